"""Arguments that the formulas of B5.6 and B5.7 reject."""

from __future__ import annotations

import math

import pytest

from ch05_forces.closed_form import coasting_speed, quadratic_fall, terminal_speed
from expect import about, expect_error

pytestmark = pytest.mark.robust


def bad_numbers(good: tuple[float, ...]) -> list[tuple[float, ...]]:
    """Return these arguments with each one in turn replaced by NaN and by infinity."""
    return [
        (*good[:i], bad, *good[i + 1 :]) for i in range(len(good)) for bad in (math.nan, math.inf)
    ]


@pytest.mark.exercise("B5.6")
def test_a_terminal_speed_needs_weight_and_drag() -> None:
    about.read = "the docstring of terminal_speed"
    for bad in (
        (0.0, 0.3, 0.05),
        (-9.81, 0.3, 0.05),
        (9.81, -0.3, 0.05),
        (9.81, 0.3, -0.05),
        (9.81, 0.0, 0.0),
        *bad_numbers((9.81, 0.3, 0.05)),
    ):
        about.cause = "Both coefficients are 0, so there is no drag and no terminal speed. Raise "
        about.cause += "ValueError."
        expect_error(
            lambda bad=bad: terminal_speed(*bad),
            ValueError,
            call=f"terminal_speed{bad}",
            allowed=lambda: terminal_speed(9.81, 0.3, 0.05),
        )


@pytest.mark.exercise("B5.7")
def test_a_fall_needs_numbers_that_mean_something() -> None:
    about.read = "the docstring of quadratic_fall"
    about.cause = "One of these arguments is out of range, so raise ValueError. Pass each of them "
    about.cause += "to one of the functions in arguments.py, which raise the error for you."
    for bad in (
        (0.0, 9.81, 0.05, 3.0),
        (2.0, 0.0, 0.05, 3.0),
        (2.0, 9.81, 0.0, 3.0),
        (-2.0, 9.81, -0.05, 3.0),  # the signs cancel below the root
        (-2.0, -9.81, 0.05, 3.0),
        (2.0, 9.81, 0.05, -3.0),
        *bad_numbers((2.0, 9.81, 0.05, 3.0)),
    ):
        expect_error(
            lambda bad=bad: quadratic_fall(*bad),
            ValueError,
            call=f"quadratic_fall{bad}",
            allowed=lambda: quadratic_fall(2.0, 9.81, 0.05, 3.0),
        )


@pytest.mark.exercise("B5.7")
def test_coasting_needs_numbers_that_mean_something() -> None:
    about.read = "the docstring of coasting_speed"
    about.cause = "One of these arguments is out of range, so raise ValueError. Pass each of them "
    about.cause += "to one of the functions in arguments.py, which raise the error for you."
    for bad in (
        (-20.0, 0.3, 0.05, 2.0, 1.5),
        (20.0, -0.3, 0.05, 2.0, 1.5),
        (20.0, 0.3, -0.05, 2.0, 1.5),
        (20.0, 0.3, 0.05, 0.0, 1.5),
        (20.0, 0.3, 0.05, -2.0, 1.5),
        (20.0, 0.3, 0.05, 2.0, -1.5),
        *bad_numbers((20.0, 0.3, 0.05, 2.0, 1.5)),
    ):
        expect_error(
            lambda bad=bad: coasting_speed(*bad),
            ValueError,
            call=f"coasting_speed{bad}",
            allowed=lambda: coasting_speed(20.0, 0.3, 0.05, 2.0, 1.5),
        )
