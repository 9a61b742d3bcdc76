"""A grenade (mini-project 4.1), which bounces, and bursts when its fuse runs out."""

from __future__ import annotations

from ch03_laws_of_motion.particle import Particle

FUSE = 4.0  # s, from the throw to the burst
BOUNCE = 0.5  # the fraction of the downward speed that a bounce returns upward
SLIDE = 0.8  # the fraction of the speed along the ground that a bounce keeps
FRAGMENTS = 12
FRAGMENT_SPEED = 15.0  # m/s, relative to the grenade


def bounce(particle: Particle) -> None:
    """Let a particle that has sunk below the ground (y < 0) bounce off it, in place.

    Move the particle back to y = 0. If it is also moving down, reverse its vertical velocity and
    multiply it by ``BOUNCE``, and multiply the components along X and Z by ``SLIDE``. A particle on
    or above the ground does not change.
    """
    raise NotImplementedError("Exercise 4.1: A grenade")


def fragments(particle: Particle) -> list[Particle]:
    """Burst a grenade into fragments, and return one new particle for each of them.

    There are ``FRAGMENTS`` pieces, each with an equal part of the grenade's mass. They start at its
    position, with the same acceleration and damping. Relative to the grenade, each piece flies at
    ``FRAGMENT_SPEED`` in a different direction. These directions add up to zero, so that a burst
    conserves momentum. The particle of the grenade does not change.
    """
    raise NotImplementedError("Exercise 4.1: A grenade")
