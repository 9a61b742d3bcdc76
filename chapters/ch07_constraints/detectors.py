"""Detectors: objects that find out which particles touch, and predict the next impact.

``contacts()`` finds all particles that touch or overlap now, in the order of the list.
``next_impact(duration)`` finds the first impact in the coming ``duration`` s, including its end. In
t seconds a particle moves to p + v t + a t^2 / 2, where a is its ``last_acceleration``.

A detector does not copy its list, so you may add particles to the list later. Lengths are in m. A
number out of range raises ValueError, and a value of the wrong type raises TypeError.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol

from ch02_vectors.arguments import finite, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, a_restitution

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
        raise NotImplementedError("Exercise 7.5: A detector for the ground")

    def next_impact(self, duration: float) -> Impact | None:
        """Predict the first impact of a particle on the ground, with ``time_to_close``.

        Immovable particles have no impact. Of impacts at the same time, take the first in the list.
        """
        raise NotImplementedError("Exercise B7.10: When does it reach the ground?")


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
        raise NotImplementedError("Exercise B7.9: Pairs of spheres")

    def next_impact(self, duration: float) -> Impact | None:
        """Predict the first impact of two spheres, with its normal at the time of the impact.

        You may assume that the accelerations of all particles are the same, or differ only by
        rounding errors. Treat the velocity of an immovable particle as zero.

        Two spheres have an impact when they touch or overlap while they approach each other faster
        than ``VELOCITY_TOLERANCE``. Ignore a slower approach, which may be the rounding error of an
        earlier impact. If they already touch and approach at the start, the time is 0. Of impacts
        at the same time, take the first in the order of ``contacts()``.
        """
        raise NotImplementedError("Exercise B7.11: When do two spheres meet?")


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
    raise NotImplementedError("Exercise B7.10: When does it reach the ground?")


def some_particles(particles: Sequence[Particle]) -> Sequence[Particle]:
    """Check that ``particles`` is a list or a tuple of particles, and return it."""
    if not isinstance(particles, (list, tuple)):
        raise TypeError(f"particles must be a list or tuple, got {particles!r}")
    for i, particle in enumerate(particles):
        instance_of(f"particles[{i}]", particle, Particle)
    return particles
