"""Closed forms of flights against decimals of 80 digits, and a shell against known figures."""

from __future__ import annotations

import math
from decimal import Decimal, localcontext

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.closed_form import drag_factors, state_after


def in_decimals(damping: float, time: float) -> tuple[float, float, float]:
    """Return the factors, computed directly from the formulas with 80 digits."""
    with localcontext() as context:
        context.prec = 80
        d, t = Decimal(damping), Decimal(time)
        k = -d.ln()
        if k == 0:
            return 1.0, time, float(t * t / 2)
        kept = (-k * t).exp()
        gone = (1 - kept) / k
        return float(kept), float(gone), float((t - gone) / k)


def expect_factors(damping: float, time: float) -> None:
    # The tolerance allows for a few roundings. kept is e^(-kt), so the rounding of ln d counts kt
    # times.
    kt = abs(math.log(damping) * time)
    for got, wanted in zip(drag_factors(damping, time), in_decimals(damping, time), strict=True):
        assert got == pytest.approx(wanted, rel=1e-15 * (8.0 + kt), abs=1e-300)


@given(st.floats(1e-6, 2.0), st.floats(1e-6, 50.0))
def test_the_factors_are_right_to_the_last_digits(damping: float, time: float) -> None:
    expect_factors(damping, time)


@pytest.mark.parametrize("exponent", range(1, 17))
@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_the_factors_are_right_next_to_a_damping_of_1(sign: float, exponent: int) -> None:
    for time in (1e-3, 1.0, 3.7, 40.0):
        expect_factors(1.0 + sign * 10.0**-exponent, time)


def test_what_fits_in_no_float_is_refused_and_no_nan() -> None:
    assert drag_factors(1.0, 1e150) == (1.0, 1e150, pytest.approx(5e299, rel=1e-15))
    for damping, time in ((1.0, 1e200), (1.0, 1e155), (2.0, 2000.0)):
        with pytest.raises(OverflowError):
            state_after(Particle(damping=damping), time)
    # With drag a long time is possible, because motion ends or reaches the terminal speed.
    kept, gone, fallen = drag_factors(0.5, 1e300)
    assert (kept, gone) == (0.0, pytest.approx(1.0 / math.log(2.0), rel=1e-15))
    assert fallen == pytest.approx(1e300 / math.log(2.0), rel=1e-15)
