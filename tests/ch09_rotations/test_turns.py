"""Quaternions, axes and angles, and turning on by a vector: build tasks B9.9 and B9.11."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch09_rotations.probes import in_parts
from ch09_rotations.quaternion import Quaternion
from draw import Triple, positive_number, vector
from expect import about, expect_close, expect_error, expect_exactly, expect_vector, xyz
from turning import (
    TIGHT,
    X_AXIS,
    Quad,
    draw_quad,
    draw_turn,
    expect_kept,
    hamilton,
    named,
    quad,
    rijk,
    same_sign,
    short,
)

MAKE = "book 9.2.4, Eq. 9.4, and the docstring of from_axis_angle"
BACK = "the docstring of to_axis_angle"
BY_VECTOR = "book 9.4.10, the docstring of rotate_by, and E-12"
ADD = "Eq. 9.5, the docstring of add_scaled, and E-31"
NOTHING = "This method works in place, so it shouldn't return anything."


def unit(q: Sequence[float]) -> Quad:
    """Return a normalized quaternion."""
    return tuple(component / math.hypot(*q) for component in q)


def make_slips(axis: Triple, angle: float) -> dict[str, Quad]:
    """Return the results of likely mistakes in from_axis_angle."""
    c, s, u = math.cos(0.5 * angle), math.sin(0.5 * angle), axis / abs(axis)
    whole_c, whole_s = math.cos(angle), math.sin(angle)
    parts = {
        "half of the angle in the cosine, but the whole angle in the sine": (c, whole_s * u),
        "half of the angle in the sine, but the whole angle in the cosine": (whole_c, s * u),
        "the whole angle": (whole_c, whole_s * u),
        "the whole angle, and you don't normalize the axis": (whole_c, whole_s * axis),
        "sin(angle / 2) for r": (s, s * u),
        "cos(angle / 2) for the vector part": (c, c * u),
    }
    return {f"You use {slip}.": (r, *v) for slip, (r, v) in parts.items()} | {
        "You divide the angle by 4. Divide it by 2 only.": quad(axis, 0.5 * angle),
        "You put r last. It is the first argument of Quaternion.": (*(s * u), c),
        "You normalize the quaternion instead of the axis.": unit((c, *(s * axis))),
        "You don't normalize the axis.": (c, *(s * axis)),
        "You treat the angle as degrees. It is in radians.": quad(axis, math.radians(angle)),
        "You swap sine and cosine.": (s, *(c * u)),
        "You swap sine and cosine in r and i.": (s, c * u[0], s * u[1], s * u[2]),
        "You don't multiply the axis by the sine.": (c, *u),
        "Your rotation goes in the opposite direction.": quad(axis, -angle),
    }


@pytest.mark.exercise("B9.9", asks="Create the quaternion of a rotation by angle", read=MAKE)
def test_the_quaternion_of_axis_and_angle(rng: Random) -> None:
    drawn, angle = vector(rng), positive_number(rng, 0.3, 2.8)
    plain = Triple((1.0, 2.0, 3.0))
    # Eight decimals of SciPy's Rotation.from_rotvec.
    samples = [(plain, 1.2, (0.82533561, 0.15090705, 0.30181410, 0.45272115), 1e-8)]
    for t in (angle, -angle, 2.0 * math.pi + angle):
        samples.append((drawn, t, quad(drawn, t), TIGHT))
    for axis, t, wanted, near in samples:
        with calls("r is cos(angle / 2), and i, j and k are the unit axis times sin(angle / 2)."):
            v = Vector3(*axis)
            q = Quaternion.from_axis_angle(v, t)
        got = rijk(q)
        if t > math.pi:  # a rotation by t - 2 pi is the same, and has the opposite quaternion
            got = same_sign(got, wanted)
        expect_close(got, wanted, make_slips(axis, t), tolerance=near)
        expect_kept("the axis", v, axis)


def expect_any_length(rng: Random, scale: float, cause: str) -> None:
    """Expect an axis that is scaled to make the same quaternion."""
    axis, angle = draw_turn(rng)
    with calls(cause):
        q = Quaternion.from_axis_angle(Vector3(*axis) * scale, angle)
    expect_close(rijk(q), quad(axis, angle), tolerance=TIGHT)


@pytest.mark.exercise("B9.9", asks="Only the direction of the axis matters", read=MAKE)
def test_the_length_of_the_axis_does_not_matter(rng: Random) -> None:
    expect_any_length(rng, 1e-3, "You don't normalize the axis. Use a normalized copy of it.")


@pytest.mark.exercise("B9.9", asks="so the axis may have any length except 0", read=MAKE)
@pytest.mark.robust
def test_an_axis_may_be_huge_or_tiny(rng: Random) -> None:
    cause = "The squares of the components don't fit into a float. Call normalized() on the axis."
    for scale in (1e200, 1e-200):
        expect_any_length(rng, scale, cause)


@pytest.mark.exercise("B9.9", asks="if the axis is zero or a number is not finite", read=MAKE)
@pytest.mark.robust
def test_rejects_an_invalid_axis_or_angle() -> None:
    for axis, angle, error, problem in (
        ((0.0, 0.0, 0.0), 1.0, ValueError, "The axis is zero, so it has no direction."),
        ((0.0, math.nan, 1.0), 1.0, ValueError, ""),
        ((0.0, math.inf, 1.0), 1.0, ValueError, "A component of the axis is infinite."),
        ((0.0, 1.0, 1.0), math.nan, ValueError, ""),
        ((0.0, 1.0, 1.0), math.inf, ValueError, "The angle is infinite."),
        ((0.0, 1.0, 1.0), "1.0", TypeError, "The angle is a string, not a number."),
        ((0.0, 1.0, 1.0), 1.0, TypeError, "The axis is a tuple, not a Vector3."),
    ):
        of = tuple if "tuple" in problem else lambda numbers: Vector3(*numbers)
        name = "" if of is tuple else "Vector3"
        expect_error(
            lambda axis=axis, angle=angle, of=of: Quaternion.from_axis_angle(of(axis), angle),
            error,
            call=f"Quaternion.from_axis_angle({name}{short(axis)}, {angle!r})",
            cause=f"{problem} Raise {error.__name__}.",
            allowed=lambda: Quaternion.from_axis_angle(Vector3(0.0, 1.0, 1.0), 1.0),
        )


def expect_axis_and_angle(
    a: Quad, wanted: tuple[Triple, float], cause: str, *slips: dict[str, Any], near: float = TIGHT
) -> None:
    """Expect these results of to_axis_angle. ``slips`` are those of the angle and the axis."""
    (unit_axis, turn), (angles, axes) = wanted, slips or (None, None)
    with calls(cause):
        q = Quaternion(*a)
        axis, angle = q.to_axis_angle()
    first = "You return the angle first. Return the axis and then the angle."
    got = expect_vector(axis, then="; axis", cause=first if isinstance(axis, float) else cause)
    expect_kept("q", rijk(q), a)
    expect_close(angle, turn, angles, then="; angle", unit="rad", tolerance=near)
    got = same_sign(got, unit_axis) if a[0] == 0.0 else got
    expect_close(got, unit_axis, axes, then="; axis", tolerance=TIGHT if near else 0.0)


@pytest.mark.exercise(
    "B9.9", asks="a new unit vector, and an angle from 0 to pi", weight=2, read=BACK
)
def test_axis_and_angle_of_a_quaternion(rng: Random) -> None:
    for sign in (1.0, -1.0, 1.0 + 1e-14):  # the last is a length after rounding
        axis, angle = vector(rng), positive_number(rng, 0.3, 2.8)
        r, i, j, k = (sign * component for component in quad(axis, angle))
        cause = "The angle is 2 atan2(|(i, j, k)|, |r|), and the axis is (i, j, k), normalized."
        opposite = "Your axis points in the opposite direction."
        if r < 0.0:
            cause += " If r is negative, use -q, which is the same rotation."
            opposite += " If r is negative, reverse the axis too, because -q is the same rotation."
        angles = {
            "You return half of the angle. Double it.": 0.5 * angle,
            "Your angle is greater than pi, so it is the longer way around.": math.tau - angle,
            "You return the angle in degrees. Return it in radians.": math.degrees(angle),
            "Your angle has the wrong sign.": -angle,
            "You return half of the angle for the longer way around.": math.pi - 0.5 * angle,
            "Your angle is pi minus the right one, because you treat r as the sine of half the "
            "angle. Either you swap the two arguments of atan2, or you use asin(r). The sine is "
            "the length of (i, j, k), and it is the first argument of atan2.": math.pi - angle,
        }
        u = axis / abs(axis)
        axes = {opposite: -u, "You return (i, j, k) without normalizing it.": (i, j, k)}
        expect_axis_and_angle((r, i, j, k), (u, angle), cause, angles, axes)


@pytest.mark.exercise("B9.9", asks="any axis would be correct, so return X", read=BACK)
def test_axis_and_angle_at_the_ends(rng: Random) -> None:
    drawn = vector(rng)
    u = drawn / abs(drawn)
    no_axis = "A rotation by 0 has no axis. By convention, return the X axis and the angle 0."
    for r in (1.0, -1.0):
        expect_axis_and_angle((r, 0.0, 0.0, 0.0), (X_AXIS, 0.0), no_axis, near=0.0)
    asin = "You compute the angle with asin, which loses half of its digits near pi. Use atan2."
    half = "Here r is 0, so the angle is pi. The axis may point in either direction. Don't compute "
    half += "the angle with asin, which loses half of its digits near pi. Use atan2."
    expect_axis_and_angle((0.0, *u), (u, math.pi), half)
    for less in (1e-3, 1e-6):
        expect_axis_and_angle(quad(u, math.pi - less), (u, math.pi - less), asin)
    acos = "Either you compute the angle with acos, which fails near 0, because the cosine rounds "
    acos += "to 1, or you treat a small angle as 0. Use atan2 for all angles."
    for small in (1e-5, 1e-9):
        # The sine differs from the angle by its cube only, 1e-11 of it or less here.
        q = (1.0, *(0.5 * small * u))
        expect_axis_and_angle(q, (u, small), acos, near=1e-10 * small)


@pytest.mark.exercise("B9.9", asks="for angles as small as 1e-200", read=BACK)
@pytest.mark.robust
def test_axis_and_angle_of_the_smallest_turn(rng: Random) -> None:
    drawn = vector(rng)
    u = drawn / abs(drawn)
    cause = "The squares of the components round to 0. Use magnitude() and normalize()."
    expect_axis_and_angle((1.0, *(5e-201 * u)), (u, 1e-200), cause, near=1e-210)


@pytest.mark.exercise("B9.9", asks="for every length that is_unit accepts", weight=0.5, read=BACK)
def test_axis_and_angle_though_the_length_is_a_little_off(rng: Random) -> None:
    drawn = draw_quad(rng)
    u = Triple(drawn[1:]) / math.hypot(*drawn[1:])
    cause = "is_unit() accepts this length, which is not exactly 1. Use atan2, which does, too."
    for off in (1.0 + 5e-7, 1.0 - 5e-7):
        for whole, axis in ((drawn, u), ((0.0, *u), u), ((1.0, 0.0, 0.0, 0.0), X_AXIS)):
            q = tuple(component * off for component in whole)
            angle = 2.0 * math.atan2(math.hypot(*q[1:]), q[0])
            expect_axis_and_angle(q, (axis, angle), cause, near=1e-5)


@pytest.mark.exercise(
    "B9.9", asks="Convert the rotation to an axis, which is a new", weight=0.5, read=BACK
)
def test_each_axis_is_a_new_vector() -> None:
    with calls("You return the same X vector from every call. Return a new vector each time."):
        axis, _ = Quaternion().to_axis_angle()
        axis.invert()
        axis, _ = Quaternion().to_axis_angle()
    expect_close(xyz(axis), X_AXIS, then="; axis", tolerance=0.0)


@pytest.mark.exercise("B9.9", asks="if the length is not 1 (is_unit)", read=BACK)
@pytest.mark.robust
def test_to_axis_angle_rejects_all_but_unit_quaternions(rng: Random) -> None:
    q = draw_quad(rng)
    for length in (1.0 + 2e-6, 1.0 - 2e-6, 0.0, 2.0, math.nan):
        scaled = tuple(component * length for component in q)
        expect_error(
            lambda scaled=scaled: Quaternion(*scaled).to_axis_angle(),
            ValueError,
            call=f"q = Quaternion{short(scaled)}, whose length is {length}; q.to_axis_angle()",
            cause="The length of this quaternion is not 1, so it is not a rotation. Call is_unit() "
            "first, and raise ValueError if it returns False.",
            allowed=lambda: [
                Quaternion(*(component * near for component in q)).to_axis_angle()
                for near in (1.0 + 5e-7, 1.0 - 5e-7)
            ],
        )


def stepped(q: Quad, change: Quad, scale: float) -> Quad:
    """Return q + scale * change."""
    return tuple(old + scale * new for old, new in zip(q, change, strict=True))


def by_vector_slips(q: Quad, a: Triple) -> dict[str, Quad]:
    """Return the results of likely mistakes in rotate_by."""
    left, right, size = hamilton((0.0, *a), q), hamilton(q, (0.0, *a)), abs(a)
    turn, in_turn = quad(a, size), [*q]
    for place in range(4):
        in_turn[place] = hamilton(turn, in_turn)[place]
    make = "Make a rotation from the vector with from_axis_angle."
    book = f"as in the book's listing. (0, vector) is not a rotation (E-12). {make}"
    first_order = f"which is only accurate to first order (E-12). {make}"
    angles = {
        "You rotate by half the angle.": 0.5 * size,
        "You rotate by twice the angle.": 2.0 * size,
        "You rotate by 1 radian, no matter how long the vector is.": 1.0,
        "You rotate in the opposite direction.": -size,
        "You use the squared length as the angle. Use the length itself.": size * size,
    }
    slips = {slip: hamilton(quad(a, angle), q) for slip, angle in angles.items()}
    for slip, wrong in (
        (f"You multiply q by (0, vector){{}}, {book}", right),
        ("You multiply (0, vector) by q{}, but (0, vector) is not a rotation (E-12).", left),
        (f"You use Eq. 9.9{{}}, {first_order}", stepped(q, left, 0.5)),
    ):
        slips |= {slip.format(""): wrong, slip.format(" and normalize"): unit(wrong)}
    return slips | {
        "You rotate about the object's own axes. Either the new rotation is on the right of q, or "
        "you rotate the vector by q first. Use the vector as it is, with the new rotation on the "
        "left.": hamilton(q, turn),
        "You replace the old orientation by the new rotation.": turn,
        "You add the new rotation to q. Multiply it by q instead.": stepped(q, turn, 1.0),
        "You change a component of q before you have computed the others.": tuple(in_turn),
        "The quaternion hasn't changed. Assign the new values to self.r, self.i and so on.": q,
    }


@pytest.mark.exercise(
    "B9.11", asks="Rotate the orientation in place by the rotation", weight=2, read=BY_VECTOR
)
def test_rotates_a_quaternion_by_a_vector(rng: Random) -> None:
    for size in (0.3, 1.0, 9.0):
        b, a = draw_quad(rng), size * vector(rng)
        with calls(
            "Make a rotation with from_axis_angle, where the vector is the axis and its length is "
            "the angle. Put it on the left of q, because the vector is in world coordinates."
        ):
            q, v = Quaternion(*b), Vector3(*a)
            returned = q.rotate_by(v)
        wanted = hamilton(quad(a, abs(a)), b)
        slips = {name: same_sign(slip, wanted) for name, slip in by_vector_slips(b, a).items()}
        got = same_sign(rijk(q), wanted)
        expect_close(got, wanted, slips, then="; q", tolerance=1e-11)
        expect_kept("the vector", v, a)
        expect_exactly(returned, None, cause=NOTHING)


@pytest.mark.exercise("B9.11", asks="To make an exact step, build a quaternion", read=BY_VECTOR)
def test_a_steady_rotation_is_exact_in_any_number_of_parts() -> None:
    for parts in (1, 7, 100):
        with calls(
            "You don't rotate by exactly the length of the vector, so the errors of all calls add "
            "up. Make an exact rotation from the vector.",
            f"{parts} times q.rotate_by(Vector3(0.3, -0.5, 0.8) * 2 / {parts}), from Quaternion()",
        ):
            got = in_parts((0.3, -0.5, 0.8), 2.0, parts)
        # Eight decimals of SciPy's Rotation.from_rotvec.
        wanted = (0.54873208, 0.25334573, -0.42224289, 0.67558862)
        expect_close(same_sign(got, wanted), wanted, tolerance=1e-8)


def expect_tiny_turn(tiny: float) -> None:
    """Expect rotate_by to add half of a very small vector."""
    every = "Rotate by every angle, no matter how small."
    with calls(f"You treat this small angle as 0. {every}"):
        q = Quaternion()
        q.rotate_by(Vector3(0.0, tiny, 0.0))
    got = same_sign(rijk(q), (1.0, 0.0, 0.0, 0.0))[2] / tiny
    why = f"{every} Here (i, j, k) becomes half the vector." if got else about.cause
    expect_close(got, 0.5, then=f"; q.j / {tiny}", cause=why, tolerance=TIGHT)


@pytest.mark.exercise("B9.11", asks="so a zero vector changes nothing", read=BY_VECTOR)
def test_rotates_by_a_zero_or_tiny_vector(rng: Random) -> None:
    a = draw_quad(rng)
    with calls("A zero vector has no direction, so leave the quaternion unchanged."):
        q = Quaternion(*a)
        q.rotate_by(Vector3(0.0, 0.0, 0.0))
    # Normalizing at the end causes a rounding error here.
    expect_close(rijk(q), a, then="; q", tolerance=TIGHT)
    expect_tiny_turn(1e-9)


@pytest.mark.exercise("B9.11", asks="for vectors as short as 1e-200", read=BY_VECTOR)
@pytest.mark.robust
def test_rotates_by_an_extremely_short_vector() -> None:
    expect_tiny_turn(1e-200)


def add_slips(q: Quad, a: Triple, scale: float) -> dict[str, Quad]:
    """Return the results of likely mistakes in add_scaled."""
    left, half, in_turn = hamilton((0.0, *a), q), 0.5 * scale, [*q]
    for place in range(4):
        in_turn[place] += half * hamilton((0.0, *a), in_turn)[place]
    changes = {
        "You leave out the factor 1/2 of Eq. 9.5. Add scale/2 times the product (0, vector) q to "
        "q.": (left, scale),
        "You don't multiply the vector by the scale.": (left, 0.5),
        "Your quaternion of the vector has r = 1.": (hamilton((1.0, *a), q), half),
        "The quaternion of your scaled vector has r = 1.": (hamilton((1.0, *(scale * a)), q), 0.5),
        "You rotate about an axis of the object instead of the world, because you compute q (0, "
        "vector). Swap the two factors.": (hamilton(q, (0.0, *a)), half),
        "You multiply by the scale twice. Eq. 9.5 contains it only once.": (left, half * scale),
        "You divide by 2 twice. Eq. 9.5 contains the factor 1/2 only once.": (left, 0.5 * half),
        "You subtract the change from q. Add it instead.": (left, -half),
        "You add (0, vector) alone, without multiplying it by q.": ((0.0, *a), half),
    }
    slips = {slip: stepped(q, *change) for slip, change in changes.items()}
    return slips | {
        "You normalize the result. Leave out the normalization, because later exercises measure "
        "how much a step of Eq. 9.5 changes the length (E-31).": unit(stepped(q, left, half)),
        "You rotate exactly, as rotate_by does. add_scaled takes the first-order step of Eq. 9.5 "
        "instead: it adds scale/2 times (0, vector) q to q.": hamilton(quad(a, scale * abs(a)), q),
        "You use components of q that you have already changed.": in_turn,
        "You lose the old q. Add the change to it.": tuple(half * part for part in left),
        "The quaternion hasn't changed. Assign the new values to self.r, self.i and so on.": q,
    }


@pytest.mark.exercise("B9.11", asks="Do not normalize the result", weight=2, read=ADD)
def test_the_step_of_the_book(rng: Random) -> None:
    size = positive_number(rng, 0.01, 0.9)
    for scale in (-size, size):
        b, a = draw_quad(rng), vector(rng)
        cause = "Add scale/2 times the product (0, vector) q to q. Compute all four components "
        cause += "from the old q before you assign them."
        with calls(cause):
            q, v = Quaternion(*b), Vector3(*a)
            returned = q.add_scaled(v, scale)
        wanted = stepped(b, hamilton((0.0, *a), b), 0.5 * scale)
        why = named(rijk(q), cause, add_slips(b, a, scale), wanted)
        expect_close(rijk(q), wanted, then="; q", cause=why, tolerance=TIGHT)
        expect_kept("the vector", v, a)
    expect_exactly(returned, None, cause=NOTHING)
