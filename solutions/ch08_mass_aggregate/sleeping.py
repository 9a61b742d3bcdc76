"""Going further: particles at rest fall asleep, and cost almost nothing until something wakes them.

The engine already skips immovable particles. So the world makes a particle immovable while it
sleeps: it stores the particle's inverse mass, and restores it when the particle wakes.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from ch02_vectors.arguments import not_negative, positive, whole
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactGenerator
from ch08_mass_aggregate.joints import Pair, joined, touching
from ch08_mass_aggregate.world import ParticleWorld, mechanical_energy

LOOK_EVERY = 10  # steps between two checks of the forces on sleeping particles
# J/kg. A body that loses contact for one step of 1/60 s by rounding falls freely and gets
# (g h)^2 / 2 = 0.0134. It must still count as slow.
SLEEP_ENERGY = 0.015
SAME = 0.01  # a change of the acceleration by this fraction or less wakes nothing


@dataclass(frozen=True)
class Sleep:
    """What the world must know about a sleeping particle to wake it."""

    inverse_mass: float  # 1/kg, which it gets back
    position: Vector3  # m, a copy of the position at which it fell asleep
    acceleration: Vector3  # m/s^2: its last_acceleration, which includes forces
    neighbors: tuple[Particle, ...]  # particles that it touched or was joined to


class SleepingWorld(ParticleWorld):
    """A ParticleWorld in which groups of touching particles fall asleep when they are at rest.

    A step is slow for a particle if its kinetic energy per kg after the step is at most
    ``sleep_energy``, in J/kg. After ``sleep_frames`` slow steps in a row the particle is tired. The
    dict ``asleep`` maps each sleeping particle, whose mass is ``math.inf``, to its ``Sleep``.

    The world cannot detect every change. Call ``wake`` yourself before you make a sleeping particle
    immovable, join something to it, or move the ground or an anchor that supports it.
    """

    def __init__(
        self,
        particles: Iterable[Particle] = (),
        contact_generators: Iterable[ContactGenerator] = (),
        *,
        iterations: int | None = None,
        integrator: Integrator = semi_implicit_euler,
        sleep_energy: float = SLEEP_ENERGY,
        sleep_frames: int = 30,
    ) -> None:
        super().__init__(
            particles, contact_generators, iterations=iterations, integrator=integrator
        )
        self.sleep_energy = not_negative("sleep_energy", sleep_energy)
        self.sleep_frames = whole("sleep_frames", sleep_frames)
        self.asleep: dict[Particle, Sleep] = {}
        self._slow: dict[Particle, int] = {}  # the number of steps for which each has been slow
        self._touched: dict[Pair, int] = {}  # the step in which two were last in contact
        self._frame = 0

    def wake(self, particle: Particle) -> None:
        """Wake ``particle``, its neighbors, their neighbors, and so on.

        Particles that fell asleep together therefore wake together. Each of them gets its mass
        back, unless you have given it another finite mass in the meantime. Its count of slow steps
        starts from 0 again. If ``particle`` was already awake, only its count restarts.
        """
        waking = [particle]
        while waking:
            one = waking.pop()
            self._slow[one] = 0
            sleep = self.asleep.pop(one, None)
            if sleep is not None:
                if not one.inverse_mass:
                    one.inverse_mass = sleep.inverse_mass
                waking += [other for other in sleep.neighbors if other in self.asleep]

    def mechanical_energy(self) -> float:
        """Add up the mechanical energy in J, with the potential energy of sleeping particles."""
        return mechanical_energy(self.particles) - sum(
            one.acceleration.dot(one.position) / sleep.inverse_mass
            for one, sleep in self.asleep.items()
            if not one.inverse_mass
        )

    def wake_moved(self) -> None:
        """Wake every sleeping particle that code outside the world has changed.

        A sleeping particle keeps its position and its infinite mass, has no velocity, and has no
        force in its accumulator. Wake the particle if any of this is no longer true.
        """
        for particle, sleep in [*self.asleep.items()]:
            if (
                particle.position != sleep.position
                or particle.velocity != Vector3()
                or particle.force_accumulator != Vector3()
                or particle.inverse_mass
            ):
                self.wake(particle)

    def wake_pushed(self, duration: float) -> None:
        """Wake every sleeping particle whose acceleration has changed since it fell asleep.

        Compute a + f / m, where f is the sum of the generators' forces, and compare it with the
        acceleration in ``Sleep``. The particle wakes if the change is more than ``SAME`` times the
        current |a| + |f / m| or the magnitude of the old acceleration, whichever is larger.

        Call only generators that are registered for sleeping particles. Give each sleeping particle
        its original mass meanwhile, because a generator may use it. The accumulators of sleeping
        particles are empty when this method starts, and must be empty again when it returns.
        """
        for particle, generator in self.registry.pairs():
            if particle in self.asleep:
                particle.inverse_mass = self.asleep[particle].inverse_mass
                generator.update_force(particle, duration)
                particle.inverse_mass = 0.0
        for particle, sleep in [*self.asleep.items()]:
            push = particle.force_accumulator * sleep.inverse_mass
            particle.clear_forces()
            change = particle.acceleration + push - sleep.acceleration
            acts = particle.acceleration.magnitude() + push.magnitude()
            if change.magnitude() > SAME * max(acts, sleep.acceleration.magnitude()):
                self.wake(particle)

    def wake_touched(self, contacts: Iterable[Contact]) -> bool:
        """Wake every sleeping particle that is in contact with a particle that can move.

        Return True if any particle woke. In that case the caller must find the contacts again.
        """
        woken = False
        for contact in contacts:
            a, b = contact.particle, contact.other
            if b is None:
                continue
            for sleeper, other in ((a, b), (b, a)):
                if sleeper in self.asleep and other.inverse_mass:
                    self.wake(sleeper)
                    woken = True
        return woken

    def fall_asleep(self, contacts: Iterable[Contact]) -> None:
        """Update the counts of slow steps, and put groups of tired particles to sleep.

        Particles that are connected, directly or through others, form a group. Two are connected if
        they were in contact in one of the last ``sleep_frames`` steps, or if a generator of the
        registry joins them. Immovable particles do not connect groups, and they never sleep.

        A particle is tired if its last ``sleep_frames`` steps were all slow. A group falls asleep
        only when all of its particles are tired. Add each of them to ``asleep``, and set its
        ``velocity`` and ``inverse_mass`` to 0.
        """
        awake = [particle for particle in self.particles if particle.inverse_mass]
        self._count_slow_steps(awake)
        self._note_contacts(contacts)
        restless = [particle for particle in awake if self._slow[particle] < self.sleep_frames]
        neighbors = _neighbors([*self._touched, *joined(self.registry)])
        kept_awake = _connected(restless, neighbors)
        for particle in awake:
            if particle not in kept_awake:
                self._put_to_sleep(particle, neighbors.get(particle, []))

    def run_physics(self, duration: float) -> None:
        """Move all particles that are awake forward by one time step of ``duration`` s.

        - Count the step in ``_frame``.
        - Wake the particles that code outside the world has changed. Every ``LOOK_EVERY`` steps,
          also wake the particles whose acceleration has changed since they fell asleep.
        - If all particles are asleep, the step is finished.
        - Otherwise, call the integrator with only the particles that are awake.
        - Find the contacts. If a contact wakes a particle, find the contacts again. Repeat this
          until no more particles wake.
        - Resolve the contacts, and then call ``fall_asleep``.
        """
        positive("duration", duration)
        self._frame += 1
        self.wake_moved()
        if self._frame % LOOK_EVERY == 0:
            self.wake_pushed(duration)
        awake = [particle for particle in self.particles if particle not in self.asleep]
        if not awake:
            return
        self.integrator(awake, self.registry.update_forces, duration)
        contacts = self.contacts()
        while self.wake_touched(contacts):
            contacts = self.contacts()
        if contacts:
            self.resolver.resolve_contacts(contacts, duration)
        self.fall_asleep(contacts)

    def _count_slow_steps(self, awake: Iterable[Particle]) -> None:
        """For each particle, count how many steps in a row it has been slow."""
        for particle in awake:
            slow = particle.kinetic_energy() <= self.sleep_energy * particle.mass
            self._slow[particle] = self._slow.get(particle, 0) + 1 if slow else 0

    def _note_contacts(self, contacts: Iterable[Contact]) -> None:
        """Record which particles touch in this step, and drop contacts that ended some steps ago.

        A body at rest on another one sometimes loses its contact for a step because of rounding.
        """
        for pair in touching(contacts):
            self._touched[pair] = self._frame
        since = self._frame - self.sleep_frames
        self._touched = {pair: last for pair, last in self._touched.items() if last > since}

    def _put_to_sleep(self, particle: Particle, neighbors: Iterable[Particle]) -> None:
        """Stop a particle, make it immovable, and store what is needed to wake it."""
        self.asleep[particle] = Sleep(
            particle.inverse_mass,
            particle.position.copy(),
            particle.last_acceleration,
            tuple(neighbors),
        )
        particle.velocity.clear()
        particle.inverse_mass = 0.0


def _neighbors(pairs: Iterable[Pair]) -> dict[Particle, list[Particle]]:
    """Build a dict that maps each particle to all particles with which it forms a pair."""
    neighbors: dict[Particle, list[Particle]] = {}
    for a, b in pairs:
        neighbors.setdefault(a, []).append(b)
        neighbors.setdefault(b, []).append(a)
    return neighbors


def _connected(
    starts: Iterable[Particle], neighbors: Mapping[Particle, Iterable[Particle]]
) -> set[Particle]:
    """Find all particles that are connected to ``starts``, directly or through other particles."""
    found = set(starts)
    waiting = [*found]
    while waiting:
        for other in neighbors.get(waiting.pop(), ()):
            if other not in found:
                found.add(other)
                waiting.append(other)
    return found
