"""Arguments that the formulas of B5.6 and B5.7 reject."""

from __future__ import annotations

import math

import pytest

from ch05_forces.closed_form import coasting_speed, quadratic_fall, terminal_speed
from expect import about, expect_error

pytestmark = pytest.mark.robust


def why(names: str, bad: tuple[float, ...], good: tuple[float, ...]) -> str:
    """Say which argument is bad. Of the names, those with a plus must be positive."""
    place = next(i for i, number in enumerate(good) if bad[i] != number)
    name = names.split(", ")[place]
    rule = "positive" if "+" in name else "not negative"
    text = f"{name.strip('+')} is {bad[place]:g}. It must be finite and {rule}, so raise "
    text += "ValueError."
    return text if name.startswith("k") else f"The {text}"


def bad_numbers(good: tuple[float, ...]) -> list[tuple[float, ...]]:
    """Return these arguments with each one in turn replaced by NaN and by infinity."""
    return [
        (*good[:i], bad, *good[i + 1 :]) for i in range(len(good)) for bad in (math.nan, math.inf)
    ]


@pytest.mark.exercise("B5.6")
def test_terminal_speed_rejects_bad_arguments() -> None:
    about.read = "the docstring of terminal_speed"
    for bad in (
        (0.0, 0.3, 0.05),
        (-9.81, 0.3, 0.05),
        (9.81, -0.3, 0.05),
        (9.81, 0.3, -0.05),
        (9.81, 0.0, 0.0),
        *bad_numbers((9.81, 0.3, 0.05)),
    ):
        about.cause = why("weight+, k1, k2", bad, (9.81, 0.3, 0.05))
        if bad[1:] == (0.0, 0.0):
            about.cause = "Both k1 and k2 are 0. There is no terminal speed without drag, so raise "
            about.cause += "ValueError."
        expect_error(
            lambda bad=bad: terminal_speed(*bad),
            ValueError,
            call="terminal_speed(weight={}, k1={}, k2={})".format(*bad),
            allowed=lambda: terminal_speed(9.81, 0.3, 0.05),
        )


@pytest.mark.exercise("B5.7")
def test_quadratic_fall_rejects_bad_arguments() -> None:
    about.read = "the docstring of quadratic_fall"
    for bad in (
        (0.0, 9.81, 0.05, 3.0),
        (2.0, 0.0, 0.05, 3.0),
        (2.0, 9.81, 0.0, 3.0),
        (-2.0, 9.81, -0.05, 3.0),  # the signs cancel below the root
        (-2.0, -9.81, 0.05, 3.0),
        (2.0, 9.81, 0.05, -3.0),
        *bad_numbers((2.0, 9.81, 0.05, 3.0)),
    ):
        about.cause = why("mass+, gravity+, k2+, time", bad, (2.0, 9.81, 0.05, 3.0))
        expect_error(
            lambda bad=bad: quadratic_fall(*bad),
            ValueError,
            call="quadratic_fall(mass={}, gravity={}, k2={}, time={})".format(*bad),
            allowed=lambda: quadratic_fall(2.0, 9.81, 0.05, 3.0),
        )


@pytest.mark.exercise("B5.7")
def test_coasting_speed_rejects_bad_arguments() -> None:
    about.read = "the docstring of coasting_speed"
    for bad in (
        (-20.0, 0.3, 0.05, 2.0, 1.5),
        (20.0, -0.3, 0.05, 2.0, 1.5),
        (20.0, 0.3, -0.05, 2.0, 1.5),
        (20.0, 0.3, 0.05, 0.0, 1.5),
        (20.0, 0.3, 0.05, -2.0, 1.5),
        (20.0, 0.3, 0.05, 2.0, -1.5),
        *bad_numbers((20.0, 0.3, 0.05, 2.0, 1.5)),
    ):
        about.cause = why("speed, k1, k2, mass+, time", bad, (20.0, 0.3, 0.05, 2.0, 1.5))
        expect_error(
            lambda bad=bad: coasting_speed(*bad),
            ValueError,
            call="coasting_speed(speed={}, k1={}, k2={}, mass={}, time={})".format(*bad),
            allowed=lambda: coasting_speed(20.0, 0.3, 0.05, 2.0, 1.5),
        )
