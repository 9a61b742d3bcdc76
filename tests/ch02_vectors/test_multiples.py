"""Vector3: multiples and division by a number, build task B2.3."""

from __future__ import annotations

from random import Random

import pytest

from ch02_vectors.vector import Vector3
from draw import Components, components, number
from expect import (
    about,
    cause_of,
    expect_close,
    expect_error,
    expect_same_object,
    expect_that,
    expect_unchanged,
    xyz,
)

NO_SELF = (
    "Your {} returned nothing, so Python assigned None to v. End the method with return self."
).format


def scaled(a: Components, scale: float) -> Components:
    return a[0] * scale, a[1] * scale, a[2] * scale


@pytest.mark.exercise("B2.3", asks="Both v * scale and scale * v call this method")
def test_a_vector_times_a_number_on_either_side(rng: Random) -> None:
    a, scale = components(rng), number(rng)
    v = Vector3(*a)
    about.cause = "Your result is not the vector times the number. Multiply each component by the "
    about.cause += "number, and return the products as a new vector."
    about.read = "book 2.1.3"
    for factor in (scale, 2):
        wanted = scaled(a, factor)
        if factor == 2:
            about.cause = "Your code fails for 2, which is an int. Accept both an int and a float."
        about.call = f"v = Vector3{a}; v * {factor}"
        got = xyz(v * factor)
        plain = "Your products are right, but you don't return a vector. Pass them to Vector3()."
        added = "You add the number to each component. Multiply each component by it."
        mistakes = [(wanted, plain), (tuple(n + factor for n in a), added)]
        expect_close(got, wanted, cause=cause_of(got, mistakes, about.cause))
        reads = (
            "Your __mul__ changes v, but only v *= may do that. Return a new vector and leave v "
            "unchanged."
        )
        expect_unchanged("v", xyz(v), a, cause=reads)
        about.call = f"v = Vector3{a}; {factor} * v"
        expect_close(xyz(factor * v), wanted)


@pytest.mark.exercise("B2.3", asks="Multiply every component by a number, in place")
def test_times_equals_changes_the_vector_itself(rng: Random) -> None:
    a, scale = components(rng), number(rng)
    v = before = Vector3(*a)
    made, step = f"v = Vector3{a}", f"v *= {scale}"
    about.call = f"{made}; {step}"
    about.cause = (
        "Multiply each component of self by the number. End the method with return self, because "
        "Python assigns its result to v."
    )
    about.read = "book 2.1.3, and the docstring of Vector3.__imul__"
    v *= scale
    same = "v is the same vector as before"
    expect_that(v is not None, "v is None", same, cause=NO_SELF("__imul__"))
    expect_close(xyz(v), scaled(a, scale))
    expect_same_object(made, step, v, before)


@pytest.mark.exercise("B2.3", asks="Divide every component by a number, and return a new vector")
def test_division_by_a_number(rng: Random) -> None:
    a, divisor = components(rng), number(rng)
    v = Vector3(*a)
    w = before = Vector3(*a)
    wanted = (a[0] / divisor, a[1] / divisor, a[2] / divisor)
    mistakes = [
        (
            tuple(n // divisor for n in a),
            "You divide with the operator //, which rounds down to a whole number. Use / instead.",
        ),
        (
            scaled(a, divisor),
            "You multiply by the number. This operator must divide each component by it.",
        ),
    ]
    made, step = f"v = Vector3{a}", f"v /= {divisor}"
    about(
        f"{made}; v / {divisor}",
        cause="Divide each component by the number. Return the quotients as a new vector.",
    )
    about.read = "the docstring of Vector3.__truediv__"
    got = xyz(v / divisor)
    expect_close(got, wanted, cause=cause_of(got, mistakes, about.cause))
    reads = (
        "Your __truediv__ changes v, but only v /= may do that. Return a new vector and leave v "
        "unchanged."
    )
    expect_unchanged("v", xyz(v), a, cause=reads)
    about.call = f"{made}; {step}"
    about.cause = (
        "Divide each component of self by the number. End the method with return self, because "
        "Python assigns its result to v."
    )
    about.read = "the docstring of Vector3.__itruediv__"
    w /= divisor
    same = "v is the same vector as before"
    expect_that(w is not None, "v is None", same, cause=NO_SELF("__itruediv__"))
    got = xyz(w)
    expect_close(got, wanted, cause=cause_of(got, mistakes, about.cause))
    expect_same_object(made, step, w, before)


def divide_in_place(a: Components, divisor: object) -> object:
    v = Vector3(*a)
    v /= divisor
    return v


@pytest.mark.exercise("B2.3", asks="ZeroDivisionError if it is zero")
@pytest.mark.robust
def test_division_by_zero_is_an_error(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about.cause = (
        "You treat a division by zero as a special case. Divide without testing for zero, so that "
        "Python raises the ZeroDivisionError for you."
    )
    about.read = "the docstring of Vector3.__truediv__"
    for call, attempt, allowed in (
        (f"v = Vector3{a}; v / 0.0", lambda: v / 0.0, lambda: v / 2.0),
        (
            f"v = Vector3{a}; v /= 0.0",
            lambda: divide_in_place(a, 0.0),
            lambda: divide_in_place(a, 2.0),
        ),
    ):
        about.call = call
        expect_error(attempt, ZeroDivisionError, allowed=allowed)


@pytest.mark.exercise("B2.3", asks="Raises TypeError if scale is a vector")
@pytest.mark.robust
def test_a_vector_times_a_vector_is_refused(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)

    def times_equals(factor: object) -> object:
        changed = Vector3(*a)
        changed *= factor
        return changed

    asked = "Raise TypeError if the other operand is a Vector3."
    product = (
        "You accept a vector as the factor, but the operator * accepts only numbers, because "
        f"vectors have three different products. {asked}"
    )
    about.read = "the docstring of Vector3.__mul__"
    for call, attempt, allowed, cause in (
        (f"Vector3{a} * Vector3{b}", lambda: v * w, lambda: v * 2.0, product),
        (
            f"v = Vector3{a}; v *= Vector3{b}",
            lambda: times_equals(w),
            lambda: times_equals(2.0),
            product,
        ),
        (
            f"Vector3{a} / Vector3{b}",
            lambda: v / w,
            lambda: v / 2.0,
            "You accept a vector as the divisor, but a vector cannot be divided by a vector. "
            f"{asked}",
        ),
    ):
        about(call, cause=cause)
        expect_error(attempt, TypeError, allowed=allowed)
