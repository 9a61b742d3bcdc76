"""The factors of a motion with drag, build task B4.8."""

from __future__ import annotations

import itertools
import math
from random import Random

import pytest

from ch04_particle_engine import closed_form
from expect import about, blame, cause_of, expect_close

FACTORS = "the docstring of drag_factors"


def by_series(damping: float, time: float) -> tuple[float, float, float]:
    """Return the factors for a small k t, from the power series of fallen."""
    kt = -math.log(damping) * time
    # For k t up to 0.1, the terms (k t)^n / (n + 2)! after the 12th are below the last digit.
    fallen = time * time * math.fsum((-kt) ** n / math.factorial(n + 2) for n in range(12))
    gone = time + math.log(damping) * fallen
    return damping**time, gone, fallen


@pytest.mark.exercise("B4.8", asks="Compute three factors that give the exact motion")
def test_the_factors_are_those_of_the_equation(rng: Random) -> None:
    about.read = FACTORS
    for damping, time in (
        (0.5, 1.0),
        (round(rng.uniform(0.1, 0.3), 3), round(rng.uniform(5.0, 9.0), 3)),  # too long for a series
        (1.5, round(rng.uniform(1.0, 3.0), 3)),  # the formula also holds for a damping above 1
        (0.9999, 3000.0),  # k t decides whether the drag is small, not k
    ):
        about.call = (
            f"drag_factors(damping={damping}, time={time}), which returns (kept, gone, fallen)"
        )
        k = -math.log(damping)
        gone = -math.expm1(-k * time) / k
        wanted = (math.exp(-k * time), gone, (time - gone) / k)
        about.cause = (
            "One of the three factors is wrong. Call the damping d and the time t. Compute the "
            "drag rate k = -ln d, and then kept = d^t, gone = (1 - d^t) / k and fallen = (t - "
            "gone) / k."
        )
        got = closed_form.drag_factors(damping, time)
        size = max(1.0, *wanted)
        undamped = (
            "You ignore the damping, so these are the factors without drag. Compute the drag rate "
            "from it, which is -ln(damping)."
        )
        if damping == 0.9999:
            undamped = (
                "You treat this damping as 1 because it is close to 1. Over such a long time, the "
                "drag still matters. Use the full formulas unless -ln(damping) x time is small."
            )
        if damping == 0.9999:
            few = (
                "Your factors are close, but have fewer than 9 correct digits. If you use a series "
                "for k t = 0.3, add terms to it, or use it only for a smaller k t."
            )
            blame(got, [(wanted, few)], tolerance=0.01)
        ten = k / math.log(10.0)  # a drag rate from log10
        rising = (wanted[0], -gone, (time + gone) / -k)
        drag = 1.0 - damping
        powers = [(kept, (1.0 - kept) / drag) for kept in (damping**time, math.exp(-drag * time))]
        mistakes = [
            *(
                (
                    (kept, gone, (time - gone) / drag),
                    "You compute the drag rate k as 1 - damping. The equation uses k = "
                    "-ln(damping), which is different unless the damping is near 1.",
                )
                for kept, gone in powers
            ),
            (
                (wanted[0], wanted[1], time * time / 2.0),
                "You compute fallen as t^2 / 2, which is right only without drag. With drag it "
                "is (t - gone) / k, where t is the time and k = -ln(damping).",
            ),
            ((1.0, time, time * time / 2.0), undamped),
            *(
                (
                    (kept, (1.0 - kept) / ten, (time - (1.0 - kept) / ten) / ten),
                    "You use math.log10. Use math.log, which is the natural logarithm.",
                )
                for kept in (wanted[0], math.exp(-ten * time))
            ),
            (
                (wanted[0], wanted[1], (time - wanted[0]) / k),
                "Your fallen is (t - kept) / k. It must be (t - gone) / k.",
            ),
            (
                (wanted[0], wanted[1], (time - wanted[1]) / k**2),
                "Your fallen is (t - gone) / k^2. Divide by k only once.",
            ),
            (
                (wanted[0], 1.0 - wanted[0] / k, (time - (1.0 - wanted[0] / k)) / k),
                "Your gone is 1 - d^t / k. Put the difference in parentheses: (1 - d^t) / k.",
            ),
            (
                rising,
                "Your drag rate has the wrong sign. The logarithm of a damping below 1 is "
                "negative, so k = -ln(damping).",
            ),
            (
                (wanted[0], wanted[2], gone),
                "You return the three factors in the wrong order. Return kept, gone and fallen.",
            ),
            (
                (wanted[0], (1.0 - wanted[0]) * k, (time - (1.0 - wanted[0]) * k) * k),
                "You multiply by the drag rate k. Divide by it to get gone and fallen.",
            ),
            (
                (damping * time, (1.0 - damping * time) / k, (time - (1 - damping * time) / k) / k),
                "You compute kept as d times t. Each second keeps the fraction d of the velocity, "
                "so kept is d to the power of t.",
            ),
        ]
        blame(got, mistakes)
        # Nine digits are required. A solution may choose where its series begins and ends.
        expect_close(got, wanted, tolerance=1e-9 * size)


@pytest.mark.exercise("B4.8", asks="At time 0 they are 1, 0 and 0")
def test_dampings_of_0_and_1_and_a_time_of_0(rng: Random) -> None:
    time = round(rng.uniform(1.0, 9.0), 3)
    about.read = FACTORS
    for damping, t, wanted, cause in (
        (
            1.0,
            time,
            (1.0, time, time * time / 2.0),
            "If the damping is 1, the drag rate is 0, so you cannot divide by it. In this case, "
            "return the factors without drag, which are 1, t and t^2 / 2 after a time t.",
        ),
        (
            0.0,
            time,
            (0.0, 0.0, 0.0),
            "Handle a damping of 0 separately, because 0 has no logarithm. The motion stops at "
            "once, so all three factors are 0.",
        ),
        (
            0.5,
            0.0,
            (1.0, 0.0, 0.0),
            "At time 0 nothing has moved yet. Return the factors 1, 0 and 0.",
        ),
        (
            0.0,
            0.0,
            (1.0, 0.0, 0.0),
            "At time 0 nothing has moved yet, even with a damping of 0. Check the time before the "
            "damping, and return the factors 1, 0 and 0.",
        ),
    ):
        about(
            f"drag_factors(damping={damping}, time={t:.6g}), which returns (kept, gone, fallen)",
            cause=cause,
        )
        got = closed_form.drag_factors(damping, t)
        expect_close(got, wanted)


@pytest.mark.exercise("B4.8", asks="must still have at least 9 correct digits")
@pytest.mark.parametrize("away", [1e-13, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2])
def test_the_factors_hold_for_a_damping_near_1(away: float, rng: Random) -> None:
    about.read = FACTORS
    of_gone, of_fallen = (
        f"Your formula for {name} loses digits if the damping d is near 1, because {difference} "
        f"subtracts nearly equal numbers. Use {instead}."
        for name, difference, instead in (
            ("gone", "1 - d^t", "math.expm1 instead"),
            (
                "fallen",
                "t - gone",
                "the first terms of its power series instead, wherever k t is below about 0.001",
            ),
        )
    )
    undamped = (
        "You treat this damping as 1 because it is close to 1. Compute kept as d^t, gone with "
        "math.expm1, and fallen from the first terms of its power series, where d is the damping."
    )
    # The formulas usually lose 1e-8 of short times. Long times show whether drag was ignored.
    for damping, most in itertools.product((1.0 - away, 1.0 + away), (2.0, 2.0, 9.0)):
        t = round(rng.uniform(most - 1.0, most), 3)
        about.call = (
            f"drag_factors(damping=1 {'-' if damping < 1.0 else '+'} {away}, time={t}), which "
            "returns (kept, gone, fallen)"
        )
        got = closed_form.drag_factors(damping, t)
        # A series that is cut early or begins elsewhere may be wrong by up to 1e-9.
        wanted = by_series(damping, t)
        size = wanted[2]
        first_two = got[:2] if isinstance(got, (tuple, list)) else got
        about.cause = of_gone
        blame(first_two, [(wanted[:2], of_fallen)])
        blame(got, [((1.0, t, t * t / 2.0), undamped)])
        third = got[2:] if isinstance(got, (tuple, list)) else ()
        if not cause_of(third, [((size,), "right")], ""):
            turned = (by_series(1.0 / damping, t)[2],)
            sign = (
                "The terms of your series for fallen have the wrong sign. It is t^2 (1/2 - kt/6 + "
                "(kt)^2/24 - ...), where k = -ln(damping)."
            )
            blame(third, [(turned, sign)], tolerance=1e-12)
        expect_close(got, wanted, tolerance=1e-9 * max(1.0, size))


@pytest.mark.exercise("B4.8", asks="limit, and for very short times")
def test_the_factors_hold_for_short_times(rng: Random) -> None:
    about(
        cause="After a very short time, gone and fallen are small but not 0. Check whether your "
        "code rounds a small number, or treats it as 0.",
        read=FACTORS,
    )
    damping = round(rng.uniform(0.3, 0.9), 3)
    for t in (1.0 / 60.0, 1e-6):
        about.call = (
            f"drag_factors(damping={damping}, time={t:.6g}), which returns (kept, gone, fallen)"
        )
        wanted = by_series(damping, t)
        got = closed_form.drag_factors(damping, t)
        # Nine digits are required, of gone and of fallen too.
        expect_close(got, wanted, tolerance=1e-9)
        for words, i, power in (("gone / t", 1, t), ("fallen / t^2", 2, t * t)):
            about.call = f"_, gone, fallen = drag_factors(damping={damping}, time={t:.6g}); {words}"
            expect_close(got[i] / power, wanted[i] / power, tolerance=1e-8)
