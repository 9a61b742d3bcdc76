"""Detectors: contact generators that find what touches, and when something will.

Pairs are found by halving space, and spheres meet by the distance at which they would miss.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import combinations
from typing import Protocol

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import (
    VELOCITY_TOLERANCE,
    Contact,
    a_particle,
    a_restitution,
    direction_of,
)

Impact = tuple[float, Contact]

_FEW = 12  # so many are compared at once: to part them takes longer
_SAME = 1e-9  # accelerations that differ by less than this share are one: f / m rounds
_SLACK = 1.0 + 1e-9  # for rounding, in what only looks for candidates


class Detector(Protocol):
    """Whatever has both methods is a detector: no class needs to derive from this one."""

    def contacts(self) -> Iterable[Contact]:
        """Return the contacts of now."""

    def next_impact(self, duration: float) -> Impact | None:
        """Return when the first impact of the next ``duration`` s is, and its contact, or None."""


class GroundPlane:
    """Exercise 7.5: level ground at a height, for points, and for spheres of a radius."""

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
        return [self._contact(particle, 0.0 - gap) for particle, gap in self._gaps() if gap <= 0.0]

    def next_impact(self, duration: float) -> Impact | None:
        not_negative("duration", duration)
        times = [
            (time_to_close(gap, particle.velocity.y, particle.last_acceleration.y), i, particle)
            for i, (particle, gap) in enumerate(self._gaps())
        ]
        time, _, particle = min(times, default=(math.inf, 0, None), key=lambda entry: entry[:2])
        if particle is None or time > duration:
            return None
        return time, self._contact(particle, 0.0)

    def _gaps(self) -> list[tuple[Particle, float]]:
        """Return how far each particle that can be moved is above where it touches."""
        level = self.height + self.radius
        return [(one, one.position.y - level) for one in self.particles if one.inverse_mass]

    def _contact(self, particle: Particle, depth: float) -> Contact:
        return Contact(particle, None, Vector3(0.0, 1.0), self.restitution, depth)


class ParticlePairs:
    """Finds pairs of particles that touch: spheres that all have one ``radius``, above 0."""

    def __init__(
        self, particles: Sequence[Particle], radius: float, restitution: float = 0.0
    ) -> None:
        self.particles = some_particles(particles)
        self.radius = positive("radius", radius)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        found = []
        for i, j in self._near_pairs():
            a, b = self.particles[i], self.particles[j]
            offset = a.position - b.position
            depth = 2.0 * self.radius - offset.magnitude()
            if depth >= 0.0 and (a.inverse_mass or b.inverse_mass):
                found.append(Contact(a, b, direction_of(offset), self.restitution, depth))
        return found

    def next_impact(self, duration: float) -> Impact | None:
        not_negative("duration", duration)
        self._refuse_different_accelerations()
        best: tuple[float, Particle, Particle] | None = None
        limit = duration
        for a, b in combinations(self.particles, 2):
            if not (a.inverse_mass or b.inverse_mass):
                continue
            time = self._time_to_touch(a, b)
            if time < limit or (best is None and time == limit):
                best, limit = (time, a, b), time
        if best is None:
            return None
        time, a, b = best
        offset = a.position - b.position
        offset.add_scaled(_velocity(a) - _velocity(b), time)
        return time, Contact(a, b, direction_of(offset), self.restitution)

    def _refuse_different_accelerations(self) -> None:
        moving = [one for one in self.particles if one.inverse_mass]
        if not moving:
            return
        first = moving[0].last_acceleration
        for i, one in enumerate(self.particles):
            here = one.last_acceleration if one.inverse_mass else Vector3()
            if (here - first).magnitude() > _SAME * max(here.magnitude(), first.magnitude()):
                raise ValueError(
                    "particles must have the same acceleration, or their paths bend as seen from "
                    f"each other: particles[{i}] has {here!r}, another one {first!r}"
                )

    def _near_pairs(self) -> list[tuple[int, int]]:
        """Return pairs of places in the list, lower first: all that touch, and hardly any others.

        Two that touch are on one side of any plane, or no farther than a radius beyond it: so what
        is spread out is halved again and again, with those near the plane in both halves.
        """
        reach = self.radius * _SLACK
        places = [(*one.position,) for one in self.particles]
        found: set[tuple[int, int]] = set()
        groups = [[*range(len(places))]]
        while groups:
            group = groups.pop()
            if len(group) > _FEW:
                along = [[places[i][axis] for i in group] for axis in range(3)]
                axis = max(range(3), key=lambda axis: max(along[axis]) - min(along[axis]))
                low, high = min(along[axis]), max(along[axis])
                middle = low / 2.0 + high / 2.0
                below = [i for i in group if places[i][axis] - middle <= reach]
                above = [i for i in group if middle - places[i][axis] <= reach]
                # Below six radii the halves would be hardly smaller than the whole.
                if high - low > 6.0 * reach and max(len(below), len(above)) < len(group):
                    groups += [below, above]
                    continue
            found.update(
                (i, j)
                for i, j in combinations(group, 2)
                if math.dist(places[i], places[j]) <= 2.0 * reach
            )
        return sorted(found)

    def _time_to_touch(self, a: Particle, b: Particle) -> float:
        """Return when two spheres, of the same acceleration, impact, and math.inf for never.

        Seen from b, a moves along a line. Where it is nearest is ``ahead`` of it, and ``miss`` from
        b; the spheres touch ``half`` before that.
        """
        offset = a.position - b.position
        seen = _velocity(a) - _velocity(b)
        speed, distance, touch = seen.magnitude(), offset.magnitude(), 2.0 * self.radius
        way = seen.normalized()
        ahead = -(offset @ way)
        if ahead <= 0.0 or speed * (ahead / distance) < VELOCITY_TOLERANCE:
            return math.inf
        if distance <= touch:
            return 0.0
        miss = offset.cross(way).magnitude()
        if miss >= touch:
            return math.inf
        half = math.sqrt(touch - miss) * math.sqrt(touch + miss)
        # ahead - half, without the loss of digits where they have nearly met.
        return (distance - touch) * ((distance + touch) / (ahead + half)) / speed


class Detectors:
    """Several detectors as one: for spheres that bounce on the ground and off each other."""

    def __init__(self, *detectors: Detector) -> None:
        self.detectors = detectors

    def contacts(self) -> list[Contact]:
        return [contact for detector in self.detectors for contact in detector.contacts()]

    def next_impact(self, duration: float) -> Impact | None:
        impacts = [detector.next_impact(duration) for detector in self.detectors]
        return min((impact for impact in impacts if impact), key=lambda i: i[0], default=None)


def time_to_close(gap: float, velocity: float, acceleration: float) -> float:
    if acceleration == 0.0 and velocity > -VELOCITY_TOLERANCE:
        return math.inf
    if velocity > 0.0 or (velocity == 0.0 and acceleration > 0.0):
        if acceleration > 0.0:
            return math.inf
        # It comes back: through 0, or it turns round below. Both are so long after the turn.
        s = math.sqrt(2.0) * math.sqrt(-acceleration) * math.sqrt(abs(gap))
        arrival = math.hypot(velocity, s) if gap >= 0.0 else _leg(velocity, s)
        return velocity / -acceleration + arrival / -acceleration
    if gap <= 0.0:
        return 0.0
    s = math.sqrt(2.0) * math.sqrt(abs(acceleration)) * math.sqrt(gap)
    if acceleration <= 0.0:
        arrival = math.hypot(velocity, s)
    elif -velocity > s:
        arrival = _leg(velocity, s)
    else:  # it turns round before it gets there, or just there, and does not close on
        return math.inf
    return 2.0 * (gap / (arrival - velocity))


def some_particles(particles: Sequence[Particle]) -> Sequence[Particle]:
    if not isinstance(particles, (list, tuple)):
        raise TypeError(f"particles must be a list, got {particles!r}")
    for i, particle in enumerate(particles):
        a_particle(f"particles[{i}]", particle)
    return particles


def _leg(whole: float, other: float) -> float:
    """Return the root of whole^2 - other^2, and 0 where there is none."""
    whole = abs(whole)
    return math.sqrt(whole - other) * math.sqrt(whole + other) if whole > other else 0.0


def _velocity(particle: Particle) -> Vector3:
    return particle.velocity if particle.inverse_mass else Vector3()
