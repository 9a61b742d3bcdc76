"""Force generators, and the registry that asks them for their forces once a frame (book 5.2, 5.3).

A generator adds a force to a particle, and knows nothing of the other forces that act on it. What
one is made with is looked at and, where it is a vector, copied: ValueError names what is not
finite. Its attributes may be changed later, and are then yours to keep finite. What is no number,
or no Vector3, is a TypeError everywhere.
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

    The constructor makes ``_pairs``, an empty list for tuples (particle, generator). You may keep
    the pairs in another way. If you do, change ``pairs`` to match.
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
        if not callable(getattr(particle, "add_force", None)):
            raise TypeError(f"particle must have add_force, got {particle!r}")
        if not callable(getattr(generator, "update_force", None)):
            raise TypeError(f"generator must have update_force, got {generator!r}")
        self._pairs.append((particle, generator))

    def remove(self, particle: Particle, generator: ForceGenerator) -> None:
        """Take back one call of add for this very particle and generator; none is no error."""
        for i, (other, others) in enumerate(self._pairs):
            if other is particle and others is generator:
                del self._pairs[i]
                return

    def clear(self) -> None:
        """Take back every call of add; particles and generators stay as they are."""
        self._pairs.clear()

    def update_forces(self, duration: float) -> None:
        """Ask every generator for its force on its particle, for a frame of a duration in s.

        Immovable particles are skipped. A generator may add and remove pairs meanwhile: that counts
        from the next call on. What a generator raises comes out, and the pairs after it are not
        asked.

        Raises ValueError where the duration is not positive and finite; nothing is asked then.
        """
        positive("duration", duration)
        for particle, generator in self._pairs.copy():
            if particle.inverse_mass:
                generator.update_force(particle, duration)


class Gravity:
    """The weight of a particle, m g (Eq. 3.4), for an acceleration g in m/s^2: a vector.

    Particle.acceleration does the same for less, where g is the same at all places and times (5.3).
    """

    def __init__(self, acceleration: Vector3) -> None:
        self.acceleration = finite_vector("acceleration", acceleration)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add m g. An immovable particle is left alone: its weight would be infinite (5.2.3)."""
        if particle.has_finite_mass:
            particle.add_force(self.acceleration * particle.mass)


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
    """Return the drag in N at a velocity in m/s, as new: -v^ (k1 |v| + k2 |v|^2) (Eq. 5.1).

    v^ is the direction of the velocity; where there is none, there is no drag. k1 is in N s/m, and
    k2 in N s^2/m^2.
    """
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
        place = particle.position
        if math.hypot(place.x - self.origin.x, place.z - self.origin.z) <= self.radius:
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
        than FULL of the velocity, however large k is, and however long the frame. What is immovable
        is not stopped by it, and that is no error.

        Raises ValueError where the duration is not positive and finite.
        """
        positive("duration", duration)
        if self.on:
            most = self.FULL * particle.mass / duration
            particle.add_force(particle.velocity * -min(self.k, most))


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
        if particle.has_finite_mass:
            way = (self.center - particle.position).normalized()
            particle.add_force(way * (particle.mass * self.strength))


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
        distance = way.magnitude()
        force = particle.mass / distance * (self.mu / distance) if distance else math.inf
        if not math.isfinite(force):
            raise ArithmeticError(f"m mu / r^2 is not finite: the particle is {distance!r} m away")
        particle.add_force(way.normalized() * force)
