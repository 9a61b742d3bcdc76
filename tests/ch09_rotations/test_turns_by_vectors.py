"""A quaternion is turned on by a vector, build task B9.11."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.probes import in_parts
from ch09_rotations.quaternion import Quaternion
from draw import Components, components, positive_number
from expect import (
    UNCHANGED,
    about,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    scoped,
    xyz,
)
from turning import TIGHT, Quad, draw_quad, hamilton, named, quad, rijk, same_sign

BY_VECTOR = "book 9.4.10, the docstring of rotate_by, and E-12"
ADD = "Eq. 9.5, the docstring of add_scaled, and E-31"
FIRST_LINES = "the first lines of quaternion.py"


def unit(q: Quad) -> Quad:
    """Return a quaternion normalised."""
    return tuple(component / math.hypot(*q) for component in q)


def stepped(q: Quad, change: Quad, scale: float) -> Quad:
    """Return q and so much of a change of it."""
    return tuple(old + scale * new for old, new in zip(q, change, strict=True))


def by_vector_slips(q: Quad, a: Components) -> dict[str, Quad]:
    """Return what likely mistakes make of a quaternion that is turned on by a vector."""
    left, right, size = hamilton((0.0, *a), q), hamilton(q, (0.0, *a)), math.hypot(*a)
    product = "the book's listing, q times (0, vector), which is no turn (E-12)"
    return {
        product: right,
        f"{product}, normalised": unit(right),
        "(0, vector) times q, where (0, vector) is no turn (E-12)": left,
        "(0, vector) times q, normalised, where (0, vector) is no turn (E-12)": unit(left),
        "Eq. 9.9, which is only the first order of the turn (E-12)": stepped(q, left, 0.5),
        "Eq. 9.9, normalised, and only the first order of the turn (E-12)": unit(
            stepped(q, left, 0.5)
        ),
        "q times the turn, as if the axis were the object's own": hamilton(q, quad(a, size)),
        "a turn by half the angle": hamilton(quad(a, 0.5 * size), q),
        "a turn by twice the angle": hamilton(quad(a, 2.0 * size), q),
        "a turn by 1 radian, whatever the length of the vector": hamilton(quad(a, 1.0), q),
        "the turn the other way round": hamilton(quad(a, -size), q),
        "q as it was, but it turns in place, and returns nothing": q,
    }


@pytest.mark.exercise("B9.11", weight=2)
def test_a_quaternion_is_turned_on_by_a_vector(rng: Random) -> None:
    about.read = BY_VECTOR
    about.cause = "make a turn of the vector, by from_axis_angle with its length as the angle; "
    about.cause += "that times q, in this order, since the axis is the world's"
    for size in (0.3, 1.0, 9.0):
        q, a = draw_quad(rng), tuple(size * component for component in components(rng))
        quaternion, v = Quaternion(*q), Vector3(*a)
        about.call = f"q = Quaternion{q}; q.rotate_by(Vector3{a}); q"
        returned = quaternion.rotate_by(v)
        wanted = hamilton(quad(a, math.hypot(*a)), q)
        got = same_sign(rijk(quaternion), wanted)
        slips = {name: same_sign(slip, wanted) for name, slip in by_vector_slips(q, a).items()}
        why = named(got, about.cause, slips)
        expect_close(got, wanted, cause=why, tolerance=1e-11)
        expect_unchanged("the vector", xyz(v), a, cause=UNCHANGED)
        about.call = f"Quaternion{q}.rotate_by(Vector3{a}), what it returns"
        cause_none = "what changes in place returns nothing"
        expect_exactly(returned, None, cause=cause_none)


@pytest.mark.exercise("B9.11")
def test_a_steady_turn_is_exact_in_any_parts() -> None:
    about.read = BY_VECTOR
    about.cause = "it is a rotation, not its first order: the angle of each part is its length"
    for parts in (1, 7, 100):
        about.call = f"{parts} times q.rotate_by(Vector3(0.3, -0.5, 0.8) * 2 / {parts}), from "
        about.call += "Quaternion()"
        got = in_parts((0.3, -0.5, 0.8), 2.0, parts)
        # Eight decimals of SciPy's Rotation.from_rotvec.
        wanted = (0.54873208, 0.25334573, -0.42224289, 0.67558862)
        got = same_sign(got, wanted)
        expect_close(got, wanted, tolerance=1e-8)


@scoped
def expect_tiny_turn(tiny: float) -> None:
    """Expect a turn on by a vector that is next to nothing to be half of it."""
    about.read = BY_VECTOR
    about.cause = "half the vector, to rounding: no small angle may be taken for none"
    quaternion = Quaternion()
    about.call = f"q = Quaternion(); q.rotate_by(Vector3(0, {tiny}, 0)); q.j / {tiny}"
    quaternion.rotate_by(Vector3(0.0, tiny, 0.0))
    got = same_sign(rijk(quaternion), (1.0, 0.0, 0.0, 0.0))[2] / tiny
    expect_close(got, 0.5, tolerance=TIGHT)


@pytest.mark.exercise("B9.11")
def test_turned_on_by_next_to_nothing(rng: Random) -> None:
    about.read = BY_VECTOR
    q = draw_quad(rng)
    quaternion = Quaternion(*q)
    about.call = f"q = Quaternion{q}; q.rotate_by(Vector3(0, 0, 0)); q"
    about.cause = "zero has no direction, and turns nothing"
    quaternion.rotate_by(Vector3(0.0, 0.0, 0.0))
    # Whoever normalises in the end has a rounding there.
    expect_close(rijk(quaternion), q, tolerance=TIGHT)
    expect_tiny_turn(1e-9)


@pytest.mark.exercise("B9.11")
@pytest.mark.robust
def test_turned_on_by_the_least_there_is() -> None:
    expect_tiny_turn(1e-200)


def add_slips(q: Quad, a: Components, scale: float) -> dict[str, Quad]:
    """Return what likely mistakes make of a step by Eq. 9.5."""
    left, right = hamilton((0.0, *a), q), hamilton(q, (0.0, *a))
    in_turn = [*q]
    for place in range(4):
        in_turn[place] += 0.5 * scale * hamilton((0.0, *a), in_turn)[place]
    return {
        "without the half of Eq. 9.5": stepped(q, left, scale),
        "without the scale": stepped(q, left, 0.5),
        "with q times (0, vector), the axis taken for the object's own": stepped(
            q, right, 0.5 * scale
        ),
        "normalised, which Eq. 9.5 is not, and its length must show (E-31)": unit(
            stepped(q, left, 0.5 * scale)
        ),
        "the exact turn of rotate_by, of which Eq. 9.5 is the first order": hamilton(
            quad(a, scale * math.hypot(*a)), q
        ),
        "what comes of components that read others which are changed already": in_turn,
        "the change alone, not added to q": stepped((0.0, 0.0, 0.0, 0.0), left, 0.5 * scale),
        "the vector itself added, times scale/2, and not (0, vector) q": stepped(
            q, (0.0, *a), 0.5 * scale
        ),
        "q as it was, but it changes in place, and returns nothing": q,
    }


@pytest.mark.exercise("B9.11", weight=2)
def test_the_step_of_the_book(rng: Random) -> None:
    about.read = ADD
    size = positive_number(rng, 0.01, 0.9)
    for scale in (-size, size):
        q, a = draw_quad(rng), components(rng)
        quaternion, v = Quaternion(*q), Vector3(*a)
        about.call = f"q = Quaternion{q}; q.add_scaled(Vector3{a}, {scale}); q"
        about.cause = "add scale/2 times (0, vector) q to q, all four components made from the old "
        about.cause += "q"
        returned = quaternion.add_scaled(v, scale)
        wanted = stepped(q, hamilton((0.0, *a), q), 0.5 * scale)
        got = rijk(quaternion)
        why = named(got, about.cause, add_slips(q, a, scale))
        expect_close(got, wanted, cause=why, tolerance=TIGHT)
        expect_unchanged("the vector", xyz(v), a, cause=UNCHANGED)
    about.cause = "what changes in place returns nothing"
    about.call = f"Quaternion{q}.add_scaled(Vector3{a}, {scale}), what it returns"
    expect_exactly(returned, None)


@pytest.mark.exercise("B9.11")
@pytest.mark.robust
@pytest.mark.parametrize("method", ["rotate_by", "add_scaled"])
def test_turned_by_what_is_no_vector(rng: Random, method: str) -> None:
    about.read = f"the docstring of {method}"
    q, scale = draw_quad(rng), positive_number(rng)
    about.cause = "finite_vector and finite of arguments.py refuse it, before anything is changed"
    good = (0.0, 1.0, 1.0)
    bad = [((0.0, n, 1.0), scale, ValueError) for n in (math.nan, math.inf)]
    bad += [(good, n, ValueError) for n in (math.nan, math.inf) if method == "add_scaled"]
    bad += [(good, "1.0", TypeError)] if method == "add_scaled" else []

    def use(quaternion: object, v: object, by: object) -> object:
        return getattr(quaternion, method)(v, *((by,) if method == "add_scaled" else ()))

    for a, by, error in [*bad, (None, scale, TypeError)]:
        quaternion = Quaternion(*q)
        vector = None if a is None else Vector3(*a)
        about.call = f"q = Quaternion{q}; q.{method}({'None' if a is None else f'Vector3{a}'}"
        about.call += f", {by!r})" if method == "add_scaled" else ")"
        expect_error(
            lambda quaternion=quaternion, vector=vector, by=by: use(quaternion, vector, by),
            error,
            allowed=lambda: use(Quaternion(*q), Vector3(*good), scale),
        )
        expect_unchanged("q", rijk(quaternion), q)
    more = (scale,) if method == "add_scaled" else ()
    shown = ", ".join(map(str, (good, *more)))
    expect_error(
        lambda: use(Quaternion(*q), good, scale),
        TypeError,
        call=f"Quaternion{q}.{method}({shown})",
        allowed=lambda: use(Quaternion(*q), Vector3(*good), scale),
        cause="three numbers are no Vector3: finite_vector of arguments.py refuses them",
        read=FIRST_LINES,
    )
