"""A particle on which forces act: the particle of chapter 3, with a force accumulator (book 5.1).

Units are SI, so forces are in N.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import particle


class Particle(particle.Particle):
    """A particle that adds up the forces on it until the next time step uses them.

    ``_force`` is the sum of the forces since the last step, and ``_last_force`` is the sum that the
    last step used. Both are vectors, and zero at first. Replace them by new vectors, as in
    ``a = a + b``, so that a copy of the particle can share them.
    """

    __slots__ = ("_force", "_last_force")

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
        self._force = Vector3()
        self._last_force = Vector3()

    @property
    def force_accumulator(self) -> Vector3:
        """The sum of the forces added since the last time step, in N, as a new vector.

        If no force was added, the sum is the zero vector. Changing the returned vector does not
        change the sum.
        """
        raise NotImplementedError("Exercise B5.1: The force accumulator")

    def add_force(self, force: Vector3) -> None:
        """Add a force in N to the sum of the forces that act on the particle in the next time step.

        The vector ``force`` does not change, and a later change to it does not change the sum.

        Raises ValueError if a component of the force, or of the sum, is not finite, and TypeError
        if the force is not a Vector3. In both cases the sum does not change. Book 5.1.
        """
        raise NotImplementedError("Exercise B5.1: The force accumulator")

    def clear_forces(self) -> None:
        """Discard the forces that were added to the particle since the last time step (book 5.1).

        ``last_acceleration`` does not change.
        """
        raise NotImplementedError("Exercise B5.1: The force accumulator")

    @property
    def last_acceleration(self) -> Vector3:
        """The total acceleration of the particle in its last time step, in m/s^2 as a new vector.

        This is the constant acceleration plus f / m, where f is the sum of the forces that the last
        step used (book Eq. 3.2). Before the first step f is zero. The mass and the constant
        acceleration are the current ones. An immovable particle does not react to forces.
        """
        raise NotImplementedError("Exercise B5.2: The step with forces")

    def kick(self, duration: float) -> None:
        """Apply the acceleration, forces and damping to the velocity over ``duration`` s.

        The new velocity is v' = (v + a h) d^h, where a is the constant acceleration plus f / m, and
        f is the sum of the forces that were added since the last kick. After the update, clear this
        sum, even for an immovable particle, so that each force acts only once. Keep a copy of it
        for ``last_acceleration``. The mass and the damping may change between two steps, so use
        their current values in each step. ``integrate`` of chapter 3 calls this method after it has
        moved the particle.
        """
        raise NotImplementedError("Exercise B5.2: The step with forces")
