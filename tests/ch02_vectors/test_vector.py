"""The parts of Vector3, build tasks B2.1 to B2.9."""

from __future__ import annotations

import math
from collections.abc import Callable
from random import Random
from typing import Any

import pytest

from ch02_vectors.probes import keeps_its_object, walk
from ch02_vectors.vector import Vector3
from draw import Components, components, number
from expect import expect_close, expect_error, expect_exactly, expect_nan, expect_unchanged, xyz

HUGE, TINY = 1e200, 1e-200  # their squares are infinity and zero in a float
ZERO = (0.0, 0.0, 0.0)


def whole_length(rng: Random) -> tuple[Components, float]:
    """Draw whole components whose length is whole too, by the formula of Lebesgue."""
    m, n, p, q = (rng.randint(1, 6) for _ in range(4))
    x, y, z = m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p)
    return (float(x), float(y), float(z)), float(m * m + n * n + p * p + q * q)


def scaled(a: Components, scale: float) -> Components:
    return a[0] * scale, a[1] * scale, a[2] * scale


def expect_vectors_only(
    rng: Random, expression: str, attempt: Callable[[Any, Any], object]
) -> None:
    """Expect a method, or an operator, to take a vector and to refuse a number."""
    a, b = components(rng), components(rng)
    call = f"v = Vector3{a}; {expression}"
    cause = "ask isinstance(v, Vector3) first, and raise TypeError where it is not"
    read = "the docstring of the method"
    expect_error(
        call,
        lambda: attempt(Vector3(*a), 3.0),
        TypeError,
        allowed=lambda: attempt(Vector3(*a), Vector3(*b)),
        cause=cause,
        read=read,
    )


# B2.1 Copy, clear and invert


@pytest.mark.exercise("B2.1")
def test_a_copy_has_the_components_and_a_life_of_its_own(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    call = f"v = Vector3{a}; v.copy()"
    cause = "a new Vector3 is wanted, with the same three components"
    read = "the docstring of Vector3.copy"
    copied = v.copy()
    expect_close(call, xyz(copied), a, cause=cause, read=read)
    copied.x = 99.0
    expect_unchanged(f"v = Vector3{a}; w = v.copy(); w.x = 99", "v", xyz(v), a, read=read)


@pytest.mark.exercise("B2.1")
def test_clear_leaves_zero(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    call = f"v = Vector3{a}; v.clear()"
    cause = "all three components of v itself become zero; a new vector would be lost"
    read = "the docstring of Vector3.clear"
    v.clear()
    expect_close(call, xyz(v), ZERO, cause=cause, read=read)


@pytest.mark.exercise("B2.1")
def test_invert_changes_the_sign_of_every_component(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    call = f"v = Vector3{a}; v.invert()"
    cause = "x from x, y from y, z from z, in v itself; the book's listing sets x from z (E-14)"
    read = "book 2.1, and errata.md"
    v.invert()
    expect_close(call, xyz(v), scaled(a, -1.0), cause=cause, read=read)


@pytest.mark.exercise("B2.1")
def test_minus_v_is_a_new_vector_turned_round(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    call = f"v = Vector3{a}; -v"
    cause = "a new vector with all three signs changed"
    read = "the docstring of Vector3.__neg__"
    expect_close(call, xyz(-v), scaled(a, -1.0), cause=cause, read=read)
    expect_unchanged(call, "v", xyz(v), a, read=read)


# B2.2 Length


@pytest.mark.exercise("B2.2")
def test_magnitude_is_the_length(rng: Random) -> None:
    a, length = whole_length(rng)
    call = f"Vector3{a}.magnitude()"
    cause = "the root of the sum of the three squared components"
    read = "book 2.1"
    expect_close(call, Vector3(*a).magnitude(), length, cause=cause, read=read)


@pytest.mark.exercise("B2.2")
def test_squared_magnitude_is_the_length_squared(rng: Random) -> None:
    a, length = whole_length(rng)
    call = f"Vector3{a}.squared_magnitude()"
    cause = "the sum of the three squares, without the root"
    read = "book 2.1"
    expect_close(call, Vector3(*a).squared_magnitude(), length**2, cause=cause, read=read)


@pytest.mark.exercise("B2.2")
def test_magnitude_of_huge_and_tiny_components(rng: Random) -> None:
    a, length = whole_length(rng)
    cause = "a square leaves the range of a float; math.hypot finds the length without it"
    read = "the docstring of Vector3.magnitude"
    for scale in (HUGE, TINY):
        b = scaled(a, scale)
        call = f"Vector3{b}.magnitude()"
        expect_close(call, Vector3(*b).magnitude(), length * scale, cause=cause, read=read)


@pytest.mark.exercise("B2.2")
def test_length_of_zero_and_of_nan() -> None:
    call = "Vector3(0, 0, 0).magnitude()"
    cause = "zero is a vector like any other, of length zero"
    read = "the docstrings of Vector3 and Vector3.magnitude"
    expect_close(call, Vector3(0.0, 0.0, 0.0).magnitude(), 0.0, cause=cause, read=read)
    lost = Vector3(1.0, math.nan, 2.0)
    call = "Vector3(1, nan, 2).magnitude()"
    cause = "a NaN must stay visible: no max or min, and no test that it slips through"
    expect_nan(call, lost.magnitude(), cause=cause, read=read)
    call = "Vector3(1, nan, 2).squared_magnitude()"
    expect_nan(call, lost.squared_magnitude(), cause=cause, read=read)


# B2.3 Multiply and divide by a number


@pytest.mark.exercise("B2.3")
def test_a_vector_times_a_number_on_either_side(rng: Random) -> None:
    a, scale = components(rng), number(rng)
    v = Vector3(*a)
    cause = "a new vector, each component multiplied once, by any number: 2 as well as 2.0"
    read = "book 2.1.3"
    for factor in (scale, 2):
        wanted = scaled(a, factor)
        call = f"v = Vector3{a}; v * {factor}"
        expect_close(call, xyz(v * factor), wanted, cause=cause, read=read)
        expect_unchanged(call, "v", xyz(v), a, read=read)
        call = f"v = Vector3{a}; {factor} * v"
        expect_close(call, xyz(factor * v), wanted, cause=cause, read=read)


@pytest.mark.exercise("B2.3")
def test_times_equals_changes_the_vector_itself(rng: Random) -> None:
    a, scale = components(rng), number(rng)
    v = Vector3(*a)
    call = f"v = Vector3{a}; v *= {scale}"
    cause = "each component is multiplied in self, and the method ends with return self"
    read = "book 2.1.3, and the docstring of Vector3.__imul__"
    v *= scale
    expect_close(call, xyz(v), scaled(a, scale), cause=cause, read=read)
    same = keeps_its_object("*=", a, a, scale)
    expect_exactly(f"{call}; is v still the same object?", same, True, cause=cause, read=read)


@pytest.mark.exercise("B2.3")
def test_division_by_a_number(rng: Random) -> None:
    a, divisor = components(rng), number(rng)
    v, w = Vector3(*a), Vector3(*a)
    wanted = (a[0] / divisor, a[1] / divisor, a[2] / divisor)
    call = f"v = Vector3{a}; v / {divisor}"
    cause = "a new vector, each component divided once"
    read = "the docstring of Vector3.__truediv__"
    expect_close(call, xyz(v / divisor), wanted, cause=cause, read=read)
    expect_unchanged(call, "v", xyz(v), a, read=read)
    call = f"v = Vector3{a}; v /= {divisor}"
    cause = "each component is divided in self, and the method ends with return self"
    read = "the docstring of Vector3.__itruediv__"
    w /= divisor
    expect_close(call, xyz(w), wanted, cause=cause, read=read)
    same = keeps_its_object("/=", a, a, divisor)
    expect_exactly(f"{call}; is v still the same object?", same, True, cause=cause, read=read)


def divide_in_place(a: Components, divisor: object) -> object:
    v = Vector3(*a)
    v /= divisor
    return v


@pytest.mark.exercise("B2.3")
def test_division_by_zero_is_an_error(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    cause = "let Python's own ZeroDivisionError through"
    read = "the docstring of Vector3.__truediv__"
    for call, attempt, allowed in (
        (f"v = Vector3{a}; v / 0.0", lambda: v / 0.0, lambda: v / 2.0),
        (
            f"v = Vector3{a}; v /= 0.0",
            lambda: divide_in_place(a, 0.0),
            lambda: divide_in_place(a, 2.0),
        ),
    ):
        expect_error(call, attempt, ZeroDivisionError, allowed=allowed, cause=cause, read=read)


@pytest.mark.exercise("B2.3")
def test_a_vector_times_a_vector_is_refused(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)

    def times_equals(factor: object) -> object:
        changed = Vector3(*a)
        changed *= factor
        return changed

    cause = "a product could mean three things, and nothing divides by a vector: TypeError"
    read = "the docstring of Vector3.__mul__"
    for call, attempt, allowed in (
        (f"Vector3{a} * Vector3{b}", lambda: v * w, lambda: v * 2.0),
        (f"v = Vector3{a}; v *= Vector3{b}", lambda: times_equals(w), lambda: times_equals(2.0)),
        (f"Vector3{a} / Vector3{b}", lambda: v / w, lambda: v / 2.0),
    ):
        expect_error(call, attempt, TypeError, allowed=allowed, cause=cause, read=read)


# B2.4 Normalise


@pytest.mark.exercise("B2.4")
def test_normalize_keeps_the_direction_and_makes_the_length_one(rng: Random) -> None:
    a, length = whole_length(rng)
    v = Vector3(*a)
    call = f"v = Vector3{a}; v.normalize()"
    cause = (
        "v itself changes: all three components are divided by the length, which is worked out "
        "once, before the first of them changes"
    )
    read = "book 2.1.3"
    v.normalize()
    expect_close(call, xyz(v), scaled(a, 1.0 / length), cause=cause, read=read)


@pytest.mark.exercise("B2.4")
def test_normalized_is_a_new_unit_vector(rng: Random) -> None:
    a, length = whole_length(rng)
    v = Vector3(*a)
    call = f"v = Vector3{a}; v.normalized()"
    cause = "a new vector, each component divided by the length"
    read = "the docstring of Vector3.normalized"
    expect_close(call, xyz(v.normalized()), scaled(a, 1.0 / length), cause=cause, read=read)
    expect_unchanged(call, "v", xyz(v), a, read=read)


@pytest.mark.exercise("B2.4")
def test_the_zero_vector_stays_zero() -> None:
    v = Vector3(0.0, 0.0, 0.0)
    call = "v = Vector3(0, 0, 0); v.normalized()"
    cause = "zero has no direction: see to it before dividing by its length"
    read = "book 2.1.3"
    expect_close(call, xyz(v.normalized()), ZERO, cause=cause, read=read)
    call = "v = Vector3(0, 0, 0); v.normalize()"
    v.normalize()
    expect_close(call, xyz(v), ZERO, cause=cause, read=read)


@pytest.mark.exercise("B2.4")
def test_normalize_huge_and_tiny_vectors(rng: Random) -> None:
    a, length = whole_length(rng)
    cause = "the length, or one divided by it, left the range of a float: see magnitude"
    read = "the docstring of Vector3.normalize"
    for scale in (HUGE, TINY):
        b = scaled(a, scale)
        v = Vector3(*b)
        call = f"v = Vector3{b}; v.normalize()"
        v.normalize()
        expect_close(call, xyz(v), scaled(a, 1.0 / length), cause=cause, read=read)


# B2.5 Add and subtract


@pytest.mark.exercise("B2.5")
def test_the_sum_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] + b[0], a[1] + b[1], a[2] + b[2])
    call = f"v, w = Vector3{a}, Vector3{b}; v + w"
    cause = "a new vector: x with x, y with y, z with z"
    read = "book 2.1.4"
    expect_close(call, xyz(v + w), wanted, cause=cause, read=read)
    expect_unchanged(call, "v", xyz(v), a, read=read)
    expect_unchanged(call, "w", xyz(w), b, read=read)


@pytest.mark.exercise("B2.5")
def test_the_difference_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] - b[0], a[1] - b[1], a[2] - b[2])
    call = f"v, w = Vector3{a}, Vector3{b}; v - w"
    cause = "a new vector: the first minus the second, component by component"
    read = "book 2.1.4"
    expect_close(call, xyz(v - w), wanted, cause=cause, read=read, tolerance=1e-14)
    expect_unchanged(call, "v", xyz(v), a, read=read)
    expect_unchanged(call, "w", xyz(w), b, read=read)


@pytest.mark.exercise("B2.5")
@pytest.mark.parametrize(("operator", "sign"), [("+=", 1.0), ("-=", -1.0)], ids=["plus", "minus"])
def test_plus_and_minus_equals_change_the_vector_itself(
    rng: Random, operator: str, sign: float
) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2])
    call = f"v, w = Vector3{a}, Vector3{b}; v {operator} w"
    cause = "self changes, component by component, and the method ends with return self"
    read = "book 2.1.4"
    if operator == "+=":
        v += w
    else:
        v -= w
    expect_close(call, xyz(v), wanted, cause=cause, read=read, tolerance=1e-14)
    expect_unchanged(call, "w", xyz(w), b, read=read)
    same = keeps_its_object(operator, a, b, 1.0)
    expect_exactly(f"{call}; is v still the same object?", same, True, cause=cause, read=read)


@pytest.mark.exercise("B2.5")
def test_a_vector_minus_itself_in_place(rng: Random) -> None:
    a = components(rng)
    v, w = Vector3(*a), Vector3(*a)
    cause = "the argument is v itself: do not change it before you have read it"
    read = "book 2.1.4"
    call = f"v = Vector3{a}; v -= v"
    v -= v
    expect_close(call, xyz(v), ZERO, cause=cause, read=read)
    call = f"v = Vector3{a}; v += v"
    w += w
    expect_close(call, xyz(w), scaled(a, 2.0), cause=cause, read=read)


@pytest.mark.exercise("B2.5")
def test_a_vector_plus_a_number_is_refused(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    cause = "return NotImplemented where the other is no Vector3, and Python raises TypeError"
    read = "the docstring of Vector3.__add__"
    for call, attempt, allowed in (
        (f"Vector3{a} + 1.0", lambda: v + 1.0, lambda: v + v),
        (f"Vector3{a} - 1.0", lambda: v - 1.0, lambda: v - v),
    ):
        expect_error(call, attempt, TypeError, allowed=allowed, cause=cause, read=read)


# B2.6 Add a scaled vector


@pytest.mark.exercise("B2.6")
def test_add_scaled_changes_the_vector_itself(rng: Random) -> None:
    a, b, scale = components(rng), components(rng), number(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] + b[0] * scale, a[1] + b[1] * scale, a[2] + b[2] * scale)
    call = f"v, w = Vector3{a}, Vector3{b}; v.add_scaled(w, {scale})"
    cause = "v itself grows by w times the number; w stays as it is"
    read = "book 2.1.4"
    v.add_scaled(w, scale)
    # Rounding of numbers up to 100.
    expect_close(call, xyz(v), wanted, cause=cause, read=read, tolerance=1e-12)
    expect_unchanged(call, "w", xyz(w), b, read=read)


@pytest.mark.exercise("B2.6")
def test_add_scaled_with_itself(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    call = f"v = Vector3{a}; v.add_scaled(v, 2)"
    cause = "the argument is v itself: do not change it before you have read it"
    read = "the docstring of Vector3.add_scaled"
    v.add_scaled(v, 2.0)
    expect_close(call, xyz(v), scaled(a, 3.0), cause=cause, read=read)


@pytest.mark.exercise("B2.6")
def test_add_scaled_frame_after_frame(rng: Random) -> None:
    start, velocity = components(rng), components(rng)
    wanted = tuple(p + 10.0 * v for p, v in zip(start, velocity, strict=True))
    call = f"p, v = Vector3{start}, Vector3{velocity}; 600 times p.add_scaled(v, 1 / 60)"
    cause = "600 frames of 1/60 s are 10 s: p' = p + v h in each"
    read = "book 2.2, Eq. 2.7"
    got = walk(start, velocity, 1.0 / 60.0, 600)
    # 600 roundings of numbers up to 100.
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-10)


@pytest.mark.exercise("B2.6", weight=0.5)
def test_add_scaled_refuses_what_is_no_vector(rng: Random) -> None:
    expect_vectors_only(rng, "v.add_scaled(3.0, 2.0)", lambda v, other: v.add_scaled(other, 2.0))


# B2.7 The component product


@pytest.mark.exercise("B2.7")
def test_the_component_product_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] * b[0], a[1] * b[1], a[2] * b[2])
    call = f"v, w = Vector3{a}, Vector3{b}; v.component_product(w)"
    cause = "a new vector: x times x, y times y, z times z, and nothing added up"
    read = "book 2.1.6"
    expect_close(call, xyz(v.component_product(w)), wanted, cause=cause, read=read)
    expect_unchanged(call, "v", xyz(v), a, read=read)
    expect_unchanged(call, "w", xyz(w), b, read=read)


@pytest.mark.exercise("B2.7")
def test_the_component_product_in_place(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] * b[0], a[1] * b[1], a[2] * b[2])
    call = f"v, w = Vector3{a}, Vector3{b}; v.component_product_update(w)"
    cause = "the three products are stored in v itself"
    read = "book 2.1.6"
    v.component_product_update(w)
    expect_close(call, xyz(v), wanted, cause=cause, read=read)
    expect_unchanged(call, "w", xyz(w), b, read=read)


@pytest.mark.exercise("B2.7")
def test_the_component_product_with_itself(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    wanted = (a[0] * a[0], a[1] * a[1], a[2] * a[2])
    call = f"v = Vector3{a}; v.component_product_update(v)"
    cause = "the argument is v itself: do not change it before you have read it"
    read = "book 2.1.6"
    v.component_product_update(v)
    expect_close(call, xyz(v), wanted, cause=cause, read=read)


@pytest.mark.exercise("B2.7", weight=0.5)
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
    wanted = math.fsum(p * q for p, q in zip(a, b, strict=True))
    call = f"v, w = Vector3{a}, Vector3{b}; v.dot(w)"
    cause = "a number: the three products of components, added up"
    read = "book 2.1.7, Eq. 2.4"
    # The terms may cancel, so rounding is measured by the terms: at most 100 each.
    expect_close(call, v.dot(w), wanted, cause=cause, read=read, tolerance=1e-12)
    expect_unchanged(call, "v", xyz(v), a, read=read)
    expect_unchanged(call, "w", xyz(w), b, read=read)


@pytest.mark.exercise("B2.8")
def test_the_at_sign_is_the_scalar_product(rng: Random) -> None:
    a, b = components(rng), components(rng)
    wanted = math.fsum(p * q for p, q in zip(a, b, strict=True))
    call = f"v, w = Vector3{a}, Vector3{b}; v @ w"
    cause = "__matmul__ gives what dot gives"
    read = "book 2.1.7, Eq. 2.4"
    got = Vector3(*a) @ Vector3(*b)
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-12)


@pytest.mark.exercise("B2.8")
def test_the_scalar_product_is_the_lengths_times_the_cosine(rng: Random) -> None:
    angle, first, second = rng.uniform(1.8, 3.0), rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    a = (0.0, first, 0.0)
    b = (second * math.sin(angle), second * math.cos(angle), 0.0)
    wanted = first * second * math.cos(angle)
    call = f"v, w = Vector3{a}, Vector3{b}; v.dot(w)"
    cause = "these enclose an obtuse angle, so the product is negative; all digits are wanted"
    read = "book 2.1.7, Eq. 2.4"
    got = Vector3(*a).dot(Vector3(*b))
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-12)


@pytest.mark.exercise("B2.8")
def test_nan_and_infinity_stay_visible_in_the_scalar_product() -> None:
    w = Vector3(1.0, 1.0, 1.0)
    call = "Vector3(nan, 1, 1).dot(Vector3(1, 1, 1))"
    cause = "a NaN must come out as NaN"
    read = "the docstring of Vector3"
    expect_nan(call, Vector3(math.nan, 1.0, 1.0).dot(w), cause=cause, read=read)
    call = "Vector3(inf, 1, 1).dot(Vector3(1, 1, 1))"
    cause = "an infinity must come out as one"
    got = Vector3(math.inf, 1.0, 1.0).dot(w)
    expect_exactly(call, got, math.inf, cause=cause, read=read)


@pytest.mark.exercise("B2.8", weight=0.5)
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
    cause = "X x Y = Z, Y x Z = X, Z x X = Y in right-handed axes: look for a sign, or a b x a"
    read = "book 2.1.8, Eq. 2.6"
    for i in range(3):
        a, b, c = axes[i], axes[(i + 1) % 3], axes[(i + 2) % 3]
        call = f"Vector3{a}.cross(Vector3{b})"
        got = Vector3(*a).cross(Vector3(*b))
        expect_close(call, xyz(got), c, cause=cause, read=read)


@pytest.mark.exercise("B2.9")
def test_the_vector_product_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    call = f"v, w = Vector3{a}, Vector3{b}; v.cross(w)"
    cause = "a new vector: x is made of y and z, y of z and x, z of x and y"
    read = "book 2.1.8, Eq. 2.6"
    wanted = vector_product(a, b)
    # The two terms of a component may cancel, so rounding is measured by the terms.
    expect_close(call, xyz(v.cross(w)), wanted, cause=cause, read=read, tolerance=1e-12)
    expect_unchanged(call, "v", xyz(v), a, read=read)
    expect_unchanged(call, "w", xyz(w), b, read=read)


@pytest.mark.exercise("B2.9")
def test_the_vector_product_is_the_lengths_times_the_sine(rng: Random) -> None:
    angle, first, second = rng.uniform(0.2, 3.0), rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    a = (0.0, 0.0, first)
    b = (second * math.sin(angle), 0.0, second * math.cos(angle))
    wanted = (0.0, first * second * math.sin(angle), 0.0)
    call = f"v, w = Vector3{a}, Vector3{b}; v.cross(w)"
    cause = "y is z of v times x of w minus x of v times z of w: z comes before x"
    read = "book 2.1.8, Eq. 2.6"
    got = Vector3(*a).cross(Vector3(*b))
    expect_close(call, xyz(got), wanted, cause=cause, read=read, tolerance=1e-12)


@pytest.mark.exercise("B2.9")
def test_the_vector_product_in_place(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    call = f"v, w = Vector3{a}, Vector3{b}; v.cross_update(w)"
    cause = "v becomes v x w: work all three components out before you store the first"
    read = "the docstring of Vector3.cross_update"
    v.cross_update(w)
    wanted = vector_product(a, b)
    expect_close(call, xyz(v), wanted, cause=cause, read=read, tolerance=1e-12)
    expect_unchanged(call, "w", xyz(w), b, read=read)


@pytest.mark.exercise("B2.9")
def test_a_vector_crossed_with_itself_in_place(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    call = f"v = Vector3{a}; v.cross_update(v)"
    cause = "parallel vectors have the product zero, and v is both of them here"
    read = "book 2.1.8"
    v.cross_update(v)
    expect_close(call, xyz(v), ZERO, cause=cause, read=read, tolerance=1e-12)


@pytest.mark.exercise("B2.9", weight=0.5)
def test_the_vector_product_refuses_what_is_no_vector(rng: Random) -> None:
    expect_vectors_only(rng, "v.cross(3.0)", lambda v, other: v.cross(other))
    expect_vectors_only(rng, "v.cross_update(3.0)", lambda v, other: v.cross_update(other))
