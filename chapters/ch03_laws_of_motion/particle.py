"""A particle: a point with a mass that moves by Newton's laws (book chapter 3).

Units are SI: m, m/s, m/s^2, kg, s, J, kg m/s.
"""

from __future__ import annotations

from typing import Any

from ch02_vectors.arguments import finite_vector
from ch02_vectors.vector import Vector3


class Particle:
    """A point mass with a position, a velocity and a constant acceleration, such as gravity.

    ``position``, ``velocity`` and ``acceleration`` are vectors, zero where none is given. What is
    assigned to them is copied, so two particles never share one, and must be finite: ValueError
    names the one that is not, TypeError what is no Vector3. Their components may be changed one by
    one, as in ``particle.velocity.y = 3.0``, and are then yours to keep finite.

    ``damping`` is the fraction of the velocity that is kept per second: 1 keeps all of it.
    A mass of math.inf, or an inverse mass of 0, makes a particle that nothing moves.

    A particle can only have the attributes that ``__slots__`` lists. The engine keeps 1 / mass in
    ``_inverse_mass`` and the damping in ``_damping``. If your code needs to remember something
    else, add its name there.
    """

    __slots__ = ("_damping", "_inverse_mass", "acceleration", "position", "velocity")

    position: Vector3
    velocity: Vector3
    acceleration: Vector3

    def __init__(
        self,
        position: Vector3 | None = None,
        velocity: Vector3 | None = None,
        acceleration: Vector3 | None = None,
        *,
        mass: float = 1.0,
        damping: float = 1.0,
    ) -> None:
        self.position = Vector3() if position is None else position
        self.velocity = Vector3() if velocity is None else velocity
        self.acceleration = Vector3() if acceleration is None else acceleration
        self.mass = mass
        self.damping = damping

    def __setattr__(self, name: str, value: Any) -> None:
        """Set an attribute; of the three vectors keep a copy, after a look at it."""
        if name in ("position", "velocity", "acceleration"):
            value = finite_vector(name, value)
        object.__setattr__(self, name, value)

    @property
    def mass(self) -> float:
        """The mass in kg, above 0; math.inf for an immovable particle (3.2)."""
        raise NotImplementedError("Exercise B3.1: Mass, inverse mass and damping")

    @mass.setter
    def mass(self, mass: float) -> None:
        """Set the mass. Raises ValueError where it is not positive; math.inf is.

        Raises TypeError for what is no number, as every setter here does.
        """
        raise NotImplementedError("Exercise B3.1: Mass, inverse mass and damping")

    @property
    def inverse_mass(self) -> float:
        """1 / mass in 1/kg, which the engine keeps: 0 for an immovable particle (3.2)."""
        raise NotImplementedError("Exercise B3.1: Mass, inverse mass and damping")

    @inverse_mass.setter
    def inverse_mass(self, inverse_mass: float) -> None:
        """Set the inverse mass. Raises ValueError where it is negative or not finite."""
        raise NotImplementedError("Exercise B3.1: Mass, inverse mass and damping")

    @property
    def has_finite_mass(self) -> bool:
        """Whether the particle can be moved at all: True unless its mass is infinite."""
        raise NotImplementedError("Exercise B3.1: Mass, inverse mass and damping")

    @property
    def damping(self) -> float:
        """The share d of the velocity that is kept per second (Eq. 3.6)."""
        raise NotImplementedError("Exercise B3.1: Mass, inverse mass and damping")

    @damping.setter
    def damping(self, damping: float) -> None:
        """Set the damping. Raises ValueError where it is negative or not finite."""
        raise NotImplementedError("Exercise B3.1: Mass, inverse mass and damping")

    def kinetic_energy(self) -> float:
        """Exercise 3.3: return m |v|^2 / 2 in J.

        An immovable particle has none, since it does not move.
        """
        raise NotImplementedError("Exercise 3.3: Kinetic energy")

    def momentum(self) -> Vector3:
        """Return m v in kg m/s, as new: what stays constant without a force (3.2).

        An immovable particle has none, since it does not move.
        """
        raise NotImplementedError("Exercise B3.2: Momentum")

    @property
    def last_acceleration(self) -> Vector3:
        """All of the acceleration of the last step, as new; so far that is the constant one."""
        raise NotImplementedError("Exercise B3.4: The step")

    def drift(self, duration: float) -> None:
        """Move the position with the velocity for a duration in s: p' = p + v h (Eq. 2.7).

        The velocity stays as it is, and an immovable particle stays where it is. Integrators drift
        for parts of a step, and a few drift back, so the duration may be 0 or negative.

        The duration is not checked here, because a step has several moves. What makes the step
        checks it once: integrate, an integrator or a world.
        """
        raise NotImplementedError("Exercise B3.4: The step")

    def kick(self, duration: float) -> None:
        """Change the velocity as the acceleration does in a duration in s: v' = (v + a h) d^h.

        The velocity is damped after the acceleration is added. That is the form of the book's
        listing; its Eq. 3.6 has v d^h + a h (E-16). The position stays as it is, and an immovable
        particle keeps its velocity. The duration may be 0 or negative, and is not checked, as for
        drift.
        """
        raise NotImplementedError("Exercise B3.4: The step")

    def integrate(self, duration: float) -> None:
        """Make the book's step for a duration in s: drift, then kick. It is explicit Euler (3.3.2).

        So the position moves with the velocity from before the step, and the term a h^2 / 2 is left
        out on purpose. The book calls this order by another name (E-17). Chapter 5 adds forces to
        the kick, and gets its step from here: call self.kick(duration).

        An immovable particle stays as it is. Raises ValueError where the duration is not positive
        and finite, and TypeError where it is not a number; the particle is then as it was.
        """
        raise NotImplementedError("Exercise B3.4: The step")
