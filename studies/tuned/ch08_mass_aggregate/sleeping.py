"""Going further: particles at rest fall asleep, and cost almost nothing until something wakes them.

Most bodies in a game lie still most of the time, but the engine spends as much time on them as on
moving bodies. It can save this time, because the rest of the engine already skips immovable
particles. So the world makes a particle immovable while it sleeps: it stores the particle's inverse
mass, and restores it when the particle wakes.

A world whose particles are asleep spends most of its time on looking whether something has changed.
This version first compares a sleeping particle with what it last saw of it, in plain numbers. It
asks the slow question, whether a change wakes the particle, only if something is not the same.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from ch02_vectors.arguments import not_negative, positive, whole
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import set_inverse_mass
from ch05_forces.particle import NO_FORCE, Numbers, Particle
from ch06_springs.integrators import Integrator, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactGenerator
from ch08_mass_aggregate.joints import Pair, joined, touching
from ch08_mass_aggregate.world import ParticleWorld, mechanical_energy

LOOK_EVERY = 10  # steps between two checks of the forces on sleeping particles
# J/kg. A body that loses contact for one step of 1/60 s by rounding falls freely and gets
# (g h)^2 / 2 = 0.0134. It must still count as slow.
SLEEP_ENERGY = 0.015
SAME = 0.01  # a change of the acceleration by this fraction or less wakes nothing


@dataclass
class Sleep:
    inverse_mass: float  # 1/kg
    place: tuple[float, float, float]  # m
    acceleration: Vector3  # m/s^2: its last_acceleration, which includes forces
    neighbors: tuple[Particle, ...]  # particles that it touched or was joined to
    # The objects that belong to the particle while it sleeps: position, velocity, sums of forces.
    own: tuple[Vector3, Vector3, list[Numbers | None]]
    # The last force and acceleration that did not wake it.
    calm: tuple[Numbers | None, float, float, float] | None = None


class SleepingWorld(ParticleWorld):
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
        asleep = [(one, sleep) for one, sleep in self.asleep.items() if not one.inverse_mass]
        return mechanical_energy(self.particles) - sum(
            one.acceleration.dot(one.position) / sleep.inverse_mass for one, sleep in asleep
        )

    def wake_moved(self) -> None:
        moved = []
        for particle, sleep in self.asleep.items():
            p, v, sums = sleep.own
            x, y, z = sleep.place
            if (
                p.x != x
                or p.y != y
                or p.z != z
                or v.x
                or v.y
                or v.z
                or sums[0]
                or particle._inverse_mass
                or particle.position is not p
                or particle.velocity is not v
            ):
                moved.append((particle, sleep))
        for particle, sleep in moved:
            if _was_moved(particle, sleep):
                self.wake(particle)

    def wake_pushed(self, duration: float) -> None:
        self._ask_for_sleepers(duration)
        for particle, sleep in [*self.asleep.items()]:
            sums = particle._forces
            push, own = sums[0], particle.acceleration
            sums[0] = None
            now = (push, own.x, own.y, own.z)
            if now == sleep.calm:
                continue
            if _is_pushed_otherwise(particle, push or NO_FORCE, sleep):
                self.wake(particle)
            else:
                sleep.calm = now

    def wake_touched(self, contacts: Iterable[Contact]) -> bool:
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
        awake = [particle for particle in self.particles if particle._inverse_mass]
        self._count_slow_frames(awake)
        self._note_contacts(contacts)
        restless = [particle for particle in awake if self._slow[particle] < self.sleep_frames]
        if len(restless) == len(awake):
            return
        neighbors = _neighbors([*self._touched, *joined(self.registry)])
        kept_awake = _connected(restless, neighbors)
        for particle in awake:
            if particle not in kept_awake:
                self._put_to_sleep(particle, neighbors.get(particle, []))

    def run_physics(self, duration: float) -> None:
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

    def _count_slow_frames(self, awake: Iterable[Particle]) -> None:
        """For each particle, count how many steps in a row it has been slow."""
        for particle in awake:
            v, mass = particle.velocity, 1.0 / particle._inverse_mass
            energy = 0.5 * mass * (v.x * v.x + v.y * v.y + v.z * v.z)
            slow = energy <= self.sleep_energy * mass
            self._slow[particle] = self._slow.get(particle, 0) + 1 if slow else 0

    def _note_contacts(self, contacts: Iterable[Contact]) -> None:
        """Record which particles touch in this step, and drop contacts that ended some steps ago.

        A body that rests on another body sometimes loses its contact for one step because of
        rounding errors. That is why each contact is remembered for several steps.
        """
        for pair in touching(contacts):
            self._touched[pair] = self._frame
        since = self._frame - self.sleep_frames
        self._touched = {pair: last for pair, last in self._touched.items() if last > since}

    def _put_to_sleep(self, particle: Particle, neighbors: Iterable[Particle]) -> None:
        """Stop a particle, make it immovable, and store what is needed to wake it."""
        x, y, z = particle.position
        self.asleep[particle] = Sleep(
            particle.inverse_mass,
            (x, y, z),
            particle.last_acceleration,
            tuple(neighbors),
            (particle.position, particle.velocity, particle._forces),
        )
        particle.velocity.clear()
        particle.inverse_mass = 0.0

    def _ask_for_sleepers(self, duration: float) -> None:
        """Call the generators of each sleeping particle, and restore its mass during each call."""
        for particle, generator in self.registry.pairs():
            sleep = self.asleep.get(particle)
            if sleep is not None:
                set_inverse_mass(particle, sleep.inverse_mass)
                generator.update_force(particle, duration)
                set_inverse_mass(particle, 0.0)


def _was_moved(particle: Particle, sleep: Sleep) -> bool:
    """Return True if code outside the world has changed a sleeping particle."""
    v, p = particle.velocity, particle.position
    if v.x or v.y or v.z or (p.x, p.y, p.z) != sleep.place or particle.inverse_mass:
        return True
    sums = particle._forces
    return sums[0] is not None and sums[0] != NO_FORCE


def _is_pushed_otherwise(
    particle: Particle, force: tuple[float, float, float], sleep: Sleep
) -> bool:
    """Return True if a particle's acceleration a + f / m has changed since it fell asleep.

    Relative changes of up to SAME are ignored.
    """
    mass, own, old = sleep.inverse_mass, particle.acceleration, sleep.acceleration
    x, y, z = force[0] * mass, force[1] * mass, force[2] * mass
    change = math.hypot(own.x + x - old.x, own.y + y - old.y, own.z + z - old.z)
    if not change:
        return False
    acts = math.hypot(own.x, own.y, own.z) + math.hypot(x, y, z)
    return change > SAME * max(acts, old.magnitude())


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
