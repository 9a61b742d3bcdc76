"""Vector3: sums and differences, build task B2.5."""

from __future__ import annotations

from random import Random

import pytest

from ch02_vectors.vector import Vector3
from draw import components
from expect import (
    about,
    blame,
    expect_close,
    expect_same_object,
    expect_that,
    expect_unchanged,
    xyz,
)

ZERO = (0.0, 0.0, 0.0)


# B2.5 Add and subtract


@pytest.mark.exercise("B2.5", asks="return their sum as a new vector")
def test_the_sum_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] + b[0], a[1] + b[1], a[2] + b[2])
    about.call = f"v, w = Vector3{a}, Vector3{b}; v + w"
    about(
        cause="Vectors are added component by component. Return a new vector with the components "
        "v.x + w.x, v.y + w.y and v.z + w.z.",
        read="book 2.1.4",
    )
    got = xyz(v + w)
    no_vector = "Your three sums are right, but you don't return a vector. Pass them to Vector3()."
    blame(got, [(wanted, no_vector)])
    expect_close(got, wanted)
    for name, now, before in (("v", v, a), ("w", w, b)):
        about.cause = (
            f"Your __add__ changes {name}, but only v += w may change a vector, and only v. Return "
            "a new vector and leave both unchanged."
        )
        expect_unchanged(name, xyz(now), before)


@pytest.mark.exercise("B2.5", asks="return the difference as a new vector")
def test_the_difference_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    wanted = (a[0] - b[0], a[1] - b[1], a[2] - b[2])
    about.call = f"v, w = Vector3{a}, Vector3{b}; v - w"
    about.cause = (
        "Vectors are subtracted component by component. Return a new vector with the components "
        "v.x - w.x, v.y - w.y and v.z - w.z."
    )
    about.read = "book 2.1.4"
    got = xyz(v - w)
    mistakes = [
        (
            tuple(-n for n in wanted),
            "You swap the operands, so the result is w - v. Subtract the components of w from "
            "those of v.",
        ),
        (
            (a[0] + b[0], a[1] + b[1], a[2] + b[2]),
            "The result is v + w. Subtract the components of w instead of adding them.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, wanted, tolerance=1e-14)
    for name, now, before in (("v", v, a), ("w", w, b)):
        about.cause = (
            f"Your __sub__ changes {name}, but only v -= w may change a vector, and only v. Return "
            "a new vector and leave both unchanged."
        )
        expect_unchanged(name, xyz(now), before)


@pytest.mark.exercise("B2.5", asks="their methods must end with return self")
@pytest.mark.parametrize(("operator", "sign"), [("+=", 1.0), ("-=", -1.0)], ids=["plus", "minus"])
def test_plus_and_minus_equals_change_the_vector_itself(
    rng: Random, operator: str, sign: float
) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    before = v
    wanted = (a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2])
    made, step = f"v, other = Vector3{a}, Vector3{b}", f"v {operator} other"
    about.call = f"{made}; {step}"
    about.cause = (
        "Change the components of self. End the method with return self, because Python assigns "
        "its result to v."
    )
    about.read = "book 2.1.4"
    if operator == "+=":
        v += w
    else:
        v -= w
    nothing = (
        f"Your {'__iadd__' if sign > 0.0 else '__isub__'} returned nothing, so Python assigned "
        "None to v. End the method with return self."
    )
    expect_that(v is not None, "v is None", "v is the same vector as before", cause=nothing)
    opposite = (a[0] - sign * b[0], a[1] - sign * b[1], a[2] - sign * b[2])
    wrong_sign = "-" if sign > 0.0 else "+"
    mistakes = [
        (
            opposite,
            f"You compute v {wrong_sign} other, although the operator is {operator}. Compute v "
            f"{operator[0]} other for each component.",
        )
    ]
    blame(xyz(v), mistakes)
    expect_close(xyz(v), wanted, then="; v", tolerance=1e-14)
    about.cause = (
        "Your method changes the other vector too, but it must change only self. Read the "
        "components of the other vector without assigning to them."
    )
    expect_unchanged("other", xyz(w), b)
    expect_same_object(made, step, v, before)


@pytest.mark.exercise("B2.5", asks="if the other vector is the vector itself")
def test_a_vector_minus_itself_in_place(rng: Random) -> None:
    a = components(rng)
    v, w = Vector3(*a), Vector3(*a)
    about.cause = (
        "Here self and the argument are the same vector, v, so each change to self also changes "
        "the argument. Read each component before you change it."
    )
    about(f"v = Vector3{a}; v -= v", read="book 2.1.4")
    v -= v
    expect_close(xyz(v), ZERO, then="; v")
    about.call = f"v = Vector3{a}; v += v"
    w += w
    expect_close(xyz(w), tuple(2.0 * n for n in a), then="; v")
