"""Detectors: objects that find out which particles touch, and predict the next impact.

A detector has two methods. The engine calls ``contacts()`` after each step to find out which
particles touch. Particles that just touch also have a contact, with a penetration of 0. The
contacts are always in the order of the particles. A step with time division (``time_division.py``)
calls ``next_impact(duration)`` before it moves the particles, because it must stop at the next
impact.

Lengths are in m, times in s. A detector does not copy its list of particles, so you may add
particles to the list later. You may also change the attributes of a detector between two calls.
Constructors raise ValueError for a number that is not finite, a radius that is too small, and a
restitution outside 0 to 1. They raise TypeError for an argument of the wrong type.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol

from ch02_vectors.arguments import finite, instance_of, not_negative, positive
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, a_restitution

Impact = tuple[float, Contact]


class Detector(Protocol):
    """The interface of detectors, which have the methods ``contacts`` and ``next_impact``.

    A detector does not have to inherit from this class.
    """

    def contacts(self) -> Iterable[Contact]:
        """Find all contacts at the current positions and return them."""

    def next_impact(self, duration: float) -> Impact | None:
        """Find the first impact within ``duration`` s, as (time, contact), or return None.

        An impact exactly at the end of the duration counts.
        """


class GroundPlane:
    """Exercise 7.5: a detector for particles that touch level ground at ``height``.

    The particles are points, or spheres that all have the same ``radius``. Everything below
    ``height`` is ground. A particle that ends a step there is in contact, however deep it is, so
    even a very fast particle cannot pass through the ground.
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
        """Predict the first impact of a particle on the ground within ``duration`` s.

        After t seconds a particle is at p + v t + a t^2 / 2, where a is its ``last_acceleration``.
        Use ``time_to_close`` to find out when the gap between the particle and the ground closes. A
        particle that lies on the ground and is accelerated downward always has an impact at time 0,
        and an immovable particle has none. If two particles hit the ground at the same time, take
        the particle that is earlier in the list.

        Returns:
            The tuple (time, contact), or None if there is no impact. The contact has a penetration
            of 0.
        """
        raise NotImplementedError("Exercise B7.10: When does it reach the ground?")


class ParticlePairs:
    """A detector for collisions between spheres that all have the same positive ``radius``.

    The center of each sphere is a particle.
    """

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

        Do not compare every pair, because the cost would grow with the square of the number of
        particles. You can, for example, sort the particles into the cells of a grid. If the cells
        are large enough, only particles in the same cell or in neighboring cells can touch.
        """
        raise NotImplementedError("Exercise B7.9: Pairs of spheres")

    def next_impact(self, duration: float) -> Impact | None:
        """Predict the first impact of two spheres within ``duration`` s.

        After t seconds a particle is at p + v t + a t^2 / 2, where a is its ``last_acceleration``.
        Two particles with the same acceleration move in a straight line relative to each other, so
        the time of their impact is easy to compute. You may assume that the accelerations of all
        particles are the same, or differ only by rounding errors. Treat the velocity and the
        acceleration of an immovable particle as zero.

        Two spheres have an impact when they touch or overlap while they approach each other faster
        than ``VELOCITY_TOLERANCE``. Ignore a slower approach, because it may be only the rounding
        error of an earlier impact. If the spheres already touch and approach at the start, the time
        is 0. If several impacts happen at the same time, take the first in the order of
        ``contacts()``.

        Returns:
            The tuple (time, contact), or None if there is no impact. The contact has the normal at
            the time of the impact, and a penetration of 0.
        """
        raise NotImplementedError("Exercise B7.11: When do two spheres meet?")


class Detectors:
    """Combines several detectors into one, for example one for the ground and one for spheres.

    You can then pass all of them to ``time_division_step``, which takes only one detector.
    """

    def __init__(self, *detectors: Detector) -> None:
        self.detectors = detectors

    def contacts(self) -> list[Contact]:
        """Return the contacts of all detectors in one list, in the order of the detectors."""
        return [contact for detector in self.detectors for contact in detector.contacts()]

    def next_impact(self, duration: float) -> Impact | None:
        """Return the earliest impact that any of the detectors finds, or None if there is none.

        If several impacts happen at the same time, return the one from the detector listed first.

        Raises:
            ValueError: if one of the detectors raises it.
        """
        impacts = [detector.next_impact(duration) for detector in self.detectors]
        return min((impact for impact in impacts if impact), key=lambda i: i[0], default=None)


def time_to_close(gap: float, velocity: float, acceleration: float) -> float:
    """Compute how long it takes until the gap between a body and the ground closes, in s.

    The result is the first time at which the gap is 0 or negative and still decreasing. After t
    seconds the gap is g + v t + a t^2 / 2. Here g is ``gap`` in m, v is ``velocity`` in m/s and a
    is ``acceleration`` in m/s^2. A negative v makes the gap smaller. If the gap is already 0 or
    negative at the start, the result depends on v:

    - If v is negative, or if v is 0 and a is negative, the result is 0.
    - If v is positive and a is negative, the result is the time at which the gap returns to 0. If
      the gap never becomes positive, the result is the time at which v reverses.

    A very small velocity may be only a rounding error. So if v is between -VELOCITY_TOLERANCE and
    0, the gap closes only if a is negative. The result must have nine correct digits, even for a
    fast body just above the ground, so do not subtract nearly equal numbers. Return ``math.inf`` if
    the gap never closes, and also if the velocity reverses exactly when the gap is 0. The arguments
    are not checked.
    """
    raise NotImplementedError("Exercise B7.10: When does it reach the ground?")


def some_particles(particles: Sequence[Particle]) -> Sequence[Particle]:
    """Check that ``particles`` is a list or a tuple of particles, and return it.

    Raises:
        TypeError: if it is anything else.
    """
    if not isinstance(particles, (list, tuple)):
        raise TypeError(f"particles must be a list or tuple, got {particles!r}")
    for i, particle in enumerate(particles):
        instance_of(f"particles[{i}]", particle, Particle)
    return particles
