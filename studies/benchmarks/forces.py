"""Measure how much longer the time step of a particle takes when forces act on it.

A particle of chapter 5, which accepts forces, is compared with one of chapter 3, which does not. It
is also compared with plain arithmetic.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry, Gravity
from ch05_forces.particle import Particle
from scenes.drag_flight import PROJECTILE, Numbers, make_particle
from scenes.timing import Measurement, Target, timer, versus
from studies.benchmarks.particles import FRAME, ROUNDS, STEPS, steps

FORCE = (1.0, 2.0, 3.0)
FRAMES = [FRAME] * STEPS


def lines() -> list[Measurement]:
    """Set up the benchmarks that show how much time it costs to apply forces to a particle.

    One of them compares gravity as a force generator with gravity as a constant acceleration.
    """
    chapter_3 = timer(lambda: steps(make_particle(PROJECTILE), FRAMES))
    free = timer(lambda: steps(make_particle_with_forces(), FRAMES))
    forced = timer(lambda: forced_steps(FRAMES))
    return [
        Measurement(
            "Particle.integrate of chapter 5 without forces / that of chapter 3",
            versus(free, chapter_3),
            ROUNDS,
            Target("at most", 1.1),
        ),
        Measurement(
            "add_force and Particle.integrate / the same arithmetic in local variables",
            versus(forced, timer(lambda: forced_arithmetic(FRAMES))),
            ROUNDS,
            Target("at most", 2.1),
        ),
        Measurement(
            "gravity as a force generator in the registry / as constant acceleration",
            versus(timer(lambda: generator_steps(FRAMES)), free),
            ROUNDS,
        ),
    ]


def make_particle_with_forces() -> Particle:
    """Create the projectile from the Particle class of chapter 5, which accepts forces."""
    start = PROJECTILE.start
    return Particle(
        Vector3(*start.position),
        Vector3(*start.velocity),
        Vector3(*PROJECTILE.acceleration),
        damping=PROJECTILE.damping,
    )


def forced_steps(frames: list[float]) -> Numbers:
    """Move a particle on which a constant force acts, and return its final position.

    ``frames`` lists the durations of the time steps in s.
    """
    particle = make_particle_with_forces()
    force = Vector3(*FORCE)
    for frame in frames:
        particle.add_force(force)
        particle.integrate(frame)
    return particle.position.x, particle.position.y, particle.position.z


def generator_steps(frames: list[float]) -> Numbers:
    """Move a particle with gravity as a force generator, and return its final position.

    ``frames`` lists the durations of the time steps in s.
    """
    particle = make_particle_with_forces()
    particle.acceleration = Vector3()
    registry = ForceRegistry()
    registry.add(particle, Gravity(Vector3(*PROJECTILE.acceleration)))
    for frame in frames:
        registry.update_forces(frame)
        particle.integrate(frame)
    return particle.position.x, particle.position.y, particle.position.z


def forced_arithmetic(frames: list[float]) -> Numbers:
    """Compute the same motion as ``forced_steps``, but with plain arithmetic in local variables.

    As in the engine, each step adds the force to a sum, uses the sum, and clears it. The extra time
    that ``forced_steps`` takes is therefore the cost of the engine's objects and calls. Return the
    final position.
    """
    x, y, z = PROJECTILE.start.position
    vx, vy, vz = PROJECTILE.start.velocity
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
