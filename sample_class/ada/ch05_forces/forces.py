"""Force generators, and the registry that asks them for their forces once a frame (book 5.2, 5.3).

A generator adds a force to a particle, and knows nothing of the other forces that act on it. What
one is made with is looked at and, where it is a vector, copied. Its attributes may be changed
later, and are then yours to keep finite.
"""

from __future__ import annotations

import math
from typing import Protocol

from ch02_vectors.arguments import finite, finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class ForceGenerator(Protocol):
    """Whatever has this method is a force generator: no class needs to derive from this one."""

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add this generator's force on a particle, for a frame of a duration in s (5.2.1)."""


class ForceRegistry:
    """Pairs of a particle and a generator that acts on it, in the order in which they were added.

    What is kept is ``_pairs``, a list of tuples (particle, generator).
    """

    def __init__(self) -> None:
        self._pairs: list[tuple[Particle, ForceGenerator]] = []

    def pairs(self) -> list[tuple[Particle, ForceGenerator]]:
        """Return the pairs in their order, in a list of its own. Later chapters ask for them."""
        return [*self._pairs]

    def add(self, particle: Particle, generator: ForceGenerator) -> None:
        """Let a generator act on a particle from now on (5.2.2); a pair added twice acts twice.

        Raises TypeError for a particle without add_force, or a generator without update_force.
        """
        _must_have(particle, "particle", "add_force")
        _must_have(generator, "generator", "update_force")
        self._pairs.append((particle, generator))

    def remove(self, particle: Particle, generator: ForceGenerator) -> None:
        """Take back one call of add for this very particle and generator; none is no error."""
        for index in reversed(range(len(self._pairs))):
            one, other = self._pairs[index]
            if one is particle and other is generator:
                del self._pairs[index]
                return

    def clear(self) -> None:
        """Take back every call of add; particles and generators stay as they are."""
        self._pairs = []

    def update_forces(self, duration: float) -> None:
        """Ask every generator for its force on its particle, for a frame of a duration in s.

        Immovable particles are skipped. A generator may add and remove pairs meanwhile: that counts
        from the next call on.

        Raises ValueError where the duration is not positive and finite; nothing is asked then.
        """
        positive("duration", duration)
        for particle, generator in tuple(self._pairs):
            if particle.has_finite_mass:
                generator.update_force(particle, duration)


class Gravity:
    """The weight of a particle, m g (Eq. 3.4), for an acceleration g in m/s^2: a vector.

    Particle.acceleration does the same for less, wherever g is the same at all times (5.2.3).
    """

    def __init__(self, acceleration: Vector3) -> None:
        self.acceleration = finite_vector("acceleration", acceleration)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add m g. An immovable particle is left alone: its weight would be infinite (5.2.3)."""
        if particle.has_finite_mass:
            particle.add_force(particle.mass * self.acceleration)


class Drag:
    """Drag against the motion (Eq. 5.1): a part that grows with the speed, and one with its square.

    k1 is in N s/m, k2 in N s^2/m^2. Raises ValueError where one is negative or not finite.
    """

    def __init__(self, k1: float, k2: float) -> None:
        self.k1 = not_negative("k1", k1)
        self.k2 = not_negative("k2", k2)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the drag_force of the particle's velocity."""
        particle.add_force(drag_force(particle.velocity, self.k1, self.k2))


def drag_force(velocity: Vector3, k1: float, k2: float) -> Vector3:
    """Return the drag in N at a velocity, as new: -v^ (k1 |v| + k2 |v|^2) (Eq. 5.1).

    v^ is the direction of the velocity; where there is none, there is no drag.
    """
    # v^ |v| is v, so one |v| goes into it: no division, and nothing to ask of a zero.
    return velocity * -(k1 + k2 * velocity.magnitude())


class Uplift:
    """Exercise 5.1: a column of rising air, upright and without an end.

    ``force`` is a vector in N; the column's middle runs through ``origin``, its ``radius`` is in m.

    Raises ValueError where the radius is negative or not finite.
    """

    def __init__(self, origin: Vector3, radius: float, force: Vector3) -> None:
        self.origin = finite_vector("origin", origin)
        self.radius = not_negative("radius", radius)
        self.force = finite_vector("force", force)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 5.1: add the force where the particle is in the column, at whatever height.

        It is where its distance from the origin in X and Z is at most the radius.
        """
        away = particle.position - self.origin
        away.y = 0.0
        if away.magnitude() <= self.radius:
            particle.add_force(self.force)


class Airbrake:
    """Exercise 5.2: a large drag, -k v with k in N s/m, that is switched on and off.

    ``on`` is the switch; a new brake is off. Raises ValueError where k is negative or not finite.
    """

    # The share of a full stop that the brake takes at most: rounding cannot make it more than all.
    FULL = 1.0 - 1e-12

    def __init__(self, k: float) -> None:
        self.k = not_negative("k", k)
        self.on = False

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 5.2: where the brake is on, add -k v, but nothing that turns the motion round.

        A force f changes the velocity of a frame by f h / m. So the brake alone never takes more
        than FULL of the velocity, however large k is, and however long the frame.

        Raises ValueError where the duration is not positive and finite.
        """
        positive("duration", duration)
        if not self.on:
            return
        strongest = self.FULL * particle.mass / duration  # this k would take FULL of the velocity
        particle.add_force(-particle.velocity * min(self.k, strongest))


class PointGravity:
    """Exercise 5.3: gravity towards a point, of the same strength in m/s^2 at every distance.

    Raises ValueError where the strength is not finite; a negative one pushes away.
    """

    def __init__(self, center: Vector3, strength: float) -> None:
        self.center = finite_vector("center", center)
        self.strength = finite("strength", strength)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 5.3: add m g towards the center; at the center there is no force.

        An immovable particle is left alone.
        """
        if not particle.has_finite_mass:
            return
        direction = (self.center - particle.position).normalized()
        particle.add_force(direction * particle.mass * self.strength)


class InverseSquareGravity:
    """Exercise 5.4: gravity towards a point that weakens with the square of the distance (Eq. 3.3).

    ``mu`` is G times the mass that attracts, in m^3/s^2. Raises ValueError where it is not finite;
    a negative one pushes away.
    """

    def __init__(self, center: Vector3, mu: float) -> None:
        self.center = finite_vector("center", center)
        self.mu = finite("mu", mu)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 5.4: add the force m mu / r^2 towards the center, r the distance in m.

        An immovable particle is left alone. Raises ArithmeticError at the center, and so near to it
        that the force is not finite; nothing is added then.
        """
        if not particle.has_finite_mass:
            return
        way = self.center - particle.position
        r = way.magnitude()
        if r == 0.0:
            raise ArithmeticError(f"there is no direction at the center {self.center!r}")
        force = way.normalized() * ((self.mu / r) * (particle.mass / r))
        if not all(math.isfinite(component) for component in force):
            raise ArithmeticError(f"the force is not finite at {r!r} m from {self.center!r}")
        particle.add_force(force)


def _must_have(thing: object, name: str, method: str) -> None:
    if not callable(getattr(thing, method, None)):
        raise TypeError(f"{name} must have a method {method}, got {thing!r}")
