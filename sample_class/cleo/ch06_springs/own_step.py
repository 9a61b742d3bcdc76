"""My step: half the way, a push, the other half, eight times a frame."""

from collections.abc import Sequence

from ch05_forces.particle import Particle
from ch06_springs.integrators import ApplyForces

PARTS = 8


def my_step(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
    h = duration / PARTS
    for _ in range(PARTS):
        for p in particles:
            p.position = p.position + p.velocity * (h / 2)
        apply_forces(h)
        for p in particles:
            p.velocity = p.velocity + (p.acceleration + p.force_accumulator * p.inverse_mass) * h
            p.clear_forces()
            p.position = p.position + p.velocity * (h / 2)
