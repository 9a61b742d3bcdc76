"""Force generators, and the registry that applies them in each time step (book 5.2 and 5.3).

The constructors are complete. They check their arguments and copy vectors. You may change the
attributes of a generator later, and it uses the new values from its next call on. Forces are in N.
"""

from __future__ import annotations

import math
from typing import Protocol

from ch02_vectors.arguments import finite, finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class ForceGenerator(Protocol):
    """A force generator, which is any object with an ``update_force`` method."""

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force to the others on ``particle``. Change nothing else."""


class ForceRegistry:
    """The forces of a scene: pairs (particle, generator) in ``_pairs``, in the order of ``add``."""

    def __init__(self) -> None:
        self._pairs: list[tuple[Particle, ForceGenerator]] = []

    def pairs(self) -> list[tuple[Particle, ForceGenerator]]:
        """Return a new list of the (particle, generator) pairs, in the order they were added."""
        return [*self._pairs]

    def add(self, particle: Particle, generator: ForceGenerator) -> None:
        """Register a generator. It may act on several particles; a pair added twice acts twice."""
        self._pairs.append((particle, generator))

    def remove(self, particle: Particle, generator: ForceGenerator) -> None:
        """Undo one call of ``add``. Compare with ``is``. If there is no such pair, do nothing."""
        for i, (other, others) in enumerate(self._pairs):
            if other is particle and others is generator:
                del self._pairs[i]
                return

    def clear(self) -> None:
        """Remove all pairs from the registry, without changing the particles and generators."""
        self._pairs.clear()

    def update_forces(self, duration: float) -> None:
        """Let every registered generator add its force to its particle, once per time step.

        Go through the pairs in the order in which they were added, and skip immovable particles. A
        generator may add or remove pairs meanwhile, but the change takes effect only in the next
        call.
        """
        positive("duration", duration)
        for particle, generator in self._pairs.copy():
            if particle.inverse_mass:
                generator.update_force(particle, duration)


class Gravity:
    """A weight m g, for the vector g = ``acceleration`` in m/s^2 (book 5.2.3)."""

    def __init__(self, acceleration: Vector3) -> None:
        self.acceleration = finite_vector("acceleration", acceleration)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the weight m g. Skip an immovable particle, whose weight would be infinite."""
        if particle.has_finite_mass:
            particle.add_force(self.acceleration * particle.mass)


class Drag:
    """Drag in still air, with k1 in N s/m and k2 in N s^2/m^2 (book 5.2.4, Eq. 5.1)."""

    def __init__(self, k1: float, k2: float) -> None:
        self.k1 = not_negative("k1", k1)
        self.k2 = not_negative("k2", k2)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the drag of ``drag_force`` to the particle's other forces."""
        particle.add_force(drag_force(particle.velocity, self.k1, self.k2))


def drag_force(velocity: Vector3, k1: float, k2: float) -> Vector3:
    """Compute the drag, -v^ (k1 |v| + k2 |v|^2), as a new vector (book Eq. 5.1).

    Here v^ is the unit vector along the velocity. If the velocity is zero, so is the drag.
    """
    return velocity * -(k1 + k2 * velocity.magnitude())


class Uplift:
    """A vertical column of rising air around ``origin``, without an upper or lower end."""

    def __init__(self, origin: Vector3, radius: float, force: Vector3) -> None:
        self.origin = finite_vector("origin", origin)
        self.radius = not_negative("radius", radius)
        self.force = finite_vector("force", force)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add ``force`` if the horizontal distance (in X and Z) from the axis is at most
        ``radius``.
        """
        place = particle.position
        if math.hypot(place.x - self.origin.x, place.z - self.origin.z) <= self.radius:
            particle.add_force(self.force)


class Airbrake:
    """A brake with the force -k v that can be switched ``on`` and off, with ``k`` in N s/m."""

    # The share of a full stop that the brake takes at most: rounding cannot make it more than all.
    FULL = 1.0 - 1e-12

    def __init__(self, k: float) -> None:
        self.k = not_negative("k", k)
        self.on = False

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force -k v if the brake is on, but never so much that the motion reverses.

        A force f changes the velocity by f h / m in a step of h s. On its own, the brake may remove
        at most the fraction ``FULL`` of the velocity in one step. An immovable particle must not
        cause an error.
        """
        positive("duration", duration)
        if self.on:
            most = self.FULL * particle.mass / duration
            particle.add_force(particle.velocity * -min(self.k, most))


class PointGravity:
    """Gravity of ``strength`` m/s^2 toward ``center``, or away from it if it is negative."""

    def __init__(self, center: Vector3, strength: float) -> None:
        self.center = finite_vector("center", center)
        self.strength = finite("strength", strength)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add a force of m times ``strength`` toward the center, even very close to the center.

        At the center it has no direction, so it is zero there. Skip an immovable particle.
        """
        if particle.has_finite_mass:
            way = (self.center - particle.position).normalized()
            particle.add_force(way * (particle.mass * self.strength))


class InverseSquareGravity:
    """Gravity that falls with 1 / r^2, as for orbits. ``mu`` is G times a mass, in m^3/s^2."""

    def __init__(self, center: Vector3, mu: float) -> None:
        self.center = finite_vector("center", center)
        self.mu = finite("mu", mu)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force m mu / r^2 toward the center, or away from it if mu is negative.

        If the force is finite, it must be correct at any distance, even if r^2 does not fit in a
        float. Skip an immovable particle. Raises ArithmeticError, and adds no force, if the
        particle is at the center or so close to it that the force is not finite.
        """
        if not particle.has_finite_mass:
            return
        way = self.center - particle.position
        distance = way.magnitude()
        force = particle.mass / distance * (self.mu / distance) if distance else math.inf
        if not math.isfinite(force):
            raise ArithmeticError(f"the force is not finite at {distance!r} m from the center")
        particle.add_force(way.normalized() * force)
