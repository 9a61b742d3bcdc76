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
CALL = "step = watched(integrator, {}); step(particles, apply_forces, h)"


@pytest.mark.exercise("B6.10")
def test_a_watched_step_does_what_the_step_does(rng: Random) -> None:
    about.read = READ
    frames, limit = rng.randint(2, 5), positive_number(rng, 2.0, 90.0)
    about.call = f"{CALL.format(limit)}, {frames} times, h = 0.25, 1.25, ..."
    about.cause = (
        "The integrator must be called once per step. Pass particles, apply_forces and duration on "
        "to it unchanged."
    )
    speeds = [[0.5 * limit, 0.999 * limit, -0.999 * limit]] * frames
    calls, error = watching(limit, speeds)
    at_limit = (
        "No speed is over the limit here, so nothing must be raised. The speed of a particle is "
    )
    at_limit += "|v|, the square root of the sum of the squares."
    expect_exactly(
        error, None, then=", speeds at the limit and below: SimulationDiverged", cause=at_limit
    )
    wanted = [(3, 0.25 + i) for i in range(frames)]
    expect_exactly(
        [tuple(one) for one in calls],
        wanted,
        then=": what the integrator gets, how many particles and which duration",
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
        about.call = f"{CALL.format(limit)}; particle {fast} has {1.25 * limit} m/s after step "
        about.call += f"{number}"
        about.cause = (
            "Check every particle after each step, and raise SimulationDiverged(i, steps, speed, "
            "speed_limit) for the first one that is too fast. The first step has the number 1."
        )
        calls, error = watching(limit, speeds)
        wanted = (fast, number, 1.25 * limit, limit)
        got = (math.nan,) * 4 if error is None else tuple(error)
        size = 1.25 * limit
        slips = {
            "The number of the step is one too small. Count the first step as number 1.": (
                fast,
                number - 1,
                size,
                limit,
            ),
            "The index of the particle is one too large. Number the particles from 0, as in the "
            "list.": (fast + 1, number, size, limit),
            "The error reports the last particle that is too fast. Raise it for the first one in "
            "the list.": (
                3,
                number,
                2.0 * limit,
                limit,
            ),
            "The speed and the limit are in the wrong order. Pass the speed of the particle first "
            "and then the limit.": (
                fast,
                number,
                limit,
                size,
            ),
        }
        blame(got, slips)
        if error is None:
            about.cause = f"No error was raised. {about.cause}"
        elif got[1] > number:
            about.cause = (
                "The error was raised in a later step. Check right after each step, and let each "
                "watched integrator count its own steps, from 1."
            )
        expect_close(
            got,
            wanted,
            then=": (particle, step, speed, limit) of the error, nan where none is raised",
        )
        about.cause = "Raise the error right after the step in which a particle is too fast."
        expect_exactly(len(calls), number, then=": how many steps were made")


@pytest.mark.exercise("B6.10")
def test_a_speed_at_the_limit_is_not_over_it() -> None:
    about("watched(integrator, 7.0); a velocity of (2, 3, 6), whose speed is 7: ", read=READ)
    about.call += "SimulationDiverged"
    about.cause = (
        "A speed equal to the limit is allowed. Write `not speed <= speed_limit` instead of `speed "
        "> speed_limit`, so that NaN is refused too."
    )
    _, error = watching(7.0, [[7.0]])
    expect_exactly(error, None)
    about.call = "watched(integrator, 1.0), 2 m/s after the first step: (particle, step) of the "
    about.call += "error, nan where none is raised"
    about.cause = (
        "The speed of 2 m/s is above the limit of 1 m/s. The watched step must raise "
        "SimulationDiverged after the first step."
    )
    _, error = watching(1.0, [[2.0]])
    got = (math.nan, math.nan) if error is None else tuple(error[:2])
    expect_close(got, (0.0, 1.0))


@pytest.mark.exercise("B6.10")
@pytest.mark.robust
def test_a_speed_that_is_no_number_is_over_every_limit() -> None:
    about.read = READ
    for speed, what in ((math.nan, "NaN"), (math.inf, "infinity"), (-math.inf, "-infinity")):
        about.call = f"{CALL.format(1e300)}; the velocity of particle 1 has {what} along y after "
        about.call += "step 2"
        about.cause = (
            "Every comparison with NaN is False, so `speed > speed_limit` does not catch NaN. "
            "Test `not speed <= speed_limit`."
        )
        _, error = watching(1e300, [[1.0, 1.0], [1.0, speed], [1.0, 1.0]])
        got = (math.nan, math.nan) if error is None else tuple(error[:2])
        expect_close(
            got, (1.0, 2.0), then=": (particle, step) of the error, nan where none is raised"
        )


@pytest.mark.exercise("B6.10")
def test_an_explosion_is_told_with_its_step(rng: Random) -> None:
    about.read = READ
    # The first speed over 480 m/s is on the way back, that over the smaller limit is not.
    for limit in (positive_number(rng, 130.0, 470.0), positive_number(rng, 490.0, 950.0)):
        about.call = f"{CALL.format(limit)}; explicit Euler, k = 3600, 1 kg, h = 1/60, from 1 m: "
        about.call += "step and speed"
        about.cause = (
            "Compare the speed after the step. Here k h^2 / m is 1, so each step rotates the state "
            "by 45 degrees and multiplies it by the root of 2."
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
    about.call = "two steps by watched(integrator, 5.0), one after the other; the second is too "
    about.call += "fast at once"
    about.cause = (
        "Each watched step counts its own steps. Keep the counter inside watched(), and not in the "
        "module."
    )
    watching(5.0, [[1.0]] * 3)
    _, error = watching(5.0, [[9.0]])
    got = (math.nan, math.nan) if error is None else tuple(error[:2])
    expect_close(got, (0.0, 1.0), then=": (particle, step) of the error, nan where none is raised")
    about.call = "watched(integrator, 5.0), watched(integrator, 9.0): 7 m/s under the second one"
    about.cause = (
        "Each call of watched() has its own limit, so 7 m/s must be allowed under a limit of 9 "
        "m/s. Do not store the limit in the module."
    )
    _, error = watching(9.0, [[7.0]])
    expect_exactly(error, None, then=": SimulationDiverged")


@pytest.mark.exercise("B6.10")
def test_a_watch_goes_on_after_an_error(rng: Random) -> None:
    about.read = READ
    limit = positive_number(rng, 5.0, 90.0)  # half of it is over its root
    about.call = f"{CALL.format(limit)}; the first step raises ValueError, the third and the fifth "
    about.call += "call end too fast; of each error its step, or -1 for the ValueError"
    about.cause = (
        "Pass on the exceptions of the integrator, and do not count a step that raised one. After "
        "an alarm, continue to count."
    )
    got = watching_on(limit)
    expect_close(got, (-1.0, 2.0, 4.0))


@pytest.mark.exercise("B6.10")
@pytest.mark.robust
def test_a_watch_needs_a_limit() -> None:
    about(
        cause=("Refuse the limit with ValueError when watched() is called. positive() does that."),
        read=READ,
    )
    for bad in (0.0, -1.0, math.inf, math.nan):
        expect_error(
            lambda bad=bad: watched(print, bad),
            ValueError,
            call=f"watched(integrator, {bad})",
            allowed=lambda: watched(print, 1.0),
        )
