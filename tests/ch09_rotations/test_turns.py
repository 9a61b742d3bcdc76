"""Quaternions, axes and angles: build task B9.9."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion
from draw import Components
from expect import (
    about,
    expect_close,
    expect_error,
    expect_vector,
    scoped,
    xyz,
)
from turning import (
    TIGHT,
    X_AXIS,
    Quad,
    draw_quad,
    draw_turn,
    expect_kept,
    named,
    quad,
    rijk,
    same_sign,
    short,
)

MAKE = "book 9.2.4, Eq. 9.4, and the docstring of from_axis_angle"
BACK = "the docstring of to_axis_angle"


def make_slips(axis: Components, angle: float) -> dict[str, Quad]:
    """Return the results of likely mistakes in from_axis_angle."""
    cosine, sine, length = math.cos(0.5 * angle), math.sin(0.5 * angle), math.hypot(*axis)
    r, *vector = quad(axis, angle)
    plain = (cosine, *(component * sine for component in axis))
    return {
        "You use half of the angle in the cosine, but the whole angle in the sine.": (
            cosine,
            *quad(axis, 2.0 * angle)[1:],
        ),
        "You use half of the angle in the sine, but the whole angle in the cosine.": (
            math.cos(angle),
            *vector,
        ),
        "You divide the angle by 4. Divide it by 2 only.": quad(axis, 0.5 * angle),
        "You put r last. It is the first argument of Quaternion.": (*vector, r),
        "You normalize the quaternion instead of the axis. Normalize the axis before you multiply "
        "it by the sine.": tuple(component / math.hypot(*plain) for component in plain),
        "You use the whole angle. Use half the angle instead.": quad(axis, 2.0 * angle),
        "You use the whole angle instead of half of it, and you don't normalize the axis.": (
            math.cos(angle),
            *(component * math.sin(angle) for component in axis),
        ),
        "You don't normalize the axis. Divide it by its length before you multiply it by the "
        "sine.": (cosine, *(c * sine for c in axis)),
        "You treat the angle as degrees. It is in radians.": quad(axis, math.radians(angle)),
        "You swap sine and cosine.": (sine, *(c / length * cosine for c in axis)),
        "You swap sine and cosine in r and i. r is cos(angle / 2), and i, j and k contain "
        "sin(angle / 2).": (
            sine,
            axis[0] / length * cosine,
            *(c / length * sine for c in axis[1:]),
        ),
        "Your r is sin(angle / 2). It should be cos(angle / 2).": (
            sine,
            *(c / length * sine for c in axis),
        ),
        "You use cos(angle / 2) for the vector part. Use sin(angle / 2).": (
            cosine,
            *(c / length * cosine for c in axis),
        ),
        "You don't multiply the axis by the sine.": (cosine, *(c / length for c in axis)),
        "Your rotation goes in the opposite direction.": quad(axis, -angle),
    }


@pytest.mark.exercise("B9.9", asks="Create the quaternion of a rotation by angle")
def test_the_quaternion_of_axis_and_angle(rng: Random) -> None:
    about("Quaternion.from_axis_angle(Vector3(1, 2, 3), 1.2)", read=MAKE)
    about.cause = "The scalar part is cos(angle / 2), and the vector part is the normalized axis "
    about.cause += "times sin(angle / 2)."
    got = rijk(Quaternion.from_axis_angle(Vector3(1.0, 2.0, 3.0), 1.2))
    why = named(got, about.cause, make_slips((1.0, 2.0, 3.0), 1.2))
    # Eight decimals of SciPy's Rotation.from_rotvec.
    wanted = (0.82533561, 0.15090705, 0.30181410, 0.45272115)
    expect_close(got, wanted, cause=why, tolerance=1e-8)
    axis, angle = draw_turn(rng)
    for t in (angle, -angle, 2.0 * math.pi + angle):
        v = Vector3(*axis)
        about.call = f"Quaternion.from_axis_angle(Vector3{short(axis)}, {t})"
        wanted = quad(axis, t)
        got = rijk(Quaternion.from_axis_angle(v, t))
        if t > math.pi:  # a rotation by t - 2 pi is the same, and has the opposite quaternion
            got = same_sign(got, wanted)
        why = named(got, about.cause, make_slips(axis, t))
        expect_close(got, wanted, cause=why, tolerance=TIGHT)
        expect_kept("the axis", xyz(v), axis)


@scoped
def expect_any_length(rng: Random, scale: float, cause: str) -> None:
    """Expect an axis that is scaled to make the same quaternion."""
    about(cause=cause, read=MAKE)
    axis, angle = draw_turn(rng)
    scaled = tuple(component * scale for component in axis)
    about.call = f"Quaternion.from_axis_angle(Vector3{short(scaled)}, {angle})"
    got = rijk(Quaternion.from_axis_angle(Vector3(*scaled), angle))
    expect_close(got, quad(axis, angle), tolerance=TIGHT)


@pytest.mark.exercise("B9.9", asks="Only the direction of the axis matters")
def test_the_length_of_the_axis_does_not_matter(rng: Random) -> None:
    expect_any_length(
        rng,
        1e-3,
        "You don't normalize the axis. Use a normalized copy of it.",
    )


@pytest.mark.exercise("B9.9", asks="so the axis may have any length except 0")
@pytest.mark.robust
def test_an_axis_may_be_huge_or_tiny(rng: Random) -> None:
    for scale in (1e200, 1e-200):
        about.cause = "You square the components, but their squares don't fit into a float. "
        about.cause += "Call normalized() on the axis instead, which works for any length."
        expect_any_length(rng, scale, about.cause)


@pytest.mark.exercise("B9.9", asks="if the axis is zero or a number is not finite")
@pytest.mark.robust
def test_rejects_an_invalid_axis_or_angle() -> None:
    about.read = MAKE
    for axis, angle, error, problem in (
        ((0.0, 0.0, 0.0), 1.0, ValueError, "The axis is zero, so it has no direction."),
        ((0.0, math.nan, 1.0), 1.0, ValueError, ""),
        ((0.0, math.inf, 1.0), 1.0, ValueError, "A component of the axis is infinite."),
        ((0.0, 1.0, 1.0), math.nan, ValueError, ""),
        ((0.0, 1.0, 1.0), math.inf, ValueError, "The angle is infinite."),
        ((0.0, 1.0, 1.0), "1.0", TypeError, "The angle is a string, not a number."),
    ):
        about.call = f"Quaternion.from_axis_angle(Vector3{short(axis)}, {angle!r})"
        about.cause = f"{problem} Raise {error.__name__}."
        expect_error(
            lambda axis=axis, angle=angle: Quaternion.from_axis_angle(Vector3(*axis), angle),
            error,
            allowed=lambda: Quaternion.from_axis_angle(Vector3(0.0, 1.0, 1.0), 1.0),
        )
    about.cause = "The axis is a tuple, not a Vector3, so raise TypeError."
    expect_error(
        lambda: Quaternion.from_axis_angle((0.0, 1.0, 1.0), 1.0),
        TypeError,
        call="Quaternion.from_axis_angle((0, 1, 1), 1.0)",
        allowed=lambda: Quaternion.from_axis_angle(Vector3(0.0, 1.0, 1.0), 1.0),
        read=MAKE,
    )


@scoped
def axis_angle_of(q: Quad) -> tuple:
    """Return the result of to_axis_angle as plain numbers."""
    about(f"q = Quaternion{short(q)}; q.to_axis_angle()", read=BACK)
    quaternion = Quaternion(*q)
    axis, angle = quaternion.to_axis_angle()
    if isinstance(axis, float):
        about.cause = "You return the angle first. Return the axis and then the angle."
    got = expect_vector(axis, then=", the axis")
    expect_kept("q", rijk(quaternion), q)
    return got, angle


@scoped
def expect_small_turn(unit: Components, small: float) -> None:
    """Expect the axis and angle of a rotation by a very small angle."""
    about.read = BACK
    x, y, z = (component * 0.5 * small for component in unit)
    about.call = f"q = Quaternion{short((1.0, x, y, z))}; q.to_axis_angle(), "
    got, turn = axis_angle_of((1.0, x, y, z))
    # The sine differs from the angle by its cube only, 1e-11 of it or less here.
    near = 1e-10 * small
    expect_close(turn, small, then="the angle in radians", tolerance=near)
    expect_close(got, unit, then="the axis", tolerance=TIGHT)


@pytest.mark.exercise("B9.9", asks="a new unit vector, and an angle from 0 to pi", weight=2)
def test_axis_and_angle_of_a_quaternion(rng: Random) -> None:
    about.read = BACK
    about.cause = "The angle is 2 atan2(|(i, j, k)|, |r|), and the axis is (i, j, k), normalized."
    for sign in (1.0, -1.0, 1.0 + 1e-14):  # the last is a length after rounding
        axis, angle = draw_turn(rng)
        length = math.hypot(*axis)
        wanted = tuple(component / length for component in axis)
        r, i, j, k = (sign * component for component in quad(axis, angle))
        about.call = f"q = Quaternion{short((r, i, j, k))}; q.to_axis_angle(), "
        opposite = "Your axis points in the opposite direction."
        if r < 0.0:
            about.cause += " If r is negative, use -q, which is the same rotation."
            opposite += " If r is negative, reverse the axis too, because -q is the same rotation."
        got, turn = axis_angle_of((r, i, j, k))
        slips = {
            "You return half of the angle. Double it.": 0.5 * angle,
            "Your angle is greater than pi, so it is the longer way around. If r is negative, use "
            "-q, which is the same rotation by the smaller angle.": math.tau - angle,
            "You return the angle in degrees. Return it in radians.": math.degrees(angle),
            "Your angle has the wrong sign.": -angle,
            "You return half of the angle for the longer way around.": math.pi - 0.5 * angle,
            "Your angle is pi minus the right one, because you treat r as the sine of half the "
            "angle. Either you swap the two arguments of atan2, or you use asin(r). The sine is "
            "the length of (i, j, k), and it is the first argument of atan2.": math.pi - angle,
        }
        why = named(turn, about.cause, slips)
        expect_close(turn, angle, then="the angle in radians", cause=why, tolerance=TIGHT)
        slips = {
            opposite: [-c for c in wanted],
            "You return (i, j, k) without normalizing it.": (i, j, k),
        }
        why = named(got, about.cause, slips)
        expect_close(got, wanted, then="the axis", cause=why, tolerance=TIGHT)


@pytest.mark.exercise("B9.9", asks="any axis would be correct, so return X")
def test_axis_and_angle_at_the_ends(rng: Random) -> None:
    about.read = BACK
    axis, _ = draw_turn(rng)
    length = math.hypot(*axis)
    unit = tuple(component / length for component in axis)
    about.cause = "A rotation by 0 has no particular axis. By convention, return the X axis and "
    about.cause += "the angle 0."
    for q in ((1.0, 0.0, 0.0, 0.0), (-1.0, 0.0, 0.0, 0.0)):
        about.call = f"q = Quaternion{short(q)}; q.to_axis_angle(), "
        got, turn = axis_angle_of(q)
        expect_close(turn, 0.0, then="the angle in radians", tolerance=0.0)
        expect_close(got, X_AXIS, then="the axis", tolerance=0.0)
    about.cause = "Here r is 0, so the angle is pi. The axis may point in either direction."
    by_asin = "You compute the angle with asin, which loses half of its digits near pi. Use atan2."
    q = (0.0, *unit)
    about.call = f"q = Quaternion{short(q)}; q.to_axis_angle(), "
    got, turn = axis_angle_of(q)
    why = by_asin if isinstance(turn, float) and abs(turn - math.pi) < 1e-6 else about.cause
    expect_close(turn, math.pi, then="the angle in radians", cause=why, tolerance=TIGHT)
    got = same_sign(got, unit)
    expect_close(got, unit, then="the axis", tolerance=TIGHT)
    about.cause = by_asin
    for less in (1e-3, 1e-6):
        q = quad(unit, math.pi - less)
        about.call = f"q = Quaternion{short(q)}; q.to_axis_angle(), "
        got, turn = axis_angle_of(q)
        wanted = math.pi - less
        expect_close(turn, wanted, then="the angle in radians", tolerance=TIGHT)
        expect_close(got, unit, then="the axis", tolerance=TIGHT)
    about.cause = (
        "Either you compute the angle with acos, which fails near 0, because the cosine rounds to "
        "1, or you treat a small angle as 0. Use atan2 for all angles."
    )
    for small in (1e-5, 1e-9):
        expect_small_turn(unit, small)


@pytest.mark.exercise("B9.9", asks="for angles as small as 1e-200")
@pytest.mark.robust
def test_axis_and_angle_of_the_smallest_turn(rng: Random) -> None:
    axis, _ = draw_turn(rng)
    length = math.hypot(*axis)
    unit = tuple(component / length for component in axis)
    about.cause = (
        "You square the components, but their squares round to 0. Use Vector3's magnitude() and "
        "normalize(), which work for vectors of any length."
    )
    expect_small_turn(unit, 1e-200)


@pytest.mark.exercise("B9.9", asks="for every length that is_unit accepts", weight=0.5)
def test_axis_and_angle_though_the_length_is_a_little_off(rng: Random) -> None:
    about.read = BACK
    drawn = draw_quad(rng)
    length = math.hypot(*drawn[1:])
    unit = tuple(component / length for component in drawn[1:])
    about.cause = (
        "Your result is wrong if the length is slightly above or below 1, which is_unit() accepts. "
        "Use atan2, which works for any length."
    )
    for off in (1.0 + 5e-7, 1.0 - 5e-7):
        for whole in (drawn, (0.0, *unit), (1.0, 0.0, 0.0, 0.0)):
            q = tuple(component * off for component in whole)
            about.call = f"q = Quaternion{short(q)}; q.to_axis_angle(), "
            got, turn = axis_angle_of(q)
            wanted = 2.0 * math.atan2(math.hypot(*q[1:]), q[0])
            expect_close(turn, wanted, then="the angle in radians", tolerance=1e-5)
            axis = X_AXIS if whole[0] == 1.0 else unit
            got = same_sign(got, axis)
            expect_close(got, axis, then="the axis", tolerance=TIGHT)


@pytest.mark.exercise("B9.9", asks="Convert the rotation to an axis, which is a new", weight=0.5)
def test_each_axis_is_a_new_vector() -> None:
    about.read = BACK
    about.call = "axis, _ = Quaternion().to_axis_angle(); axis.invert(); "
    about.call += "Quaternion().to_axis_angle()[0]"
    about.cause = (
        "You return the same X vector from every call, so a change of one result also changes the "
        "others. Return a new vector each time."
    )
    first, _ = Quaternion().to_axis_angle()
    first.invert()
    second, _ = Quaternion().to_axis_angle()
    expect_close(xyz(second), X_AXIS, tolerance=0.0)


@pytest.mark.exercise("B9.9", asks="if the length is not 1 (is_unit)")
@pytest.mark.robust
def test_to_axis_angle_rejects_all_but_unit_quaternions(rng: Random) -> None:
    about.read = BACK
    about.cause = "The length of this quaternion is not 1, so it is not a rotation. Call is_unit() "
    about.cause += "first, and raise ValueError if it returns False."
    q = draw_quad(rng)
    for length in (1.0 + 2e-6, 1.0 - 2e-6, 0.0, 2.0, math.nan):
        scaled = tuple(component * length for component in q)
        expect_error(
            lambda scaled=scaled: Quaternion(*scaled).to_axis_angle(),
            ValueError,
            call=f"q = Quaternion{short(scaled)}, whose length is {length}; q.to_axis_angle()",
            allowed=lambda: [
                Quaternion(*(component * near for component in q)).to_axis_angle()
                for near in (1.0 + 5e-7, 1.0 - 5e-7)
            ],
        )
