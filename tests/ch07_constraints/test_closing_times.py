"""The time at which a gap closes, build task B7.10."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch07_constraints.detectors import time_to_close
from draw import positive_number
from expect import about, blame, expect_close, expect_exactly

CLOSE = "the docstring of time_to_close"


@pytest.mark.exercise("B7.10", asks="the first time at which the gap is 0 or negative")
def test_when_a_gap_closes(rng: Random) -> None:
    about.read = CLOSE
    t, pull = positive_number(rng), positive_number(rng)
    rest = "The velocity is 0, but the acceleration still closes the gap. Solve gap + a t^2 / 2 = "
    rest += "0 for t."
    for gap, v, a, wanted, cause in (
        (12.0, -4.0, 0.0, 3.0, "There is no acceleration, so the body crosses the gap at constant "
                               "speed. Return gap / -v, without dividing by the acceleration."),
        (5.0, 0.0, -10.0, 1.0, rest),
        (15.0, 10.0, -10.0, 3.0,
         "The body first moves away and then falls back to the ground. Return the positive "
         "solution of the equation."),
        (40.0, -10.0, -10.0, 2.0,
         "The negative solution is in the past. Return the positive one."),
        (6.0, -5.0, 2.0, 2.0,
         "The body slows down but still reaches the ground. Return the smaller of the two "
         "positive solutions."),
        (0.5 * pull * t * t, 0.0, -pull, t, rest),
        (1e-6, -1e-6, 0.0, 1.0, "The body is slow, but it reaches the ground after 1 s. Don't "
                                "treat its speed as 0."),
        (5e-7, 0.0, -1e-6, 1.0, "The acceleration is small, but it brings the body to the ground "
                                "after 1 s. Don't treat the acceleration as 0."),
        (0.0, 10.0, -10.0, 2.0,
         "At t = 0 the body is just leaving the ground, which is not an impact. Return the time "
         "when it comes back."),
        (-0.01, 10.0, -10.0, 1.0 + math.sqrt(0.998),
         "The body starts slightly inside the ground and moves out of it, which is not an impact. "
         "Return the time when it comes back."),
        (-5.0, 3.0, -10.0, 0.3,
         "The number under the square root is negative, because the body turns around before it "
         "leaves the ground. Return the time when it turns around."),
    ):  # fmt: skip
        about(f"time_to_close(gap={gap}, velocity={v}, acceleration={a})", cause=cause)
        got = time_to_close(gap, v, a)
        mistakes = [(-wanted, "Your time is negative. Check the signs of velocity and acceleration "
                              "in your formula: both are positive when they widen the gap."),
                   ]  # fmt: skip
        if a:
            other = -2.0 * v / a - wanted  # the sum of both solutions is -2 v / a
            why = f"You returned the other solution of the quadratic equation. {cause}"
            if other < 0.0:
                why = "You returned the negative solution of the quadratic equation, which is in "
                why += "the past. Return the positive one."
            elif other == 0.0:
                why = f"You returned 0. {cause}"
            mistakes.append((other, why))
        if not v:
            half = wanted / math.sqrt(2.0)
            root = "Your time is sqrt(2) times too large, perhaps because you left out a factor 2. "
            root += "The number under the square root is v^2 - 2 a g, where g is the gap."
            mistakes.append((2.0 * half, root))
            mistakes.append(
                (
                    half,
                    "The acceleration changes the gap by a t^2 / 2, but you left out the factor "
                    "1/2. Solve gap + v t + a t^2 / 2 = 0 for t.",
                )
            )
        blame(got, mistakes)
        expect_close(got, wanted, unit="s")


@pytest.mark.exercise("B7.10", asks="Return math.inf if the gap never closes")
def test_a_gap_that_is_closed_or_never_closes(rng: Random) -> None:
    about.read = CLOSE
    x = positive_number(rng)
    lies = (
        "The body lies on the ground and accelerates into it, so the gap closes at once. Return 0."
    )
    slow = "The speed of 1e-13 m/s is below VELOCITY_TOLERANCE, so treat it as a rounding error "
    slow += "that never closes the gap. Return math.inf."
    for gap, v, a, wanted, cause in (
        (0.0, -x, 0.0, 0.0, "The body touches the ground and moves into it, so the gap closes at "
                            "once. Return 0."),
        (-x, -x, 3.0, 0.0, "The body is inside the ground and moving farther in, so the gap is "
                           "already closed. Return 0."),
        (0.0, -1e-9, 0.0, 0.0, "The body touches the ground and is moving into it, however slowly, "
                               "so the gap closes at once. Return 0."),
        (2.0, -2.0, 1.0, math.inf,
         "The number under the square root is 0, because the body turns around exactly at the "
         "ground. This is not an impact, so return math.inf."),
        (0.0, 0.0, -x, 0.0, lies),
        (-1e-18, 0.0, -x, 0.0, lies),
        (x, 1.0, 0.0, math.inf, "The body is moving away, and no acceleration brings it back. "
                                "Return math.inf."),
        (x, 0.0, 0.0, math.inf, "The body isn't moving at all, so it never reaches the ground. "
                                "Return math.inf."),
        (x, 0.0, 2.0, math.inf, "The body is at rest and accelerates away from the ground, so it "
                                "never arrives. Return math.inf."),
        (x, 2.0, 3.0, math.inf, "The body moves away and accelerates away, so it never arrives. "
                                "Return math.inf."),
        (x, -1.0, 1.0 / x, math.inf, "The body turns around before it reaches the ground. The "
                                     "number under the square root is negative, so return "
                                     "math.inf before you take the square root."),
        (0.0, 0.0, 0.0, math.inf, "The body lies on the ground and has neither velocity nor "
                                  "acceleration, so there is no impact. Return math.inf."),
        (0.0, x, 0.0, math.inf, "The body leaves the ground, and no acceleration brings it back. "
                                "There is no impact, so return math.inf."),
        (-x, 0.0, 0.0, math.inf, "The body is inside the ground but isn't moving, so there is no "
                                 "impact. Return math.inf."),
        (-x, 0.0, 2.0, math.inf, "The body is inside the ground but accelerating out of it, so "
                                 "there is no impact. Return math.inf."),
        (1.0, -1e-13, 0.0, math.inf, slow),
        (-x, x, 1.0, math.inf, "The body is inside the ground but moving out of it, so there is no "
                               "impact. Return math.inf."),
        (0.0, -1e-13, 0.0, math.inf, slow),
    ):  # fmt: skip
        about(f"time_to_close(gap={gap}, velocity={v}, acceleration={a})", cause=cause)
        got = time_to_close(gap, v, a)
        expect_exactly(float(got), wanted, unit="s")


@pytest.mark.exercise("B7.10", asks="The result must have nine correct digits")
def test_the_time_keeps_its_digits() -> None:
    about.read = CLOSE
    for a in (-10.0, 10.0):
        about.cause = "You subtracted two nearly equal numbers in (-v - sqrt(...)) / a, which "
        about.cause += "loses most of their digits. Use 2 gap / (sqrt(v^2 - 2 a gap) - v) instead."
        about.call = f"time_to_close(gap=1e-10, velocity=-1000.0, acceleration={a})"
        got = time_to_close(1e-10, -1000.0, a)
        # The acceleration changes it by 1e-15 of it.
        expect_close(got, 1e-13, tolerance=1e-22, unit="s")
