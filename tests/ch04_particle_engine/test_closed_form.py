"""The factors of a motion with drag, build task B4.8."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from random import Random
from typing import Any

import pytest

from calls import calls
from ch04_particle_engine.closed_form import drag_factors
from expect import about, expect_close, named

FACTORS = "the docstring of drag_factors"


def factors(cause: str, damping: float, time: float, shown: str = "") -> Any:
    """Return the student's factors."""
    with calls(
        cause,
        f"drag_factors(damping={shown or damping}, time={time:.6g}), which returns (kept, gone, "
        "fallen)",
    ):
        return drag_factors(damping, time)


def by_rate(kept: float, k: float, time: float) -> tuple[float, float, float]:
    """Return the factors from what is kept and the drag rate."""
    gone = (1.0 - kept) / k
    return kept, gone, (time - gone) / k


def is_near(got: Any, wanted: Sequence[float], tolerance: float) -> bool:
    """Return whether these are as many numbers as wanted, within a relative tolerance."""
    return (
        isinstance(got, (tuple, list))
        and len(got) == len(wanted)
        and all(isinstance(number, (int, float)) for number in got)
        and math.dist(got, wanted) <= tolerance * max(wanted)
    )


def by_series(damping: float, time: float) -> tuple[float, float, float]:
    """Return the factors for a small k t, from the power series of fallen."""
    kt = -math.log(damping) * time
    # For k t up to 0.1, the terms (k t)^n / (n + 2)! after the 12th are below the last digit.
    fallen = time * time * math.fsum((-kt) ** n / math.factorial(n + 2) for n in range(12))
    gone = time + math.log(damping) * fallen
    return damping**time, gone, fallen


@pytest.mark.exercise("B4.8", asks="Compute three factors that give the exact motion", read=FACTORS)
def test_the_factors_are_those_of_the_equation(rng: Random) -> None:
    for damping, time in (
        (0.5, 1.0),
        (round(rng.uniform(0.1, 0.3), 3), round(rng.uniform(5.0, 9.0), 3)),  # too long for a series
        (1.5, round(rng.uniform(1.0, 3.0), 3)),  # the formula also holds for a damping above 1
        (0.9999, 3000.0),  # k t decides whether the drag is small, not k
    ):
        k = -math.log(damping)
        kept, gone = math.exp(-k * time), -math.expm1(-k * time) / k
        wanted = (kept, gone, (time - gone) / k)
        cause = (
            "One of the three factors is wrong. Call the damping d and the time t. Compute the "
            "drag rate k = -ln d, and then kept = d^t, gone = (1 - d^t) / k and fallen = (t - "
            "gone) / k."
        )
        got = factors(cause, damping, time)
        undamped = (
            "You ignore the damping, which gives the factors without drag. Use k = -ln(damping)."
        )
        if damping == 0.9999:
            undamped = (
                "You treat this damping as 1 because it is close to 1. Over such a long time, the "
                "drag still matters. Use the full formulas unless -ln(damping) x time is small."
            )
            few = (
                "Your factors are close, but have fewer than 9 correct digits. If you use a series "
                "for k t = 0.3, add terms to it, or use it only for a smaller k t."
            )
            cause = few if is_near(got, wanted, 0.01) else cause
        slips = {
            "You compute fallen as t^2 / 2, which is right only without drag. With drag it is (t - "
            "gone) / k, where t is the time and k = -ln(damping).": (kept, gone, time**2 / 2.0),
            undamped: (1.0, time, time**2 / 2.0),
            "Your fallen is (t - kept) / k. It must be (t - gone) / k.":
                (kept, gone, (time - kept) / k),
            "Your fallen is (t - gone) / k^2. Divide by k only once.":
                (kept, gone, (time - gone) / k**2),
            "Your gone is 1 - d^t / k. Put the difference in parentheses: (1 - d^t) / k.":
                (kept, 1.0 - kept / k, (time - 1.0 + kept / k) / k),
            "Your drag rate has the wrong sign. The logarithm of a damping below 1 is negative, so "
            "k = -ln(damping).": (kept, -gone, (time + gone) / -k),
            "You return the three factors in the wrong order. Return kept, gone and fallen.":
                (kept, wanted[2], gone),
            "You multiply by the drag rate k. Divide by it to get gone and fallen.":
                by_rate(kept, 1.0 / k, time),
            "You compute kept as d times t. Each second keeps the fraction d of the velocity, so "
            "kept is d to the power of t.": by_rate(damping * time, k, time),
        }  # fmt: skip
        why = named(got, cause, slips)
        for rate, words in (
            (1.0 - damping,
             "You compute the drag rate k as 1 - damping. The equation uses k = -ln(damping), "
             "which is different unless the damping is near 1."),
            (k / math.log(10.0),
             "You use math.log10. Use math.log, which is the natural logarithm."),
        ):  # fmt: skip
            for start in (kept, math.exp(-rate * time)):
                why = named(got, why, {words: by_rate(start, rate, time)})
        # Nine digits are required. A solution may choose where its series begins and ends.
        tolerance = 1e-9 * max(1.0, *wanted)
        expect_close(got, wanted, tolerance=tolerance, cause=why)


@pytest.mark.exercise("B4.8", asks="At time 0 they are 1, 0 and 0", read=FACTORS)
def test_dampings_of_0_and_1_and_a_time_of_0(rng: Random) -> None:
    time = round(rng.uniform(1.0, 9.0), 3)
    for damping, t, wanted, cause in (
        (1.0, time, (1.0, time, time * time / 2.0),
         "If the damping is 1, the drag rate is 0, so you cannot divide by it. In this case, "
         "return the factors without drag, which are 1, t and t^2 / 2 after a time t."),
        (0.0, time, (0.0, 0.0, 0.0),
         "Handle a damping of 0 separately, because 0 has no logarithm. The motion stops at once, "
         "so all three factors are 0."),
        (0.5, 0.0, (1.0, 0.0, 0.0),
         "At time 0 nothing has moved yet. Return the factors 1, 0 and 0."),
        (0.0, 0.0, (1.0, 0.0, 0.0),
         "At time 0 nothing has moved yet, even with a damping of 0. Check the time before the "
         "damping, and return the factors 1, 0 and 0."),
    ):  # fmt: skip
        expect_close(factors(cause, damping, t), wanted)


@pytest.mark.exercise("B4.8", asks="must still have at least 9 correct digits", read=FACTORS)
@pytest.mark.parametrize("away", [1e-13, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2])
def test_the_factors_hold_for_a_damping_near_1(away: float, rng: Random) -> None:
    loses = "loses digits if the damping d is near 1, because"
    of_gone = (
        f"Your formula for gone {loses} 1 - d^t subtracts nearly equal numbers. Use math.expm1 "
        "instead."
    )
    of_fallen = (
        f"Your formula for fallen {loses} t - gone subtracts nearly equal numbers. Use the first "
        "terms of its power series instead, wherever k t is below about 0.001."
    )
    undamped = (
        "You treat this damping as 1 because it is close to 1. Compute kept as d^t, gone with "
        "math.expm1, and fallen from the first terms of its power series, where d is the damping."
    )
    sign = (
        "The terms of your series for fallen have the wrong sign. It is t^2 (1/2 - kt/6 + "
        "(kt)^2/24 - ...), where k = -ln(damping)."
    )
    # The formulas usually lose 1e-8 of short times. Long times show whether drag was ignored.
    for damping, most in itertools.product((1.0 - away, 1.0 + away), (2.0, 2.0, 9.0)):
        t = round(rng.uniform(most - 1.0, most), 3)
        got = factors(of_gone, damping, t, f"1 {'-' if damping < 1.0 else '+'} {away}")
        # A series that is cut early or begins elsewhere may be wrong by up to 1e-9.
        wanted = by_series(damping, t)
        fallen = wanted[2]
        first_two, third = got, ()
        if isinstance(got, (tuple, list)):
            first_two, third = got[:2], got[2:]
        why = named(first_two, of_gone, {of_fallen: wanted[:2]})
        why = named(got, why, {undamped: (1.0, t, t * t / 2.0)})
        if not is_near(third, [fallen], 1e-9):
            why = sign if is_near(third, by_series(1.0 / damping, t)[2:], 1e-12) else why
        expect_close(got, wanted, tolerance=1e-9 * max(1.0, fallen), cause=why)


@pytest.mark.exercise("B4.8", asks="limit, and for very short times", read=FACTORS)
def test_the_factors_hold_for_short_times(rng: Random) -> None:
    damping = round(rng.uniform(0.3, 0.9), 3)
    for t in (1.0 / 60.0, 1e-6):
        cause = "After a very short time, gone and fallen are small but not 0. Don't round them."
        got, wanted = factors(cause, damping, t), by_series(damping, t)
        # Nine digits are required, of gone and of fallen too.
        expect_close(got, wanted, tolerance=1e-9)
        for words, i, power in (("gone / t", 1, t), ("fallen / t^2", 2, t * t)):
            about(f"_, gone, fallen = drag_factors(damping={damping}, time={t:.6g}); {words}")
            expect_close(got[i] / power, wanted[i] / power, tolerance=1e-8)
