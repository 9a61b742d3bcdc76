"""A warning when it explodes, build task B6.10."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random

import pytest

from calls import calls
from ch06_springs.step_probes import exploding, watching, watching_on
from draw import positive_number
from expect import ROUNDING, expect_close, expect_exactly, expect_that, named

READ = "the docstring of watched"
CALL = "step = watched(integrator, speed_limit={}); step(particles, apply_forces, h)"
TOLD = "; the error that step raises"


def in_words(error: Sequence[float] | None) -> str:
    """Describe an error by its particle, and if given, by its step, speed and limit."""
    forms = "particle {}", "step {}", "speed {:.6g} m/s", "limit {:.6g} m/s"
    return "no error" if error is None else ", ".join(map(str.format, forms, error))


def expect_told(error: Sequence[float] | None, wanted: Sequence[float] | None, cause: str) -> None:
    """Expect an error with these numbers, the particle, the step, the speed and the limit, or none.

    Of the four numbers, only as many count as are wanted.
    """
    __tracebackhide__ = True
    told = error if error is None or wanted is None else error[: len(wanted)]
    right = told is wanted or (
        None not in (told, wanted)
        and all(
            type(one) in (int, float) and abs(one - other) <= ROUNDING * max(wanted)
            for one, other in zip(told, wanted, strict=True)
        )
    )
    expect_that(right, in_words(told), in_words(wanted), then=TOLD, cause=cause)


@pytest.mark.exercise("B6.10", asks="calls integrator once, with the same arguments", read=READ)
def test_a_watched_step_is_the_original_step(rng: Random) -> None:
    frames, limit = rng.randint(2, 5), positive_number(rng, 2.0, 90.0)
    with calls(
        "Return the function itself: return step, without parentheses. In each step, call the "
        "original integrator exactly once, with the three arguments unchanged.",
        f"no particle is faster than {0.999 * limit:.6g} m/s; {CALL.format(limit)}, {frames} times",
    ):
        asked, error = watching(limit, [[0.5 * limit, 0.999 * limit, -0.999 * limit]] * frames)
    often = "Your step calls the original integrator more than once, perhaps once for each "
    often += "particle. Call it exactly once in each step, before you check the particles."
    then = "; number of calls of the original integrator"
    expect_that(len(asked) <= frames, f"{len(asked)}", f"at most {frames}", cause=often, then=then)
    total = "Your speed is the sum of the three components of the velocity. Use its magnitude, the "
    total += "square root of the sum of their squares."
    squared = "You compare the squared speed with the limit. Take the square root of the sum of "
    squared += "the squared components first."
    cause = "You raise an error although no speed is above the limit. The speed is the magnitude "
    cause += "of the velocity."
    for speed in (0.5 * limit, 0.999 * limit):
        slips = {total: speed * 11.0 / 7.0, squared: speed**2}  # 2 + 3 + 6 of 7
        cause = named(error and error[2], cause, slips)
    expect_told(error, None, cause)
    expect_exactly(
        [tuple(one) for one in asked],
        [(3, 0.25 + i) for i in range(frames)],
        then="; the number of particles and the duration that the integrator gets in each call",
        cause="You don't pass the same arguments to the original integrator. Call it once per "
        "step, with particles, apply_forces and duration unchanged.",
    )


@pytest.mark.exercise("B6.10", asks="raises SimulationDiverged for the first particle", read=READ)
def test_the_error_names_the_first_particle_above_the_limit(rng: Random) -> None:
    limit = positive_number(rng, 2.0, 90.0)
    speed = 1.25 * limit
    report = "Report the first particle that is too fast: its index, the number of the step, its "
    report += "speed and the limit."
    for number, fast in ((1, 0), (1, 3), (3, 2), (6, 1)):
        speeds = [[0.5 * limit] * 4 for _ in range(6)]
        speeds[number - 1][3] = 2.0 * limit
        speeds[number - 1][fast] = -speed
        with calls(
            f"Raise SimulationDiverged. {report}",
            f"{CALL.format(limit)}, until it raises an error; particles[{fast}] is the first that "
            f"is too fast, at {speed:.6g} m/s after step {number}",
        ):
            asked, error = watching(limit, speeds)
        slips = {
            "Your step number is one too small. The first step is number 1, so increase the "
            "counter before you check the speeds.": (fast, number - 1, speed, limit),
            "Your step number is always 1, because you set the counter to 0 in every step. Set it "
            "to 0 in watched, outside of step, and declare it nonlocal in step.":
                (fast, 1 if number > 2 else 0, speed, limit),
            "Your particle number is one too large. Particles are numbered from 0, like the "
            "items of a list.": (fast + 1, number, speed, limit),
            "Your error reports the last particle that is too fast. Go through the list from "
            "the start, and report the first one that you find.": (3, number, 2.0 * limit, limit),
            "You swapped the speed and the limit. SimulationDiverged takes the speed first and "
            "then the limit.": (fast, number, limit, speed),
            "Your step number is one too large. Count the steps from 1, and check the speeds after "
            "you call the integrator.": (fast, number + 1, speed, limit),
        }  # fmt: skip
        if error is None:
            cause = "Your step raises no error although a particle is too fast. After each step, "
            cause += "compare the magnitude of every velocity with speed_limit."
            if fast:
                cause = f"Your step checks some particles, but not particles[{fast}]. Check the "
                cause += "speed of every particle in the list after each step."
        elif error[3] == limit and isinstance(error[1], int) and error[1] > number + 1:
            cause = "Your step number also counts the steps of other watched integrators. Let each "
            cause += "watched integrator count its own steps from 1."
        else:
            wrong = f"Your error reports the wrong numbers. {report}"
            cause = named(tuple(error), wrong, slips)
        expect_told(error, (fast, number, speed, limit), cause)
        cause = "You raised the error too early or too late. Check the speeds right after each "
        cause += "step, and raise the error before the next step."
        expect_exactly(len(asked), number, then="; number of steps that were made", cause=cause)


@pytest.mark.exercise("B6.10", asks="whose speed is NaN or above speed_limit", read=READ)
def test_a_speed_equal_to_the_limit_is_allowed() -> None:
    for limit, speed, wanted, scene, cause in (
        (7.0, 7.0, None,
         "; the particle has the velocity (2, 3, 6) m/s, so its speed is 7 m/s",
         "You raise an error for a speed equal to the limit, which is still allowed. Write `not "
         "speed <= speed_limit`."),
        (1.0, 2.0, (0.0, 1.0),
         "; the particle moves at 2 m/s after the first step",
         "A limit of 1 m/s is valid, so watch the integrator as usual. Check the speeds after each "
         "step, whatever the limit is."),
    ):  # fmt: skip
        with calls(cause, CALL.format(limit) + scene):
            _, error = watching(limit, [[speed]])
        expect_told(error, wanted, cause)


@pytest.mark.exercise("B6.10", asks="whose speed is NaN or above speed_limit", read=READ)
@pytest.mark.robust
def test_a_speed_of_nan_is_above_every_limit() -> None:
    cause = "Every comparison with NaN is False, so `speed > speed_limit` does not detect NaN. "
    cause += "Write `not speed <= speed_limit` instead."
    for speed, what in ((math.nan, "NaN"), (math.inf, "infinity"), (-math.inf, "-infinity")):
        with calls(
            cause,
            f"{CALL.format(1e300)}, three times; the velocity of particles[1] has {what} along y "
            "after step 2",
        ):
            _, error = watching(1e300, [[1.0, 1.0], [1.0, speed], [1.0, 1.0]])
        expect_told(error, (1, 2), cause)


@pytest.mark.exercise("B6.10", asks="after which the particle was too fast", read=READ)
def test_an_explosion_is_reported_with_its_step(rng: Random) -> None:
    # The first speed over 480 m/s is on the way back, that over the smaller limit is not.
    for limit in (positive_number(rng, 130.0, 470.0), positive_number(rng, 490.0, 950.0)):
        with calls(
            "The step or the speed in your error is wrong. Compare the speed that a particle has "
            "after each step with the limit, not the one before it.",
            f"{CALL.format(limit)} with explicit Euler, a spring of 3600 N/m, 1 kg and h = 1/60 s, "
            "released 1 m away; the step, the speed in m/s and the limit in m/s of the error",
        ):
            got = exploding(limit)
        number, v, x = 0, 0.0, 1.0
        while abs(v) <= limit:
            x, v = x + v / 60.0, v - 60.0 * x
            number += 1
        expect_close(got, (float(number), abs(v), limit), tolerance=1e-9)


@pytest.mark.exercise("B6.10", asks="It counts its own steps", read=READ)
def test_two_watched_integrators_count_separately() -> None:
    for limit, speed, wanted, scene, cause in (
        (5.0, 9.0, (0, 1),
         "two integrators made by watched(integrator, speed_limit=5.0), used one after the other; "
         "a particle of the second one is too fast after its first step",
         "Each watched integrator must count its own steps. Keep the count in a variable inside "
         "watched, because both integrators would share a variable of the module."),
        (9.0, 7.0, None,
         "watched(integrator, speed_limit=5.0) and then watched(integrator, speed_limit=9.0); a "
         "step of the second one, after which a particle moves at 7 m/s",
         "The second integrator allows 9 m/s, and the limit of 5 m/s belongs to the first one. Use "
         "the speed_limit from the same call of watched."),
    ):  # fmt: skip
        with calls(cause, scene):
            watching(5.0, [[1.0]] * 3)
            _, error = watching(limit, [[speed]])
        expect_told(error, wanted, cause)


@pytest.mark.exercise(
    "B6.10", asks="It can be called again after that, and goes on counting.", read=READ
)
def test_watched_goes_on_after_an_error(rng: Random) -> None:
    # Half of the limit is above its square root, so that a squared speed is noticed.
    limit = positive_number(rng, 5.0, 90.0)
    with calls(
        "If the integrator raises an exception, let it reach the caller, and don't count that "
        "step. After a SimulationDiverged, the next call must continue counting and checking.",
        f"{CALL.format(limit)}; the first step raises ValueError, and after the third and the "
        "fifth a particle is too fast; the step number in each error, or -1 for the ValueError",
    ):
        got = watching_on(limit)
    caught = "You catch the exception of the integrator, so the caller never learns about it"
    slips = {
        "You count the step in which the integrator raised an exception. Count a step only after "
        "the call of the integrator.": (-1.0, 3.0, 5.0),
        "You count from the start again after a SimulationDiverged.": (-1, 2, 2),
        "After a SimulationDiverged, your step no longer checks the speeds.": (-1.0, 2.0),
        f"{caught}.": (3.0, 5.0),
        f"{caught}, but you don't count its step.": (2.0, 4.0),
    }
    expect_close(got, (-1.0, 2.0, 4.0), slips)
