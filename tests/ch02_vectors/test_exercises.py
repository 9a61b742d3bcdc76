"""Exercises 2.1, 2.4, 2.6 and 2.7; those on angles are in test_angles.py."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors import exercises
from ch02_vectors.vector import Vector3
from draw import components, direction, dot, number
from expect import cause_of, expect_close, expect_error, expect_unchanged, is_plain, xyz

ZERO = (0.0, 0.0, 0.0)


# 2.1 Magnitude and direction


@pytest.mark.exercise("2.1")
def test_split_the_vector_of_the_book() -> None:
    call = "split(Vector3(2, -2, -2))"
    cause = "a pair is wanted: the length, and a new unit vector of the same direction"
    read = "book 2.1"
    magnitude, unit = exercises.split(Vector3(2.0, -2.0, -2.0))
    if not is_plain(magnitude):
        cause = "the pair is the other way round: first the length, then the direction"
    cause = cause_of(magnitude, [(12.0, "that is the squared length")], cause)
    third = 1.0 / math.sqrt(3.0)
    expect_close(f"{call}, the first", magnitude, math.sqrt(12.0), cause=cause, read=read)
    wanted = (third, -third, -third)
    mistakes = [
        ((2.0, -2.0, -2.0), "that is v itself: the direction has the length 1"),
        ((1.0 / 6.0, -1.0 / 6.0, -1.0 / 6.0), "it was divided by the squared length"),
    ]
    cause = cause_of(xyz(unit), mistakes, cause)
    expect_close(f"{call}, the second", xyz(unit), wanted, cause=cause, read=read)


@pytest.mark.exercise("2.1")
def test_split_gives_two_factors_of_the_vector(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    call = f"v = Vector3{a}; split(v)"
    cause = "a pair is wanted: the length, and a new unit vector of the same direction"
    read = "book 2.1"
    magnitude, unit = exercises.split(v)
    length = math.sqrt(dot(a, a))
    expect_close(f"{call}, the first", magnitude, length, cause=cause, read=read)
    wanted = (a[0] / length, a[1] / length, a[2] / length)
    expect_close(f"{call}, the second", xyz(unit), wanted, cause=cause, read=read)
    cause = "v belongs to the caller: normalize changes v itself, normalized makes a new vector"
    expect_unchanged(call, "v", xyz(v), a, cause=cause, read="the docstring of split")


@pytest.mark.exercise("2.1")
def test_split_the_zero_vector() -> None:
    call = "split(Vector3(0, 0, 0))"
    cause = "zero has no direction: nothing may be divided by its length"
    read = "the docstring of split"
    magnitude, unit = exercises.split(Vector3(0.0, 0.0, 0.0))
    expect_close(f"{call}, the first", magnitude, 0.0, cause=cause, read=read)
    expect_close(f"{call}, the second", xyz(unit), ZERO, cause=cause, read=read)


# 2.4 The component that makes two vectors perpendicular


@pytest.mark.exercise("2.4")
def test_the_perpendicular_vector_of_the_book() -> None:
    call = "make_perpendicular(Vector3(1, 2, 3), 7, -2)"
    cause = "solve 1 * 7 + 2 * (-2) + 3 z = 0 for z"
    read = "book 2.1.7"
    got = exercises.make_perpendicular(Vector3(1.0, 2.0, 3.0), 7.0, -2.0)
    mistakes = [
        (1.0, "the sign was lost: 3 z = -(1 * 7 + 2 * (-2))"),
        (-3.0, "that is 3 z: divide by a.z"),
    ]
    cause = cause_of(got, mistakes, cause)
    expect_close(call, got, -1.0, cause=cause, read=read)


@pytest.mark.exercise("2.4")
def test_the_component_makes_the_scalar_product_zero(rng: Random) -> None:
    (ax, ay, az), x, y = components(rng), number(rng), number(rng)
    cause = "solve a.x x + a.y y + a.z z = 0 for z, however small a.z is"
    read = "book 2.1.7"
    for z in (az, -az, az * 1e-12, az * -1e-12):
        call = f"make_perpendicular(Vector3{(ax, ay, z)}, {x}, {y})"
        got = exercises.make_perpendicular(Vector3(ax, ay, z), x, y)
        # Rounding of two terms up to 100 that may cancel, divided by z.
        tolerance = 1e-12 / abs(z)
        wanted = -(ax * x + ay * y) / z
        expect_close(call, got, wanted, cause=cause, read=read, tolerance=tolerance)


@pytest.mark.exercise("2.4")
@pytest.mark.robust
def test_no_component_can_make_up_for_a_zero(rng: Random) -> None:
    x, y, _ = components(rng)
    call = f"make_perpendicular(Vector3({x}, {y}, 0), 1, 2)"
    cause = "with a.z = 0 the new component has no effect: say so with a ValueError"
    read = "the docstring of make_perpendicular"
    expect_error(
        call,
        lambda: exercises.make_perpendicular(Vector3(x, y, 0.0), 1.0, 2.0),
        ValueError,
        allowed=lambda: exercises.make_perpendicular(Vector3(x, y, 1.0), 1.0, 2.0),
        cause=cause,
        read=read,
    )


# 2.6 What is left without the projection


@pytest.mark.exercise("2.6", weight=2)
def test_without_its_projection_a_vector_is_perpendicular(rng: Random) -> None:
    # Of length 1 to rounding, and never just 1.
    a, b = (tuple(n * (1.0 + 1e-15) for n in direction(rng)) for _ in range(2))
    v, w = Vector3(*a), Vector3(*b)
    call = f"v, w = Vector3{a}, Vector3{b}; remove_projection(v, w)"
    cause = "these are unit vectors, to rounding: compare with the tolerance of 1e-6, not with =="
    read = "book 2.1.7"
    c, d, angle = exercises.remove_projection(v, w)
    cause = (
        "three results are wanted: a . b, the vector b - (a . b) a, and a right angle in radians"
    )
    along = dot(a, b)
    name = f"{call}, the first"
    expect_close(name, c, along, cause=cause, read=read, tolerance=1e-12)
    wanted = (b[0] - along * a[0], b[1] - along * a[1], b[2] - along * a[2])
    name = f"{call}, the second"
    mistakes = [
        (tuple(along * n for n in a), "that is c a, the projection itself: take it away from b"),
        (tuple(-n for n in wanted), "that is c a - b: d is b - c a"),
        (tuple(b[i] + along * a[i] for i in range(3)), "that is b + c a: d is b - c a"),
        (tuple(a[i] - along * b[i] for i in range(3)), "that is a - c b: d is b - c a"),
    ]
    expect_close(
        name, xyz(d), wanted, cause=cause_of(xyz(d), mistakes, cause), read=read, tolerance=1e-12
    )
    # By its sine, a right angle is known to the root of a rounding only: of 1e-15, 5e-8.
    name = f"{call}, the third"
    mistakes = [
        (90.0, "that is in degrees: radians are wanted"),
        (math.acos(max(-1.0, min(along, 1.0))), "that is the angle between a and b, not a and d"),
    ]
    cause = cause_of(angle, mistakes, "the angle between a and d, in radians: a right one")
    expect_close(name, angle, math.pi / 2.0, cause=cause, read=read, tolerance=1e-7)
    cause = "add_scaled, -= and *= change the caller's vector: b - a * c makes a new one"
    expect_unchanged(call, "v", xyz(v), a, cause=cause, read="the docstring of remove_projection")
    expect_unchanged(call, "w", xyz(w), b, cause=cause, read="the docstring of remove_projection")


def remove_projection_of_length(length: float) -> object:
    """Call remove_projection with vectors that are not parallel, one of this length."""
    return exercises.remove_projection(Vector3(0.0, length, 0.0), Vector3(0.6, 0.8, 0.0))


@pytest.mark.exercise("2.6")
@pytest.mark.robust
def test_what_is_not_a_unit_vector_is_refused() -> None:
    cause = "a length within 1e-6 of 1 is rounding: compare with that tolerance, not with =="
    read = "the docstring of remove_projection"
    for length in (1.0 - 5e-7, 1.0 + 5e-7):
        call = f"remove_projection(Vector3(0, {length!r}, 0), Vector3(0.6, 0.8, 0))"
        remove_projection_of_length(length)
    cause = "c a is the projection for unit vectors only: look at both lengths first"
    for length in (0.0, 3.0, 1.0 + 2e-6, 1.0 - 2e-6):
        call = f"remove_projection(Vector3(0, {length!r}, 0), Vector3(0.6, 0.8, 0))"
        expect_error(
            call,
            lambda length=length: remove_projection_of_length(length),
            ValueError,
            allowed=lambda: remove_projection_of_length(1.0),
            cause=cause,
            read=read,
        )
    call = "remove_projection(Vector3(1, 0, 0), Vector3(3, 4, 0))"
    expect_error(
        call,
        lambda: exercises.remove_projection(Vector3(1, 0, 0), Vector3(3, 4, 0)),
        ValueError,
        allowed=lambda: exercises.remove_projection(Vector3(1, 0, 0), Vector3(0.6, 0.8, 0)),
        cause=cause,
        read=read,
    )


@pytest.mark.exercise("2.6", weight=0.5)
@pytest.mark.robust
def test_nan_is_not_a_unit_vector() -> None:
    call = "remove_projection(Vector3(0, nan, 0), Vector3(0.6, 0.8, 0))"
    cause = "its length is NaN, which is not 1"
    read = "the docstring of remove_projection"
    expect_error(
        call,
        lambda: remove_projection_of_length(math.nan),
        ValueError,
        allowed=lambda: remove_projection_of_length(1.0),
        cause=cause,
        read=read,
    )


@pytest.mark.exercise("2.6")
@pytest.mark.robust
def test_nothing_is_left_of_a_parallel_vector(rng: Random) -> None:
    a = direction(rng)
    cause = "d is zero but for rounding, and has no direction to measure: raise ValueError"
    read = "the docstring of remove_projection"
    for b in (a, (-a[0], -a[1], -a[2])):
        call = f"remove_projection(Vector3{a}, Vector3{b})"
        expect_error(
            call,
            lambda b=b: exercises.remove_projection(Vector3(*a), Vector3(*b)),
            ValueError,
            allowed=lambda: remove_projection_of_length(1.0),
            cause=cause,
            read=read,
        )
    cause = "what is left counts as nothing where d is shorter than 1e-6, not only where it is 0"
    x = Vector3(1.0, 0.0, 0.0)
    # Both are 1 long to the last digit, and d is what they have along Y.
    short, enough = (Vector3(math.sqrt(1.0 - y * y), y, 0.0) for y in (5e-7, 1.5e-6))
    expect_error(
        f"remove_projection(Vector3(1, 0, 0), Vector3({short.x!r}, 5e-07, 0))",
        lambda: exercises.remove_projection(x, short),
        ValueError,
        allowed=lambda: exercises.remove_projection(x, enough),
        cause=cause,
        read=read,
    )


# 2.7 A position that changes with a velocity


@pytest.mark.exercise("2.7")
def test_ten_seconds_with_the_velocity_of_the_book() -> None:
    call = "position_after(Vector3(3, 5, -4), Vector3(1, -1, 2), 10)"
    cause = "p' = p + v t, as a new vector"
    read = "book 2.2, Eq. 2.7"
    got = exercises.position_after(Vector3(3, 5, -4), Vector3(1, -1, 2), 10)
    mistakes = [
        ((4, 4, -2), "the velocity was added once, as if one second had passed: multiply it by t"),
        ((10, -10, 20), "that is v t, the way alone: add it to p"),
        ((40, 40, -20), "that is (p + v) t: the position is not multiplied"),
    ]
    cause = cause_of(xyz(got), mistakes, cause)
    expect_close(call, xyz(got), (13.0, -5.0, 16.0), cause=cause, read=read)


@pytest.mark.exercise("2.7")
def test_the_new_position_leaves_the_old_one_alone(rng: Random) -> None:
    start, velocity, duration = components(rng), components(rng), rng.uniform(0.1, 20.0)
    p, v = Vector3(*start), Vector3(*velocity)
    call = f"p, v = Vector3{start}, Vector3{velocity}; position_after(p, v, {duration})"
    cause = "p' = p + v t, as a new vector"
    read = "book 2.2, Eq. 2.7"
    got = exercises.position_after(p, v, duration)
    wanted = tuple(x + step * duration for x, step in zip(start, velocity, strict=True))
    # Rounding of numbers up to 200.
    expect_close(call, xyz(got), wanted, cause=cause, read=read, tolerance=1e-12)
    read = "the docstring of position_after"
    cause = "add_scaled, += and *= change the caller's vector: p + v * t makes a new one"
    expect_unchanged(call, "p", xyz(p), start, cause=cause, read=read)
    expect_unchanged(call, "v", xyz(v), velocity, cause=cause, read=read)


@pytest.mark.exercise("2.7")
@pytest.mark.robust
@pytest.mark.parametrize("duration", [0.0, -1.0, math.inf, math.nan])
def test_a_duration_must_be_positive_and_finite(duration: float) -> None:
    call = f"position_after(Vector3(1, 2, 3), Vector3(1, 1, 1), {duration})"
    cause = "refuse it with ValueError: no time passes in it, or time runs back or for ever"
    read = "the docstring of position_after"
    expect_error(
        call,
        lambda: exercises.position_after(Vector3(1, 2, 3), Vector3(1, 1, 1), duration),
        ValueError,
        allowed=lambda: exercises.position_after(Vector3(1, 2, 3), Vector3(1, 1, 1), 1.0),
        cause=cause,
        read=read,
    )
