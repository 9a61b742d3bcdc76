"""Vector3: scaled sums and the three products, build tasks B2.6 to B2.9."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random
from typing import Any

import pytest

from ch02_vectors.probes import walk
from ch02_vectors.vector import Vector3
from draw import Components, components, dot, number, rounded
from expect import (
    LOST,
    UNCHANGED,
    about,
    blame,
    expect_close,
    expect_unchanged,
    is_plain,
    xyz,
)


def vector_product(a: Components, b: Components) -> Components:
    """Return a x b, computed from its definition."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


# B2.6 Add a scaled vector


@pytest.mark.exercise("B2.6", asks="to this vector, in place")
def test_add_scaled_changes_the_vector_itself(rng: Random) -> None:
    a, b, scale = components(rng), components(rng), number(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] + b[0] * scale, a[1] + b[1] * scale, a[2] + b[2] * scale)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.add_scaled(w, {scale})"
    about(
        cause="v must become v + w times the number. Multiply w by the number and add the product "
        "to v itself, but leave w unchanged.",
        read="book 2.1.4",
    )
    v.add_scaled(w, scale)
    mistakes = [
        (a, LOST),
        (tuple(a[i] * scale + b[i] for i in range(3)), "You multiply the wrong vector by the "
         "number: v instead of w. Add w times the number to v."),
        (tuple((a[i] + b[i]) * scale for i in range(3)), "You multiply the whole sum v + w by the "
         "number. Multiply only w by it, and then add the product to v."),
        (tuple(a[i] + b[i] for i in range(3)), "You add w without multiplying it by the "
         "number. Multiply each component of w first."),
        (tuple(a[i] + b[i] + scale for i in range(3)), "You add the number to each component. "
         "Multiply each component of w by it."),
        (tuple(b[i] * scale for i in range(3)), "v is now only w times the number. Add this "
         "product to the components that v already has."),
    ]  # fmt: skip
    blame(xyz(v), mistakes)
    # The rounding errors of numbers up to 100.
    expect_close(xyz(v), wanted, then="; v", tolerance=1e-12)
    about.cause = (
        "You change w, which belongs to the caller, as w *= number does. Use w * number instead, "
        "which creates a new vector."
    )
    expect_unchanged("w", xyz(w), b)


@pytest.mark.exercise("B2.6", asks="if the other vector is the vector itself")
def test_add_scaled_with_itself(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; v.add_scaled(v, 2)"
    about.cause = (
        "Here self and the argument are the same vector, v, so each change to self also changes "
        "the argument. Read each component before you change it."
    )
    about.read = "the docstring of Vector3.add_scaled"
    v.add_scaled(v, 2.0)
    expect_close(xyz(v), (3.0 * a[0], 3.0 * a[1], 3.0 * a[2]), then="; v")


@pytest.mark.exercise("B2.6", asks="in place, as in p' = p + v h")
def test_add_scaled_frame_after_frame(rng: Random) -> None:
    start, velocity = components(rng), components(rng)
    wanted = tuple(p + 10.0 * v for p, v in zip(start, velocity, strict=True))
    about.call = f"p, v = Vector3{start}, Vector3{velocity}; p.add_scaled(v, 1 / 60) 600 times; p"
    about(
        cause="After 600 calls, p must be p + 10 v. Each call must add v times 1/60 to p.",
        read="book 2.2, Eq. 2.7",
    )
    got = walk(start, velocity, 1.0 / 60.0, 600)
    # 600 roundings of numbers up to 100.
    expect_close(got, wanted, tolerance=1e-10)


# B2.7 The component product


@pytest.mark.exercise("B2.7", asks="matching component of v, and return a new vector")
def test_the_component_product_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] * b[0], a[1] * b[1], a[2] * b[2])
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.component_product(w)"
    about.cause = "Multiply x by x, y by y and z by z. Return the three products as a new vector."
    about.read = "book 2.1.6"
    got = xyz(v.component_product(w))
    scalar = (
        "The result is the scalar product, a single number. Return the three products as a vector "
        "instead of adding them up."
    )
    mistakes = [
        (dot(a, b), scalar),
        (tuple(a[i] + b[i] for i in range(3)), "The result is v + w. Multiply the matching "
        "components instead of adding them."),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, wanted)
    about.cause = (
        "Your component_product changes v or w, but only component_product_update may change v. "
        "Return a new vector and leave both unchanged."
    )
    expect_unchanged("v", xyz(v), a)
    expect_unchanged("w", xyz(w), b)


@pytest.mark.exercise("B2.7", asks="by the matching component of v, in place")
def test_the_component_product_in_place(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] * b[0], a[1] * b[1], a[2] * b[2])
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.component_product_update(w)"
    about(
        cause="This method must change v itself. Store the three products of the matching "
        "components in v.",
        read="book 2.1.6",
    )
    v.component_product_update(w)
    blame(xyz(v), [(a, LOST)])
    expect_close(xyz(v), wanted, then="; v")
    expect_unchanged("w", xyz(w), b, cause=UNCHANGED)


@pytest.mark.exercise("B2.7", asks="if the other vector is the vector itself")
def test_the_component_product_with_itself(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    wanted = (a[0] * a[0], a[1] * a[1], a[2] * a[2])
    about.call = f"v = Vector3{a}; v.component_product_update(v)"
    about.cause = (
        "Here self and the argument are the same vector, v, so each change to self also changes "
        "the argument. Read each component before you change it."
    )
    about.read = "book 2.1.6"
    v.component_product_update(v)
    expect_close(xyz(v), wanted, then="; v")


# B2.8 The scalar product


@pytest.mark.exercise("B2.8", asks="The dot product is a single number, the sum")
def test_the_scalar_product_is_the_sum_of_the_products(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = dot(a, b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.dot(w)"
    about(
        cause="The scalar product is a single number. Multiply the matching components, and add up "
        "the three products."
    )
    about.read = "book 2.1.7, Eq. 2.4"
    # The terms may cancel, so rounding is measured by the terms: at most 100 each.
    got = v.dot(w)
    mistakes = [
        (wanted / (math.hypot(*a) * math.hypot(*b)), "The result is the cosine of the angle, "
         "because you divide by both lengths. Return the sum of the three products without "
         "dividing it."),
        (a[0] * b[0] + a[1] * b[1], "The product of the z components is missing from your sum. Add "
         "v.z * w.z to it."),
        (dot(a, a), "You multiply the components of v by themselves. Multiply them by those of w."),
        (dot(b, b), "You multiply the components of w by themselves. Multiply them by those of v."),
        (a[0] * b[0] + a[1] * b[1] * a[2] * b[2], "You multiply the second product by the third "
         "one. Add all three products."),
        (math.hypot(*(p * q for p, q in zip(a, b, strict=True))), "You return the length of the "
         "component product. Add up its components instead."),
        (sum(a) * sum(b), "You multiply the sums of the components. Multiply the matching "
         "components first, and then add up the three products."),
        (math.hypot(*a) * math.hypot(*b), "The result is |v| |w|, the product of the lengths. "
         "Multiply the matching components instead, and add up the three products."),
    ]  # fmt: skip
    blame(got, mistakes)
    if not is_plain(got):
        about.cause = "You return a vector. Add up the three products, and return their sum."
        products = "You return the three products as a vector. Add them up and return the sum."
        crossed = "You return the vector product, a vector. The scalar product is a number."
        pairs = zip(a, b, strict=True)
        blame(xyz(got), [([p * q for p, q in pairs], products), (vector_product(a, b), crossed)])
    expect_close(got, wanted, tolerance=1e-12)
    expect_unchanged("v", xyz(v), a, cause=UNCHANGED)
    expect_unchanged("w", xyz(w), b, cause=UNCHANGED)


@pytest.mark.exercise("B2.8", asks="so that a @ b equals a.dot(b)")
def test_the_at_sign_is_the_scalar_product(rng: Random) -> None:
    a, b = components(rng), components(rng)
    wanted = dot(a, b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v @ w"
    about(
        cause="Your __matmul__ doesn't return the scalar product, so v @ w is not equal to "
        "v.dot(w). Return self.dot(v) instead.",
        read="book 2.1.7, Eq. 2.4",
    )
    got = Vector3(*a) @ Vector3(*b)
    expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("B2.8", asks="|a| |b| cos t, with the angle t")
def test_the_scalar_product_is_the_lengths_times_the_cosine(rng: Random) -> None:
    angle, first, second = rng.uniform(1.8, 3.0), rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    a = (0.0, first, 0.0)
    b = (second * math.sin(angle), second * math.cos(angle), 0.0)
    wanted = first * second * math.cos(angle)
    about.call = f"v, w = Vector3{rounded(a)}, Vector3{rounded(b)}; v.dot(w)"
    about.cause = (
        "The angle between v and w is obtuse, so the scalar product must be negative. Don't round "
        "it, and don't take an absolute value."
    )
    about.read = "book 2.1.7, Eq. 2.4"
    got = Vector3(*a).dot(Vector3(*b))
    expect_close(got, wanted, tolerance=1e-12)


# B2.9 The vector product


def wrong_component(gots: Sequence[Any], wanteds: Sequence[Components], otherwise: str) -> str:
    """Return a cause that names the only wrong component of some vector products."""
    pairs = [
        pair
        for got, wanted in zip(gots, wanteds, strict=True)
        for pair in enumerate(zip(got, wanted, strict=True))
    ]
    wrong = {i for i, (one, other) in pairs if abs(one - other) > 1e-9}
    if len(wrong) != 1:  # several components are wrong, or none
        return otherwise
    x, y, z = ("xyz" * 2)[wrong.pop() :][:3]
    return (
        f"The {x} component of your vector product is wrong. It must be self.{y} * v.{z} - "
        f"self.{z} * v.{y}. Check its signs and its letters."
    )


@pytest.mark.exercise("B2.9", asks="The axes of our engine are right-handed")
def test_the_vector_product_of_two_axes_is_the_third() -> None:
    axes = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    about(
        cause="The vector product of two axes must be the third axis: X x Y = Z, Y x Z = X and Z x "
        "X = Y. Check the order of the terms in each component."
    )
    about.read = "book 2.1.8, Eq. 2.6"
    products = []
    for i in range(3):
        a, b = axes[i], axes[(i + 1) % 3]
        about.call = f"Vector3{a}.cross(Vector3{b})"
        products.append((about.call, xyz(Vector3(*a).cross(Vector3(*b))), axes[(i + 2) % 3]))
    if all(isinstance(got, tuple) for _, got, _ in products):
        _, gots, wanteds = zip(*products, strict=True)
        about.cause = wrong_component(gots, wanteds, about.cause)
        if gots == ((0.0, 1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)):
            about.cause = "Your y and z components are in the wrong order. Swap them."
        if all(got == (0.0, 0.0, 0.0) for got in gots):
            about.cause = (
                "Your vector product of two different axes is zero, like the component product. "
                "Each component of the vector product uses the two other letters."
            )
    turned = [got == tuple(-n for n in wanted) for _, got, wanted in products]
    for i, (call, got, wanted) in enumerate(products):
        about.call = call
        if all(turned):
            about.cause = (
                "You compute b x a instead of a x b, so all three components have the wrong sign. "
                "Swap the two terms in every component."
            )
        elif turned[i]:
            about.cause = (
                f"The {'zxy'[i]} component of your vector product has the wrong sign. Swap the two "
                "terms in its formula."
            )
        expect_close(got, wanted)


@pytest.mark.exercise("B2.9", asks="Return the vector product a x b as a new vector")
def test_the_vector_product_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.cross(w)"
    about.cause = (
        "Check which components you multiply. The x component of the result uses only y and z, its "
        "y component only z and x, and its z component only x and y."
    )
    about.read = "book 2.1.8, Eq. 2.6"
    wanted = vector_product(a, b)
    got = xyz(v.cross(w))
    if isinstance(got, tuple):
        about.cause = wrong_component([got], [wanted], about.cause)
    x, y, z = wanted
    mistakes = [
        ((x, z, y), "Your y and z components are in the wrong order."),
        ((y, x, z), "Your x and y components are in the wrong order."),
        ((z, y, x), "Your x and z components are in the wrong order."),
    ]
    blame(got, mistakes)
    # The two terms of a component may cancel, so rounding is measured by the terms.
    expect_close(got, wanted, tolerance=1e-12)
    expect_unchanged("v", xyz(v), a, cause=UNCHANGED)
    expect_unchanged("w", xyz(w), b, cause=UNCHANGED)


@pytest.mark.exercise("B2.9", asks="has the length |a| |b| sin t")
def test_the_vector_product_is_the_lengths_times_the_sine(rng: Random) -> None:
    angle, first, second = rng.uniform(0.2, 3.0), rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    a = (0.0, 0.0, first)
    b = (second * math.sin(angle), 0.0, second * math.cos(angle))
    wanted = (0.0, first * second * math.sin(angle), 0.0)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.cross(w)"
    about.cause = (
        "Your y component is wrong. It must be v.z * w.x - v.x * w.z, with its two terms in this "
        "order."
    )
    about.read = "book 2.1.8, Eq. 2.6"
    got = Vector3(*a).cross(Vector3(*b))
    expect_close(xyz(got), wanted, tolerance=1e-12)


@pytest.mark.exercise("B2.9", asks="Set this vector to the vector product self x v")
def test_the_vector_product_in_place(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.cross_update(w)"
    about.cause = (
        "v must become v x w, the same vector that v.cross(w) returns. Store its three components "
        "in v."
    )
    about.read = "the docstring of Vector3.cross_update"
    v.cross_update(w)
    wanted = vector_product(a, b)
    x = wanted[0]
    y = a[2] * b[0] - x * b[2]
    mistakes = [
        (a, LOST),
        ((x, wanted[1], a[0] * b[1] - wanted[1] * b[0]), "Your z component is computed from the "
         "new y, which you have already stored. Compute all three components before you store any "
         "of them."),
        ((x, y, x * b[1] - y * b[0]), "Your y component is computed from the new x, which you have "
         "already stored. Compute all three components before you store any of them."),
    ]  # fmt: skip
    blame(xyz(v), mistakes)
    expect_close(xyz(v), wanted, then="; v", tolerance=1e-12)
    expect_unchanged("w", xyz(w), b, cause=UNCHANGED)


@pytest.mark.exercise("B2.9", asks="if the other vector is the vector itself")
def test_a_vector_crossed_with_itself_in_place(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; v.cross_update(v)"
    about.cause = (
        "The vector product of v with itself must be zero. Here v is both factors, so each change "
        "to v changes both of them. Compute all three components before you store any."
    )
    about.read = "book 2.1.8"
    v.cross_update(v)
    expect_close(xyz(v), (0.0, 0.0, 0.0), then="; v", tolerance=1e-12)
