"""Quaternions: length and product, build tasks B9.7 and B9.8."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch09_rotations.quaternion import Quaternion
from draw import number
from expect import about, expect_close, expect_exactly
from turning import Quad, draw_quad, expect_kept, hamilton, named, rijk, short

LENGTH = "the docstrings of Quaternion.magnitude and is_unit"
NORMALIZE = "book 9.4.8, and the docstring of normalize"
PRODUCT = "book 9.4.9"
RETURN_NEW = "return a new Quaternion with the result."


def draw_four(rng: Random) -> Quad:
    """Draw four components away from zero."""
    return number(rng), number(rng), number(rng), number(rng)


@pytest.mark.exercise("B9.7", asks="Compute the length, sqrt(r^2 + i^2 + j^2 + k^2)")
def test_the_length_of_four_components(rng: Random) -> None:
    about(
        cause="The magnitude is sqrt(r^2 + i^2 + j^2 + k^2).",
        read=LENGTH,
    )
    about.call = "Quaternion(2, -5, 4, 6).magnitude()"
    got = Quaternion(2.0, -5.0, 4.0, 6.0).magnitude()
    slips = {
        "Your result is the sum of the squares. Take the square root of it.": 81.0,
        "You leave out r. Add r^2 to the other three squares.": math.sqrt(77.0),
        "You leave out i. Add i^2 to the other three squares.": math.sqrt(56.0),
        "You leave out j. Add j^2 to the other three squares.": math.sqrt(65.0),
        "You leave out k. Add k^2 to the other three squares.": math.sqrt(45.0),
        "the sum of the four components": 7.0,
        "the sum of the four absolute values": 17.0,
    }
    expect_close(got, 9.0, cause=named(got, about.cause, slips))
    q = draw_four(rng)
    about.call = f"q = Quaternion{short(q)}; q.magnitude()"
    quaternion = Quaternion(*q)
    got = quaternion.magnitude()
    expect_close(got, math.hypot(*q))
    expect_kept("q", rijk(quaternion), q)


@pytest.mark.exercise("B9.7", asks="Return True if the length is 1 to within")
def test_is_unit_accepts_lengths_near_one(rng: Random) -> None:
    about.read = LENGTH
    q = draw_quad(rng)
    for length, wanted in (
        (1.0, True),
        (1.0 + 9e-7, True),
        (1.0 - 9e-7, True),
        (1.0 + 1.1e-6, False),
        (1.0 - 1.1e-6, False),
        (0.0, False),
        (-3.0, False),
    ):
        scaled = tuple(component * length for component in q)
        about.call = f"q = Quaternion{short(scaled)}, whose length is {abs(length)}; q.is_unit()"
        off = f"The length differs from 1 by {abs(abs(length) - 1.0):.2g}, which is"
        about.cause = f"{off} more than UNIT_TOLERANCE (1e-6), so return False."
        if wanted:
            about.cause = f"{off} within UNIT_TOLERANCE (1e-6), so return True. "
            about.cause += "Compare the length itself, not its square."
        elif 0.9 < length < 1.0:
            about.cause = "You accept every length below 1. Compare the absolute value of "
            about.cause += "length - 1 with UNIT_TOLERANCE (1e-6)."
        quaternion = Quaternion(*scaled)
        got = quaternion.is_unit()
        expect_exactly(got, wanted)
        expect_kept("q", rijk(quaternion), scaled)
    cause = (
        "You reject a half-turn, where r is 0. The length of this quaternion is 1, so return True."
    )
    about("Quaternion(0, 0.6, 0, 0.8).is_unit()", cause=cause)
    got = Quaternion(0.0, 0.6, 0.0, 0.8).is_unit()
    expect_exactly(got, True)


@pytest.mark.exercise("B9.7", asks="by dividing each component by the length")
def test_normalized_it_has_length_one(rng: Random) -> None:
    about.read = NORMALIZE
    drawn, near = draw_four(rng), draw_quad(rng)
    opposite = tuple(-component for component in drawn)
    for q in (drawn, opposite, tuple(component * (1.0 + 5e-7) for component in near)):
        length = math.hypot(*q)
        about.cause = "Divide each of the four components by the length."
        quaternion = Quaternion(*q)
        about.call = f"q = Quaternion{short(q)}; q.normalize(); q"
        returned = quaternion.normalize()
        wanted = tuple(component / length for component in q)
        got = rijk(quaternion)
        in_turn = [*q]
        for place in range(4):
            in_turn[place] /= math.hypot(*in_turn)
        slips = {
            "You compute the length again after you have changed a component. Compute it only "
            "once, before the first change.": in_turn,
            "The quaternion hasn't changed. Assign the new values to the components of self, "
            "because a new quaternion is lost when the method returns.": q,
            "You divide by the squared length instead of the length.": [c / length**2 for c in q],
            "You multiply by the length instead of dividing by it.": [c * length for c in q],
        }
        if length != 1.0 and abs(length - 1.0) < 1e-6:
            about.cause = (
                "The length is not exactly 1, although is_unit() accepts it. Divide by it."
            )
            slips = {
                "You leave this quaternion unchanged because is_unit() accepts it. Its length is "
                "not exactly 1, so divide by it.": q
            }
        expect_close(got, wanted, cause=named(got, about.cause, slips, wanted))
    about.cause = "normalize works in place, so it shouldn't return anything."
    about.call = f"Quaternion{short(q)}.normalize()"
    expect_exactly(returned, None)


@pytest.mark.exercise("B9.7", asks="so it becomes (1, 0, 0, 0), the reference")
def test_zero_becomes_the_reference() -> None:
    about("q = Quaternion(0, 0, 0, 0); q.normalize(); q", read=NORMALIZE)
    about.cause = (
        "The zero quaternion has a length of 0, so you can't divide by its length. Set it to (1, "
        "0, 0, 0), which is the rotation by 0."
    )
    quaternion = Quaternion(0.0, 0.0, 0.0, 0.0)
    quaternion.normalize()
    about.cause = "You leave the zero quaternion as it is. Set it to (1, 0, 0, 0), the rotation by "
    about.cause += "0, because it has no direction."
    expect_close(rijk(quaternion), (1.0, 0.0, 0.0, 0.0))


@pytest.mark.exercise("B9.7", asks="NaN, infinite or as large as 1e200")
@pytest.mark.robust
def test_is_unit_rejects_huge_components_and_nan(rng: Random) -> None:
    about.read = LENGTH
    q = draw_quad(rng)
    about.cause = (
        "You test whether the length is too far from 1, which is False for NaN. Test whether it is "
        "close enough to 1 instead."
    )
    for length in (math.nan, math.inf):
        scaled = tuple(component * length for component in q)
        about.call = f"Quaternion{short(scaled)}.is_unit()"
        got = Quaternion(*scaled).is_unit()
        expect_exactly(got, False)
    about.call = "Quaternion(1e200, 0, 0, 1e200).is_unit()"
    about.cause = (
        "You square 1e200, and the square is too large for a float. Compute the length with "
        "magnitude() instead."
    )
    got = Quaternion(1e200, 0.0, 0.0, 1e200).is_unit()
    expect_exactly(got, False)


@pytest.mark.exercise("B9.7", asks="as large as 1e200 and as small as 1e-200")
@pytest.mark.robust
def test_huge_and_tiny_components_have_a_length(rng: Random) -> None:
    about.read = NORMALIZE
    q = draw_four(rng)
    length = math.hypot(*q)
    wanted = tuple(component / length for component in q)
    about.cause = (
        "You square the components, but their squares don't fit into a float. Call math.hypot "
        "instead, which works for numbers of any size."
    )
    for scale in (1e200, 1e-200):
        scaled = tuple(component * scale for component in q)
        about.call = f"q = Quaternion{short(scaled)}; q.magnitude() / {scale}"
        got = Quaternion(*scaled).magnitude() / scale
        expect_close(got, length)
        quaternion = Quaternion(*scaled)
        about.call = f"q = Quaternion{short(scaled)}; q.normalize(); q"
        quaternion.normalize()
        expect_close(rijk(quaternion), wanted)


@pytest.mark.exercise("B9.8", asks="Return the new quaternion (r, -i, -j, -k)")
def test_the_conjugate_turns_back(rng: Random) -> None:
    about.read = "the docstring of conjugate"
    q = draw_four(rng)
    quaternion = Quaternion(*q)
    about.call = f"q = Quaternion{short(q)}; q.conjugate()"
    about.cause = (
        "The conjugate keeps r and reverses the signs of i, j and k. Return it as a new quaternion."
    )
    got = rijk(quaternion.conjugate())
    expect_kept("q", rijk(quaternion), q, f"Leave q as it is, and {RETURN_NEW}")
    r, i, j, k = q
    wanted = (r, -i, -j, -k)
    slips = {
        "You reverse all four signs. Keep the sign of r.": (-r, -i, -j, -k),
        "You reverse the sign of r. Keep it, and reverse the signs of i, j and k.": (-r, i, j, k),
        "the original quaternion": q,
    }
    why = named(got, about.cause, slips)
    expect_close(got, wanted, cause=why, tolerance=0.0)


def componentwise(a: Quad, b: Quad) -> Quad:
    """Return the products of the components that are in the same place."""
    return a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3]


def without_cross(a: Quad, b: Quad) -> Quad:
    """Return the product of two quaternions without the vector product of their vector parts."""
    r, *_ = hamilton(a, b)
    i, j, k = (a[0] * q + p * b[0] for p, q in zip(a[1:], b[1:], strict=True))
    return r, i, j, k


def without_dot(a: Quad, b: Quad) -> Quad:
    """Return the product of two quaternions without the scalar product of their vector parts."""
    return a[0] * b[0], *hamilton(a, b)[1:]


PRODUCT_SLIPS = {
    componentwise: "You multiply the quaternions component by component. Instead, multiply each of "
    "the four terms of the first by each of the four terms of the second, which gives 16 products.",
    without_cross: "You leave out the products of two different letters, such as i j = k. They are "
    "the vector product v x v' of the two vector parts, so add it.",
    without_dot: "You leave out the products i i, j j and k k. Each of them is -1, so subtract i "
    "i', j j' and k k' in the scalar part.",
}


@pytest.mark.exercise("B9.8", asks="check that i · j = k, j · k = i and k · i = j")
def test_the_table_of_i_j_and_k() -> None:
    about.read = PRODUCT
    units = {
        "1": (1.0, 0.0, 0.0, 0.0),
        "i": (0.0, 1.0, 0.0, 0.0),
        "j": (0.0, 0.0, 1.0, 0.0),
        "k": (0.0, 0.0, 0.0, 1.0),
    }
    about.cause = (
        "The rules are i i = j j = k k = -1, i j = k, j k = i and k i = j. If you swap two "
        "different factors, their product changes sign."
    )
    products = []
    for first, a in units.items():
        for second, b in units.items():
            about.call = f"Quaternion{short(a)} * Quaternion{short(b)}, which is {first} {second}"
            one, other = Quaternion(*a), Quaternion(*b)
            products.append((about.call, f"{first} {second}", a, b, rijk(one * other)))
            instead = f"Leave both factors as they are, and {RETURN_NEW}"
            expect_kept("the first factor", rijk(one), a, instead)
            expect_kept("the second factor", rijk(other), b, instead)
    in_reverse = all(got == hamilton(b, a) for *_, a, b, got in products)
    for wrong, why in PRODUCT_SLIPS.items():
        if all(got == wrong(a, b) for *_, a, b, got in products):
            about.cause = why
    for call, name, a, b, got in products:
        about.call, wanted = call, hamilton(a, b)
        first, second = name.split()
        right = "-" * (min(wanted) < 0.0) + "1ijk"[[*map(abs, wanted)].index(1.0)]
        slips = {
            f"Your product {name} has the wrong sign. The rule is {name} = {right}.": [
                -component for component in wanted
            ]
        }
        if in_reverse:
            slips = {
                "You multiply the factors in the wrong order. Your result is "
                f"{second} {first} instead of {name}.": hamilton(b, a)
            }
        expect_close(got, wanted, cause=named(got, about.cause, slips), tolerance=0.0)


@pytest.mark.exercise("B9.8", asks="which rotates by q and then by self", weight=2)
def test_the_product_of_any_two(rng: Random) -> None:
    about.read = PRODUCT
    a, b = draw_four(rng), draw_four(rng)
    first, second = Quaternion(*a), Quaternion(*b)
    about.call = f"a, b = Quaternion{short(a)}, Quaternion{short(b)}; a * b"
    about.cause = (
        "With the vector parts v and v', the scalar part of the product is r r' - v . v', and the "
        "vector part is r v' + r' v + v x v'. Return a new quaternion."
    )
    got = rijk(first * second)
    # Four products of up to 90.
    expect_close(got, hamilton(a, b), tolerance=1e-12)
    expect_kept("a", rijk(first), a)
    expect_kept("b", rijk(second), b)
