"""Going further: what lies still falls asleep, and costs next to nothing until something wakes it.

A particle that sleeps is immovable: that is what the whole engine leaves alone already. The world
keeps its inverse mass, and gives it back.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.arguments import not_negative, positive
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactGenerator
from ch08_mass_aggregate.world import ParticleWorld

LOOK_EVERY = 10  # frames: how often the generators of what sleeps are asked
SAME = 0.01  # of what accelerates it: a change by less wakes nothing


@dataclass(frozen=True)
class Sleep:
    """What a particle is given back when it wakes, and what must stay the same until then."""

    inverse_mass: float  # 1/kg
    place: tuple[float, float, float]  # m
    acceleration: Vector3  # m/s^2, with that of its forces


class SleepingWorld(ParticleWorld):
    """A ParticleWorld whose particles fall asleep when they, and all that they touch, are slow.

    Slow is what had a kinetic energy of ``sleep_energy`` in J or less at the end of each of
    ``sleep_frames`` frames in a row. What sleeps has no velocity, and a mass of math.inf;
    ``asleep`` is a dict from it to its Sleep.

    Raises ValueError where sleep_energy is negative or not finite, or sleep_frames is below 1, and
    what ParticleWorld raises.
    """

    def __init__(
        self,
        particles: Iterable[Particle] = (),
        contact_generators: Iterable[ContactGenerator] = (),
        *,
        iterations: int | None = None,
        integrator: Integrator = semi_implicit_euler,
        sleep_energy: float = 1e-3,
        sleep_frames: int = 30,
    ) -> None:
        super().__init__(
            particles, contact_generators, iterations=iterations, integrator=integrator
        )
        self.sleep_energy = not_negative("sleep_energy", sleep_energy)
        if not isinstance(sleep_frames, int) or isinstance(sleep_frames, bool):
            raise TypeError(f"sleep_frames must be a whole number, got {sleep_frames!r}")
        if sleep_frames < 1:
            raise ValueError(f"sleep_frames must be 1 or more, got {sleep_frames!r}")
        self.sleep_frames = sleep_frames
        self.asleep: dict[Particle, Sleep] = {}
        self._slow: dict[Particle, int] = {}  # for how many frames each has been slow
        self._frame = 0

    def wake(self, particle: Particle) -> None:
        """Wake a particle: its mass is what it was, unless it has been given another by hand.

        It has to be slow again for all of sleep_frames. One that is awake stays awake, and begins
        to count anew.
        """
        self._slow.pop(particle, None)
        sleep = self.asleep.pop(particle, None)
        if sleep is not None and not particle.inverse_mass:
            particle.inverse_mass = sleep.inverse_mass

    def wake_moved(self) -> None:
        """Wake what was moved by hand since it fell asleep.

        That is what has a velocity, another place, a mass, or a force in its accumulator.
        """
        for particle in [one for one, sleep in self.asleep.items() if _moved(one, sleep)]:
            self.wake(particle)

    def wake_pushed(self, duration: float) -> None:
        """Wake what the generators of the registry push otherwise than when it fell asleep.

        It is the force of now, and with it the acceleration a + f / m, that is compared with the
        one of then: a change of more than SAME of the larger of the two wakes. The accumulators of
        what sleeps are empty before and afterwards.
        """
        if not self.asleep:
            return
        # What is awake keeps its forces by hand: a spring may pull at both of its ends.
        by_hand = [(one, one.force_accumulator) for one in self.particles if one not in self.asleep]
        masses = [(one, one.inverse_mass) for one in self.asleep]
        accelerations: dict[Particle, Vector3] = {}
        try:
            for one, sleep in self.asleep.items():
                one.inverse_mass = sleep.inverse_mass
                one.clear_forces()
            self.registry.update_forces(duration)
            for one in self.asleep:
                accelerations[one] = one.acceleration + one.force_accumulator * one.inverse_mass
        finally:
            for one, inverse_mass in masses:
                one.inverse_mass = inverse_mass
                one.clear_forces()
            for one, force in by_hand:
                one.clear_forces()
                one.add_force(force)
        for one, now in accelerations.items():
            then = self.asleep[one].acceleration
            if (now - then).magnitude() > SAME * max(now.magnitude(), then.magnitude()):
                self.wake(one)

    def wake_touched(self, contacts: Iterable[Contact]) -> bool:
        """Wake what sleeps and is in contact with a particle that can move.

        Return whether there was any.
        """
        pairs = _pairs(contacts)
        woken = False
        again = True
        while again:
            again = False
            for a, b in pairs:
                for sleeper, other in ((a, b), (b, a)):
                    if sleeper in self.asleep and other.inverse_mass:
                        self.wake(sleeper)
                        woken = again = True
        return woken

    def fall_asleep(self, contacts: Iterable[Contact]) -> None:
        """Put to sleep what has been slow for long enough, with all that it touches.

        Of particles that are in contact with each other, directly or through others, all sleep or
        none. What is immovable joins nothing, and neither slows down nor sleeps.
        """
        neighbours: dict[Particle, list[Particle]] = {}
        for a, b in _pairs(contacts):
            if a.inverse_mass and b.inverse_mass:
                neighbours.setdefault(a, []).append(b)
                neighbours.setdefault(b, []).append(a)
        for one in self.particles:
            if one.inverse_mass and one.kinetic_energy() <= self.sleep_energy:
                self._slow[one] = self._slow.get(one, 0) + 1
            else:
                self._slow.pop(one, None)
        seen: set[Particle] = set()
        for one in self.particles:
            if one in seen or one not in self._slow:
                continue
            group = _reach(one, neighbours)
            seen |= group
            if all(self._slow.get(member, 0) >= self.sleep_frames for member in group):
                for member in group:
                    self._put_to_sleep(member)

    def run_physics(self, duration: float) -> None:
        """Move all on that is awake by a frame of a duration in s.

        First what was moved by hand wakes, and in every LOOK_EVERY-th frame what its generators
        push otherwise. After the integrator has moved what is awake, contacts wake what sleeps:
        then they are looked for again, until they wake nothing more. When they are resolved, what
        has been slow for long enough falls asleep.

        Raises ValueError where the duration is not positive and finite; all is then as it was.
        """
        positive("duration", duration)
        self._frame += 1
        self.wake_moved()
        if self._frame % LOOK_EVERY == 0:
            self.wake_pushed(duration)
        self.integrator(self.particles, self.registry.update_forces, duration)
        touching = self.contacts()
        while self.wake_touched(touching):
            touching = self.contacts()
        if touching:
            self.resolver.resolve_contacts(touching, duration)
        self.fall_asleep(touching)

    def _put_to_sleep(self, particle: Particle) -> None:
        """Stop a particle, and keep what it is given back."""
        del self._slow[particle]
        self.asleep[particle] = Sleep(
            particle.inverse_mass, _place(particle), particle.last_acceleration
        )
        particle.velocity.clear()
        particle.inverse_mass = 0.0


def _place(particle: Particle) -> tuple[float, float, float]:
    """Return where a particle is."""
    place = particle.position
    return place.x, place.y, place.z


def _moved(particle: Particle, sleep: Sleep) -> bool:
    """Say whether something has been done to a sleeping particle by hand."""
    still = Vector3()
    return (
        particle.inverse_mass != 0.0
        or particle.velocity != still
        or particle.force_accumulator != still
        or _place(particle) != sleep.place
    )


def _pairs(contacts: Iterable[Contact]) -> list[tuple[Particle, Particle]]:
    """Return the particles of those contacts that have two."""
    return [(one.particle, one.other) for one in contacts if one.other is not None]


def _reach(start: Particle, neighbours: dict[Particle, list[Particle]]) -> set[Particle]:
    """Return a particle with all that it touches, directly or through others."""
    group, waiting = {start}, [start]
    while waiting:
        for other in neighbours.get(waiting.pop(), ()):
            if other not in group:
                group.add(other)
                waiting.append(other)
    return group
