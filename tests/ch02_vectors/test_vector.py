"""Vector3: copies, length, sums and multiples, build tasks B2.1 to B2.5."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from draw import Components, components, number
from expect import expect_close, expect_error, expect_nan, expect_unchanged, xyz

HUGE, TINY = 1e200, 1e-200  # their squares are infinity and zero in a float
ZERO = (0.0, 0.0, 0.0)


def whole_length(rng: Random) -> tuple[Components, float]:
    """Draw whole components whose length is whole too, by the formula of Lebesgue."""
    m, n, p, q = (rng.randint(1, 6) for _ in range(4))
    x, y, z = m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p)
    return (float(x), float(y), float(z)), float(m * m + n * n + p * p + q * q)


def scaled(a: Components, scale: float) -> Components:
    return a[0] * scale, a[1] * scale, a[2] * scale


def expect_same_object(call: str, v: Any, before: Any, *, cause: str, read: str) -> None:
    """Expect v to be the object that it was before, by what can be seen: they change together."""
    before.x = 99.0
    call = f"{call}; is v still the same object? w = v before it; w.x = 99.0 after it; v.x"
    expect_close(call, v.x, 99.0, cause=cause, read=read)


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
    v = before = Vector3(*a)
    call = f"v = Vector3{a}; v *= {scale}"
    cause = "each component is multiplied in self, and the method ends with return self"
    read = "book 2.1.3, and the docstring of Vector3.__imul__"
    v *= scale
    expect_close(call, xyz(v), scaled(a, scale), cause=cause, read=read)
    expect_same_object(call, v, before, cause=cause, read=read)


@pytest.mark.exercise("B2.3")
def test_division_by_a_number(rng: Random) -> None:
    a, divisor = components(rng), number(rng)
    v = Vector3(*a)
    w = before = Vector3(*a)
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
    expect_same_object(call, w, before, cause=cause, read=read)


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
    before = v
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
    expect_same_object(call, v, before, cause=cause, read=read)


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
