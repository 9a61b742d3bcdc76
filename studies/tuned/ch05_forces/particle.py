"""The particle of chapter 5 in plain numbers.

A sum of forces is a tuple of three numbers, or None if no force was added, so a step without forces
costs little more than in chapter 3. The other modules of this folder read and write the sums
themselves. Integrators call ``kick_and_drift``, ``drift_and_kick`` and ``kick_from``, which do in
one call what a kick and a drift do, or what a kick does after the velocity is set.
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

    def __init_subclass__(cls) -> None:
        """Let the steps of integrators call a drift or a kick that a subclass has written."""
        super().__init_subclass__()
        if "drift" in vars(cls) or "kick" in vars(cls):
            cls.drift_and_kick = particle.drift_and_kick  # type: ignore[assignment]
            cls.kick_and_drift = _kick_and_drift  # type: ignore[assignment]
            cls.kick_from = _kick_from  # type: ignore[assignment]

    def __copy__(self) -> Self:
        """Return a copy with a list of forces of its own."""
        other = self.__new__(type(self))
        state: Any = object.__getstate__(self)  # the attributes of a subclass, and of __slots__
        own, slots = state
        for name, value in {**(own or {}), **slots}.items():
            setattr(other, name, value)
        other._forces = [*self._forces]
        return other

    def add_numbers(self, x: float, y: float, z: float) -> None:
        """Add the force with these components in N, as ``add_force`` does."""
        forces = self._forces
        if forces[0] is not None:
            sum_x, sum_y, sum_z = forces[0]
            x, y, z = sum_x + x, sum_y + y, sum_z + z
        if 0.0 * (x + y + z) != 0.0:  # one question for three numbers: infinity * 0 is NaN
            finite_vector("the sum of the forces", Vector3(x, y, z))
        forces[0] = (x, y, z)

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
        if (force := forces[0]) is None:
            forces[1] = None
        else:
            forces[0] = None
            forces[1] = force
        inverse_mass = self._inverse_mass
        if not inverse_mass:
            return
        keep = self._keep if duration == self._span else self._factor(duration)
        velocity = self.velocity
        acceleration = self.acceleration
        x = acceleration.x
        y = acceleration.y
        z = acceleration.z
        if force is not None:
            fx, fy, fz = force
            x += fx * inverse_mass
            y += fy * inverse_mass
            z += fz * inverse_mass
        velocity.x = (velocity.x + x * duration) * keep
        velocity.y = (velocity.y + y * duration) * keep
        velocity.z = (velocity.z + z * duration) * keep

    def kick_and_drift(self, duration: float, ahead: float) -> None:
        """Kick the particle for ``duration`` s, and let it drift for ``ahead`` s."""
        forces = self._forces
        if (force := forces[0]) is None:
            forces[1] = None
        else:
            forces[0] = None
            forces[1] = force
        inverse_mass = self._inverse_mass
        if not inverse_mass:
            return
        keep = self._keep if duration == self._span else self._factor(duration)
        position = self.position
        velocity = self.velocity
        acceleration = self.acceleration
        x = acceleration.x
        y = acceleration.y
        z = acceleration.z
        if force is not None:
            fx, fy, fz = force
            x += fx * inverse_mass
            y += fy * inverse_mass
            z += fz * inverse_mass
        velocity.x = x = (velocity.x + x * duration) * keep
        velocity.y = y = (velocity.y + y * duration) * keep
        velocity.z = z = (velocity.z + z * duration) * keep
        position.x += x * ahead
        position.y += y * ahead
        position.z += z * ahead

    def kick_from(self, u: float, v: float, w: float, force: Numbers, duration: float) -> None:
        """Kick the particle, which can move, from the velocity (u, v, w) and by this force."""
        forces = self._forces
        forces[0] = None
        forces[1] = force
        keep = self._keep if duration == self._span else self._factor(duration)
        inverse_mass = self._inverse_mass
        velocity = self.velocity
        acceleration = self.acceleration
        x, y, z = force
        velocity.x = (u + (acceleration.x + x * inverse_mass) * duration) * keep
        velocity.y = (v + (acceleration.y + y * inverse_mass) * duration) * keep
        velocity.z = (w + (acceleration.z + z * inverse_mass) * duration) * keep

    def integrate(self, duration: float) -> None:
        if duration != self._span and not self._renew(duration):
            self.kick(duration)  # which clears the forces of an immovable particle, too
            return
        position = self.position
        velocity = self.velocity
        position.x += velocity.x * duration
        position.y += velocity.y * duration
        position.z += velocity.z * duration
        acceleration = self.acceleration
        keep = self._keep
        forces = self._forces
        if (force := forces[0]) is None:
            forces[1] = None
            velocity.x = (velocity.x + acceleration.x * duration) * keep
            velocity.y = (velocity.y + acceleration.y * duration) * keep
            velocity.z = (velocity.z + acceleration.z * duration) * keep
        else:
            forces[0] = None
            forces[1] = force
            inverse_mass = self._inverse_mass
            x, y, z = force
            velocity.x = (velocity.x + (acceleration.x + x * inverse_mass) * duration) * keep
            velocity.y = (velocity.y + (acceleration.y + y * inverse_mass) * duration) * keep
            velocity.z = (velocity.z + (acceleration.z + z * inverse_mass) * duration) * keep

    drift_and_kick = integrate  # of the particle itself, whatever a subclass does


def _kick_and_drift(particle: Particle, duration: float, ahead: float) -> None:
    particle.kick(duration)
    particle.drift(ahead)


def _kick_from(
    particle: Particle, u: float, v: float, w: float, force: Numbers, duration: float
) -> None:
    velocity = particle.velocity
    velocity.x, velocity.y, velocity.z = u, v, w
    particle._forces[0] = force
    particle.kick(duration)
