"""Limits of a damped spring's stiffness, and a cloth. Studies and chapter 6 have the others."""

from __future__ import annotations

import contextlib
import random
from typing import Any

import numpy
import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.going_further.cloth import make_cloth
from ch06_springs.integrators import (
    Integrator,
    SimulationDiverged,
    explicit_euler,
    leapfrog,
    semi_implicit_euler,
    watched,
)

FRAME = 1.0 / 60.0


def step_matrix(step: Integrator, k: float, d: float, m: float, c: float) -> Any:
    """Return the matrix of a step of (x, h v), which two states determine for a linear spring."""
    columns = []
    for x, v in ((1.0, 0.0), (0.0, 1.0 / FRAME)):
        p = Particle(Vector3(x), Vector3(v), mass=m, damping=d)
        step([p], lambda _, p=p: p.add_force(Vector3(-k * p.position.x - c * p.velocity.x)), FRAME)
        columns.append([p.position.x, p.velocity.x * FRAME])
    return numpy.array(columns).T


def radius(matrix: Any) -> float:
    return float(max(abs(numpy.linalg.eigvals(matrix))))


@pytest.mark.parametrize(
    ("step", "damping", "rate", "holds"),
    [
        (semi_implicit_euler, 0.0, 88, True),
        (semi_implicit_euler, 0.0, 82, False),
        (explicit_euler, 0.2, 1000, False),
    ],
)
def test_the_cloth_holds_for_ten_seconds_at_so_many_frames_a_second(
    step: Integrator, damping: float, rate: int, holds: bool
) -> None:
    """4 m / 8 k, 89.4 Hz, is safe for any taut cloth. A falling one needs slightly less."""
    knots, registry = make_cloth(damping)
    careful = watched(step, 1000.0)
    with contextlib.nullcontext() if holds else pytest.raises(SimulationDiverged, match="1000 m/s"):
        for _ in range(10 * rate):
            careful(knots, registry.update_forces, 1.0 / rate)


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("step", [leapfrog, semi_implicit_euler])
def test_the_limit_of_a_step_whose_particle_and_spring_are_damped(
    step: Integrator, seed: int
) -> None:
    """An eigenvalue passes -1 where kappa + 2 beta = 2 (1 + D) / D, with D = d^h."""
    draw = random.Random(seed)
    kept = draw.uniform(0.05, 1.0)
    most = (1.0 + kept) / kept  # of beta
    beta = draw.uniform(0.01, 0.9) * most
    d, m = kept ** (1.0 / FRAME), draw.uniform(0.1, 9.0)
    for share, holds in ((0.5, True), (1.0 - 1e-6, True), (1.0 + 1e-6, False), (2.0, False)):
        kappa = share * 2.0 * (most - beta)
        matrix = step_matrix(step, kappa * m / FRAME**2, d, m, beta * m / FRAME)
        # Near the limit an eigenvalue changes by at least 1e-6 / 20.
        assert (radius(matrix) < 1.0) is holds
