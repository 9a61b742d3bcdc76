"""The closed forms of drag against SciPy's solver, and the wind on a bullet against its own."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from ch05_forces.closed_form import coasting_speed, quadratic_fall, terminal_speed

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
