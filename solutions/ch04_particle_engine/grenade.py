"""A grenade (mini-project 4.1), which bounces, and bursts when its fuse runs out."""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle

FUSE = 4.0  # s, from the throw to the burst
BOUNCE = 0.5  # the fraction of the downward speed that a bounce returns upward
SLIDE = 0.8  # the fraction of the speed along the ground that a bounce keeps
FRAGMENTS = 12
FRAGMENT_SPEED = 15.0  # m/s, relative to the grenade

# The 12 corners of an icosahedron, from the golden ratio: in opposite pairs, and evenly spread.
_CORNERS = [
    corner
    for one in (-1.0, 1.0)
    for long in (-1.618033988749895, 1.618033988749895)
    for corner in ((0.0, one, long), (one, long, 0.0), (long, 0.0, one))
]


def bounce(particle: Particle) -> None:
    """Let a particle that has sunk below the ground (y < 0) bounce off it, in place.

    Move the particle back to y = 0. If it is also moving down, reverse its vertical velocity and
    multiply it by ``BOUNCE``, and multiply the components along X and Z by ``SLIDE``. A particle on
    or above the ground does not change.
    """
    if particle.position.y >= 0.0:
        return
    particle.position.y = 0.0
    if particle.velocity.y < 0.0:
        particle.velocity.component_product_update(Vector3(SLIDE, -BOUNCE, SLIDE))


def fragments(particle: Particle) -> list[Particle]:
    """Burst a grenade into fragments, and return one new particle for each of them.

    There are ``FRAGMENTS`` pieces, each with an equal part of the grenade's mass. They start at its
    position, with the same acceleration and damping. Relative to the grenade, each piece flies at
    ``FRAGMENT_SPEED`` in a different direction. These directions add up to zero, so that a burst
    conserves momentum. The particle of the grenade does not change.
    """
    return [
        Particle(
            particle.position,
            particle.velocity + Vector3(*corner).normalized() * FRAGMENT_SPEED,
            particle.acceleration,
            mass=particle.mass / FRAGMENTS,
            damping=particle.damping,
        )
        for corner in _CORNERS
    ]
