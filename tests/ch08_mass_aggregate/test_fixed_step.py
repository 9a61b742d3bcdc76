"""Frames of one length: B8.3."""

from __future__ import annotations

import math
from itertools import product
from random import Random

import pytest

from ch08_mass_aggregate.probes import advanced, bounced, refused_time
from expect import about, cause_of, expect_close, expect_exactly

READ = "the docstring of FixedStep.advance"
# A step of 2^-6 s adds up without rounding.
STEP = 0.015625


@pytest.mark.exercise("B8.3")
def test_as_many_steps_as_time_has_passed(rng: Random) -> None:
    about.read = READ
    quarters = [rng.randint(0, 40) for _ in range(12)]
    elapsed = [0.25 * STEP * quarter for quarter in quarters]
    about.cause = "add elapsed to left; while that is a step or more, call step(duration) and take "
    about.cause += "the duration off left"
    done = advanced(STEP, elapsed)
    left = 0
    for i, (quarter, row) in enumerate(zip(quarters, done["rows"], strict=True)):
        steps, left = divmod(left + quarter, 4)
        about.call = f"a FixedStep of {STEP} s; advance by {elapsed[: i + 1]} in turn"
        mistakes = [
            (steps + 1, "one too many: what is less than a step is left for the next call"),
            (1, "one step only: make one while there is time for it"),
        ]
        seen = cause_of(row[0], mistakes, about.cause)
        expect_exactly(row[0], steps, then=": the steps that the last call returns", cause=seen)
        mistakes = [((0.0, 0.0), "what is left over is lost: keep it for the next call")]
        seen = cause_of(row[1:], mistakes, about.cause)
        wanted = (0.25 * STEP * left, 0.0)
        expect_close(row[1:], wanted, then=": left and dropped then", cause=seen, tolerance=0.0)
    about.cause = "every step has the same duration, whatever has passed"
    wanted = [STEP] * (sum(quarters) // 4)
    expect_exactly(done["made"], wanted, then=": the steps' durations")


@pytest.mark.exercise("B8.3")
@pytest.mark.parametrize("rate", [50, 60, 100])
def test_rounding_makes_no_step_late(rate: int) -> None:
    about.read = READ
    about.call = f"a FixedStep of 1/{rate} s; advance by 1/{rate}, again and again: steps of each "
    about.call += "call"
    about.cause = "sums are rounded: what lacks less than SHARE of a step is due all the same"
    done = advanced(1.0 / rate, [1.0 / rate] * 100)
    got = [row[0] for row in done["rows"]]
    expect_exactly(got, [1] * 100)
    about.call = f"a FixedStep of 1/{rate} s; advance by half a second, twice, and by a second"
    done = advanced(1.0 / rate, [0.5, 0.5, 1.0])
    got = [row[0] for row in done["rows"]]
    expect_exactly(got, [rate // 2, rate // 2, rate])
    done = advanced(1.0 / rate, [1.0])
    about.call = f"a FixedStep of 1/{rate} s; advance by a second"
    expect_exactly(done["rows"][0][0], rate)
    about.call = f"a FixedStep of 1/{rate} s; advance by a thousandth less than that"
    about.cause = "what lacks more than rounding is not due yet"
    done = advanced(1.0 / rate, [0.999 / rate])
    expect_exactly(done["rows"][0][0], 0)


@pytest.mark.exercise("B8.3")
@pytest.mark.parametrize("duration", [1e-6, STEP, 1000.0])
def test_a_share_of_a_step_is_due(duration: float) -> None:
    about.read = READ
    for lack, steps, cause in (
        (1e-7, 0, "what lacks more than SHARE of a step is not due yet: a part of it, not of 1 s"),
        (1e-10, 1, "what lacks less than SHARE of a step is due: of the step, whatever its length"),
    ):
        about.cause = cause
        elapsed = duration * (1.0 - lack)
        about.call = f"a FixedStep of {duration} s; advance({elapsed!r}): steps, left"
        row = advanced(duration, [elapsed])["rows"][0]
        expect_exactly(row[0], steps)
        left = elapsed - steps * duration
        expect_close(row[1], left, tolerance=1e-9 * duration)


@pytest.mark.exercise("B8.3")
def test_a_limit_of_steps_drops_time(rng: Random) -> None:
    about.read = READ
    limit, late = rng.randint(2, 5), rng.randint(3, 30)
    elapsed = [STEP * (limit + late + 0.25), STEP * (limit + 0.5), STEP * (limit - 1)]
    elapsed.append(STEP * (limit + 1))
    start = f"a FixedStep of {STEP} s, max_steps={limit}; advance by "
    about.cause = "after max_steps the whole steps that are left are added to dropped; less than a "
    about.cause += "step is still left"
    done = advanced(STEP, elapsed, limit)
    wanted = [
        (limit, 0.25 * STEP, STEP * late),
        (limit, 0.75 * STEP, STEP * late),
        (limit - 1, 0.75 * STEP, STEP * late),
        (limit, 0.75 * STEP, STEP * (late + 1)),
    ]
    for i, row in enumerate(done["rows"]):
        about.call = f"{start}{elapsed[: i + 1]} in turn"
        steps, left, dropped = wanted[i]
        seen = cause_of(row[0], [(limit + 1, "one step more than max_steps")], about.cause)
        expect_exactly(row[0], steps, then=": the steps of the last call", cause=seen)
        mistakes = [
            ((0.0, left + dropped), "all that is left is dropped: less than a step stays left"),
            ((left + dropped, 0.0), "nothing is dropped: the next call would make up for it"),
            ((left, dropped / STEP), "dropped is a time in s, and not a number of steps"),
            ((left, STEP), "that is what the last call dropped: dropped adds up"),
        ]
        seen = cause_of(row[1:], mistakes, about.cause)
        expect_close(row[1:], (left, dropped), then=": left, dropped", cause=seen, tolerance=1e-12)
    count = sum(row[0] for row in wanted)
    about.call = f"{start}{elapsed} in turn"
    expect_exactly(len(done["made"]), count, then=": how many steps were made")
    about.call = f"a FixedStep of 0.1 s, max_steps={limit}; advance by {0.1 * (limit + late)!r}"
    about.cause = "a step that rounding makes late is a whole step here as well"
    row = advanced(0.1, [0.1 * (limit + late)], limit)["rows"][0]
    # Rounding of a few times 0.1 s, many times less than a step.
    expect_close(row[1:], (0.0, 0.1 * late), then=": left, dropped", tolerance=1e-9)
    about.cause = "what lacks less than SHARE of a step is dropped with the others, and nothing "
    about.cause += "else is"
    for duration, lack in product((1e-6, STEP, 1000.0), (1e-7, 1e-10)):
        elapsed = duration * (5.0 - lack)
        about.call = f"a FixedStep of {duration} s, max_steps=2; advance({elapsed!r})"
        row = advanced(duration, [elapsed], 2)["rows"][0]
        late = 2.0 if lack > 1e-9 else 3.0
        wanted = (elapsed - (2.0 + late) * duration, late * duration)
        expect_close(row[1:], wanted, then=": left, dropped", tolerance=1e-9 * duration)
    about.call = f"a FixedStep of {STEP} s, no max_steps; advance by 5000 steps"
    about.cause = "None means no limit"
    row = advanced(STEP, [5000.0 * STEP])["rows"][0]
    expect_exactly(row[0], 5000, then=": steps")
    expect_close(row[1:], (0.0, 0.0), then=": left, dropped")


@pytest.mark.exercise("B8.3")
def test_a_step_that_fails_is_still_due(rng: Random) -> None:
    about.read = READ
    good = rng.randint(1, 4)
    about.call = f"a FixedStep of {STEP} s whose step number {good + 1} raises; advance by 6 "
    about.call += "steps, by 0"
    about.cause = "take the time of a step off left after it was made: what it raises comes out, "
    about.cause += "and the step is made anew by the next call"
    done = advanced(STEP, [6.0 * STEP, 0.0], raise_at=good + 1)
    expect_exactly(
        done["rows"][0][0],
        -1,
        then=": what the first call returns, -1 where the step's error comes out",
    )
    got = done["rows"][0][1]
    expect_close(got, (6 - good) * STEP, then=": left after the first call", tolerance=1e-12)
    expect_exactly(done["rows"][1][0], 6 - good, then=": the steps of the second call")


@pytest.mark.exercise("B8.3")
@pytest.mark.robust
def test_a_time_that_is_none_is_refused() -> None:
    about.read = READ
    for time, error in (
        (-0.1, "ValueError"),
        (math.nan, "ValueError"),
        (math.inf, "ValueError"),
        ("0.1", "TypeError"),
    ):
        about.call = f"a FixedStep of {STEP} s with a quarter of a step left; advance({time!r})"
        about.cause = "not_negative() refuses it, before left changes"
        name, left, made = refused_time(STEP, time)
        expect_exactly(name, error, then=": the error, '' for none")
        expect_close(left, 0.25 * STEP, then=": left", tolerance=0.0)
        expect_exactly(made, 0, then=": steps made")
    about.call, about.cause = (
        f"a FixedStep of {STEP} s; advance(0.0)",
        "no time is a time: it makes no step",
    )
    expect_exactly(refused_time(STEP, 0.0)[0], "", then=": the error, '' for none")


@pytest.mark.exercise("B8.3")
def test_a_run_is_the_same_whatever_the_frames(rng: Random) -> None:
    about.read = READ
    even = [4.0 * STEP] * 40
    odd = [STEP * rng.choice((1.0, 2.0, 3.0)) for _ in range(20)] + [0.5, 0.5]
    odd.append(160.0 * STEP - math.fsum(odd))
    about.call = "a ball bounces for 2.5 s in frames of many lengths, two of them of 0.5 s; "
    about.call += f"FixedStep of {STEP} s"
    about.cause = "the step is always the same, and so is all that comes of it"
    place, velocity = bounced(even, STEP)
    about.call += ": place and velocity"
    got = bounced(odd, STEP)
    expect_close(got[0], place, tolerance=0.0)
    expect_close(got[1], velocity, tolerance=0.0)
    # An outer truth: it has moved along X by 1 m/s times 160 steps.
    about.call += ": how far along X"
    expect_close(got[0][0], 160.0 * STEP, tolerance=1e-9)
