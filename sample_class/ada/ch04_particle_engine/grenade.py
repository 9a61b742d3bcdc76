"""The two things that only a grenade does: it bounces off the ground, and in the end it bursts."""

from __future__ import annotations

import math
from collections.abc import Iterator

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle

FUSE = 4.0  # s between throw and burst
BOUNCE = 0.5  # of the falling speed, what a bounce gives back upwards
SLIDE = 0.8  # of the speed along the ground, what a bounce leaves
FRAGMENTS = 12
FRAGMENT_SPEED = 15.0  # m/s, seen from the grenade

_GOLDEN_ANGLE = math.pi * (3 - math.sqrt(5))


def bounce(particle: Particle) -> None:
    x, height, z = particle.position
    if height >= 0:
        return
    particle.position = Vector3(x, 0.0, z)
    if particle.velocity.y < 0:
        particle.velocity.component_product_update(Vector3(SLIDE, -BOUNCE, SLIDE))


def fragments(particle: Particle) -> list[Particle]:
    return [
        Particle(
            particle.position,
            particle.velocity + direction * FRAGMENT_SPEED,
            particle.acceleration,
            mass=particle.mass / FRAGMENTS,
            damping=particle.damping,
        )
        for half in _half_of_the_directions()
        for direction in (half, -half)
    ]


def _half_of_the_directions() -> Iterator[Vector3]:
    """Yield unit vectors on a spiral from the top of a sphere down to its equator."""
    pairs = FRAGMENTS // 2
    for turn in range(pairs):
        height = 1 - (turn + 0.5) / pairs
        radius = math.sqrt(1 - height * height)
        bearing = turn * _GOLDEN_ANGLE
        yield Vector3(radius * math.cos(bearing), height, radius * math.sin(bearing)).normalized()
