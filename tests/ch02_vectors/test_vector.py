"""Vector3: copies, length and unit vectors, build tasks B2.1, B2.2 and B2.4."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from draw import Components, components, rounded
from expect import (
    LOST,
    about,
    blame,
    expect_close,
    expect_nan,
    expect_that,
    expect_unchanged,
    xyz,
)

HUGE, TINY = 1e200, 1e-200  # their squares are infinity and zero in a float
ZERO = (0.0, 0.0, 0.0)


def whole_length(rng: Random) -> tuple[Components, float]:
    """Draw whole components, none of them 0, with a whole length by Lebesgue's formula."""
    x = z = 0
    while not x or not z:
        m, n, p, q = (rng.randint(1, 6) for _ in range(4))
        x, y, z = m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p)
    return (float(x), float(y), float(z)), float(m * m + n * n + p * p + q * q)


def scaled(a: Components, scale: float) -> Components:
    return a[0] * scale, a[1] * scale, a[2] * scale


# B2.1 Copy, clear and invert


@pytest.mark.exercise("B2.1", asks="Return a new vector with the same components")
def test_a_copy_is_a_new_vector_with_the_same_components(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; v.copy()"
    about.cause = "Return a new Vector3 with the same x, y and z as the original."
    about.read = "the docstring of Vector3.copy"
    copied = v.copy()
    expect_close(xyz(copied), a)
    copied.x = 99.0
    about.call = f"v = Vector3{a}; w = v.copy(); w.x = 99"
    about.cause = (
        "copy() returned the vector itself, so any change to the copy also changes v. Return a new "
        "Vector3 with the same components."
    )
    expect_unchanged("v", xyz(v), a)


@pytest.mark.exercise("B2.1", asks="Set all three components of the vector to zero")
def test_clear_leaves_zero(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about(
        f"v = Vector3{a}; v.clear()",
        cause="Your clear must set all three components of self, x, y and z, to zero.",
    )
    about.read = "the docstring of Vector3.clear"
    v.clear()
    same = (
        "Your clear leaves v unchanged, perhaps because it assigns a new vector to the name self. "
        "Assign 0 to self.x, self.y and self.z instead."
    )
    mistakes = [(a, same)]
    for i, name in enumerate("xyz"):
        left = tuple(n if i == j else 0.0 for j, n in enumerate(a))
        mistakes.append((left, f"Your clear leaves {name} unchanged. Set self.{name} to 0 too."))
    blame(xyz(v), mistakes)
    expect_close(xyz(v), ZERO, then="; v")


@pytest.mark.exercise("B2.1", asks="Reverse the direction, in place")
def test_invert_changes_the_sign_of_every_component(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; v.invert()"
    about.cause = (
        "Your invert must reverse the direction of the vector itself. Flip the sign of every "
        "component of self, for example with self.x = -self.x."
    )
    about.read = "book 2.1, and errata.md"
    v.invert()
    printed = (
        "You follow the book's listing, which sets x from z by mistake and never changes z (E-14). "
        "Flip the sign of each component instead."
    )
    blame(xyz(v), [(a, LOST), ((-a[2], -a[1], a[2]), printed)])
    expect_close(xyz(v), scaled(a, -1.0), then="; v")


@pytest.mark.exercise("B2.1", asks="is a new vector that points in the opposite direction")
def test_minus_v_is_a_new_vector_in_the_opposite_direction(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about(
        f"v = Vector3{a}; -v",
        cause="-v must point in the opposite direction. Return a new vector with the signs of all "
        "three components flipped.",
    )
    about.read = "the docstring of Vector3.__neg__"
    expect_close(xyz(-v), scaled(a, -1.0))
    about.cause = (
        "Your __neg__ changes v, but only invert may do that. Return a new vector and leave v "
        "unchanged."
    )
    expect_unchanged("v", xyz(v), a)


# B2.2 Length


@pytest.mark.exercise("B2.2", asks="Return the length of the vector, |v|")
def test_magnitude_is_the_length(rng: Random) -> None:
    a, length = whole_length(rng)
    about(
        f"Vector3{a}.magnitude()",
        cause="The magnitude of a vector is its length, sqrt(x^2 + y^2 + z^2). Check your formula "
        "against it.",
    )
    about.read = "book 2.1.2"
    got = Vector3(*a).magnitude()
    mistakes = [
        (length**2, "You return the squared length. Take its square root."),
        (
            math.hypot(a[0], a[1]),
            "You leave out z. Add its square to the sum before you take the square root.",
        ),
        (
            math.fsum(map(abs, a)),
            "You add up the components without their signs. Add up their squares, and take the "
            "square root of the sum.",
        ),
        *(
            (
                math.sqrt(abs(length**2 - n * n + 2.0 * n)),
                f"You double the {axis} component instead of squaring it. Write {axis}**2.",
            )
            for axis, n in zip("xyz", a, strict=True)
        ),
        (1.0, "Your exponent is 1 // 2, which is 0. The square root is the power 0.5."),
        (length**2 / 2.0, "You halve the sum. The square root is the power 0.5, as in x**0.5."),
        (
            sum(a),
            "You return the sum of the components. Square each of them first, and then take the "
            "square root of the sum.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, length)


@pytest.mark.exercise("B2.2", asks="Return the squared length of the vector")
def test_squared_magnitude_is_the_length_squared(rng: Random) -> None:
    a, length = whole_length(rng)
    about(
        f"Vector3{a}.squared_magnitude()",
        cause="The squared magnitude is x^2 + y^2 + z^2, without a square root. Check your formula "
        "against it.",
    )
    about.read = "book 2.1.2"
    got = Vector3(*a).squared_magnitude()
    mistakes = [
        (
            length,
            "You return the length itself. This method must return the squared length, so leave "
            "out the square root.",
        ),
        (
            a[0] ** 2 + a[1] ** 2,
            "You return x^2 + y^2. Add the square of z.",
        ),
        (
            sum(a) ** 2,
            "You square the sum of the components. Square each of them, and then add the squares.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, length**2)


@pytest.mark.exercise("B2.2", asks="as large as 1e200 or as small as 1e-200")
@pytest.mark.robust
def test_magnitude_of_huge_and_tiny_components(rng: Random) -> None:
    a, length = whole_length(rng)
    about.read = "the docstring of Vector3.magnitude"
    for scale, size in ((HUGE, "large"), (TINY, "small")):
        about.cause = (
            f"The squares of these components are too {size} for a float. Use math.hypot, which "
            "does not need the squares to fit."
        )
        b = scaled(a, scale)
        about.call = f"Vector3{rounded(b)}.magnitude()"
        expect_close(Vector3(*b).magnitude(), length * scale)


@pytest.mark.exercise("B2.2", asks="without a direction. Its magnitude is 0")
def test_the_zero_vector_has_the_length_zero() -> None:
    about(
        "Vector3(0, 0, 0).magnitude()",
        cause="All three components are zero, so the length must be zero too. Return 0.0 without "
        "an error.",
    )
    about.read = "book 2.1.2"
    expect_close(Vector3(0.0, 0.0, 0.0).magnitude(), 0.0)


@pytest.mark.exercise("B2.2", asks="which is NaN if a component is")
@pytest.mark.robust
def test_the_length_of_a_vector_with_nan_is_nan() -> None:
    about.read = "the docstrings of Vector3 and Vector3.magnitude"
    lost = Vector3(1.0, math.nan, 2.0)
    about.call = "Vector3(1, nan, 2).magnitude()"
    about.cause = (
        "Your code loses the NaN, perhaps by calling max or min. Return the result of the formula "
        "without comparing it with another number."
    )
    expect_nan(lost.magnitude())
    about.call = "Vector3(1, nan, 2).squared_magnitude()"
    expect_nan(lost.squared_magnitude())


# B2.4 Normalize


@pytest.mark.exercise("B2.4", asks="Scale the vector to length 1 in place")
def test_normalize_keeps_the_direction_and_makes_the_length_one(rng: Random) -> None:
    a, length = whole_length(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; v.normalize()"
    about.cause = (
        "After this call, v must have length 1 and its old direction. Divide each of its three "
        "components by its length."
    )
    about.read = "book 2.1.2"
    v.normalize()
    x = a[0] / length
    y = a[1] / math.hypot(x, a[1], a[2])
    mistakes = [
        (a, LOST),
        (
            scaled(a, length**-2),
            "You divide the vector by its squared length. Divide it by its length, which "
            "magnitude() returns.",
        ),
        (scaled(a, length), "You multiply the vector by its length. Divide it by its length."),
        (
            tuple(n // length for n in a),
            "You divide with //, which rounds down to a whole number. Use / instead.",
        ),
        (
            (x, y, a[2] / math.hypot(x, y, a[2])),
            "You compute the length again after you have changed x, so you divide y and z by a "
            "different number. Compute the length once, and keep it in a variable.",
        ),
    ]
    blame(xyz(v), mistakes)
    expect_close(xyz(v), scaled(a, 1.0 / length), then="; v")


@pytest.mark.exercise("B2.4", asks="Return a new vector of length 1")
def test_normalized_is_a_new_unit_vector(rng: Random) -> None:
    a, length = whole_length(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; v.normalized()"
    about.cause = (
        "The result must be a new vector of length 1. Divide each component by the length, and "
        "return the quotients as a new vector."
    )
    about.read = "the docstring of Vector3.normalized"
    result = v.normalized()
    in_place = (
        "Your normalized returns None, perhaps because you return the result of normalize. "
        "Normalize a copy of v first, and then return the copy."
    )
    expect_that(result is not None, "nothing (None)", "a new unit vector", cause=in_place)
    got = xyz(result)
    mistakes = [
        (
            scaled(a, length**-2),
            "You divide the vector by its squared length. Divide it by its length, which "
            "magnitude() returns.",
        )
    ]
    blame(got, mistakes)
    expect_close(got, scaled(a, 1.0 / length))
    about.cause = (
        "Your normalized changes v, but only normalize may do that. Return a new vector and leave "
        "v unchanged."
    )
    expect_unchanged("v", xyz(v), a)
    first = v.normalized()
    Vector3(0.0, -1.0, 0.0).normalized()
    about.call = f"u = Vector3{a}.normalized(); Vector3(0, -1, 0).normalized(); u"
    about.cause = (
        "The second call of normalized changes u, the result of the first call, so both calls "
        "return the same object. Create a new vector in every call."
    )
    expect_close(xyz(first), scaled(a, 1.0 / length))


@pytest.mark.exercise("B2.4", asks="The zero vector stays zero")
def test_the_zero_vector_stays_zero() -> None:
    v = Vector3(0.0, 0.0, 0.0)
    about.call = "v = Vector3(0, 0, 0); v.normalized()"
    about.cause = (
        "You divide by the length, which is 0 here. Test for a length of 0.0 before you divide, so "
        "that the result is the zero vector."
    )
    about.read = "book 2.1.2"
    u = v.normalized()
    expect_close(xyz(u), ZERO)
    u.x = 9.0
    about.call = "v = Vector3(0, 0, 0); u = v.normalized(); u.x = 9; v"
    itself = (
        "You return the zero vector itself, so a change of the result also changes v. Return a new "
        "zero vector, Vector3()."
    )
    expect_close(xyz(v), ZERO, cause=itself)
    about.call = "v = Vector3(0, 0, 0); v.normalize()"
    v = Vector3(0.0, 0.0, 0.0)
    v.normalize()
    expect_close(xyz(v), ZERO, then="; v")


@pytest.mark.exercise("B2.4", asks="must work for components as large as 1e200")
@pytest.mark.robust
def test_normalize_huge_and_tiny_vectors(rng: Random) -> None:
    a, length = whole_length(rng)
    about.read = "the docstring of Vector3.normalize"
    for scale in (HUGE, TINY):
        b = scaled(a, scale)
        v = Vector3(*b)
        about.call = f"v = Vector3{rounded(b)}; v.normalize()"
        about.cause = (
            "You square components whose squares are too large or too small for a float. Compute "
            "the length with magnitude(), which avoids this."
        )
        v.normalize()
        taken = (
            "v did not change, because you treat a very short vector as zero. Return early only if "
            "magnitude() is exactly 0.0."
        )
        mistakes = [
            (b, taken if scale == TINY else LOST),
            (
                ZERO,
                "The result is zero, because your squared length overflows to infinity. Compute "
                "the length with magnitude() instead.",
            ),
        ]
        blame(xyz(v), mistakes)
        expect_close(xyz(v), scaled(a, 1.0 / length), then="; v")
