"""The time at which a gap closes, build task B7.10."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch07_constraints.detectors import time_to_close
from draw import positive_number
from expect import expect_close, expect_exactly

CLOSE = "the docstring of time_to_close"


@pytest.mark.exercise("B7.10", asks="the first time at which the gap is 0 or negative", read=CLOSE)
def test_when_a_gap_closes(rng: Random) -> None:
    t, pull = positive_number(rng), positive_number(rng)
    rest = "The velocity is 0, but the acceleration closes the gap. Solve gap + a t^2 / 2 = 0."
    for gap, v, a, wanted, cause in (
        (12.0, -4.0, 0.0, 3.0,
         "Without acceleration, return gap / -v. Don't divide by the acceleration."),
        (5.0, 0.0, -10.0, 1.0, rest),
        (15.0, 10.0, -10.0, 3.0,
         "The body first moves away and then falls back. Return the positive solution."),
        (40.0, -10.0, -10.0, 2.0,
         "The negative solution is in the past. Return the positive one."),
        (6.0, -5.0, 2.0, 2.0,
         "The body slows down but arrives. Return the smaller one of the positive solutions."),
        (0.5 * pull * t * t, 0.0, -pull, t, rest),
        (1e-6, -1e-6, 0.0, 1.0,
         "The body is slow, but it reaches the ground after 1 s. Don't treat its speed as 0."),
        (5e-7, 0.0, -1e-6, 1.0,
         "The acceleration is small, but it closes the gap. Don't treat it as 0."),
        (0.0, 10.0, -10.0, 2.0,
         "The body is just leaving the ground. Return the time when it comes back."),
        (-0.01, 10.0, -10.0, 1.0 + math.sqrt(0.998),
         "The body moves out of the ground. Return the time when it comes back."),
        (-5.0, 3.0, -10.0, 0.3,
         "The number under the square root is negative, because the body turns around before it "
         "leaves the ground. Return the time when it turns around."),
    ):  # fmt: skip
        with calls(cause):
            got = time_to_close(gap=gap, velocity=v, acceleration=a)
        slips = {
            "Your time is negative. Check the signs of velocity and acceleration in your formula: "
            "both are positive when they widen the gap.": -wanted
        }
        if a:
            other = -2.0 * v / a - wanted  # the sum of both solutions is -2 v / a
            past = (
                "You returned the negative solution, a time in the past. Return the positive one."
            )
            now = "You returned 0." if other == 0.0 else "You returned the other solution."
            slips[past if other < 0.0 else now] = other
        if not v:
            root = "Your time is sqrt(2) times too large, perhaps because you left out a factor 2. "
            root += "The number under the square root is v^2 - 2 a g, where g is the gap."
            half = "The acceleration changes the gap by a t^2 / 2, but you left out the factor "
            half += "1/2. Solve gap + v t + a t^2 / 2 = 0 for t."
            slips |= {root: wanted * math.sqrt(2.0), half: wanted / math.sqrt(2.0)}
        expect_close(got, wanted, slips, unit="s")


@pytest.mark.exercise("B7.10", asks="Return math.inf if the gap never closes", read=CLOSE)
def test_a_gap_that_is_closed_or_never_closes(rng: Random) -> None:
    x = positive_number(rng)
    slow = "approaches at 1e-13 m/s, which is a rounding error below VELOCITY_TOLERANCE"
    closes, never = "so the gap closes at once. Return 0.", "so no impact comes. Return math.inf."
    for gap, v, a, state in (
        (0.0, -x, 0.0, "touches the ground and moves into it"),
        (-x, -x, 3.0, "is inside the ground and moving farther in"),
        (0.0, -1e-9, 0.0, "touches the ground and is moving into it, however slowly"),
        (0.0, 0.0, -x, "lies on the ground and accelerates into it"),
        (-1e-18, 0.0, -x, "lies on the ground and accelerates into it"),
    ):
        with calls(f"The body {state}, {closes}"):
            got = time_to_close(gap=gap, velocity=v, acceleration=a)
        expect_exactly(float(got), 0.0, unit="s")
    for gap, v, a, state in (
        (2.0, -2.0, 1.0, "turns at the ground, as the number under the square root is 0"),
        (x, 1.0, 0.0, "is moving away, and no acceleration brings it back"),
        (x, 0.0, 0.0, "isn't moving at all"),
        (x, 0.0, 2.0, "is at rest and accelerates away from the ground"),
        (x, 2.0, 3.0, "moves away and accelerates away"),
        (x, -1.0, 1.0 / x, "turns too early, as the number under the square root is negative"),
        (0.0, 0.0, 0.0, "lies on the ground and has neither velocity nor acceleration"),
        (0.0, x, 0.0, "leaves the ground, and no acceleration brings it back"),
        (-x, 0.0, 0.0, "is inside the ground but isn't moving"),
        (-x, 0.0, 2.0, "is inside the ground but accelerating out of it"),
        (1.0, -1e-13, 0.0, slow),
        (-x, x, 1.0, "is inside the ground but moving out of it"),
        (0.0, -1e-13, 0.0, slow),
    ):
        with calls(f"The body {state}, {never}"):
            got = time_to_close(gap=gap, velocity=v, acceleration=a)
        expect_exactly(float(got), math.inf, unit="s")


@pytest.mark.exercise("B7.10", asks="The result must have nine correct digits", read=CLOSE)
def test_the_time_keeps_its_digits() -> None:
    for a in (-10.0, 10.0):
        with calls(
            "You subtracted two nearly equal numbers in (-v - sqrt(...)) / a, which loses most of "
            "their digits. Use 2 gap / (sqrt(v^2 - 2 a gap) - v) instead."
        ):
            got = time_to_close(gap=1e-10, velocity=-1000.0, acceleration=a)
        # The acceleration changes it by 1e-15 of it.
        expect_close(got, 1e-13, tolerance=1e-22, unit="s")
