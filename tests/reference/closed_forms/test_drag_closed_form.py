"""The closed forms of drag against SciPy's solver, and the wind on a bullet against its own."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from ch02_vectors.vector import Vector3
from ch05_forces.closed_form import coasting_speed, quadratic_fall, terminal_speed
from ch05_forces.sniper import MUZZLE_SPEED, SniperRange

number = st.floats(0.01, 5.0)


@given(st.floats(0.1, 50.0), st.floats(0.5, 20.0), number, st.floats(0.01, 3.0))
def test_a_quadratic_fall_solves_its_equation(m: float, g: float, k2: float, time: float) -> None:
    def change(_: float, state: tuple[float, float]) -> tuple[float, float]:
        return g - k2 * state[0] ** 2 / m, state[0]

    wanted = solve_ivp(change, (0.0, time), (0.0, 0.0), "DOP853", rtol=1e-10, atol=1e-12).y[:, -1]
    assert quadratic_fall(m, g, k2, time) == pytest.approx(tuple(wanted), rel=1e-8)


@given(st.floats(0.1, 10.0), number, number, st.floats(2.0, 50.0), st.floats(0.01, 3.0))
def test_coasting_solves_its_equation(
    v: float, k1: float, k2: float, m: float, time: float
) -> None:
    def change(_: float, speed: float) -> float:
        return -(k1 * speed + k2 * speed * speed) / m

    wanted = solve_ivp(change, (0.0, time), (v,), "DOP853", rtol=1e-10, atol=1e-12).y[0, -1]
    assert coasting_speed(v, k1, k2, m, time) == pytest.approx(wanted, rel=1e-8)


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


def test_the_wind_carries_as_far_as_it_goes_in_the_time_that_the_drag_costs() -> None:
    """With linear drag x = w (t - z / v0) is exact. The error of the step has order 1."""
    errors = []
    for frame in (1.0 / 240.0, 1.0 / 480.0):
        at = SniperRange(1)
        at.wind.k1, at.wind.k2 = 0.2, 0.0
        at.wind.velocity = Vector3(10.0, 0.0, 0.0)
        at.shoot(0.0, 0.0)
        for _ in range(round(0.75 / frame)):
            at.update(frame)
        assert at.bullet is not None
        drift = 10.0 * (1.0 - math.exp(-0.2 * 0.75)) / 0.2  # the path under such drag
        exact = 10.0 * 0.75 - drift
        errors.append(at.bullet.position.x - exact)
        # z has the same relative error, so the rule also holds for the step.
        z = at.bullet.position.z
        assert at.bullet.position.x == pytest.approx(10.0 * (0.75 - z / MUZZLE_SPEED), rel=1e-12)
    assert errors[0] / errors[1] == pytest.approx(2.0, abs=0.01)
