"""Exercises 2.1, 2.4, 2.6, 2.7 and B2.11. The exercises on angles are in test_angles.py."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors import exercises
from ch02_vectors.vector import Vector3
from draw import Triple, number, rounded, unit_vector, vector
from expect import (
    expect_close,
    expect_error,
    expect_exactly,
    expect_that,
    expect_unchanged,
    is_plain,
    xyz,
)

DOC = "the docstring of the function"
PARTS, MOTION = "book 2.1.2", "book 2.2, Eq. 2.7"
LENGTH, DIRECTION = "; the first result, the length", "; the second result, the direction"
TWO_PARTS = (
    "Return a pair: the length of v, and a new vector of length 1 that points in the same "
    "direction."
)
MOVED = "The position after a time t must be p' = p + v t. Return it as a new vector."


# 2.1 Magnitude and direction


@pytest.mark.exercise("2.1", asks="takes a vector and returns these two parts", read=PARTS)
def test_split_the_vector_of_the_book() -> None:
    with calls(TWO_PARTS):
        magnitude, unit = exercises.split(Vector3(2.0, -2.0, -2.0))
    order = "You return the two results in the wrong order. Return the length first."
    cause = TWO_PARTS if is_plain(magnitude) else order
    slips = {
        "You return the squared length of v as the first result. Return the length itself, which "
        "is v.magnitude().": 12.0,
        "You measure the length of a vector that is already normalized, so it is 1. Measure the "
        "length of v first, and don't change v.": 1.0,
    }
    length = math.sqrt(12.0)
    expect_close(magnitude, length, slips, then=LENGTH, cause=cause)
    nothing = "Your second result is None, as v.normalize() returns it. Return v.normalized()."
    expect_that(unit is not None, "None, no vector", "a vector", then=DIRECTION, cause=nothing)
    v = Triple((2.0, -2.0, -2.0))
    slips = {
        "You return v itself as the second result. Divide v by its length to get its direction, "
        "which is a vector of length 1.": v,
        "You divide v by its squared length. Divide it by its length instead, so that the result "
        "has length 1.": v / 12.0,
    }
    expect_close(xyz(unit), v / length, slips, then=DIRECTION)


@pytest.mark.exercise("2.1", asks="its magnitude and its direction: a unit vector", read=PARTS)
def test_split_returns_the_length_and_the_direction(rng: Random) -> None:
    a = vector(rng)
    with calls(TWO_PARTS):
        v = Vector3(*a)
        magnitude, unit = exercises.split(v)
    expect_close(magnitude, abs(a), then=LENGTH)
    expect_close(xyz(unit), a / abs(a), then=DIRECTION)
    in_place = (
        "You change v, because normalize works in place. Use normalized, which returns a new "
        "vector."
    )
    expect_unchanged("v", v, a, cause=in_place, read=DOC)


@pytest.mark.exercise("2.1", asks="or zero for zero", read=DOC)
def test_split_the_zero_vector() -> None:
    with calls(
        "The length of this vector is 0, so don't divide by it. Return 0 and a new zero vector as "
        "the direction."
    ):
        magnitude, unit = exercises.split(Vector3(0.0, 0.0, 0.0))
    expect_close(magnitude, 0.0, then=LENGTH)
    expect_close(xyz(unit), (0.0, 0.0, 0.0), then=DIRECTION)


# 2.4 The component that makes two vectors perpendicular


@pytest.mark.exercise("2.4", asks="Find the z that makes the vector", read="book 2.1.7")
def test_the_perpendicular_vector_of_the_book() -> None:
    with calls(
        "Two vectors are perpendicular if their scalar product is 0. Solve 1 * 7 + 2 * (-2) + 3 z "
        "= 0 for z."
    ):
        got = exercises.make_perpendicular(Vector3(1.0, 2.0, 3.0), x=7.0, y=-2.0)
    slips = {
        "Your z has the wrong sign. The x and y terms change sign on the other side of the "
        "equation: 3 z = -(1 * 7 + 2 * (-2)).": 1.0,
        "You solve the equation for 3 z, not for z. Divide the result by a.z, which is 3 here.":
            -3.0,
        "Your formula lacks brackets, so the minus sign and the division each apply to one term "
        "only. Compute -(a.x x + a.y y) / a.z.": -7.0 - 4.0 / 3.0,
        "Your formula lacks brackets, so only the last term is divided. Divide the whole sum: "
        "-(a.x x + a.y y) / a.z.": -7.0 + 4.0 / 3.0,
        "You multiply by a.z. Divide by it to solve the equation for z.": -9.0,
        "You subtract the term of y instead of adding it.": -11.0 / 3.0,
    }  # fmt: skip
    expect_close(got, -1.0, slips)


@pytest.mark.exercise("2.4", asks="the vector (x, y, z) perpendicular to a", read="book 2.1.7")
def test_the_component_makes_the_scalar_product_zero(rng: Random) -> None:
    (ax, ay, az), x, y = vector(rng), number(rng), number(rng)
    for z in (az, -az, az * 1e-12, az * -1e-12):
        with calls(
            f"You reject a.z = {z:.4g}, but the equation has a solution for every a.z except 0. "
            "Compare a.z with 0 exactly."
        ):
            got = exercises.make_perpendicular(Vector3(ax, ay, z), x=x, y=y)
        rest = ax * x + ay * y
        slips = {
            "You divide with //, which rounds down to a whole number. Use / instead.": -rest // z,
            "You divide with //, which rounds to a whole number. Use / instead.": -(rest // z),
            "The minus sign applies only to your first term. Compute -(a.x x + a.y y) / a.z.":
                (ay * y - ax * x) / z,
        }  # fmt: skip
        solve = "Solve a.x x + a.y y + a.z z = 0 for z. Subtract a.x x and a.y y first."
        # The rounding errors of two terms of up to 100, which may cancel, are divided by z.
        expect_close(got, -rest / z, slips, tolerance=1e-12 / abs(z), cause=solve)


@pytest.mark.exercise("2.4", asks="if a.z is zero, because then z changes nothing", read=DOC)
@pytest.mark.robust
def test_a_z_component_of_zero_is_refused(rng: Random) -> None:
    x, y, _ = vector(rng)
    expect_error(
        lambda: exercises.make_perpendicular(Vector3(x, y, 0.0), 1.0, 2.0),
        ValueError,
        allowed=lambda: exercises.make_perpendicular(Vector3(x, y, 1.0), 1.0, 2.0),
        call=f"make_perpendicular(Vector3({x}, {y}, 0), x=1, y=2)",
        cause="You cannot divide by a.z, which is 0 here, so the equation has no solution. Check "
        "a.z first and raise ValueError.",
    )


# 2.6 The rest of a vector after a projection


def unit_text(name: str, v: Triple) -> str:
    return f"{name} = Vector3{rounded(v)}  # a unit vector, rounded to 6 digits; "


@pytest.mark.exercise("2.6", asks="Return c, d and the angle", weight=2, read="book 2.1.7")
def test_without_its_projection_a_vector_is_perpendicular(rng: Random) -> None:
    # Their length is 1 within rounding, but not exactly.
    one, other = unit_vector(rng) * (1.0 + 1e-15), unit_vector(rng) * (1.0 + 1e-15)
    three = (
        "Return three results: the number c = a . b, the vector d = b - c a, and the angle between "
        "a and d in radians."
    )
    shown = f"{unit_text('a', one)}{unit_text('b', other)}remove_projection(a, b)"
    with calls(three, shown):
        a, b = Vector3(*one), Vector3(*other)
        c, d, angle = exercises.remove_projection(a, b)
    along = one @ other
    order = "You return the results in the wrong order. Return c, d and the angle."
    cause = three if is_plain(c) else order
    expect_close(c, along, tolerance=1e-12, then="; the first result, c", cause=cause)
    wanted = other - along * one
    slips = {
        "You return the projection of b onto a.": along * one,
        "You return c a - b, which points in the opposite direction.": -wanted,
        "You add the projection of b onto a to b. Subtract it instead: d = b - c a, where c = "
        "a . b.": other + along * one,
        "You subtract c b instead of c a.": other - along * other,
        "Your d is b - a. Multiply a by c first: d = b - c a.": other - one,
        "You normalize d. Return d = b - c a as it is.": wanted / abs(wanted),
        "You return a - c b, because you swap a and b.": one - along * other,
    }
    rest = "The second result must be the part of b that is perpendicular to a: d = b - c a."
    expect_close(xyz(d), wanted, slips, tolerance=1e-12, then="; the second result, d", cause=rest)
    slips = {
        "Your angle is in degrees, but it must be in radians. The math module already returns "
        "radians, so don't convert the angle.": 90.0,
        "Your angle is 0, as if you returned the scalar product of a and d, or its arcsine. Pass "
        "the cosine of the angle to math.acos.": 0.0,
        "You return the angle between b and d.": math.acos(min(math.sqrt(1.0 - along**2), 1.0)),
        "You return the angle between a and b.": math.acos(max(-1.0, min(along, 1.0))),
    }
    right = "The angle between a and d must be pi / 2, because d is perpendicular to a."
    then = "; the third result, the angle"
    # A sine gives a right angle only to the root of a rounding error: 5e-8 for 1e-15.
    expect_close(angle, math.pi / 2.0, slips, tolerance=1e-7, then=then, cause=right)
    for name, now, before in (("a", a, one), ("b", b, other)):
        cause = (
            f"You change {name}, which belongs to the caller, because add_scaled, -= and *= work "
            "in place. Write b - a * c, which creates a new vector."
        )
        expect_unchanged(name, now, before, cause=cause)


@pytest.mark.exercise("2.6", asks="if d is shorter than 1e-6", read=DOC)
@pytest.mark.robust
def test_the_projection_of_parallel_vectors_is_refused(rng: Random) -> None:
    a, x = unit_vector(rng), Triple((1.0, 0.0, 0.0))
    # Both have length 1, except for rounding, and d is as long as their Y component.
    short, enough = (Triple((math.sqrt(1.0 - y * y), y, 0.0)) for y in (5e-7, 1.5e-6))
    parallel = (
        "You accept parallel vectors, although d is then only a rounding error without a "
        "direction. Raise ValueError."
    )
    nearly = (
        "Here b is nearly parallel to a, so the length of d is only 5e-7. Raise ValueError if the "
        "length of d is below 1e-6."
    )
    nearly_call = f"remove_projection(Vector3{x}, Vector3{short})"
    for one, other, good, call, cause in (
        (a, a, Triple((0.6, 0.8, 0.0)), f"{unit_text('a', a)}remove_projection(a, a)", parallel),
        (a, -a, Triple((0.6, 0.8, 0.0)), f"{unit_text('a', a)}remove_projection(a, -a)", parallel),
        (x, short, enough, nearly_call, nearly),
    ):
        expect_error(
            lambda one=one, other=other: exercises.remove_projection(
                Vector3(*one), Vector3(*other)
            ),
            ValueError,
            allowed=lambda good=good: exercises.remove_projection(Vector3(*x), Vector3(*good)),
            call=call,
            cause=cause,
            valid=f"remove_projection(Vector3{x}, Vector3{good})",
        )


# 2.7 A position that changes with a velocity


@pytest.mark.exercise("2.7", asks="the position after a motion at constant velocity", read=MOTION)
def test_ten_seconds_with_the_velocity_of_the_book() -> None:
    with calls(MOVED):
        got = exercises.position_after(Vector3(3, 5, -4), Vector3(1, -1, 2), duration=10)
    slips = {
        "You add the velocity as if one second had passed.": (4, 4, -2),
        "You divide the velocity by the time. Multiply it by the time.": (3.1, 4.9, -3.8),
        "You return only the displacement v t. Add it to the position p.": (10, -10, 20),
        "You subtract v t, so the body moves backward.": (-7, 15, -24),
        "You return (p + v) t, because you multiply the position by the time as well.":
            (40, 40, -20),
    }  # fmt: skip
    expect_close(xyz(got), (13.0, -5.0, 16.0), slips)


@pytest.mark.exercise("2.7", asks="None of these changes its arguments", read=MOTION)
def test_the_new_position_is_a_new_vector(rng: Random) -> None:
    start, velocity, duration = vector(rng), vector(rng), rng.uniform(0.1, 20.0)
    with calls(MOVED):
        p, v = Vector3(*start), Vector3(*velocity)
        got = exercises.position_after(p, v, duration=duration)
    # Rounding of numbers up to 200.
    expect_close(xyz(got), start + velocity * duration, tolerance=1e-12)
    for name, now, before in (("p", p, start), ("v", v, velocity)):
        cause = (
            f"You change {name}, which belongs to the caller, because add_scaled, += and *= work "
            "in place. Write p + v * t, which creates a new vector."
        )
        expect_unchanged(name, now, before, cause=cause)


# B2.11 Check an argument before you use it


def expect_refusal(value: Any, error: type[Exception], cause: str) -> None:
    """Expect checked_duration to refuse a value with this error, and to accept half a second."""
    __tracebackhide__ = True
    expect_error(
        lambda: exercises.checked_duration(value),
        error,
        allowed=lambda: exercises.checked_duration(0.5),
        call=f"checked_duration({value!r})",
        cause=cause,
    )


@pytest.mark.exercise("B2.11", asks="the duration of a time step as a float", read=DOC)
def test_a_good_duration_comes_back_as_a_float(rng: Random) -> None:
    for duration in (round(rng.uniform(0.1, 5.0), 3), 1e-300, 1e300, rng.randint(1, 9)):
        with calls(
            f"You reject {duration!r}, which is a valid duration. Accept every positive, finite "
            "number, whether it is an int or a float."
        ):
            got = exercises.checked_duration(duration)
        changed = "You change a valid duration. Return float(duration)."
        expect_close(got, float(duration), tolerance=0.0, cause=changed)
        whole = "You return the duration as an int. Convert it, and return float(duration)."
        expect_exactly(got, float(duration), cause=whole)


@pytest.mark.exercise("B2.11", asks="for zero, a negative number, an infinity or NaN", read=DOC)
def test_zero_and_negative_durations_are_refused(rng: Random) -> None:
    for value in (0.0, -round(rng.uniform(0.1, 5.0), 3), -1e-300, 0):
        cause = f"The duration is {value}, so raise ValueError. Only a duration above 0 is valid."
        expect_refusal(value, ValueError, cause)


@pytest.mark.exercise("B2.11", asks="for zero, a negative number, an infinity or NaN", read=DOC)
def test_infinite_durations_and_nan_are_refused() -> None:
    infinite = "You accept an infinite duration. Reject it with a ValueError."
    nan = (
        "You accept NaN. Every comparison with NaN is False, so reject a duration unless it is in "
        "the valid range, 0.0 < duration < math.inf."
    )
    for value, cause in ((math.inf, infinite), (-math.inf, infinite), (math.nan, nan)):
        expect_refusal(value, ValueError, cause)


@pytest.mark.exercise("B2.11", asks="for anything that is not a number", read=DOC)
@pytest.mark.parametrize("value", ["0.5", None, [0.5]], ids=["text", "none", "list"])
def test_a_duration_that_is_not_a_number_is_refused(value: Any) -> None:
    cause = (
        f"{value!r} is not a number, so raise TypeError. Check isinstance(duration, (int, float)), "
        "because float() accepts a string such as '0.5'."
    )
    expect_refusal(value, TypeError, cause)


@pytest.mark.exercise("B2.11", asks="names the argument, says what it must be", read=DOC)
@pytest.mark.parametrize("value", [-1.5, "soon"], ids=["number", "text"])
def test_the_message_names_the_argument_and_shows_the_value(value: Any) -> None:
    with calls("You reject a valid duration. Raise no error for a positive, finite number."):
        exercises.checked_duration(0.5)
    message, cause = "no error", f"You accept {value!r}, so there is no error message."
    parts = {"duration": "name the argument", str(value): "show the value of the argument"}
    try:
        exercises.checked_duration(value)
    except (ValueError, TypeError) as error:
        message = str(error)
        missing = " or ".join(lack for word, lack in parts.items() if word not in message)
        cause = f"Your error message doesn't {missing}."
    expect_that(
        all(word in message for word in parts),
        repr(message),
        f"a message that contains 'duration' and {str(value)!r}",
        call=f"the error message of checked_duration({value!r})",
        cause=f'{cause} Raise an error with a message such as f"duration must be positive and '
        'finite, got {duration!r}".',
    )
