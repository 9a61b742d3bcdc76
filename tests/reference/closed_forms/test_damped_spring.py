"""The closed form of a damped spring compared with a matrix exponential of 120 digits."""

from __future__ import annotations

import math
from decimal import Decimal, localcontext

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch06_springs.closed_form import damped_spring_state
from ch06_springs.integrators import backward_euler, trapezoidal

Row = tuple[Decimal, Decimal]
Matrix = tuple[Row, Row]

start = st.floats(-10.0, 10.0)
share = st.floats(0.0, 4.0)  # fraction of critical damping, for all three regimes
rate = st.floats(-2.0, 3.0).map(lambda power: 10.0**power)
mass = st.floats(-2.0, 3.0).map(lambda power: 10.0**power)


def times(a: Matrix, b: Matrix) -> Matrix:
    (p, q), (r, s) = a
    (t, u), (v, w) = b
    return (p * t + q * v, p * u + q * w), (r * t + s * v, r * u + s * w)


def in_decimals(
    x0: float, v0: float, k: float, c: float, m: float, time: float
) -> tuple[Decimal, Decimal]:
    """Return the state from 60 terms of the series of e^(A t / 2^n), squared n times."""
    with localcontext() as context:
        context.prec = 120
        t, one, zero = Decimal(time), Decimal(1), Decimal(0)
        stiff, damped = Decimal(k) / Decimal(m), Decimal(c) / Decimal(m)
        halvings = max(0, math.frexp((1.0 + k / m + c / m) * time)[1] + 1)
        t /= Decimal(2) ** halvings
        matrix = (zero, t), (-stiff * t, -damped * t)
        term: Matrix = (one, zero), (zero, one)
        total = term
        for i in range(1, 61):
            (p, q), (r, s) = times(term, matrix)
            term = (p / i, q / i), (r / i, s / i)
            ((p, q), (r, s)), ((a, b), (c_, d)) = term, total
            total = (a + p, b + q), (c_ + r, d + s)
        for _ in range(halvings):
            total = times(total, total)
        (a, b), (c_, d) = total
        x, v = Decimal(x0), Decimal(v0)
        return a * x + b * v, c_ * x + d * v


@given(start, start, share, rate, mass, st.floats(0.0, 20.0))
def test_the_state_is_that_of_the_matrix_in_every_regime(
    x0: float, v: float, share: float, chi: float, m: float, turns: float
) -> None:
    v0, k, c, time = v * chi, chi * chi * m, share * 2.0 * chi * m, turns / chi
    got = damped_spring_state(x0, v0, k, c, m, time)
    x, velocity = in_decimals(x0, v0, k, c, m, time)
    # The tolerance allows for roundings of chi t and (c / 2 m) t, up to 20 and 80, and of their
    # difference near critical damping. They are relative to the largest value, x0 or v0 / chi.
    size = abs(x0) + abs(v)
    assert got[0] == pytest.approx(float(x), abs=4e-14 * size)
    assert got[1] / chi == pytest.approx(float(velocity) / chi, abs=4e-14 * size)


def test_what_is_too_large_for_a_float_is_an_error_and_no_nan() -> None:
    assert damped_spring_state(1e200, 0.0, 1e200, 0.0, 1.0, 0.0) == (1e200, 0.0)
    with pytest.raises(ValueError, match="velocity must be finite"):
        damped_spring_state(1e200, 0.0, 1e300, 0.0, 1.0, 1e-100)
    with pytest.raises(ValueError, match="position must be finite"):
        damped_spring_state(1e308, 1e308, 0.0, 0.0, 1.0, 10.0)
    for method in (backward_euler, trapezoidal):
        for arguments in ((1.0, 0.0, 1e308, 0.0, 1.0, 1e10), (1.0, 1.0, 1e200, 0.0, 1.0, 1e200)):
            with pytest.raises(ValueError, match="new position must be finite"):
                method(*arguments)
