"""A particle on which forces act: chapter 3's, with a force accumulator (book 5.1).

Units are SI: forces are in N.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import particle

Numbers = tuple[float, float, float]


class Particle(particle.Particle):
    """A particle of chapter 3 that adds up the forces of a frame until its next step uses them."""

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
        return _total(self._forces[0])

    def add_force(self, force: Vector3) -> None:
        total = self.force_accumulator + finite_vector("force", force)
        self._forces[0] = _numbers(finite_vector("sum of the forces", total))

    def clear_forces(self) -> None:
        self._forces[0] = None

    @property
    def last_acceleration(self) -> Vector3:
        return self._acceleration_under(self._forces[1])

    def kick(self, duration: float) -> None:
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
