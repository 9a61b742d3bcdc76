"""Vector3: copies, length and unit vectors, build tasks B2.1, B2.2 and B2.4."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from draw import Triple, rounded, vector
from expect import LOST, expect_close, expect_nan, expect_that, expect_unchanged, xyz

DOC = "the docstrings of Vector3 and of the method"
NEGATE = "the docstring of Vector3.__neg__"
HUGE, TINY = 1e200, 1e-200  # their squares are infinity and zero in a float
ZERO = (0.0, 0.0, 0.0)
CHANGES = "Your {} changes v, but only {} may do that. Return a new vector and leave v unchanged."
BY_SQUARE = (
    "You divide the vector by its squared length. Divide it by its length, which magnitude() "
    "returns."
)


def whole_length(rng: Random) -> tuple[Triple, float]:
    """Draw whole components, none of them 0, with a whole length by Lebesgue's formula."""
    x = z = 0
    while not x or not z:
        m, n, p, q = (rng.randint(1, 6) for _ in range(4))
        x, y, z = m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p)
    return Triple(map(float, (x, y, z))), float(m * m + n * n + p * p + q * q)


# B2.1 Copy, clear and invert


@pytest.mark.exercise("B2.1", asks="Return a new vector with the same components", read=DOC)
def test_a_copy_is_a_new_vector_with_the_same_components(rng: Random) -> None:
    a = vector(rng)
    with calls("Return a new Vector3 with the same x, y and z as the original."):
        v = Vector3(*a)
        got = v.copy()
    expect_close(xyz(got), a)
    with calls(
        "copy() returned the vector itself, so any change to the copy also changes v. Return a new "
        "Vector3 with the same components."
    ):
        v = Vector3(*a)
        w = v.copy()
        w.x = 99.0
    expect_unchanged("v", v, a)


@pytest.mark.exercise("B2.1", asks="Set all three components of the vector to zero", read=DOC)
def test_clear_leaves_zero(rng: Random) -> None:
    a = vector(rng)
    with calls("Set all three components of self, x, y and z, to zero."):
        v = Vector3(*a)
        v.clear()
    slips = {
        "Your clear leaves v unchanged, perhaps because it assigns a new vector to the name self.":
            a,
        "Your clear leaves x unchanged.": (a[0], 0.0, 0.0),
        "Your clear leaves y unchanged.": (0.0, a[1], 0.0),
        "Your clear leaves z unchanged.": (0.0, 0.0, a[2]),
    }  # fmt: skip
    expect_close(v, ZERO, slips, then="; v")


@pytest.mark.exercise(
    "B2.1", asks="Reverse the direction, in place", read="book 2.1; docs/errata.md"
)
def test_invert_changes_the_sign_of_every_component(rng: Random) -> None:
    a = vector(rng)
    with calls(
        "Your invert must reverse the direction of the vector itself. Flip the sign of every "
        "component of self, for example with self.x = -self.x."
    ):
        v = Vector3(*a)
        v.invert()
    printed = (
        "You follow the book's listing, which sets x from z by mistake and never changes z (E-14). "
        "Flip the sign of each component instead."
    )
    expect_close(v, -a, {LOST: a, printed: (-a[2], -a[1], a[2])}, then="; v")


@pytest.mark.exercise(
    "B2.1", asks="is a new vector that points in the opposite direction", read=NEGATE
)
def test_minus_v_is_a_new_vector_in_the_opposite_direction(rng: Random) -> None:
    a = vector(rng)
    with calls("Return a new vector with the signs of all three components flipped."):
        v = Vector3(*a)
        got = -v
    expect_close(xyz(got), -a)
    expect_unchanged("v", v, a, cause=CHANGES.format("__neg__", "invert"))


# B2.2 Length


@pytest.mark.exercise("B2.2", asks="Return the length of the vector, |v|", read="book 2.1.2")
def test_magnitude_is_the_length(rng: Random) -> None:
    a, length = whole_length(rng)
    with calls("The magnitude of a vector is its length, sqrt(x^2 + y^2 + z^2)."):
        got = Vector3(*a).magnitude()
    slips = {
        "You return the squared length. Take its square root.": length**2,
        "You leave out z.": math.hypot(a[0], a[1]),
        "You add up the components without their signs.": math.fsum(map(abs, a)),
        "Your exponent is 1 // 2, which is 0. The square root is the power 0.5.": 1.0,
        "You halve the sum. The square root is the power 0.5, as in x**0.5.": length**2 / 2.0,
        "You return the sum of the components, without squaring them.": sum(a),
    }
    for axis, n in zip("xyz", a, strict=True):
        doubled = f"You double the {axis} component instead of squaring it. Write {axis}**2."
        slips[doubled] = math.sqrt(abs(length**2 - n * n + 2.0 * n))
    expect_close(got, length, slips)


@pytest.mark.exercise("B2.2", asks="Return the squared length of the vector", read="book 2.1.2")
def test_squared_magnitude_is_the_length_squared(rng: Random) -> None:
    a, length = whole_length(rng)
    with calls("The squared magnitude is x^2 + y^2 + z^2, without a square root."):
        got = Vector3(*a).squared_magnitude()
    slips = {
        "You return the length itself.": length,
        "You return x^2 + y^2.": a[0] ** 2 + a[1] ** 2,
        "You square the sum of the components.": sum(a) ** 2,
    }
    expect_close(got, length**2, slips)


@pytest.mark.exercise("B2.2", asks="as large as 1e200 or as small as 1e-200", read=DOC)
@pytest.mark.robust
def test_magnitude_of_huge_and_tiny_components(rng: Random) -> None:
    a, length = whole_length(rng)
    for scale, size in ((HUGE, "large"), (TINY, "small")):
        with calls(
            f"The squares of these components are too {size} for a float. Use math.hypot, which "
            "does not need the squares to fit.",
            f"Vector3{rounded(a * scale)}.magnitude()",
        ):
            got = Vector3(*a * scale).magnitude()
        expect_close(got, length * scale)


@pytest.mark.exercise("B2.2", asks="without a direction. Its magnitude is 0", read="book 2.1.2")
def test_the_zero_vector_has_the_length_zero() -> None:
    with calls("The length of a zero vector is zero. Return 0.0 without an error."):
        got = Vector3(0.0, 0.0, 0.0).magnitude()
    expect_close(got, 0.0)


@pytest.mark.exercise("B2.2", asks="which is NaN if a component is", read=DOC)
@pytest.mark.robust
def test_the_length_of_a_vector_with_nan_is_nan() -> None:
    for name in ("magnitude", "squared_magnitude"):
        with calls(
            "Your code loses the NaN, perhaps by calling max or min. Return the result of the "
            "formula without comparing it with another number.",
            f"Vector3(1, math.nan, 2).{name}()",
        ):
            got = getattr(Vector3(1.0, math.nan, 2.0), name)()
        expect_nan(got)


# B2.4 Normalize


@pytest.mark.exercise("B2.4", asks="Scale the vector to length 1 in place", read="book 2.1.2")
def test_normalize_keeps_the_direction_and_makes_the_length_one(rng: Random) -> None:
    a, length = whole_length(rng)
    with calls("Divide each of the three components of v by the length, so that v has length 1."):
        v = Vector3(*a)
        v.normalize()
    x = a[0] / length
    y = a[1] / math.hypot(x, a[1], a[2])
    slips = {
        LOST: a,
        BY_SQUARE: a / length**2,
        "You multiply the vector by its length. Divide it by its length.": a * length,
        "You divide with //, which rounds down to a whole number. Use / instead.":
            [n // length for n in a],
        "You compute the length again after you have changed x, so you divide y and z by a "
        "different number. Compute the length once, and keep it in a variable.":
            (x, y, a[2] / math.hypot(x, y, a[2])),
    }  # fmt: skip
    expect_close(v, a / length, slips, then="; v")


@pytest.mark.exercise("B2.4", asks="Return a new vector of length 1", read=DOC)
def test_normalized_is_a_new_unit_vector(rng: Random) -> None:
    a, length = whole_length(rng)
    with calls("Divide each component by the length, and return the quotients as a new vector."):
        v = Vector3(*a)
        got = v.normalized()
    in_place = (
        "Your normalized returns None, perhaps because you return the result of normalize. "
        "Normalize a copy of v first, and then return the copy."
    )
    expect_that(got is not None, "nothing (None)", "a new unit vector", cause=in_place)
    expect_close(xyz(got), a / length, {BY_SQUARE: a / length**2})
    expect_unchanged("v", v, a, cause=CHANGES.format("normalized", "normalize"))
    with calls(
        "The second call of normalized changes u, the result of the first call, so both calls "
        "return the same object. Create a new vector in every call."
    ):
        u = Vector3(*a).normalized()
        Vector3(0.0, -1.0, 0.0).normalized()
    expect_close(u, a / length, then="; u")


@pytest.mark.exercise("B2.4", asks="The zero vector stays zero", read="book 2.1.2")
def test_the_zero_vector_stays_zero() -> None:
    divides = (
        "You divide by the length, which is 0 here. Test for a length of 0.0 before you divide, so "
        "that the result is the zero vector."
    )
    with calls(divides):
        v = Vector3(0.0, 0.0, 0.0)
        u = v.normalized()
    expect_close(xyz(u), ZERO)
    with calls(
        "You return the zero vector itself, so a change of the result also changes v. Return a new "
        "zero vector, Vector3()."
    ):
        v = Vector3(0.0, 0.0, 0.0)
        u = v.normalized()
        u.x = 9.0
    expect_close(v, ZERO, then="; v")
    with calls(divides):
        v = Vector3(0.0, 0.0, 0.0)
        v.normalize()
    expect_close(v, ZERO, then="; v")


@pytest.mark.exercise("B2.4", asks="must work for components as large as 1e200", read=DOC)
@pytest.mark.robust
def test_normalize_huge_and_tiny_vectors(rng: Random) -> None:
    a, length = whole_length(rng)
    short = (
        "v did not change, because you treat a very short vector as zero. Return early only if "
        "magnitude() is exactly 0.0."
    )
    for scale, unchanged in ((HUGE, LOST), (TINY, short)):
        with calls(
            "You square components whose squares are too large or too small for a float. Compute "
            "the length with magnitude(), which avoids this.",
            f"v = Vector3{rounded(a * scale)}; v.normalize()",
        ):
            v = Vector3(*a * scale)
            v.normalize()
        zero = "The result is zero, because your squared length overflows to infinity."
        expect_close(v, a / length, {unchanged: a * scale, zero: ZERO}, then="; v")
