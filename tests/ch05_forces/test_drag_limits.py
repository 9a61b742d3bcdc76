"""Time steps that are too long for drag, build task B5.8."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch05_forces.closed_form import drag_limits
from ch05_forces.probes import with_drag
from draw import positive_number
from expect import about, expect_close, expect_error, expect_exactly, named

LIMITS = "the docstring of drag_limits"


@pytest.mark.exercise("B5.8")
def test_the_limits_by_their_formula(rng: Random) -> None:
    about.read = LIMITS
    k1, k2, mass, speed = (
        positive_number(rng),
        positive_number(rng),
        positive_number(rng),
        positive_number(rng, 1.0, 90.0),
    )
    about.cause = "A step multiplies the velocity by 1 - (k1 + k2 |v|) h / m. This factor is 0 at "
    about.cause += "the first limit and -1 at the second, so solve for h in both cases."
    for one, two, rate in (
        (k1, 0.0, k1 / mass),
        (0.0, k2, k2 * speed / mass),
        (k1, k2, (k1 + k2 * speed) / mass),
    ):
        about.call = f"drag_limits({one}, {two}, {mass}, {speed})"
        got = drag_limits(one, two, mass, speed)
        wrong = {  # other ways to (k1 + k2 |v|) / m
            "The mass is missing. Drag slows a heavier particle down less, so it tolerates a "
            "longer step. Multiply by the mass.": rate * mass,
            "You divided by the mass. A heavier particle tolerates a longer step, so multiply by "
            "the mass instead.": rate * mass**2,
            "You used k1 + k2. The quadratic drag depends on the speed, so multiply k2 by the "
            "speed.": (one + two) / mass,
            "You multiplied both coefficients by the speed, which is right only for k2.": (
                one + two
            )
            * speed
            / mass,
            "You used k1 + 2 k2 |v|, which is the derivative of the drag. Use the drag divided by "
            "the speed, k1 + k2 |v|.": (one + 2.0 * two * speed) / mass,
        }
        slips = {name: (1.0 / a, 2.0 / a) for name, a in wrong.items()}
        slips["The two limits are swapped. Return the smaller one first."] = (
            2.0 / rate,
            1.0 / rate,
        )
        slips[
            "You returned the first limit twice. At the second limit the factor must be -1 instead "
            "of 0, so that limit is twice as long."
        ] = (1.0 / rate, 1.0 / rate)
        slips["The second limit is the square of the first, but it must be twice the first."] = (
            1.0 / rate,
            rate**-2,
        )
        why = named(got, about.cause, slips)
        expect_close(got, (1.0 / rate, 2.0 / rate), cause=why)
    about.cause = "The drag is small here, but it is not 0. Compute the two limits as usual."
    got = drag_limits(1e-12, 0.0, 1.0, 1.0)
    expect_close(got, (1e12, 2e12), call="drag_limits(1e-12, 0.0, 1.0, 1.0)")
    about(
        f"drag_limits({k1}, {k2}, {mass}, 0.0)",
        cause="The speed is 0, so only k1 counts, and the limits are m / k1 and 2 m / k1.",
    )
    got = drag_limits(k1, k2, mass, 0.0)
    expect_close(got, (mass / k1, 2.0 * mass / k1))


@pytest.mark.exercise("B5.8")
def test_without_drag_no_frame_is_too_long() -> None:
    about.read = LIMITS
    about.cause = "Without drag, every time step is stable. Return math.inf for both limits "
    about.cause += "instead of dividing by 0."
    for arguments in ((0.0, 0.0, 2.0, 5.0), (0.0, 0.5, 2.0, 0.0)):
        about.call = f"[*drag_limits{arguments}]"
        got = [*drag_limits(*arguments)]
        expect_exactly(got, [math.inf, math.inf])
    about.cause = "Here (k1 + k2 |v|) / m is 1 per second, so the limits are 1 s and 2 s."
    got = drag_limits(1.0, 0.5, 2.0, 2.0)
    expect_close(got, (1.0, 2.0), call="drag_limits(1.0, 0.5, 2.0, 2.0)")


@pytest.mark.exercise("B5.8")
def test_the_step_fails_just_beyond_the_limits_and_not_before(rng: Random) -> None:
    about.read = LIMITS
    k1, mass, speed = positive_number(rng), positive_number(rng), positive_number(rng, 5.0, 90.0)
    k2 = round(positive_number(rng, 0.3, 3.0) * k1 / speed, 6)  # both parts of the drag count
    about.call = f"drag_limits({k1}, {k2}, {mass}, {speed})"
    about.cause = "A step multiplies the velocity by 1 - (k1 + k2 |v|) h / m. This factor must be "
    about.cause += "0 at the first limit and -1 at the second."
    first, second = drag_limits(k1, k2, mass, speed)
    for limit, share, wanted, cause in (
        (
            first,
            0.98,
            1,
            "Just below the first limit, a step must slow the particle down without "
            "reversing its motion.",
        ),
        (first, 1.02, -1, "Just above the first limit, a step must reverse the motion."),
        (
            second,
            0.98,
            -1,
            "Just below the second limit, the reversed motion must be slower than before the step.",
        ),
        (
            second,
            1.02,
            -2,
            "Just above the second limit, the reversed motion must be faster than before the step.",
        ),
    ):
        about.cause = cause
        h = limit * share
        name = f"{about.call} = (a, b); a step of {h!r} s with Drag({k1}, {k2}) at {speed} m/s"
        name += ": 1 slower, -1 reversed and slower, -2 reversed and faster"
        _, velocity = with_drag((speed, 0.0, 0.0), k1, k2, mass, h, 1)
        v = velocity[0] / speed
        kind = 1 if 0.0 <= v < 1.0 else -1 if -1.0 <= v < 0.0 else -2 if v < -1.0 else 0
        expect_exactly(kind, wanted, call=name)


@pytest.mark.exercise("B5.8")
@pytest.mark.robust
def test_limits_need_numbers_that_mean_something() -> None:
    about.read = LIMITS
    about.cause = "One of these arguments is out of range, so raise ValueError. Pass each of them "
    about.cause += "to one of the functions in arguments.py, which raise the error for you."
    for bad in (
        (-0.3, 0.05, 2.0, 5.0),
        (0.3, -0.05, 2.0, 5.0),
        (0.3, 0.05, 0.0, 5.0),
        (0.3, 0.05, -2.0, 5.0),
        (0.3, 0.05, 2.0, -5.0),
        (math.nan, 0.05, 2.0, 5.0),
        (0.3, math.inf, 2.0, 5.0),
        (0.3, 0.05, math.inf, 5.0),
        (0.3, 0.05, math.nan, 5.0),
        (0.3, 0.05, 2.0, math.nan),
    ):
        expect_error(
            lambda bad=bad: drag_limits(*bad),
            ValueError,
            call=f"drag_limits{bad}",
            allowed=lambda: drag_limits(0.3, 0.05, 2.0, 5.0),
        )
