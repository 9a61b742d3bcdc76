"""Ada's grenade: six pairs of fragments, each pair flying apart."""

import math

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle

FUSE = 4.0
BOUNCE = 0.5
SLIDE = 0.8
FRAGMENTS = 12
FRAGMENT_SPEED = 15.0


def bounce(particle):
    if particle.position.y < 0:
        particle.position.y = 0.0
        v = particle.velocity
        if v.y < 0:
            particle.velocity = Vector3(v.x * SLIDE, -v.y * BOUNCE, v.z * SLIDE)


def fragments(particle):
    pieces = []
    for i in range(FRAGMENTS // 2):
        angle = math.pi * i / (FRAGMENTS // 2)
        along = Vector3(math.cos(angle), math.sin(angle), 0.5).normalized()
        for way in (FRAGMENT_SPEED, -FRAGMENT_SPEED):
            pieces.append(
                Particle(
                    particle.position,
                    particle.velocity + along * way,
                    particle.acceleration,
                    mass=particle.mass / FRAGMENTS,
                    damping=particle.damping,
                )
            )
    return pieces
