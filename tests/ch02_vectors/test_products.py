"""Vector3: the component product, the scalar and the vector product, build tasks B2.7 to B2.9."""

from __future__ import annotations

import math
from operator import mul
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from draw import Components, Triple, vector
from expect import LOST, UNCHANGED, about, expect_close, expect_unchanged, is_plain, named, xyz

BOOK = "book 2.1.6"
DOC = "the docstring of the method"
DOT = "book 2.1.7, Eq. 2.4"
CROSS = "book 2.1.8, Eq. 2.6"
PRODUCTS = "Multiply x by x, y by y and z by z."


# B2.7 The component product


@pytest.mark.exercise("B2.7", asks="matching component of v, and return a new vector", read=BOOK)
def test_the_component_product_is_a_new_vector(rng: Random) -> None:
    a, b = vector(rng), vector(rng)
    with calls(f"{PRODUCTS} Return the three products as a new vector."):
        v, w = Vector3(*a), Vector3(*b)
        got = v.component_product(w)
    slips = {
        "The result is the scalar product, a single number.": a @ b,
        "The result is v + w.": a + b,
    }
    expect_close(xyz(got), Triple(map(mul, a, b)), slips)
    for name, now, before in (("v", v, a), ("w", w, b)):
        cause = f"Your component_product changes {name}, but it must leave both vectors unchanged."
        expect_unchanged(name, now, before, cause=f"{cause} Return a new vector.")


@pytest.mark.exercise("B2.7", asks="by the matching component of v, in place", read=BOOK)
def test_the_component_product_in_place(rng: Random) -> None:
    a, b = vector(rng), vector(rng)
    with calls(f"This method must change v itself. {PRODUCTS} Store the three products in v."):
        v, w = Vector3(*a), Vector3(*b)
        v.component_product_update(w)
    expect_close(v, Triple(map(mul, a, b)), {LOST: a}, then="; v")
    expect_unchanged("w", w, b, cause=UNCHANGED)
    with calls(
        "Here self and the argument are the same vector, v, so each change to self also changes "
        "the argument. Read each component before you change it."
    ):
        v = Vector3(*a)
        v.component_product_update(v)
    expect_close(v, Triple(map(mul, a, a)), then="; v")


# B2.8 The scalar product


@pytest.mark.exercise("B2.8", asks="The dot product is a single number, the sum", read=DOT)
def test_the_scalar_product_is_the_sum_of_the_products(rng: Random) -> None:
    a, b = vector(rng), vector(rng)
    with calls("Multiply the matching components, and add up the three products."):
        v, w = Vector3(*a), Vector3(*b)
        got = v.dot(w)
    x, y, z = products = Triple(map(mul, a, b))
    slips = {
        "The result is the cosine of the angle, because you divide by both lengths.":
            a @ b / (abs(a) * abs(b)),
        "The product of the z components is missing from your sum.": x + y,
        "You multiply the components of v by themselves.": a @ a,
        "You multiply the components of w by themselves.": b @ b,
        "You multiply the second product by the third one.": x + y * z,
        "You return the length of the component product.": abs(products),
        "You multiply the sums of the components.": sum(a) * sum(b),
        "The result is |v| |w|, the product of the lengths.": abs(a) * abs(b),
        "You return the three products as a vector.": products,
        "You return the vector product, but the scalar product is a number.": a.cross(b),
    }  # fmt: skip
    # The terms may cancel, so rounding is measured by the terms: at most 100 each.
    cause = named(got if is_plain(got) else xyz(got), about.cause, slips)
    expect_close(got, a @ b, tolerance=1e-12, cause=cause)
    expect_unchanged("v", v, a, cause=UNCHANGED)
    expect_unchanged("w", w, b, cause=UNCHANGED)


@pytest.mark.exercise("B2.8", asks="so that a @ b equals a.dot(b)", read=DOT)
def test_the_at_sign_is_the_scalar_product(rng: Random) -> None:
    a, b = vector(rng), vector(rng)
    with calls("v @ w must be the scalar product, v.dot(w). Return self.dot(v) in __matmul__."):
        v, w = Vector3(*a), Vector3(*b)
        got = v @ w
    expect_close(got, a @ b, tolerance=1e-12)


@pytest.mark.exercise("B2.8", asks="|a| |b| cos t, with the angle t", read=DOT)
def test_the_scalar_product_is_the_lengths_times_the_cosine(rng: Random) -> None:
    angle, first, second = rng.uniform(1.8, 3.0), rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    b = second * Triple((math.sin(angle), math.cos(angle), 0.0))
    with calls(
        "The angle between v and w is obtuse, so the scalar product must be negative. Don't round "
        "it, and don't take an absolute value."
    ):
        v, w = Vector3(0.0, first, 0.0), Vector3(*b)
        got = v.dot(w)
    expect_close(got, first * second * math.cos(angle), tolerance=1e-12)


# B2.9 The vector product


def wrong_component(gots: list[Any], wanteds: list[Components], otherwise: str) -> str:
    """Return a cause that names the only wrong component of some vector products."""
    wrong = {
        i
        for got, wanted in zip(gots, wanteds, strict=True)
        for i in range(3)
        if isinstance(got, tuple) and abs(got[i] - wanted[i]) > 1e-9
    }
    if len(wrong) != 1:  # several components are wrong, or none
        return otherwise
    x, y, z = ("xyz" * 2)[wrong.pop() :][:3]
    return (
        f"The {x} component of your vector product is wrong. It must be self.{y} * v.{z} - "
        f"self.{z} * v.{y}. Check its signs and its letters."
    )


@pytest.mark.exercise("B2.9", asks="The axes of our engine are right-handed", read=CROSS)
def test_the_vector_product_of_two_axes_is_the_third() -> None:
    with calls(
        "The vector product of two axes must be the third axis: X x Y = Z, Y x Z = X and Z x X = "
        "Y. Check the order of the terms in each component."
    ):
        x, y, z = Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0), Vector3(0.0, 0.0, 1.0)
        products = x.cross(y), y.cross(z), z.cross(x)
    gots: list[Any] = [xyz(product) for product in products]
    wanteds = [(0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
    slips = {
        "You compute b x a instead of a x b, so all three components have the wrong sign. Swap the "
        "two terms in every component.": [(0, 0, -1), (-1, 0, 0), (0, -1, 0)],
        "Your y and z components are in the wrong order. Swap them.":
            [(0, 1, 0), (1, 0, 0), (0, 0, 1)],
        "Your vector product of two different axes is zero, like the component product. Each "
        "component of the vector product uses the two other letters.": [(0, 0, 0)] * 3,
    }  # fmt: skip
    found = [slip for slip, numbers in slips.items() if gots == numbers]
    cause = found[0] if found else wrong_component(gots, wanteds, about.cause)
    for which, got, wanted in zip(("first", "second", "third"), gots, wanteds, strict=True):
        expect_close(got, wanted, then=f"; the {which} of these vectors", cause=cause)


@pytest.mark.exercise("B2.9", asks="Return the vector product a x b as a new vector", read=CROSS)
def test_the_vector_product_is_a_new_vector(rng: Random) -> None:
    a, b = vector(rng), vector(rng)
    with calls(
        "Check which components you multiply. The x component of the result uses only y and z, its "
        "y component only z and x, and its z component only x and y."
    ):
        v, w = Vector3(*a), Vector3(*b)
        got = v.cross(w)
    x, y, z = wanted = a.cross(b)
    slips = {
        "Your y and z components are in the wrong order.": (x, z, y),
        "Your x and y components are in the wrong order.": (y, x, z),
        "Your x and z components are in the wrong order.": (z, y, x),
    }
    # The two terms of a component may cancel, so rounding is measured by the terms.
    cause = wrong_component([xyz(got)], [wanted], about.cause)
    expect_close(xyz(got), wanted, slips, tolerance=1e-12, cause=cause)
    expect_unchanged("v", v, a, cause=UNCHANGED)
    expect_unchanged("w", w, b, cause=UNCHANGED)


@pytest.mark.exercise("B2.9", asks="has the length |a| |b| sin t", read=CROSS)
def test_the_vector_product_is_the_lengths_times_the_sine(rng: Random) -> None:
    """Only here the wanted vector comes from two lengths and an angle, not from components."""
    angle, first, second = rng.uniform(0.2, 3.0), rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    b = second * Triple((math.sin(angle), 0.0, math.cos(angle)))
    with calls("Your y component is wrong. It must be v.z * w.x - v.x * w.z, in this order."):
        v, w = Vector3(0.0, 0.0, first), Vector3(*b)
        got = v.cross(w)
    expect_close(xyz(got), (0.0, first * second * math.sin(angle), 0.0), tolerance=1e-12)


@pytest.mark.exercise("B2.9", asks="Set this vector to the vector product self x v", read=DOC)
def test_the_vector_product_in_place(rng: Random) -> None:
    a, b = vector(rng), vector(rng)
    with calls(
        "Either cross or this method gets a component wrong, or you store one in v before you have "
        "computed all three."
    ):
        v, w = Vector3(*a), Vector3(*b)
        v.cross_update(w)
    x, y, _ = wanted = a.cross(b)
    late = a[2] * b[0] - x * b[2]  # y, from the new x
    slips = {
        LOST: a,
        "Your z component is computed from the new y, which you have already stored.":
            (x, y, a[0] * b[1] - y * b[0]),
        "Your y component is computed from the new x, which you have already stored.":
            (x, late, x * b[1] - late * b[0]),
    }  # fmt: skip
    expect_close(v, wanted, slips, then="; v", tolerance=1e-12)
    expect_unchanged("w", w, b, cause=UNCHANGED)


@pytest.mark.exercise("B2.9", asks="if the other vector is the vector itself", read="book 2.1.8")
def test_a_vector_crossed_with_itself_in_place(rng: Random) -> None:
    a = vector(rng)
    with calls(
        "The vector product of v with itself must be zero. If a term has a wrong sign, it is not. "
        "Here v is also both factors, so compute all three components before you store any."
    ):
        v = Vector3(*a)
        v.cross_update(v)
    expect_close(v, (0.0, 0.0, 0.0), then="; v", tolerance=1e-12)
