"""Going further: particles at rest fall asleep and cost almost nothing until something wakes them.

A sleeping particle is immovable, and the whole engine leaves immovable particles alone already. The
world keeps the inverse mass of each, and gives it back when the particle wakes.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ch02_vectors.arguments import not_negative, whole
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactGenerator
from ch08_mass_aggregate.joints import Pair
from ch08_mass_aggregate.world import ParticleWorld

LOOK_EVERY = 10  # frames: how often the generators of sleeping particles are asked
# J/kg: a little more than a free fall through one frame of 1/60 s, (g h)^2 / 2 = 0.0134, since a
# contact may be lost for a frame by rounding.
SLEEP_ENERGY = 0.015
SAME = 0.01  # a change by this fraction of the acceleration, or by less, wakes nothing


@dataclass(frozen=True)
class Sleep:
    """What a particle is given back when it wakes, and what must stay the same until then."""

    inverse_mass: float  # 1/kg
    place: tuple[float, float, float]  # m
    acceleration: Vector3  # m/s^2: its last_acceleration, so with its forces
    neighbours: tuple[Particle, ...]  # those that it touched or was joined to


class SleepingWorld(ParticleWorld):
    """A ParticleWorld in which particles at rest fall asleep, together with all that they touch.

    A particle is slow if its kinetic energy per kg of its mass is ``sleep_energy`` in J/kg or less
    at the end of a frame. It is tired after ``sleep_frames`` slow frames in a row. A sleeping
    particle has no velocity and a mass of math.inf. ``asleep`` is a dict from each sleeping
    particle to its Sleep.

    Wake a sleeping particle first if you move the ground or an anchor under it, join something new
    to it, or make it immovable.

    Raises ValueError if sleep_energy is negative or not finite, or sleep_frames is below 1. Raises
    TypeError if sleep_frames is not a whole number, and whatever ParticleWorld raises.
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
        self._slow: dict[Particle, int] = {}  # for how many frames each has been slow
        self._touched: dict[Pair, int] = {}  # in which frame two were last in contact
        self._frame = 0

    def wake(self, particle: Particle) -> None:
        """Wake a particle, its neighbours, their neighbours, and so on.

        So particles that fell asleep together wake together. Each gets its mass back, unless it has
        been given another finite mass by hand. It has to be slow again for all of sleep_frames. A
        particle that is awake stays awake, and its slow frames are counted anew.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def wake_moved(self) -> None:
        """Wake the particles that were moved by hand since they fell asleep.

        Such a particle has a velocity, another position, a mass, or a force in its accumulator.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def wake_pushed(self, duration: float) -> None:
        """Wake the particles that the generators push otherwise than when they fell asleep.

        The acceleration of now, a + f / m with the forces of the generators, is compared with the
        one of then. A change of more than SAME of what acts wakes the particle. What acts is
        |a| + |f / m| now, or the size of the acceleration of then, whichever is larger.

        Only generators that are registered for sleeping particles are asked, and each particle has
        its own mass for that time. The accumulators of sleeping particles are empty before and
        afterwards.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def wake_touched(self, contacts: Iterable[Contact]) -> bool:
        """Wake the sleeping particles that are in contact with a particle that can move.

        Return whether there were any.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def fall_asleep(self, contacts: Iterable[Contact]) -> None:
        """Count a frame, and put every group to sleep in which all particles are tired.

        Particles belong to one group if they were in contact in one of the last sleep_frames
        frames, or if a generator of the registry joins them, directly or through others. All of a
        group falls asleep, or none of it. Immovable particles join nothing, and neither slow down
        nor sleep. A particle that falls asleep has no velocity and an inverse_mass of 0, and is in
        asleep.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def run_physics(self, duration: float) -> None:
        """Move all particles that are awake on by a frame of a duration in s.

        Particles that were moved by hand wake first, and in every LOOK_EVERY-th frame those that
        their generators push otherwise. The integrator gets the particles that are awake, and no
        others. Then contacts wake sleeping particles, and are found again, until they wake no more.
        Once they are resolved, groups that are tired fall asleep.

        Raises ValueError if the duration is not positive and finite; all is then as it was.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")
