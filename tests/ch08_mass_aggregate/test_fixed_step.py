"""A fixed time step with an accumulator: B8.3."""

from __future__ import annotations

import math
from itertools import product
from random import Random

import pytest

from ch08_mass_aggregate.probes import advanced, bounced, refused_time
from expect import about, cause_of, expect_close, expect_exactly

READ = "the docstring of FixedStep.advance"
# Multiples of 2^-6 s add up without rounding.
STEP = 0.015625


@pytest.mark.exercise("B8.3")
def test_as_many_steps_as_time_has_passed(rng: Random) -> None:
    about.read = READ
    quarters = [rng.randint(0, 40) for _ in range(12)]
    elapsed = [0.25 * STEP * quarter for quarter in quarters]
    about.cause = (
        "Add elapsed to self.left. As long as self.left is enough for a step, call "
        "self.step(self.duration) and subtract the duration."
    )
    done = advanced(STEP, elapsed)
    left = 0
    for quarter, row in zip(quarters, done["rows"], strict=True):
        about.call = (
            f"a FixedStep clock with steps of {STEP} s and left = {0.25 * STEP * left:g} s; "
            f"clock.advance({0.25 * quarter:g} * {STEP})"
        )
        steps, left = divmod(left + quarter, 4)
        mistakes = [
            (steps + 1,
             "You make one step too many. Stop when self.left is shorter than a step, and keep it "
             "for the next call."),
            (1, "You make only one step, although enough time has passed for more. Keep stepping "
                "in a loop while self.left is enough for a step."),
        ]  # fmt: skip
        seen = cause_of(row[0], mistakes, about.cause)
        expect_exactly(
            row[0], steps, then=": the number of steps that it returns", unit="steps", cause=seen
        )
        mistakes = [
            (
                (0.0, 0.0),
                "You lose the leftover time, which is shorter than a step. Keep it in self.left "
                "for the next call.",
            )
        ]  # fmt: skip
        seen = cause_of(row[1:], mistakes, about.cause)
        wanted = (0.25 * STEP * left, 0.0)
        expect_close(
            row[1:],
            wanted,
            then=": clock.left and clock.dropped",
            unit="s",
            cause=seen,
            tolerance=0.0,
        )
    about.cause = (
        "Every step has the same duration, no matter how much time has passed. Pass self.duration "
        "to self.step."
    )
    wanted = [STEP] * (sum(quarters) // 4)
    expect_exactly(done["made"], wanted, then=": the durations of all steps")


@pytest.mark.exercise("B8.3")
@pytest.mark.parametrize("rate", [50, 60, 100])
def test_rounding_makes_no_step_late(rate: int) -> None:
    about.read = READ
    about.call = (
        f"a FixedStep clock with steps of 1/{rate} s; clock.advance(1/{rate}) a hundred times: "
        "the number of steps in each call"
    )
    about.cause = (
        "Rounding can leave self.left slightly too small for a step that is due. Take the step if "
        "less than SHARE of its duration is missing."
    )
    done = advanced(1.0 / rate, [1.0 / rate] * 100)
    got = [row[0] for row in done["rows"]]
    expect_exactly(got, [1] * 100)
    about.call = (
        f"a FixedStep clock with steps of 1/{rate} s; clock.advance with 0.5, 0.5 and 1 s: "
        "the number of steps in each call"
    )
    done = advanced(1.0 / rate, [0.5, 0.5, 1.0])
    got = [row[0] for row in done["rows"]]
    expect_exactly(got, [rate // 2, rate // 2, rate])
    done = advanced(1.0 / rate, [1.0])
    about.call = f"a FixedStep clock with steps of 1/{rate} s; clock.advance(1): the number of "
    about.call += "steps"
    expect_exactly(done["rows"][0][0], rate)
    about.call = f"a FixedStep clock with steps of 1/{rate} s; clock.advance(0.999/{rate}): the "
    about.call += "number of steps"
    about.cause = (
        "You make a step although a thousandth of its time is still missing. That is far more than "
        "a rounding error, so the step is not due yet."
    )
    done = advanced(1.0 / rate, [0.999 / rate])
    expect_exactly(done["rows"][0][0], 0)


@pytest.mark.exercise("B8.3")
@pytest.mark.parametrize("duration", [1e-6, STEP, 1000.0])
def test_a_share_of_a_step_is_due(duration: float) -> None:
    about.read = READ
    for lack, steps, cause in (
        (1e-7, 0, "More than SHARE of the step is missing, so the step is not due yet. Multiply "
                  "SHARE by the duration, because it is a fraction of a step, not a time."),
        (1e-10, 1, "Less than SHARE of the step is missing, so the step is due. Multiply SHARE "
                   "by the duration, because it is a fraction of a step, not a time."),
    ):  # fmt: skip
        elapsed = duration * (1.0 - lack)
        about(
            f"a FixedStep clock with steps of {duration:g} s; clock.advance({duration:g} * (1 - "
            f"{lack:g}))",
            cause=cause,
        )
        row = advanced(duration, [elapsed])["rows"][0]
        expect_exactly(row[0], steps, then=": the number of steps", unit="steps")
        left = elapsed - steps * duration
        expect_close(row[1], left, then=": clock.left", unit="s", tolerance=1e-9 * duration)


@pytest.mark.exercise("B8.3")
def test_a_limit_of_steps_drops_time(rng: Random) -> None:
    about.read = READ
    limit, late = rng.randint(2, 5), rng.randint(3, 30)
    elapsed = [STEP * (limit + late + 0.25), STEP * (limit + 0.5), STEP * (limit - 1)]
    elapsed.append(STEP * (limit + 1))
    start = f"a FixedStep clock with steps of {STEP} s and max_steps={limit}; clock.advance(n * "
    start += f"{STEP}) for each n in "
    about.cause = (
        "After max_steps steps, some whole steps may still be due. Subtract their time from "
        "self.left, and add it to self.dropped."
    )
    done = advanced(STEP, elapsed, limit)
    wanted = [
        (limit, 0.25 * STEP, STEP * late),
        (limit, 0.75 * STEP, STEP * late),
        (limit - 1, 0.75 * STEP, STEP * late),
        (limit, 0.75 * STEP, STEP * (late + 1)),
    ]
    for i, row in enumerate(done["rows"]):
        about.call = f"{start}{[time / STEP for time in elapsed[: i + 1]]}"
        steps, left, dropped = wanted[i]
        mistakes = [
            (
                limit + 1,
                "You make one step more than max_steps in this call. Check the count before each "
                "step, and stop as soon as it reaches max_steps.",
            )
        ]  # fmt: skip
        seen = cause_of(row[0], mistakes, about.cause)
        expect_exactly(
            row[0], steps, then=": the number of steps in the last call", unit="steps", cause=seen
        )
        mistakes = [
            ((0.0, left + dropped),
             "You drop all of the remaining time. Drop only whole steps, and keep whatever is "
             "shorter than a step in self.left."),
            ((left + dropped, 0.0),
             "You drop no time, although whole steps are still due after max_steps. Subtract their "
             "time from self.left, and add it to self.dropped."),
            ((left, dropped / STEP),
             "self.dropped holds a number of steps, but it should be a time in seconds. Multiply "
             "the number by self.duration."),
            ((left, STEP),
             "self.dropped holds only the time that the last call dropped. It should be the total "
             "over all calls, so add to it instead of replacing it."),
        ]  # fmt: skip
        seen = cause_of(row[1:], mistakes, about.cause)
        expect_close(
            row[1:],
            (left, dropped),
            then=": clock.left and clock.dropped",
            unit="s",
            cause=seen,
            tolerance=1e-12,
        )
    count = sum(row[0] for row in wanted)
    about.call = f"{start}{[time / STEP for time in elapsed]}"
    expect_exactly(
        len(done["made"]), count, then=": the number of steps in all calls together", unit="steps"
    )
    about.call = f"a FixedStep clock with steps of 0.1 s and max_steps={limit}; "
    about.call += f"clock.advance({0.1 * (limit + late):g})"
    about.cause = (
        "Your clock doesn't drop all of the remaining steps. Rounding can make the last one "
        "slightly too short, but count it as a whole step if less than SHARE of it is missing."
    )
    row = advanced(0.1, [0.1 * (limit + late)], limit)["rows"][0]
    # Rounding of a few times 0.1 s, many times less than a step.
    expect_close(
        row[1:], (0.0, 0.1 * late), then=": clock.left and clock.dropped", unit="s", tolerance=1e-9
    )
    about.cause = (
        "Drop only whole steps, and keep the leftover time in self.left. If less than SHARE of a "
        "step is missing, count it as a whole step."
    )
    for duration, lack in product((1e-6, STEP, 1000.0), (1e-7, 1e-10)):
        elapsed = duration * (5.0 - lack)
        about.call = f"a FixedStep clock with steps of {duration:g} s and max_steps=2; "
        about.call += f"clock.advance({duration:g} * (5 - {lack:g}))"
        row = advanced(duration, [elapsed], 2)["rows"][0]
        late = 2.0 if lack > 1e-9 else 3.0
        wanted = (elapsed - (2.0 + late) * duration, late * duration)
        expect_close(
            row[1:],
            wanted,
            then=": clock.left and clock.dropped",
            unit="s",
            tolerance=1e-9 * duration,
        )
    about.call = f"a FixedStep clock with steps of {STEP} s and without max_steps; clock.advance "
    about.call += "with the time of 5000 steps"
    about.cause = (
        "max_steps is None here, so there is no limit. Take every step that is due and drop "
        "nothing."
    )
    row = advanced(STEP, [5000.0 * STEP])["rows"][0]
    expect_exactly(row[0], 5000, then=": the number of steps", unit="steps")
    expect_close(row[1:], (0.0, 0.0), then=": clock.left and clock.dropped", unit="s")


@pytest.mark.exercise("B8.3")
def test_a_step_that_fails_is_still_due(rng: Random) -> None:
    about.read = READ
    good = rng.randint(1, 4)
    about.call = (
        f"a FixedStep clock with steps of {STEP} s; step number {good + 1} raises an error; "
        "clock.advance is called with the time of 6 steps, and then with 0"
    )
    about.cause = (
        "A step that raises an error is still due, so its time must stay in self.left. Subtract "
        "the duration only after self.step has returned, and let the error through."
    )
    done = advanced(STEP, [6.0 * STEP, 0.0], raise_at=good + 1)
    expect_exactly(
        done["rows"][0][0],
        -1,
        then=": what the first call returns (-1 means that the error comes through)",
    )
    got = done["rows"][0][1]
    expect_close(
        got, (6 - good) * STEP, then=": clock.left after the first call", unit="s", tolerance=1e-12
    )
    expect_exactly(
        done["rows"][1][0], 6 - good, then=": the number of steps in the second call", unit="steps"
    )


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
        about.call = f"a FixedStep clock with steps of {STEP} s and left = {0.25 * STEP} s; "
        about.call += f"clock.advance({time!r})"
        about.cause = (
            "The time elapsed must be finite and not negative. Check it with "
            'not_negative("elapsed", elapsed) before you change self.left.'
        )
        name, left, made = refused_time(STEP, time)
        expect_exactly(name, error, then=": the error that it raises")
        lost = (
            "The call raises an error, but only after it has changed self.left. Check elapsed "
            "before you change self.left."
        )
        expect_close(left, 0.25 * STEP, then=": clock.left", unit="s", cause=lost, tolerance=0.0)
        expect_exactly(made, 0, then=": the number of steps that were made", unit="steps")
    about(
        f"a FixedStep clock with steps of {STEP} s; clock.advance(0.0)",
        cause="A time of 0 is valid, because two frames can have the same timestamp. Make no step, "
        "and don't raise an error.",
    )
    expect_exactly(refused_time(STEP, 0.0)[0], "no error", then=": the error that it raises")


@pytest.mark.exercise("B8.3")
def test_a_run_is_the_same_whatever_the_frames(rng: Random) -> None:
    about.read = READ
    even = [4.0 * STEP] * 40
    odd = [STEP * rng.choice((1.0, 2.0, 3.0)) for _ in range(20)] + [0.5, 0.5]
    odd.append(160.0 * STEP - math.fsum(odd))
    about.call = (
        f"a ball that bounces for 2.5 s; a FixedStep clock with steps of {STEP} s, moves it; "
        "clock.advance with times from 0.016 to 0.5 s"
    )
    about.cause = (
        "Your ball moves differently when the same 2.5 s are divided into other calls of advance. "
        "In each call, make as many steps as self.left allows."
    )
    place, velocity = bounced(even, STEP)
    got = bounced(odd, STEP)
    expect_close(got[0], place, then="; the position of the ball", unit="m", tolerance=0.0)
    expect_close(got[1], velocity, then="; the velocity of the ball", unit="m/s", tolerance=0.0)
    # A truth from outside: it has moved along X by 1 m/s times 160 steps.
    way = "; the distance that the ball has moved along X, in m"
    expect_close(got[0][0], 160.0 * STEP, then=way, tolerance=1e-9)
