"""Springs and their kin: force generators that push and pull by how far away something is."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import NamedTuple

from ch02_vectors.arguments import finite, finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.closed_form import damped_spring_state


class _Line(NamedTuple):
    """The line from the far end of a spring to the near one, of length 0 where they coincide."""

    direction: Vector3
    length: float
    growth: float  # m/s

    def tension(self, stiffness: float, rest_length: float, damping: float) -> float:
        """Return in N how hard the ends are pulled together; below 0 they are pushed apart."""
        if not self.length:
            return 0.0
        return stiffness * (self.length - rest_length) + damping * self.growth


def _line(offset: Vector3, velocity: Vector3) -> _Line:
    direction = offset.normalized()
    return _Line(direction, offset.magnitude(), direction @ velocity)


def _line_between(far: Particle, near: Particle) -> _Line:
    return _line(near.position - far.position, near.velocity - far.velocity)


def spring_force(
    offset: Vector3, velocity: Vector3, stiffness: float, rest_length: float, damping: float = 0.0
) -> Vector3:
    """Return the force in N of a spring on the end that has this offset from the other one."""
    line = _line(offset, velocity)
    return line.direction * -line.tension(stiffness, rest_length, damping)


class Spring:
    """A spring from the particle it acts on to another one, which it leaves alone."""

    def __init__(
        self, other: Particle, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.other = _particle("other", other)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the spring_force on the particle, seen from the other one."""
        _act(self, _line_between(self.other, particle), particle)


class AnchoredSpring:
    """A spring from a particle to an anchor."""

    def __init__(
        self, anchor: Vector3, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the spring_force on the particle, seen from the anchor."""
        _act(self, _line(particle.position - self.anchor, particle.velocity), particle)


class Bungee(Spring):
    """An elastic rope to another particle: a spring that only pulls."""

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force of the spring where that pulls, and nothing where the rope is slack."""
        _act_as_rope(self, _line_between(self.other, particle), particle)


class AnchoredBungee(AnchoredSpring):
    """An elastic rope to an anchor, which only pulls."""

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force of the spring where that pulls, as a Bungee does."""
        _act_as_rope(self, _line(particle.position - self.anchor, particle.velocity), particle)


def _act(spring: Spring | AnchoredSpring, line: _Line, particle: Particle) -> None:
    tension = line.tension(spring.stiffness, spring.rest_length, spring.damping)
    particle.add_force(line.direction * -tension)


def _act_as_rope(rope: Bungee | AnchoredBungee, line: _Line, particle: Particle) -> None:
    tension = line.tension(rope.stiffness, rope.rest_length, rope.damping)
    if line.length > rope.rest_length and tension > 0.0:
        particle.add_force(line.direction * -tension)


class Connection:
    """A spring between two particles, a and b, that serves both ends at once."""

    def __init__(
        self, a: Particle, b: Particle, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.a = _particle("a", a)
        self.b = _particle("b", b)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the spring_force on a to a, and exactly its opposite to b."""
        line = _line_between(self.b, self.a)
        tension = line.tension(self.stiffness, self.rest_length, self.damping)
        self.a.add_force(line.direction * -tension)
        self.b.add_force(line.direction * tension)


def connect(
    registry: ForceRegistry,
    a: Particle,
    b: Particle,
    stiffness: float,
    rest_length: float,
    damping: float = 0.0,
) -> Connection:
    """Join two particles by one spring that acts on both, and return it."""
    connection = Connection(a, b, stiffness, rest_length, damping)
    keeper = next((end for end in (a, b) if end.has_finite_mass), b)
    registry.add(keeper, connection)
    return connection


class Buoyancy:
    """The lift of water, whose surface is level, on a body that floats or sinks in it."""

    def __init__(
        self,
        max_depth: float,
        volume: float,
        water_height: float,
        liquid_density: float = 1000.0,
        gravity: float = 9.81,
    ) -> None:
        self.max_depth = positive("max_depth", max_depth)
        self.volume = positive("volume", volume)
        self.water_height = finite("water_height", water_height)
        self.liquid_density = positive("liquid_density", liquid_density)
        self.gravity = not_negative("gravity", gravity)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the weight of the water that is pushed aside, upwards."""
        depth = self.water_height - particle.position.y  # of the middle of the body
        if depth <= -self.max_depth:
            return
        share = 1.0 if depth >= self.max_depth else 0.5 * (1.0 + depth / self.max_depth)
        water = self.liquid_density * (share * self.volume)  # kg
        particle.add_force(Vector3(0.0, water * self.gravity, 0.0))


class FakeStiffSpring:
    """A spring too stiff for the steps, by the force that brings its end where it would be."""

    def __init__(self, anchor: Vector3, stiffness: float, damping: float) -> None:
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add m ((T - x) / h^2 - v / h) on each axis, T being where the spring has it after h.

        A spring is linear: T is a share of the place, and a time's worth of the velocity.
        """
        h = positive("duration", duration)
        if not particle.has_finite_mass:
            return
        mass = particle.mass
        share, _ = damped_spring_state(1.0, 0.0, self.stiffness, self.damping, mass, h)
        worth, _ = damped_spring_state(0.0, 1.0, self.stiffness, self.damping, mass, h)
        x, v = particle.position - self.anchor, particle.velocity
        way = x * share + v * worth - x
        particle.add_force((way / h - v) / h * mass)


class ElasticLimitSpring:
    """Exercise 6.1: a spring that is weaker once it is stretched beyond its limit."""

    def __init__(
        self, other: Particle, stiffness: float, rest_length: float, limit: float, share: float
    ) -> None:
        self.other = _particle("other", other)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.limit = not_negative("limit", limit)
        if self.limit < self.rest_length:
            raise ValueError(f"limit must be rest_length, {rest_length!r}, or more, got {limit!r}")
        self.share = not_negative("share", share)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 6.1: add the force; at the limit itself there is no jump in it."""
        line = _line_between(self.other, particle)
        tension = line.tension(self.stiffness, self.rest_length, 0.0)
        if line.length > self.limit:  # two springs in a row of tensions: up to the limit, beyond it
            tension = self.stiffness * (self.limit - self.rest_length)
            tension += line.tension(self.share * self.stiffness, self.limit, 0.0)
        particle.add_force(line.direction * -tension)


class LighterThanAir:
    """Exercise 6.2: the lift of a balloon, which falls off with the height: F e^(-y / H)."""

    def __init__(self, max_lift: float, scale_height: float) -> None:
        self.max_lift = not_negative("max_lift", max_lift)
        self.scale_height = positive("scale_height", scale_height)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 6.2: add the lift at the particle's height, upwards."""
        share = min(1.0, math.exp(min(0.0, -particle.position.y / self.scale_height)))
        particle.add_force(Vector3(0.0, self.max_lift * share, 0.0))


class Overcrowding:
    """Exercise 6.3: particles that are too near push apart, as a compressed spring does."""

    def __init__(self, particles: list[Particle], distance: float, stiffness: float) -> None:
        for i, one in enumerate(particles):
            _particle(f"particles[{i}]", one)
        self.particles = particles
        self.distance = not_negative("distance", distance)
        self.stiffness = not_negative("stiffness", stiffness)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 6.3: add k (distance - l) away from each of the others with l < distance."""
        lines = (_line_between(other, particle) for other in self.particles)
        for line in lines:
            if 0.0 < line.length < self.distance:
                push = self.stiffness * (self.distance - line.length)
                particle.add_force(line.direction * push)


class HomingBullet:
    """Exercise 6.4: a force towards where both will be after ``look_ahead`` s."""

    def __init__(self, target: Particle, stiffness: float, look_ahead: float) -> None:
        self.target = _particle("target", target)
        self.stiffness = not_negative("stiffness", stiffness)
        self.look_ahead = not_negative("look_ahead", look_ahead)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 6.4: add k times the way between the two places; it leaves the target alone."""
        way = self.target.position - particle.position
        way.add_scaled(self.target.velocity - particle.velocity, self.look_ahead)
        particle.add_force(way * self.stiffness)


def max_stable_stiffness(damping: float, duration: float, mass: float = 1.0) -> float:
    """Exercise 6.6b: return the stiffness in N/m above which a spring explodes."""
    d = not_negative("damping", damping)
    h, m = positive("duration", duration), positive("mass", mass)
    if d >= 1.0:
        return 0.0
    if d == 0.0:
        return math.inf
    exponent = -h * math.log(d)
    try:
        if exponent > 700.0:  # d^-h alone may be too large where the stiffness is not
            return math.exp(exponent + math.log(m) - 2.0 * math.log(h))
        return float(Fraction(m) * Fraction(math.expm1(exponent)) / Fraction(h) ** 2)
    except OverflowError:
        return math.inf


def _particle(name: str, value: Particle) -> Particle:
    """Return what has a place and takes forces; TypeError names what does not."""
    if not (hasattr(value, "position") and hasattr(value, "add_force")):
        raise TypeError(f"{name} must be a Particle, got {value!r}")
    return value
