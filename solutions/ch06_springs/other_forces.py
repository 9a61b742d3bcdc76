"""Forces that depend on where a particle is: water, a balloon, a crowd and a homing bullet.

Units and the checks of arguments are as in springs.py, which passes these classes on: import them
from either module.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, instance_of, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class Buoyancy:
    """The lift of water, whose surface is level, on a body that floats or sinks in it (6.2.4).

    ``max_depth`` in m is how deep the middle of the body is when all of it is just under water, and
    how high when all of it is just out; ``volume`` is in m^3, ``liquid_density`` in kg/m^3 (fresh
    water has 1000, the sea 1020 to 1030) and ``gravity`` in m/s^2. The lift is in N: the book's
    text has some of its examples a thousand times too large (E-21).

    Raises ValueError where ``max_depth``, ``volume`` or ``liquid_density`` is not positive,
    ``gravity`` is negative, or one of them is not finite.
    """

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
        """Add the weight of the water that is pushed aside, upwards.

        It is rho V g times the share of the body that is under water: (y_w + s - y) / (2 s), but
        never less than 0 nor more than 1. Here s is ``max_depth``, y_w the height of the water and
        y that of the particle. The book's formula has another sign, and its listing loses brackets
        and g (E-5).
        """
        depth = self.water_height + self.max_depth - particle.position.y
        share = min(max(depth / (2.0 * self.max_depth), 0.0), 1.0)
        lift = share * self.liquid_density * self.volume * self.gravity
        particle.add_force(Vector3(0.0, lift, 0.0))


class LighterThanAir:
    """Exercise 6.2: the lift of a balloon, which falls off with the height: F e^(-y / H).

    F is ``max_lift`` in N, at the ground, where y is 0; H is ``scale_height`` in m, in which the
    lift falls to 1 / e. Below the ground it is as at the ground: finite everywhere.

    Raises ValueError where ``max_lift`` is negative, ``scale_height`` is not positive, or one of
    them is not finite.
    """

    def __init__(self, max_lift: float, scale_height: float) -> None:
        self.max_lift = not_negative("max_lift", max_lift)
        self.scale_height = positive("scale_height", scale_height)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 6.2: add the lift at the particle's height, upwards."""
        height = max(particle.position.y, 0.0)
        lift = self.max_lift * math.exp(-height / self.scale_height)
        particle.add_force(Vector3(0.0, lift, 0.0))


class Overcrowding:
    """Exercise 6.3: particles that are too near push apart, as a compressed spring does.

    ``particles`` is the crowd, a list that is kept and may be changed; the particle that is asked
    for may be one of them. ``distance`` in m is how near they may be without a push.
    """

    def __init__(self, particles: list[Particle], distance: float, stiffness: float) -> None:
        if not isinstance(particles, list):
            raise TypeError(f"particles must be a list, got {particles!r}")
        for i, one in enumerate(particles):
            instance_of(f"particles[{i}]", one, Particle)
        self.particles = particles
        self.distance = not_negative("distance", distance)
        self.stiffness = not_negative("stiffness", stiffness)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 6.3: add k (distance - l) away from each of the others with l < distance.

        Others at the very same place have no direction, and do not push.
        """
        for other in self.particles:
            away = particle.position - other.position
            too_near = self.distance - away.magnitude()
            if too_near > 0.0:
                particle.add_force(away.normalized() * (self.stiffness * too_near))


class HomingBullet:
    """Exercise 6.4: a force towards where both will be after ``look_ahead`` s, if neither turns.

    It is a spring of rest length 0 from where the bullet will be to where the target will be.
    """

    def __init__(self, target: Particle, stiffness: float, look_ahead: float) -> None:
        self.target = instance_of("target", target, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.look_ahead = not_negative("look_ahead", look_ahead)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 6.4: add k times the way between the two places; it leaves the target alone."""
        way = self.target.position - particle.position
        way.add_scaled(self.target.velocity - particle.velocity, self.look_ahead)
        particle.add_force(way * self.stiffness)
