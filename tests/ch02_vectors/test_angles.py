"""The exercises on angles, 2.2a and 2.5."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors import exercises
from ch02_vectors.vector import Vector3
from draw import Components, components, direction, dot, rounded
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
    """Draw two vectors with this angle between them, in the plane of u and w."""
    u, v = direction(rng), direction(rng)
    along = dot(u, v)
    rest = [q - along * p for p, q in zip(u, v, strict=True)]
    length = math.hypot(*rest)
    if length < 0.1:  # nearly parallel, so rounding would change the angle
        return two_at_an_angle(rng, angle)
    w = [number / length for number in rest]
    first, second = rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    cosine, sine = second * math.cos(angle), second * math.sin(angle)
    a = (first * u[0], first * u[1], first * u[2])
    b = (cosine * u[0] + sine * w[0], cosine * u[1] + sine * w[1], cosine * u[2] + sine * w[2])
    return a, b


# 2.2a A scalar product and what its sign says


@pytest.mark.exercise("2.2a", asks="say whether the angle is acute, right or obtuse")
@pytest.mark.parametrize("word", ["acute", "obtuse"])
def test_the_sign_of_the_scalar_product_gives_the_kind_of_angle(rng: Random, word: str) -> None:
    low, high = (0.1, 1.5) if word == "acute" else (1.6, 3.0)
    long, b = two_at_an_angle(rng, rng.uniform(low, high))
    about.read = "book 2.1.7, Eq. 2.4"
    for a in (long, (0.01 * long[0], 0.01 * long[1], 0.01 * long[2])):
        about.call = f"scalar_product_and_angle(Vector3{rounded(a)}, Vector3{rounded(b)})"
        about.cause = (
            "Return a pair: the scalar product a . b, and one of the words acute, right and obtuse."
        )
        product, got = exercises.scalar_product_and_angle(Vector3(*a), Vector3(*b))
        if product in ("acute", "right", "obtuse"):
            about.cause = "You return the two results in the wrong order. Return the number first."
        name = f"{about.call}; the first result, the scalar product"
        cosine = dot(a, b) / math.sqrt(dot(a, a) * dot(b, b))
        divided = (
            "You return the cosine of the angle, because you divide by both lengths. Return the "
            "scalar product itself."
        )
        sine = math.sqrt(dot(a, a) * dot(b, b)) * math.sqrt(1.0 - cosine * cosine)
        crossed = "You return |a x b|, the length of the vector product. Use a.dot(b)."
        blame(product, [(cosine, divided), (sine, crossed)])
        expect_close(product, dot(a, b), call=name, tolerance=1e-12)
        about.cause = (
            "Return exactly one of the words acute, right and obtuse as the second result."
        )
        opposite = Vector3(-b[0], -b[1], -b[2])
        if (
            got in ("acute", "obtuse")
            and got != word
            and exercises.scalar_product_and_angle(Vector3(*a), opposite)[1] == got
        ):
            about.cause = (
                f"You return {got} for this angle, and also if b is reversed. Test the sign of the "
                "scalar product. If you compare an angle instead, it is in radians, in which 90 "
                "degrees are pi / 2."
            )
        elif got in ("acute", "obtuse"):
            about.cause = (
                "You swap acute and obtuse. The angle is acute if the scalar product is positive, "
                "and obtuse if it is negative."
            )
        if got == "right":
            about.cause = (
                "You return right, but the scalar product is not exactly 0. Test the sign of the "
                "product without rounding it first."
            )
        expect_exactly(got, word, then="; the second result, the kind of angle")


@pytest.mark.exercise("2.2a", asks="is only for exactly 0")
def test_a_scalar_product_of_zero_is_a_right_angle(rng: Random) -> None:
    # Powers of 2: unit vectors of these are at right angles as well, to the last digit.
    x, y = rng.choice((1.0, 2.0, 4.0, 8.0)), rng.choice((1.0, 2.0, 4.0, 8.0))
    about.call = f"scalar_product_and_angle(Vector3({x}, {y}, 0), Vector3({-y}, {x}, 3))"
    about.cause = (
        "The scalar product is exactly 0 here, so the angle is a right angle. Return the word "
        "right."
    )
    about.read = "book 2.1.7, Eq. 2.4"
    a, b = Vector3(x, y, 0.0), Vector3(-y, x, 3.0)
    product, got = exercises.scalar_product_and_angle(a, b)
    expect_close(product, 0.0, then="; the first result, the scalar product")
    if got in ("acute", "obtuse"):
        about.cause = (
            f"You return {got} for a scalar product of exactly 0, which means a right angle. "
            "Compare the product with 0 by > and <, not by >= or <=."
        )
    expect_exactly(got, "right", then="; the second result, the kind of angle")


# 2.5 The angle between two vectors, in two ways


@pytest.mark.exercise("2.5", asks="Return both in radians, the smaller one first")
def test_the_angles_of_the_book() -> None:
    a, b = Vector3(0.0, 1.0, 1.0), Vector3(0.0, -1.0, 0.0)
    about.call = "angle_by_scalar_product(Vector3(0, 1, 1), Vector3(0, -1, 0))"
    about.cause = (
        "Divide a . b by both lengths to get the cosine of the angle. Return math.acos of this "
        "cosine, which is the angle in radians."
    )
    about.read = "book 2.1.7, Eq. 2.4"
    got = exercises.angle_by_scalar_product(a, b)
    mistakes = [
        (
            135.0,
            "Your angle is in degrees, but it must be in radians. The function math.acos already "
            "returns radians, so leave its result as it is.",
        ),
        (
            math.pi,
            "You pass a . b itself to math.acos, but it is the cosine only if both vectors have "
            "length 1. Divide it by both lengths first.",
        ),
        (
            -math.sqrt(0.5),
            "You return the cosine of the angle. Pass it to math.acos to get the angle itself.",
        ),
        (
            0.25 * math.pi,
            "You drop the minus sign of the scalar product, perhaps with abs. Keep it, because a "
            "negative product means that the angle is obtuse.",
        ),
        (
            -0.25 * math.pi,
            "You pass the cosine to math.asin, which needs a sine. Pass it to math.acos instead.",
        ),
        (
            math.atan(-math.sqrt(0.5)),
            "You pass the cosine to math.atan, which needs a tangent. Pass it to math.acos.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, 0.75 * math.pi)
    about.call = "angles_by_vector_product(Vector3(0, 1, 1), Vector3(0, -1, 0))"
    about.cause = (
        "Two angles between 0 and pi have the same sine, because sin t = sin(pi - t). Return both "
        "as a pair, the smaller one first."
    )
    about.read = "book 2.1.8, Eq. 2.6"
    angles = exercises.angles_by_vector_product(a, b)
    wanted = (0.25 * math.pi, 0.75 * math.pi)
    mistakes = [
        (
            (0.0, math.pi),
            "You use sqrt(1 - (a . b)^2) as the sine, which is right only if a and b are unit "
            "vectors. Normalize both first.",
        ),
        (
            (0.5 * math.pi, 0.5 * math.pi),
            "You use |a x b| itself as the sine of the angle, but its value depends on the lengths "
            "of a and b. Divide it by both lengths first.",
        ),
        (
            (45.0, 135.0),
            "Your angles are in degrees, but they must be in radians. The function math.asin "
            "already returns radians, so leave its result as it is.",
        ),
        (
            wanted[::-1],
            "You return the two angles in the wrong order. Return the smaller one first.",
        ),
        (
            (wanted[0], 180.0 - wanted[0]),
            "You subtract the angle from 180, but it is in radians, in which half a turn is pi. "
            "Return pi - t as the second angle.",
        ),
        (
            (wanted[0], 135.0),
            "Your second angle is in degrees, but it must be in radians. Return pi - t.",
        ),
        (
            (wanted[0], 0.5 * math.pi - wanted[0]),
            "You subtract the angle from pi / 2. Angles with the same sine add up to pi, so return "
            "pi - t as the second one.",
        ),
        (
            (wanted[0], 2.0 * math.pi - wanted[0]),
            "You subtract the angle from 2 pi. Angles with the same sine add up to pi, so return "
            "pi - t as the second one.",
        ),
        (
            (wanted[0], -wanted[0]),
            "The sine of -t is not that of t. Return pi - t as the second angle.",
        ),
        (
            (wanted[0], wanted[0] + math.pi),
            "The sine of t + pi is not that of t. Return pi - t as the second angle.",
        ),
        (
            wanted[0],
            "You return only one of the two possible angles. Return t and pi - t as a pair, "
            "because both have the same sine.",
        ),
    ]
    blame(angles, [*mistakes, (math.sqrt(0.5), "This is the sine. Pass it to math.asin.")])
    expect_close(angles, wanted)


@pytest.mark.exercise("2.5", asks="in radians between 0 and pi")
@pytest.mark.parametrize("kind", ["acute", "obtuse"])
def test_the_angle_by_the_scalar_product(rng: Random, kind: str) -> None:
    angle = rng.uniform(0.3, 1.4) if kind == "acute" else rng.uniform(1.7, 2.8)
    a, b = two_at_an_angle(rng, angle)
    v, w = Vector3(*a), Vector3(*b)
    about.call = f"v, w = Vector3{rounded(a)}, Vector3{rounded(b)}; angle_by_scalar_product(v, w)"
    about.cause = (
        "Divide v . w by both lengths to get the cosine of the angle. Return math.acos of this "
        "cosine, which is the angle in radians."
    )
    about.read = "book 2.1.7, Eq. 2.4"
    got = exercises.angle_by_scalar_product(v, w)
    other = (
        "You return pi minus the angle, because you lose or flip the sign of the scalar product. "
        "Check where your code changes the sign of v . w."
    )
    mistakes = [(math.pi - angle, other)]
    long, short = math.hypot(*a), math.hypot(*b)
    for cosine, cause in (
        (dot(a, b) / long, "You divide the scalar product only by |v|. Divide it by |w|, too."),
        (dot(a, b) / short, "You divide the scalar product only by |w|. Divide it by |v|, too."),
        (
            dot(a, b) / long * short,
            "Your formula lacks brackets, so you multiply by |w|. Divide by the product: "
            "a.dot(b) / (|v| * |w|).",
        ),
    ):
        if abs(cosine) < 1.0:  # otherwise, a clamp gives 0 or pi, whatever the mistake is
            mistakes.append((math.acos(cosine), cause))
    clamped = (
        "The angle is 0 or pi, although v and w are not parallel. Probably your cosine is outside "
        "the range from -1 to 1, and the clamp hides that. Divide v . w by both lengths, and put "
        "brackets around their product."
    )
    blame(got, [*mistakes, (0.0, clamped), (math.pi, clamped)])
    # Rounding errors are divided by sin t, at least 0.3, and drawing the vectors adds its own.
    expect_close(got, angle, tolerance=1e-12)
    expect_unchanged("v", xyz(v), a, cause=UNCHANGED)
    expect_unchanged("w", xyz(w), b, cause=UNCHANGED)


@pytest.mark.exercise("2.5", asks="have the same sine")
@pytest.mark.parametrize("kind", ["acute", "obtuse"])
def test_the_angles_by_the_vector_product(rng: Random, kind: str) -> None:
    angle = rng.uniform(0.3, 1.4) if kind == "acute" else rng.uniform(1.7, 2.8)
    a, b = two_at_an_angle(rng, angle)
    v, w = Vector3(*a), Vector3(*b)
    about.call = f"v, w = Vector3{rounded(a)}, Vector3{rounded(b)}; angles_by_vector_product(v, w)"
    about.cause = (
        "The sine of the angle is |v x w| divided by both lengths. Compute t = math.asin of this "
        "sine, and return t and pi - t in radians, the smaller one first."
    )
    about.read = "book 2.1.8, Eq. 2.6"
    got = exercises.angles_by_vector_product(v, w)
    wanted = (min(angle, math.pi - angle), max(angle, math.pi - angle))
    half, inverse = math.pi / 2.0, "You pass the sine to math.acos. Pass it to math.asin."
    blame(got, [((half - wanted[0], half + wanted[0]), inverse)])
    # Rounding errors are divided by |cos t|, at least 0.12, and drawing the vectors adds its own.
    expect_close(got, wanted, tolerance=1e-11)
    expect_unchanged("v", xyz(v), a, cause=UNCHANGED)
    expect_unchanged("w", xyz(w), b, cause=UNCHANGED)


@pytest.mark.exercise("2.5", asks="Limit both to the range")
def test_the_angles_of_parallel_and_perpendicular_vectors(rng: Random) -> None:
    # In many of the 40 pairs, rounding leaves a cosine or a sine slightly above 1.
    clamp = (
        "Rounding makes your {0} slightly {1} here, so {2} raises an error. Clamp the {0} to the "
        "range from -1 to 1 first."
    ).format
    parallel = "These vectors are parallel, so the angle is 0, or pi if they point in opposite "
    parallel += "directions. Keep the sign of the scalar product."
    perpendicular = "These vectors are perpendicular, so the sine is 1 and both angles are pi / 2."
    about.read = "the hints of exercise 2.5"
    for _ in range(40):
        a, scale = components(rng), rng.uniform(0.1, 9.0)
        for size, angle in ((scale, 0.0), (-scale, math.pi)):
            b = (a[0] * size, a[1] * size, a[2] * size)
            about(
                f"angle_by_scalar_product(Vector3{a}, Vector3{b})",
                cause=clamp("cosine", "above 1" if size > 0.0 else "below -1", "math.acos"),
            )
            got = exercises.angle_by_scalar_product(Vector3(*a), Vector3(*b))
            # Near 0 and pi, acos turns a rounding error of 1e-16 into its square root, 1e-8.
            expect_close(got, angle, tolerance=1e-7, cause=parallel)
        c = (a[1], -a[0], 0.0)
        about(
            f"angles_by_vector_product(Vector3{a}, Vector3{c})",
            cause=clamp("sine", "above 1", "math.asin"),
        )
        both = exercises.angles_by_vector_product(Vector3(*a), Vector3(*c))
        right = math.pi / 2.0
        expect_close(both, (right, right), tolerance=1e-7, cause=perpendicular)


@pytest.mark.exercise("2.5", asks="A zero vector has no direction")
@pytest.mark.robust
@pytest.mark.parametrize("name", ["angle_by_scalar_product", "angles_by_vector_product"])
def test_the_angle_of_a_zero_vector_is_refused(rng: Random, name: str) -> None:
    a = components(rng)
    function = getattr(exercises, name)
    zero = Vector3(0.0, 0.0, 0.0)

    def right_angle() -> object:
        return function(Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0))

    about.cause = (
        "You don't check for a zero vector, which has no direction and so no angle to the other "
        "vector. Raise ValueError."
    )
    about.read = f"the docstring of {name}"
    for call, attempt in (
        (f"{name}(Vector3{a}, Vector3(0, 0, 0))", lambda: function(Vector3(*a), zero)),
        (f"{name}(Vector3(0, 0, 0), Vector3{a})", lambda: function(zero, Vector3(*a))),
    ):
        about.call = call
        expect_error(attempt, ValueError, allowed=right_angle)


@pytest.mark.exercise("2.5", asks="The angles of NaN are NaN", weight=0.5)
@pytest.mark.robust
def test_the_angle_of_a_vector_with_nan_is_nan() -> None:
    lost, good = Vector3(math.nan, 0.0, 0.0), Vector3(1.0, 2.0, 3.0)
    about.call = "angle_by_scalar_product(Vector3(nan, 0, 0), Vector3(1, 2, 3))"
    about.cause = (
        "Your clamp probably hides the NaN, because min(1.0, nan) is 1.0 but min(nan, 1.0) is nan. "
        "Pass the number that you clamp as the first argument of min and max."
    )
    about.read = "the docstring of angle_by_scalar_product"
    got = exercises.angle_by_scalar_product(lost, good)
    expect_nan(got)
    about.call = "angles_by_vector_product(Vector3(nan, 0, 0), Vector3(1, 2, 3))"
    about.read = "the docstring of angles_by_vector_product"
    angles = exercises.angles_by_vector_product(lost, good)
    expect_exactly(
        len(angles),
        2,
        call=f"len({about.call})",
        cause="One component is NaN, so both angles are unknown. Return a pair of two NaNs.",
    )
    for angle in angles:
        expect_nan(angle, then="; one of the two angles")
