"""Compare a particle of chapter 5, on which forces act, with one of chapter 3 and arithmetic."""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import particle as chapter_3
from ch05_forces.forces import Gravity
from ch05_forces.particle import Particle
from scenes.clock import FRAME
from scenes.flight import PROJECTILE
from scenes.readings import Numbers
from scenes.setup import alone
from scenes.timing import Measurement, Target, timer, versus
from studies.benchmarks.particles import ROUNDS, STEPS, steps

FORCE = (1.0, 2.0, 3.0)
FRAMES = [FRAME] * STEPS


def lines() -> list[Measurement]:
    """Set up the benchmarks that show how much time it costs to apply forces to a particle."""
    free = timer(lambda: steps(PROJECTILE.particle(Particle), FRAMES))
    return [
        Measurement(
            "Particle.integrate of chapter 5 without forces / that of chapter 3",
            versus(free, timer(lambda: steps(PROJECTILE.particle(chapter_3.Particle), FRAMES))),
            ROUNDS,
            Target("at most", 1.1),
        ),
        Measurement(
            "add_force and Particle.integrate / the same arithmetic in local variables",
            versus(timer(lambda: forced_steps(FRAMES)), timer(lambda: forced_arithmetic(FRAMES))),
            ROUNDS,
            Target("at most", 2.1),
        ),
        Measurement(
            "gravity as a force generator in the registry / as constant acceleration",
            versus(timer(lambda: generator_steps(FRAMES)), free),
            ROUNDS,
        ),
    ]


def forced_steps(frames: list[float]) -> Numbers:
    """Move a particle on which a constant force acts, and return its final position."""
    particle = PROJECTILE.particle(Particle)
    force = Vector3(*FORCE)
    for frame in frames:
        particle.add_force(force)
        particle.integrate(frame)
    return particle.position.x, particle.position.y, particle.position.z


def generator_steps(frames: list[float]) -> Numbers:
    """Move a particle with gravity as a force generator, and return its final position."""
    particle = PROJECTILE.particle(Particle)
    particle.acceleration = Vector3()
    registry = alone(particle, Gravity(Vector3(*PROJECTILE.acceleration))).registry()
    for frame in frames:
        registry.update_forces(frame)
        particle.integrate(frame)
    return particle.position.x, particle.position.y, particle.position.z


def forced_arithmetic(frames: list[float]) -> Numbers:
    """Do the arithmetic of ``forced_steps`` without objects, and return the final position.

    As in the engine, each step adds the force to a sum, uses the sum, and clears it.
    """
    x, y, z = PROJECTILE.position
    vx, vy, vz = PROJECTILE.velocity
    ax, ay, az = PROJECTILE.acceleration
    damping = PROJECTILE.damping
    inverse_mass = 1.0
    force_x, force_y, force_z = FORCE
    sum_x = sum_y = sum_z = 0.0
    for frame in frames:
        sum_x += force_x
        sum_y += force_y
        sum_z += force_z
        x += vx * frame
        y += vy * frame
        z += vz * frame
        keep = damping**frame
        vx = (vx + (ax + sum_x * inverse_mass) * frame) * keep
        vy = (vy + (ay + sum_y * inverse_mass) * frame) * keep
        vz = (vz + (az + sum_z * inverse_mass) * frame) * keep
        sum_x = sum_y = sum_z = 0.0
    return x, y, z
