"""A particle on which forces act: the particle of chapter 3, with a force accumulator (book 5.1).

Units are SI, so forces are in N.
"""

from __future__ import annotations

from typing import Any, Self

from ch02_vectors.arguments import finite_vector
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import particle

Numbers = tuple[float, float, float]
NO_FORCE: Numbers = (0.0, 0.0, 0.0)


class Particle(particle.Particle):
    """A particle that adds up the forces on it until the next time step uses them.

    It inherits position, velocity, mass and damping from chapter 3. ``_forces`` is a list with two
    entries: the sum of the forces since the last step, and the sum that the last step used. Each
    entry is a tuple of three numbers, or None if no force was added. You may store the forces in
    another way, but then change ``__slots__``, the constructor, ``__copy__``, ``take_forces`` and
    ``add_force_pair`` to match.
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

    def __copy__(self) -> Self:
        """Return a copy of the particle that has a separate force accumulator.

        The copy has the same class and the same attributes, and starts with the same sum of forces.
        A force that you later add to one of the two particles does not affect the other.
        """
        other = self.__new__(type(self))
        state: Any = object.__getstate__(self)  # the attributes of a subclass, and of __slots__
        own, slots = state
        for name, value in {**(own or {}), **slots}.items():
            setattr(other, name, value)
        other._forces = [*self._forces]
        return other

    def take_forces(self) -> Numbers:
        """Return the sum of the forces in N as three numbers, and clear the sum.

        You get the same result from ``force_accumulator`` followed by ``clear_forces``, but this
        method takes only a third of the time. The difference matters for an integrator that
        evaluates the forces several times per step.
        """
        forces = self._forces
        force = forces[0]
        forces[0] = None
        return force or NO_FORCE

    def add_force_pair(self, other: Particle, x: float, y: float, z: float) -> None:
        """Add a force in N to this particle, and the opposite force to the particle ``other``.

        ``x``, ``y`` and ``z`` are the components of the force on this particle. Newton's third law
        gives the force on ``other``. You could also call ``add_force`` twice, but this method takes
        half the time, which matters for a cloth with hundreds of springs.

        Raises:
            ValueError: if a component, or one of the two sums, is not finite. In that case neither
                sum changes.
        """
        mine, others = self._forces, other._forces
        ax, ay, az = mine[0] or NO_FORCE
        bx, by, bz = others[0] or NO_FORCE
        ax += x
        ay += y
        az += z
        bx -= x
        by -= y
        bz -= z
        if 0.0 * (ax + ay + az + bx + by + bz) != 0.0:  # one question for six numbers
            finite_vector("the force", Vector3(x, y, z))
            finite_vector("the sum of the forces", Vector3(ax, ay, az))
            finite_vector("the sum of the forces", Vector3(bx, by, bz))
        mine[0] = (ax, ay, az)
        others[0] = (bx, by, bz)

    @property
    def force_accumulator(self) -> Vector3:
        """The sum of the forces added since the last time step, in N, as a new vector.

        If no force was added, the sum is the zero vector. Changing the returned vector does not
        change the sum.
        """
        raise NotImplementedError("Exercise B5.1: The force accumulator")

    def add_force(self, force: Vector3) -> None:
        """Add a force in N to the sum of the forces that act on the particle in the next time step.

        The vector ``force`` itself does not change, and a later change to it does not change the
        sum. The position, the velocity and the acceleration stay the same until the step.

        Raises:
            ValueError: if a component of the force, or of the sum, is not finite. In that case the
                sum does not change.
            TypeError: if the force is not a Vector3. The sum does not change then either.

        Book 5.1.
        """
        raise NotImplementedError("Exercise B5.1: The force accumulator")

    def clear_forces(self) -> None:
        """Discard the forces that were added to the particle since the last time step.

        ``last_acceleration`` does not change. Book 5.1.
        """
        raise NotImplementedError("Exercise B5.1: The force accumulator")

    @property
    def last_acceleration(self) -> Vector3:
        """The total acceleration of the particle in its last time step, in m/s^2 as a new vector.

        This is the constant acceleration plus f / m, where f is the sum of the forces that the last
        step used. The mass and the constant acceleration are the current ones, even if they have
        changed since that step. Before the first step f is zero, so the result is only the constant
        acceleration. The same is true for an immovable particle, which does not react to forces.
        Book Eq. 3.2.
        """
        raise NotImplementedError("Exercise B5.2: The step with forces")

    def kick(self, duration: float) -> None:
        """Apply the acceleration, forces and damping to the velocity over ``duration`` s.

        The new velocity is v' = (v + a h) d^h. Here h is ``duration``, d is the damping, and a is
        the constant acceleration plus f / m. The force f is the sum of the forces that were added
        since the last kick. After the update, clear this sum, even for an immovable particle, so
        that each force acts only once. Keep a copy of it for ``last_acceleration``. The mass and
        the damping may change between two steps, so use their current values in each step.

        You do not have to write ``integrate`` again. The version from chapter 3 already calls this
        method after it has moved the particle. As in chapter 3, the duration is not checked.
        """
        raise NotImplementedError("Exercise B5.2: The step with forces")
