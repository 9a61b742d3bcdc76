"""Detectors: objects that find out which particles touch, and predict the next impact.

``contacts()`` finds all particles that touch or overlap now, in the order of the list.
``next_impact(duration)`` finds the first impact in the coming ``duration`` s, including its end. In
t seconds a particle moves to p + v t + a t^2 / 2, where a is its ``last_acceleration``.

A detector does not copy its list, so you may add particles to the list later. Lengths are in m. A
number out of range raises ValueError, and a value of the wrong type raises TypeError.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, product
from typing import Protocol

from ch02_vectors.arguments import finite, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import (
    VELOCITY_TOLERANCE,
    Contact,
    a_restitution,
    direction_of,
)

Impact = tuple[float, Contact]  # the time of the impact in s, and its contact with penetration 0
UP = Vector3(0.0, 1.0, 0.0)  # the normal of level ground


class Detector(Protocol):
    """The interface of detectors. A detector does not have to inherit from this class."""

    def contacts(self) -> Iterable[Contact]:
        """Find all contacts at the current positions and return them."""

    def next_impact(self, duration: float) -> Impact | None:
        """Find the first impact within ``duration`` s, as (time, contact), or return None."""


class GroundPlane:
    """Exercise 7.5: a detector for particles that touch level ground at ``height``.

    The particles are points, or spheres that all have the same ``radius``. Everything below
    ``height`` is ground, so even a very fast particle cannot pass through it.
    """

    def __init__(
        self,
        particles: Sequence[Particle],
        height: float = 0.0,
        radius: float = 0.0,
        restitution: float = 0.0,
    ) -> None:
        self.particles = some_particles(particles)
        self.height = finite("height", height)
        self.radius = not_negative("radius", radius)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Exercise 7.5: return a contact for each particle that touches the ground or is below it.

        In each contact, ``other`` is None, the normal is (0, 1, 0), and the penetration is the
        depth of the sphere's lowest point below the ground. Immovable particles have no contacts.
        """
        found = []
        for particle in self.particles:
            depth = self.height + self.radius - particle.position.y
            if depth >= 0.0 and particle.inverse_mass:
                found.append(Contact(particle, None, UP, self.restitution, depth))
        return found

    def next_impact(self, duration: float) -> Impact | None:
        """Predict the first impact of a particle on the ground, with ``time_to_close``.

        Immovable particles have no impact. Of impacts at the same time, take the first in the list.
        """
        not_negative("duration", duration)
        impacts = []
        for particle in self.particles:
            gap = particle.position.y - self.height - self.radius
            time = time_to_close(gap, particle.velocity.y, particle.last_acceleration.y)
            if time <= duration and particle.inverse_mass:
                impacts.append((time, Contact(particle, None, UP, self.restitution)))
        return earliest(impacts)


class ParticlePairs:
    """A detector for collisions between spheres around particles, all with the same ``radius``."""

    def __init__(
        self, particles: Sequence[Particle], radius: float, restitution: float = 0.0
    ) -> None:
        self.particles = some_particles(particles)
        self.radius = positive("radius", radius)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a contact for each pair of spheres that touch or overlap.

        The contacts are in the order of the list, and in each contact ``particle`` comes earlier in
        the list than ``other``. The normal points from ``other`` to ``particle``, or along +Y if
        both positions are equal. Two immovable particles have no contact.

        Do not compare every pair, because the cost grows with the square of the number of spheres.
        """
        found = []
        for i, j in sorted(self._near_pairs()):
            a, b = self.particles[i], self.particles[j]
            offset = a.position - b.position
            depth = 2.0 * self.radius - offset.magnitude()
            if depth >= 0.0 and a.inverse_mass + b.inverse_mass:
                found.append(Contact(a, b, direction_of(offset), self.restitution, depth))
        return found

    def _near_pairs(self) -> Iterator[tuple[int, int]]:
        """Sort the particles into a grid one by one, each after meeting its earlier neighbors."""
        size = 2.001 * self.radius  # so that spheres that just touch are never two cells apart
        cells: dict[tuple[int, int, int], list[int]] = {}
        for j, particle in enumerate(self.particles):
            x, y, z = (math.floor(component / size) for component in particle.position)
            for right, up, front in product((-1, 0, 1), repeat=3):
                for i in cells.get((x + right, y + up, z + front), ()):
                    yield i, j
            cells.setdefault((x, y, z), []).append(j)

    def next_impact(self, duration: float) -> Impact | None:
        """Predict the first impact of two spheres, with its normal at the time of the impact.

        You may assume that the accelerations of all particles are the same, or differ only by
        rounding errors. Treat the velocity of an immovable particle as zero.

        Two spheres have an impact when they touch or overlap while they approach each other faster
        than ``VELOCITY_TOLERANCE``. Ignore a slower approach, which may be the rounding error of an
        earlier impact. If they already touch and approach at the start, the time is 0. Of impacts
        at the same time, take the first in the order of ``contacts()``.
        """
        not_negative("duration", duration)
        impacts = []
        for a, b in combinations(self.particles, 2):
            offset, velocity = a.position - b.position, _velocity(a) - _velocity(b)
            time = _time_to_touch(offset, velocity, 2.0 * self.radius)
            if time <= duration:
                normal = (offset + velocity * time).normalized()
                impacts.append((time, Contact(a, b, normal, self.restitution)))
        return earliest(impacts)


def _velocity(particle: Particle) -> Vector3:
    """Return the velocity of a particle, or zero if it is immovable."""
    return particle.velocity if particle.inverse_mass else Vector3()


def _time_to_touch(d: Vector3, u: Vector3, distance: float) -> float:
    """Solve |d + u t| = ``distance`` for the time t >= 0 at which the spheres meet, or math.inf."""
    closing = -d.dot(u)  # the closing speed times the distance
    if closing <= VELOCITY_TOLERANCE * d.magnitude():
        return math.inf
    gap = d.squared_magnitude() - distance**2
    if gap <= 0.0:
        return 0.0
    root = closing**2 - u.squared_magnitude() * gap
    return gap / (closing + math.sqrt(root)) if root > 0.0 else math.inf


class Detectors:
    """Combines several detectors into one, for example one for the ground and one for spheres."""

    def __init__(self, *detectors: Detector) -> None:
        self.detectors = detectors

    def contacts(self) -> list[Contact]:
        """Return the contacts of all detectors in one list, in the order of the detectors."""
        return [contact for detector in self.detectors for contact in detector.contacts()]

    def next_impact(self, duration: float) -> Impact | None:
        """Return the earliest impact of all detectors. Of equals, take the first detector's."""
        impacts = [detector.next_impact(duration) for detector in self.detectors]
        return earliest(impact for impact in impacts if impact)


def earliest(impacts: Iterable[Impact]) -> Impact | None:
    """Return the first of the impacts with the lowest time, or None if there are no impacts."""
    return min(impacts, key=lambda impact: impact[0], default=None)


def time_to_close(gap: float, velocity: float, acceleration: float) -> float:
    """Compute how long it takes until the gap between a body and the ground closes, in s.

    After t seconds the gap is g + v t + a t^2 / 2. The result is the first time at which the gap is
    0 or negative and still decreasing. That is 0 for a body on or below the ground with v < 0, or
    with v = 0 and a < 0. If it moves up and a < 0, it is the time at which the gap returns to 0, or
    at which v reverses if the gap never becomes positive.

    Return ``math.inf`` if the gap never closes, or if v reverses exactly when the gap is 0. A v
    between -VELOCITY_TOLERANCE and 0 may be a rounding error, so it closes the gap only if a < 0.
    The result must have nine correct digits, even for a fast body just above the ground, so do not
    subtract nearly equal numbers. The arguments are not checked.
    """
    if acceleration >= 0.0 and velocity >= -VELOCITY_TOLERANCE:
        return math.inf
    if gap <= 0.0 and velocity <= 0.0:
        return 0.0
    squared = velocity**2 - 2.0 * acceleration * gap  # the square of the velocity at the ground
    if velocity > 0.0:  # up first; if the square is negative, it turns around below the ground
        return (velocity + math.sqrt(max(0.0, squared))) / -acceleration
    if squared <= 0.0:  # it turns around before it reaches the ground
        return math.inf
    return 2.0 * gap / (math.sqrt(squared) - velocity)  # the gap over the mean of both speeds


def some_particles(particles: Sequence[Particle]) -> Sequence[Particle]:
    """Check that ``particles`` is a list or a tuple of particles, and return it."""
    if not isinstance(particles, (list, tuple)):
        raise TypeError(f"particles must be a list or tuple, got {particles!r}")
    for i, particle in enumerate(particles):
        instance_of(f"particles[{i}]", particle, Particle)
    return particles
