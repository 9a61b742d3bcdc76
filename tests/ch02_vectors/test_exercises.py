"""Exercises 2.1 to 2.7."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors import exercises
from ch02_vectors.vector import Vector3
from draw import Components, components, direction, number
from expect import expect_close, expect_error, expect_exactly, expect_unchanged, xyz


def two_at_an_angle(rng: Random, angle: float) -> tuple[Components, Components]:
    """Draw two vectors that enclose this angle: one along u, one at the angle from u towards w."""
    u, v = direction(rng), direction(rng)
    along = math.fsum(p * q for p, q in zip(u, v, strict=True))
    rest = [q - along * p for p, q in zip(u, v, strict=True)]
    length = math.hypot(*rest)
    if length < 0.1:  # nearly parallel: rounding would turn the angle
        return two_at_an_angle(rng, angle)
    w = [number / length for number in rest]
    first, second = rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    cosine, sine = second * math.cos(angle), second * math.sin(angle)
    a = (first * u[0], first * u[1], first * u[2])
    b = (
        cosine * u[0] + sine * w[0],
        cosine * u[1] + sine * w[1],
        cosine * u[2] + sine * w[2],
    )
    return a, b


# 2.1 Magnitude and direction


@pytest.mark.exercise("2.1")
def test_split_the_vector_of_the_book() -> None:
    magnitude, unit = exercises.split(Vector3(2.0, -2.0, -2.0))
    call = "split(Vector3(2, -2, -2))"
    read = "book 2.1"
    third = 1.0 / math.sqrt(3.0)
    cause = "the first of the pair is the length"
    expect_close(call + "[0]", magnitude, math.sqrt(12.0), cause=cause, read=read)
    cause = "the second of the pair is the unit vector of the same direction"
    expect_close(call + "[1]", xyz(unit), (third, -third, -third), cause=cause, read=read)


@pytest.mark.exercise("2.1")
def test_split_gives_two_factors_of_the_vector(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    magnitude, unit = exercises.split(v)
    call = f"split(Vector3{a})"
    read = "book 2.1"
    length = math.sqrt(math.fsum(number * number for number in a))
    cause = "the first of the pair is the length"
    expect_close(call + "[0]", magnitude, length, cause=cause, read=read)
    wanted = tuple(number / length for number in a)
    cause = "the second of the pair is the unit vector of the same direction"
    expect_close(call + "[1]", xyz(unit), wanted, cause=cause, read=read)
    expect_unchanged(call, "v", xyz(v), a, read="the docstring of split")


@pytest.mark.exercise("2.1")
def test_split_the_zero_vector() -> None:
    magnitude, unit = exercises.split(Vector3(0.0, 0.0, 0.0))
    call = "split(Vector3(0, 0, 0))"
    read = "the docstring of split"
    cause = "nothing may be divided by a length of zero"
    expect_exactly(call + "[0]", magnitude, 0.0, cause=cause, read=read)
    expect_exactly(call + "[1]", xyz(unit), (0.0, 0.0, 0.0), cause=cause, read=read)


# 2.2a A scalar product and what its sign says


@pytest.mark.exercise("2.2a")
@pytest.mark.parametrize("word", ["acute", "obtuse"])
def test_the_sign_of_a_scalar_product_names_the_angle(rng: Random, word: str) -> None:
    low, high = (0.1, 1.5) if word == "acute" else (1.6, 3.0)
    a, b = two_at_an_angle(rng, rng.uniform(low, high))
    product, got = exercises.scalar_product_and_angle(Vector3(*a), Vector3(*b))
    call = f"scalar_product_and_angle(Vector3{a}, Vector3{b})"
    wanted = math.fsum(p * q for p, q in zip(a, b, strict=True))
    read = "book 2.1.7, Eq. 2.4"
    cause = "the first of the pair is a . b, not divided by the lengths"
    expect_close(call + "[0]", product, wanted, cause=cause, read=read, tolerance=1e-12)
    cause = "a positive product means an acute angle, a negative one an obtuse angle"
    expect_exactly(call + "[1]", got, word, cause=cause, read=read)


@pytest.mark.exercise("2.2a")
def test_a_scalar_product_of_zero_is_a_right_angle(rng: Random) -> None:
    x, y = float(rng.randint(1, 9)), float(rng.randint(1, 9))  # whole, so that nothing is rounded
    product, got = exercises.scalar_product_and_angle(Vector3(x, y, 0.0), Vector3(-y, x, 3.0))
    call = f"scalar_product_and_angle(Vector3({x}, {y}, 0), Vector3({-y}, {x}, 3))"
    read = "book 2.1.7, Eq. 2.4"
    expect_close(call + "[0]", product, 0.0, cause="the products cancel", read=read)
    expect_exactly(call + "[1]", got, "right", cause="cos t = 0 at a right angle", read=read)


# 2.4 The component that makes two vectors perpendicular


@pytest.mark.exercise("2.4")
def test_the_perpendicular_vector_of_the_book() -> None:
    expect_close(
        "make_perpendicular(Vector3(1, 2, 3), 7, -2)",
        exercises.make_perpendicular(Vector3(1.0, 2.0, 3.0), 7.0, -2.0),
        -1.0,
        cause="solve 1 * 7 + 2 * (-2) + 3 z = 0: mind the sign",
        read="book 2.1.7",
    )


@pytest.mark.exercise("2.4")
def test_the_component_makes_the_scalar_product_zero(rng: Random) -> None:
    a, x, y = components(rng), number(rng), number(rng)
    expect_close(
        f"make_perpendicular(Vector3{a}, {x}, {y})",
        exercises.make_perpendicular(Vector3(*a), x, y),
        -(a[0] * x + a[1] * y) / a[2],
        cause="solve a.x x + a.y y + a.z z = 0 for z",
        read="book 2.1.7",
        tolerance=1e-11,  # rounding of two terms that may cancel, divided by 0.5 at the least
    )


@pytest.mark.exercise("2.4")
def test_no_component_can_make_up_for_a_zero(rng: Random) -> None:
    x, y, _ = components(rng)
    expect_error(
        f"make_perpendicular(Vector3({x}, {y}, 0), 1, 2)",
        lambda: exercises.make_perpendicular(Vector3(x, y, 0.0), 1.0, 2.0),
        ValueError,
        allowed=lambda: exercises.make_perpendicular(Vector3(x, y, 1.0), 1.0, 2.0),
        cause="with a.z = 0 the new component has no effect: say so with a ValueError",
        read="the docstring of make_perpendicular",
    )


# 2.5 The angle between two vectors, in two ways


@pytest.mark.exercise("2.5")
def test_the_angles_of_the_book() -> None:
    a, b = Vector3(0.0, 1.0, 1.0), Vector3(0.0, -1.0, 0.0)
    read = "book 2.1.7 and 2.1.8"
    cause = "135 degrees, in radians: divide by both lengths, and keep the sign of the product"
    got = exercises.angle_by_scalar_product(a, b)
    call = "(Vector3(0, 1, 1), Vector3(0, -1, 0))"
    expect_close(f"angle_by_scalar_product{call}", got, 0.75 * math.pi, cause=cause, read=read)
    cause = "45 and 135 degrees have the same sine: both are wanted, the smaller one first"
    angles = exercises.angles_by_vector_product(a, b)
    wanted = (0.25 * math.pi, 0.75 * math.pi)
    # asin is 1.4 times as sensitive to rounding here as its argument.
    expect_close(f"angles_by_vector_product{call}", angles, wanted, cause=cause, read=read)


@pytest.mark.exercise("2.5")
@pytest.mark.parametrize("kind", ["acute", "obtuse"])
def test_the_angle_by_the_scalar_product(rng: Random, kind: str) -> None:
    angle = rng.uniform(0.3, 1.4) if kind == "acute" else rng.uniform(1.7, 2.8)
    a, b = two_at_an_angle(rng, angle)
    v, w = Vector3(*a), Vector3(*b)
    call = f"angle_by_scalar_product(Vector3{a}, Vector3{b})"
    read = "book 2.1.7, Eq. 2.4"
    cause = "cos t is the product divided by both lengths; math.acos gives radians"
    got = exercises.angle_by_scalar_product(v, w)
    # Rounding is divided by sin t, 0.3 at the least, and drawing the vectors adds its own.
    expect_close(call, got, angle, cause=cause, read=read, tolerance=1e-12)
    expect_unchanged(call, "a", xyz(v), a, read=read)
    expect_unchanged(call, "b", xyz(w), b, read=read)


@pytest.mark.exercise("2.5")
@pytest.mark.parametrize("kind", ["acute", "obtuse"])
def test_the_angles_by_the_vector_product(rng: Random, kind: str) -> None:
    angle = rng.uniform(0.3, 1.4) if kind == "acute" else rng.uniform(1.7, 2.8)
    a, b = two_at_an_angle(rng, angle)
    v, w = Vector3(*a), Vector3(*b)
    call = f"angles_by_vector_product(Vector3{a}, Vector3{b})"
    read = "book 2.1.8, Eq. 2.6"
    cause = "sin t = sin(pi - t): return both, the smaller one first"
    got = exercises.angles_by_vector_product(v, w)
    wanted = (min(angle, math.pi - angle), max(angle, math.pi - angle))
    # Rounding is divided by |cos t|, 0.12 at the least, and drawing the vectors adds its own.
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-11)
    expect_unchanged(call, "a", xyz(v), a, read=read)
    expect_unchanged(call, "b", xyz(w), b, read=read)


@pytest.mark.exercise("2.5")
def test_parallel_and_perpendicular_vectors_have_angles_too(rng: Random) -> None:
    # 40 pairs: for many of them rounding leaves a cosine, or a sine, of just more than 1.
    cause = "rounding can leave just more than 1, which math.acos and math.asin refuse: clamp it"
    read = "the hints of exercise 2.5"
    for _ in range(40):
        a, scale = components(rng), rng.uniform(0.1, 9.0)
        for sign, angle in ((1.0, 0.0), (-1.0, math.pi)):
            b = tuple(sign * scale * number for number in a)
            got = exercises.angle_by_scalar_product(Vector3(*a), Vector3(*b))
            call = f"angle_by_scalar_product(Vector3{a}, Vector3{b})"
            # Near 0 and pi acos turns a rounding of 1e-16 into its root, 1e-8.
            expect_close(call, got, angle, cause=cause, read=read, tolerance=1e-7)
        c = (a[1], -a[0], 0.0)
        both = exercises.angles_by_vector_product(Vector3(*a), Vector3(*c))
        call = f"angles_by_vector_product(Vector3{a}, Vector3{c})"
        right = math.pi / 2.0
        expect_close(call, both, (right, right), cause=cause, read=read, tolerance=1e-7)


@pytest.mark.exercise("2.5")
@pytest.mark.parametrize("name", ["angle_by_scalar_product", "angles_by_vector_product"])
def test_a_zero_vector_has_no_angle(rng: Random, name: str) -> None:
    a = components(rng)
    function = getattr(exercises, name)
    zero = Vector3(0.0, 0.0, 0.0)

    def right_angle() -> object:
        return function(Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0))

    read = f"the docstring of {name}"
    cause = "a zero vector points nowhere: raise ValueError, do not return some angle"
    for call, attempt in (
        (f"{name}(Vector3{a}, Vector3(0, 0, 0))", lambda: function(Vector3(*a), zero)),
        (f"{name}(Vector3(0, 0, 0), Vector3{a})", lambda: function(zero, Vector3(*a))),
    ):
        expect_error(call, attempt, ValueError, allowed=right_angle, cause=cause, read=read)


# 2.6 What is left without the projection


def unit_vectors_with_a_projection() -> object:
    return exercises.remove_projection(Vector3(1.0, 0.0, 0.0), Vector3(0.6, 0.8, 0.0))


@pytest.mark.exercise("2.6")
def test_without_its_projection_a_vector_is_perpendicular(rng: Random) -> None:
    a, b = direction(rng), direction(rng)
    v, w = Vector3(*a), Vector3(*b)
    c, d, angle = exercises.remove_projection(v, w)
    call = f"remove_projection(Vector3{a}, Vector3{b})"
    read = "book 2.1.7"
    along = math.fsum(p * q for p, q in zip(a, b, strict=True))
    cause = "the first is a . b"
    expect_close(call + "[0]", c, along, cause=cause, read=read, tolerance=1e-12)
    wanted = tuple(q - along * p for p, q in zip(a, b, strict=True))
    cause = "the second is b - c a, the part of b along a taken away"
    expect_close(call + "[1]", xyz(d), wanted, cause=cause, read=read, tolerance=1e-12)
    cause = "the third is the angle between a and d in radians, always a right angle"
    # The two directions are at least 0.05 apart with these draws: rounding is divided by it.
    expect_close(call + "[2]", angle, math.pi / 2.0, cause=cause, read=read, tolerance=1e-10)
    expect_unchanged(call, "a", xyz(v), a, read="the docstring of remove_projection")
    expect_unchanged(call, "b", xyz(w), b, read="the docstring of remove_projection")


@pytest.mark.exercise("2.6")
def test_what_is_not_a_unit_vector_is_refused(rng: Random) -> None:
    unit, long = direction(rng), components(rng)
    cause = "c a is the projection only for unit vectors: raise ValueError for others"
    read = "the docstring of remove_projection"
    for a, b in ((unit, long), (long, unit), (unit, (math.nan, 0.0, 0.0))):
        expect_error(
            f"remove_projection(Vector3{a}, Vector3{b})",
            lambda a=a, b=b: exercises.remove_projection(Vector3(*a), Vector3(*b)),
            ValueError,
            allowed=unit_vectors_with_a_projection,
            cause=cause,
            read=read,
        )


@pytest.mark.exercise("2.6")
def test_nothing_is_left_of_a_parallel_vector(rng: Random) -> None:
    a = direction(rng)
    for sign in (1.0, -1.0):
        b = (sign * a[0], sign * a[1], sign * a[2])
        expect_error(
            f"remove_projection(Vector3{a}, Vector3{b})",
            lambda b=b: exercises.remove_projection(Vector3(*a), Vector3(*b)),
            ValueError,
            allowed=unit_vectors_with_a_projection,
            cause="d is zero but for rounding, and has no direction to measure",
            read="the docstring of remove_projection",
        )


# 2.7 A position that changes with a velocity


@pytest.mark.exercise("2.7")
def test_ten_seconds_with_the_velocity_of_the_book() -> None:
    expect_close(
        "position_after(Vector3(3, 5, -4), Vector3(1, -1, 2), 10)",
        xyz(exercises.position_after(Vector3(3, 5, -4), Vector3(1, -1, 2), 10)),
        (13.0, -5.0, 16.0),
        cause="p' = p + v t",
        read="book 2.2, Eq. 2.7",
    )


@pytest.mark.exercise("2.7")
def test_the_new_position_leaves_the_old_one_alone(rng: Random) -> None:
    start, velocity, duration = components(rng), components(rng), rng.uniform(0.1, 20.0)
    p, v = Vector3(*start), Vector3(*velocity)
    call = f"position_after(Vector3{start}, Vector3{velocity}, {duration})"
    got = exercises.position_after(p, v, duration)
    wanted = tuple(x + step * duration for x, step in zip(start, velocity, strict=True))
    read = "book 2.2, Eq. 2.7"
    cause = "p' = p + v t, as a new vector"
    expect_close(call, xyz(got), wanted, cause=cause, read=read, tolerance=1e-12)
    expect_unchanged(call, "position", xyz(p), start, read="the docstring of position_after")
    expect_unchanged(call, "velocity", xyz(v), velocity, read="the docstring of position_after")


@pytest.mark.exercise("2.7")
@pytest.mark.parametrize("duration", [0.0, -1.0, math.inf, math.nan])
def test_a_duration_must_be_positive_and_finite(duration: float) -> None:
    expect_error(
        f"position_after(Vector3(1, 2, 3), Vector3(1, 1, 1), {duration})",
        lambda: exercises.position_after(Vector3(1, 2, 3), Vector3(1, 1, 1), duration),
        ValueError,
        allowed=lambda: exercises.position_after(Vector3(1, 2, 3), Vector3(1, 1, 1), 1.0),
        cause="NaN compares false with everything, so ask for what is wanted and refuse the rest",
        read="the docstring of position_after",
    )
