"""All sparks of a burst without steps, build task B4.9."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch04_particle_engine import probes
from ch04_particle_engine.closed_form import burst_positions
from draw import number
from expect import expect_close, expect_that, expect_unchanged

BURST = "the docstring of burst_positions"


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
