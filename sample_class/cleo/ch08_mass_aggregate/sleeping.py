"""Going further: what lies still falls asleep, and costs next to nothing until something wakes it.

A particle that sleeps is immovable: that is what the whole engine leaves alone already. The world
keeps its inverse mass, and gives it back.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ch02_vectors.arguments import not_negative
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactGenerator
from ch08_mass_aggregate.joints import Pair
from ch08_mass_aggregate.world import ParticleWorld

LOOK_EVERY = 10  # frames: how often the generators of what sleeps are asked
# J/kg: a little more than a frame of 1/60 s gives to what has lost its contact to rounding, and
# falls freely: (g h)^2 / 2 = 0.0134.
SLEEP_ENERGY = 0.015
SAME = 0.01  # of what accelerates it: a change by less wakes nothing


@dataclass(frozen=True)
class Sleep:
    """What a particle is given back when it wakes, and what must stay the same until then."""

    inverse_mass: float  # 1/kg
    place: tuple[float, float, float]  # m
    acceleration: Vector3  # m/s^2, with that of its forces
    neighbors: tuple[Particle, ...]  # what it touched, or was joined to


class SleepingWorld(ParticleWorld):
    """A ParticleWorld whose particles fall asleep when they, and all that they touch, are slow.

    Slow is what had a kinetic energy of ``sleep_energy`` or less, in J for each kg of it, at the
    end of each of ``sleep_frames`` frames in a row. What sleeps has no velocity, and a mass of
    math.inf; ``asleep`` is a dict from it to its Sleep. Who moves the ground or an anchor, or joins
    something new to what sleeps, has to wake it.

    Raises ValueError where sleep_energy is negative or not finite, or sleep_frames is below 1,
    TypeError where it is no whole number, and what ParticleWorld raises.
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
        if not isinstance(sleep_frames, int) or isinstance(sleep_frames, bool):
            raise TypeError(f"sleep_frames must be a whole number, got {sleep_frames!r}")
        if sleep_frames < 1:
            raise ValueError(f"sleep_frames must be 1 or more, got {sleep_frames!r}")
        self.sleep_frames = sleep_frames
        self.asleep: dict[Particle, Sleep] = {}
        self._slow: dict[Particle, int] = {}  # for how many frames each has been slow
        self._touched: dict[Pair, int] = {}  # in which frame two were last in contact
        self._frame = 0

    def wake(self, particle: Particle) -> None:
        """Wake a particle, its neighbors, theirs, and so on: what fell asleep as one wakes as one.

        The mass of each is what it was, unless it has been given another by hand. It has to be slow
        again for all of sleep_frames. A particle that is awake stays awake, and begins to count
        anew.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def wake_moved(self) -> None:
        """Wake what was moved by hand since it fell asleep.

        That is what has a velocity, another place, a mass, or a force in its accumulator.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def wake_pushed(self, duration: float) -> None:
        """Wake what the generators of the registry push otherwise than when it fell asleep.

        The acceleration of now, a + f / m with their forces, is compared with the one of then. A
        change of more than SAME of what acts wakes: of |a| + |f / m|, or of what it was then. Only
        generators that are registered for what sleeps are asked, and each has its own mass for that
        time. The accumulators of what sleeps are empty before and afterwards.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def wake_touched(self, contacts: Iterable[Contact]) -> bool:
        """Wake what sleeps and is in contact with a particle that can move.

        Return whether there was any.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def fall_asleep(self, contacts: Iterable[Contact]) -> None:
        """Count a frame, and put to sleep what has been slow for long enough, if its group has.

        A group is what was in contact in one of the last sleep_frames frames, or is joined by a
        generator of the registry, directly or through others: all of it sleeps, or none. What is
        immovable joins nothing, and neither slows down nor sleeps. What falls asleep has no
        velocity and an inverse_mass of 0, and is in asleep.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def run_physics(self, duration: float) -> None:
        """Move all on that is awake by a frame of a duration in s.

        First what was moved by hand wakes, and in every LOOK_EVERY-th frame what its generators
        push otherwise. The integrator gets the particles that are awake, and no others. Then
        contacts wake what sleeps, and are looked for again, until they wake nothing more. When they
        are resolved, what has been slow for long enough falls asleep.

        Raises ValueError where the duration is not positive and finite; all is then as it was.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")
