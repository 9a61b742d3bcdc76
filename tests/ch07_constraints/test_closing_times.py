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
        (15.0, 10.0, -10.0, 3.0, "It first goes up and then comes down: take the later solution."),
        (40.0, -10.0, -10.0, 2.0, "One solution lies in the past. Take the positive one."),
        (6.0, -5.0, 2.0, 2.0, "It slows down but arrives: take the first of the two solutions."),
        (0.5 * pull * t * t, 0.0, -pull, t, rest),
        (1e-6, -1e-6, 0.0, 1.0, "A slow approach closes the gap too."),
        (5e-7, 0.0, -1e-6, 1.0, "A weak acceleration closes the gap too."),
        (0.0, 10.0, -10.0, 2.0, "It leaves the ground now. The impact is when it comes back."),
        (-0.01, 10.0, -10.0, 1.0 + math.sqrt(0.998), "It starts a little inside and leaves. The "
         "impact is when it comes back."),
        (-5.0, 3.0, -10.0, 0.3, "It is too deep to get out. It starts to close when its velocity "
         "reverses."),
    ):  # fmt: skip
        about(f"time_to_close({gap}, {v}, {a})", cause=cause)
        got = time_to_close(gap, v, a)
        mistakes = [(-wanted, "This time is in the past. Check the signs of velocity and "
                     "acceleration.")]  # fmt: skip
        if a:
            other = -2.0 * v / a - wanted  # the sum of both solutions is -2 v / a
            mistakes.append((other, f"This is the other solution of the equation. {cause}"))
        if not v:
            half = wanted / math.sqrt(2.0)
            mistakes.append((half, "The factor 1/2 is missing: solve gap + v t + a t^2 / 2 = 0."))
        blame(got, mistakes)
        expect_close(got, wanted)


@pytest.mark.exercise("B7.10")
def test_a_gap_that_is_closed_or_never_closes(rng: Random) -> None:
    about.read = CLOSE
    x = positive_number(rng)
    lies = "It lies there and is accelerated inward. The time is 0."
    slow = "A speed below VELOCITY_TOLERANCE is rounding. It does not close the gap."
    for gap, v, a, wanted, cause in (
        (0.0, -x, 0.0, 0.0, "It touches and closes, so the time is 0."),
        (-x, -x, 3.0, 0.0, "It is inside and moves farther in, so the time is 0."),
        (0.0, -1e-9, 0.0, 0.0, "It touches and closes slowly, so the time is 0."),
        (2.0, -2.0, 1.0, math.inf, "It reverses exactly when it touches (the root is 0), so there "
         "is no impact."),
        (0.0, 0.0, -x, 0.0, lies),
        (-1e-18, 0.0, -x, 0.0, lies),
        (x, 1.0, 0.0, math.inf, "It moves away and nothing brings it back."),
        (x, 0.0, 0.0, math.inf, "It does not move at all."),
        (x, 0.0, 2.0, math.inf, "It is accelerated away."),
        (x, 2.0, 3.0, math.inf, "It moves away and is accelerated away."),
        (x, -1.0, 1.0 / x, math.inf, "It reverses before it arrives: the number under the root is "
         "negative."),
        (0.0, 0.0, 0.0, math.inf, "It lies there without velocity or acceleration, so there is no "
         "impact."),
        (0.0, x, 0.0, math.inf, "It leaves."),
        (-x, 0.0, 0.0, math.inf, "It is inside but does not move, so there is no impact."),
        (-x, 0.0, 2.0, math.inf, "It is inside and accelerated outward, so there is no impact."),
        (1.0, -1e-13, 0.0, math.inf, slow),
        (-x, x, 1.0, math.inf, "It is inside but moves out, so there is no impact."),
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
