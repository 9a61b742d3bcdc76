"""Euler angles, build task B9.17."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.euler import euler_rates, euler_to_quaternion, rate_map
from draw import Components, components, number
from expect import (
    about,
    expect_close,
    expect_error,
    expect_vector,
    scoped,
    xyz,
)
from turning import (
    IDENTITY,
    TIGHT,
    X_AXIS,
    Y_AXIS,
    Z_AXIS,
    Quad,
    applied,
    entries,
    expect_kept,
    hamilton,
    matrix_of,
    named,
    quad,
    rijk,
    same_sign,
    short,
    transposed,
    turned,
)

ANGLES = "book 9.2.1, and the docstring at the top of euler.py"
RATES = "the docstring of rate_map"
BACK = "the docstring of euler_rates"


def draw_angles(rng: Random) -> Components:
    """Draw three angles away from zero, the middle one also away from a quarter turn."""
    return number(rng, 0.3, 2.9), number(rng, 0.3, 1.2), number(rng, 0.3, 2.9)


def in_order(x: float, y: float, z: float) -> Quad:
    """Return the rotation about X, then Y, then Z, which are axes of the world."""
    return hamilton(quad(Z_AXIS, z), hamilton(quad(Y_AXIS, y), quad(X_AXIS, x)))


def map_of(_x: float, y: float, z: float) -> tuple[float, ...]:
    """Return the axes of the three angles as columns. They do not depend on the first angle."""
    turn = quad(Z_AXIS, z)
    columns = (turned(turn, turned(quad(Y_AXIS, y), X_AXIS)), turned(turn, Y_AXIS), Z_AXIS)
    return tuple(column[row] for row in range(3) for column in columns)


def map_to_own(x: float, y: float, z: float) -> tuple[float, ...]:
    """Return the axes of the three angles as columns, in the axes of the object."""
    r, *back = in_order(x, y, z)
    world = map_of(x, y, z)
    columns = [turned((r, *(-c for c in back)), world[column::3]) for column in range(3)]
    return tuple(column[row] for row in range(3) for column in columns)


@pytest.mark.exercise("B9.17", asks="by x about X, by y about Y, then by z about Z")
def test_one_turn_after_another(rng: Random) -> None:
    about.read = ANGLES
    x, y, z = draw_angles(rng)
    far = math.copysign(math.pi - abs(y), y)
    about.cause = (
        "The product should be Z Y X, so that the object rotates about X first, then Y, then Z."
    )
    for angles in ((x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z), (x, y, z), (x, far, z)):
        about.call = f"euler_to_quaternion{short(angles)}"
        wanted = in_order(*angles)
        got = same_sign(rijk(euler_to_quaternion(*angles)), wanted)
        turns = [quad(axis, t) for axis, t in zip((X_AXIS, Y_AXIS, Z_AXIS), angles, strict=True)]
        slips = {
            f"You multiply the rotations in the order {' '.join(names)}.": same_sign(
                hamilton(hamilton(*(turns["XYZ".index(name)] for name in names[:2])), last), wanted
            )
            for names in ("XYZ", "XZY", "YXZ", "YZX", "ZXY")
            for last in [turns["XYZ".index(names[2])]]
        }
        slips["You rotate in the opposite direction. Keep the signs of the angles."] = same_sign(
            in_order(*(-t for t in angles)), wanted
        )
        slips["You treat the angles as degrees. They are in radians."] = same_sign(
            in_order(*map(math.radians, angles)), wanted
        )
        slips["You halve the angles. from_axis_angle already does this, so pass whole angles."] = (
            same_sign(in_order(*(0.5 * t for t in angles)), wanted)
        )
        slips["You use the three angles as one rotation vector. Multiply three rotations."] = (
            same_sign(quad(angles, math.hypot(*angles)), wanted)
        )
        slips["You swap x and z."] = same_sign(in_order(*angles[::-1]), wanted)
        why = named(got, about.cause, slips)
        expect_close(got, wanted, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("B9.17", asks="Each column of the matrix is the axis")
def test_the_rate_map(rng: Random) -> None:
    about.read = RATES
    drawn, (_, tilt, _) = draw_angles(rng), draw_angles(rng)
    steep = (0.4, math.pi - tilt, -1.9)
    for x, y, z in (drawn, tuple(-a for a in drawn), steep, (0.4, 0.5 * math.pi, -0.7)):
        wanted = map_of(x, y, z)
        about.call = f"rate_map({x}, {y:.6g}, {z}), row by row"
        about.cause = (
            "Column 1 should be the X axis after the rotations by y and z. Column 2 should be the "
            "Y axis after the rotation by z, and column 3 the Z axis."
        )
        got = entries(rate_map(x, y, z))
        slips = {
            "You return the identity, as if the rates were the angular velocity.": IDENTITY,
            "Your matrix has the rotation axes as rows. Write them as columns.": transposed(wanted),
            "You use the axes of the object instead of the world.": map_to_own(x, y, z),
            "the rotation matrix of the three angles": matrix_of(in_order(x, y, z)),
            "the map with its columns in reverse order": [
                wanted[3 * row + column] for row in range(3) for column in (2, 1, 0)
            ],
            "the map with y and z swapped": map_of(x, z, y),
        }
        if math.cos(y) < 0.0:
            slips[
                "You use a positive cos y, but here it is negative. Use math.cos(y), not the "
                "square root of 1 - sin(y)^2."
            ] = [-n if place in (0, 3) else n for place, n in enumerate(wanted)]
        why = named(got, about.cause, slips, wanted)
        expect_close(got, wanted, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("B9.17", asks="Compute how fast the three Euler angles must change")
def test_the_rates_produce_the_angular_velocity(rng: Random) -> None:
    about.read = BACK
    w = components(rng)
    velocity = Vector3(*w)
    drawn = draw_angles(rng)  # first for a plain message, last for the code after the loop
    for angles in (drawn, (0.4, 2.5, 0.7), (0.4, -2.5, 0.7), (0.4, 4.0, 0.7), drawn):
        x, y, z = angles
        about.call = f"rates = euler_rates({x}, {y}, {z}, Vector3{short(w)})"
        about.cause = (
            "These angles are not gimbal lock, so the rates exist. Raise an error only if |cos y| "
            "is at most SINGULAR."
        )
        if math.cos(y) < 0.0:
            about.cause = f"You reject a negative cos y, which is {math.cos(y):.3g} here. Compare "
            about.cause += "its absolute value with SINGULAR."
        rates = xyz(euler_rates(*angles, velocity))
        about.cause = "Multiply the angular velocity by the inverse of rate_map(x, y, z)."
        there = map_of(*angles)
        slips = {
            "the angular velocity itself": w,
            "You multiply the angular velocity by rate_map(x, y, z). Multiply by the inverse of "
            "this matrix instead.": applied(there, w),
            "You multiply by the transpose of rate_map(x, y, z) instead of its inverse. The two "
            "differ, because this matrix is not a rotation.": applied(transposed(there), w),
        }
        about.cause = named(rates, about.cause, slips)
        got = applied(there, rates) if isinstance(rates, tuple) and len(rates) == 3 else rates
        expect_close(got, w, then="; the angular velocity that results from rates", tolerance=1e-11)
    expect_kept("angular_velocity", xyz(velocity), w)
    step = 1e-6
    x, y, z = (angle + step * rate for angle, rate in zip(angles, rates, strict=True))
    q = in_order(*angles)
    got = hamilton(in_order(x, y, z), (q[0], -q[1], -q[2], -q[3]))
    about.call += f"; the angles change at these rates for {step} s; the rotation per second"
    about.cause = (
        "Your rates don't produce this angular velocity. Multiply the angular velocity by the "
        "inverse of rate_map(x, y, z)."
    )
    # First order in the step: 1e-6 of the square of rates of up to some 50.
    got = tuple(2.0 * component / step for component in got[1:])
    expect_close(got, w, tolerance=0.05)


def draw_locked(rng: Random) -> tuple[float, float, Components]:
    """Draw the first and third angle for a quarter turn of the second, and a velocity."""
    # The product of the rows' lengths is then 0.55 to 0.66. Ten times SINGULAR of it exceeds 5e-13.
    return number(rng, 0.3, 2.9), number(rng, 0.45, 0.6), components(rng)


@scoped
def expect_rates_near_lock(x: float, z: float, w: Components, off: float) -> None:
    """Expect rates when the second angle is ``off`` a quarter turn."""
    about(f"euler_rates({x}, pi / 2 + {off}, {z}, Vector3{short(w)})", read=BACK)
    about.cause = (
        f"These angles are close to gimbal lock, but |cos y| is {abs(off)}, which is greater than "
        "SINGULAR (1e-13). So return the rates."
    )
    rates = euler_rates(x, 0.5 * math.pi + off, z, Vector3(*w))
    expect_vector(rates)


@pytest.mark.exercise("B9.17", asks="Near gimbal lock, the rates become very large")
def test_near_gimbal_lock_there_are_rates(rng: Random) -> None:
    x, z, w = draw_locked(rng)
    for off in (1e-6, -1e-6):
        expect_rates_near_lock(x, z, w, off)


@pytest.mark.exercise("B9.17", asks="which means that |cos y| is at most")
@pytest.mark.robust
def test_rejects_gimbal_lock_but_not_angles_near_it(rng: Random) -> None:
    about.read = BACK
    x, z, w = draw_locked(rng)
    quarter = 0.5 * math.pi
    for off in (5e-13, -5e-13):
        expect_rates_near_lock(x, z, w, off)
    for y, turn in (
        (quarter, z),
        (-quarter, z),
        (quarter, 0.0),
        (3.0 * quarter, z),
        (3.0 * quarter, 0.0),
        (quarter - 2e-14, 0.0),
        (quarter - 2e-14, z),
        (quarter + 2e-14, z),
    ):
        about.cause = (
            "This is gimbal lock: y is a quarter turn, so there are no rates. Raise ValueError "
            "unless abs(cos y) > SINGULAR."
        )
        if turn == 0.0:
            about.cause = (
                "Matrix3.inverse doesn't detect this gimbal lock. Raise ValueError yourself unless "
                "abs(cos y) > SINGULAR."
            )
        expect_error(
            lambda y=y, turn=turn: euler_rates(x, y, turn, Vector3(*w)),
            ValueError,
            call=f"euler_rates({x}, {y}, {turn}, Vector3{short(w)})",
            allowed=lambda: [
                euler_rates(x, near, z, Vector3(*w))
                for near in (quarter - 1e-6, 1e-6 - quarter, quarter - 5e-13, quarter + 5e-13)
            ],
        )
