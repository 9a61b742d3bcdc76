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
from turning import TIGHT, Quad, draw_quad, hamilton, named, quad, rijk, same_sign, short

BY_VECTOR = "book 9.4.10, the docstring of rotate_by, and E-12"
ADD = "Eq. 9.5, the docstring of add_scaled, and E-31"
FIRST_LINES = "the docstring at the top of quaternion.py"


def unit(q: Quad) -> Quad:
    """Return a normalized quaternion."""
    return tuple(component / math.hypot(*q) for component in q)


def stepped(q: Quad, change: Quad, scale: float) -> Quad:
    """Return q + scale * change."""
    return tuple(old + scale * new for old, new in zip(q, change, strict=True))


def by_vector_slips(q: Quad, a: Components) -> dict[str, Quad]:
    """Return the results of likely mistakes in rotate_by."""
    left, right, size = hamilton((0.0, *a), q), hamilton(q, (0.0, *a)), math.hypot(*a)
    book = "as in the book's listing. (0, vector) is not a rotation (E-12), so make one from the "
    book += "vector with from_axis_angle."
    first_order = "which is only accurate to first order (E-12). Make an exact rotation from the "
    first_order += "vector with from_axis_angle instead, and multiply it by q."
    return {
        f"You multiply q by (0, vector), {book}": right,
        f"You multiply q by (0, vector) and normalize the product, {book}": unit(right),
        "(0, vector) times q, where (0, vector) is not a rotation (E-12)": left,
        "(0, vector) times q, normalized, where (0, vector) is not a rotation (E-12)": unit(left),
        f"You use Eq. 9.9, {first_order}": stepped(q, left, 0.5),
        f"You use Eq. 9.9 and normalize, {first_order}": unit(stepped(q, left, 0.5)),
        "q times the rotation, which is about the object's own axis": hamilton(q, quad(a, size)),
        "You rotate by half the angle.": hamilton(quad(a, 0.5 * size), q),
        "You rotate by twice the angle.": hamilton(quad(a, 2.0 * size), q),
        "You rotate by 1 radian, no matter how long the vector is.": hamilton(quad(a, 1.0), q),
        "You rotate in the opposite direction.": hamilton(quad(a, -size), q),
        "The quaternion hasn't changed. Assign the new values to the components of self, because a "
        "new quaternion is lost when the method returns.": q,
    }


@pytest.mark.exercise("B9.11", weight=2)
def test_a_quaternion_is_turned_on_by_a_vector(rng: Random) -> None:
    about.read = BY_VECTOR
    about.cause = (
        "Make a rotation with from_axis_angle, where the vector is the axis and its length is the "
        "angle. Put it on the left of q, because the vector is in world coordinates."
    )
    for size in (0.3, 1.0, 9.0):
        q, a = draw_quad(rng), tuple(size * component for component in components(rng))
        quaternion, v = Quaternion(*q), Vector3(*a)
        about.call = f"q = Quaternion{short(q)}; q.rotate_by(Vector3{short(a)}); q"
        returned = quaternion.rotate_by(v)
        wanted = hamilton(quad(a, math.hypot(*a)), q)
        got = same_sign(rijk(quaternion), wanted)
        slips = {name: same_sign(slip, wanted) for name, slip in by_vector_slips(q, a).items()}
        why = named(got, about.cause, slips)
        expect_close(got, wanted, cause=why, tolerance=1e-11)
        expect_unchanged("the vector", xyz(v), a, cause=UNCHANGED)
        about.call = f"Quaternion{short(q)}.rotate_by(Vector3{short(a)})"
        cause_none = "This method works in place, so it shouldn't return anything."
        expect_exactly(returned, None, cause=cause_none)


@pytest.mark.exercise("B9.11")
def test_a_steady_turn_is_exact_in_any_parts() -> None:
    about.read = BY_VECTOR
    about.cause = (
        "Each call should rotate by exactly the length of its vector. Then all calls together give "
        "the same result, however many there are."
    )
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
    """Expect rotate_by to add half of a very small vector."""
    about.read = BY_VECTOR
    about.cause = (
        "You treat this small angle as 0. Rotate by it as usual: (i, j, k) should become half of "
        "the vector."
    )
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
    about.call = f"q = Quaternion{short(q)}; q.rotate_by(Vector3(0, 0, 0)); q"
    about.cause = (
        "A zero vector has no direction and means an angle of 0. Leave the quaternion as it is."
    )
    quaternion.rotate_by(Vector3(0.0, 0.0, 0.0))
    # Normalizing at the end causes a rounding error here.
    expect_close(rijk(quaternion), q, tolerance=TIGHT)
    expect_tiny_turn(1e-9)


@pytest.mark.exercise("B9.11")
@pytest.mark.robust
def test_turned_on_by_the_least_there_is() -> None:
    expect_tiny_turn(1e-200)


def add_slips(q: Quad, a: Components, scale: float) -> dict[str, Quad]:
    """Return the results of likely mistakes in add_scaled."""
    left, right = hamilton((0.0, *a), q), hamilton(q, (0.0, *a))
    in_turn = [*q]
    for place in range(4):
        in_turn[place] += 0.5 * scale * hamilton((0.0, *a), in_turn)[place]
    return {
        "You leave out the factor 1/2 of Eq. 9.5. Add scale/2 times the product (0, vector) q to "
        "q.": stepped(q, left, scale),
        "You don't multiply the vector by the scale.": stepped(q, left, 0.5),
        "Your factors are in the wrong order, so the step rotates about an axis of the object "
        "instead of the world.": stepped(q, right, 0.5 * scale),
        "You normalize the result, but a step of Eq. 9.5 should change the length a little (E-31). "
        "The exercises measure this error, so leave it.": unit(stepped(q, left, 0.5 * scale)),
        "You make the exact rotation that rotate_by makes. Make the first-order step of Eq. 9.5 "
        "instead: add scale/2 times (0, vector) q to q.": hamilton(
            quad(a, scale * math.hypot(*a)), q
        ),
        "You use components of q that you have already changed. Compute all four from "
        "the old q before you assign them.": in_turn,
        "You lose the old q. Add the change to its components instead of replacing them.": stepped(
            (0.0, 0.0, 0.0, 0.0), left, 0.5 * scale
        ),
        "You add (0, vector) alone, without multiplying it by q.": stepped(
            q, (0.0, *a), 0.5 * scale
        ),
        "The quaternion hasn't changed. Change its components in place, because a new quaternion "
        "is lost when the method returns.": q,
    }


@pytest.mark.exercise("B9.11", weight=2)
def test_the_step_of_the_book(rng: Random) -> None:
    about.read = ADD
    size = positive_number(rng, 0.01, 0.9)
    for scale in (-size, size):
        q, a = draw_quad(rng), components(rng)
        quaternion, v = Quaternion(*q), Vector3(*a)
        about.call = f"q = Quaternion{short(q)}; q.add_scaled(Vector3{short(a)}, {scale}); q"
        about.cause = (
            "Add scale/2 times the product (0, vector) q to q. Compute all four components from "
            "the old q before you assign them."
        )
        returned = quaternion.add_scaled(v, scale)
        wanted = stepped(q, hamilton((0.0, *a), q), 0.5 * scale)
        got = rijk(quaternion)
        why = named(got, about.cause, add_slips(q, a, scale))
        expect_close(got, wanted, cause=why, tolerance=TIGHT)
        expect_unchanged("the vector", xyz(v), a, cause=UNCHANGED)
    about.cause = "This method works in place, so it shouldn't return anything."
    about.call = f"Quaternion{short(q)}.add_scaled(Vector3{short(a)}, {scale})"
    expect_exactly(returned, None)


@pytest.mark.exercise("B9.11")
@pytest.mark.robust
@pytest.mark.parametrize("method", ["rotate_by", "add_scaled"])
def test_turned_by_what_is_no_vector(rng: Random, method: str) -> None:
    about.read = f"the docstring of {method}"
    q, scale = draw_quad(rng), positive_number(rng)
    about.cause = (
        "The vector and the scale must be finite. Check them with finite_vector and finite from "
        "arguments.py before you change anything."
    )
    good = (0.0, 1.0, 1.0)
    bad = [((0.0, n, 1.0), scale, ValueError) for n in (math.nan, math.inf)]
    bad += [(good, n, ValueError) for n in (math.nan, math.inf) if method == "add_scaled"]
    bad += [(good, "1.0", TypeError)] if method == "add_scaled" else []

    def use(quaternion: object, v: object, by: object) -> object:
        return getattr(quaternion, method)(v, *((by,) if method == "add_scaled" else ()))

    for a, by, error in [*bad, (None, scale, TypeError)]:
        quaternion = Quaternion(*q)
        vector = None if a is None else Vector3(*a)
        about.call = f"q = Quaternion{short(q)}; "
        about.call += f"q.{method}({'None' if a is None else f'Vector3{short(a)}'}"
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
        call=f"Quaternion{short(q)}.{method}({shown})",
        allowed=lambda: use(Quaternion(*q), Vector3(*good), scale),
        cause="The check passed a tuple. Raise TypeError for anything but a Vector3.",
        read=FIRST_LINES,
    )
