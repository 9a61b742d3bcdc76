"""Time steps that are too long for drag, build task B5.8."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch05_forces.closed_form import drag_limits
from ch05_forces.probes import with_drag
from draw import positive_number
from expect import about, expect_close, expect_exactly, named

LIMITS = "the docstring of drag_limits"


@pytest.mark.exercise("B5.8", asks="Return the durations in s above which")
def test_the_limits_by_their_formula(rng: Random) -> None:
    about.read = LIMITS
    k1, k2, mass, speed = (
        positive_number(rng),
        positive_number(rng),
        positive_number(rng),
        positive_number(rng, 1.0, 90.0),
    )
    about.cause = "The limits are wrong. A step of h seconds multiplies the velocity by 1 - (k1 + "
    about.cause += "k2 |v|) h / m, which must be 0 at the first limit and -1 at the second."
    for one, two, rate in (
        (k1, k2, (k1 + k2 * speed) / mass),
        (k1, 0.0, k1 / mass),
        (0.0, k2, k2 * speed / mass),
    ):
        about.call = f"drag_limits(k1={one}, k2={two}, mass={mass}, speed={speed}); (first limit, "
        about.call += "second limit) in s"
        got = drag_limits(one, two, mass, speed)
        wrong = {  # other ways to (k1 + k2 |v|) / m
            "The mass is missing. A heavier particle tolerates a longer step, so multiply by "
            "the mass.": rate * mass,
            "You divide by the mass. A heavier particle tolerates a longer step, so multiply "
            "by the mass instead.": rate * mass**2,
            "You divide only k2 |v| by the mass. Write the sum in parentheses, as in (k1 + k2 |v|) "
            "/ m.": one + two * speed / mass,
            "You use the drag itself, k1 |v| + k2 |v|^2. Divide it by the speed |v|, which gives "
            "k1 + k2 |v|.": rate * speed,
            "You multiply k2 by the square of the speed. The force has |v|^2, but it is divided by "
            "the speed |v| here, which leaves k1 + k2 |v|.": (one + two * speed**2) / mass,
            "You use k1 + k2, without the speed. Multiply k2 by the speed |v|, which gives k1 + "
            "k2 |v|.": (one + two) / mass,
            "You multiply both k1 and k2 by the speed |v|. Multiply only k2 by it, which gives "
            "k1 + k2 |v|.": (one + two) * speed / mass,
            "You use k1 + 2 k2 |v|, the derivative of the drag. Use the drag divided by the "
            "speed |v|, which is k1 + k2 |v|.": (one + 2.0 * two * speed) / mass,
        }
        slips: dict[str, Any] = {name: (1.0 / a, 2.0 / a) for name, a in wrong.items()}
        slips["You return the two limits in the wrong order. Return the smaller one first."] = (
            2.0 / rate,
            1.0 / rate,
        )
        slips[
            "Your two limits are equal. A step as long as the second limit reverses the full "
            "velocity, so this limit must be twice the first."
        ] = (1.0 / rate, 1.0 / rate)
        slips["You return (k1 + k2 |v|) / m, which is a rate. Its inverse is a time."] = (
            rate,
            2.0 * rate,
        )
        slips["Your limits are half the right ones. The first one is m / (k1 + k2 |v|)."] = (
            0.5 / rate,
            1.0 / rate,
        )
        slips["You return only the first limit. Return a tuple of both."] = 1.0 / rate
        slips["Your second limit is the square of the first. It must be twice the first."] = (
            1.0 / rate,
            rate**-2,
        )
        why = named(got, about.cause, slips)
        if isinstance(got, (tuple, list)) and math.inf in got:
            why = (
                "You return an infinite limit although there is drag. The first limit is m / (k1 + "
            )
            why += "k2 |v|), and the second one is twice as long."
        expect_close(got, (1.0 / rate, 2.0 / rate), cause=why)
    about.cause = "You treat a very small drag as 0. It is not 0, so compute the two limits as "
    about.cause += "usual."
    got = drag_limits(1e-12, 0.0, 1.0, 1.0)
    expect_close(
        got,
        (1e12, 2e12),
        call="drag_limits(k1=1e-12, k2=0.0, mass=1.0, speed=1.0); (first limit, second limit) in s",
    )
    about(
        f"drag_limits(k1={k1}, k2={k2}, mass={mass}, speed=0.0); (first limit, second limit) in s",
        cause="The limits are wrong for a speed of 0. Only k1 has an effect then, so they must be "
        "m / k1 and 2 m / k1.",
    )
    got = drag_limits(k1, k2, mass, 0.0)
    expect_close(got, (mass / k1, 2.0 * mass / k1))


@pytest.mark.exercise("B5.8", asks="Both are math.inf without drag")
def test_without_drag_no_step_is_too_long() -> None:
    about.read = LIMITS
    about.cause = "There is no drag here, so no time step is too long. Return math.inf for both "
    about.cause += "limits."
    for arguments in ((0.0, 0.0, 2.0, 5.0), (0.0, 0.5, 2.0, 0.0)):
        about.call = (
            "drag_limits(k1={}, k2={}, mass={}, speed={}); (first limit, second limit) in s".format(
                *arguments
            )
        )
        got = [*drag_limits(*arguments)]
        expect_exactly(got, [math.inf, math.inf])
    about.cause = "The limits are wrong. Here (k1 + k2 |v|) / m is 1 per second, so they must be 1 "
    about.cause += "s and 2 s."
    got = drag_limits(1.0, 0.5, 2.0, 2.0)
    expect_close(
        got,
        (1.0, 2.0),
        call="drag_limits(k1=1.0, k2=0.5, mass=2.0, speed=2.0); (first limit, second limit) in s",
    )


@pytest.mark.exercise("B5.8", asks="above which a step reverses the motion")
def test_steps_slightly_shorter_and_longer_than_the_limits(rng: Random) -> None:
    about.read = LIMITS
    k1, mass, speed = positive_number(rng), positive_number(rng), positive_number(rng, 5.0, 90.0)
    k2 = round(positive_number(rng, 0.3, 3.0) * k1 / speed, 6)  # both parts of the drag count
    about.call = f"drag_limits(k1={k1}, k2={k2}, mass={mass}, speed={speed})"
    about.cause = "The limits are wrong. A step of h seconds multiplies the velocity v by 1 - (k1 "
    about.cause += "+ k2 |v|) h / m, which must be 0 at the first limit and -1 at the second."
    first, second = drag_limits(k1, k2, mass, speed)
    for limit, share, wanted, cause in (
        (
            first,
            0.98,
            "slower",
            "Your first limit is too long. A step that is slightly shorter must slow the "
            "particle down without reversing its motion.",
        ),
        (
            first,
            1.02,
            "reversed and slower",
            "Your first limit is too short. A step that is slightly longer must reverse the "
            "motion.",
        ),
        (
            second,
            0.98,
            "reversed and slower",
            "Your second limit is wrong. After a step that is slightly shorter, the particle "
            "must move backward, but slower than before.",
        ),
        (
            second,
            1.02,
            "reversed and faster",
            "Your second limit is too short. After a step that is slightly longer, the particle "
            "must move backward and faster than before.",
        ),
    ):
        about.cause = cause
        h = limit * share
        name = f"{about.call} = ({first:.6g}, {second:.6g}) s; the motion after one step of "
        name += f"{h:.6g} s with Drag(k1={k1}, k2={k2}), compared with the motion before it"
        _, velocity = with_drag((speed, 0.0, 0.0), k1, k2, mass, h, 1)
        v = velocity[0] / speed
        kind = "reversed and faster" if v < -1.0 else "reversed and slower" if v < 0.0 else "slower"
        kind = kind if v < 1.0 else "not slower"
        expect_exactly(kind, wanted, call=name)
