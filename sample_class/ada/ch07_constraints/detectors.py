"""Ada's detectors."""

import math
from collections.abc import Iterable
from itertools import combinations, product
from typing import Protocol

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch07_constraints.contacts import (
    VELOCITY_TOLERANCE,
    Contact,
    a_particle,
    a_restitution,
    direction_of,
)

Impact = tuple[float, Contact]

AROUND = list(product((-1, 0, 1), repeat=3))


class Detector(Protocol):
    def contacts(self) -> Iterable[Contact]: ...

    def next_impact(self, duration: float) -> Impact | None: ...


def soonest(times, duration):
    """The first of the earliest (time, ...), if it comes in time."""
    first = min(times, key=lambda entry: entry[0], default=None)
    return first if first and first[0] <= duration else None


class GroundPlane:
    def __init__(self, particles, height=0.0, radius=0.0, restitution=0.0):
        self.particles = some_particles(particles)
        self.height = finite("height", height)
        self.radius = not_negative("radius", radius)
        self.restitution = a_restitution("restitution", restitution)

    def movable(self):
        return (p for p in self.particles if p.has_finite_mass)

    def depth(self, particle):
        return self.height - (particle.position.y - self.radius)

    def touch(self, particle, depth):
        return Contact(particle, None, Vector3(0, 1, 0), self.restitution, depth)

    def contacts(self):
        depths = ((p, self.depth(p)) for p in self.movable())
        return [self.touch(p, depth) for p, depth in depths if depth >= 0]

    def next_impact(self, duration):
        not_negative("duration", duration)
        first = soonest(
            (
                (time_to_close(-self.depth(p), p.velocity.y, p.last_acceleration.y), p)
                for p in self.movable()
            ),
            duration,
        )
        return first and (first[0], self.touch(first[1], 0))


class ParticlePairs:
    def __init__(self, particles, radius, restitution=0.0):
        self.particles = some_particles(particles)
        self.radius = positive("radius", radius)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self):
        found = []
        for i, j in sorted(self._near_pairs()):
            a, b = self.particles[i], self.particles[j]
            between = a.position - b.position
            depth = self.radius * 2 - between.magnitude()
            if depth >= 0 and (a.has_finite_mass or b.has_finite_mass):
                found.append(Contact(a, b, direction_of(between), self.restitution, depth))
        return found

    def _near_pairs(self):
        # everyone looks around for those that are there already, and then sits down
        size = self.radius * 2.1
        seats = {}
        for j, particle in enumerate(self.particles):
            x, y, z = (math.floor(c / size) for c in particle.position)
            for dx, dy, dz in AROUND:
                for i in seats.get((x + dx, y + dy, z + dz), ()):
                    yield i, j
            seats.setdefault((x, y, z), []).append(j)

    def next_impact(self, duration):
        not_negative("duration", duration)
        flights = [(p, *flight(p)) for p in self.particles]
        first = soonest(
            ((self._time_to_touch(*pair), *pair) for pair in combinations(flights, 2)), duration
        )
        if first is None:
            return None
        time, (a, v, _), (b, w, _) = first
        between = (a.position + v * time) - (b.position + w * time)
        return time, Contact(a, b, direction_of(between), self.restitution)

    def _time_to_touch(self, one, two):
        (a, v, f), (b, w, g) = one, two
        if (f - g).magnitude() > 1e-12 * (f.magnitude() + g.magnitude()):
            raise ValueError(f"these two are not accelerated alike: {f!r} and {g!r}")
        between, seen, touch = a.position - b.position, v - w, 2 * self.radius
        dd, du, uu = between @ between, between @ seen, seen @ seen
        if -du <= VELOCITY_TOLERANCE * math.sqrt(dd):
            return math.inf
        # dd + 2 du t + uu t^2 = touch^2, and of both times the first
        gap = dd - touch**2
        if gap <= 0:
            return 0.0
        root = du**2 - uu * gap
        return gap / (math.sqrt(root) - du) if root > 0 else math.inf


def flight(particle):
    if particle.has_finite_mass:
        return particle.velocity, particle.last_acceleration
    return Vector3(), Vector3()


class Detectors:
    def __init__(self, *detectors):
        self.detectors = detectors

    def contacts(self):
        return [contact for detector in self.detectors for contact in detector.contacts()]

    def next_impact(self, duration):
        impacts = [detector.next_impact(duration) for detector in self.detectors]
        return soonest((impact for impact in impacts if impact), duration)


def time_to_close(gap, velocity, acceleration):
    v, a = velocity, acceleration
    if a >= 0 and v >= -VELOCITY_TOLERANCE:
        return math.inf  # nothing brings it there
    if v > 0:
        # up to the top, and down from there; under the ground it is due at the top
        top = gap + v * v / -a / 2
        return v / -a + math.sqrt(max(2 * top / -a, 0))
    if gap <= 0:
        return 0.0
    arrival = v * v - 2 * a * gap  # the square of its speed there
    if arrival <= 0:
        return math.inf
    return gap / ((math.sqrt(arrival) - v) / 2)  # by the mean speed


def some_particles(particles):
    if not isinstance(particles, (list, tuple)):
        raise TypeError(f"particles are no list: {particles!r}")
    for i, particle in enumerate(particles):
        a_particle(f"particles[{i}]", particle)
    return particles
