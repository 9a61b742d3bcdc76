"""Going further: what lies still falls asleep, and costs next to nothing until something wakes it.

A particle that sleeps is immovable: that is what the whole engine leaves alone already. The world
keeps its inverse mass, and gives it back.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.arguments import not_negative
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
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def wake_moved(self) -> None:
        """Wake what was moved by hand since it fell asleep.

        That is what has a velocity, another place, a mass, or a force in its accumulator.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def wake_pushed(self, duration: float) -> None:
        """Wake what the generators of the registry push otherwise than when it fell asleep.

        It is the force of now, and with it the acceleration a + f / m, that is compared with the
        one of then: a change of more than SAME of the larger of the two wakes. The accumulators of
        what sleeps are empty before and afterwards.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def wake_touched(self, contacts: Iterable[Contact]) -> bool:
        """Wake what sleeps and is in contact with a particle that can move.

        Return whether there was any.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def fall_asleep(self, contacts: Iterable[Contact]) -> None:
        """Put to sleep what has been slow for long enough, with all that it touches.

        Of particles that are in contact with each other, directly or through others, all sleep or
        none. What is immovable joins nothing, and neither slows down nor sleeps.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def run_physics(self, duration: float) -> None:
        """Move all on that is awake by a frame of a duration in s.

        First what was moved by hand wakes, and in every LOOK_EVERY-th frame what its generators
        push otherwise. After the integrator has moved what is awake, contacts wake what sleeps:
        then they are looked for again, until they wake nothing more. When they are resolved, what
        has been slow for long enough falls asleep.

        Raises ValueError where the duration is not positive and finite; all is then as it was.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")
