"""Vector3: sums and differences, build task B2.5."""

from __future__ import annotations

from random import Random

import pytest

from ch02_vectors.vector import Vector3
from draw import components
from expect import (
    cause_of,
    expect_close,
    expect_error,
    expect_same_object,
    expect_unchanged,
    xyz,
)

ZERO = (0.0, 0.0, 0.0)


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
    cause = "v + w makes a new vector and only reads both; v += w is the one that changes v"
    expect_unchanged(call, "v", xyz(v), a, cause=cause, read=read)
    expect_unchanged(call, "w", xyz(w), b, cause=cause, read=read)


@pytest.mark.exercise("B2.5")
def test_the_difference_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] - b[0], a[1] - b[1], a[2] - b[2])
    call = f"v, w = Vector3{a}, Vector3{b}; v - w"
    cause = "a new vector: the first minus the second, component by component"
    read = "book 2.1.4"
    got = xyz(v - w)
    mistakes = [
        (tuple(-n for n in wanted), "that is w - v: the other way round"),
        ((a[0] + b[0], a[1] + b[1], a[2] + b[2]), "that is v + w"),
    ]
    cause = cause_of(got, mistakes, cause)
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-14)
    cause = "v - w makes a new vector and only reads both; v -= w is the one that changes v"
    expect_unchanged(call, "v", xyz(v), a, cause=cause, read=read)
    expect_unchanged(call, "w", xyz(w), b, cause=cause, read=read)


@pytest.mark.exercise("B2.5")
@pytest.mark.parametrize(("operator", "sign"), [("+=", 1.0), ("-=", -1.0)], ids=["plus", "minus"])
def test_plus_and_minus_equals_change_the_vector_itself(
    rng: Random, operator: str, sign: float
) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    before = v
    wanted = (a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2])
    made, step = f"v, other = Vector3{a}, Vector3{b}", f"v {operator} other"
    call = f"{made}; {step}"
    cause = "self changes, component by component; what the method returns becomes v: return self"
    read = "book 2.1.4"
    if operator == "+=":
        v += w
    else:
        v -= w
    opposite = (a[0] - sign * b[0], a[1] - sign * b[1], a[2] - sign * b[2])
    mistakes = [(opposite, f"that is v {'-' if sign > 0.0 else '+'} other")]
    cause = cause_of(xyz(v), mistakes, cause)
    expect_close(call, xyz(v), wanted, cause=cause, read=read, tolerance=1e-14)
    cause = "the other vector is only read: it is self that changes"
    expect_unchanged(call, "other", xyz(w), b, cause=cause, read=read)
    expect_same_object(made, step, v, before, read=read)


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
    expect_close(call, xyz(w), tuple(2.0 * n for n in a), cause=cause, read=read)


@pytest.mark.exercise("B2.5")
@pytest.mark.robust
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
