"""Springs."""

import math

from ch02_vectors.arguments import finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.other_forces import Buoyancy, HomingBullet, LighterThanAir, Overcrowding


def spring_force(offset, velocity, stiffness, rest_length, damping=0.0):
    d = offset.normalized()
    magnitude = abs(offset.magnitude() - rest_length) * stiffness
    return d * -(magnitude + damping * velocity.dot(d))


class Spring:
    def __init__(self, other, stiffness, rest_length, damping=0.0):
        self.other = _particle("other", other)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle, duration):
        d = particle.position - self.other.position
        v = particle.velocity - self.other.velocity
        particle.add_force(spring_force(d, v, self.stiffness, self.rest_length, self.damping))


class AnchoredSpring:
    def __init__(self, anchor, stiffness, rest_length, damping=0.0):
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle, duration):
        d = particle.position - self.anchor
        v = particle.velocity
        particle.add_force(spring_force(d, v, self.stiffness, self.rest_length, self.damping))


class Bungee(Spring):
    def update_force(self, particle, duration):
        d = particle.position - self.other.position
        if d.magnitude() <= self.rest_length:
            return
        v = particle.velocity - self.other.velocity
        force = spring_force(d, v, self.stiffness, self.rest_length, self.damping)
        if force.dot(d) < 0:
            particle.add_force(force)


class AnchoredBungee(AnchoredSpring):
    def update_force(self, particle, duration):
        d = particle.position - self.anchor
        if d.magnitude() <= self.rest_length:
            return
        v = particle.velocity
        force = spring_force(d, v, self.stiffness, self.rest_length, self.damping)
        if force.dot(d) < 0:
            particle.add_force(force)


class Connection:
    def __init__(self, a, b, stiffness, rest_length, damping=0.0):
        self.a = _particle("a", a)
        self.b = _particle("b", b)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle, duration):
        d = self.a.position - self.b.position
        v = self.a.velocity - self.b.velocity
        force = spring_force(d, v, self.stiffness, self.rest_length, self.damping)
        self.a.add_force(force)
        self.b.add_force(-force)


def connect(registry, a, b, stiffness, rest_length, damping=0.0):
    spring = Connection(a, b, stiffness, rest_length, damping)
    registry.add(a, spring)
    registry.add(b, spring)
    return spring


class FakeStiffSpring:
    def __init__(self, anchor, stiffness, damping):
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle, duration):
        if not particle.has_finite_mass:
            return
        position = particle.position - self.anchor
        target = Vector3()
        for axis in ("x", "y", "z"):
            x, v = getattr(position, axis), getattr(particle.velocity, axis)
            state = damped_spring_state(x, v, self.stiffness, self.damping, particle.mass, duration)
            setattr(target, axis, state[0])
        accel = (target - position) * (1 / duration**2) - particle.velocity
        particle.add_force(accel * particle.mass)


class ElasticLimitSpring:
    def __init__(self, other, stiffness, rest_length, limit, share):
        self.other = _particle("other", other)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.limit = not_negative("limit", limit)
        if self.limit < self.rest_length:
            raise ValueError(f"limit must be rest_length, {rest_length!r}, or more, got {limit!r}")
        self.share = not_negative("share", share)

    def update_force(self, particle, duration):
        d = particle.position - self.other.position
        length = d.magnitude()
        k = self.stiffness
        if length > self.limit:
            k = k * self.share
        particle.add_force(d.normalized() * -(k * (length - self.rest_length)))


def max_stable_stiffness(damping, duration, mass=1.0):
    d = not_negative("damping", damping)
    h = positive("duration", duration)
    m = positive("mass", mass)
    if d == 0:
        return math.inf
    if d >= 1:
        return 0.0
    return -m * math.log(d) / h


def _particle(name, value):
    if not (hasattr(value, "position") and hasattr(value, "add_force")):
        raise TypeError(f"{name} must be a Particle, got {value!r}")
    return value
