"""Exercises 2.1, 2.4, 2.6 and 2.7. The exercises on angles are in test_angles.py."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors import exercises
from ch02_vectors.vector import Vector3
from draw import components, direction, dot, number, rounded
from expect import (
    about,
    blame,
    cause_of,
    expect_close,
    expect_error,
    expect_that,
    expect_unchanged,
    is_plain,
    xyz,
)

ZERO = (0.0, 0.0, 0.0)


# 2.1 Magnitude and direction


@pytest.mark.exercise("2.1", asks="takes a vector and returns these two parts")
def test_split_the_vector_of_the_book() -> None:
    about.call = "split(Vector3(2, -2, -2))"
    about.cause = (
        "Return a pair: the length of v, and a new vector of length 1 that points in the same "
        "direction."
    )
    about.read = "book 2.1.2"
    magnitude, unit = exercises.split(Vector3(2.0, -2.0, -2.0))
    if not is_plain(magnitude):
        about.cause = (
            "You return the two results in the wrong order. Return the length first and the "
            "direction second."
        )
    blame(
        magnitude,
        [
            (
                12.0,
                "You return the squared length of v as the first result. Return the length itself, "
                "which is v.magnitude().",
            ),
            (
                1.0,
                "You measure the length of a vector that is already normalized, so it is 1. "
                "Measure the length of v first, and don't change v.",
            ),
        ],
    )
    third = 1.0 / math.sqrt(3.0)
    expect_close(magnitude, math.sqrt(12.0), then="; the first result, the length")
    nothing = "Your second result is None, as v.normalize() returns it. Return v.normalized()."
    where = "; the second result, the direction"
    expect_that(unit is not None, "None, no vector", "a vector", then=where, cause=nothing)
    wanted = (third, -third, -third)
    mistakes = [
        (
            (2.0, -2.0, -2.0),
            "You return v itself as the second result. Divide v by its length to get its "
            "direction, which is a vector of length 1.",
        ),
        (
            (1.0 / 6.0, -1.0 / 6.0, -1.0 / 6.0),
            "You divide v by its squared length. Divide it by its length instead, so that the "
            "result has length 1.",
        ),
    ]
    blame(xyz(unit), mistakes)
    expect_close(xyz(unit), wanted, then="; the second result, the direction")


@pytest.mark.exercise("2.1", asks="its magnitude and its direction: a unit vector")
def test_split_returns_the_length_and_the_direction(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; split(v)"
    about.cause = (
        "Return a pair: the length of v, and a new vector of length 1 that points in the same "
        "direction."
    )
    about.read = "book 2.1.2"
    magnitude, unit = exercises.split(v)
    length = math.sqrt(dot(a, a))
    expect_close(magnitude, length, then="; the first result, the length")
    wanted = (a[0] / length, a[1] / length, a[2] / length)
    expect_close(xyz(unit), wanted, then="; the second result, the direction")
    about.cause = (
        "You change v, because normalize works in place. Use normalized, which returns a new "
        "vector."
    )
    expect_unchanged("v", xyz(v), a, read="the docstring of split")


@pytest.mark.exercise("2.1", asks="or zero for zero")
def test_split_the_zero_vector() -> None:
    about.call = "split(Vector3(0, 0, 0))"
    about.cause = (
        "The length of this vector is 0, so don't divide by it. Return 0 and a new zero vector as "
        "the direction."
    )
    about.read = "the docstring of split"
    magnitude, unit = exercises.split(Vector3(0.0, 0.0, 0.0))
    expect_close(magnitude, 0.0, then="; the first result, the length")
    expect_close(xyz(unit), ZERO, then="; the second result, the direction")


# 2.4 The component that makes two vectors perpendicular


@pytest.mark.exercise("2.4", asks="Find the z that makes the vector")
def test_the_perpendicular_vector_of_the_book() -> None:
    about.call = "make_perpendicular(Vector3(1, 2, 3), x=7, y=-2)"
    about(
        cause="Two vectors are perpendicular if their scalar product is 0. Solve 1 * 7 + 2 * (-2) "
        "+ 3 z = 0 for z.",
        read="book 2.1.7",
    )
    got = exercises.make_perpendicular(Vector3(1.0, 2.0, 3.0), 7.0, -2.0)
    mistakes = [
        (
            1.0,
            "Your z has the wrong sign. The x and y terms change sign on the other side of the "
            "equation: 3 z = -(1 * 7 + 2 * (-2)).",
        ),
        (
            -3.0,
            "You solve the equation for 3 z, not for z. Divide the result by a.z, which is 3 here.",
        ),
        (
            -7.0 - 4.0 / 3.0,
            "Your formula lacks brackets, so the minus sign and the division each apply to one "
            "term only. Compute -(a.x x + a.y y) / a.z.",
        ),
        (
            -7.0 + 4.0 / 3.0,
            "Your formula lacks brackets, so only the last term is divided. Divide the whole sum: "
            "-(a.x x + a.y y) / a.z.",
        ),
        (
            -9.0,
            "You multiply by a.z. Divide by it to solve the equation for z.",
        ),
        (
            -11.0 / 3.0,
            "You subtract the term of y instead of adding it. Solve 3 z = -(1 * 7 + 2 * (-2)).",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, -1.0)


@pytest.mark.exercise("2.4", asks="the vector (x, y, z) perpendicular to a")
def test_the_component_makes_the_scalar_product_zero(rng: Random) -> None:
    (ax, ay, az), x, y = components(rng), number(rng), number(rng)
    about.read = "book 2.1.7"
    for z in (az, -az, az * 1e-12, az * -1e-12):
        about.cause = (
            f"You reject a.z = {z:.4g}, but the equation has a solution for every a.z except 0. "
            "Compare a.z with 0 exactly."
        )
        about.call = f"make_perpendicular(Vector3{(ax, ay, z)}, x={x}, y={y})"
        got = exercises.make_perpendicular(Vector3(ax, ay, z), x, y)
        about.cause = "Solve a.x x + a.y y + a.z z = 0 for z. Subtract a.x x and a.y y first."
        # The rounding errors of two terms of up to 100, which may cancel, are divided by z.
        tolerance = 1e-12 / abs(z)
        wanted = -(ax * x + ay * y) / z
        floor = "You divide with //, which rounds down to a whole number. Use / instead."
        mistakes = [
            (-(ax * x + ay * y) // z, floor),
            (-((ax * x + ay * y) // z), floor),
            (
                (-ax * x + ay * y) / z,
                "The minus sign applies only to your first term. Compute -(a.x x + a.y y) / a.z.",
            ),
        ]
        blame(got, mistakes)
        expect_close(got, wanted, tolerance=tolerance)


@pytest.mark.exercise("2.4", asks="if a.z is zero, because then z changes nothing")
@pytest.mark.robust
def test_a_z_component_of_zero_is_refused(rng: Random) -> None:
    x, y, _ = components(rng)
    about.call = f"make_perpendicular(Vector3({x}, {y}, 0), x=1, y=2)"
    about.cause = (
        "You cannot divide by a.z, which is 0 here, so the equation has no solution. Check a.z "
        "first and raise ValueError."
    )
    about.read = "the docstring of make_perpendicular"
    expect_error(
        lambda: exercises.make_perpendicular(Vector3(x, y, 0.0), 1.0, 2.0),
        ValueError,
        allowed=lambda: exercises.make_perpendicular(Vector3(x, y, 1.0), 1.0, 2.0),
    )


# 2.6 The rest of a vector after a projection


@pytest.mark.exercise("2.6", asks="Return c, d and the angle", weight=2)
def test_without_its_projection_a_vector_is_perpendicular(rng: Random) -> None:
    # Their length is 1 within rounding, but not exactly.
    a, b = (tuple(n * (1.0 + 1e-15) for n in direction(rng)) for _ in range(2))
    v, w = Vector3(*a), Vector3(*b)
    about.call = (
        f"a = Vector3{rounded(a)}  # a unit vector, rounded to 6 digits; "
        f"b = Vector3{rounded(b)}  # a unit vector, rounded to 6 digits; remove_projection(a, b)"
    )
    about.cause = (
        "Return three results: the number c = a . b, the vector d = b - c a, and the angle between "
        "a and d in radians."
    )
    about.read = "book 2.1.7"
    c, d, angle = exercises.remove_projection(v, w)
    along = dot(a, b)
    name = f"{about.call}; the first result, c"
    if not is_plain(c):
        about.cause = "You return the results in the wrong order. Return c, d and the angle."
    expect_close(c, along, call=name, tolerance=1e-12)
    wanted = (b[0] - along * a[0], b[1] - along * a[1], b[2] - along * a[2])
    name = f"{about.call}; the second result, d"
    mistakes = [
        (
            tuple(along * n for n in a),
            "You return the projection of b onto a. Subtract it from b to get d, the part of b "
            "that is perpendicular to a.",
        ),
        (
            tuple(-n for n in wanted),
            "You return c a - b, which points in the opposite direction. Return d = b - c a.",
        ),
        (
            tuple(b[i] + along * a[i] for i in range(3)),
            "You add the projection of b onto a to b. Subtract it instead: d = b - c a, where c = "
            "a . b.",
        ),
        (
            tuple(n - along * n for n in b),
            "You subtract c b instead of c a. Return d = b - c a.",
        ),
        (
            tuple(m - n for m, n in zip(b, a, strict=True)),
            "Your d is b - a. Multiply a by c first: d = b - c a.",
        ),
        (
            tuple(n / math.hypot(*wanted) for n in wanted),
            "You normalize d. Return d = b - c a as it is.",
        ),
        (
            tuple(a[i] - along * b[i] for i in range(3)),
            "You return a - c b, because you swap a and b. Return d = b - c a.",
        ),
    ]
    expect_close(
        xyz(d), wanted, call=name, cause=cause_of(xyz(d), mistakes, about.cause), tolerance=1e-12
    )
    # A sine gives a right angle only to the root of a rounding error: 5e-8 for 1e-15.
    name = f"{about.call}; the third result, the angle"
    mistakes = [
        (
            90.0,
            "Your angle is in degrees, but it must be in radians. The math module already returns "
            "radians, so don't convert the angle.",
        ),
        (
            0.0,
            "Your angle is 0, as if you returned the scalar product of a and d, or its arcsine. "
            "Pass the cosine of the angle to math.acos.",
        ),
        (
            math.acos(max(-1.0, min(math.sqrt(1.0 - along**2), 1.0))),
            "You return the angle between b and d. Return the angle between a and d instead.",
        ),
        (
            math.acos(max(-1.0, min(along, 1.0))),
            "You return the angle between a and b. Return the angle between a and d instead.",
        ),
    ]
    about.cause = cause_of(
        angle,
        mistakes,
        "The angle between a and d must be pi / 2, because d is perpendicular to a. Check how you "
        "compute this angle.",
    )
    expect_close(angle, math.pi / 2.0, call=name, tolerance=1e-7)
    about.read = "the docstring of remove_projection"
    for name, now, before in (("a", xyz(v), a), ("b", xyz(w), b)):
        about.cause = (
            f"You change {name}, which belongs to the caller, because add_scaled, -= and *= work "
            "in place. Write b - a * c, which creates a new vector."
        )
        expect_unchanged(name, now, before)


def remove_projection_of_length(length: float) -> object:
    """Call remove_projection with vectors that are not parallel, one of them of this length."""
    return exercises.remove_projection(Vector3(0.0, length, 0.0), Vector3(0.6, 0.8, 0.0))


@pytest.mark.exercise("2.6", asks="if d is shorter than 1e-6")
@pytest.mark.robust
def test_the_projection_of_parallel_vectors_is_refused(rng: Random) -> None:
    a = direction(rng)
    about.cause = (
        "You accept parallel vectors, although d is then only a rounding error without a "
        "direction. Raise ValueError."
    )
    about.read = "the docstring of remove_projection"
    for b, second in ((a, "a"), ((-a[0], -a[1], -a[2]), "-a")):
        about.call = f"a = Vector3{rounded(a)}  # a unit vector, rounded to 6 digits; "
        about.call += f"remove_projection(a, {second})"
        expect_error(
            lambda b=b: exercises.remove_projection(Vector3(*a), Vector3(*b)),
            ValueError,
            allowed=lambda: remove_projection_of_length(1.0),
        )
    about.cause = (
        "Here b is nearly parallel to a, so the length of d is only 5e-7. Raise ValueError if the "
        "length of d is below 1e-6."
    )
    x = Vector3(1.0, 0.0, 0.0)
    # Both have length 1 to the last digit, and d is their Y component.
    short, enough = (Vector3(math.sqrt(1.0 - y * y), y, 0.0) for y in (5e-7, 1.5e-6))
    expect_error(
        lambda: exercises.remove_projection(x, short),
        ValueError,
        call="remove_projection(Vector3(1, 0, 0), Vector3(0.9999999999999, 5e-07, 0))",
        allowed=lambda: exercises.remove_projection(x, enough),
        valid="remove_projection(Vector3(1, 0, 0), Vector3(0.9999999999989, 1.5e-06, 0))",
    )


# 2.7 A position that changes with a velocity


@pytest.mark.exercise("2.7", asks="the position after a motion at constant velocity")
def test_ten_seconds_with_the_velocity_of_the_book() -> None:
    about.call = "position_after(Vector3(3, 5, -4), Vector3(1, -1, 2), duration=10)"
    about(
        cause="The position after a time t must be p' = p + v t. Return it as a new vector.",
        read="book 2.2, Eq. 2.7",
    )
    got = exercises.position_after(Vector3(3, 5, -4), Vector3(1, -1, 2), 10)
    mistakes = [
        (
            (4, 4, -2),
            "You add the velocity as if one second had passed. Multiply it by the time t first.",
        ),
        ((3.1, 4.9, -3.8), "You divide the velocity by the time. Multiply it by the time."),
        ((10, -10, 20), "You return only the displacement v t. Add it to the position p."),
        (
            (-7, 15, -24),
            "You subtract v t, so the body moves backward. Add v t to the position p.",
        ),
        (
            (40, 40, -20),
            "You return (p + v) t, because you multiply the position by the time as well. Multiply "
            "only the velocity by t.",
        ),
    ]
    blame(xyz(got), mistakes)
    expect_close(xyz(got), (13.0, -5.0, 16.0))


@pytest.mark.exercise("2.7", asks="None of these changes its arguments")
def test_the_new_position_is_a_new_vector(rng: Random) -> None:
    start, velocity, duration = components(rng), components(rng), rng.uniform(0.1, 20.0)
    p, v = Vector3(*start), Vector3(*velocity)
    about.call = (
        f"p, v = Vector3{start}, Vector3{velocity}; position_after(p, v, duration={duration:.6g})"
    )
    about(
        cause="The position after a time t must be p' = p + v t. Return it as a new vector.",
        read="book 2.2, Eq. 2.7",
    )
    got = exercises.position_after(p, v, duration)
    wanted = tuple(x + step * duration for x, step in zip(start, velocity, strict=True))
    # Rounding of numbers up to 200.
    expect_close(xyz(got), wanted, tolerance=1e-12)
    about.read = "the docstring of position_after"
    for name, now, before in (("p", xyz(p), start), ("v", xyz(v), velocity)):
        about.cause = (
            f"You change {name}, which belongs to the caller, because add_scaled, += and *= work "
            "in place. Write p + v * t, which creates a new vector."
        )
        expect_unchanged(name, now, before)
