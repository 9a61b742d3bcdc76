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
    about,
    expect_close,
    expect_exactly,
    scoped,
    xyz,
)
from turning import (
    TIGHT,
    Quad,
    draw_quad,
    expect_kept,
    hamilton,
    named,
    quad,
    rijk,
    same_sign,
    short,
)

BY_VECTOR = "book 9.4.10, the docstring of rotate_by, and E-12"
ADD = "Eq. 9.5, the docstring of add_scaled, and E-31"


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
    first_order += "vector with from_axis_angle instead."
    turn, in_turn = quad(a, size), [*q]
    for place in range(4):
        in_turn[place] = hamilton(turn, in_turn)[place]
    make = (
        "but (0, vector) is not a rotation (E-12). Make one from the vector with from_axis_angle."
    )
    return {
        f"You multiply q by (0, vector), {book}": right,
        f"You multiply q by (0, vector) and normalize the product, {book}": unit(right),
        f"You multiply (0, vector) by q, {make}": left,
        f"You multiply (0, vector) by q and normalize the product, {make}": unit(left),
        f"You use Eq. 9.9, {first_order}": stepped(q, left, 0.5),
        f"You use Eq. 9.9 and normalize, {first_order}": unit(stepped(q, left, 0.5)),
        "You rotate about the object's own axes. Either the new rotation is on the right of q, or "
        "you rotate the vector by q first. Use the vector as it is, with the new rotation on the "
        "left.": hamilton(q, quad(a, size)),
        "You rotate by half the angle. The angle is the whole length of the vector.": hamilton(
            quad(a, 0.5 * size), q
        ),
        "You rotate by twice the angle. The angle is the length of the vector.": hamilton(
            quad(a, 2.0 * size), q
        ),
        "You rotate by 1 radian, no matter how long the vector is. Use its length as the "
        "angle.": hamilton(quad(a, 1.0), q),
        "You rotate in the opposite direction.": hamilton(quad(a, -size), q),
        "You use the squared length as the angle. Use the length itself.": hamilton(
            quad(a, size * size), q
        ),
        "You replace the old orientation by the new rotation. Multiply the new rotation by q "
        "instead.": turn,
        "You add the new rotation to q. Multiply it by q instead.": stepped(q, turn, 1.0),
        "You change a component of q before you have computed the others. Compute the whole "
        "product first, and assign its components at the end.": tuple(in_turn),
        "The quaternion hasn't changed. Assign the new values to the components of self, because a "
        "new quaternion is lost when the method returns.": q,
    }


@pytest.mark.exercise("B9.11", asks="Rotate the orientation in place by the rotation", weight=2)
def test_rotates_a_quaternion_by_a_vector(rng: Random) -> None:
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
        expect_kept("the vector", xyz(v), a)
        about.call = f"Quaternion{short(q)}.rotate_by(Vector3{short(a)})"
        cause_none = "This method works in place, so it shouldn't return anything."
        expect_exactly(returned, None, cause=cause_none)


@pytest.mark.exercise("B9.11", asks="To make an exact step, build a quaternion")
def test_a_steady_rotation_is_exact_in_any_number_of_parts() -> None:
    about.read = BY_VECTOR
    about.cause = (
        "You don't rotate by exactly the length of the vector, so the errors of all calls add up. "
        "Make an exact rotation from the vector."
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
    about.cause = "You treat this small angle as 0. Rotate by every angle, no matter how small."
    quaternion = Quaternion()
    about.call = f"q = Quaternion(); q.rotate_by(Vector3(0, {tiny}, 0)); q.j / {tiny}"
    quaternion.rotate_by(Vector3(0.0, tiny, 0.0))
    got = same_sign(rijk(quaternion), (1.0, 0.0, 0.0, 0.0))[2] / tiny
    if got:
        about.cause = (
            "Rotate by every angle, no matter how small. Here (i, j, k) becomes half the vector."
        )
    expect_close(got, 0.5, tolerance=TIGHT)


@pytest.mark.exercise("B9.11", asks="so a zero vector changes nothing")
def test_rotates_by_a_zero_or_tiny_vector(rng: Random) -> None:
    about.read = BY_VECTOR
    q = draw_quad(rng)
    quaternion = Quaternion(*q)
    about.call = f"q = Quaternion{short(q)}; q.rotate_by(Vector3(0, 0, 0)); q"
    about.cause = (
        "A zero vector means a rotation by 0, but it has no direction that could be an axis. Leave "
        "the quaternion unchanged."
    )
    quaternion.rotate_by(Vector3(0.0, 0.0, 0.0))
    # Normalizing at the end causes a rounding error here.
    expect_close(rijk(quaternion), q, tolerance=TIGHT)
    expect_tiny_turn(1e-9)


@pytest.mark.exercise("B9.11", asks="for vectors as short as 1e-200")
@pytest.mark.robust
def test_rotates_by_an_extremely_short_vector() -> None:
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
        "Your quaternion of the vector has r = 1. Its r must be 0.": stepped(
            q, hamilton((1.0, *a), q), 0.5 * scale
        ),
        "The quaternion of your scaled vector has r = 1. Its r must be 0.": stepped(
            q, hamilton((1.0, *(scale * part for part in a)), q), 0.5
        ),
        "You rotate about an axis of the object instead of the world, because you compute q (0, "
        "vector). Swap the two factors.": stepped(q, right, 0.5 * scale),
        "You normalize the result. Leave out the normalization, because later exercises measure "
        "how much a step of Eq. 9.5 changes the length (E-31).": unit(
            stepped(q, left, 0.5 * scale)
        ),
        "You rotate exactly, as rotate_by does. add_scaled takes the first-order step of Eq. 9.5 "
        "instead: it adds scale/2 times (0, vector) q to q.": hamilton(
            quad(a, scale * math.hypot(*a)), q
        ),
        "You use components of q that you have already changed. Compute all four from "
        "the old q before you assign them.": in_turn,
        "You multiply by the scale twice. Eq. 9.5 contains it only once.": stepped(
            q, left, 0.5 * scale * scale
        ),
        "You divide by 2 twice. Eq. 9.5 contains the factor 1/2 only once.": stepped(
            q, left, 0.25 * scale
        ),
        "You subtract the change from q. Add it instead.": stepped(q, left, -0.5 * scale),
        "You lose the old q. Add the change to its components instead of replacing them.": stepped(
            (0.0, 0.0, 0.0, 0.0), left, 0.5 * scale
        ),
        "You add (0, vector) alone, without multiplying it by q.": stepped(
            q, (0.0, *a), 0.5 * scale
        ),
        "The quaternion hasn't changed. Change its components in place, because a new quaternion "
        "is lost when the method returns.": q,
    }


@pytest.mark.exercise("B9.11", asks="Do not normalize the result", weight=2)
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
        why = named(got, about.cause, add_slips(q, a, scale), wanted)
        expect_close(got, wanted, cause=why, tolerance=TIGHT)
        expect_kept("the vector", xyz(v), a)
    about.cause = "This method works in place, so it shouldn't return anything."
    about.call = f"Quaternion{short(q)}.add_scaled(Vector3{short(a)}, {scale})"
    expect_exactly(returned, None)
