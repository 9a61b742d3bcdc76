"""The particle of chapter 5 in plain numbers.

A sum of forces is a tuple of three numbers, or None if no force was added, so a step without forces
costs as much as in chapter 3. Springs and integrators of this folder use ``add_force_pair`` and
``take_forces``, which create no vectors.
"""

from __future__ import annotations

from typing import Any, Self

from ch02_vectors.arguments import finite_vector
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import particle

Numbers = tuple[float, float, float]
NO_FORCE: Numbers = (0.0, 0.0, 0.0)


class Particle(particle.Particle):
    """A particle with a force accumulator.

    ``_forces`` is a list of two sums: of the forces since the last step, and of those that the last
    step used. A list can be changed without the checks of ``__setattr__``.
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
        """Return a copy with a list of forces of its own."""
        other = self.__new__(type(self))
        state: Any = object.__getstate__(self)  # the attributes of a subclass, and of __slots__
        own, slots = state
        for name, value in {**(own or {}), **slots}.items():
            setattr(other, name, value)
        other._forces = [*self._forces]
        return other

    def take_forces(self) -> Numbers:
        """Return the sum of the forces in N, and clear it."""
        forces = self._forces
        force = forces[0]
        forces[0] = None
        return force or NO_FORCE

    def add_numbers(self, x: float, y: float, z: float) -> None:
        """Add the force with these components in N, as ``add_force`` does."""
        forces = self._forces
        if forces[0] is not None:
            sum_x, sum_y, sum_z = forces[0]
            x, y, z = sum_x + x, sum_y + y, sum_z + z
        if 0.0 * (x + y + z) != 0.0:  # one question for three numbers: infinity * 0 is NaN
            finite_vector("the sum of the forces", Vector3(x, y, z))
        forces[0] = (x, y, z)

    def add_force_pair(self, other: Particle, x: float, y: float, z: float) -> None:
        """Add a force in N to this particle, and the opposite force to the other one.

        Raises ValueError if a component, or one of the two sums, is not finite. Neither sum then
        changes.
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
        return Vector3(*(self._forces[0] or ()))

    def add_force(self, force: Vector3) -> None:
        try:
            x, y, z = force.x, force.y, force.z
        except AttributeError:
            raise TypeError(f"force must be a Vector3, got {force!r}") from None
        forces = self._forces
        if forces[0] is not None:
            sum_x, sum_y, sum_z = forces[0]
            x, y, z = sum_x + x, sum_y + y, sum_z + z
        if 0.0 * (x + y + z) != 0.0:  # one question for three numbers: infinity * 0 is NaN
            finite_vector("force", force)
            finite_vector("the sum of the forces", Vector3(x, y, z))
        forces[0] = (x, y, z)

    def clear_forces(self) -> None:
        self._forces[0] = None

    @property
    def last_acceleration(self) -> Vector3:
        force = Vector3(*(self._forces[1] or ()))
        return self.acceleration + force * self._inverse_mass

    def kick(self, duration: float) -> None:
        forces = self._forces
        force, last_force = forces
        if force is not last_force:  # both None: no force acts, and none has to be forgotten
            forces[0], forces[1] = None, force
        inverse_mass = self._inverse_mass
        if not inverse_mass:
            return
        keep = self._keep if duration == self._span else self._damping**duration
        velocity, acceleration = self.velocity, self.acceleration
        x, y, z = acceleration.x, acceleration.y, acceleration.z
        if force is not None:
            fx, fy, fz = force
            x += fx * inverse_mass
            y += fy * inverse_mass
            z += fz * inverse_mass
        velocity.x = (velocity.x + x * duration) * keep
        velocity.y = (velocity.y + y * duration) * keep
        velocity.z = (velocity.z + z * duration) * keep

    def integrate(self, duration: float) -> None:
        if duration != self._span and not self._renew(duration):
            self.kick(duration)  # which clears the forces of an immovable particle, too
            return
        position, velocity, acceleration = self.position, self.velocity, self.acceleration
        keep, u, v, w = self._keep, velocity.x, velocity.y, velocity.z
        position.x += u * duration
        position.y += v * duration
        position.z += w * duration
        x, y, z = acceleration.x, acceleration.y, acceleration.z
        forces = self._forces
        force, last_force = forces
        if force is not last_force:
            forces[0], forces[1] = None, force
        if force is not None:
            fx, fy, fz = force
            inverse_mass = self._inverse_mass
            x += fx * inverse_mass
            y += fy * inverse_mass
            z += fz * inverse_mass
        velocity.x = (u + x * duration) * keep
        velocity.y = (v + y * duration) * keep
        velocity.z = (w + z * duration) * keep
