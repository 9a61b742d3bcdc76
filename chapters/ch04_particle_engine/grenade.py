"""The behavior of a grenade (mini-project 4.1): it bounces, and it bursts at the end of its fuse.

The bounce here is a rule for this one type of shot. Chapter 7 adds contacts for any particle.
"""

from __future__ import annotations

from ch03_laws_of_motion.particle import Particle

FUSE = 4.0  # s, from the throw to the burst
BOUNCE = 0.5  # the fraction of the downward speed that a bounce returns upward
SLIDE = 0.8  # the fraction of the speed along the ground that a bounce keeps
FRAGMENTS = 12
FRAGMENT_SPEED = 15.0  # m/s, relative to the grenade


def bounce(particle: Particle) -> None:
    """Mini-project 4.1: move a particle that is below the ground (y < 0) back to y = 0, in place.

    If the particle is moving down, change its velocity too: reverse the vertical velocity and
    multiply it by ``BOUNCE``, and multiply the components along X and Z by ``SLIDE``. A particle on
    or above the ground does not change.
    """
    raise NotImplementedError("Exercise 4.1: A grenade")


def fragments(particle: Particle) -> list[Particle]:
    """Mini-project 4.1: return the fragments into which a grenade bursts, at its position.

    There are ``FRAGMENTS`` fragments. Their masses are equal and add up to the mass of the grenade.
    They have the same acceleration and damping as the grenade. Relative to the grenade, each
    fragment flies at ``FRAGMENT_SPEED`` in a different direction. The directions add up to zero, so
    the total momentum of the fragments is the momentum of the grenade. The grenade does not change.
    """
    raise NotImplementedError("Exercise 4.1: A grenade")
