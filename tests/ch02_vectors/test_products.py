"""Vector3: scaled sums and the three products, build tasks B2.6 to B2.9."""

from __future__ import annotations

import math
from collections.abc import Callable
from random import Random
from typing import Any

import pytest

from ch02_vectors.probes import walk
from ch02_vectors.vector import Vector3
from draw import Components, components, dot, number
from expect import (
    LOST,
    UNCHANGED,
    about,
    blame,
    expect_close,
    expect_error,
    expect_exactly,
    expect_nan,
    expect_unchanged,
    scoped,
    xyz,
)


@scoped
def expect_vectors_only(
    rng: Random, expression: str, attempt: Callable[[Any, Any], object]
) -> None:
    """Expect a method, or an operator, to take a vector and to refuse a number."""
    a, b = components(rng), components(rng)
    about.call = f"v = Vector3{a}; {expression}"
    about.cause = "ask isinstance(v, Vector3) first, and raise TypeError where it is not"
    about.read = "the docstring of the method"
    expect_error(
        lambda: attempt(Vector3(*a), 3.0),
        TypeError,
        allowed=lambda: attempt(Vector3(*a), Vector3(*b)),
    )


# B2.6 Add a scaled vector


@pytest.mark.exercise("B2.6")
def test_add_scaled_changes_the_vector_itself(rng: Random) -> None:
    a, b, scale = components(rng), components(rng), number(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] + b[0] * scale, a[1] + b[1] * scale, a[2] + b[2] * scale)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.add_scaled(w, {scale})"
    about(cause="v itself grows by w times the number; w stays as it is", read="book 2.1.4")
    v.add_scaled(w, scale)
    mistakes = [
        (a, LOST),
        (
            tuple(a[i] * scale + b[i] for i in range(3)),
            "v was multiplied, and w was not: the number goes with w",
        ),
        (
            tuple((a[i] + b[i]) * scale for i in range(3)),
            "the sum was multiplied: the number goes with w alone",
        ),
        (tuple(a[i] + b[i] for i in range(3)), "w was added without the number"),
        (tuple(b[i] * scale for i in range(3)), "that is w times the number alone: v is missing"),
    ]
    blame(xyz(v), mistakes)
    # Rounding of numbers up to 100.
    expect_close(xyz(v), wanted, tolerance=1e-12)
    about.cause = "w is the caller's: w *= number would change it, w * number makes a new vector"
    expect_unchanged("w", xyz(w), b)


@pytest.mark.exercise("B2.6")
def test_add_scaled_with_itself(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; v.add_scaled(v, 2)"
    about.cause = "the argument is v itself: do not change it before you have read it"
    about.read = "the docstring of Vector3.add_scaled"
    v.add_scaled(v, 2.0)
    expect_close(xyz(v), (3.0 * a[0], 3.0 * a[1], 3.0 * a[2]))


@pytest.mark.exercise("B2.6")
def test_add_scaled_frame_after_frame(rng: Random) -> None:
    start, velocity = components(rng), components(rng)
    wanted = tuple(p + 10.0 * v for p, v in zip(start, velocity, strict=True))
    about.call = f"p, v = Vector3{start}, Vector3{velocity}; 600 times p.add_scaled(v, 1 / 60)"
    about(cause="600 frames of 1/60 s are 10 s: p' = p + v h in each", read="book 2.2, Eq. 2.7")
    got = walk(start, velocity, 1.0 / 60.0, 600)
    # 600 roundings of numbers up to 100.
    expect_close(got, wanted, tolerance=1e-10)


@pytest.mark.exercise("B2.6")
@pytest.mark.robust
def test_add_scaled_refuses_what_is_no_vector(rng: Random) -> None:
    expect_vectors_only(rng, "v.add_scaled(3.0, 2.0)", lambda v, other: v.add_scaled(other, 2.0))


# B2.7 The component product


@pytest.mark.exercise("B2.7")
def test_the_component_product_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] * b[0], a[1] * b[1], a[2] * b[2])
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.component_product(w)"
    about.cause = "a new vector: x times x, y times y, z times z, and nothing added up"
    about.read = "book 2.1.6"
    got = xyz(v.component_product(w))
    scalar = "that is the scalar product, one number: here the three products stay apart"
    mistakes = [
        (dot(a, b), scalar),
        (tuple(a[i] + b[i] for i in range(3)), "that is v + w: multiply the components"),
    ]
    blame(got, mistakes)
    expect_close(got, wanted)
    about.cause = "it makes a new vector; component_product_update is the one that changes v"
    expect_unchanged("v", xyz(v), a)
    expect_unchanged("w", xyz(w), b)


@pytest.mark.exercise("B2.7")
def test_the_component_product_in_place(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] * b[0], a[1] * b[1], a[2] * b[2])
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.component_product_update(w)"
    about(cause="the three products are stored in v itself", read="book 2.1.6")
    v.component_product_update(w)
    blame(xyz(v), [(a, LOST)])
    expect_close(xyz(v), wanted)
    expect_unchanged("w", xyz(w), b, cause=UNCHANGED)


@pytest.mark.exercise("B2.7")
def test_the_component_product_with_itself(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    wanted = (a[0] * a[0], a[1] * a[1], a[2] * a[2])
    about.call = f"v = Vector3{a}; v.component_product_update(v)"
    about.cause = "the argument is v itself: do not change it before you have read it"
    about.read = "book 2.1.6"
    v.component_product_update(v)
    expect_close(xyz(v), wanted)


@pytest.mark.exercise("B2.7")
@pytest.mark.robust
def test_the_component_products_refuse_what_is_no_vector(rng: Random) -> None:
    expect_vectors_only(
        rng, "v.component_product(3.0)", lambda v, other: v.component_product(other)
    )
    expect_vectors_only(
        rng, "v.component_product_update(3.0)", lambda v, other: v.component_product_update(other)
    )


# B2.8 The scalar product


@pytest.mark.exercise("B2.8")
def test_the_scalar_product_is_the_sum_of_the_products(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = dot(a, b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.dot(w)"
    about(cause="a number: the three products of components, added up", read="book 2.1.7, Eq. 2.4")
    # The terms may cancel, so rounding is measured by the terms: at most 100 each.
    got = v.dot(w)
    mistakes = [
        (
            wanted / (math.hypot(*a) * math.hypot(*b)),
            "that is the cosine of the angle: the product is not divided by the lengths",
        ),
        (a[0] * b[0] + a[1] * b[1], "the product of the z components is missing"),
        (math.hypot(*a) * math.hypot(*b), "that is |v| |w|, without the cosine of their angle"),
    ]
    blame(got, mistakes)
    expect_close(got, wanted, tolerance=1e-12)
    expect_unchanged("v", xyz(v), a, cause=UNCHANGED)
    expect_unchanged("w", xyz(w), b, cause=UNCHANGED)


@pytest.mark.exercise("B2.8")
def test_the_at_sign_is_the_scalar_product(rng: Random) -> None:
    a, b = components(rng), components(rng)
    wanted = dot(a, b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v @ w"
    about(cause="@ is another spelling of dot: return self.dot(v)", read="book 2.1.7, Eq. 2.4")
    got = Vector3(*a) @ Vector3(*b)
    expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("B2.8")
def test_the_scalar_product_is_the_lengths_times_the_cosine(rng: Random) -> None:
    angle, first, second = rng.uniform(1.8, 3.0), rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    a = (0.0, first, 0.0)
    b = (second * math.sin(angle), second * math.cos(angle), 0.0)
    wanted = first * second * math.cos(angle)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.dot(w)"
    about.cause = "these enclose an obtuse angle, so the product is negative; all digits are wanted"
    about.read = "book 2.1.7, Eq. 2.4"
    got = Vector3(*a).dot(Vector3(*b))
    expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("B2.8")
@pytest.mark.robust
def test_nan_and_infinity_stay_visible_in_the_scalar_product() -> None:
    w = Vector3(1.0, 1.0, 1.0)
    about("Vector3(nan, 1, 1).dot(Vector3(1, 1, 1))", cause="a NaN must come out as NaN")
    about.read = "the docstring of Vector3"
    expect_nan(Vector3(math.nan, 1.0, 1.0).dot(w))
    about("Vector3(inf, 1, 1).dot(Vector3(1, 1, 1))", cause="an infinity must come out as one")
    got = Vector3(math.inf, 1.0, 1.0).dot(w)
    expect_exactly(got, math.inf)


@pytest.mark.exercise("B2.8", weight=0.5)
@pytest.mark.robust
def test_the_scalar_product_refuses_what_is_no_vector(rng: Random) -> None:
    expect_vectors_only(rng, "v.dot(3.0)", lambda v, other: v.dot(other))
    expect_vectors_only(rng, "v @ 3.0", lambda v, other: v @ other)


# B2.9 The vector product


def vector_product(a: Components, b: Components) -> Components:
    """Return a x b, by its definition."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


@pytest.mark.exercise("B2.9")
def test_x_cross_y_is_z_and_so_on_round() -> None:
    axes = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    about(cause="X x Y = Z, Y x Z = X, Z x X = Y in right-handed axes", read="book 2.1.8, Eq. 2.6")
    products = []
    for i in range(3):
        a, b = axes[i], axes[(i + 1) % 3]
        about.call = f"Vector3{a}.cross(Vector3{b})"
        products.append((about.call, xyz(Vector3(*a).cross(Vector3(*b))), axes[(i + 2) % 3]))
    turned = [got == tuple(-n for n in wanted) for _, got, wanted in products]
    for i, (call, got, wanted) in enumerate(products):
        about.call = call
        if all(turned):
            about.cause = "all three signs are turned round: that is b x a, and -(a x b)"
        elif turned[i]:
            about.cause = f"the two terms of {'zxy'[i]} are the wrong way round, which turns its "
            about.cause += "sign"
        expect_close(got, wanted)


@pytest.mark.exercise("B2.9")
def test_the_vector_product_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.cross(w)"
    about.cause = "a new vector: x is made of y and z, y of z and x, z of x and y"
    about.read = "book 2.1.8, Eq. 2.6"
    wanted = vector_product(a, b)
    # The two terms of a component may cancel, so rounding is measured by the terms.
    expect_close(xyz(v.cross(w)), wanted, tolerance=1e-12)
    expect_unchanged("v", xyz(v), a, cause=UNCHANGED)
    expect_unchanged("w", xyz(w), b, cause=UNCHANGED)


@pytest.mark.exercise("B2.9")
def test_the_vector_product_is_the_lengths_times_the_sine(rng: Random) -> None:
    angle, first, second = rng.uniform(0.2, 3.0), rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    a = (0.0, 0.0, first)
    b = (second * math.sin(angle), 0.0, second * math.cos(angle))
    wanted = (0.0, first * second * math.sin(angle), 0.0)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.cross(w)"
    about.cause = "y is z of v times x of w minus x of v times z of w: z comes before x"
    about.read = "book 2.1.8, Eq. 2.6"
    got = Vector3(*a).cross(Vector3(*b))
    expect_close(xyz(got), wanted, tolerance=1e-12)


@pytest.mark.exercise("B2.9")
def test_the_vector_product_in_place(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; v.cross_update(w)"
    about(cause="v becomes v x w, as cross gives it", read="the docstring of Vector3.cross_update")
    v.cross_update(w)
    wanted = vector_product(a, b)
    x = wanted[0]
    y = a[2] * b[0] - x * b[2]
    mistakes = [
        (a, LOST),
        ((x, y, x * b[1] - y * b[0]), "y was made from the new x: work all three out, then store"),
    ]
    blame(xyz(v), mistakes)
    expect_close(xyz(v), wanted, tolerance=1e-12)
    expect_unchanged("w", xyz(w), b, cause=UNCHANGED)


@pytest.mark.exercise("B2.9")
def test_a_vector_crossed_with_itself_in_place(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; v.cross_update(v)"
    about.cause = "parallel vectors have the product zero, and v is both of them here"
    about.read = "book 2.1.8"
    v.cross_update(v)
    expect_close(xyz(v), (0.0, 0.0, 0.0), tolerance=1e-12)


@pytest.mark.exercise("B2.9")
@pytest.mark.robust
def test_the_vector_product_refuses_what_is_no_vector(rng: Random) -> None:
    expect_vectors_only(rng, "v.cross(3.0)", lambda v, other: v.cross(other))
    expect_vectors_only(rng, "v.cross_update(3.0)", lambda v, other: v.cross_update(other))
