"""Three angles for an orientation, build task B9.17."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.euler import euler_rates, euler_to_quaternion, rate_map
from draw import Components, components, number
from expect import (
    expect_close,
    expect_error,
    expect_finite_numbers,
    expect_unchanged,
    xyz,
)
from turning import (
    TIGHT,
    X_AXIS,
    Y_AXIS,
    Z_AXIS,
    Quad,
    applied,
    entries,
    hamilton,
    quad,
    rijk,
    same_sign,
    turned,
)

ANGLES = "book 9.2.1, and the first lines of euler.py"
RATES = "the docstring of rate_map"
BACK = "the docstring of euler_rates"


def draw_angles(rng: Random) -> Components:
    """Draw three angles, none near zero, and the middle one not near a quarter turn."""
    return number(rng, 0.3, 2.9), number(rng, 0.3, 1.2), number(rng, 0.3, 2.9)


def in_order(x: float, y: float, z: float) -> Quad:
    """Return the turn about X, then Y, then Z, axes of the world."""
    return hamilton(quad(Z_AXIS, z), hamilton(quad(Y_AXIS, y), quad(X_AXIS, x)))


def map_of(_x: float, y: float, z: float) -> tuple[float, ...]:
    """Return the axes of the three angles, as columns; the first angle has no part in them."""
    turn = quad(Z_AXIS, z)
    columns = (turned(turn, turned(quad(Y_AXIS, y), X_AXIS)), turned(turn, Y_AXIS), Z_AXIS)
    return tuple(column[row] for row in range(3) for column in columns)


@pytest.mark.exercise("B9.17")
def test_one_turn_after_another(rng: Random) -> None:
    read = ANGLES
    x, y, z = draw_angles(rng)
    far = math.copysign(math.pi - abs(y), y)
    cause = (
        "about X first, then Y, then Z, all axes of the world: the later turn stands on the left"
    )
    for angles in ((x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z), (x, y, z), (x, far, z)):
        call = f"euler_to_quaternion{angles}"
        wanted = in_order(*angles)
        got = same_sign(rijk(euler_to_quaternion(*angles)), wanted)
        expect_close(call, got, wanted, cause=cause, read=read, tolerance=TIGHT)


@pytest.mark.exercise("B9.17")
def test_what_the_rates_make(rng: Random) -> None:
    read = RATES
    drawn, (_, tilt, _) = draw_angles(rng), draw_angles(rng)
    steep = (0.4, math.pi - tilt, -1.9)
    for x, y, z in (drawn, tuple(-a for a in drawn), steep, (0.4, 0.5 * math.pi, -0.7)):
        wanted = map_of(x, y, z)
        call = f"rate_map({x}, {y}, {z})"
        cause = "a column for each angle's axis: Z stays, Y is turned by z, X by y and then by z"
        got = entries(rate_map(x, y, z))
        expect_close(call, got, wanted, cause=cause, read=read, tolerance=TIGHT)


@pytest.mark.exercise("B9.17")
def test_the_rates_of_the_angles_are_those_of_the_turning(rng: Random) -> None:
    read = BACK
    w = components(rng)
    velocity = Vector3(*w)
    cause = "what the inverse of the rate map makes of the angular velocity, beyond a quarter turn "
    cause += "too: only where |cos y| is next to nothing there is none"
    for y in (2.5, -2.5, 4.0):
        angles = (0.4, y, 0.7)
        call = f"euler_rates{(*angles, f'Vector3{w}')}"
        rates = xyz(euler_rates(*angles, velocity))
        got = applied(map_of(*angles), rates) if isinstance(rates, tuple) else rates
        expect_close(call, got, w, cause=cause, read=read, tolerance=1e-11)
    angles = draw_angles(rng)
    call = f"euler_rates{(*angles, f'Vector3{w}')}"
    cause = "what the inverse of the rate map makes of the angular velocity"
    rates = xyz(euler_rates(*angles, velocity))
    expect_close(call, applied(map_of(*angles), rates), w, cause=cause, read=read, tolerance=1e-11)
    expect_unchanged(call, "angular_velocity", xyz(velocity), w, read=read)
    step = 1e-6
    x, y, z = (angle + step * rate for angle, rate in zip(angles, rates, strict=True))
    q = in_order(*angles)
    got = hamilton(in_order(x, y, z), (q[0], -q[1], -q[2], -q[3]))
    call += f", after {step} s: the turn that they have made, per second"
    cause = "these rates do not make this angular velocity"
    # First order in the step: 1e-6 of the square of rates of up to some 50.
    got = tuple(2.0 * component / step for component in got[1:])
    expect_close(call, got, w, cause=cause, read=read, tolerance=0.05)


@pytest.mark.exercise("B9.17")
def test_gimbal_lock_is_refused_and_what_is_near_is_not(rng: Random) -> None:
    read = BACK
    x, z = number(rng, 0.3, 2.9), number(rng, 0.3, 2.9)
    w = components(rng)
    cause = "at a quarter turn two axes are one: ask abs(cos y) > SINGULAR. Matrix3.inverse "
    cause += "compares with the lengths of the rows, which may shrink with it"
    quarter = 0.5 * math.pi
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
        expect_error(
            f"euler_rates({x}, {y}, {turn}, Vector3{w})",
            lambda y=y, turn=turn: euler_rates(x, y, turn, Vector3(*w)),
            ValueError,
            allowed=lambda: [
                euler_rates(x, near, z, Vector3(*w))
                for near in (quarter - 1e-6, 1e-6 - quarter, quarter - 5e-13, quarter + 5e-13)
            ],
            cause=cause,
            read=read,
        )


@pytest.mark.exercise("B9.17", weight=0.5)
def test_angles_that_are_none_are_refused() -> None:
    expect_finite_numbers("euler_to_quaternion", euler_to_quaternion, (1, 1, 1), (), read=ANGLES)
    expect_finite_numbers("rate_map", rate_map, (1, 1, 1), (), read=ANGLES)
    expect_finite_numbers(
        "euler_rates(...), with its three angles ",
        lambda x, y, z: euler_rates(x, y, z, Vector3(1.0, 2.0, 3.0)),
        (1, 1, 1),
        (),
        read=ANGLES,
    )
    cause = "finite_vector of arguments.py refuses it"
    good = (1.0, 2.0, 3.0)
    for bad, error in (((1.0, math.nan, 3.0), ValueError), ((math.inf, 2.0, 3.0), ValueError)):
        expect_error(
            f"euler_rates(1, 1, 1, Vector3{bad})",
            lambda bad=bad: euler_rates(1, 1, 1, Vector3(*bad)),
            error,
            allowed=lambda: euler_rates(1, 1, 1, Vector3(*good)),
            cause=cause,
            read=ANGLES,
        )
    expect_error(
        "euler_rates(1, 1, 1, (1, 2, 3))",
        lambda: euler_rates(1, 1, 1, good),
        TypeError,
        allowed=lambda: euler_rates(1, 1, 1, Vector3(*good)),
        cause="three numbers are no Vector3",
        read=ANGLES,
    )
