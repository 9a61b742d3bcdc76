"""A particle on which forces act: chapter 3's, with a force accumulator (book 5.1).

Units are SI: forces are in N.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import particle

Numbers = tuple[float, float, float]


class Particle(particle.Particle):
    """A particle of chapter 3 that adds up the forces of a frame until its next step uses them.

    What is kept is ``_forces``, a list of two: the sum since the last step, and the sum that the
    last step used. Each is three numbers, or None where no force was added.
    """

    __slots__ = ("_forces",)

    _forces: list[Numbers | None]

    def __init__(
        self,
        position: Vector3 | None = None,
        velocity: Vector3 | None = None,
        acceleration: Vector3 | None = None,
        *,
        mass: float = 1.0,
        damping: float = 1.0,
    ) -> None:
        super().__init__(position, velocity, acceleration, mass=mass, damping=damping)
        self._forces = [None, None]

    @property
    def force_accumulator(self) -> Vector3:
        """The sum in N of the forces since the last step, as new; add_force is what changes it."""
        return _total(self._forces[0])

    def add_force(self, force: Vector3) -> None:
        """Add a force in N to the sum, for the next step alone (5.1). The force is only read.

        Raises ValueError where a component of it, or of the sum, is not finite, and TypeError for
        what is no Vector3; the sum is then as it was.
        """
        total = self.force_accumulator + finite_vector("force", force)
        self._forces[0] = _numbers(finite_vector("sum of the forces", total))

    def clear_forces(self) -> None:
        """Drop the forces that were added since the last step (5.1)."""
        self._forces[0] = None

    @property
    def last_acceleration(self) -> Vector3:
        """All of the acceleration of the last step, as new: the constant one, and f / m (Eq. 3.2).

        It is worked out when it is asked for, from the mass and the constant acceleration of now.
        """
        return self._acceleration_under(self._forces[1])

    def kick(self, duration: float) -> None:
        """Change the velocity for a duration in s, by the acceleration and the forces.

        v' = (v + (a + f / m) h) d^h, where a is the constant acceleration and f the sum of the
        forces since the last kick. That sum is cleared, for an immovable particle too, and kept as
        what the last step used.

        Raises ValueError where the duration is not finite; the particle, and the sum of its forces,
        are then as they were.
        """
        gathered = self._forces[0]
        constant = self.acceleration
        # Chapter 3's kick knows one acceleration only, so it is lent the whole of it.
        object.__setattr__(self, "acceleration", self._acceleration_under(gathered))
        try:
            super().kick(duration)
        finally:
            object.__setattr__(self, "acceleration", constant)
        self._forces = [None, gathered]

    def _acceleration_under(self, forces: Numbers | None) -> Vector3:
        return self.acceleration + _total(forces) / self.mass


def _total(forces: Numbers | None) -> Vector3:
    return Vector3() if forces is None else Vector3(*forces)


def _numbers(v: Vector3) -> Numbers:
    return v.x, v.y, v.z
