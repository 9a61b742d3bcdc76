"""The closed forms of drag compared with fine steps of a method of order 4."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch05_forces.closed_form import coasting_speed, quadratic_fall, terminal_speed

coefficient = st.floats(0.01, 5.0)


def runge_kutta(change: Callable[[float], float], v: float, time: float) -> tuple[float, float]:
    """Return speed and distance after a time of dv/dt = change(v), in 2,000 steps."""
    h, distance = time / 2000.0, 0.0
    for _ in range(2000):
        a = change(v)
        b = change(v + a * h / 2.0)
        c = change(v + b * h / 2.0)
        d = change(v + c * h)
        distance += v * h + (a + b + c) * h * h / 6.0
        v += (a + 2.0 * b + 2.0 * c + d) * h / 6.0
    return v, distance


@given(st.floats(0.1, 50.0), st.floats(0.5, 20.0), coefficient, st.floats(0.01, 3.0))
def test_a_quadratic_fall_solves_its_equation(m: float, g: float, k2: float, time: float) -> None:
    wanted = runge_kutta(lambda v: g - k2 * v * v / m, 0.0, time)
    # A step is at most a twentieth of the time in which the speed changes, to the fourth power.
    assert quadratic_fall(m, g, k2, time) == pytest.approx(wanted, rel=1e-7)


@given(st.floats(0.1, 10.0), coefficient, coefficient, st.floats(2.0, 50.0), st.floats(0.01, 3.0))
def test_coasting_solves_its_equation(
    v: float, k1: float, k2: float, m: float, time: float
) -> None:
    wanted, _ = runge_kutta(lambda u: -(k1 * u + k2 * u * u) / m, v, time)
    assert coasting_speed(v, k1, k2, m, time) == pytest.approx(wanted, rel=1e-6)


def test_the_known_figures() -> None:
    assert terminal_speed(2.0 * 9.81, 0.3, 0.05) == pytest.approx(17.0349694, abs=5e-8)
    # Computed with 40 digits.
    wanted = (17.878238350449884, 33.699945475035044)
    assert quadratic_fall(2.0, 9.81, 0.05, 3.0) == pytest.approx(wanted, rel=1e-15)


def test_the_two_forms_of_the_distance_meet() -> None:
    """The distance is continuous at x = 40, where the formula changes."""
    u = math.sqrt(200.0)
    distances = [
        quadratic_fall(1.0, 10.0, 0.05, 40.0 * u / 10.0 * share)[1] for share in (1.0 - 1e-9, 1.0)
    ]
    # The fall is u per second for 4e-9 of the time. The rest is a rounding of 790.
    assert distances[1] - distances[0] == pytest.approx(u * 40.0 * u / 10.0 * 1e-9, abs=1e-12)


def test_a_fall_of_any_length_ends_in_numbers() -> None:
    for time in (0.0, 1e-300, 1e-9, 1e9, 1e300):
        for k2 in (1e-300, 1e-9, 1.0, 1e9):
            speed, distance = quadratic_fall(2.0, 9.81, k2, time)
            assert speed >= 0.0
            assert distance >= 0.0
            assert 0.0 <= coasting_speed(5.0, k2, k2, 2.0, time) <= 5.0
            assert coasting_speed(5.0, 0.0, 0.0, 1e-300, time) == 5.0
