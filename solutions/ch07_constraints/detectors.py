"""Detectors: contact generators that find what touches, and when something will.

``contacts()`` returns what touches now, in the order of the particles, the same every time. That
includes what only just touches, with a penetration of 0, so that rest is found a frame earlier.
``next_impact(duration)`` looks ahead for ``time_division_step``.

Lengths are in m, times in s. What a detector is made with is looked at: ValueError names what is
negative or not finite, and a restitution that is not from 0 to 1; TypeError what is no number, and
particles that are no list or tuple of them. A list is kept, and may be changed.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
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

Impact = tuple[float, Contact]

_SAME = 1e-12  # how far apart two accelerations are that only rounding has parted, of their sizes

# The neighbours of a cell of a grid that come after it: with all 26 each pair would be found twice.
_AFTER = [cell for cell in product((-1, 0, 1), repeat=3) if cell > (0, 0, 0)]


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
        found = []
        for particle in self.particles:
            depth = self.height + self.radius - particle.position.y
            if depth >= 0.0 and particle.inverse_mass:
                found.append(
                    Contact(particle, None, Vector3(0.0, 1.0, 0.0), self.restitution, depth)
                )
        return found

    def next_impact(self, duration: float) -> Impact | None:
        """Return the first impact on the ground within ``duration`` s: its time and its contact.

        A particle moves by p + v t + a t^2 / 2, where a is its last_acceleration, and impacts when
        it is on the ground, or below, and closes on: see time_to_close. One that lies there, and is
        pulled downwards, impacts at 0, time and again. None where there is no impact. The contact's
        penetration is 0. Immovable particles have none, and of two at the same time the first in
        the list is taken.

        Raises ValueError where the duration is negative or not finite.
        """
        not_negative("duration", duration)
        first: Impact | None = None
        for particle in self.particles:
            gap = particle.position.y - self.height - self.radius
            time = time_to_close(gap, particle.velocity.y, particle.last_acceleration.y)
            if particle.inverse_mass and time <= duration and (first is None or time < first[0]):
                normal = Vector3(0.0, 1.0, 0.0)
                first = time, Contact(particle, None, normal, self.restitution)
        return first


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
        found = []
        for i, j in sorted(self._near_pairs()):
            a, b = self.particles[i], self.particles[j]
            offset = a.position - b.position
            depth = 2.0 * self.radius - offset.magnitude()
            if depth >= 0.0 and a.inverse_mass + b.inverse_mass:
                normal = direction_of(offset)
                found.append(Contact(a, b, normal, self.restitution, depth))
        return found

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
        not_negative("duration", duration)
        first: Impact | None = None
        for a, b in combinations(self.particles, 2):
            time = self._time_to_touch(a, b)
            if time <= duration and (first is None or time < first[0]):
                offset = a.position - b.position
                offset.add_scaled(_flight(a)[0] - _flight(b)[0], time)
                first = time, Contact(a, b, offset.normalized(), self.restitution)
        return first

    def _near_pairs(self) -> list[tuple[int, int]]:
        """Return pairs of places in the list, lower first: all that touch, and some others."""
        size = 2.001 * self.radius  # rounding must not put two cells between what just touches
        cells: dict[tuple[int, int, int], list[int]] = {}
        for i, particle in enumerate(self.particles):
            x, y, z = particle.position
            cell = (math.floor(x / size), math.floor(y / size), math.floor(z / size))
            cells.setdefault(cell, []).append(i)
        pairs: list[tuple[int, int]] = []
        for (x, y, z), here in cells.items():
            pairs += combinations(here, 2)
            for right, up, front in _AFTER:
                for j in cells.get((x + right, y + up, z + front), ()):
                    pairs += [(min(i, j), max(i, j)) for i in here]
        return pairs

    def _time_to_touch(self, a: Particle, b: Particle) -> float:
        """Return when two spheres, of the same acceleration, impact, and math.inf for never."""
        (v, pull), (w, other) = _flight(a), _flight(b)
        if (pull - other).magnitude() > _SAME * (pull.magnitude() + other.magnitude()):
            seen = f"{pull!r} and {other!r}"
            raise ValueError(f"the particles of a pair must have the same acceleration, got {seen}")
        offset, velocity = a.position - b.position, v - w
        closing = -offset.dot(velocity)  # the closing speed times the distance
        if closing <= VELOCITY_TOLERANCE * offset.magnitude():
            return math.inf
        gap = offset.squared_magnitude() - (2.0 * self.radius) ** 2
        if gap <= 0.0:
            return 0.0
        root = closing * closing - velocity.squared_magnitude() * gap
        return gap / (closing + math.sqrt(root)) if root > 0.0 else math.inf


def _flight(particle: Particle) -> tuple[Vector3, Vector3]:
    """Return the velocity and acceleration by which a particle flies on: none if immovable."""
    if not particle.inverse_mass:
        return Vector3(), Vector3()
    return particle.velocity, particle.last_acceleration


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
    if acceleration >= 0.0 and velocity >= -VELOCITY_TOLERANCE:
        return math.inf
    if gap <= 0.0 and velocity <= 0.0:
        return 0.0
    root = velocity * velocity - 2.0 * acceleration * gap
    if velocity > 0.0:  # up first; where it begins in the ground, and stays there, until it is over
        return (velocity + math.sqrt(max(root, 0.0))) / -acceleration
    return 2.0 * gap / (math.sqrt(root) - velocity) if root > 0.0 else math.inf


def some_particles(particles: Sequence[Particle]) -> Sequence[Particle]:
    """Return a list or tuple of particles; TypeError for anything else."""
    if not isinstance(particles, (list, tuple)):
        raise TypeError(f"particles must be a list, got {particles!r}")
    for i, particle in enumerate(particles):
        instance_of(f"particles[{i}]", particle, Particle)
    return particles
