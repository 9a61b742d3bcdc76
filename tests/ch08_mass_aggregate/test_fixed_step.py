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
    about.cause = "Add elapsed to self.left. While self.left is a step or more, call "
    about.cause += "self.step(self.duration) and subtract the duration."
    done = advanced(STEP, elapsed)
    left = 0
    for i, (quarter, row) in enumerate(zip(quarters, done["rows"], strict=True)):
        about.call = f"call {i + 1} of advance of a FixedStep of {STEP} s: advance({elapsed[i]}), "
        about.call += f"while {0.25 * STEP * left} s are left from before"
        steps, left = divmod(left + quarter, 4)
        mistakes = [
            (
                steps + 1,
                "One step too many was made. A time shorter than a step stays in self.left for "
                "the next call.",
            ),
            (1, "Only one step was made. Repeat while there is enough time left."),
        ]
        seen = cause_of(row[0], mistakes, about.cause)
        expect_exactly(row[0], steps, then=": the number of steps that it returns", cause=seen)
        mistakes = [((0.0, 0.0), "The rest of the time is lost. Store it in self.left.")]
        seen = cause_of(row[1:], mistakes, about.cause)
        wanted = (0.25 * STEP * left, 0.0)
        expect_close(row[1:], wanted, then=": left and dropped", cause=seen, tolerance=0.0)
    about.cause = "Every step must have the same duration, however much time has passed."
    wanted = [STEP] * (sum(quarters) // 4)
    expect_exactly(done["made"], wanted, then=": the durations of all steps")


@pytest.mark.exercise("B8.3")
@pytest.mark.parametrize("rate", [50, 60, 100])
def test_rounding_makes_no_step_late(rate: int) -> None:
    about.read = READ
    about.call = f"a FixedStep of 1/{rate} s; advance by 1/{rate}, a hundred times: steps of each "
    about.call += "call"
    about.cause = "Sums of floats are rounded. If less than SHARE of a step is missing, make the "
    about.cause += "step."
    done = advanced(1.0 / rate, [1.0 / rate] * 100)
    got = [row[0] for row in done["rows"]]
    expect_exactly(got, [1] * 100)
    about.call = f"a FixedStep of 1/{rate} s; advance by half a second, twice, and by a second: "
    about.call += "steps of each call"
    done = advanced(1.0 / rate, [0.5, 0.5, 1.0])
    got = [row[0] for row in done["rows"]]
    expect_exactly(got, [rate // 2, rate // 2, rate])
    done = advanced(1.0 / rate, [1.0])
    about.call = f"a FixedStep of 1/{rate} s; advance by a second: steps"
    expect_exactly(done["rows"][0][0], rate)
    about.call = f"a FixedStep of 1/{rate} s; advance by 0.999/{rate} s: steps"
    about.cause = "A thousandth of the step is missing. This is more than rounding, so the step is "
    about.cause += "not due yet."
    done = advanced(1.0 / rate, [0.999 / rate])
    expect_exactly(done["rows"][0][0], 0)


@pytest.mark.exercise("B8.3")
@pytest.mark.parametrize("duration", [1e-6, STEP, 1000.0])
def test_a_share_of_a_step_is_due(duration: float) -> None:
    about.read = READ
    for lack, steps, cause in (
        (1e-7, 0, "The step is not due: more than SHARE of it is missing. SHARE is a fraction of a "
         "step and not a time in s."),
        (1e-10, 1, "The step is due: less than SHARE of it is missing. SHARE is a fraction of a "
         "step and not a time in s."),
    ):  # fmt: skip
        elapsed = duration * (1.0 - lack)
        about(f"a FixedStep of {duration} s; advance({elapsed!r}): steps, left", cause=cause)
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
    about.cause = "After max_steps steps, subtract the time of all remaining whole steps from "
    about.cause += "self.left and add it to self.dropped."
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
        mistakes = [(limit + 1, "One step more than max_steps was made. Stop at max_steps.")]
        seen = cause_of(row[0], mistakes, about.cause)
        expect_exactly(row[0], steps, then=": steps of the last call", cause=seen)
        mistakes = [
            (
                (0.0, left + dropped),
                "All of the time was dropped. Keep the part that is less than a step in self.left.",
            ),
            (
                (left + dropped, 0.0),
                "No time was dropped, so the next call would make up for the missing steps.",
            ),
            (
                (left, dropped / STEP),
                "The attribute dropped is a time in seconds and not a number of steps.",
            ),
            (
                (left, STEP),
                "dropped contains only the time that the last call dropped. Add to dropped "
                "instead of replacing it.",
            ),
        ]
        seen = cause_of(row[1:], mistakes, about.cause)
        expect_close(row[1:], (left, dropped), then=": left, dropped", cause=seen, tolerance=1e-12)
    count = sum(row[0] for row in wanted)
    about.call = f"{start}{elapsed} in turn"
    expect_exactly(len(done["made"]), count, then=": steps made in all")
    about.call = f"a FixedStep of 0.1 s, max_steps={limit}; advance by {0.1 * (limit + late)!r}"
    about.cause = "Here too, a step counts as due if only a rounding error is missing from it."
    row = advanced(0.1, [0.1 * (limit + late)], limit)["rows"][0]
    # Rounding of a few times 0.1 s, many times less than a step.
    expect_close(row[1:], (0.0, 0.1 * late), then=": left, dropped", tolerance=1e-9)
    about.cause = (
        "Drop whole steps and nothing less. A step of which less than SHARE is missing counts as "
        "whole."
    )
    for duration, lack in product((1e-6, STEP, 1000.0), (1e-7, 1e-10)):
        elapsed = duration * (5.0 - lack)
        about.call = f"a FixedStep of {duration} s, max_steps=2; advance({elapsed!r})"
        row = advanced(duration, [elapsed], 2)["rows"][0]
        late = 2.0 if lack > 1e-9 else 3.0
        wanted = (elapsed - (2.0 + late) * duration, late * duration)
        expect_close(row[1:], wanted, then=": left, dropped", tolerance=1e-9 * duration)
    about.call = f"a FixedStep of {STEP} s without max_steps; advance by 5000 steps"
    about.cause = "If max_steps is None, there is no limit."
    row = advanced(STEP, [5000.0 * STEP])["rows"][0]
    expect_exactly(row[0], 5000, then=": steps")
    expect_close(row[1:], (0.0, 0.0), then=": left, dropped")


@pytest.mark.exercise("B8.3")
def test_a_step_that_fails_is_still_due(rng: Random) -> None:
    about.read = READ
    good = rng.randint(1, 4)
    about.call = f"a FixedStep of {STEP} s whose step number {good + 1} raises an error; advance "
    about.call += "by 6 steps, then by 0"
    about.cause = "Let the error of the step pass through, and subtract the time of a step only "
    about.cause += "after it was made. The next call then makes the failed step again."
    done = advanced(STEP, [6.0 * STEP, 0.0], raise_at=good + 1)
    expect_exactly(
        done["rows"][0][0],
        -1,
        then=": what the first call returns (-1 if the error passes through)",
    )
    got = done["rows"][0][1]
    expect_close(got, (6 - good) * STEP, then=": left after the first call", tolerance=1e-12)
    expect_exactly(done["rows"][1][0], 6 - good, then=": steps of the second call")


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
        about.call = f"a FixedStep of {STEP} s with left = {0.25 * STEP}; advance({time!r})"
        about.cause = 'Check elapsed before you change self.left: not_negative("elapsed", elapsed).'
        name, left, made = refused_time(STEP, time)
        expect_exactly(name, error, then=": the error raised ('' is none)")
        lost = (
            "The rest of the time from the call before is lost. A rejected call must not change "
            "self.left."
        )
        expect_close(left, 0.25 * STEP, then=": left", cause=lost, tolerance=0.0)
        expect_exactly(made, 0, then=": steps made")
    about(
        f"a FixedStep of {STEP} s; advance(0.0)",
        cause="A time of 0 is valid, and it makes no step.",
    )
    expect_exactly(refused_time(STEP, 0.0)[0], "", then=": the error raised ('' is none)")


@pytest.mark.exercise("B8.3")
def test_a_run_is_the_same_whatever_the_frames(rng: Random) -> None:
    about.read = READ
    even = [4.0 * STEP] * 40
    odd = [STEP * rng.choice((1.0, 2.0, 3.0)) for _ in range(20)] + [0.5, 0.5]
    odd.append(160.0 * STEP - math.fsum(odd))
    about.call = "a ball bounces for 2.5 s, with elapsed times from 0.016 to 0.5 s; FixedStep of "
    about.call += f"{STEP} s"
    about.cause = "With a fixed time step, the result must not depend on the elapsed times. Repeat "
    about.cause += "steps while self.left is a step or more."
    place, velocity = bounced(even, STEP)
    about.call += ": position and velocity"
    got = bounced(odd, STEP)
    expect_close(got[0], place, tolerance=0.0)
    expect_close(got[1], velocity, tolerance=0.0)
    # A truth from outside: it has moved along X by 1 m/s times 160 steps.
    about.call += ": distance along X"
    expect_close(got[0][0], 160.0 * STEP, tolerance=1e-9)
