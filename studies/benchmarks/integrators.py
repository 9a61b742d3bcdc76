"""Measure how long a time step takes with four integrators of chapter 6.

In each benchmark, one particle moves on an anchored spring.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.integrators import (
    Integrator,
    leapfrog,
    runge_kutta_4,
    semi_implicit_euler,
    velocity_verlet,
)
from ch06_springs.springs import AnchoredSpring
from scenes.timing import Measurement, Target, timer, versus

STIFFNESS, REST_LENGTH, DAMPING, MASS = 100.0, 1.0, 0.2, 1.0  # N/m, m, N s/m, kg
STEP = 1.0 / 60.0  # s
STEPS = 2000
ROUNDS = 51


def lines() -> list[Measurement]:
    """Set up the benchmarks that measure how long one step of each integrator takes.

    Semi-implicit Euler is compared with plain arithmetic. All other integrators are compared with
    semi-implicit Euler.
    """
    once = timer(stepping(semi_implicit_euler))
    return [
        Measurement(
            "one particle on a spring: a semi-implicit Euler step / the same arithmetic",
            versus(once, timer(arithmetic)),
            ROUNDS,
            Target("at most", 6.6),  # nine tenths of the cost before kick and drift existed
        ),
        Measurement(
            "one particle on a spring: a leapfrog step / a semi-implicit Euler step",
            versus(timer(stepping(leapfrog)), once),
            ROUNDS,
            Target("at most", 1.1),
        ),
        Measurement(
            "one particle on a spring: a velocity Verlet step / a semi-implicit Euler step",
            versus(timer(stepping(velocity_verlet)), once),
            ROUNDS,
        ),
        Measurement(
            "one particle on a spring: a Runge-Kutta 4 step / a semi-implicit Euler step",
            versus(timer(stepping(runge_kutta_4)), once),
            ROUNDS,
            Target("at most", 4.0),
        ),
    ]


def stepping(integrator: Integrator) -> Callable[[], None]:
    """Return a function that moves a particle on a spring by STEPS time steps.

    Each call continues from the state in which the previous call ended.
    """
    particle = Particle(Vector3(1.0, 2.0, 3.0), Vector3(1.0, 2.0, 3.0), mass=MASS)
    registry = ForceRegistry()
    registry.add(particle, AnchoredSpring(Vector3(), STIFFNESS, REST_LENGTH, DAMPING))
    particles = [particle]

    def run() -> None:
        for _ in range(STEPS):
            integrator(particles, registry.update_forces, STEP)

    return run


def arithmetic() -> tuple[float, float, float]:
    """Simulate a particle on a spring with plain arithmetic, and return its final position.

    The calculation is the same as in STEPS steps of the semi-implicit Euler integrator. The extra
    time that the integrator takes is the cost of its objects.
    """
    x, y, z = 1.0, 2.0, 3.0
    u, v, w = 1.0, 2.0, 3.0
    for _ in range(STEPS):
        length = math.hypot(x, y, z)
        rate = (u * x + v * y + w * z) / length
        pull = (STIFFNESS * (REST_LENGTH - length) - DAMPING * rate) / length
        u += x * pull / MASS * STEP
        v += y * pull / MASS * STEP
        w += z * pull / MASS * STEP
        x += u * STEP
        y += v * STEP
        z += w * STEP
    return x, y, z
