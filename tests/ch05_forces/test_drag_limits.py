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
    about.cause = "A step of h seconds multiplies the velocity v by 1 - (k1 + k2 |v|) h / m. "
    about.cause += "Solve for the h at which this factor is 0 (first limit) and -1 (second limit)."
    for one, two, rate in (
        (k1, 0.0, k1 / mass),
        (0.0, k2, k2 * speed / mass),
        (k1, k2, (k1 + k2 * speed) / mass),
    ):
        about.call = f"drag_limits(k1={one}, k2={two}, mass={mass}, speed={speed}); (first limit, "
        about.call += "second limit) in s"
        got = drag_limits(one, two, mass, speed)
        wrong = {  # other ways to (k1 + k2 |v|) / m
            "The mass is missing. A heavier particle tolerates a longer step, so multiply by "
            "the mass.": rate * mass,
            "You divide by the mass. A heavier particle tolerates a longer step, so multiply "
            "by the mass instead.": rate * mass**2,
            "You use k1 + k2 without the speed. The quadratic drag depends on the speed, so "
            "multiply k2 by the speed.": (one + two) / mass,
            "You multiply both k1 and k2 by the speed. Only the quadratic part needs this, so "
            "use k1 + k2 |v|, where |v| is the speed.": (one + two) * speed / mass,
            "You use k1 + 2 k2 |v|, the derivative of the drag. Use the drag divided by the "
            "speed, which is k1 + k2 |v|.": (one + 2.0 * two * speed) / mass,
        }
        slips = {name: (1.0 / a, 2.0 / a) for name, a in wrong.items()}
        slips["You return the two limits in the wrong order. Return the smaller one first."] = (
            2.0 / rate,
            1.0 / rate,
        )
        slips[
            "Your two limits are equal. The first limit stops the particle, and the second "
            "reverses its full velocity, so the second must be twice the first."
        ] = (1.0 / rate, 1.0 / rate)
        slips["Your second limit is the square of the first. It must be twice the first."] = (
            1.0 / rate,
            rate**-2,
        )
        why = named(got, about.cause, slips)
        expect_close(got, (1.0 / rate, 2.0 / rate), cause=why)
    about.cause = "Here the drag is very small, but it is not 0. Compute the two limits as usual."
    got = drag_limits(1e-12, 0.0, 1.0, 1.0)
    expect_close(
        got,
        (1e12, 2e12),
        call="drag_limits(k1=1e-12, k2=0.0, mass=1.0, speed=1.0); (first limit, second limit) in s",
    )
    about(
        f"drag_limits(k1={k1}, k2={k2}, mass={mass}, speed=0.0); (first limit, second limit) in s",
        cause="Here the speed is 0, so only k1 counts. The limits are m / k1 and 2 m / "
        "k1, where m is the mass.",
    )
    got = drag_limits(k1, k2, mass, 0.0)
    expect_close(got, (mass / k1, 2.0 * mass / k1))


@pytest.mark.exercise("B5.8")
def test_without_drag_no_frame_is_too_long() -> None:
    about.read = LIMITS
    about.cause = "Without drag no time step is too long. Return math.inf for both limits instead "
    about.cause += "of dividing by 0."
    for arguments in ((0.0, 0.0, 2.0, 5.0), (0.0, 0.5, 2.0, 0.0)):
        about.call = "drag_limits(k1={}, k2={}, mass={}, speed={}), in s".format(*arguments)
        got = [*drag_limits(*arguments)]
        expect_exactly(got, [math.inf, math.inf])
    about.cause = "Here (k1 + k2 |v|) / m is 1 per second, where |v| is the speed. The limits are "
    about.cause += "therefore 1 s and 2 s."
    got = drag_limits(1.0, 0.5, 2.0, 2.0)
    expect_close(
        got,
        (1.0, 2.0),
        call="drag_limits(k1=1.0, k2=0.5, mass=2.0, speed=2.0); (first limit, second limit) in s",
    )


@pytest.mark.exercise("B5.8")
def test_the_step_fails_just_beyond_the_limits_and_not_before(rng: Random) -> None:
    about.read = LIMITS
    k1, mass, speed = positive_number(rng), positive_number(rng), positive_number(rng, 5.0, 90.0)
    k2 = round(positive_number(rng, 0.3, 3.0) * k1 / speed, 6)  # both parts of the drag count
    about.call = f"drag_limits(k1={k1}, k2={k2}, mass={mass}, speed={speed})"
    about.cause = "A step of h seconds multiplies the velocity v by 1 - (k1 + k2 |v|) h / m. This "
    about.cause += "factor must be 0 at the first limit and -1 at the second."
    first, second = drag_limits(k1, k2, mass, speed)
    for limit, share, wanted, cause in (
        (
            first,
            0.98,
            "slower",
            "A step slightly shorter than your first limit must slow the particle down without "
            "reversing its motion.",
        ),
        (
            first,
            1.02,
            "reversed and slower",
            "A step slightly longer than your first limit must reverse the motion.",
        ),
        (
            second,
            0.98,
            "reversed and slower",
            "After a step slightly shorter than your second limit, the particle must move "
            "backward and slower than before the step.",
        ),
        (
            second,
            1.02,
            "reversed and faster",
            "After a step slightly longer than your second limit, the particle must move "
            "backward and faster than before the step.",
        ),
    ):
        about.cause = cause
        h = limit * share
        name = f"{about.call}, in s; the motion after a step of {h:.6g} s with Drag(k1={k1}, "
        name += f"k2={k2}), compared with the motion before it"
        _, velocity = with_drag((speed, 0.0, 0.0), k1, k2, mass, h, 1)
        v = velocity[0] / speed
        kind = "reversed and faster" if v < -1.0 else "reversed and slower" if v < 0.0 else "slower"
        kind = kind if v < 1.0 else "not slower"
        expect_exactly(kind, wanted, call=name)


@pytest.mark.exercise("B5.8")
@pytest.mark.robust
def test_limits_need_numbers_that_mean_something() -> None:
    about.read = LIMITS
    about.cause = "One of these arguments is not valid, so raise ValueError. Check each argument "
    about.cause += "with one of the functions in arguments.py, which raise the error for you."
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
            call="drag_limits(k1={}, k2={}, mass={}, speed={})".format(*bad),
            allowed=lambda: drag_limits(0.3, 0.05, 2.0, 5.0),
        )
