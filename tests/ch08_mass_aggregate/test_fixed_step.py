"""A fixed time step with an accumulator: B8.3."""

from __future__ import annotations

import math
from itertools import product
from random import Random

import pytest

from ch08_mass_aggregate.probes import advanced, bounced, refused_time
from expect import about, cause_of, expect_close, expect_exactly, expect_that

READ = "the docstring of FixedStep.advance"
# Multiples of 2^-6 s add up without rounding.
STEP = 0.015625


@pytest.mark.exercise("B8.3", asks="Time that is too short for a whole step")
def test_as_many_steps_as_time_has_passed(rng: Random) -> None:
    about.read = READ
    quarters = [rng.randint(0, 40) for _ in range(12)]
    elapsed = [0.25 * STEP * quarter for quarter in quarters]
    about.cause = "Add elapsed to self.left. As long as self.left is enough for a step, call "
    about.cause += "self.step(self.duration) and subtract the duration."
    done = advanced(STEP, elapsed)
    left = 0
    for quarter, row in zip(quarters, done["rows"], strict=True):
        about.call = (
            f"a FixedStep clock with steps of {STEP} s and left = {0.25 * STEP * left:g} s; "
            f"clock.advance({0.25 * quarter:g} * {STEP})"
        )
        before, (steps, left) = left, divmod(left + quarter, 4)
        one = (
            "You take only one step, although enough time has passed for more. Keep taking steps "
            "as long as self.left is enough for another one. A return in the loop ends it."
        )
        if any(type(time) is float and time > STEP for time in done["made"]):
            one = (
                "You take a single step for all of the elapsed time. Take steps of self.duration "
                "instead, as long as self.left is enough for another one."
            )
        early = (
            f"You take a step although only {0.25 * left:g} of its duration is left. Wait until "
            "self.left is enough for a whole step."
        )
        replaced = "You replace self.left by elapsed. Add elapsed to it, so that the time that was "
        replaced += "left counts too."
        alone = before > 0 and tuple(row[:2]) == (quarter // 4, 0.25 * STEP * (quarter % 4))
        late = "Exactly enough time for one more step is left. Take a step as soon as self.left >= "
        late += "self.duration * (1.0 - SHARE)."
        mistakes = [(steps + 1, early), (1, one)]
        if row[1] == STEP:
            mistakes.insert(0, (steps - 1, late))
        seen = replaced if alone else cause_of(row[0], mistakes, about.cause)
        expect_that(
            row[0] is not None,
            "nothing (None)",
            f"{steps} steps",
            then="; the return value",
            cause="advance returns nothing. Return the number of steps that it took.",
        )
        expect_exactly(row[0], steps, then="; the return value", unit="steps", cause=seen)
        other = "self.left is wrong. Add elapsed to it, and subtract the duration of each step."
        lost = "You lose the leftover time, which is shorter than a step. Keep it in self.left for "
        lost += "the next call."
        seen = replaced if alone else cause_of(row[1], [(0.0, lost)], other)
        wanted = 0.25 * STEP * left
        expect_close(row[1], wanted, then="; clock.left", unit="s", cause=seen, tolerance=0.0)
        seen = (
            "self.dropped changes, although max_steps is None. Drop time only if max_steps is not "
            "None."
        )
        expect_close(row[2], 0.0, then="; clock.dropped", unit="s", cause=seen, tolerance=0.0)
    about.cause = "Every step has the same duration, no matter how much time has passed. Pass "
    about.cause += "self.duration to self.step."
    different = sorted(set(done["made"]))
    expect_exactly(different, [STEP], then="; the different durations of all steps")
    name = "; the number of calls to self.step so far"
    expect_exactly(len(done["made"]), sum(quarters) // 4, then=name, unit="calls")


@pytest.mark.exercise("B8.3", asks="sixty frames of 1/60 s give exactly sixty steps")
@pytest.mark.parametrize("rate", [50, 60, 100])
def test_rounding_does_not_delay_a_step(rate: int) -> None:
    about.read = READ
    about.call = (
        f"a FixedStep clock with steps of 1/{rate} s; clock.advance(1/{rate}) a hundred times"
    )
    about.cause = "Rounding made self.left slightly too small, so you skip a step that is due. "
    about.cause += "Take a step as soon as self.left >= self.duration * (1.0 - SHARE)."
    done = advanced(1.0 / rate, [1.0 / rate] * 100)
    for i, row in enumerate(done["rows"], 1):
        expect_exactly(row[0], 1, then=f"; the number of steps in call {i}", unit="steps")
    about.call = (
        f"a FixedStep clock with steps of 1/{rate} s; clock.advance(0.5), clock.advance(0.5) and "
        "clock.advance(1); the number of steps in each call"
    )
    done = advanced(1.0 / rate, [0.5, 0.5, 1.0])
    got = [row[0] for row in done["rows"]]
    expect_exactly(got, [rate // 2, rate // 2, rate])
    done = advanced(1.0 / rate, [1.0])
    about.call = f"a FixedStep clock with steps of 1/{rate} s; clock.advance(1); the number of "
    about.call += "steps"
    expect_exactly(done["rows"][0][0], rate)
    about.call = f"a FixedStep clock with steps of 1/{rate} s; clock.advance(0.999/{rate}); the "
    about.call += "number of steps"
    about.cause = "You take a step although a thousandth of its time is still missing. That is far "
    about.cause += "more than a rounding error, so the step is not due yet."
    done = advanced(1.0 / rate, [0.999 / rate])
    expect_exactly(done["rows"][0][0], 0)


@pytest.mark.exercise("B8.3", asks="at most the fraction SHARE of its duration")
@pytest.mark.parametrize("duration", [1e-6, STEP, 1000.0])
def test_share_is_a_fraction_of_a_step(duration: float) -> None:
    about.read = READ
    for lack, steps, when, cause in (
        (1e-7, 0, "early", "You take a step although more than SHARE of its duration is missing. "
                           "Wait until self.left >= self.duration * (1.0 - SHARE)."),
        (1e-10, 1, "late", "You skip a step although less than SHARE of its duration is missing. "
                           "Take it as soon as self.left >= self.duration * (1.0 - SHARE)."),
    ):  # fmt: skip
        elapsed = duration * (1.0 - lack)
        about(
            f"a FixedStep clock with steps of {duration:g} s; clock.advance({duration:g} * (1 - "
            f"{lack:g}))",
            cause=cause,
        )
        row = advanced(duration, [elapsed])["rows"][0]
        # At this step, a SHARE in seconds does what it should.
        if row[0] != steps == advanced(STEP, [STEP * (1.0 - lack)])["rows"][0][0]:
            about.cause = f"You take a step too {when}, because you use SHARE as a time in "
            about.cause += "seconds. It is a fraction of a step, so multiply it by the duration."
        expect_exactly(row[0], steps, then="; the number of steps", unit="steps")
        left = elapsed - steps * duration
        about.cause = "self.left is wrong. Subtract exactly the duration of each step from it."
        expect_close(row[1], left, then="; clock.left", unit="s", tolerance=1e-9 * duration)


@pytest.mark.exercise("B8.3", asks="skip the steps beyond the limit")
def test_a_limit_of_steps_drops_time(rng: Random) -> None:
    about.read = READ
    limit, late = rng.randint(2, 5), rng.randint(3, 30)
    elapsed = [STEP * (limit + late + 0.25), STEP * (limit + 0.5), STEP * (limit - 1)]
    elapsed.append(STEP * (limit + 1))
    start = f"a FixedStep clock with steps of {STEP} s and max_steps={limit}"
    about.cause = "After max_steps steps, some whole steps may still be due. Subtract their time "
    about.cause += "from self.left, and add it to self.dropped."
    done = advanced(STEP, elapsed, limit)
    wanted = [
        (limit, 0.25 * STEP, STEP * late),
        (limit, 0.75 * STEP, STEP * late),
        (limit - 1, 0.75 * STEP, STEP * late),
        (limit, 0.75 * STEP, STEP * (late + 1)),
    ]
    for i, row in enumerate(done["rows"]):
        start += f"; clock.advance({elapsed[i] / STEP:g} * {STEP})"
        about.call = start
        steps, left, dropped = wanted[i]
        mistakes = [
            (
                limit + 1,
                "You take one step more than max_steps allows. Stop as soon as the number of "
                "steps in this call reaches max_steps.",
            )
        ]  # fmt: skip
        seen = cause_of(row[0], mistakes, about.cause)
        expect_exactly(
            row[0], steps, then="; the number of steps in this call", unit="steps", cause=seen
        )
        mistakes = [
            ((0.0, left + dropped),
             "You drop all of the remaining time. Drop only whole steps, and keep the rest, "
             "which is shorter than a step, in self.left."),
            ((left + dropped, 0.0),
             "You drop no time, although more steps are due than max_steps allows. Move the time "
             "of the extra steps from self.left to self.dropped."),
            ((left, dropped / STEP),
             "self.dropped holds a number of steps, but it should be a time in seconds. Multiply "
             "the number by self.duration."),
            ((left, STEP),
             "self.dropped holds only the time that the last call dropped. Add to it instead of "
             "replacing it, so that it is the total of all calls."),
        ]  # fmt: skip
        seen = cause_of(row[1:], mistakes, about.cause)
        expect_close(
            row[1:],
            (left, dropped),
            then="; (clock.left, clock.dropped)",
            unit="s",
            cause=seen,
            tolerance=1e-12,
        )
    count = sum(row[0] for row in wanted)
    about.call = start
    expect_exactly(
        len(done["made"]), count, then="; the number of steps in all calls together", unit="steps"
    )
    about.call = f"a FixedStep clock with steps of 0.1 s and max_steps={limit}; "
    about.call += f"clock.advance({0.1 * (limit + late):g})"
    about.cause = "Your clock doesn't drop all of the remaining steps. Rounding may make the last "
    about.cause += "one slightly too short, but it still counts as a whole step if less than SHARE "
    about.cause += "of it is missing."
    row = advanced(0.1, [0.1 * (limit + late)], limit)["rows"][0]
    # Rounding of a few times 0.1 s, many times less than a step.
    expect_close(
        row[1:], (0.0, 0.1 * late), then="; (clock.left, clock.dropped)", unit="s", tolerance=1e-9
    )
    for duration, lack in product((1e-6, STEP, 1000.0), (1e-7, 1e-10)):
        elapsed = duration * (5.0 - lack)
        about.call = f"a FixedStep clock with steps of {duration:g} s and max_steps=2; "
        about.call += f"clock.advance({duration:g} * (5 - {lack:g}))"
        row = advanced(duration, [elapsed], 2)["rows"][0]
        late = 2.0 if lack > 1e-9 else 3.0
        wanted = (elapsed - (2.0 + late) * duration, late * duration)
        about.cause = (
            f"You {'keep' if late > 2.0 else 'drop'} the last step. It counts as a whole step if "
            "at most SHARE of its duration is missing."
        )
        # At this step, a SHARE in seconds does what it should.
        other = advanced(STEP, [STEP * (5.0 - lack)], 2)["rows"][0][2]
        if type(other) is float and abs(other - late * STEP) < 1e-9:
            about.cause = (
                f"You {'keep' if late > 2.0 else 'drop'} the last step, because you use SHARE as a "
                "time in seconds. It is a fraction of a step, so multiply it by the duration."
            )
        expect_close(
            row[1:],
            wanted,
            then="; (clock.left, clock.dropped)",
            unit="s",
            tolerance=1e-9 * duration,
        )
    about.call = f"a FixedStep clock with steps of {STEP} s and without max_steps; "
    about.call += f"clock.advance(5000 * {STEP})"
    about.cause = "You limit the number of steps although max_steps is None. Take every step that "
    about.cause += "is due, and drop nothing."
    row = advanced(STEP, [5000.0 * STEP])["rows"][0]
    expect_exactly(row[0], 5000, then="; the number of steps", unit="steps")
    expect_close(row[1:], (0.0, 0.0), then="; (clock.left, clock.dropped)", unit="s")


@pytest.mark.exercise("B8.3", asks="Leave the time of that step in left")
def test_a_step_that_fails_is_still_due(rng: Random) -> None:
    about.read = READ
    good = rng.randint(1, 4)
    about.call = (
        f"a FixedStep clock with steps of {STEP} s; step number {good + 1} raises an error; "
        f"clock.advance(6 * {STEP})"
    )
    about.cause = (
        "You catch the error that self.step raises. Let it propagate, and leave the failed "
        "step's time in self.left."
    )
    done = advanced(STEP, [6.0 * STEP, 0.0], raise_at=good + 1)
    got = done["rows"][0][0]
    if done["rows"][1][0] == -1 or len(done["made"]) < good:
        about.cause = (
            "You take too few steps. Keep taking steps as long as self.left is enough for another "
            "one."
        )
    wanted = f"the error that step number {good + 1} raised"
    expect_that(got == -1, f"no error; the call returned {got}", wanted)
    about.cause = (
        "You subtract the time of a step before you take it, so the time of a failed step is "
        "lost. Subtract it only after self.step has returned."
    )
    got = done["rows"][0][1]
    after = "You subtract the time of all steps after the last one. After an error, the time of "
    after += "the earlier steps is still in self.left, so subtract the duration after each step."
    seen = cause_of(got, [(6.0 * STEP, after)], about.cause)
    name = "; clock.left"
    expect_close(got, (6 - good) * STEP, then=name, unit="s", cause=seen, tolerance=1e-12)
    about.call += "; clock.advance(0); the number of steps"
    about.cause = (
        "Your clock loses steps after an error. Take all steps whose time is still in self.left."
    )
    expect_exactly(done["rows"][1][0], 6 - good, unit="steps")


@pytest.mark.exercise("B8.3", asks="if elapsed is negative or not finite")
@pytest.mark.robust
def test_rejects_an_invalid_time() -> None:
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
            f"The elapsed time is {time!r}. It must be finite and not negative, so raise {error}."
        )
        name, left, made = refused_time(STEP, time)
        expect_that(name == error, name, error)
        lost = "You change self.left before you raise the error. Check elapsed first."
        expect_close(left, 0.25 * STEP, then="; clock.left", unit="s", cause=lost, tolerance=0.0)
        expect_exactly(made, 0, then="; the number of steps that were made", unit="steps")
    about(
        f"a FixedStep clock with steps of {STEP} s; clock.advance(0.0)",
        cause="You reject a time of 0, which is valid. Two frames can have the same timestamp.",
    )
    got = refused_time(STEP, 0.0)[0]
    expect_that(got == "no error", got, "no error")


@pytest.mark.exercise("B8.3", asks="gives the same results on every machine")
def test_a_run_is_the_same_whatever_the_frames(rng: Random) -> None:
    about.read = READ
    even = [4.0 * STEP] * 40
    odd = [STEP * rng.choice((1.0, 2.0, 3.0)) for _ in range(20)] + [0.5, 0.5]
    odd.append(160.0 * STEP - math.fsum(odd))
    about.call = (
        f"a ball that bounces for 2.5 s; a FixedStep clock with steps of {STEP} s moves it; "
        "clock.advance with times from 0.016 to 0.5 s"
    )
    about.cause = (
        "Your ball moves differently when the same 2.5 s are split differently into calls of "
        "advance. In each call, take as many steps as self.left allows."
    )
    place, velocity = bounced(even, STEP)
    got = bounced(odd, STEP)
    expect_close(got[0], place, then="; the position of the ball", unit="m", tolerance=0.0)
    expect_close(got[1], velocity, then="; the velocity of the ball", unit="m/s", tolerance=0.0)
    # A truth from outside: it has moved along X by 1 m/s times 160 steps.
    way = "; the distance that the ball has moved along X, in m"
    expect_close(got[0][0], 160.0 * STEP, then=way, tolerance=1e-9)
