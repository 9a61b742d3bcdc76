"""The integrators of chapter 6 by name, as all scenes, plots and studies list them."""

from __future__ import annotations

from collections.abc import Callable

from ch06_springs.integrators import (
    Integrator,
    backward_euler,
    explicit_euler,
    leapfrog,
    runge_kutta_4,
    semi_implicit_euler,
    trapezoidal,
    velocity_verlet,
)

# From x, v, stiffness, damping, mass and duration to x and v after a step.
Solver = Callable[[float, float, float, float, float, float], tuple[float, float]]

INTEGRATORS: dict[str, Integrator] = {
    "explicit Euler": explicit_euler,
    "semi-implicit Euler": semi_implicit_euler,
    "leapfrog": leapfrog,
    "velocity Verlet": velocity_verlet,
    "Runge-Kutta 4": runge_kutta_4,
}
SOLVERS: dict[str, Solver] = {"backward Euler": backward_euler, "trapezoidal rule": trapezoidal}
