"""A body that slides with friction; the autograder runs it beside the student."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch08_mass_aggregate import friction
from ch08_mass_aggregate.probes import Components, xyz


def slid(
    normal: Components,
    gravity: Components,
    velocity: Components,
    mass: float,
    mu: float,
    steps: int,
    duration: float,
) -> list[tuple[Components, Components]]:
    """Let a particle slide on a plane through the origin; return position and velocity by step."""
    up = Vector3(*normal)
    particle = Particle(velocity=Vector3(*velocity), acceleration=Vector3(*gravity), mass=mass)
    seen = []
    for _ in range(steps):
        semi_implicit_euler([particle], lambda _: None, duration)
        depth = -math.fsum(p * n for p, n in zip(xyz(particle.position), normal, strict=True))
        if depth >= 0.0:
            contact = friction.FrictionContact(particle, None, up, 0.0, depth, mu)
            contact.resolve(duration)
        seen.append((xyz(particle.position), xyz(particle.velocity)))
    return seen
