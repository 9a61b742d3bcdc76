"""Detectors, which find the current contacts and predict the next impact.

A resolver asks a detector after each step which particles touch, by calling ``contacts()``. The
contacts are always in the order of the particles. Particles that just touch have a contact too,
with a penetration of 0. ``time_division_step`` must know before a step when something will touch,
so that it can stop there. It calls ``next_impact(duration)``, which predicts the next impact.

Lengths are in m, times in s. A detector does not copy its list of particles, so you may add
particles to the list later. Constructors raise ValueError for a number that is negative or not
finite and for a restitution outside 0 to 1, and TypeError for an argument of the wrong type.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol

from ch02_vectors.arguments import finite, instance_of, not_negative, positive
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, a_restitution

Impact = tuple[float, Contact]


class Detector(Protocol):
    """The interface of a detector. A detector need not inherit from this class."""

    def contacts(self) -> Iterable[Contact]:
        """Return the current contacts."""

    def next_impact(self, duration: float) -> Impact | None:
        """Return the time and contact of the first impact within ``duration`` s, or None."""


class GroundPlane:
    """Exercise 7.5: level ground at a height, for points or for spheres of one radius.

    Everything below the height is ground. Even a fast particle therefore cannot pass through: if it
    ends a step below the height, it is in contact.
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

        The contact's ``other`` is None and its normal is (0, 1, 0). Its penetration is the depth of
        the sphere's lowest point below the ground. Immovable particles have no contacts.
        """
        raise NotImplementedError("Exercise 7.5: A detector for the ground")

    def next_impact(self, duration: float) -> Impact | None:
        """Return the time and contact of the first impact on the ground within ``duration`` s.

        After t seconds a particle is at p + v t + a t^2 / 2, where a is its ``last_acceleration``.
        It hits the ground at the time that ``time_to_close`` returns for the gap below it. A
        particle that lies on the ground and is accelerated downward always has an impact at time 0.
        Immovable particles have no impacts. If two particles hit the ground at the same time, take
        the one that is earlier in the list.

        Returns:
            (time, contact), where the contact has a penetration of 0, or None if there is no
                impact.

        Raises:
            ValueError: if the duration is negative or not finite.
        """
        raise NotImplementedError("Exercise B7.10: When does it reach the ground?")


class ParticlePairs:
    """Finds contacts between pairs of spheres, which all have the same positive ``radius``."""

    def __init__(
        self, particles: Sequence[Particle], radius: float, restitution: float = 0.0
    ) -> None:
        self.particles = some_particles(particles)
        self.radius = positive("radius", radius)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a contact for each pair of spheres that touch or overlap.

        The contacts are in the order of the list, and the ``particle`` of each contact is earlier
        in the list than its ``other``. The normal points from ``other`` to ``particle``. If both
        positions are equal, the normal is +Y. Two immovable particles have no contact.

        If you compared every pair, the cost would grow with the square of the number of particles.
        Find the pairs in another way. For example, sort the particles into the cells of a grid.
        Then only particles in the same cell or in neighboring cells can touch.
        """
        raise NotImplementedError("Exercise B7.9: Pairs of spheres")

    def next_impact(self, duration: float) -> Impact | None:
        """Return the time and contact of the first impact of two spheres within ``duration`` s.

        After t seconds a particle is at p + v t + a t^2 / 2, where a is its ``last_acceleration``.
        Two particles with the same acceleration therefore move in a straight line relative to each
        other. Immovable particles stay where they are and have no acceleration.

        Two spheres have an impact when they touch or overlap and close faster than
        ``VELOCITY_TOLERANCE``. If this is already true at the start, the time is 0. A slower
        closing speed may be the rounding error of an earlier impact, so ignore it. If several
        impacts happen at the same time, take the first in the order of ``contacts()``.

        Returns:
            (time, contact), or None if there is no impact. The contact's normal is the one at the
                time of the impact, and its penetration is 0.

        Raises:
            ValueError: if the duration is negative or not finite, or if the accelerations of any
                two particles differ by more than rounding, 1e-12 of their sizes.
        """
        raise NotImplementedError("Exercise B7.11: When do two spheres meet?")


class Detectors:
    """Combines several detectors, such as the ground and pairs of spheres, into one."""

    def __init__(self, *detectors: Detector) -> None:
        self.detectors = detectors

    def contacts(self) -> list[Contact]:
        """Return the contacts of all detectors, in their order."""
        return [contact for detector in self.detectors for contact in detector.contacts()]

    def next_impact(self, duration: float) -> Impact | None:
        """Return the earliest impact of any detector. At equal times, the first detector wins.

        Raises:
            ValueError: if one of the detectors raises it.
        """
        impacts = [detector.next_impact(duration) for detector in self.detectors]
        return min((impact for impact in impacts if impact), key=lambda i: i[0], default=None)


def time_to_close(gap: float, velocity: float, acceleration: float) -> float:
    """Return the first time in s at which a gap is 0 or negative and still decreasing.

    After t seconds the gap is gap + v t + a t^2 / 2, where v is the velocity in m/s and a is the
    acceleration in m/s^2. A negative v makes the gap smaller. If the gap is already 0 or negative
    at the start, the sign of v decides:

    - If v is negative, or if v is 0 and a is negative, the result is 0.
    - If v is positive and a is negative, the result is the time at which the gap returns to 0. If
      the gap never becomes positive, it is the time at which v reverses.

    A very slow velocity may be only rounding. So if a is not negative, a velocity of
    -VELOCITY_TOLERANCE or more does not close the gap. Return ``math.inf`` if the gap never closes,
    or if the velocity reverses exactly when the gap is 0. The arguments are not checked.
    """
    raise NotImplementedError("Exercise B7.10: When does it reach the ground?")


def some_particles(particles: Sequence[Particle]) -> Sequence[Particle]:
    """Return ``particles`` if it is a list or tuple of particles, or raise TypeError."""
    if not isinstance(particles, (list, tuple)):
        raise TypeError(f"particles must be a list or tuple, got {particles!r}")
    for i, particle in enumerate(particles):
        instance_of(f"particles[{i}]", particle, Particle)
    return particles
