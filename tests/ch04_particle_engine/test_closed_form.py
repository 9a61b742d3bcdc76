"""Motion with drag in closed form: its factors, B4.8, and all sparks of a burst, B4.9."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from random import Random
from typing import Any

import pytest

from calls import calls
from ch04_particle_engine import probes
from ch04_particle_engine.closed_form import burst_positions, drag_factors
from draw import number
from expect import about, expect_close, expect_that, expect_unchanged, named

FACTORS, BURST = "the docstring of drag_factors", "the docstring of burst_positions"


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
            "You ignore the damping, so these factors are without drag. Use k = -ln(damping)."
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


@pytest.mark.exercise("B4.9", asks="list in the order of the speeds", read=BURST)
def test_each_spark_is_where_its_own_speed_takes_it(rng: Random) -> None:
    start, a, speeds = number(rng), number(rng), [number(rng) for _ in range(5)]
    t, damping = round(rng.uniform(1.0, 3.0), 3), round(rng.uniform(0.2, 0.8), 3)

    def positions(of_speed: float, of_acceleration: float) -> list[float]:
        return [start + speed * of_speed + a * of_acceleration for speed in speeds]

    cause = (
        "The position of a spark is start + speed x gone + acceleration x fallen. Return these "
        "positions in the same order as the speeds."
    )
    with calls(cause):
        got = burst_positions(start, [*speeds], acceleration=a, damping=1.0, time=t)
    undamped = positions(t, t * t / 2.0)
    slips = {
        "You leave out the start position. Add start to every result.":
            [position - start for position in undamped],
        "You leave out the acceleration. Add acceleration x fallen to every result.":
            positions(t, 0.0),
        "You sort the positions. Return them in the same order as the speeds.": sorted(undamped),
        "You have swapped gone and fallen. Multiply the speed by gone, and the acceleration by "
        "fallen.": positions(t * t / 2.0, t),
        "You multiply the speed by kept, the first factor. Multiply it by gone, the second.":
            positions(1.0, t * t / 2.0),
        "You use kept and gone as gone and fallen. drag_factors returns the three factors kept, "
        "gone and fallen, in this order.": positions(1.0, t),
        "You return only the position of the first spark, perhaps because the return statement is "
        "inside the loop. Return a list of all positions.": undamped[:1],
    }  # fmt: skip
    if not isinstance(got, (list, tuple)):
        cause = "Return a list of the positions, one for each speed."
    expect_close(got, undamped, slips, unit="m", tolerance=1e-12, cause=cause)
    mine = "Your function changes the list of speeds. Store the positions in a new list."
    _, given, _ = probes.burst_counted(start, [*speeds], a, 0.5, t)
    expect_unchanged("the list of speeds", given, speeds, cause=mine)
    k = -math.log(damping)
    gone = -math.expm1(-k * t) / k
    fallen = (t - gone) / k
    with calls(cause):
        got = burst_positions(start, [*speeds], acceleration=a, damping=damping, time=t)
    slips = {
        "You ignore the damping, so these are the positions without drag. Use the factors gone and "
        "fallen that drag_factors returns.": undamped,
        "You multiply the speed by the time. Multiply it by gone, which is less with drag.":
            positions(t, fallen),
    }  # fmt: skip
    expect_close(got, positions(gone, fallen), slips, unit="m", tolerance=1e-11)


@pytest.mark.exercise("B4.9", asks="needs to be computed only once per call", read=BURST)
def test_drag_factors_is_called_once_for_all_sparks() -> None:
    with calls(
        "You call drag_factors again for each spark, although the factors don't depend on its "
        "speed. Call drag_factors once, before the loop.",
        "burst_positions(...) with 50 speeds",
    ):
        positions, _, count = probes.burst_counted(1.0, [2.0] * 50, -10.0, 0.5, 1.0)
    then = "; the number of calls to drag_factors"
    expect_that(count <= 1, f"{count} calls", "1 call", then=then)
    then, cause = "; the number of positions", "There are 50 speeds, so return 50 positions."
    expect_close(len(positions), 50, then=then, cause=cause)


@pytest.mark.exercise("B4.9", asks="All sparks start at the same position", read=BURST)
def test_a_burst_begins_at_its_start_and_may_be_empty(rng: Random) -> None:
    start = number(rng)
    with calls("At time 0 no spark has moved yet. Return the start position for each of them."):
        got = burst_positions(start, [3.0, -4.0], acceleration=-10.0, damping=0.5, time=0.0)
    expect_close(got, [start, start])
    with calls("If there are no speeds, there are no sparks, so return an empty list."):
        got = len(burst_positions(start, [], acceleration=-10.0, damping=0.5, time=1.0))
    expect_close(got, 0)
