"""Vector3: multiples and sums, build tasks B2.3, B2.5 and B2.6."""

from __future__ import annotations

from operator import iadd, imul, isub, itruediv, mul, truediv
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.probes import walk
from ch02_vectors.vector import Vector3
from draw import Triple, number, vector
from expect import (
    LOST,
    UNCHANGED,
    about,
    expect_close,
    expect_error,
    expect_same_object,
    expect_that,
    expect_unchanged,
    xyz,
)

TIMES = "book 2.1.3"
IMUL = "book 2.1.3, and the docstring of Vector3.__imul__"
DIVIDE = "the docstring of Vector3.__truediv__"
MULTIPLY, ADD = "the docstring of Vector3.__mul__", "the docstring of Vector3.add_scaled"
CHANGES = "Your {} changes v, but only {} may do that. Return a new vector and leave v unchanged."
SELF_TWICE = (
    "Here self and the argument are the same vector, v, so each change to self also changes the "
    "argument. Read each component before you change it."
)
RETURN_SELF = "End the method with return self, because Python assigns its result to v."
NO_VECTOR = "Your {} are right, but you don't return a vector. Pass them to Vector3()."


def expect_in_place(
    method: str,
    v: Any,
    before: Any,
    wanted: Triple,
    slips: dict[str, Any] | None = None,
    tolerance: float | None = None,
) -> None:
    """Expect that an operator such as *= has changed v itself, and that v is not None."""
    __tracebackhide__ = True
    nothing = f"Your {method} returned nothing, so Python assigned None to v. {RETURN_SELF}"
    expect_that(v is not None, "v is None", "v is the same vector as before", cause=nothing)
    expect_close(xyz(v), wanted, slips, then="; v", tolerance=tolerance)
    made, step = about.call.split("; ")
    expect_same_object(made, step, v, before)


# B2.3 Multiples


@pytest.mark.exercise("B2.3", asks="Both v * scale and scale * v call this method", read=TIMES)
def test_a_vector_times_a_number_on_either_side(rng: Random) -> None:
    a, scale = vector(rng), number(rng)
    wrong = (
        "Your result is not the vector times the number. Multiply each component by the number, "
        "and return the products as a new vector."
    )
    whole = "Your code fails for 2, which is an int. Accept both an int and a float."
    for factor, cause in ((scale, wrong), (2, whole)):
        with calls(cause):
            v = Vector3(*a)
            got = v * factor
        slips = {
            NO_VECTOR.format("products"): a * factor,
            "You add the number to each component. Multiply each component by it.":
                [n + factor for n in a],
        }  # fmt: skip
        expect_close(xyz(got), a * factor, slips)
        expect_unchanged("v", v, a, cause=CHANGES.format("__mul__", "v *="))
        with calls(cause):
            got = factor * Vector3(*a)
        expect_close(xyz(got), a * factor)


@pytest.mark.exercise("B2.3", asks="Multiply every component by a number, in place", read=IMUL)
def test_times_equals_changes_the_vector_itself(rng: Random) -> None:
    a, scale = vector(rng), number(rng)
    with calls(f"Multiply each component of self by the number. {RETURN_SELF}"):
        v = before = Vector3(*a)
        v *= scale
    expect_in_place("__imul__", v, before, a * scale)


@pytest.mark.exercise(
    "B2.3", asks="Divide every component by a number, and return a new vector", read=DIVIDE
)
def test_division_by_a_number(rng: Random) -> None:
    a, divisor = vector(rng), number(rng)
    slips = {
        "You divide with the operator //, which rounds down to a whole number. Use / instead.":
            Triple(n // divisor for n in a),
        "You multiply by the number. This operator must divide each component by it.": a * divisor,
    }  # fmt: skip
    with calls("Divide each component by the number. Return the quotients as a new vector."):
        v = Vector3(*a)
        got = v / divisor
    expect_close(xyz(got), a / divisor, slips)
    expect_unchanged("v", v, a, cause=CHANGES.format("__truediv__", "v /="))
    with calls(f"Divide each component of self by the number. {RETURN_SELF}"):
        v = before = Vector3(*a)
        v /= divisor
    expect_in_place("__itruediv__", v, before, a / divisor, slips)


@pytest.mark.exercise("B2.3", asks="ZeroDivisionError if it is zero", read=DIVIDE)
@pytest.mark.robust
def test_division_by_zero_is_an_error(rng: Random) -> None:
    a = vector(rng)
    cause = (
        "You treat a division by zero as a special case. Divide without testing for zero, so that "
        "Python raises the ZeroDivisionError for you."
    )
    for sign, divide in (("/", truediv), ("/=", itruediv)):
        expect_error(
            lambda divide=divide: divide(Vector3(*a), 0.0),
            ZeroDivisionError,
            allowed=lambda divide=divide: divide(Vector3(*a), 2.0),
            call=f"v = Vector3{a}; v {sign} 0.0",
            cause=cause,
        )


@pytest.mark.exercise("B2.3", asks="Raises TypeError if scale is a vector", read=MULTIPLY)
@pytest.mark.robust
def test_a_vector_times_a_vector_is_refused(rng: Random) -> None:
    a, b = vector(rng), vector(rng)
    asked = "Raise TypeError if the other operand is a Vector3."
    factor = (
        "You accept a vector as the factor, but the operator * accepts only numbers, because "
        f"vectors have three different products. {asked}"
    )
    divisor = "You accept a vector as the divisor, but a vector cannot be divided by a vector."
    for sign, combine, cause in (
        ("*", mul, factor),
        ("*=", imul, factor),
        ("/", truediv, f"{divisor} {asked}"),
    ):
        expect_error(
            lambda combine=combine: combine(Vector3(*a), Vector3(*b)),
            TypeError,
            allowed=lambda combine=combine: combine(Vector3(*a), 2.0),
            call=f"v = Vector3{a}; v {sign} Vector3{b}",
            cause=cause,
        )


# B2.5 Add and subtract


@pytest.mark.exercise("B2.5", asks="return their sum as a new vector", read="book 2.1.4")
def test_the_sum_is_a_new_vector(rng: Random) -> None:
    a, b = vector(rng), vector(rng)
    with calls(
        "Vectors are added component by component. Return a new vector with the components v.x + "
        "w.x, v.y + w.y and v.z + w.z."
    ):
        v, w = Vector3(*a), Vector3(*b)
        got = v + w
    expect_close(xyz(got), a + b, {NO_VECTOR.format("sums"): a + b})
    expect_unchanged("v", v, a, cause=CHANGES.format("__add__", "v +="))
    expect_unchanged("w", w, b, cause=UNCHANGED)


@pytest.mark.exercise("B2.5", asks="return the difference as a new vector", read="book 2.1.4")
def test_the_difference_is_a_new_vector(rng: Random) -> None:
    a, b = vector(rng), vector(rng)
    with calls(
        "Vectors are subtracted component by component. Return a new vector with the components "
        "v.x - w.x, v.y - w.y and v.z - w.z."
    ):
        v, w = Vector3(*a), Vector3(*b)
        got = v - w
    slips = {
        "You swap the operands, so the result is w - v.": b - a,
        "The result is v + w.": a + b,
    }
    expect_close(xyz(got), a - b, slips, tolerance=1e-14)
    expect_unchanged("v", v, a, cause=CHANGES.format("__sub__", "v -="))
    expect_unchanged("w", w, b, cause=UNCHANGED)


@pytest.mark.exercise("B2.5", asks="their methods must end with return self", read="book 2.1.4")
@pytest.mark.parametrize(("operator", "sign"), [("+=", 1.0), ("-=", -1.0)], ids=["plus", "minus"])
def test_plus_and_minus_equals_change_the_vector_itself(
    rng: Random, operator: str, sign: float
) -> None:
    a, b = vector(rng), vector(rng)
    method, change, opposite = ("__iadd__", iadd, "-") if sign > 0.0 else ("__isub__", isub, "+")
    with calls(
        f"Change the components of self. {RETURN_SELF}",
        f"v, other = Vector3{a}, Vector3{b}; v {operator} other",
    ):
        v, other = Vector3(*a), Vector3(*b)
        before, v = v, change(v, other)
    expect_unchanged(
        "other",
        other,
        b,
        cause="Your method changes the other vector too, but it must change only self. Read the "
        "components of the other vector without assigning to them.",
    )
    wrong_sign = (
        f"You compute v {opposite} other, although the operator is {operator}. Compute v "
        f"{operator[0]} other for each component."
    )
    expect_in_place(method, v, before, a + sign * b, {wrong_sign: a - sign * b}, 1e-14)


@pytest.mark.exercise("B2.5", asks="if the other vector is the vector itself", read="book 2.1.4")
def test_a_vector_minus_itself_in_place(rng: Random) -> None:
    a = vector(rng)
    with calls(SELF_TWICE):
        v = Vector3(*a)
        v -= v
    expect_close(xyz(v), (0.0, 0.0, 0.0), then="; v")
    with calls(SELF_TWICE):
        v = Vector3(*a)
        v += v
    expect_close(xyz(v), 2.0 * a, then="; v")


# B2.6 Add a scaled vector


@pytest.mark.exercise("B2.6", asks="to this vector, in place", read="book 2.1.4")
def test_add_scaled_changes_the_vector_itself(rng: Random) -> None:
    a, b, scale = vector(rng), vector(rng), number(rng)
    with calls("Multiply only w by the number, and add the product to v itself."):
        v, w = Vector3(*a), Vector3(*b)
        v.add_scaled(w, scale)
    slips = {
        LOST: a,
        "You multiply the wrong vector by the number: v instead of w.": a * scale + b,
        "You multiply the whole sum v + w by the number.": (a + b) * scale,
        "You add w without multiplying it by the number.": a + b,
        "You add the number to each component.": [n + scale for n in a + b],
        "v is now only w times the number.": b * scale,
    }
    # The rounding errors of numbers up to 100.
    expect_close(v, a + b * scale, slips, then="; v", tolerance=1e-12)
    expect_unchanged(
        "w",
        w,
        b,
        cause="You change w, which belongs to the caller, as w *= number does. Use w * number "
        "instead, which creates a new vector.",
    )


@pytest.mark.exercise("B2.6", asks="if the other vector is the vector itself", read=ADD)
def test_add_scaled_with_itself(rng: Random) -> None:
    a = vector(rng)
    with calls(SELF_TWICE):
        v = Vector3(*a)
        v.add_scaled(v, 2.0)
    expect_close(v, 3.0 * a, then="; v")


@pytest.mark.exercise("B2.6", asks="in place, as in p' = p + v h", read="book 2.2, Eq. 2.7")
def test_add_scaled_frame_after_frame(rng: Random) -> None:
    """An error of one call may be below its tolerance, but 600 calls add it up."""
    start, velocity = vector(rng), vector(rng)
    with calls(
        "After 600 calls, p must be p + 10 v. Each call must add v times 1/60 to p.",
        f"p, v = Vector3{start}, Vector3{velocity}; p.add_scaled(v, 1 / 60) 600 times; p",
    ):
        got = walk(start, velocity, 1.0 / 60.0, 600)
    # 600 roundings of numbers up to 100.
    expect_close(got, start + 10.0 * velocity, tolerance=1e-10)
