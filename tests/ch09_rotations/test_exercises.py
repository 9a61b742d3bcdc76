"""Exercises 9.1 to 9.4. The others are in test_read_off.py and test_stones.py."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch09_rotations.exercise_probes import multiplications
from ch09_rotations.exercises import (
    back_to_reference,
    product_without_j_and_k,
    turned_by_sense,
    turned_by_steps,
    two_other_turns,
)
from ch09_rotations.quaternion import Quaternion
from draw import components, number, positive_number
from expect import (
    about,
    expect_between,
    expect_close,
    expect_that,
    expect_unchanged,
    expect_vector,
    scoped,
)
from turning import (
    TIGHT,
    X_AXIS,
    Y_AXIS,
    Z_AXIS,
    Quad,
    draw_quad,
    expect_kept,
    hamilton,
    named,
    quad,
    rijk,
    same_sign,
    short,
    turned,
)

BACK = "the docstring of back_to_reference"
PLANE = "the docstring of product_without_j_and_k"
SENSE = "the docstring of turned_by_sense"
BY_STEPS = "the docstring of turned_by_steps, and Eq. 9.5"


# 9.1 Two rotations and two others


@pytest.mark.exercise("9.1", asks="The result is the same if you rotate the object by")
def test_two_turns_end_where_two_others_do() -> None:
    about.read = "the docstring of two_other_turns"
    about.call, about.cause = "two_other_turns()", "Return a and b as a pair, in degrees."
    a, b = two_other_turns()
    both = hamilton(quad(X_AXIS, math.radians(b)), quad(Z_AXIS, math.radians(a)))
    about.cause = "Try it with a book: the axes X and Z stay fixed in space, and rotations are "
    about.cause += "right-handed."
    slips = {
        "You return the two angles in the wrong order. Return (a, b).": (90.0, -90.0),
        "Either the sign of a is wrong, or your axes rotate with the object. Here the axes stay "
        "fixed in the room.": (90.0, 90.0),
        "Only the sign of your angle b is wrong. Change this sign.": (-90.0, -90.0),
        "You return radians. Return degrees.": (-0.5 * math.pi, 0.5 * math.pi),
    }
    about.cause = named((a, b), about.cause, slips)
    for name, axis, wanted in (
        ("X", X_AXIS, (0.0, 0.0, -1.0)),
        ("Y", Y_AXIS, (1.0, 0.0, 0.0)),
        ("Z", Z_AXIS, (0.0, -1.0, 0.0)),
    ):
        about.call = f"a, b = two_other_turns(); the object's {name} axis after a rotation by a = "
        about.call += f"{a:.6g} degrees about Z and then by b = {b:.6g} degrees about X"
        got = tuple(round(component, 9) for component in turned(both, axis))
        expect_close(got, wanted, tolerance=0.0)


@pytest.mark.exercise("9.1", asks="in degrees, from -180 to 180")
def test_the_angles_are_within_half_a_turn() -> None:
    about.read = "the docstring of two_other_turns"
    about.call = "two_other_turns()"
    about.cause = "This angle is outside the range from -180 to 180 degrees. Add or subtract 360."
    for letter, angle in zip("ab", two_other_turns(), strict=True):
        expect_between(angle, -180.0, 180.0, then=f"; the angle {letter}, in degrees")


# 9.2 One rotation back to the reference


@scoped
def way_back(q: Quad) -> tuple:
    """Return the axis and angle of back_to_reference as plain numbers."""
    about(f"q = Quaternion{short(q)}; back_to_reference(q)", read=BACK)
    about.cause = "Return a pair (axis, angle) of a unit Vector3 and an angle in radians."
    orientation = Quaternion(*q)
    axis, angle = back_to_reference(orientation)
    if isinstance(axis, float):
        about.cause = "You return the angle first. Return the axis and then the angle."
    expect_kept("the orientation", rijk(orientation), q)
    unit = expect_vector(axis, then="; the axis")
    length = math.hypot(*unit)
    about.cause = "Your axis is not a unit vector. Divide it by its length."
    expect_close(length, 1.0, then="; the length of the axis", tolerance=TIGHT)
    about.cause = "Your angle is not in the range from -pi to pi. Use the smaller angle about the "
    about.cause += "opposite axis instead."
    turn = math.degrees(2.0 * math.atan2(math.hypot(*q[1:]), abs(q[0])))
    if angle and isinstance(angle, float) and math.isclose(abs(angle), turn):
        about.cause = "You return the angle in degrees. Return it in radians."
    expect_between(angle, -math.pi, math.pi, then="; the angle in radians", tolerance=1e-12)
    return unit, angle


@pytest.mark.exercise("9.2", asks="find the rotation that takes an orientation back", weight=2)
def test_one_turn_leads_back(rng: Random) -> None:
    about.read = BACK
    axis, small, large = components(rng), rng.uniform(0.1, 1.0), rng.uniform(3.3, 6.0)
    about.cause = "The conjugate of q has the same axis and the opposite angle, so it undoes the "
    about.cause += "rotation. Convert the conjugate to an axis and an angle."
    drawn = [draw_quad(rng), quad(axis, small), quad(axis, large), quad(axis, -small)]
    for q in ((0.5, 0.5, 0.5, 0.5), *drawn):
        unit, angle = way_back(q)
        about.call = f"q = Quaternion{short(q)}; back_to_reference(q); the orientation after q is "
        about.call += f"rotated by {angle:.6g} rad about {short(unit)}"
        reference = (1.0, 0.0, 0.0, 0.0)
        got = same_sign(hamilton(quad(unit, angle), q), reference)
        slips = {
            "You rotate further away instead of back. Reverse either the axis or the angle, but "
            "not both.": same_sign(hamilton(q, q), reference),
            "You rotate by half the angle.": same_sign(quad(q[1:], math.acos(q[0])), reference),
        }
        why = named(got, about.cause, slips)
        expect_close(got, reference, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("9.2", asks="the angle is 0 and the axis may be any unit vector")
def test_the_way_back_at_the_ends(rng: Random) -> None:
    about(
        cause="This orientation is already the reference, so the angle should be 0, and the axis "
        "can be any unit vector.",
        read=BACK,
    )
    for q in ((1.0, 0.0, 0.0, 0.0), (-1.0, 0.0, 0.0, 0.0)):
        _, angle = way_back(q)
        about.call = f"q = Quaternion{short(q)}; back_to_reference(q); the angle in radians"
        expect_close(angle, 0.0, tolerance=0.0)
    axis, near = turned(draw_quad(rng), X_AXIS), math.pi - 2e-7
    about.cause = "Undo a half-turn by another half-turn about the same axis, in either direction."
    for q, turn in (((0.0, *axis), math.pi), (quad(axis, near), near)):
        unit, angle = way_back(q)
        got, wanted = (abs(angle), *same_sign(unit, axis)), (turn, *axis)
        about.call = f"q = Quaternion{short(q)}; back_to_reference(q); |angle| and axis"
        expect_close(got, wanted, tolerance=TIGHT)


# 9.3a Two quaternions without j and k


@pytest.mark.exercise("9.3a", asks="with only four multiplications")
def test_a_product_without_j_and_k(rng: Random) -> None:
    about.read = PLANE
    (r, i), (s, j) = ((number(rng, 1.5), number(rng, 1.5)) for _ in range(2))
    about.call = f"product_without_j_and_k(Quaternion({r}, {i}, 0, 0), Quaternion({s}, {j}, 0, 0))"
    about.cause = "The product has r = r1 r2 - i1 i2 and i = r1 i2 + i1 r2, because i i = -1."
    a, b = Quaternion(r, i, 0.0, 0.0), Quaternion(s, j, 0.0, 0.0)
    got = rijk(product_without_j_and_k(a, b))
    product = complex(r, i) * complex(s, j)
    wanted = (product.real, product.imag, 0.0, 0.0)
    expect_kept("the first quaternion", rijk(a), (r, i, 0.0, 0.0))
    expect_kept("the second quaternion", rijk(b), (s, j, 0.0, 0.0))
    added = (r * s + i * j, product.imag, 0.0, 0.0)
    slips = {
        "You add the product of the two i components to r. Subtract it, because i i = -1.": added,
        "You multiply the quaternions component by component.": (r * s, i * j, 0.0, 0.0),
        "You subtract the two products in i. Add them.": (wanted[0], r * j - i * s, 0.0, 0.0),
        "You swap r and i of the result.": (wanted[1], wanted[0], 0.0, 0.0),
    }
    why = named(got, about.cause, slips, wanted)
    expect_close(got, wanted, cause=why, tolerance=TIGHT)
    count = multiplications((r, i), (s, j))
    about.cause = (
        "You also multiply components that are zero. Leave out the terms with j and k, so "
    )
    about.cause += "that four multiplications remain."
    if count == 16:
        about.cause = "You also multiply components that are zero, as the general product a * b "
        about.cause += (
            "does. Leave out the terms with j and k, so that four multiplications remain."
        )
    expect_that(count <= 4, f"{count} multiplications", "at most 4 multiplications")


# 9.4 A steady rotation, in one step and in many


@pytest.mark.exercise("9.4", asks="at a constant rate about the world's X axis")
def test_a_steady_turn_is_one_rotation(rng: Random) -> None:
    about.read = SENSE
    size = positive_number(rng, 0.2, 4.0)
    for q, rate in (((0.5, 0.5, 0.5, 0.5), size), (draw_quad(rng), -size), (draw_quad(rng), 0.0)):
        duration = positive_number(rng, 0.5, 3.0)
        orientation = Quaternion(*q)
        about.call = f"turned_by_sense(Quaternion{short(q)}, rate={rate}, duration={duration})"
        about.cause = "Rotate by the angle rate * duration about the world's X axis."
        if rate == 0.0:
            about.cause = "Your axis depends on the rate, which is 0 here. Use a fixed X axis."
        turn = quad(X_AXIS, rate * duration)
        wanted = hamilton(turn, q)
        got = same_sign(rijk(turned_by_sense(orientation, rate, duration)), wanted)
        slips = {
            "You rotate about the object's own X axis. To rotate about the world's X axis, put the "
            "new rotation on the left.": hamilton(q, turn),
            "You return only the new rotation. Multiply it by the orientation, on its right.": turn,
            "You rotate by half the angle.": hamilton(quad(X_AXIS, 0.5 * rate * duration), q),
            "You rotate by the rate alone.": hamilton(quad(X_AXIS, rate), q),
            "You divide the rate by the duration. Multiply them.": hamilton(
                quad(X_AXIS, rate / duration), q
            ),
            "You convert the angle to degrees. from_axis_angle takes radians.": hamilton(
                quad(X_AXIS, math.degrees(rate * duration)), q
            ),
            "You rotate in the opposite direction.": hamilton(quad(X_AXIS, -rate * duration), q),
            "You take a step of Eq. 9.5.": stepped(q, rate, duration, 1),
        }
        slips = {name: same_sign(slip, wanted) for name, slip in slips.items()}
        why = named(got, about.cause, slips)
        expect_close(got, wanted, cause=why, tolerance=TIGHT)
        expect_kept("the orientation", rijk(orientation), q, "Work on orientation.copy() instead.")
    about.call = f"q = Quaternion{short(q)}; turned_by_sense(q, 0, 1).r = 9.0; q"
    about.cause = "You return q itself, so a change of the result also changes q. Return a copy."
    turned_by_sense(orientation, 0.0, 1.0).r = 9.0
    expect_unchanged("q", rijk(orientation), q)


def stepped(q: Quad, rate: float, duration: float, steps: int) -> Quad:
    """Return the normalized orientation after steps of Eq. 9.5 about X."""
    half = 0.5 * rate * duration / steps
    for _ in range(steps):
        change = hamilton((0.0, half, 0.0, 0.0), q)
        q = tuple(old + new for old, new in zip(q, change, strict=True))
    length = math.hypot(*q)
    return tuple(component / length for component in q)


def angle_of(q: Quad) -> float:
    """Return the angle of a rotation, from 0 to pi."""
    return 2.0 * math.atan2(math.hypot(*q[1:]), abs(q[0]))


@pytest.mark.exercise("9.4", asks="normalize only after the last one", weight=2)
def test_a_steady_turn_in_steps_of_the_book(rng: Random) -> None:
    about.read = BY_STEPS
    for q, steps, share in (
        ((0.5, 0.5, 0.5, 0.5), 1, 1.0),
        (draw_quad(rng), 2, -1.0),
        (draw_quad(rng), 1000, 0.3),  # so little is missing that acos would lose it
        (draw_quad(rng), 3, 0.0),
    ):
        rate, duration = share * positive_number(rng, 0.3, 1.2), positive_number(rng, 1.0, 2.0)
        orientation = Quaternion(*q)
        call = f"turned_by_steps(Quaternion{short(q)}, rate={rate:.6g}, duration={duration}"
        about.call = f"{call}, steps={steps})"
        about.cause = "Call add_scaled with duration / steps in each step, on a copy. Normalize "
        about.cause += "the copy after the last step, before you use it to compute the error."
        if steps == 1:
            about.call = f"{call})"
            result, error = turned_by_steps(orientation, rate, duration)
        else:
            result, error = turned_by_steps(orientation, rate, duration, steps)
        wanted = stepped(q, rate, duration, steps)
        got = same_sign(rijk(result), wanted)
        name = f"{about.call}; the orientation"
        half = 0.5 * rate * duration / steps
        size = (1.0 + half * half) ** (0.5 * steps)
        slips = {
            "Each of your steps takes the whole duration. Divide it by the number of "
            "steps.": stepped(q, rate, duration * steps, steps),
            f"You take a single step. Take {steps} steps instead.": stepped(q, rate, duration, 1),
            "You divide the rate by the number of steps, too. Divide only the duration.": stepped(
                q, rate / steps, duration, steps
            ),
            f"You take one step too many. Take {steps}.": stepped(
                q, rate, duration * (steps + 1) / steps, steps + 1
            ),
            "You don't normalize the result. Normalize it at the end.": [size * c for c in wanted],
            "You compute the exact rotation instead of taking steps of Eq. 9.5. Call add_scaled in "
            "each step.": hamilton(quad(X_AXIS, rate * duration), q),
            "the old orientation": q,
        }
        slips = {label: same_sign(slip, wanted) for label, slip in slips.items()}
        why = named(got, about.cause, slips)
        expect_close(got, wanted, call=name, cause=why, tolerance=TIGHT)
        turn = abs(rate * duration)
        missing = turn - 2.0 * steps * math.atan(0.5 * turn / steps)
        about.cause = "The error is the angle to the exact rotation, in radians and at least 0."
        name = f"{about.call}; the error (an angle)"
        slips = {
            "You return half of the angle. Double it.": 0.5 * missing,
            "You return a negative angle.": -missing,
            "You return the distance between the two quaternions. Return the angle of the rotation "
            "from one to the other.": 2.0 * math.sin(0.25 * missing),
            "You multiply the two orientations. Multiply one by the conjugate of the "
            "other.": angle_of(hamilton(hamilton(quad(X_AXIS, rate * duration), q), wanted)),
            "You subtract the angles of two rotations about different axes. Return the angle of "
            "the rotation from one orientation to the other.": abs(
                angle_of(hamilton(quad(X_AXIS, rate * duration), q)) - angle_of(wanted)
            ),
            "You return the angle in degrees.": math.degrees(missing),
        }
        why = named(error, about.cause, slips)
        if isinstance(error, (int, float)) and 1e-11 < abs(error - missing) < 1e-7:
            why = "You use acos, which loses half of the digits of a small angle. Use atan2."
        expect_close(error, missing, call=name, cause=why, unit="rad", tolerance=1e-11)
        expect_kept("the orientation", rijk(orientation), q, "Work on orientation.copy() instead.")


@pytest.mark.exercise("9.4", asks="the angle in radians, from 0 to pi")
def test_an_error_is_at_most_half_a_turn() -> None:
    about.read = BY_STEPS
    q = (0.5, 0.5, 0.5, 0.5)
    about.call = f"turned_by_steps(Quaternion{short(q)}, rate=3, duration=2); the error (an angle)"
    about.cause = "The error is an angle from 0 to pi. If your angle is greater than pi, return 2 "
    about.cause += "pi minus this angle."
    # Of 6 rad it rotates by 2 atan 3 = 2.50: 3.50 are missing, or 2.78 the other way round.
    wanted = math.tau - (6.0 - 2.0 * math.atan(3.0))
    got = turned_by_steps(Quaternion(*q), 3.0, 2.0)[1]
    expect_close(got, wanted, unit="rad", tolerance=1e-11)
