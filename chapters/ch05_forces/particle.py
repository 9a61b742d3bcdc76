"""A particle on which forces act: the one of chapter 3, with a force accumulator (book 5.1)."""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import particle


class Particle(particle.Particle):
    """A particle that adds up the forces on it until the next time step uses them.

    ``_force`` is the sum since the last step, and ``_last_force`` the sum that the last step used.
    Replace them by new vectors, as in ``a = a + b``, because a copy of the particle shares them.
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
        self._force, self._last_force = Vector3(), Vector3()

    @property
    def force_accumulator(self) -> Vector3:
        """The forces since the last time step in N, as a new vector: zero if no force was added."""
        raise NotImplementedError("Exercise B5.1: The force accumulator")

    def add_force(self, force: Vector3) -> None:
        """Add a force in N to the sum of the forces. A later change to it does not change the sum.

        Raises ValueError if a component of the force, or of the sum, is not finite, and TypeError
        if it is not a Vector3. In both cases the sum does not change.
        """
        raise NotImplementedError("Exercise B5.1: The force accumulator")

    def clear_forces(self) -> None:
        """Discard the forces that were added since the last time step."""
        raise NotImplementedError("Exercise B5.1: The force accumulator")

    @property
    def last_acceleration(self) -> Vector3:
        """The total acceleration of the particle in its last time step, in m/s^2 as a new vector.

        It is the constant acceleration plus f / m, where f is the sum that the last step used, with
        the acceleration and the mass of now. Before the first step f is zero.
        """
        raise NotImplementedError("Exercise B5.2: The step with forces")

    def kick(self, duration: float) -> None:
        """Apply the acceleration, forces and damping to the velocity over ``duration`` s.

        The new velocity is v' = (v + a h) d^h, where a is the constant acceleration plus f / m,
        with the mass and the damping of now, and f is the sum of the forces that were added since
        the last kick. Then clear this sum, so that each force acts only once, and keep it for
        ``last_acceleration``. No force changes the velocity of an immovable particle.
        """
        raise NotImplementedError("Exercise B5.2: The step with forces")
