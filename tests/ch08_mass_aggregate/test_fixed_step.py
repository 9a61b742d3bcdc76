"""A fixed time step with an accumulator: B8.3."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product
from random import Random
from typing import Any

import pytest

from calls import calls
from ch08_mass_aggregate.fixed_step import FixedStep
from ch08_mass_aggregate.probes import advanced, bounced
from expect import expect_close, expect_error, expect_exactly, expect_that, named

READ = "the docstring of FixedStep.advance"
# Multiples of 2^-6 s add up without rounding.
STEP = 0.015625
LATE = "Take a step as soon as self.left >= self.duration * (1.0 - SHARE)."
FRACTION = "SHARE as a time in seconds. It is a fraction of a step, so multiply it by the duration."
REPEAT = "Keep taking steps as long as self.left is enough for another one."


def clock(
    duration: float, elapsed: Sequence[float], cause: str, limit: int | None = None
) -> tuple[list[float], list[tuple[Any, float, float]]]:
    """Return the durations of all steps, and after each call what it returned, left and dropped."""
    steps = ", ".join(f"{time / duration:.12g}" for time in elapsed)
    made = f"a FixedStep clock with steps of {duration:g} s and max_steps={limit}"
    with calls(cause, f"{made}; clock.advance, with these multiples of a step: {steps}"):
        done = advanced(duration, elapsed, limit)
    return done["made"], done["rows"]


@pytest.mark.exercise("B8.3", asks="Time that is too short for a whole step", read=READ)
def test_as_many_steps_as_time_has_passed(rng: Random) -> None:
    quarters = [rng.randint(0, 40) for _ in range(12)]
    why = "Add elapsed to self.left. While it is enough, call self.step and subtract the duration."
    nothing = "advance returns nothing. Return the number of steps that it took."
    made, rows = clock(STEP, [0.25 * STEP * quarter for quarter in quarters], why)
    left = 0
    for quarter, row in zip(quarters, rows, strict=True):
        text = f"a FixedStep clock with steps of {STEP} s and left = {0.25 * STEP * left:g} s; "
        text += f"clock.advance({0.25 * quarter:g} * {STEP})"
        with calls(why, text):
            before, (steps, left) = left, divmod(left + quarter, 4)
        one = f"You take only one step. {REPEAT} A return in the loop ends it."
        if any(type(time) is float and time > STEP for time in made):
            one = "You take a single step for all of the time. Take steps of self.duration."
        early = f"You take a step although only {0.25 * left:g} of its duration is left."
        late = {f"Exactly enough time for one more step is left. {LATE}": steps - 1}
        slips = (late if row[1] == STEP else {}) | {early: steps + 1, one: 1}
        lost = "You lose the leftover time. Keep it in self.left for the next call."
        count, rest = named(row[0], why, slips), named(row[1], why, {lost: 0.0})
        if before > 0 and tuple(row[:2]) == (quarter // 4, 0.25 * STEP * (quarter % 4)):
            count = rest = "You replace self.left by elapsed. Add elapsed to it."
        wanted, name = f"{steps} steps", "; the return value"
        expect_that(row[0] is not None, "nothing (None)", wanted, then=name, cause=nothing)
        expect_exactly(row[0], steps, then=name, unit="steps", cause=count)
        wanted = 0.25 * STEP * left
        expect_close(row[1], wanted, then="; clock.left", unit="s", cause=rest, tolerance=0.0)
        no_limit = "Drop time only if max_steps is not None."
        expect_close(row[2], 0.0, then="; clock.dropped", unit="s", cause=no_limit, tolerance=0.0)
    same = "Every step has the same duration. Pass self.duration to self.step."
    different = sorted(set(made))
    expect_exactly(different, [STEP], then="; the durations of all steps so far", cause=same)
    name = "; the number of calls to self.step so far"
    expect_exactly(len(made), sum(quarters) // 4, then=name, unit="calls", cause=same)


@pytest.mark.exercise("B8.3", asks="sixty frames of 1/60 s give exactly sixty steps", read=READ)
@pytest.mark.parametrize("rate", [50, 60, 100])
def test_rounding_does_not_delay_a_step(rate: int) -> None:
    skip = "Rounding made self.left slightly too small, so you skip a step that is due. "
    early = "A thousandth of the step is still missing, which is far more than a rounding error."
    for elapsed, wanted, cause in (
        ([1.0 / rate] * 100, [1] * 100, skip + LATE),
        ([0.5, 0.5, 1.0], [rate // 2, rate // 2, rate], skip + LATE),
        ([1.0], [rate], skip + LATE),
        ([0.999 / rate], [0], early),
    ):
        _, rows = clock(1.0 / rate, elapsed, cause)
        expect_exactly([row[0] for row in rows], wanted, then="; the number of steps in each call")


@pytest.mark.exercise("B8.3", asks="at most the fraction SHARE of its duration", read=READ)
@pytest.mark.parametrize("duration", [1e-6, STEP, 1000.0])
def test_share_is_a_fraction_of_a_step(duration: float) -> None:
    for lack, steps, cause in (
        (1e-7, 0, f"You take a step although more than SHARE of its duration is missing. {LATE}"),
        (1e-10, 1, f"You skip a step although less than SHARE of its duration is missing. {LATE}"),
    ):
        elapsed = duration * (1.0 - lack)
        _, ((usual, *_),) = clock(STEP, [STEP * (1.0 - lack)], cause)
        _, ((got, left, _),) = clock(duration, [elapsed], cause)
        if got != steps == usual:  # at the usual step, a SHARE in seconds does what it should
            cause = f"Your step comes too {'late' if steps else 'early'}. You use {FRACTION}"
        expect_exactly(got, steps, then="; the number of steps", unit="steps", cause=cause)
        exact = "self.left is wrong. Subtract exactly the duration of each step from it."
        name, wanted = "; clock.left", elapsed - steps * duration
        expect_close(left, wanted, then=name, unit="s", cause=exact, tolerance=1e-9 * duration)


@pytest.mark.exercise("B8.3", asks="skip the steps beyond the limit", read=READ)
def test_a_limit_of_steps_drops_time(rng: Random) -> None:
    limit, late = rng.randint(2, 5), rng.randint(3, 30)
    elapsed = [STEP * n for n in (limit + late + 0.25, limit + 0.5, limit - 1, limit + 1)]
    why = "After max_steps steps, move the time of all other whole steps to self.dropped."
    for i, (steps, rest, gone) in enumerate((
        (limit, 0.25, late), (limit, 0.75, late), (limit - 1, 0.75, late), (limit, 0.75, late + 1)
    )):  # fmt: skip
        made, rows = clock(STEP, elapsed[: i + 1], why, limit)
        got, *times = rows[-1]
        more = "You take one step more than max_steps allows. Stop as soon as it is reached."
        name = "; the number of steps in the last call"
        cause = named(got, why, {more: limit + 1})
        expect_exactly(got, steps, then=name, unit="steps", cause=cause)
        left, dropped = STEP * rest, STEP * gone
        slips = {
            "You drop all of the remaining time. Drop only whole steps, and keep the rest.":
                (0.0, left + dropped),
            "You drop no time, although more steps are due than max_steps allows.":
                (left + dropped, 0.0),
            "self.dropped holds a number of steps. Multiply it by self.duration.": (left, gone),
            "self.dropped holds only the time that the last call dropped. Add to it instead.":
                (left, STEP),
        }  # fmt: skip
        name = "; (clock.left, clock.dropped)"
        expect_close(times, (left, dropped), slips, then=name, unit="s", tolerance=1e-12)
    total = "; the number of steps in all calls together"
    expect_exactly(len(made), 4 * limit - 1, then=total, unit="steps")
    last = "The last remaining step counts as a whole step if at most SHARE of it is missing."
    _, (row,) = clock(0.1, [0.1 * (limit + late)], last, limit)
    # Rounding of a few times 0.1 s, many times less than a step.
    expect_close(row[1:], (0.0, 0.1 * late), then=name, unit="s", tolerance=1e-9)
    for duration, lack in product((1e-6, STEP, 1000.0), (1e-7, 1e-10)):
        steps, word = (2.0, "drop") if lack > 1e-9 else (3.0, "keep")
        cause = f"You {word} the last step. {last}"
        _, ((*_, usual),) = clock(STEP, [STEP * (5.0 - lack)], cause, 2)
        _, ((_, *times),) = clock(duration, [duration * (5.0 - lack)], cause, 2)
        # At the usual step, a SHARE in seconds does what it should.
        if type(usual) is float and abs(usual - steps * STEP) < 1e-9:
            cause = f"You {word} the last step, because you use {FRACTION}"
        wanted, near = (duration * (3.0 - lack - steps), steps * duration), 1e-9 * duration
        expect_close(times, wanted, then=name, unit="s", cause=cause, tolerance=near)
    unlimited = "You limit the number of steps although max_steps is None. Take every step."
    _, (row,) = clock(STEP, [5000.0 * STEP], unlimited)
    expect_exactly(row[0], 5000, then="; the number of steps", unit="steps")
    expect_close(row[1:], (0.0, 0.0), then=name, unit="s")


@pytest.mark.exercise("B8.3", asks="Leave the time of that step in left", read=READ)
def test_a_step_that_fails_is_still_due(rng: Random) -> None:
    good = rng.randint(1, 4)
    why = "You catch the error that self.step raises. Let it propagate."
    text = f"a FixedStep clock with steps of {STEP} s; step number {good + 1} raises an error; "
    text += f"clock.advance(6 * {STEP})"
    with calls(why, text):
        done = advanced(STEP, [6.0 * STEP, 0.0], raise_at=good + 1)
    (got, left, _), (again, *_) = done["rows"]
    if again == -1 or len(done["made"]) < good:
        why = f"You take too few steps. {REPEAT}"
    wanted = f"the error that step number {good + 1} raised"
    expect_that(got == -1, f"no error; the call returned {got}", wanted, cause=why)
    why = "Subtract the time of a step only after self.step has returned, or it is lost."
    after = "You subtract the time of all steps after the last one. After an error, the time of "
    after += "the earlier steps is still in self.left, so subtract the duration after each step."
    why = named(left, why, {after: 6.0 * STEP})
    wanted = (6 - good) * STEP
    expect_close(left, wanted, then="; clock.left", unit="s", cause=why, tolerance=1e-12)
    why = "Your clock loses steps after an error. Take all steps whose time is still in self.left."
    name = "; clock.advance(0); the number of steps"
    expect_exactly(again, 6 - good, then=name, unit="steps", cause=why)


@pytest.mark.exercise("B8.3", asks="if elapsed is negative or not finite", read=READ)
@pytest.mark.robust
def test_rejects_an_invalid_time() -> None:
    made: list[float] = []
    for time, error in (
        (-0.1, ValueError), (math.nan, ValueError), (math.inf, ValueError), ("0.1", TypeError)
    ):  # fmt: skip
        ticking = FixedStep(made.append, STEP)
        ticking.advance(0.25 * STEP)
        call = f"a FixedStep clock with steps of {STEP} s and left = {0.25 * STEP} s; "
        expect_error(
            lambda ticking=ticking, time=time: ticking.advance(time),
            error,
            allowed=lambda: FixedStep(made.append, STEP).advance(0.0),
            valid=f"{call}clock.advance(0.0)",
            call=f"{call}clock.advance({time!r})",
            cause=f"The elapsed time is {time!r}. It must be finite and not negative, so raise "
            f"{error.__name__}.",
        )
        lost = "You change self.left before you raise the error. Check elapsed first."
        left, name = ticking.left, f"{call}clock.advance({time!r})"
        expect_close(left, 0.25 * STEP, call=f"{name}; clock.left", cause=lost, tolerance=0.0)
        name += "; the number of steps that were made"
        expect_exactly(len(made), 0, call=name, unit="steps", cause=lost)


@pytest.mark.exercise("B8.3", asks="gives the same results on every machine", read=READ)
def test_a_run_is_the_same_whatever_the_frames(rng: Random) -> None:
    odd = [STEP * rng.choice((1.0, 2.0, 3.0)) for _ in range(20)] + [0.5, 0.5]
    odd.append(160.0 * STEP - math.fsum(odd))
    with calls(
        "Your ball moves differently when the same 2.5 s are split differently into calls of "
        "advance. In each call, take as many steps as self.left allows.",
        f"a ball that bounces for 2.5 s; a FixedStep clock with steps of {STEP} s moves it; "
        "clock.advance with times from 0.016 to 0.5 s",
    ):
        place, velocity = bounced([4.0 * STEP] * 40, STEP)
        got = bounced(odd, STEP)
    expect_close(got[0], place, then="; the position of the ball", unit="m", tolerance=0.0)
    expect_close(got[1], velocity, then="; the velocity of the ball", unit="m/s", tolerance=0.0)
    # A truth from outside: it has moved along X by 1 m/s times 160 steps.
    way = "; the distance that the ball has moved along X, in m"
    expect_close(got[0][0], 160.0 * STEP, then=way, tolerance=1e-9)
