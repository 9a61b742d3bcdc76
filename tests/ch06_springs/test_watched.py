"""A warning when it explodes, build task B6.10."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch06_springs.integrators import watched
from ch06_springs.step_probes import exploding, watching, watching_on
from draw import positive_number
from expect import about, blame, expect_close, expect_error, expect_exactly

READ = "the docstring of watched"
CALL = "step = watched(integrator, speed_limit={}); step(particles, apply_forces, h)"


@pytest.mark.exercise("B6.10")
def test_a_watched_step_does_what_the_step_does(rng: Random) -> None:
    about.read = READ
    frames, limit = rng.randint(2, 5), positive_number(rng, 2.0, 90.0)
    about.call = f"{CALL.format(limit)}, {frames} times, with h = 0.25, 1.25, ..."
    about.cause = (
        "The watched integrator must make the same step as the original. Pass particles, "
        "apply_forces and duration on unchanged, and call the original once per step."
    )
    speeds = [[0.5 * limit, 0.999 * limit, -0.999 * limit]] * frames
    calls, error = watching(limit, speeds)
    at_limit = (
        "You raised an error, although no speed is above the limit. The speed is the magnitude of "
        "the velocity, the square root of the sum of its squared components."
    )
    expect_exactly(error, None, then="; the error that was raised, if any", cause=at_limit)
    wanted = [(3, 0.25 + i) for i in range(frames)]
    expect_exactly(
        [tuple(one) for one in calls],
        wanted,
        then="; number of particles and duration that the integrator gets in each call",
    )


@pytest.mark.exercise("B6.10")
def test_the_first_particle_over_the_limit_is_named(rng: Random) -> None:
    about.read = READ
    limit = positive_number(rng, 2.0, 90.0)
    calm = [0.5 * limit] * 4
    for number, fast in ((1, 0), (1, 3), (3, 2), (6, 1)):
        speeds = [[*calm] for _ in range(6)]
        speeds[number - 1][3] = 2.0 * limit
        speeds[number - 1][fast] = -1.25 * limit
        about.call = (
            f"{CALL.format(limit)}; particles[{fast}] is the first whose speed is too high, "
            f"{1.25 * limit:.6g} m/s after step {number}"
        )
        about.cause = (
            "Check all particles after each step. For the first one that is too fast, raise "
            "SimulationDiverged(index, step, speed, limit), where the steps count from 1."
        )
        calls, error = watching(limit, speeds)
        wanted = (fast, number, 1.25 * limit, limit)
        got = (math.nan,) * 4 if error is None else tuple(error)
        size = 1.25 * limit
        slips = {
            "Your step number is one too small. The first step is number 1, so increase the "
            "counter before you check the speeds.": (fast, number - 1, size, limit),
            "Your particle number is one too large. Particles are numbered from 0, like the "
            "items of a list.": (fast + 1, number, size, limit),
            "Your error reports the last particle that is too fast. Go through the list from "
            "the start, and report the first one that you find.": (3, number, 2.0 * limit, limit),
            "You swapped the speed and the limit. SimulationDiverged takes the speed first and "
            "then the limit.": (fast, number, limit, size),
        }
        blame(got, slips)
        if error is None:
            about.cause = f"You raised no error. {about.cause}"
        elif got[1] > number:
            about.cause = (
                "The step number in your error is too large. Check the speeds right after each "
                "step, and let each watched integrator count its own steps from 1."
            )
        expect_close(
            got,
            wanted,
            then="; (particle, step, speed, limit) of the error, or nan if there was none",
        )
        about.cause = (
            "You raised the error too early or too late. Check the speeds right after each step, "
            "and raise the error before the next step."
        )
        expect_exactly(len(calls), number, then="; number of steps that were made")


@pytest.mark.exercise("B6.10")
def test_a_speed_at_the_limit_is_not_over_it() -> None:
    about(
        "watched(integrator, speed_limit=7.0) with a particle whose velocity is (2, 3, 6) "
        "m/s, so its speed is 7 m/s; ",
        read=READ,
    )
    about.call += "the error that was raised, if any"
    about.cause = (
        "A speed equal to the limit is allowed. Write `not speed <= speed_limit`, which also "
        "detects NaN, while `speed > speed_limit` doesn't."
    )
    _, error = watching(7.0, [[7.0]])
    expect_exactly(error, None)
    about.call = "watched(integrator, speed_limit=1.0) with a particle that moves at 2 m/s after "
    about.call += "the first step; (particle, step) of the error, or nan if there was none"
    about.cause = (
        "A limit of 1 m/s is valid, so watch the integrator as usual. Check the speeds after each "
        "step, whatever the limit is."
    )
    _, error = watching(1.0, [[2.0]])
    got = (math.nan, math.nan) if error is None else tuple(error[:2])
    expect_close(got, (0.0, 1.0))


@pytest.mark.exercise("B6.10")
@pytest.mark.robust
def test_a_speed_that_is_no_number_is_over_every_limit() -> None:
    about.read = READ
    for speed, what in ((math.nan, "NaN"), (math.inf, "infinity"), (-math.inf, "-infinity")):
        about.call = f"{CALL.format(1e300)}; the velocity of particles[1] has {what} along y after "
        about.call += "step 2"
        about.cause = (
            "Every comparison with NaN is False, so `speed > speed_limit` does not detect NaN. "
            "Write `not speed <= speed_limit` instead."
        )
        _, error = watching(1e300, [[1.0, 1.0], [1.0, speed], [1.0, 1.0]])
        got = (math.nan, math.nan) if error is None else tuple(error[:2])
        expect_close(
            got, (1.0, 2.0), then="; (particle, step) of the error, or nan if there was none"
        )


@pytest.mark.exercise("B6.10")
def test_an_explosion_is_told_with_its_step(rng: Random) -> None:
    about.read = READ
    # The first speed over 480 m/s is on the way back, that over the smaller limit is not.
    for limit in (positive_number(rng, 130.0, 470.0), positive_number(rng, 490.0, 950.0)):
        about.call = f"{CALL.format(limit)} with explicit Euler, a spring of 3600 N/m, 1 kg and h "
        about.call += "= 1/60 s, released 1 m away; step, speed and limit of the error"
        about.cause = (
            "The step or the speed in your error is wrong. Compare the speed after each step with "
            "the limit, not the speed before it."
        )
        step, speed, told = exploding(limit)
        number, v, x = 0, 0.0, 1.0
        while abs(v) <= limit:
            x, v = x + v / 60.0, v - 60.0 * x
            number += 1
        wanted = (float(number), abs(v), limit)
        expect_close((step, speed, told), wanted, tolerance=1e-9)


@pytest.mark.exercise("B6.10")
def test_two_watches_count_for_themselves() -> None:
    about.read = READ
    about.call = (
        "two integrators made by watched(integrator, speed_limit=5.0), used one after the other; "
        "a particle of the second one is too fast after its first step"
    )
    about.cause = (
        "Each watched integrator must count its own steps. Keep the count in a variable inside "
        "watched, because both integrators would share a variable of the module."
    )
    watching(5.0, [[1.0]] * 3)
    _, error = watching(5.0, [[9.0]])
    got = (math.nan, math.nan) if error is None else tuple(error[:2])
    expect_close(got, (0.0, 1.0), then="; (particle, step) of the error, or nan if there was none")
    about.call = (
        "watched(integrator, speed_limit=5.0) and then watched(integrator, speed_limit=9.0); a "
        "step of the second one, after which a particle moves at 7 m/s"
    )
    about.cause = (
        "The second integrator allows 9 m/s, and the limit of 5 m/s belongs to the first one. Use "
        "the speed_limit from the same call of watched."
    )
    _, error = watching(9.0, [[7.0]])
    expect_exactly(error, None, then="; the error that was raised, if any")


@pytest.mark.exercise("B6.10")
def test_a_watch_goes_on_after_an_error(rng: Random) -> None:
    about.read = READ
    # Half of the limit is above its square root, so that a squared speed is noticed.
    limit = positive_number(rng, 5.0, 90.0)
    about.call = f"{CALL.format(limit)}; the first step raises ValueError, and after the third and "
    about.call += "the fifth a particle is too fast; the step number in each error, or -1 for the "
    about.call += "ValueError"
    about.cause = (
        "If the integrator raises an exception, let it reach the caller, and don't count that "
        "step. After a SimulationDiverged, the next call goes on counting and checking."
    )
    got = watching_on(limit)
    expect_close(got, (-1.0, 2.0, 4.0))


@pytest.mark.exercise("B6.10")
@pytest.mark.robust
def test_a_watch_needs_a_limit() -> None:
    about(
        cause=(
            "The limit must be positive and finite. Raise ValueError as soon as watched "
            "is called, with the function positive from arguments.py."
        ),
        read=READ,
    )
    for bad in (0.0, -1.0, math.inf, math.nan):
        expect_error(
            lambda bad=bad: watched(print, bad),
            ValueError,
            call=f"watched(integrator, speed_limit={bad})",
            allowed=lambda: watched(print, 1.0),
        )
