"""The stiffness that a step tolerates: its matrix, the limits, and a cloth."""

from __future__ import annotations

import contextlib
import math
import random
from collections.abc import Callable
from typing import Any

import numpy
import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.cloth import make_cloth
from ch06_springs.exercises import largest_stable_stiffness
from ch06_springs.integrators import (
    Integrator,
    SimulationDiverged,
    backward_euler,
    explicit_euler,
    leapfrog,
    runge_kutta_4,
    semi_implicit_euler,
    trapezoidal,
    velocity_verlet,
    watched,
)
from ch06_springs.springs import max_stable_stiffness

FRAME = 1.0 / 60.0
EDGES = [
    (explicit_euler, 0.999, 0.0600),
    (explicit_euler, 0.9, 6.327),
    (explicit_euler, 0.5, 41.83),
    (semi_implicit_euler, 1.0, 14400.0),
    (semi_implicit_euler, 0.999, 14400.1),
    (semi_implicit_euler, 0.9, 14412.65),
    (semi_implicit_euler, 0.5, 14483.7),
    (leapfrog, 1.0, 14400.0),
    (leapfrog, 0.9, 14412.65),
    (velocity_verlet, 1.0, 14400.0),
    (runge_kutta_4, 1.0, 28800.0),
]
CASES = [(step, d) for step, d, _ in EDGES]


def exact_edge(step: Integrator, d: float) -> float:
    """Return the known limit of k h^2 / m."""
    kept = d**FRAME
    if step is explicit_euler:
        return 1.0 / kept - 1.0
    return {
        semi_implicit_euler: 2.0 * (1.0 + kept) / kept,
        leapfrog: 2.0 * (1.0 + kept) / kept,
        velocity_verlet: 4.0,
        runge_kutta_4: 8.0,
    }[step]


def pulled(particle: Particle, k: float, c: float = 0.0) -> Callable[[float], None]:
    """Return the force of a spring to the origin in simple code, fast enough for 20,000 steps."""

    def apply_forces(_: float) -> None:
        particle.add_force(Vector3(-k * particle.position.x - c * particle.velocity.x))

    return apply_forces


def step_matrix(
    step: Integrator, k: float, d: float, h: float = FRAME, m: float = 1.0, c: float = 0.0
) -> Any:
    """Return the matrix of a step of (x, h v), which two states determine for a linear spring."""
    columns = []
    for x, v in ((1.0, 0.0), (0.0, 1.0 / h)):
        particle = Particle(Vector3(x), Vector3(v), mass=m, damping=d)
        step([particle], pulled(particle, k, c), h)
        columns.append([particle.position.x, particle.velocity.x * h])
    return numpy.array(columns).T


def radius(matrix: Any) -> float:
    return float(max(abs(numpy.linalg.eigvals(matrix))))


def amplitudes(step: Integrator, k: float, d: float, steps: int) -> list[tuple[float, float]]:
    """Return (x, h v) after every step, from rest at 10 m until it exceeds 1e7 m."""
    particle = Particle(Vector3(10.0), damping=d)
    apply_forces = pulled(particle, k)
    seen = [(10.0, 0.0)]
    for _ in range(steps):
        step([particle], apply_forces, FRAME)
        seen.append((particle.position.x, particle.velocity.x * FRAME))
        if math.hypot(*seen[-1]) > 1e7:
            break
    return seen


# The limits


@pytest.mark.parametrize(("step", "d", "figure"), EDGES)
def test_the_step_s_own_matrix_has_the_known_edge(
    step: Integrator, d: float, figure: float
) -> None:
    edge = exact_edge(step, d) / FRAME**2
    assert edge == pytest.approx(figure, rel=1e-3 if figure < 1.0 else 1e-4)  # its known digits
    inside, outside = (radius(step_matrix(step, share * edge, d)) for share in (0.98, 1.02))
    # For some steps the magnitude is 1 up to the limit, apart from a rounding.
    assert inside < 1.0 + 1e-12
    assert outside > 1.0 + 1e-7


@pytest.mark.parametrize(("step", "d"), CASES)
def test_just_inside_nothing_grows_in_20_000_steps(step: Integrator, d: float) -> None:
    """n steps multiply at most by the condition of the eigenvectors times |lambda|^n."""
    edge = exact_edge(step, d) / FRAME**2
    sizes = numpy.hypot(*numpy.array(amplitudes(step, 0.98 * edge, d, 20_000)).T)
    values, vectors = numpy.linalg.eig(step_matrix(step, 0.98 * edge, d))
    largest = max(abs(values))
    assert largest < 1.0 + 1e-12
    assert len(sizes) == 20_001
    # 20,000 roundings, which the eigenvectors amplify as well.
    bound = 10.0 * numpy.linalg.cond(vectors) * largest ** numpy.arange(20_001)
    assert numpy.all(sizes <= bound * (1.0 + 1e-9) + 1e-300)  # smaller values are denormal


@pytest.mark.parametrize(("step", "d"), CASES[3:])
def test_just_outside_all_but_explicit_euler_pass_a_million_within_200_steps(
    step: Integrator, d: float
) -> None:
    edge = exact_edge(step, d) / FRAME**2
    states = amplitudes(step, 1.02 * edge, d, 250)
    assert 41 <= len(states) - 1 <= 199  # the known range
    assert math.hypot(*states[-1]) > 1e7


@pytest.mark.parametrize(("d", "grown"), [(0.999, 1.0003), (0.9, 1.035), (0.5, 1.26)])
def test_just_outside_explicit_euler_grows_slowly_by_its_eigenvalue(d: float, grown: float) -> None:
    """Along a left eigenvector, every step multiplies a state by the eigenvalue."""
    k = 1.02 * (d**-FRAME - 1.0) / FRAME**2
    kept = d**FRAME
    matrix = numpy.array([[1.0, 1.0], [-kept * k * FRAME**2, kept]])
    values, left = numpy.linalg.eig(matrix.T)
    predicted = abs(values[0]) ** 2000
    assert predicted == pytest.approx(grown, abs=0.005 if grown > 1.01 else 5e-5)
    states = numpy.array(amplitudes(explicit_euler, k, d, 2000))
    along = abs(states @ left[:, 0])
    assert along[-1] / along[0] == pytest.approx(predicted, rel=1e-10)  # 2,000 roundings
    assert along[1] / along[0] == pytest.approx(abs(values[0]), rel=1e-13)


@pytest.mark.parametrize("step", [trapezoidal, backward_euler])
@pytest.mark.parametrize("k", [1e-6, 1.0, 1e4, 1e8, 1e12])
@pytest.mark.parametrize("c", [0.0, 1.0, 1e6])
def test_the_implicit_steps_bear_any_stiffness(
    step: Callable[..., tuple[float, float]], k: float, c: float
) -> None:
    x, v = 10.0, 0.0
    for _ in range(1000):
        x, v = step(x, v, k, c, 1.0, FRAME)
        # Released from rest, the energy never exceeds its initial value, with 1,000 roundings.
        assert k * x * x + v * v <= k * 100.0 * (1.0 + 1e-9)


# The answers to the exercises


def test_the_worked_out_limit_is_where_an_eigenvalue_of_the_book_s_step_passes_1() -> None:
    draw = random.Random(66)
    for _ in range(100):
        d, h, m = draw.uniform(0.05, 0.999), 10.0 ** draw.uniform(-3.0, 0.0), draw.uniform(0.1, 9.0)
        k = max_stable_stiffness(d, h, m)
        # Test at 1e-6 of the limit on both sides. A rounding is 1e-16, and at the softest of these
        # limits, 1e-6 m / h^2, the eigenvalue changes by 5e-13.
        assert radius(step_matrix(explicit_euler, k * (1.0 - 1e-6), d, h, m)) < 1.0
        assert radius(step_matrix(explicit_euler, k * (1.0 + 1e-6), d, h, m)) > 1.0


@pytest.mark.parametrize(
    ("step", "d"), [(explicit_euler, 0.9), (explicit_euler, 0.5), (semi_implicit_euler, 0.9)]
)
def test_the_measured_limit_is_the_known_one_to_a_hundredth(step: Integrator, d: float) -> None:
    assert largest_stable_stiffness(step, d, FRAME) == pytest.approx(
        exact_edge(step, d) / FRAME**2, rel=0.01
    )


# A cloth


@pytest.mark.parametrize(
    ("step", "damping", "rate", "holds"),
    [
        (semi_implicit_euler, 0.2, 85, True),
        (semi_implicit_euler, 0.2, 77, False),
        (semi_implicit_euler, 0.0, 88, True),
        (semi_implicit_euler, 0.0, 82, False),
        (explicit_euler, 0.2, 1000, False),
        (explicit_euler, 0.0, 1000, False),
    ],
)
def test_the_cloth_holds_for_ten_seconds_at_so_many_frames_a_second(
    step: Integrator, damping: float, rate: int, holds: bool
) -> None:
    """No row of knots has a stiffness above 8 k, so 4 m / 8 k is safe for any taut cloth.

    This is 89.4 Hz for 200 N/m and 50 g. A falling cloth needs slightly less. Within a frame or two
    of 82 and 85 Hz, the result depends on the last digit of the knots' initial positions.
    """
    knots, registry = make_cloth(damping)
    careful = watched(step, 1000.0)
    with contextlib.nullcontext() if holds else pytest.raises(SimulationDiverged, match="1000 m/s"):
        for _ in range(10 * rate):
            careful(knots, registry.update_forces, 1.0 / rate)


@pytest.mark.parametrize("beta", [0.1, 0.5, 1.0, 1.9])
@pytest.mark.parametrize(
    ("step", "limit"),
    [
        (explicit_euler, lambda b: b),
        (semi_implicit_euler, lambda b: 4.0 - 2.0 * b),
        (leapfrog, lambda b: 4.0 - 2.0 * b),
    ],
    ids=["explicit", "semi-implicit", "leapfrog"],
)
def test_a_damper_in_the_spring_moves_the_limit(
    step: Integrator, limit: Callable[[float], float], beta: float
) -> None:
    """With beta = c h / m: kappa < beta, position first, and kappa + 2 beta < 4 for the others."""
    for share, holds in ((0.98, True), (1.02, False)):
        k, c = share * limit(beta) / FRAME**2, beta / FRAME
        assert (radius(step_matrix(step, k, 1.0, c=c)) < 1.0) is holds


def moves(kappa: float, beta: float, kept: float) -> tuple[Any, Any]:
    """Return half a drift and a kick as matrices of (x, h v). A kick keeps D = d^h."""
    half_a_drift = numpy.array([[1.0, 0.5], [0.0, 1.0]])
    return half_a_drift, numpy.array([[1.0, 0.0], [-kept * kappa, kept * (1.0 - beta)]])


@pytest.mark.parametrize("seed", range(50))
def test_leapfrog_has_the_eigenvalues_of_semi_implicit_euler(seed: int) -> None:
    """Test damping in particle and spring. S K S and S S K have the same trace and determinant.

    An eigenvalue passes -1 where 1 + trace + determinant = 2 + 2 D (1 - beta) - D kappa is 0, which
    is kappa + 2 beta = 2 (1 + D) / D. None passes 1 before that: D (1 - beta) > -1 if kappa > 0.
    """
    draw = random.Random(seed)
    kept = draw.uniform(0.05, 1.0)
    most = (1.0 + kept) / kept  # of beta
    beta = draw.uniform(0.01, 0.9) * most
    d, h, m = kept ** (1.0 / FRAME), FRAME, draw.uniform(0.1, 9.0)
    for share, holds in ((0.5, True), (1.0 - 1e-6, True), (1.0 + 1e-6, False), (2.0, False)):
        kappa = share * 2.0 * (most - beta)
        half, kick = moves(kappa, beta, kept)
        for step, wanted in (
            (leapfrog, half @ kick @ half),
            (semi_implicit_euler, half @ half @ kick),
        ):
            matrix = step_matrix(step, kappa * m / h**2, d, h, m, beta * m / h)
            # d is D^60, so d^h has an error of up to 1e-13. No number here exceeds 10.
            assert matrix == pytest.approx(wanted, abs=1e-12)
            # Near the limit an eigenvalue changes by at least 1e-6 / 20.
            assert (radius(matrix) < 1.0) is holds
            assert (radius(wanted) < 1.0) is holds


@pytest.mark.parametrize("step", [semi_implicit_euler, leapfrog])
def test_a_damper_may_be_too_strong_for_any_spring(step: Integrator) -> None:
    """At beta = (1 + D) / D no stiffness is stable: an eigenvalue is -1 even without a spring."""
    kept = 0.5
    for share, holds in ((0.98, True), (1.02, False)):
        matrix = step_matrix(step, 1e-6, kept ** (1.0 / FRAME), c=share * 3.0 / FRAME)
        assert (radius(matrix) < 1.0) is holds
