"""The exercises on angles, 2.2a and 2.5."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors import exercises
from ch02_vectors.vector import Vector3
from draw import Components, components, direction, dot
from expect import (
    UNCHANGED,
    about,
    blame,
    expect_close,
    expect_error,
    expect_exactly,
    expect_nan,
    expect_unchanged,
    xyz,
)


def two_at_an_angle(rng: Random, angle: float) -> tuple[Components, Components]:
    """Draw two vectors that enclose this angle: one along u, one at the angle from u towards w."""
    u, v = direction(rng), direction(rng)
    along = dot(u, v)
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


# 2.2a A scalar product and what its sign says


@pytest.mark.exercise("2.2a")
@pytest.mark.parametrize("word", ["acute", "obtuse"])
def test_the_sign_of_a_scalar_product_names_the_angle(rng: Random, word: str) -> None:
    low, high = (0.1, 1.5) if word == "acute" else (1.6, 3.0)
    long, b = two_at_an_angle(rng, rng.uniform(low, high))
    about.read = "book 2.1.7, Eq. 2.4"
    for a in (long, (0.01 * long[0], 0.01 * long[1], 0.01 * long[2])):
        about.call = f"scalar_product_and_angle(Vector3{a}, Vector3{b})"
        about.cause = "a pair is wanted: a . b and a word"
        product, got = exercises.scalar_product_and_angle(Vector3(*a), Vector3(*b))
        cosine = dot(a, b) / math.sqrt(dot(a, a) * dot(b, b))
        divided = "that is the cosine: a . b is wanted as it is, not divided by the lengths"
        blame(product, [(cosine, divided)])
        expect_close(product, dot(a, b), then=", the first", tolerance=1e-12)
        about.cause = "a positive product means an acute angle, a negative one an obtuse angle"
        if got == "right":
            about.cause = "a small product is not zero: its sign still says what the angle is"
        expect_exactly(got, word, then=", the second")


@pytest.mark.exercise("2.2a")
def test_a_scalar_product_of_zero_is_a_right_angle(rng: Random) -> None:
    # Powers of 2: unit vectors of these are at right angles as well, to the last digit.
    x, y = rng.choice((1.0, 2.0, 4.0, 8.0)), rng.choice((1.0, 2.0, 4.0, 8.0))
    about.call = f"scalar_product_and_angle(Vector3({x}, {y}, 0), Vector3({-y}, {x}, 3))"
    about.cause = "a . b = 0, neither positive nor negative: cos t = 0 at a right angle"
    about.read = "book 2.1.7, Eq. 2.4"
    a, b = Vector3(x, y, 0.0), Vector3(-y, x, 3.0)
    product, got = exercises.scalar_product_and_angle(a, b)
    expect_close(product, 0.0, then=", the first")
    expect_exactly(got, "right", then=", the second")


@pytest.mark.exercise("2.2a")
@pytest.mark.robust
def test_a_product_that_is_nan_says_nothing_of_the_angle() -> None:
    about.call = "scalar_product_and_angle(Vector3(nan, 0, 0), Vector3(1, 2, 3))"
    about.cause = "NaN is neither positive nor negative nor zero: raise ValueError, do not say a "
    about.cause += "word"
    about.read = "the docstring of scalar_product_and_angle"
    good = Vector3(1.0, 2.0, 3.0)
    expect_error(
        lambda: exercises.scalar_product_and_angle(Vector3(math.nan, 0.0, 0.0), good),
        ValueError,
        allowed=lambda: exercises.scalar_product_and_angle(good, good),
    )


# 2.5 The angle between two vectors, in two ways


@pytest.mark.exercise("2.5")
def test_the_angles_of_the_book() -> None:
    a, b = Vector3(0.0, 1.0, 1.0), Vector3(0.0, -1.0, 0.0)
    about.call = "angle_by_scalar_product(Vector3(0, 1, 1), Vector3(0, -1, 0))"
    about.cause = "135 degrees, in radians: divide by both lengths, and keep the sign of the "
    about.cause += "product"
    about.read = "book 2.1.7, Eq. 2.4"
    got = exercises.angle_by_scalar_product(a, b)
    mistakes = [
        (135.0, "that is in degrees: radians are wanted, as math.acos gives them"),
        (math.pi, "a . b is not yet the cosine: divide it by both lengths"),
        (-math.sqrt(0.5), "that is the cosine: its angle is math.acos of it"),
        (0.25 * math.pi, "the sign of a . b is lost: below 0 the angle is more than a right one"),
        (-0.25 * math.pi, "that is math.asin of the cosine: take math.acos"),
    ]
    blame(got, mistakes)
    expect_close(got, 0.75 * math.pi)
    about.call = "angles_by_vector_product(Vector3(0, 1, 1), Vector3(0, -1, 0))"
    about.cause = "45 and 135 degrees have the same sine: a pair of both, in radians, the smaller "
    about.cause += "first"
    about.read = "book 2.1.8, Eq. 2.6, and errata.md"
    angles = exercises.angles_by_vector_product(a, b)
    wanted = (0.25 * math.pi, 0.75 * math.pi)
    mistakes = [
        (
            (0.0, math.pi),
            "0 and pi come of the book's root of 1 - (a . b)^2, which is the sine for unit vectors "
            "only (E-15): divide |a x b| by both lengths, or normalise a and b first",
        ),
        ((0.5 * math.pi, 0.5 * math.pi), "|a x b| is not yet the sine: divide by both lengths"),
        ((45.0, 135.0), "that is in degrees: radians are wanted, as math.asin gives them"),
        (wanted[::-1], "the smaller one comes first"),
        (wanted[0], "one angle only: pi minus that one has the same sine, and a pair is wanted"),
    ]
    blame(angles, mistakes)
    expect_close(angles, wanted)


@pytest.mark.exercise("2.5")
@pytest.mark.parametrize("kind", ["acute", "obtuse"])
def test_the_angle_by_the_scalar_product(rng: Random, kind: str) -> None:
    angle = rng.uniform(0.3, 1.4) if kind == "acute" else rng.uniform(1.7, 2.8)
    a, b = two_at_an_angle(rng, angle)
    v, w = Vector3(*a), Vector3(*b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; angle_by_scalar_product(v, w)"
    about.cause = "cos t is the product divided by both lengths; the angle is in radians"
    about.read = "book 2.1.7, Eq. 2.4"
    got = exercises.angle_by_scalar_product(v, w)
    other = "that is pi minus the angle: the sign of a . b is lost, or turned round"
    blame(got, [(math.pi - angle, other)])
    # Rounding is divided by sin t, 0.3 at the least, and drawing the vectors adds its own.
    expect_close(got, angle, tolerance=1e-12)
    expect_unchanged("v", xyz(v), a, cause=UNCHANGED)
    expect_unchanged("w", xyz(w), b, cause=UNCHANGED)


@pytest.mark.exercise("2.5")
@pytest.mark.parametrize("kind", ["acute", "obtuse"])
def test_the_angles_by_the_vector_product(rng: Random, kind: str) -> None:
    angle = rng.uniform(0.3, 1.4) if kind == "acute" else rng.uniform(1.7, 2.8)
    a, b = two_at_an_angle(rng, angle)
    v, w = Vector3(*a), Vector3(*b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; angles_by_vector_product(v, w)"
    about.cause = "sin t is |v x w| divided by both lengths, t and pi - t share it, and both are "
    about.cause += "wanted in radians; the root of 1 - (v . w)^2 is right for unit vectors only "
    about.cause += "(E-15)"
    about.read = "book 2.1.8, Eq. 2.6, and errata.md"
    got = exercises.angles_by_vector_product(v, w)
    wanted = (min(angle, math.pi - angle), max(angle, math.pi - angle))
    # Rounding is divided by |cos t|, 0.12 at the least, and drawing the vectors adds its own.
    expect_close(got, wanted, tolerance=1e-11)
    expect_unchanged("v", xyz(v), a, cause=UNCHANGED)
    expect_unchanged("w", xyz(w), b, cause=UNCHANGED)


@pytest.mark.exercise("2.5")
def test_parallel_and_perpendicular_vectors_have_angles_too(rng: Random) -> None:
    # 40 pairs: for many of them rounding leaves a cosine, or a sine, of just more than 1.
    about.cause = "rounding can leave a cosine or a sine just beyond 1, which math.acos and "
    about.cause += "math.asin refuse: take what is above 1 for 1, and what is below -1 for -1"
    about.read = "the hints of exercise 2.5"
    for _ in range(40):
        a, scale = components(rng), rng.uniform(0.1, 9.0)
        for size, angle in ((scale, 0.0), (-scale, math.pi)):
            b = (a[0] * size, a[1] * size, a[2] * size)
            about.call = f"angle_by_scalar_product(Vector3{a}, Vector3{b})"
            got = exercises.angle_by_scalar_product(Vector3(*a), Vector3(*b))
            # Near 0 and pi acos turns a rounding of 1e-16 into its root, 1e-8.
            expect_close(got, angle, tolerance=1e-7)
        c = (a[1], -a[0], 0.0)
        about.call = f"angles_by_vector_product(Vector3{a}, Vector3{c})"
        both = exercises.angles_by_vector_product(Vector3(*a), Vector3(*c))
        right = math.pi / 2.0
        expect_close(both, (right, right), tolerance=1e-7)


@pytest.mark.exercise("2.5")
@pytest.mark.robust
@pytest.mark.parametrize("name", ["angle_by_scalar_product", "angles_by_vector_product"])
def test_a_zero_vector_has_no_angle(rng: Random, name: str) -> None:
    a = components(rng)
    function = getattr(exercises, name)
    zero = Vector3(0.0, 0.0, 0.0)

    def right_angle() -> object:
        return function(Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0))

    about.cause = "a zero vector points nowhere: raise ValueError, do not return some angle"
    about.read = f"the docstring of {name}"
    for call, attempt in (
        (f"{name}(Vector3{a}, Vector3(0, 0, 0))", lambda: function(Vector3(*a), zero)),
        (f"{name}(Vector3(0, 0, 0), Vector3{a})", lambda: function(zero, Vector3(*a))),
    ):
        about.call = call
        expect_error(attempt, ValueError, allowed=right_angle)


@pytest.mark.exercise("2.5", weight=0.5)
@pytest.mark.robust
def test_nan_has_no_angle() -> None:
    lost, good = Vector3(math.nan, 0.0, 0.0), Vector3(1.0, 2.0, 3.0)
    about.call = "angle_by_scalar_product(Vector3(nan, 0, 0), Vector3(1, 2, 3))"
    about.cause = "min and max give their first argument where the other is NaN: clamp with NaN in "
    about.cause += "mind"
    about.read = "the docstring of angle_by_scalar_product"
    got = exercises.angle_by_scalar_product(lost, good)
    expect_nan(got)
    about.call = "angles_by_vector_product(Vector3(nan, 0, 0), Vector3(1, 2, 3))"
    about.read = "the docstring of angles_by_vector_product"
    angles = exercises.angles_by_vector_product(lost, good)
    expect_exactly(len(angles), 2, call=f"len({about.call})", cause="two angles, NaN both")
    for angle in angles:
        expect_nan(angle)
