"""The exercises on angles, 2.2a and 2.5."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors import exercises
from ch02_vectors.vector import Vector3
from draw import Triple, unit_vector, vector
from expect import (
    UNCHANGED,
    expect_close,
    expect_error,
    expect_exactly,
    expect_nan,
    expect_unchanged,
)

BOTH = "book 2.1.7, Eq. 2.4, and 2.1.8, Eq. 2.6"
DOC = "the docstring of the function"
DOT = "book 2.1.7, Eq. 2.4"
CROSS = "book 2.1.8, Eq. 2.6"
FIRST, SECOND = "; the first result, the scalar product", "; the second result, the kind of angle"
BY_COSINE = (
    "Divide the scalar product by both lengths to get the cosine of the angle. Return math.acos of "
    "this cosine, which is the angle in radians."
)


def two_at_an_angle(rng: Random, angle: float) -> tuple[Triple, Triple]:
    """Draw two vectors with this angle between them, in the plane of u and w."""
    u, v = unit_vector(rng), unit_vector(rng)
    rest = v - u * (u @ v)
    if abs(rest) < 0.1:  # nearly parallel, so rounding would change the angle
        return two_at_an_angle(rng, angle)
    w = rest / abs(rest)
    first, second = rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    return first * u, second * (math.cos(angle) * u + math.sin(angle) * w)


def angle_of(rng: Random, kind: str) -> float:
    """Draw an acute or an obtuse angle, away from 0, pi / 2 and pi."""
    return rng.uniform(0.3, 1.4) if kind == "acute" else rng.uniform(1.7, 2.8)


# 2.2a A scalar product and what its sign says


@pytest.mark.exercise("2.2a", asks="say whether the angle is acute, right or obtuse", read=DOT)
@pytest.mark.parametrize("word", ["acute", "obtuse"])
def test_the_sign_of_the_scalar_product_gives_the_kind_of_angle(rng: Random, word: str) -> None:
    low, high = (0.1, 1.5) if word == "acute" else (1.6, 3.0)
    long, b = two_at_an_angle(rng, rng.uniform(low, high))
    for a in (long, 0.01 * long):
        with calls("Return a pair: the scalar product a . b, and the kind of angle as a word."):
            product, got = exercises.scalar_product_and_angle(Vector3(*a), Vector3(*b))
        cause = "Compute the scalar product with a.dot(b), and return it as it is."
        if product in ("acute", "right", "obtuse"):
            cause = "You return the two results in the wrong order. Return the number first."
        slips = {
            "You return the cosine of the angle, because you divide by both lengths.":
                a @ b / (abs(a) * abs(b)),
            "You return |a x b|, the length of the vector product.": abs(a.cross(b)),
        }  # fmt: skip
        expect_close(product, a @ b, slips, tolerance=1e-12, then=FIRST, cause=cause)
        cause = "Return exactly one of the words acute, right and obtuse as the second result."
        if got == "right":
            cause = (
                "You return right, but the scalar product is not exactly 0. Test the sign of the "
                "product without rounding it first."
            )
        elif got in ("acute", "obtuse") and got != word:
            cause = (
                "You swap acute and obtuse. The angle is acute if the scalar product is positive, "
                "and obtuse if it is negative."
            )
            if exercises.scalar_product_and_angle(Vector3(*a), Vector3(*-b))[1] == got:
                cause = (
                    f"You return {got} for this angle, and also if b is reversed. Test the sign of "
                    "the scalar product. If you compare an angle instead, it is in radians, in "
                    "which 90 degrees are pi / 2."
                )
        expect_exactly(got, word, then=SECOND, cause=cause)


@pytest.mark.exercise("2.2a", asks="is only for exactly 0", read=DOT)
def test_a_scalar_product_of_zero_is_a_right_angle(rng: Random) -> None:
    # Powers of 2: unit vectors of these are at right angles as well, to the last digit.
    x, y = rng.choice((1.0, 2.0, 4.0, 8.0)), rng.choice((1.0, 2.0, 4.0, 8.0))
    right = (
        "The scalar product is exactly 0 here, so the angle is a right angle. Return the word "
        "right."
    )
    with calls(right):
        a, b = Vector3(x, y, 0.0), Vector3(-y, x, 3.0)
        product, got = exercises.scalar_product_and_angle(a, b)
    expect_close(product, 0.0, then=FIRST)
    if got in ("acute", "obtuse"):
        right = (
            f"You return {got} for a scalar product of exactly 0, which means a right angle. "
            "Compare the product with 0 by > and <, not by >= or <=."
        )
    expect_exactly(got, "right", then=SECOND, cause=right)


# 2.5 The angle between two vectors, in two ways


@pytest.mark.exercise("2.5", asks="Return both in radians, the smaller one first", read=BOTH)
def test_the_angles_of_the_book() -> None:
    with calls(BY_COSINE):
        a, b = Vector3(0.0, 1.0, 1.0), Vector3(0.0, -1.0, 0.0)
        got = exercises.angle_by_scalar_product(a, b)
    t, pi = 0.25 * math.pi, math.pi
    slips = {
        "Your angle is in degrees, but it must be in radians. The function math.acos already "
        "returns radians, so leave its result as it is.": 135.0,
        "You pass a.dot(b) itself to math.acos, but it is the cosine only if both vectors have "
        "length 1.": pi,
        "You return the cosine of the angle. Pass it to math.acos.": -math.sqrt(0.5),
        "You drop the minus sign of the scalar product, perhaps with abs. Keep it, because a "
        "negative product means that the angle is obtuse.": t,
        "You pass the cosine to math.asin, which needs a sine.": -t,
        "You pass the cosine to math.atan, which needs a tangent.": math.atan(-math.sqrt(0.5)),
    }
    expect_close(got, pi - t, slips)
    with calls(
        "Two angles between 0 and pi have the same sine, because sin t = sin(pi - t). Return both "
        "as a pair, the smaller one first."
    ):
        a, b = Vector3(0.0, 1.0, 1.0), Vector3(0.0, -1.0, 0.0)
        angles = exercises.angles_by_vector_product(a, b)
    slips = {
        "You use sqrt(1 - (a . b)^2) as the sine, which is right only if a and b are unit vectors. "
        "Normalize both first.": (0.0, pi),
        "You use |a x b| itself as the sine of the angle, but its value depends on the lengths of "
        "a and b. Divide it by both lengths first.": (0.5 * pi, 0.5 * pi),
        "Your angles are in degrees, but they must be in radians. The function math.asin already "
        "returns radians, so leave its result as it is.": (45.0, 135.0),
        "You return the two angles in the wrong order.": (pi - t, t),
        "You subtract the angle from 180, but it is in radians, in which half a turn is pi. Return "
        "pi - t as the second angle.": (t, 180.0 - t),
        "Your second angle is in degrees, but it must be in radians. Return pi - t.": (t, 135.0),
        "You subtract the angle from pi / 2.": (t, 0.5 * pi - t),
        "You subtract the angle from 2 pi.": (t, 2.0 * pi - t),
        "The sine of -t is not that of t.": (t, -t),
        "The sine of t + pi is not that of t.": (t, t + pi),
        "You return only one of the two possible angles.": t,
        "This is the sine. Pass it to math.asin.": math.sqrt(0.5),
    }
    expect_close(angles, (t, pi - t), slips)


@pytest.mark.exercise("2.5", asks="in radians between 0 and pi", read=DOT)
@pytest.mark.parametrize("kind", ["acute", "obtuse"])
def test_the_angle_by_the_scalar_product(rng: Random, kind: str) -> None:
    angle = angle_of(rng, kind)
    a, b = two_at_an_angle(rng, angle)
    with calls(BY_COSINE):
        v, w = Vector3(*a), Vector3(*b)
        got = exercises.angle_by_scalar_product(v, w)
    clamped = (
        "although v and w are not parallel. Probably your cosine is outside the range from -1 to "
        "1, and the clamp hides that. Divide v . w by both lengths, and put brackets around their "
        "product."
    )
    slips = {
        "You return pi minus the angle, because you lose or flip the sign of the scalar product. "
        "Check where your code changes the sign of v . w.": math.pi - angle,
        f"The angle is 0, {clamped}": 0.0,
        f"The angle is pi, {clamped}": math.pi,
    }
    for slip, cosine in {
        "You divide the scalar product only by |v|.": a @ b / abs(a),
        "You divide the scalar product only by |w|.": a @ b / abs(b),
        "Your formula lacks brackets, so you multiply by |w|. Divide by the product: a.dot(b) / "
        "(|v| * |w|).": a @ b / abs(a) * abs(b),
    }.items():
        if abs(cosine) < 1.0:  # otherwise, a clamp gives 0 or pi, whatever the mistake is
            slips[slip] = math.acos(cosine)
    # Rounding errors are divided by sin t, at least 0.3, and drawing the vectors adds its own.
    expect_close(got, angle, slips, tolerance=1e-12)
    expect_unchanged("v", v, a, cause=UNCHANGED)
    expect_unchanged("w", w, b, cause=UNCHANGED)


@pytest.mark.exercise("2.5", asks="have the same sine", read=CROSS)
@pytest.mark.parametrize("kind", ["acute", "obtuse"])
def test_the_angles_by_the_vector_product(rng: Random, kind: str) -> None:
    angle = angle_of(rng, kind)
    a, b = two_at_an_angle(rng, angle)
    with calls(
        "The sine of the angle is |v x w| divided by both lengths. Compute t = math.asin of this "
        "sine, and return t and pi - t in radians, the smaller one first."
    ):
        v, w = Vector3(*a), Vector3(*b)
        got = exercises.angles_by_vector_product(v, w)
    t = min(angle, math.pi - angle)
    slips = {"You pass the sine to math.acos.": (math.pi / 2.0 - t, math.pi / 2.0 + t)}
    # Rounding errors are divided by |cos t|, at least 0.12, and drawing the vectors adds its own.
    expect_close(got, (t, math.pi - t), slips, tolerance=1e-11)
    expect_unchanged("v", v, a, cause=UNCHANGED)
    expect_unchanged("w", w, b, cause=UNCHANGED)


@pytest.mark.exercise("2.5", asks="Limit both to the range", read="the hints of exercise 2.5")
def test_the_angles_of_parallel_and_perpendicular_vectors(rng: Random) -> None:
    # In many of the 40 pairs, rounding leaves a cosine or a sine slightly above 1.
    clamp = (
        "Rounding makes your {0} slightly {1} here, so {2} raises an error. Clamp the {0} to the "
        "range from -1 to 1 first."
    ).format
    parallel = (
        "These vectors are parallel, so the angle is 0, or pi if they point in opposite "
        "directions. Keep the sign of the scalar product."
    )
    perpendicular = "These vectors are perpendicular, so the sine is 1 and both angles are pi / 2."
    for _ in range(40):
        a, scale = vector(rng), rng.uniform(0.1, 9.0)
        for b, angle, beyond in (
            (a * scale, 0.0, "above 1"),
            (a * -scale, math.pi, "below -1"),
        ):
            with calls(clamp("cosine", beyond, "math.acos")):
                got = exercises.angle_by_scalar_product(Vector3(*a), Vector3(*b))
            # Near 0 and pi, acos turns a rounding error of 1e-16 into its square root, 1e-8.
            expect_close(got, angle, tolerance=1e-7, cause=parallel)
        b = Triple((a[1], -a[0], 0.0))
        with calls(clamp("sine", "above 1", "math.asin")):
            got = exercises.angles_by_vector_product(Vector3(*a), Vector3(*b))
        expect_close(got, [math.pi / 2.0] * 2, tolerance=1e-7, cause=perpendicular)


@pytest.mark.exercise("2.5", asks="A zero vector has no direction", read=DOC)
@pytest.mark.robust
@pytest.mark.parametrize("name", ["angle_by_scalar_product", "angles_by_vector_product"])
def test_the_angle_of_a_zero_vector_is_refused(rng: Random, name: str) -> None:
    a, zero, function = vector(rng), Triple((0.0, 0.0, 0.0)), getattr(exercises, name)
    for one, other in ((a, zero), (zero, a)):
        expect_error(
            lambda one=one, other=other: function(Vector3(*one), Vector3(*other)),
            ValueError,
            allowed=lambda: function(Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0)),
            call=f"{name}(Vector3{one}, Vector3{other})",
            cause="You don't check for a zero vector, which has no direction and so no angle to "
            "the other vector. Raise ValueError.",
        )


@pytest.mark.exercise("2.5", asks="The angles of NaN are NaN", weight=0.5, read=DOC)
@pytest.mark.robust
def test_the_angle_of_a_vector_with_nan_is_nan() -> None:
    clamp = (
        "Your clamp probably hides the NaN, because min(1.0, nan) is 1.0 but min(nan, 1.0) is nan. "
        "Pass the number that you clamp as the first argument of min and max."
    )
    with calls(clamp):
        a, b = Vector3(math.nan, 0.0, 0.0), Vector3(1.0, 2.0, 3.0)
        got = exercises.angle_by_scalar_product(a, b)
    expect_nan(got)
    with calls(clamp):
        a, b = Vector3(math.nan, 0.0, 0.0), Vector3(1.0, 2.0, 3.0)
        got = exercises.angles_by_vector_product(a, b)
    pair = "One component is NaN, so both angles are unknown. Return a pair of two NaNs."
    expect_exactly(len(got), 2, then="; the number of angles", cause=pair)
    for angle in got:
        expect_nan(angle, then="; one of the two angles")
