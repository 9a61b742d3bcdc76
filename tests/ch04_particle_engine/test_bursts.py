"""All sparks of a burst without steps, build task B4.9."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch04_particle_engine import closed_form, probes
from draw import number
from expect import about, blame, expect_close, expect_that, expect_unchanged

BURST = "the docstring of burst_positions"


@pytest.mark.exercise("B4.9", asks="list in the order of the speeds")
def test_each_spark_is_where_its_own_speed_takes_it(rng: Random) -> None:
    start, a = number(rng), number(rng)
    speeds = [number(rng) for _ in range(5)]
    about.cause = formula = (
        "The position of a spark is start + speed x gone + acceleration x fallen. Return these "
        "positions in the same order as the speeds."
    )
    about.read = BURST
    t = round(rng.uniform(1.0, 3.0), 3)
    about.call = (
        f"speeds = {speeds}; burst_positions({start}, speeds, acceleration={a}, damping=1.0, "
        f"time={t})"
    )
    got = closed_form.burst_positions(start, list(speeds), a, 1.0, t)
    wanted = [start + speed * t + a * t * t / 2.0 for speed in speeds]
    mistakes = [
        (
            [number - start for number in wanted],
            "You leave out the start position. Add start to every result.",
        ),
        (
            [start + speed * t for speed in speeds],
            "You leave out the acceleration. Add acceleration x fallen to every result.",
        ),
        (
            sorted(wanted),
            "You sort the positions. Return them in the same order as the speeds.",
        ),
        (
            [start + speed * t * t / 2.0 + a * t for speed in speeds],
            "You have swapped gone and fallen. Multiply the speed by gone, and the acceleration by "
            "fallen.",
        ),
        (
            [start + speed + a * t * t / 2.0 for speed in speeds],
            "You multiply the speed by kept, the first factor. Multiply it by gone, the second.",
        ),
        (
            [start + speed + a * t for speed in speeds],
            "You use kept and gone as gone and fallen. drag_factors returns the three factors "
            "kept, gone and fallen, in this order.",
        ),
        (
            wanted[:1],
            "You return only the position of the first spark, perhaps because the return statement "
            "is inside the loop. Return a list of all positions.",
        ),
    ]
    blame(got, mistakes)
    if not isinstance(got, (list, tuple)):
        about.cause = "Return a list of the positions, one for each speed."
    expect_close(got, wanted, unit="m", tolerance=1e-12)
    given = probes.speeds_after(start, list(speeds), a, 0.5, t)
    about.cause = (
        "Your function changes the list of speeds, which belongs to the caller. Store the "
        "positions in a new list."
    )
    expect_unchanged("the list of speeds", given, speeds)
    about.cause = formula
    damping = round(rng.uniform(0.2, 0.8), 3)
    k = -math.log(damping)
    gone = -math.expm1(-k * t) / k
    about.call = (
        f"speeds = {speeds}; burst_positions({start}, speeds, acceleration={a}, "
        f"damping={damping}, time={t})"
    )
    got = closed_form.burst_positions(start, list(speeds), a, damping, t)
    undamped = (
        "You ignore the damping, so these are the positions without drag. Use the factors gone and "
        "fallen that drag_factors returns."
    )
    blame(got, [(wanted, undamped)])
    fallen = (t - gone) / k
    wanted = [start + speed * gone + a * fallen for speed in speeds]
    by_time = "You multiply the speed by the time. Multiply it by gone, which is less with drag."
    blame(got, [([start + speed * t + a * fallen for speed in speeds], by_time)])
    expect_close(got, wanted, unit="m", tolerance=1e-11)


@pytest.mark.exercise("B4.9", asks="needs to be computed only once per call")
def test_drag_factors_is_called_once_for_all_sparks() -> None:
    about.call = "burst_positions(...) with 50 speeds; the number of calls to drag_factors"
    about.cause = (
        "You call drag_factors again for each spark, although the factors don't depend on its "
        "speed. Call drag_factors once, before the loop."
    )
    about.read = BURST
    positions, calls = probes.calls_of_drag_factors(1.0, [2.0] * 50, -10.0, 0.5, 1.0)
    expect_that(calls <= 1, f"{calls} calls", "1 call")
    about.cause = "There are 50 speeds, so return a list of 50 positions."
    name = "burst_positions(...) with 50 speeds; the number of positions that it returns"
    expect_close(len(positions), 50, call=name)


@pytest.mark.exercise("B4.9", asks="All sparks start at the same position")
def test_a_burst_begins_at_its_start_and_may_be_empty(rng: Random) -> None:
    start = number(rng)
    about(
        f"burst_positions(start={start}, speeds=[3.0, -4.0], acceleration=-10.0, damping=0.5, "
        "time=0.0)",
        read=BURST,
    )
    about.cause = "At time 0 no spark has moved yet. Return the start position for each of them."
    got = closed_form.burst_positions(start, [3.0, -4.0], -10.0, 0.5, 0.0)
    expect_close(got, [start, start])
    about.call = (
        f"len(burst_positions(start={start}, speeds=[], acceleration=-10.0, damping=0.5, time=1.0))"
    )
    about.cause = "If there are no speeds, there are no sparks, so return an empty list."
    got = len(closed_form.burst_positions(start, [], -10.0, 0.5, 1.0))
    expect_close(got, 0)
