"""When a gap closes, B7.10."""

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
    for gap, v, a, wanted, cause in (
        (12.0, -4.0, 0.0, 3.0, "without an acceleration it is gap / -v"),
        (5.0, 0.0, -10.0, 1.0, "from rest gap = -a t^2 / 2"),
        (15.0, 10.0, -10.0, 3.0, "up first, and down again: of both solutions the later one"),
        (40.0, -10.0, -10.0, 2.0, "of both solutions the one that is not before now"),
        (6.0, -5.0, 2.0, 2.0, "it is slowed down, and gets there: of both solutions the first one"),
        (0.5 * pull * t * t, 0.0, -pull, t, "from rest gap = -a t^2 / 2"),
        (1e-6, -1e-6, 0.0, 1.0, "what is slow gets there too"),
        (5e-7, 0.0, -1e-6, 1.0, "what is pulled weakly gets there too"),
        (0.0, 10.0, -10.0, 2.0, "it touches and leaves: that is no impact, its return is one"),
        (-0.01, 10.0, -10.0, 1.0 + math.sqrt(0.998), "a little inside it leaves, and returns"),
        (-5.0, 3.0, -10.0, 0.3, "too deep to get out: from where it turns round it closes on"),
    ):
        about(f"time_to_close({gap}, {v}, {a})", cause=cause)
        got = time_to_close(gap, v, a)
        mistakes = [(-wanted, "a time before now: the sign of the velocity or acceleration")]
        if a:
            other = -2.0 * v / a - wanted  # both solutions add up to that
            mistakes.append((other, f"gap + v t + a t^2 / 2 is 0 then too, but: {about.cause}"))
        if not v:
            half = wanted / math.sqrt(2.0)
            mistakes.append((half, "that is with a t^2: gap + v t + a t^2 / 2 has a half"))
        blame(got, mistakes)
        expect_close(got, wanted)


@pytest.mark.exercise("B7.10")
def test_a_gap_that_is_closed_or_never_closes(rng: Random) -> None:
    about.read = CLOSE
    x = positive_number(rng)
    for gap, v, a, wanted, cause in (
        (0.0, -x, 0.0, 0.0, "it touches and closes: now"),
        (-x, -x, 3.0, 0.0, "it is inside, and goes on inwards: now"),
        (0.0, -1e-9, 0.0, 0.0, "it touches and closes, if slowly: now"),
        (2.0, -2.0, 1.0, math.inf, "it only just gets there, and turns round: the root is 0"),
        (0.0, 0.0, -x, 0.0, "it lies there, and is pulled inwards: now"),
        (-1e-18, 0.0, -x, 0.0, "it lies there, and is pulled inwards: now"),
        (x, 1.0, 0.0, math.inf, "it goes away, and nothing pulls it back"),
        (x, 0.0, 0.0, math.inf, "nothing moves"),
        (x, 0.0, 2.0, math.inf, "it is pulled away"),
        (x, 2.0, 3.0, math.inf, "it goes away, and is pulled away"),
        (x, -1.0, 1.0 / x, math.inf, "it turns round before it gets there: the root is negative"),
        (0.0, 0.0, 0.0, math.inf, "it lies there, and nothing pulls it: there is no impact"),
        (0.0, x, 0.0, math.inf, "it leaves"),
        (-x, 0.0, 0.0, math.inf, "it is inside, and stays where it is"),
        (-x, 0.0, 2.0, math.inf, "it is inside, and pulled out"),
        (1.0, -1e-13, 0.0, math.inf, "less than VELOCITY_TOLERANCE against nothing is rounding"),
        (-x, x, 1.0, math.inf, "it leaves, if it takes some time to get out"),
        (0.0, -1e-13, 0.0, math.inf, "less than VELOCITY_TOLERANCE against nothing is rounding"),
    ):
        about(f"time_to_close({gap}, {v}, {a})", cause=cause)
        got = time_to_close(gap, v, a)
        expect_exactly(float(got), wanted)


@pytest.mark.exercise("B7.10")
def test_the_digits_of_a_time_are_kept() -> None:
    about.read = CLOSE
    for a in (-10.0, 10.0):
        about.cause = "2 gap / (sqrt(v v - 2 a gap) - v) keeps its digits: (-v - sqrt(...)) / a "
        about.cause += "takes nearly equal numbers apart, and loses them"
        about.call = f"time_to_close(1e-10, -1000.0, {a})"
        got = time_to_close(1e-10, -1000.0, a)
        # The acceleration changes it by 1e-15 of it.
        expect_close(got, 1e-13, tolerance=1e-22)
