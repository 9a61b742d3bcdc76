"""Quaternions: length and product, build tasks B9.7 and B9.8."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion
from draw import number
from expect import UNCHANGED, about, expect_close, expect_error, expect_exactly, expect_unchanged
from turning import Quad, draw_quad, hamilton, named, rijk

LENGTH = "the docstrings of Quaternion.magnitude and is_unit"
NORMALIZE = "book 9.4.8, and the docstring of normalize"
PRODUCT = "book 9.4.9"
ONLY_LOOKS = "it only asks, and must not change the quaternion: work on numbers of your own"


def draw_four(rng: Random) -> Quad:
    """Draw four components, none of them near zero."""
    return number(rng), number(rng), number(rng), number(rng)


@pytest.mark.exercise("B9.7")
def test_the_length_of_four_components(rng: Random) -> None:
    about(cause="the root of the sum of four squares: r is one of them", read=LENGTH)
    about.call = "Quaternion(1, -3, 5, 1).magnitude()"
    got = Quaternion(1.0, -3.0, 5.0, 1.0).magnitude()
    slips = {
        "the sum of the squares, without the root": 36.0,
        "the length of (i, j, k) alone, without r": math.sqrt(35.0),
        "the sum of the four": 4.0,
        "the sum of the four sizes": 10.0,
    }
    expect_close(got, 6.0, cause=named(got, about.cause, slips))
    q = draw_four(rng)
    about.call = f"Quaternion{q}.magnitude()"
    quaternion = Quaternion(*q)
    got = quaternion.magnitude()
    expect_close(got, math.hypot(*q))
    expect_unchanged("q", rijk(quaternion), q, cause=ONLY_LOOKS)


@pytest.mark.exercise("B9.7")
def test_near_which_length_it_is_a_turn(rng: Random) -> None:
    about.read = LENGTH
    q = draw_quad(rng)
    for length, wanted in (
        (1.0, True),
        (1.0 + 9e-7, True),
        (1.0 - 9e-7, True),
        (1.0 + 1.1e-6, False),
        (1.0 - 1.1e-6, False),
        (0.0, False),
        (-3.0, False),
    ):
        scaled = tuple(component * length for component in q)
        about.call = f"Quaternion{scaled}.is_unit(), of length {abs(length)}"
        about.cause = "within UNIT_TOLERANCE, 1e-6, on both sides of 1"
        if 0.0 < abs(length - 1.0) < 1e-5:
            about.cause += f": the length is off by {abs(length - 1.0):.2g} here, and its square, "
            about.cause += "which "
            about.cause += "is not to be compared, by twice as much"
        quaternion = Quaternion(*scaled)
        got = quaternion.is_unit()
        expect_exactly(got, wanted)
        expect_unchanged("q", rijk(quaternion), scaled, cause=ONLY_LOOKS)
    about("Quaternion(0, 0.6, 0, 0.8).is_unit(), a half-turn", cause="its length is 1: r may be 0")
    got = Quaternion(0.0, 0.6, 0.0, 0.8).is_unit()
    expect_exactly(got, True)


@pytest.mark.exercise("B9.7")
def test_normalised_it_has_length_one(rng: Random) -> None:
    about.read = NORMALIZE
    drawn, near = draw_four(rng), draw_quad(rng)
    opposite = tuple(-component for component in drawn)
    for q in (drawn, opposite, tuple(component * (1.0 + 5e-7) for component in near)):
        length = math.hypot(*q)
        about.cause = "divide all four by the length, which is worked out once, before the first "
        about.cause += "changes"
        quaternion = Quaternion(*q)
        about.call = f"q = Quaternion{q}; q.normalize(); q"
        returned = quaternion.normalize()
        wanted = tuple(component / length for component in q)
        got = rijk(quaternion)
        slips = {
            "the quaternion as it was, where it must change in place": q,
            "what comes of dividing by the squared length": [c / length**2 for c in q],
        }
        if length != 1.0 and abs(length - 1.0) < 1e-6:
            slips = {"the quaternion as it was, which is_unit lets pass, but not this": q}
            about.cause = "normalize divides whatever the length"
        expect_close(got, wanted, cause=named(got, about.cause, slips))
    about.cause = "what changes in place returns nothing"
    about.call = f"Quaternion{q}.normalize(), what it returns"
    expect_exactly(returned, None)


@pytest.mark.exercise("B9.7")
def test_zero_becomes_the_reference() -> None:
    about("q = Quaternion(0, 0, 0, 0); q.normalize(); q", read=NORMALIZE)
    about.cause = "zero has no direction: it becomes (1, 0, 0, 0), the turn of nothing"
    quaternion = Quaternion(0.0, 0.0, 0.0, 0.0)
    quaternion.normalize()
    expect_close(rijk(quaternion), (1.0, 0.0, 0.0, 0.0))


@pytest.mark.exercise("B9.7")
@pytest.mark.robust
def test_what_is_huge_or_not_finite_is_no_turn(rng: Random) -> None:
    about.read = LENGTH
    q = draw_quad(rng)
    about.cause = "NaN compares false with everything: ask whether the length is near 1, and not "
    about.cause += "whether it is far"
    for length in (math.nan, math.inf):
        scaled = tuple(component * length for component in q)
        about.call = f"Quaternion{scaled}.is_unit(), of length {length}"
        got = Quaternion(*scaled).is_unit()
        expect_exactly(got, False)
    about.call = "Quaternion(1e200, 0, 0, 1e200).is_unit()"
    about.cause = "the square of 1e200 fits in no float: ask magnitude()"
    got = Quaternion(1e200, 0.0, 0.0, 1e200).is_unit()
    expect_exactly(got, False)


@pytest.mark.exercise("B9.7")
@pytest.mark.robust
def test_huge_and_tiny_components_have_a_length(rng: Random) -> None:
    about.read = NORMALIZE
    q = draw_four(rng)
    length = math.hypot(*q)
    wanted = tuple(component / length for component in q)
    about.cause = "their squares fit in no float: math.hypot takes four numbers"
    for scale in (1e200, 1e-200):
        scaled = tuple(component * scale for component in q)
        about.call = f"Quaternion{scaled}.magnitude() / {scale}"
        got = Quaternion(*scaled).magnitude() / scale
        expect_close(got, length)
        quaternion = Quaternion(*scaled)
        about.call = f"q = Quaternion{scaled}; q.normalize(); q"
        quaternion.normalize()
        expect_close(rijk(quaternion), wanted)


@pytest.mark.exercise("B9.8")
def test_the_conjugate_turns_back(rng: Random) -> None:
    about.read = "the docstring of conjugate"
    q = draw_four(rng)
    quaternion = Quaternion(*q)
    about.call = f"q = Quaternion{q}; q.conjugate()"
    about.cause = "r stays, and i, j and k change their signs, in a new quaternion"
    got = rijk(quaternion.conjugate())
    r, i, j, k = q
    wanted = (r, -i, -j, -k)
    slips = {
        "all four with their signs changed, which is the same orientation": (-r, -i, -j, -k),
        "the sign of r changed, and not the three others": (-r, i, j, k),
        "the quaternion as it was": q,
    }
    why = named(got, about.cause, slips)
    expect_close(got, wanted, cause=why, tolerance=0.0)
    expect_unchanged("q", rijk(quaternion), q, cause=UNCHANGED)


@pytest.mark.exercise("B9.8")
def test_the_table_of_i_j_and_k() -> None:
    about.read = PRODUCT
    units = {
        "1": (1.0, 0.0, 0.0, 0.0),
        "i": (0.0, 1.0, 0.0, 0.0),
        "j": (0.0, 0.0, 1.0, 0.0),
        "k": (0.0, 0.0, 0.0, 1.0),
    }
    about.cause = "i j = k, j k = i and k i = j; the other way round the sign is turned; i i = -1"
    products = []
    for first, a in units.items():
        for second, b in units.items():
            about.call = f"Quaternion{a} * Quaternion{b}, which is {first} {second}"
            one, other = Quaternion(*a), Quaternion(*b)
            products.append((about.call, a, b, rijk(one * other)))
            expect_unchanged("the first", rijk(one), a, cause=UNCHANGED)
            expect_unchanged("the second", rijk(other), b, cause=UNCHANGED)
    if all(got == hamilton(b, a) for _, a, b, got in products):
        about.cause = f"this is the product in the other order: {about.cause}"
    for call, a, b, got in products:
        about.call = call
        expect_close(got, hamilton(a, b), tolerance=0.0)


@pytest.mark.exercise("B9.8", weight=2)
def test_the_product_of_any_two(rng: Random) -> None:
    about.read = PRODUCT
    a, b = draw_four(rng), draw_four(rng)
    first, second = Quaternion(*a), Quaternion(*b)
    about.call = f"a, b = Quaternion{a}, Quaternion{b}; a * b"
    about.cause = "the scalar part is r r' - v . v', the rest r v' + r' v + v x v', as a new "
    about.cause += "quaternion"
    got = rijk(first * second)
    # Four products of up to 90.
    expect_close(got, hamilton(a, b), tolerance=1e-12)
    expect_unchanged("a", rijk(first), a, cause=UNCHANGED)
    expect_unchanged("b", rijk(second), b, cause=UNCHANGED)


@pytest.mark.exercise("B9.8")
@pytest.mark.robust
def test_a_quaternion_times_a_number_is_refused(rng: Random) -> None:
    about.read = "the first lines of quaternion.py"
    q = draw_four(rng)
    about.cause = "ask isinstance(q, Quaternion), and return NotImplemented: Python raises the "
    about.cause += "TypeError"
    for other in (2.0, "2", None, (1.0, 0.0, 0.0, 0.0), Vector3(1.0, 2.0, 3.0)):
        name = "Vector3(1, 2, 3)" if isinstance(other, Vector3) else repr(other)
        expect_error(
            lambda other=other: Quaternion(*q) * other,
            TypeError,
            call=f"Quaternion{q} * {name}",
            allowed=lambda: Quaternion(*q) * Quaternion(),
        )
