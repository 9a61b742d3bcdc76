"""A warning when it explodes, build task B6.10."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random

import pytest

from ch06_springs.step_probes import exploding, watching, watching_on
from draw import positive_number
from expect import (
    ROUNDING,
    about,
    blame,
    expect_close,
    expect_exactly,
    expect_that,
)

READ = "the docstring of watched"
CALL = "step = watched(integrator, speed_limit={}); step(particles, apply_forces, h)"
TOLD = "; the error that step raises"


def in_words(error: Sequence[float] | None) -> str:
    """Describe an error by its particle, and if given, by its step, speed and limit."""
    forms = "particle {}", "step {}", "speed {:.6g} m/s", "limit {:.6g} m/s"
    return "no error" if error is None else ", ".join(map(str.format, forms, error))


def expect_told(error: Sequence[float] | None, wanted: Sequence[float], then: str = TOLD) -> None:
    """Expect an error with these numbers: the particle, the step, the speed and the limit."""
    __tracebackhide__ = True
    told = None if error is None else error[: len(wanted)]
    near = ROUNDING * max(wanted)
    right = told is not None and all(
        type(one) in (int, float) and abs(one - other) <= near
        for one, other in zip(told, wanted, strict=True)
    )
    expect_that(right, in_words(told), in_words(wanted), then=then)


@pytest.mark.exercise("B6.10", asks="calls integrator once, with the same arguments")
def test_a_watched_step_is_the_original_step(rng: Random) -> None:
    about.read = READ
    frames, limit = rng.randint(2, 5), positive_number(rng, 2.0, 90.0)
    about.call = f"no particle is faster than {0.999 * limit:.6g} m/s; {CALL.format(limit)}, "
    about.call += f"{frames} times"
    about.cause = "Return the function itself: return step, without parentheses. In each step, "
    about.cause += "call the original integrator exactly once, with the three arguments unchanged."
    speeds = [[0.5 * limit, 0.999 * limit, -0.999 * limit]] * frames
    calls, error = watching(limit, speeds)
    often = "Your step calls the original integrator more than once, perhaps once for each "
    often += "particle. Call it exactly once in each step, before you check the particles."
    then = "; number of calls of the original integrator"
    expect_that(len(calls) <= frames, f"{len(calls)}", f"at most {frames}", cause=often, then=then)
    about.cause = "You raise an error although no speed is above the limit. The speed is the "
    about.cause += "magnitude of the velocity."
    total = "Your speed is the sum of the three components of the velocity. Use its magnitude, the "
    total += "square root of the sum of their squares."
    squared = "You compare the squared speed with the limit. Take the square root of the sum of "
    squared += "the squared components first."
    mistakes = [(size * limit * 11.0 / 7.0, total) for size in (0.5, 0.999)]  # 2 + 3 + 6 of 7
    mistakes += [((size * limit) ** 2, squared) for size in (0.5, 0.999)]
    if error is not None:
        blame(error[2], mistakes)
    expect_that(error is None, in_words(error), "no error", then=TOLD)
    about.cause = "You don't pass the same arguments to the original integrator. Call it once per "
    about.cause += "step, with particles, apply_forces and duration unchanged."
    wanted = [(3, 0.25 + i) for i in range(frames)]
    expect_exactly(
        [tuple(one) for one in calls],
        wanted,
        then="; the number of particles and the duration that the integrator gets in each call",
    )


@pytest.mark.exercise("B6.10", asks="raises SimulationDiverged for the first particle")
def test_the_error_names_the_first_particle_above_the_limit(rng: Random) -> None:
    about.read = READ
    limit = positive_number(rng, 2.0, 90.0)
    calm = [0.5 * limit] * 4
    for number, fast in ((1, 0), (1, 3), (3, 2), (6, 1)):
        speeds = [[*calm] for _ in range(6)]
        speeds[number - 1][3] = 2.0 * limit
        speeds[number - 1][fast] = -1.25 * limit
        about.call = f"{CALL.format(limit)}, until it raises an error; particles[{fast}] is the "
        about.call += f"first that is too fast, at {1.25 * limit:.6g} m/s after step {number}"
        report = "the first particle that is too fast: its index, the number of the step, its "
        report += "speed and the limit."
        about.cause = f"Raise SimulationDiverged. Report {report}"
        calls, error = watching(limit, speeds)
        about.cause = f"Your error reports the wrong numbers. Report {report}"
        size = 1.25 * limit
        wanted = (fast, number, size, limit)
        slips = {
            "Your step number is one too small. The first step is number 1, so increase the "
            "counter before you check the speeds.": (fast, number - 1, size, limit),
            "Your step number is always 1, because you set the counter to 0 in every step. Set it "
            "to 0 in watched, outside of step, and declare it nonlocal in step.": (
                fast,
                1 if number > 2 else 0,
                size,
                limit,
            ),
            "Your particle number is one too large. Particles are numbered from 0, like the "
            "items of a list.": (fast + 1, number, size, limit),
            "Your error reports the last particle that is too fast. Go through the list from "
            "the start, and report the first one that you find.": (3, number, 2.0 * limit, limit),
            "You swapped the speed and the limit. SimulationDiverged takes the speed first and "
            "then the limit.": (fast, number, limit, size),
            "Your step number is one too large. Count the steps from 1, and check the speeds after "
            "you call the integrator.": (fast, number + 1, size, limit),
        }
        if error is None:
            about.cause = (
                f"Your step checks some particles, but not particles[{fast}]. Check the speed of "
                "every particle in the list after each step."
                if fast
                else "Your step raises no error although a particle is too fast. After each step, "
                "compare the magnitude of every velocity with speed_limit."
            )
        elif error[3] == limit and isinstance(error[1], int) and error[1] > number + 1:
            about.cause = "Your step number also counts the steps of other watched integrators. "
            about.cause += "Let each watched integrator count its own steps from 1."
        else:
            blame(tuple(error), slips)
        expect_told(error, wanted)
        about.cause = "You raised the error too early or too late. Check the speeds right after "
        about.cause += "each step, and raise the error before the next step."
        expect_exactly(len(calls), number, then="; number of steps that were made")


@pytest.mark.exercise("B6.10", asks="whose speed is NaN or above speed_limit")
def test_a_speed_equal_to_the_limit_is_allowed() -> None:
    about.call = f"{CALL.format(7.0)}; the particle has the velocity (2, 3, 6) m/s, so its speed "
    about.call += "is 7 m/s"
    about.read = READ
    about.cause = "You raise an error for a speed equal to the limit, which is still allowed. "
    about.cause += "Write `not speed <= speed_limit`."
    _, error = watching(7.0, [[7.0]])
    expect_that(error is None, in_words(error), "no error", then=TOLD)
    about.call = f"{CALL.format(1.0)}; the particle moves at 2 m/s after the first step"
    about.cause = "A limit of 1 m/s is valid, so watch the integrator as usual. Check the speeds "
    about.cause += "after each step, whatever the limit is."
    _, error = watching(1.0, [[2.0]])
    expect_told(error, (0.0, 1.0))


@pytest.mark.exercise("B6.10", asks="whose speed is NaN or above speed_limit")
@pytest.mark.robust
def test_a_speed_of_nan_is_above_every_limit() -> None:
    about.read = READ
    for speed, what in ((math.nan, "NaN"), (math.inf, "infinity"), (-math.inf, "-infinity")):
        about.call = f"{CALL.format(1e300)}, three times; the velocity of particles[1] has {what} "
        about.call += "along y after step 2"
        about.cause = "Every comparison with NaN is False, so `speed > speed_limit` does not "
        about.cause += "detect NaN. Write `not speed <= speed_limit` instead."
        _, error = watching(1e300, [[1.0, 1.0], [1.0, speed], [1.0, 1.0]])
        expect_told(error, (1, 2))


@pytest.mark.exercise("B6.10", asks="after which the particle was too fast")
def test_an_explosion_is_reported_with_its_step(rng: Random) -> None:
    about.read = READ
    # The first speed over 480 m/s is on the way back, that over the smaller limit is not.
    for limit in (positive_number(rng, 130.0, 470.0), positive_number(rng, 490.0, 950.0)):
        about.call = f"{CALL.format(limit)} with explicit Euler, a spring of 3600 N/m, 1 kg and h "
        about.call += "= 1/60 s, released 1 m away; the step, the speed in m/s and the limit in "
        about.call += "m/s of the error"
        about.cause = "The step or the speed in your error is wrong. Compare the speed that a "
        about.cause += "particle has after each step with the limit, not the one before it."
        step, speed, told = exploding(limit)
        number, v, x = 0, 0.0, 1.0
        while abs(v) <= limit:
            x, v = x + v / 60.0, v - 60.0 * x
            number += 1
        wanted = (float(number), abs(v), limit)
        expect_close((step, speed, told), wanted, tolerance=1e-9)


@pytest.mark.exercise("B6.10", asks="It counts its own steps")
def test_two_watched_integrators_count_separately() -> None:
    about.read = READ
    about.call = "two integrators made by watched(integrator, speed_limit=5.0), used one after the "
    about.call += "other; a particle of the second one is too fast after its first step"
    about.cause = "Each watched integrator must count its own steps. Keep the count in a variable "
    about.cause += "inside watched, because both integrators would share a variable of the module."
    watching(5.0, [[1.0]] * 3)
    _, error = watching(5.0, [[9.0]])
    expect_told(error, (0, 1), then="; the error that it raises")
    about.call = "watched(integrator, speed_limit=5.0) and then watched(integrator, "
    about.call += "speed_limit=9.0); a step of the second one, after which a particle moves at 7 "
    about.call += "m/s"
    about.cause = "The second integrator allows 9 m/s, and the limit of 5 m/s belongs to the first "
    about.cause += "one. Use the speed_limit from the same call of watched."
    _, error = watching(9.0, [[7.0]])
    expect_that(error is None, in_words(error), "no error", then="; the error that it raises")


@pytest.mark.exercise("B6.10", asks="It can be called again after that, and goes on counting.")
def test_watched_goes_on_after_an_error(rng: Random) -> None:
    about.read = READ
    # Half of the limit is above its square root, so that a squared speed is noticed.
    limit = positive_number(rng, 5.0, 90.0)
    about.call = f"{CALL.format(limit)}; the first step raises ValueError, and after the third and "
    about.call += "the fifth a particle is too fast; the step number in each error, or -1 for the "
    about.call += "ValueError"
    about.cause = "If the integrator raises an exception, let it reach the caller, and don't count "
    about.cause += "that step. After a SimulationDiverged, the next call must continue counting "
    about.cause += "and checking."
    got = watching_on(limit)
    caught = "You catch the exception of the integrator, so the caller never learns about it. Let "
    caught += "it pass, and don't count that step."
    slips = {
        "You count the step in which the integrator raised an exception. Count a step only after "
        "the call of the integrator.": (-1.0, 3.0, 5.0),
        "You count from the start again after a SimulationDiverged. Keep the count.": (-1, 2, 2),
        "After a SimulationDiverged, your step no longer checks the speeds. Check them in each "
        "call.": (-1.0, 2.0),
    }
    blame(got, slips)
    blame(got, [((3.0, 5.0), caught), ((2.0, 4.0), caught)])
    expect_close(got, (-1.0, 2.0, 4.0))
