"""What makes a grenade (mini-project 4.1): it bounces, and it bursts when its fuse has burnt.

A bounce here is a rule of this one shot. Chapter 7 makes contacts that any particle can have.
"""

from __future__ import annotations

from ch03_laws_of_motion.particle import Particle

FUSE = 4.0  # s, from the throw to the burst
BOUNCE = 0.5  # the share of the speed downwards that a bounce turns upwards
SLIDE = 0.8  # the share of the speed along the ground that a bounce keeps
FRAGMENTS = 12
FRAGMENT_SPEED = 15.0  # m/s, relative to the grenade


def bounce(particle: Particle) -> None:
    """Mini-project 4.1: put a particle that is below the ground, y < 0, back on it, in place.

    Its y becomes 0. Where it moves down, its velocity changes too: BOUNCE of that speed is turned
    upwards, and SLIDE of what is along X and Z is kept. One that is on or above the ground stays as
    it is.
    """
    raise NotImplementedError("Exercise 4.1: A grenade")


def fragments(particle: Particle) -> list[Particle]:
    """Mini-project 4.1: return the FRAGMENTS pieces into which a grenade bursts, at its place.

    They have equal masses, which add up to the grenade's, and its acceleration and damping.
    Relative to it each flies with FRAGMENT_SPEED in a direction of its own, and together they have
    the momentum that it had: the directions add up to zero. The grenade stays as it is.
    """
    raise NotImplementedError("Exercise 4.1: A grenade")
