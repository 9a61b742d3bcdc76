"""Quaternions: length, product, and rotated vectors, build tasks B9.7, B9.8 and B9.10."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion
from draw import Triple, number, vector
from expect import about, expect_close, expect_exactly, expect_that, expect_unchanged, named, xyz
from turning import LOOSE, TIGHT, Quad, draw_quad, expect_kept, hamilton, rijk, short, turned

LENGTH = "the docstrings of Quaternion.magnitude and is_unit"
NORMALIZE = "book 9.4.8, and the docstring of normalize"
CONJUGATE = "the docstring of conjugate"
ROTATE = "the docstring of rotate"
PRODUCT = "book 9.4.9"
NEW = "and return a new Quaternion with the result."


def draw_four(rng: Random) -> Quad:
    """Draw four components away from zero."""
    return number(rng), number(rng), number(rng), number(rng)


def scaled(q: Quad, factor: float) -> Quad:
    """Return a quaternion whose components are multiplied by a factor."""
    return tuple(component * factor for component in q)


@pytest.mark.exercise("B9.7", asks="Compute the length, sqrt(r^2 + i^2 + j^2 + k^2)", read=LENGTH)
def test_the_length_of_four_components(rng: Random) -> None:
    slips = {
        "Your result is the sum of the squares. Take the square root of it.": 81.0,
        "You leave out r.": math.sqrt(77.0),
        "You leave out i.": math.sqrt(56.0),
        "You leave out j.": math.sqrt(65.0),
        "You leave out k.": math.sqrt(45.0),
        "the sum of the four components": 7.0,
        "the sum of the four absolute values": 17.0,
    }
    for a in ((2.0, -5.0, 4.0, 6.0), draw_four(rng)):
        with calls("The magnitude is sqrt(r^2 + i^2 + j^2 + k^2)."):
            q = Quaternion(*a)
            got = q.magnitude()
        expect_close(got, math.hypot(*a), slips)
        expect_kept("q", rijk(q), a)


@pytest.mark.exercise("B9.7", asks="Return True if the length is 1 to within", read=LENGTH)
def test_is_unit_accepts_lengths_near_one(rng: Random) -> None:
    drawn = draw_quad(rng)
    samples = [(1.0, True), (1.0 + 9e-7, True), (1.0 - 9e-7, True), (1.0 + 1.1e-6, False)]
    for length, wanted in (*samples, (1.0 - 1.1e-6, False), (0.0, False), (-3.0, False)):
        off = f"The length differs from 1 by {abs(abs(length) - 1.0):.2g}, which is"
        cause = f"{off} more than UNIT_TOLERANCE (1e-6), so return False."
        if wanted:
            cause = f"{off} within UNIT_TOLERANCE (1e-6), so return True. Test it, not its square."
        elif 0.9 < length < 1.0:
            cause = "You accept every length below 1. Use the absolute value of length - 1."
        a = scaled(drawn, length)
        with calls(cause, f"q = Quaternion{short(a)}, of length {abs(length)}; q.is_unit()"):
            q = Quaternion(*a)
            got = q.is_unit()
        expect_exactly(got, wanted)
        expect_kept("q", rijk(q), a)
    with calls("You reject a half-turn, where r is 0. The length is 1, so return True."):
        got = Quaternion(0.0, 0.6, 0.0, 0.8).is_unit()
    expect_exactly(got, True)


@pytest.mark.exercise("B9.7", asks="by dividing each component by the length", read=NORMALIZE)
def test_normalized_it_has_length_one(rng: Random) -> None:
    drawn, near = draw_four(rng), draw_quad(rng)
    for a in (drawn, scaled(drawn, -1.0), scaled(near, 1.0 + 5e-7)):
        with calls("Divide each of the four components by the length."):
            q = Quaternion(*a)
            returned = q.normalize()
        length, in_turn = math.hypot(*a), [*a]
        for place in range(4):
            in_turn[place] /= math.hypot(*in_turn)
        slips = {
            "You compute the length again after the first change. Compute it only once.": in_turn,
            "The quaternion hasn't changed. Assign the new values to self.r, self.i and so on.": a,
            "You divide by the squared length instead of the length.": scaled(a, length**-2),
            "You multiply by the length instead of dividing by it.": scaled(a, length),
        }
        if abs(length - 1.0) < 1e-6:
            slips = {
                "You leave this quaternion unchanged because is_unit() accepts it. Its length is "
                "not exactly 1, so divide by it.": a
            }
        expect_close(rijk(q), scaled(a, 1.0 / length), slips, then="; q")
    cause = "normalize works in place, so it shouldn't return anything."
    expect_exactly(returned, None, cause=cause)


@pytest.mark.exercise("B9.7", asks="so it becomes (1, 0, 0, 0), the reference", read=NORMALIZE)
def test_zero_becomes_the_reference() -> None:
    with calls("It has no direction, so set it to (1, 0, 0, 0), the rotation by 0."):
        q = Quaternion(0.0, 0.0, 0.0, 0.0)
        q.normalize()
    slips = {"You leave the zero quaternion as it is.": (0.0, 0.0, 0.0, 0.0)}
    expect_close(rijk(q), (1.0, 0.0, 0.0, 0.0), slips, then="; q")


@pytest.mark.exercise("B9.7", asks="NaN, infinite or as large as 1e200", read=LENGTH)
@pytest.mark.robust
def test_is_unit_rejects_huge_components_and_nan(rng: Random) -> None:
    drawn = draw_quad(rng)
    not_finite = "You test if it is too far from 1, which is False for NaN. Test if it is near 1."
    huge = "The square of 1e200 is too large for a float. Compute the length with magnitude()."
    samples = [(scaled(drawn, length), not_finite) for length in (math.nan, math.inf)]
    for a, cause in (*samples, ((1e200, 0.0, 0.0, 1e200), huge)):
        with calls(cause):
            got = Quaternion(*a).is_unit()
        expect_exactly(got, False)


@pytest.mark.exercise("B9.7", asks="as large as 1e200 and as small as 1e-200", read=NORMALIZE)
@pytest.mark.robust
def test_huge_and_tiny_components_have_a_length(rng: Random) -> None:
    drawn = draw_four(rng)
    length = math.hypot(*drawn)
    for scale in ("e200", "e-200"):
        a = tuple(float(f"{component}{scale}") for component in drawn)
        with calls("The squares of the components don't fit into a float. Use math.hypot instead."):
            q = Quaternion(*a)
            got = q.magnitude()
        expect_close(got / float(f"1{scale}"), length, then=f" / 1{scale}")
        with calls(about.cause):
            q = Quaternion(*a)
            q.normalize()
        expect_close(rijk(q), scaled(drawn, 1.0 / length), then="; q")


@pytest.mark.exercise("B9.8", asks="Return the new quaternion (r, -i, -j, -k)", read=CONJUGATE)
def test_the_conjugate_turns_back(rng: Random) -> None:
    r, i, j, k = draw_four(rng)
    with calls("Return a new quaternion with the same r and the opposite i, j and k."):
        q = Quaternion(r, i, j, k)
        conjugate = q.conjugate()
    expect_kept("q", rijk(q), (r, i, j, k), f"Leave q as it is, {NEW}")
    slips = {
        "You reverse all four signs.": (-r, -i, -j, -k),
        "You reverse the sign of r.": (-r, i, j, k),
        "the original quaternion": (r, i, j, k),
    }
    expect_close(rijk(conjugate), (r, -i, -j, -k), slips, tolerance=0.0)


PRODUCT_SLIPS = {
    "You multiply the quaternions component by component. Instead, multiply each of the four terms "
    "of the first by each of the four terms of the second, which gives 16 products.":
        lambda a, b: tuple(p * q for p, q in zip(a, b, strict=True)),
    "You leave out the products of two different letters, such as i j = k. They are the vector "
    "product v x v' of the two vector parts, so add it.":
        lambda a, b: (hamilton(a, b)[0], *(a[0] * Triple(b[1:]) + b[0] * Triple(a[1:]))),
    "You leave out the products i i, j j and k k. Each of them is -1, so subtract i i', j j' and "
    "k k' in the scalar part.": lambda a, b: (a[0] * b[0], *hamilton(a, b)[1:]),
}  # fmt: skip


@pytest.mark.exercise("B9.8", asks="check that i · j = k, j · k = i and k · i = j", read=PRODUCT)
def test_the_table_of_i_j_and_k() -> None:
    units = {letter: tuple(float(n == m) for m in range(4)) for n, letter in enumerate("1ijk")}
    cause = "The rules are i i = j j = k k = -1, i j = k, j k = i and k i = j, but j i = -k."
    products = []
    for first, a in units.items():
        for second, b in units.items():
            with calls(cause):
                p, q = Quaternion(*a), Quaternion(*b)
                product = p * q
            products.append((about.call, first, second, a, b, rijk(product)))
            expect_kept("the first factor", rijk(p), a, f"Leave both factors as they are, {NEW}")
            expect_kept("the second factor", rijk(q), b, f"Leave both factors as they are, {NEW}")
    in_reverse = all(got == hamilton(b, a) for *_, a, b, got in products)
    for why, wrong in PRODUCT_SLIPS.items():
        if all(got == wrong(a, b) for *_, a, b, got in products):
            cause = why
    for call, first, second, a, b, got in products:
        wanted = hamilton(a, b)
        name = f"{first} {second}"
        right = "-" * (min(wanted) < 0.0) + "1ijk"[[*map(abs, wanted)].index(1.0)]
        slips = {
            f"Your product {name} has the wrong sign. The rule is {name} = {right}.":
                scaled(wanted, -1.0)
        }  # fmt: skip
        if in_reverse:
            slips = {
                "You multiply the factors in the wrong order. Your result is "
                f"{second} {first} instead of {name}.": hamilton(b, a)
            }
        why = named(got, cause, slips)
        expect_close(got, wanted, call=f"{call}, which is {name}", cause=why, tolerance=0.0)


@pytest.mark.exercise("B9.8", asks="which rotates by q and then by self", weight=2, read=PRODUCT)
def test_the_product_of_any_two(rng: Random) -> None:
    p, q = draw_four(rng), draw_four(rng)
    with calls("The product is r r' - v . v' and r v' + r' v + v x v', with the vector part v."):
        a, b = Quaternion(*p), Quaternion(*q)
        product = a * b
    # Four products of up to 90.
    expect_close(rijk(product), hamilton(p, q), tolerance=1e-12)
    expect_kept("a", rijk(a), p)
    expect_kept("b", rijk(b), q)


def rotate_slips(q: Quad, v: Triple) -> dict[str, tuple[float, ...]]:
    """Return the results of likely mistakes in rotate."""
    r, u = q[0], Triple(q[1:])
    back, once, alone = (r, *-u), hamilton(q, (0.0, *v)), (0.0, *v)
    first = "You put r last. It comes first, as in Quaternion(0, x, y, z)."
    r_last = hamilton(hamilton(q, (*v, 0.0)), back)
    across = u.cross(v)
    twice = u.cross(across)
    formula = "In v + 2 r (u x v) + 2 u x (u x v), you leave out the 2 of the"
    return {
        "Your code ignores the sign of r, which is negative here.": turned((abs(r), *u), v),
        "You rotate in the opposite direction. Either you compute q* (0, v) q, with the conjugate "
        "on the wrong side, or you compute v x u instead of u x v.": turned(back, v),
        "You compute q (0, v), without q* on the right. Multiply by q* too.": once[1:],
        "You compute (0, v) q*, without q on the left.": hamilton(alone, back)[1:],
        "You compute q (0, v) q. Use the conjugate of q on the right.": hamilton(once, q)[1:],
        first: r_last[1:],
        f"{first} The result begins with r, too.": r_last[:3],
        "You return r, i and j of the product.": (0.0, *turned(q, v)[:2]),
        "In v + 2 r (u x v) + 2 u x (u x v), your third term has the wrong sign. Compute "
        "u x (u x v), not (u x v) x u.": v + 2.0 * r * across - 2.0 * twice,
        f"{formula} second term. Multiply this term by 2.": v + r * across + 2.0 * twice,
        f"{formula} third term. Multiply this term by 2.": v + 2.0 * r * across + twice,
        "the original v": v,
    }


@pytest.mark.exercise("B9.10", asks="return the result as a new vector", weight=2, read=ROTATE)
def test_rotates_a_vector(rng: Random) -> None:
    half = math.sqrt(0.5)
    drawn = [(scaled(draw_quad(rng), size), vector(rng)) for size in (1.0, -1.0, 1.0 + 5e-7)]
    for a, b in (((half, 0.0, 0.0, half), Triple((1.0, 2.0, 3.0))), *drawn):
        with calls("Return the vector part of q (0, v) q*, where q* is the conjugate of q."):
            q, v = Quaternion(*a), Vector3(*b)
            got = q.rotate(v)
        expect_kept("the vector", v, b, "Return a new vector instead.")
        if isinstance(got, Quaternion):
            cause = "You return the whole product, which is a Quaternion. Return Vector3(i, j, k)."
            expect_that(False, f"Quaternion{short(rijk(got))}", "a Vector3", cause=cause)
        # Rounding of a vector of length up to 17, or the effect of a length that is off by 5e-7.
        near = LOOSE if abs(math.hypot(*a) - 1.0) < 1e-9 else 1e-4
        near = TIGHT if b == (1.0, 2.0, 3.0) else near
        expect_close(xyz(got), turned(a, b), rotate_slips(a, b), tolerance=near)
        expect_kept("q", rijk(q), a)
    with calls("You return v itself. Return a new vector, even if the rotation is by 0."):
        v = Vector3(*b)
        Quaternion().rotate(v).invert()
    expect_unchanged("v", v, b)
