"""Detectors."""

import math
from collections.abc import Iterable
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


class Detector(Protocol):
    def contacts(self) -> Iterable[Contact]:
        """Return the contacts of now."""

    def next_impact(self, duration: float) -> Impact | None:
        """Return the first impact, or None."""


class GroundPlane:
    def __init__(self, particles, height=0.0, radius=0.0, restitution=0.0):
        self.particles = some_particles(particles)
        self.height = finite("height", height)
        self.radius = not_negative("radius", radius)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self):
        result = []
        for particle in self.particles:
            if not particle.has_finite_mass:
                continue
            depth = self.height + self.radius - particle.position.y
            if depth > 0:
                up = Vector3(0, 1, 0)
                result.append(Contact(particle, None, up, self.restitution, depth))
        return result

    def next_impact(self, duration):
        not_negative("duration", duration)
        best = None
        for particle in self.particles:
            if not particle.has_finite_mass:
                continue
            gap = particle.position.y - self.radius - self.height
            t = time_to_close(gap, particle.velocity.y, particle.last_acceleration.y)
            if t <= duration and (best is None or t < best[0]):
                best = (t, Contact(particle, None, Vector3(0, 1, 0), self.restitution))
        return best


class ParticlePairs:
    def __init__(self, particles, radius, restitution=0.0):
        self.particles = some_particles(particles)
        self.radius = positive("radius", radius)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self):
        result = []
        for i, j in self._near_pairs():
            a, b = self.particles[i], self.particles[j]
            if not a.has_finite_mass and not b.has_finite_mass:
                continue
            d = a.position - b.position
            depth = 2 * self.radius - d.magnitude()
            if depth >= 0:
                result.append(Contact(a, b, direction_of(d), self.restitution, depth))
        return result

    def next_impact(self, duration):
        not_negative("duration", duration)
        best = None
        for i, a in enumerate(self.particles):
            for b in self.particles[i + 1 :]:
                t = self._time_to_touch(a, b)
                if t <= duration and (best is None or t < best[0]):
                    d = a.position - b.position
                    d += (_flight(a)[0] - _flight(b)[0]) * t
                    best = (t, Contact(a, b, direction_of(d), self.restitution))
        return best

    def _near_pairs(self):
        size = 2.5 * self.radius
        grid = {}
        cells = []
        for i, particle in enumerate(self.particles):
            p = particle.position
            cell = (math.floor(p.x / size), math.floor(p.y / size), math.floor(p.z / size))
            cells.append(cell)
            grid.setdefault(cell, []).append(i)
        pairs = []
        for i, (x, y, z) in enumerate(cells):
            near = []
            for dx in (-1, 0, 1):
                for dy in (-1, 0, 1):
                    for dz in (-1, 0, 1):
                        near += grid.get((x + dx, y + dy, z + dz), [])
            pairs += [(i, j) for j in sorted(near) if j > i]
        return pairs

    def _time_to_touch(self, a, b):
        va, aa = _flight(a)
        vb, ab = _flight(b)
        if (aa - ab).magnitude() > 1e-12 * (aa.magnitude() + ab.magnitude()):
            raise ValueError(f"accelerations must be the same, got {aa!r} and {ab!r}")
        d = a.position - b.position
        u = va - vb
        closing = -d.dot(u)
        if closing <= VELOCITY_TOLERANCE * d.magnitude():
            return math.inf
        gap = d.squared_magnitude() - 4 * self.radius**2
        if gap <= 0:
            return 0.0
        inside = closing**2 - u.squared_magnitude() * gap
        if inside <= 0:
            return math.inf
        return gap / (closing + math.sqrt(inside))


def _flight(particle):
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
        return min((impact for impact in impacts if impact), key=lambda i: i[0], default=None)


def time_to_close(gap, velocity, acceleration):
    if gap <= 0:
        return 0.0
    if acceleration == 0:
        return -gap / velocity if velocity < 0 else math.inf
    inside = velocity**2 - 2 * acceleration * gap
    if inside <= 0:
        return math.inf
    # the midnight formula
    times = [
        (-velocity - math.sqrt(inside)) / acceleration,
        (-velocity + math.sqrt(inside)) / acceleration,
    ]
    return min((t for t in times if t >= 0), default=math.inf)


def some_particles(particles):
    if not isinstance(particles, (list, tuple)):
        raise TypeError(f"particles must be a list, got {particles!r}")
    for i, particle in enumerate(particles):
        a_particle(f"particles[{i}]", particle)
    return particles
