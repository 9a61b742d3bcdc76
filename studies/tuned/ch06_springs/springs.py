"""The springs of chapter 6 in plain numbers.

A spring computes its force without vectors, and adds it to the sum of a particle without a call. A
connection does so at both of its ends.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite_vector, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import NO_FORCE, Particle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.other_forces import Buoyancy as Buoyancy
from ch06_springs.other_forces import HomingBullet as HomingBullet
from ch06_springs.other_forces import LighterThanAir as LighterThanAir
from ch06_springs.other_forces import Overcrowding as Overcrowding


def spring_force(
    offset: Vector3, velocity: Vector3, stiffness: float, rest_length: float, damping: float = 0.0
) -> Vector3:
    direction = offset.normalized()
    extension = offset.magnitude() - rest_length
    return direction * -(stiffness * extension + damping * velocity.dot(direction))


class Spring:
    def __init__(
        self, other: Particle, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.other = instance_of("other", other, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        p, q = particle.position, self.other.position
        x = p.x - q.x
        y = p.y - q.y
        z = p.z - q.z
        if length := math.hypot(x, y, z):
            v, w = particle.velocity, self.other.velocity
            rate = ((v.x - w.x) * x + (v.y - w.y) * y + (v.z - w.z) * z) / length
            push = (self.stiffness * (self.rest_length - length) - self.damping * rate) / length
            forces = particle._forces
            if force := forces[0]:
                sum_x, sum_y, sum_z = force
                x = sum_x + x * push
                y = sum_y + y * push
                z = sum_z + z * push
            else:
                x *= push
                y *= push
                z *= push
            if 0.0 * (x + y + z) != 0.0:  # infinity * 0 is NaN
                finite_vector("the force", Vector3(x, y, z))
            forces[0] = (x, y, z)


class AnchoredSpring:
    def __init__(
        self, anchor: Vector3, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        p, q = particle.position, self.anchor
        x = p.x - q.x
        y = p.y - q.y
        z = p.z - q.z
        if length := math.hypot(x, y, z):
            v = particle.velocity
            rate = (v.x * x + v.y * y + v.z * z) / length
            push = (self.stiffness * (self.rest_length - length) - self.damping * rate) / length
            forces = particle._forces
            if force := forces[0]:
                sum_x, sum_y, sum_z = force
                x = sum_x + x * push
                y = sum_y + y * push
                z = sum_z + z * push
            else:
                x *= push
                y *= push
                z *= push
            if 0.0 * (x + y + z) != 0.0:  # infinity * 0 is NaN
                finite_vector("the force", Vector3(x, y, z))
            forces[0] = (x, y, z)


class Bungee(Spring):
    def update_force(self, particle: Particle, duration: float) -> None:
        offset = particle.position - self.other.position
        _add_pull(self, particle, offset, particle.velocity - self.other.velocity)


class AnchoredBungee(AnchoredSpring):
    def update_force(self, particle: Particle, duration: float) -> None:
        _add_pull(self, particle, particle.position - self.anchor, particle.velocity)


class Connection:
    def __init__(
        self, a: Particle, b: Particle, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.a = instance_of("a", a, Particle)
        self.b = instance_of("b", b, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        a, b = self.a, self.b
        p, q = a.position, b.position
        x = p.x - q.x
        y = p.y - q.y
        z = p.z - q.z
        if length := math.hypot(x, y, z):
            v, w = a.velocity, b.velocity
            rate = ((v.x - w.x) * x + (v.y - w.y) * y + (v.z - w.z) * z) / length
            push = (self.stiffness * (self.rest_length - length) - self.damping * rate) / length
            x *= push
            y *= push
            z *= push
            mine = a._forces
            others = b._forces
            ax, ay, az = mine[0] or NO_FORCE
            bx, by, bz = others[0] or NO_FORCE
            ax += x
            ay += y
            az += z
            bx -= x
            by -= y
            bz -= z
            if 0.0 * (ax + ay + az + bx + by + bz) != 0.0:  # infinity * 0 is NaN
                finite_vector("a force", Vector3(ax, ay, az))
                finite_vector("a force", Vector3(bx, by, bz))
            mine[0] = (ax, ay, az)
            others[0] = (bx, by, bz)


def connect(
    registry: ForceRegistry,
    a: Particle,
    b: Particle,
    stiffness: float,
    rest_length: float,
    damping: float = 0.0,
) -> Connection:
    spring = Connection(a, b, stiffness, rest_length, damping)
    registry.add(a if a.inverse_mass else b, spring)
    return spring


class FakeStiffSpring:
    def __init__(self, anchor: Vector3, stiffness: float, damping: float) -> None:
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        positive("duration", duration)
        if not particle.has_finite_mass:
            return
        place, v, mass = particle.position - self.anchor, particle.velocity, particle.mass

        def force(x0: float, v0: float) -> float:
            x, _ = damped_spring_state(x0, v0, self.stiffness, self.damping, mass, duration)
            return mass * ((x - x0) / duration - v0) / duration

        particle.add_force(Vector3(force(place.x, v.x), force(place.y, v.y), force(place.z, v.z)))


class ElasticLimitSpring:
    def __init__(
        self, other: Particle, stiffness: float, rest_length: float, limit: float, share: float
    ) -> None:
        self.other = instance_of("other", other, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.limit = not_negative("limit", limit)
        if self.limit < self.rest_length:
            raise ValueError(f"limit must be at least rest_length ({rest_length!r}), got {limit!r}")
        self.share = not_negative("share", share)

    def update_force(self, particle: Particle, duration: float) -> None:
        offset = particle.position - self.other.position
        length = offset.magnitude()
        extension = min(length, self.limit) - self.rest_length
        beyond = max(length - self.limit, 0.0)
        pull = self.stiffness * (extension + self.share * beyond)
        particle.add_force(offset.normalized() * -pull)


def max_stable_stiffness(damping: float, duration: float, mass: float = 1.0) -> float:
    not_negative("damping", damping)
    positive("duration", duration)
    positive("mass", mass)
    if damping == 0.0:
        return math.inf
    try:
        grown = math.expm1(-duration * math.log(damping))  # d^-h - 1, accurate for d near 1
    except OverflowError:
        return math.inf
    return max(0.0, mass * grown / duration / duration)


def _add_pull(
    rope: Bungee | AnchoredBungee, particle: Particle, offset: Vector3, velocity: Vector3
) -> None:
    """Add the force of an elastic rope: the force of a spring, but only if it pulls."""
    if offset.magnitude() > rope.rest_length:
        force = spring_force(offset, velocity, rope.stiffness, rope.rest_length, rope.damping)
        if force.dot(offset) < 0.0:
            particle.add_force(force)
