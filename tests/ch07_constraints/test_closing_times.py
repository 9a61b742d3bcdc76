"""The time at which a gap closes, build task B7.10."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch07_constraints.detectors import time_to_close
from draw import positive_number
from expect import about, blame, expect_close, expect_exactly

CLOSE = "the docstring of time_to_close"


@pytest.mark.exercise("B7.10")
def test_when_a_gap_closes(rng: Random) -> None:
    about.read = CLOSE
    t, pull = positive_number(rng), positive_number(rng)
    rest = "From rest the gap closes when gap = -a t^2 / 2."
    for gap, v, a, wanted, cause in (
        (12.0, -4.0, 0.0, 3.0, "Without acceleration the gap closes at t = gap / -v."),
        (5.0, 0.0, -10.0, 1.0, rest),
        (15.0, 10.0, -10.0, 3.0, "The body first rises and then falls back, so it passes this "
                                 "height twice. It is closing at the later time."),
        (40.0, -10.0, -10.0, 2.0,
         "The equation has two solutions. One of them is negative and lies in the past, so take "
         "the positive one."),
        (6.0, -5.0, 2.0, 2.0, "The body slows down but still arrives, and would come back later. "
                              "Take the first of the two solutions."),
        (0.5 * pull * t * t, 0.0, -pull, t, rest),
        (1e-6, -1e-6, 0.0, 1.0, "Even a slow approach closes the gap."),
        (5e-7, 0.0, -1e-6, 1.0, "Even a weak acceleration closes the gap."),
        (0.0, 10.0, -10.0, 2.0,
         "The body leaves the ground now. The impact is the moment when it returns."),
        (-0.01, 10.0, -10.0, 1.0 + math.sqrt(0.998),
         "The body starts slightly inside the ground and leaves it. The impact is the moment "
         "when it returns."),
        (-5.0, 3.0, -10.0, 0.3,
         "The body moves out but is too deep to get out. Its impact is the moment when it turns "
         "around and moves in again."),
    ):  # fmt: skip
        about(f"time_to_close({gap}, {v}, {a})", cause=cause)
        got = time_to_close(gap, v, a)
        mistakes = [(-wanted, "A negative time lies in the past. Check the signs of velocity and "
                              "acceleration, since both point along the gap here.")]  # fmt: skip
        if a:
            other = -2.0 * v / a - wanted  # the sum of both solutions is -2 v / a
            mistakes.append((other, f"The result is the other solution of the equation. {cause}"))
        if not v:
            half = wanted / math.sqrt(2.0)
            mistakes.append(
                (
                    half,
                    "The factor 1/2 of the acceleration is missing. Solve gap + v "
                    "t + a t^2 / 2 = 0.",
                )
            )
        blame(got, mistakes)
        expect_close(got, wanted)


@pytest.mark.exercise("B7.10")
def test_a_gap_that_is_closed_or_never_closes(rng: Random) -> None:
    about.read = CLOSE
    x = positive_number(rng)
    lies = "The body lies on the ground and is accelerated inward, so the time is 0."
    slow = "A speed below VELOCITY_TOLERANCE is a rounding error and does not close the gap."
    for gap, v, a, wanted, cause in (
        (0.0, -x, 0.0, 0.0, "The body touches the ground and is closing, so the time is 0."),
        (-x, -x, 3.0, 0.0, "The body is inside the ground and moves farther in, so the time is 0."),
        (0.0, -1e-9, 0.0, 0.0, "The body touches the ground and is closing, if only slowly, so "
                               "the time is 0."),
        (2.0, -2.0, 1.0, math.inf, "The body reverses exactly when it touches (the root is 0), "
                                   "so there is no impact."),
        (0.0, 0.0, -x, 0.0, lies),
        (-1e-18, 0.0, -x, 0.0, lies),
        (x, 1.0, 0.0, math.inf, "The body moves away, and nothing brings it back. Return "
                                "math.inf."),
        (x, 0.0, 0.0, math.inf, "The body does not move at all, so it never arrives. Return "
                                "math.inf."),
        (x, 0.0, 2.0, math.inf, "The body is at rest and is accelerated away, so it never "
                                "arrives."),
        (x, 2.0, 3.0, math.inf, "The body moves away and is accelerated away, so it never "
                                "arrives."),
        (x, -1.0, 1.0 / x, math.inf, "The body turns around before it arrives. The number under "
                                     "the root is then negative, so return math.inf instead of "
                                     "taking the root."),
        (0.0, 0.0, 0.0, math.inf, "The body lies on the ground without velocity or acceleration, "
                                  "so there is no impact."),
        (0.0, x, 0.0, math.inf, "The body leaves the ground and nothing brings it back, so there "
                                "is no impact."),
        (-x, 0.0, 0.0, math.inf, "The body is inside the ground but does not move, so there is "
                                 "no impact."),
        (-x, 0.0, 2.0, math.inf, "The body is inside the ground and accelerated outward, so "
                                 "there is no impact."),
        (1.0, -1e-13, 0.0, math.inf, slow),
        (-x, x, 1.0, math.inf, "The body is inside the ground but moves out, so there is no "
                               "impact."),
        (0.0, -1e-13, 0.0, math.inf, slow),
    ):  # fmt: skip
        about(f"time_to_close({gap}, {v}, {a})", cause=cause)
        got = time_to_close(gap, v, a)
        expect_exactly(float(got), wanted)


@pytest.mark.exercise("B7.10")
def test_the_digits_of_a_time_are_kept() -> None:
    about.read = CLOSE
    for a in (-10.0, 10.0):
        about.cause = "Use 2 gap / (sqrt(v v - 2 a gap) - v). The form (-v - sqrt(...)) / a "
        about.cause += "subtracts nearly equal numbers and loses digits."
        about.call = f"time_to_close(1e-10, -1000.0, {a})"
        got = time_to_close(1e-10, -1000.0, a)
        # The acceleration changes it by 1e-15 of it.
        expect_close(got, 1e-13, tolerance=1e-22)
