"""Detectors: contact generators that find what touches, and when something will.

``contacts()`` returns what touches now, in the order of the particles, the same every time. That
includes what only just touches, with a penetration of 0, so that rest is found a frame earlier.
``next_impact(duration)`` looks ahead for ``time_division_step``.

Lengths are in m, times in s. What a detector is made with is looked at: ValueError names what is
negative or not finite, and a restitution that is not from 0 to 1; TypeError what is no number, and
particles that are no list or tuple of them. A list is kept, and may be changed.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol

from ch02_vectors.arguments import finite, instance_of, not_negative, positive
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, a_restitution

Impact = tuple[float, Contact]


class Detector(Protocol):
    """Whatever has both methods is a detector: no class needs to derive from this one."""

    def contacts(self) -> Iterable[Contact]:
        """Return the contacts of now."""

    def next_impact(self, duration: float) -> Impact | None:
        """Return when the first impact of the next ``duration`` s is, and its contact, or None."""


class GroundPlane:
    """Exercise 7.5: level ground at a height, for points, and for spheres of a radius.

    All below it is ground, so whatever gets there in a frame, however fast, is in contact with it.
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
        """Exercise 7.5: return a contact for each particle that touches the ground, or is below.

        It has no other, its normal is (0, 1, 0), and its penetration is how far the lowest point of
        the sphere is below the height. Immovable particles have none.
        """
        raise NotImplementedError("Exercise 7.5: A detector for the ground")

    def next_impact(self, duration: float) -> Impact | None:
        """Return the first impact on the ground within ``duration`` s: its time and its contact.

        A particle moves by p + v t + a t^2 / 2, where a is its last_acceleration, and impacts when
        it is on the ground, or below, and closes on: see time_to_close. One that lies there, and is
        pulled downwards, impacts at 0, time and again. None where there is no impact. The contact's
        penetration is 0. Immovable particles have none, and of two at the same time the first in
        the list is taken.

        Raises ValueError where the duration is negative or not finite.
        """
        raise NotImplementedError("Exercise B7.10: When does it reach the ground?")


class ParticlePairs:
    """Finds pairs of particles that touch: spheres that all have one ``radius``, above 0."""

    def __init__(
        self, particles: Sequence[Particle], radius: float, restitution: float = 0.0
    ) -> None:
        self.particles = some_particles(particles)
        self.radius = positive("radius", radius)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return a contact for each pair whose spheres touch or overlap.

        Its particle is the one that comes first in the list; its normal leads there from the other
        one, and is +Y where both are at one place. Two immovable particles have none.

        It does not look at each pair: only particles in the same cell of a grid, or in neighbouring
        ones, can touch.
        """
        raise NotImplementedError("Exercise B7.9: Pairs of spheres")

    def next_impact(self, duration: float) -> Impact | None:
        """Return the first impact of two spheres within ``duration`` s: its time and its contact.

        Particles move by p + v t + a t^2 / 2, where a is their last_acceleration, so two of the
        same acceleration see each other move along a line; immovable ones stay where they are. They
        impact when their spheres touch, or overlap, and close by more than VELOCITY_TOLERANCE: less
        is what an impact leaves. Those that do so already impact at 0. None where there is no
        impact. The contact is that of the places at its time, with a penetration of 0. Of several
        at the same time the first in the order of contacts is taken.

        Raises ValueError where the duration is negative or not finite, and where two particles have
        accelerations that differ by more than rounding, 1e-12 of their sizes: their paths are
        beyond this detector. An immovable one has none.
        """
        raise NotImplementedError("Exercise B7.11: When do two spheres meet?")


class Detectors:
    """Several detectors as one: for spheres that bounce on the ground and off each other."""

    def __init__(self, *detectors: Detector) -> None:
        self.detectors = detectors

    def contacts(self) -> list[Contact]:
        """Return the contacts of all, in the order of the detectors."""
        return [contact for detector in self.detectors for contact in detector.contacts()]

    def next_impact(self, duration: float) -> Impact | None:
        """Return the first impact of all; of several at the same time that of the first detector.

        Raises what one of them raises.
        """
        impacts = [detector.next_impact(duration) for detector in self.detectors]
        return min((impact for impact in impacts if impact), key=lambda i: i[0], default=None)


def time_to_close(gap: float, velocity: float, acceleration: float) -> float:
    """Return the first time in s at which a gap is closed, 0 or less, and closes on.

    It is gap + v t + a t^2 / 2 in m, with v in m/s and a in m/s^2. Where it is closed already, the
    time is that at which it closes on, or begins to: 0 where it does so now, and where it lies
    still and is accelerated inwards. Where it is not accelerated inwards, a velocity inwards of
    VELOCITY_TOLERANCE or less is no closing. math.inf where it never closes, or only just gets
    there, and turns round. The arguments are not checked.
    """
    raise NotImplementedError("Exercise B7.10: When does it reach the ground?")


def some_particles(particles: Sequence[Particle]) -> Sequence[Particle]:
    """Return a list or tuple of particles; TypeError for anything else."""
    if not isinstance(particles, (list, tuple)):
        raise TypeError(f"particles must be a list, got {particles!r}")
    for i, particle in enumerate(particles):
        instance_of(f"particles[{i}]", particle, Particle)
    return particles
