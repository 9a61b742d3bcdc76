"""Ada's springs."""

import math

from ch02_vectors.arguments import finite, finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch06_springs.closed_form import damped_spring_state


def spring_force(offset, velocity, stiffness, rest_length, damping=0.0):
    along = offset.normalized()
    extension = offset.magnitude() - rest_length  # negative when compressed, no abs
    return along * -(stiffness * extension + damping * (velocity @ along))


def need_particle(name, value):
    if not hasattr(value, "position") or not hasattr(value, "add_force"):
        raise TypeError(f"{name} is no particle: {value!r}")
    return value


class Spring:
    def __init__(self, other, stiffness, rest_length, damping=0.0):
        self.other = need_particle("other", other)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def offset(self, particle):
        return particle.position - self.other.position

    def force(self, particle):
        v = particle.velocity - self.other.velocity
        return spring_force(
            self.offset(particle), v, self.stiffness, self.rest_length, self.damping
        )

    def update_force(self, particle, duration):
        particle.add_force(self.force(particle))


class AnchoredSpring:
    def __init__(self, anchor, stiffness, rest_length, damping=0.0):
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def offset(self, particle):
        return particle.position - self.anchor

    def force(self, particle):
        v = particle.velocity
        return spring_force(
            self.offset(particle), v, self.stiffness, self.rest_length, self.damping
        )

    def update_force(self, particle, duration):
        particle.add_force(self.force(particle))


def pull(rope, particle):
    # slack ropes do nothing, and damping must not make a rope push
    offset = rope.offset(particle)
    if offset.magnitude() <= rope.rest_length:
        return
    force = rope.force(particle)
    if force @ offset < 0:
        particle.add_force(force)


class Bungee(Spring):
    def update_force(self, particle, duration):
        pull(self, particle)


class AnchoredBungee(AnchoredSpring):
    def update_force(self, particle, duration):
        pull(self, particle)


class Connection:
    def __init__(self, a, b, stiffness, rest_length, damping=0.0):
        self.a = need_particle("a", a)
        self.b = need_particle("b", b)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle, duration):
        a, b = self.a, self.b
        force = spring_force(
            a.position - b.position,
            a.velocity - b.velocity,
            self.stiffness,
            self.rest_length,
            self.damping,
        )
        a.add_force(force)
        b.add_force(-force)


def connect(registry, a, b, stiffness, rest_length, damping=0.0):
    spring = Connection(a, b, stiffness, rest_length, damping)
    # only once, under an end that the registry asks for
    registry.add(a if a.has_finite_mass else b, spring)
    return spring


class Buoyancy:
    def __init__(self, max_depth, volume, water_height, liquid_density=1000.0, gravity=9.81):
        self.max_depth = positive("max_depth", max_depth)
        self.volume = positive("volume", volume)
        self.water_height = finite("water_height", water_height)
        self.liquid_density = positive("liquid_density", liquid_density)
        self.gravity = not_negative("gravity", gravity)

    def update_force(self, particle, duration):
        s = self.max_depth
        share = (self.water_height + s - particle.position.y) / (2 * s)
        share = min(max(share, 0), 1)
        lift = self.liquid_density * self.volume * self.gravity * share
        particle.add_force(Vector3(0, lift, 0))


class FakeStiffSpring:
    """Only for semi-implicit Euler. Lands where the formula says, one frame later."""

    def __init__(self, anchor, stiffness, damping):
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle, duration):
        h = positive("duration", duration)
        if not particle.has_finite_mass:
            return
        m = particle.mass

        def on_one_axis(x, v):
            goal, _ = damped_spring_state(x, v, self.stiffness, self.damping, m, h)
            return ((goal - x) / h - v) / h * m

        offset = particle.position - self.anchor
        particle.add_force(Vector3(*map(on_one_axis, offset, particle.velocity)))


class ElasticLimitSpring:
    def __init__(self, other, stiffness, rest_length, limit, share):
        self.other = need_particle("other", other)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.limit = not_negative("limit", limit)
        if self.limit < self.rest_length:
            raise ValueError(f"the limit {limit} is below the rest length {rest_length}")
        self.share = not_negative("share", share)

    def update_force(self, particle, duration):
        offset = particle.position - self.other.position
        length = offset.magnitude()
        extension = min(length, self.limit) - self.rest_length
        extension += self.share * max(length - self.limit, 0)
        particle.add_force(offset.normalized() * (-self.stiffness * extension))


class LighterThanAir:
    def __init__(self, max_lift, scale_height):
        self.max_lift = not_negative("max_lift", max_lift)
        self.scale_height = positive("scale_height", scale_height)

    def update_force(self, particle, duration):
        height = max(particle.position.y, 0)
        lift = self.max_lift * math.exp(-height / self.scale_height)
        particle.add_force(Vector3(0, lift, 0))


class Overcrowding:
    def __init__(self, particles, distance, stiffness):
        for i, one in enumerate(particles):
            need_particle(f"particles[{i}]", one)
        self.particles = particles
        self.distance = not_negative("distance", distance)
        self.stiffness = not_negative("stiffness", stiffness)

    def update_force(self, particle, duration):
        for other in self.particles:
            away = particle.position - other.position
            too_near = self.distance - away.magnitude()
            if too_near > 0:
                # zero for the particle itself
                particle.add_force(away.normalized() * (self.stiffness * too_near))


class HomingBullet:
    def __init__(self, target, stiffness, look_ahead):
        self.target = need_particle("target", target)
        self.stiffness = not_negative("stiffness", stiffness)
        self.look_ahead = not_negative("look_ahead", look_ahead)

    def update_force(self, particle, duration):
        there = self.target.position + self.target.velocity * self.look_ahead
        here = particle.position + particle.velocity * self.look_ahead
        particle.add_force((there - here) * self.stiffness)


def max_stable_stiffness(damping, duration, mass=1.0):
    d = not_negative("damping", damping)
    h = positive("duration", duration)
    m = positive("mass", mass)
    if d >= 1:
        return 0.0
    if d == 0:
        return math.inf
    try:
        return m * math.expm1(-h * math.log(d)) / h / h
    except OverflowError:
        return math.inf
