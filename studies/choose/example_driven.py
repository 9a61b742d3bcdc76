"""A scene file for `make choose` in which the wind comes in gusts, so that a force needs the time.

The clock is a particle. It moves at 1 m/s along X, so the coordinate x of its position is the time
in s. Every method moves the clock together with all other particles. Whenever a method evaluates
the forces, the clock therefore shows the right time, even in the middle of a step.
"""

import math

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring
from ch08_mass_aggregate.world import ParticleWorld

DURATION = 4.0  # s


class Gusts:
    """A force of 10 N cos(8 t) along X, where t is the time in s that a clock shows."""

    def __init__(self, clock: Particle) -> None:
        self.clock = clock

    def update_force(self, particle: Particle, duration: float) -> None:  # noqa: ARG002
        time = self.clock.position.x
        particle.add_force(Vector3(10.0 * math.cos(8.0 * time)))


def build() -> ParticleWorld:
    """Create a clock, and a sign of 1 kg on a spring, which is at rest until the wind begins."""
    clock = Particle(velocity=Vector3(1.0))
    sign = Particle()
    world = ParticleWorld([clock, sign])
    world.registry.add(sign, AnchoredSpring(Vector3(), 100.0, 0.0))
    world.registry.add(sign, Gusts(clock))
    return world


def measure(world: ParticleWorld) -> Vector3:
    """Return the position of the sign, because the position of the clock needs no check."""
    return world.particles[1].position
