"""Exercises 9.1 to 9.6. Exercise 9.7 is in test_stones.py."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch09_rotations.exercise_probes import multiplications
from ch09_rotations.exercises import (
    back_to_reference,
    easy_inverse,
    product_without_j_and_k,
    read_off,
    turned_by_sense,
    turned_by_steps,
    two_other_turns,
)
from ch09_rotations.matrix import Matrix4
from ch09_rotations.quaternion import Quaternion
from draw import Components, Triple, number, positive_number, vector
from expect import expect_between, expect_close, expect_that, expect_vector
from turning import (
    LOOSE,
    TIGHT,
    X_AXIS,
    Y_AXIS,
    Z_AXIS,
    Quad,
    applied,
    draw_quad,
    draw_slight_turn,
    entries,
    expect_kept,
    hamilton,
    joined,
    matrix_of,
    named,
    quad,
    rijk,
    same_sign,
    short,
    transposed,
    turned,
)

TURNS = "the docstring of two_other_turns"
BACK = "the docstring of back_to_reference"
FOUR = "the docstring of product_without_j_and_k"
OFF = "the docstring of read_off"
SENSE = "the docstring of turned_by_sense"
BY_STEPS = "the docstring of turned_by_steps, and Eq. 9.5"
EASY = "the docstring of easy_inverse"
REFERENCE = (1.0, 0.0, 0.0, 0.0)
COPY = "Work on orientation.copy() instead."


@pytest.mark.exercise("9.1", asks="The result is the same if you rotate the object by", read=TURNS)
def test_two_turns_end_where_two_others_do() -> None:
    with calls("Return a and b as a pair, in degrees."):
        a, b = two_other_turns()
    slips = {
        "You return the two angles in the wrong order. Return (a, b).": (90.0, -90.0),
        "Either the sign of a is wrong, or your axes rotate with the object. Here the axes stay "
        "fixed in the room.": (90.0, 90.0),
        "Only the sign of your angle b is wrong. Change this sign.": (-90.0, -90.0),
        "You return radians. Return degrees.": (-0.5 * math.pi, 0.5 * math.pi),
    }
    why = "Try it with a book: X and Z stay fixed in space, and rotations are right-handed."
    why = named((a, b), why, slips)
    both = hamilton(quad(X_AXIS, math.radians(b)), quad(Z_AXIS, math.radians(a)))
    for name, axis, wanted in (
        ("X", X_AXIS, (0.0, 0.0, -1.0)),
        ("Y", Y_AXIS, (1.0, 0.0, 0.0)),
        ("Z", Z_AXIS, (0.0, -1.0, 0.0)),
    ):
        then = f"; the object's {name} axis after a rotation by a = {a:.6g} degrees about Z and "
        then += f"then by b = {b:.6g} degrees about X"
        got = tuple(round(component, 9) for component in turned(both, axis))
        expect_close(got, wanted, then=then, cause=why, tolerance=0.0)


@pytest.mark.exercise("9.1", asks="in degrees, from -180 to 180", read=TURNS)
def test_the_angles_are_within_half_a_turn() -> None:
    with calls("This angle is outside the range from -180 to 180 degrees. Add or subtract 360."):
        a, b = two_other_turns()
    expect_between(a, -180.0, 180.0, then="; a", unit="degrees")
    expect_between(b, -180.0, 180.0, then="; b", unit="degrees")


def way_back(a: Quad) -> tuple[Components, float]:
    """Return the axis and angle of back_to_reference as plain numbers."""
    with calls("Return a pair (axis, angle) of a unit Vector3 and an angle in radians."):
        q = Quaternion(*a)
        axis, angle = back_to_reference(q)
    expect_kept("the orientation", rijk(q), a)
    why = "Return the axis as a Vector3."
    if isinstance(axis, float):
        why = "You return the angle first. Return the axis and then the angle."
    unit = expect_vector(axis, then="; axis", cause=why)
    why = "Your axis is not a unit vector. Divide it by its length."
    expect_close(math.hypot(*unit), 1.0, then="; the length of axis", cause=why, tolerance=TIGHT)
    why = "Use an angle in the range from -pi to pi, which may be about the opposite axis."
    if angle and isinstance(angle, float) and math.isclose(abs(angle), math.degrees(angle_of(a))):
        why = "You return the angle in degrees. Return it in radians."
    expect_between(angle, -math.pi, math.pi, then="; angle", cause=why, unit="rad", tolerance=1e-12)
    return unit, angle


def angle_of(q: Quad) -> float:
    """Return the angle of a rotation, from 0 to pi."""
    return 2.0 * math.atan2(math.hypot(*q[1:]), abs(q[0]))


@pytest.mark.exercise(
    "9.2", asks="find the rotation that takes an orientation back", weight=2, read=BACK
)
def test_one_turn_leads_back(rng: Random) -> None:
    axis, small, large = vector(rng), rng.uniform(0.1, 1.0), rng.uniform(3.3, 6.0)
    drawn = [draw_quad(rng), quad(axis, small), quad(axis, large), quad(axis, -small)]
    for q in ((0.5, 0.5, 0.5, 0.5), *drawn):
        unit, angle = way_back(q)
        got = same_sign(hamilton(quad(unit, angle), q), REFERENCE)
        slips = {
            "You rotate further away instead of back. Reverse either the axis or the angle, but "
            "not both.": same_sign(hamilton(q, q), REFERENCE),
            "You rotate by half the angle.": same_sign(quad(q[1:], math.acos(q[0])), REFERENCE),
        }
        why = "The conjugate of q undoes the rotation. Convert it to an axis and an angle."
        then = f"; the orientation after q is rotated by {angle:.6g} rad about {short(unit)}"
        expect_close(got, REFERENCE, then=then, cause=named(got, why, slips), tolerance=TIGHT)


@pytest.mark.exercise("9.2", asks="the angle is 0 and the axis may be any unit vector", read=BACK)
def test_the_way_back_at_the_ends(rng: Random) -> None:
    why = "This orientation is already the reference, so the angle should be 0."
    for r in (1.0, -1.0):
        _, angle = way_back((r, 0.0, 0.0, 0.0))
        expect_close(angle, 0.0, then="; angle", cause=why, tolerance=0.0)
    axis, near = turned(draw_quad(rng), X_AXIS), math.pi - 2e-7
    why = "Undo a half-turn by another half-turn about the same axis, in either direction."
    for q, turn in (((0.0, *axis), math.pi), (quad(axis, near), near)):
        unit, angle = way_back(q)
        got = (abs(angle), *same_sign(unit, axis))
        expect_close(got, (turn, *axis), then="; |angle| and axis", cause=why, tolerance=TIGHT)


@pytest.mark.exercise("9.3a", asks="with only four multiplications", read=FOUR)
def test_a_product_without_j_and_k(rng: Random) -> None:
    r, i, s, j = (number(rng, 1.5) for _ in range(4))
    with calls("The product has r = r1 r2 - i1 i2 and i = r1 i2 + i1 r2, because i i = -1."):
        a, b = Quaternion(r, i, 0.0, 0.0), Quaternion(s, j, 0.0, 0.0)
        product = product_without_j_and_k(a, b)
    expect_kept("the first quaternion", rijk(a), (r, i, 0.0, 0.0))
    expect_kept("the second quaternion", rijk(b), (s, j, 0.0, 0.0))
    real, imaginary = r * s - i * j, r * j + i * s
    slips = {
        "You add the product of the two i components to r. Subtract it, because i i = -1.":
            (r * s + i * j, imaginary, 0.0, 0.0),
        "You multiply the quaternions component by component.": (r * s, i * j, 0.0, 0.0),
        "You subtract the two products in i. Add them.": (real, r * j - i * s, 0.0, 0.0),
        "You swap r and i of the result.": (imaginary, real, 0.0, 0.0),
    }  # fmt: skip
    expect_close(rijk(product), (real, imaginary, 0.0, 0.0), slips, tolerance=TIGHT)
    count = multiplications((r, i), (s, j))
    general = ", as the general product a * b does" * (count == 16)
    why = f"You also multiply components that are zero{general}. Leave out the terms with j and k, "
    why += "so that four multiplications remain."
    expect_that(count <= 4, f"{count} multiplications", "at most 4 multiplications", cause=why)


def about_x(angle: float, q: Quad) -> Quad:
    """Return an orientation after a rotation about the world's X axis."""
    return hamilton(quad(X_AXIS, angle), q)


def stepped(q: Quad, rate: float, duration: float, steps: int) -> Quad:
    """Return the normalized orientation after steps of Eq. 9.5 about X."""
    half = 0.5 * rate * duration / steps
    for _ in range(steps):
        change = hamilton((0.0, half, 0.0, 0.0), q)
        q = tuple(old + new for old, new in zip(q, change, strict=True))
    return tuple(component / math.hypot(*q) for component in q)


@pytest.mark.exercise("9.4", asks="at a constant rate about the world's X axis", read=SENSE)
def test_a_steady_turn_is_one_rotation(rng: Random) -> None:
    size = positive_number(rng, 0.2, 4.0)
    for a, rate in (((0.5, 0.5, 0.5, 0.5), size), (draw_quad(rng), -size), (draw_quad(rng), 0.0)):
        duration = positive_number(rng, 0.5, 3.0)
        cause = "Rotate by the angle rate * duration about the world's X axis."
        if rate == 0.0:
            cause = "Your axis depends on the rate, which is 0 here. Use a fixed X axis."
        with calls(cause):
            q = Quaternion(*a)
            result = turned_by_sense(q, rate=rate, duration=duration)
        turn = quad(X_AXIS, rate * duration)
        wanted = hamilton(turn, a)
        slips = {
            "You rotate about the object's own X axis. To rotate about the world's X axis, put the "
            "new rotation on the left.": hamilton(a, turn),
            "You return only the new rotation. Multiply it by the orientation, on its right.": turn,
            "You rotate by half the angle.": about_x(0.5 * rate * duration, a),
            "You rotate by the rate alone.": about_x(rate, a),
            "You divide the rate by the duration.": about_x(rate / duration, a),
            "You convert the angle to degrees.": about_x(math.degrees(rate * duration), a),
            "You rotate in the opposite direction.": about_x(-rate * duration, a),
            "You take a step of Eq. 9.5.": stepped(a, rate, duration, 1),
        }
        slips = {name: same_sign(slip, wanted) for name, slip in slips.items()}
        expect_close(same_sign(rijk(result), wanted), wanted, slips, tolerance=TIGHT)
        expect_kept("the orientation", rijk(q), a, COPY)
    with calls("You return q itself, so a change of the result also changes q. Return a copy."):
        q = Quaternion(*a)
        turned_by_sense(q, rate=0.0, duration=1.0).r = 9.0
    expect_close(rijk(q), a, then="; q", tolerance=0.0)


@pytest.mark.exercise("9.4", asks="normalize only after the last one", weight=2, read=BY_STEPS)
def test_a_steady_turn_in_steps_of_the_book(rng: Random) -> None:
    for a, steps, share in (
        ((0.5, 0.5, 0.5, 0.5), 1, 1.0),
        (draw_quad(rng), 2, -1.0),
        (draw_quad(rng), 1000, 0.3),  # so little is missing that acos would lose it
        (draw_quad(rng), 3, 0.0),
    ):
        rate, duration = share * positive_number(rng, 0.3, 1.2), positive_number(rng, 1.0, 2.0)
        numbers = (rate, duration) if steps == 1 else (rate, duration, steps)
        with calls("Take steps with add_scaled on a copy. Normalize the copy after the last step."):
            q = Quaternion(*a)
            result, error = turned_by_steps(q, *numbers)
        wanted, exact = stepped(a, rate, duration, steps), about_x(rate * duration, a)
        half = 0.5 * rate * duration / steps
        size = (1.0 + half * half) ** (0.5 * steps)
        slips = {
            "Each of your steps takes the whole duration. Divide it by the number of steps.":
                stepped(a, rate, duration * steps, steps),
            f"You take a single step. Take {steps} steps instead.": stepped(a, rate, duration, 1),
            "You divide the rate by the number of steps, too. Divide only the duration.":
                stepped(a, rate / steps, duration, steps),
            f"You take one step too many. Take {steps}.":
                stepped(a, rate, duration * (steps + 1) / steps, steps + 1),
            "You don't normalize the result. Normalize it at the end.": [size * c for c in wanted],
            "You compute the exact rotation instead of taking steps with add_scaled.": exact,
            "the old orientation": a,
        }  # fmt: skip
        slips = {name: same_sign(slip, wanted) for name, slip in slips.items()}
        got = same_sign(rijk(result), wanted)
        expect_close(got, wanted, slips, then="; result", tolerance=TIGHT)
        turn = abs(rate * duration)
        missing = turn - 2.0 * steps * math.atan(0.5 * turn / steps)
        slips = {
            "You return half of the angle. Double it.": 0.5 * missing,
            "You return a negative angle.": -missing,
            "You return the distance between the two quaternions.": 2.0 * math.sin(0.25 * missing),
            "You multiply the two orientations. Multiply one by the conjugate of the other.":
                angle_of(hamilton(exact, wanted)),
            "You subtract the angles of two rotations about different axes.":
                abs(angle_of(exact) - angle_of(wanted)),
            "You return the angle in degrees.": math.degrees(missing),
        }  # fmt: skip
        why = "The error is the angle to the exact rotation, in radians and at least 0."
        why = named(error, why, slips)
        if isinstance(error, (int, float)) and 1e-11 < abs(error - missing) < 1e-7:
            why = "You use acos, which loses half of the digits of a small angle. Use atan2."
        expect_close(error, missing, then="; error", cause=why, unit="rad", tolerance=1e-11)
        expect_kept("the orientation", rijk(q), a, COPY)


@pytest.mark.exercise("9.4", asks="the angle in radians, from 0 to pi", read=BY_STEPS)
def test_an_error_is_at_most_half_a_turn() -> None:
    with calls("If your angle is greater than pi, return 2 pi minus this angle."):
        q = Quaternion(0.5, 0.5, 0.5, 0.5)
        _, error = turned_by_steps(q, rate=3.0, duration=2.0)
    # Of 6 rad it rotates by 2 atan 3 = 2.50: 3.50 are missing, or 2.78 the other way round.
    wanted = math.tau - (6.0 - 2.0 * math.atan(3.0))
    expect_close(error, wanted, then="; error", unit="rad", tolerance=1e-11)


@pytest.mark.exercise("9.5", asks="into rotation, the first three columns, and position", read=OFF)
def test_rotation_and_position_are_read_off(rng: Random) -> None:
    m, p = draw_slight_turn(rng), vector(rng)
    twelve = joined(m, p)
    cause = "Return the first three columns as a Matrix3 and the last column as a Vector3."
    with calls(cause):
        matrix = Matrix4(*twelve)
        rotation, position = read_off(matrix)
    first = "You return the position first. Return the rotation and then the position."
    is_vector = isinstance(rotation, Vector3)
    expect_that(not is_vector, "a Vector3", "a Matrix3", then="; rotation", cause=first)
    slips = {
        "You return the transpose of the rotation. Don't swap rows and columns.": transposed(m),
        "You return the first nine entries.": twelve[:9],
        "You return the last three columns as the rotation. Return the first three.":
            [n for place, n in enumerate(twelve) if place % 4],
    }  # fmt: skip
    got = entries(rotation)
    # If you compute it from transformed points, numbers up to 11 are rounded.
    then = "; rotation, row by row"
    expect_close(got, m, then=then, cause=named(got, cause, slips), tolerance=TIGHT)
    slips = {
        "You return the last row as the position.": twelve[8:11],
        "You return the last three entries as the position.": twelve[9:],
        "You return the first column.": (m[0], m[3], m[6]),
        "You return the position of the inverse matrix.": -Triple(applied(transposed(m), p)),
    }
    why, then = "Return the position as a Vector3.", "; position"
    why = named(expect_vector(position, then=then, cause=why), "Return the last column.", slips)
    expect_close(position, p, then=then, cause=why, tolerance=0.0)
    expect_kept("the matrix", entries(matrix), twelve)


@pytest.mark.exercise("9.6", asks="so transpose the 3x3 part", weight=2, read=EASY)
def test_the_easy_inverse(rng: Random) -> None:
    r, p = matrix_of(draw_quad(rng)), vector(rng)
    twelve, t = joined(r, p), transposed(r)
    with calls("If m has rotation R and position p, use the transpose T of R, and -T p."):
        m = Matrix4(*twelve)
        inverse = easy_inverse(m)
    forward, back = Triple(applied(r, p)), Triple(applied(t, p))
    slips = {
        "Your last column is -p.": joined(t, -p),
        "Your last column is p.": joined(t, p),
        "Your last column is R p, where R is the rotation of m.": joined(t, forward),
        "The minus sign applies only to the first of the three products. Put the whole sum in "
        "parentheses.": joined(t, back - 2.0 * p[0] * Triple(t[::3])),
        "You put the position last. Its components belong at the ends of the rows.": (*t, *-back),
        "You return a Matrix3. Return a Matrix4, with the position of the inverse.": t,
        "Your last column is T p, without the minus sign.": joined(t, back),
        "Your last column is -R p, where R is the rotation of m.": joined(t, -forward),
        "You don't transpose the rotation. Swap its rows and columns.": joined(r, -back),
        "You use -p, and you don't transpose the rotation.": joined(r, -p),
    }
    # Rounding of numbers up to 17.
    then = ", row by row"
    expect_close(entries(inverse), joined(t, -back), slips, then=then, tolerance=TIGHT)
    expect_kept("the matrix", entries(m), twelve)


@pytest.mark.exercise(
    "9.6", asks="which is wrong if the 3x3 part is not a rotation", weight=0.5, read=EASY
)
def test_the_easy_inverse_divides_by_nothing(rng: Random) -> None:
    doubled, p = tuple(2.0 * n for n in matrix_of(draw_quad(rng))), vector(rng)
    for linear in (doubled, (0.0,) * 9):
        twelve, t = joined(linear, p), transposed(linear)
        with calls("A general inverse divides by the determinant. Transpose the 3x3 part instead."):
            m = Matrix4(*twelve)
            inverse = easy_inverse(m)
        wanted = joined(t, -Triple(applied(t, p)))
        # Rounding of numbers up to 33.
        expect_close(entries(inverse), wanted, then=", row by row", tolerance=LOOSE)
