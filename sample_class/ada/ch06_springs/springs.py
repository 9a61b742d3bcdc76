"""Springs and their kin: force generators that push and pull by how far away something is."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import NamedTuple

from ch02_vectors.arguments import finite_vector, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.other_forces import Buoyancy as Buoyancy
from ch06_springs.other_forces import HomingBullet as HomingBullet
from ch06_springs.other_forces import LighterThanAir as LighterThanAir
from ch06_springs.other_forces import Overcrowding as Overcrowding


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
    line = _line(offset, velocity)
    return line.direction * -line.tension(stiffness, rest_length, damping)


class Spring:
    """A spring from the particle it acts on to another one, which it leaves alone."""

    def __init__(
        self, other: Particle, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.other = instance_of("other", other, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
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
        _act(self, _line(particle.position - self.anchor, particle.velocity), particle)


class Bungee(Spring):
    """An elastic rope to another particle: a spring that only pulls."""

    def update_force(self, particle: Particle, duration: float) -> None:
        _act_as_rope(self, _line_between(self.other, particle), particle)


class AnchoredBungee(AnchoredSpring):
    """An elastic rope to an anchor, which only pulls."""

    def update_force(self, particle: Particle, duration: float) -> None:
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
        self.a = instance_of("a", a, Particle)
        self.b = instance_of("b", b, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
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
    connection = Connection(a, b, stiffness, rest_length, damping)
    keeper = next((end for end in (a, b) if end.has_finite_mass), b)
    registry.add(keeper, connection)
    return connection


class FakeStiffSpring:
    """A spring too stiff for the steps, by the force that brings its end where it would be."""

    def __init__(self, anchor: Vector3, stiffness: float, damping: float) -> None:
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
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
        self.other = instance_of("other", other, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.limit = not_negative("limit", limit)
        if self.limit < self.rest_length:
            raise ValueError(f"limit must be rest_length, {rest_length!r}, or more, got {limit!r}")
        self.share = not_negative("share", share)

    def update_force(self, particle: Particle, duration: float) -> None:
        line = _line_between(self.other, particle)
        tension = line.tension(self.stiffness, self.rest_length, 0.0)
        if line.length > self.limit:  # two springs in a row of tensions: up to the limit, beyond it
            tension = self.stiffness * (self.limit - self.rest_length)
            tension += line.tension(self.share * self.stiffness, self.limit, 0.0)
        particle.add_force(line.direction * -tension)


def max_stable_stiffness(damping: float, duration: float, mass: float = 1.0) -> float:
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
