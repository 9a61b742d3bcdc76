"""Springs: force generators that pull or push on a particle, depending on the spring's length.

A spring pulls if it is longer than its rest length, and pushes if it is shorter. If both ends are
at the same position, it has no direction, so its force is zero. Lengths are in m, stiffness in N/m
and damping in N s/m.

Constructors copy vectors. They raise ValueError for a number that is negative or not finite, and
TypeError for an argument of the wrong type. Attributes that you change later are not checked.
``update_force`` adds to the forces that the particle already has, and changes nothing else.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite_vector, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.other_forces import Buoyancy as Buoyancy
from ch06_springs.other_forces import HomingBullet as HomingBullet
from ch06_springs.other_forces import LighterThanAir as LighterThanAir
from ch06_springs.other_forces import Overcrowding as Overcrowding


def spring_force(
    offset: Vector3, velocity: Vector3, stiffness: float, rest_length: float, damping: float = 0.0
) -> Vector3:
    """Compute the force in N that a spring exerts on one of its ends, as a new vector.

    The force is -(k (l - l0) + c l') d^ (Eq. 6.1, 6.2), where k is ``stiffness``, l0 is
    ``rest_length`` and c is ``damping``. ``offset`` and ``velocity`` are those of this end relative
    to the other end. Here l is the length of ``offset``, d^ is its direction, and l' is the
    component of ``velocity`` along d^. A zero offset has no direction, so the force is then zero.
    The arguments are neither checked nor changed.
    """
    direction = offset.normalized()
    extension = offset.magnitude() - rest_length
    return direction * -(stiffness * extension + damping * velocity.dot(direction))


class Spring:
    """A spring that acts on one particle only: the one at its other end feels no force (6.2.1)."""

    def __init__(
        self, other: Particle, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.other = instance_of("other", other, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Compute the spring force on ``particle``, and add it to the particle's other forces."""
        offset = particle.position - self.other.position
        velocity = particle.velocity - self.other.velocity
        force = spring_force(offset, velocity, self.stiffness, self.rest_length, self.damping)
        particle.add_force(force)


class AnchoredSpring:
    """A spring between a particle and a fixed position, its anchor (6.2.2).

    You may move ``anchor``, for example to let a camera follow a player.
    """

    def __init__(
        self, anchor: Vector3, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the spring force to ``particle``, as if even a moving anchor were at rest."""
        offset, velocity = particle.position - self.anchor, particle.velocity
        force = spring_force(offset, velocity, self.stiffness, self.rest_length, self.damping)
        particle.add_force(force)


class Bungee(Spring):
    """An elastic rope to another particle: a spring that pulls but never pushes (6.2.3).

    The rope exerts no force, unless it is longer than its rest length. While a stretched rope gets
    shorter, damping reduces its pull, but the rope must never push.
    """

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the spring force if the rope is stretched, and no force if it is slack."""
        offset = particle.position - self.other.position
        velocity = particle.velocity - self.other.velocity
        _add_pull(particle, self, offset, velocity)


class AnchoredBungee(AnchoredSpring):
    """An elastic rope to an anchor: a spring that pulls but never pushes (6.2.3)."""

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the spring force if the rope is stretched, and no force if it is slack."""
        _add_pull(particle, self, particle.position - self.anchor, particle.velocity)


class Connection:
    """A spring that acts on both of its ends, ``a`` and ``b``. Create it with ``connect``."""

    def __init__(
        self, a: Particle, b: Particle, stiffness: float, rest_length: float, damping: float = 0.0
    ) -> None:
        self.a = instance_of("a", a, Particle)
        self.b = instance_of("b", b, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.rest_length = not_negative("rest_length", rest_length)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Compute the spring force on ``a``. Add it to ``a``, and add the exact opposite to ``b``.

        It does not matter which of the two is ``particle``. Because the forces are opposite, the
        total momentum of both particles stays constant.
        """
        offset = self.a.position - self.b.position
        velocity = self.a.velocity - self.b.velocity
        force = spring_force(offset, velocity, self.stiffness, self.rest_length, self.damping)
        self.a.add_force(force)
        self.b.add_force(-force)


def connect(
    registry: ForceRegistry,
    a: Particle,
    b: Particle,
    stiffness: float,
    rest_length: float,
    damping: float = 0.0,
) -> Connection:
    """Join the particles ``a`` and ``b`` by one spring that acts on both, and return the spring.

    The registry skips immovable particles, so the spring is registered for ``a``, or for ``b`` if
    ``a`` is immovable. A spring between two immovable ends has no effect. If ``Connection`` raises
    an error for one of the numbers, pass the error on and register nothing.
    """
    spring = Connection(a, b, stiffness, rest_length, damping)
    registry.add(a if a.inverse_mass else b, spring)
    return spring


class FakeStiffSpring:
    """A substitute for a spring that is too stiff for the time steps, with rest length 0 (6.3.2).

    The force is meant for semi-implicit Euler, p' = p + v' h: with it, the particle reaches the
    computed position if its damping is 1 and nothing else accelerates it. With short steps the
    force is therefore half that of a real spring, which moves the particle by a h^2 / 2.
    """

    def __init__(self, anchor: Vector3, stiffness: float, damping: float) -> None:
        self.anchor = finite_vector("anchor", anchor)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force that moves the particle to where a real spring would take it in this step.

        On each axis the force is m ((T - x) / h^2 - v / h). Here h is ``duration``, and x and v are
        the position and the velocity. T is the position to which a real spring would take the
        particle, from ``damped_spring_state``. Measure positions from the anchor. Add no force to
        an immovable particle.
        """
        h = positive("duration", duration)
        if not particle.has_finite_mass:
            return
        x, v, m = particle.position - self.anchor, particle.velocity, particle.mass
        states = [
            damped_spring_state(x0, v0, self.stiffness, self.damping, m, h)
            for x0, v0 in zip(x, v, strict=True)
        ]
        target = Vector3(*(position for position, _ in states))
        particle.add_force(((target - x) / h - v) * (m / h))


class ElasticLimitSpring:
    """Exercise 6.1: a spring that gets weaker when it is stretched beyond its elastic limit.

    Up to a length of ``limit`` it behaves like a Spring. Beyond this length, each additional meter
    increases the pull by only ``share`` times the stiffness. It has no damping.
    """

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
        """Exercise 6.1: add the spring force. It must be continuous at the elastic limit."""
        offset = particle.position - self.other.position
        length = offset.magnitude()
        extension = min(length, self.limit) - self.rest_length
        beyond = max(length - self.limit, 0.0)
        pull = self.stiffness * (extension + self.share * beyond)
        particle.add_force(offset.normalized() * -pull)


def max_stable_stiffness(damping: float, duration: float, mass: float = 1.0) -> float:
    """Exercise 6.6b: compute the stiffness in N/m above which a spring makes a simulation explode.

    With ``Particle.integrate`` and an undamped AnchoredSpring, the limit is m (d^-h - 1) / h^2,
    where h is ``duration``, d is ``damping`` and m is ``mass``. If d is 1 or more, no spring is
    stable, so the result is 0. If d is 0 or d^-h is too large for a float, it is ``math.inf``.
    """
    not_negative("damping", damping)
    positive("duration", duration)
    positive("mass", mass)
    if damping == 0.0:
        return math.inf
    try:
        growth = math.expm1(-duration * math.log(damping))  # d^-h - 1, accurate for d near 1
    except OverflowError:
        return math.inf
    return max(0.0, mass * growth / duration / duration)


def _add_pull(
    particle: Particle, rope: Bungee | AnchoredBungee, offset: Vector3, velocity: Vector3
) -> None:
    """Add the force of an elastic rope: the force of a spring, but only if it pulls."""
    if offset.magnitude() > rope.rest_length:
        force = spring_force(offset, velocity, rope.stiffness, rope.rest_length, rope.damping)
        if force.dot(offset) < 0.0:
            particle.add_force(force)
