"""Three angles for an orientation, build task B9.17."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.euler import euler_rates, euler_to_quaternion, rate_map
from draw import Components, components, number
from expect import (
    UNCHANGED,
    about,
    expect_close,
    expect_error,
    expect_finite_numbers,
    expect_unchanged,
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
    hamilton,
    named,
    quad,
    rijk,
    same_sign,
    transposed,
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


def map_to_own(x: float, y: float, z: float) -> tuple[float, ...]:
    """Return the axes of the three angles as the object has them, as columns."""
    r, *back = in_order(x, y, z)
    world = map_of(x, y, z)
    columns = [turned((r, *(-c for c in back)), world[column::3]) for column in range(3)]
    return tuple(column[row] for row in range(3) for column in columns)


@pytest.mark.exercise("B9.17")
def test_one_turn_after_another(rng: Random) -> None:
    about.read = ANGLES
    x, y, z = draw_angles(rng)
    far = math.copysign(math.pi - abs(y), y)
    about.cause = "about X first, then Y, then Z, all axes of the world: the later turn stands on "
    about.cause += "the left"
    for angles in ((x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z), (x, y, z), (x, far, z)):
        about.call = f"euler_to_quaternion{angles}"
        wanted = in_order(*angles)
        got = same_sign(rijk(euler_to_quaternion(*angles)), wanted)
        turns = [quad(axis, t) for axis, t in zip((X_AXIS, Y_AXIS, Z_AXIS), angles, strict=True)]
        slips = {
            f"the product {' '.join(names)} of the turns about these axes, not Z Y X": same_sign(
                hamilton(hamilton(*(turns["XYZ".index(name)] for name in names[:2])), last), wanted
            )
            for names in ("XYZ", "XZY", "YXZ", "YZX", "ZXY")
            for last in [turns["XYZ".index(names[2])]]
        }
        slips["the angles with the wrong sign"] = same_sign(in_order(*(-t for t in angles)), wanted)
        slips["made of degrees"] = same_sign(in_order(*map(math.radians, angles)), wanted)
        slips["about Z by x, and about X by z"] = same_sign(in_order(*angles[::-1]), wanted)
        why = named(got, about.cause, slips)
        expect_close(got, wanted, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("B9.17")
def test_what_the_rates_make(rng: Random) -> None:
    about.read = RATES
    drawn, (_, tilt, _) = draw_angles(rng), draw_angles(rng)
    steep = (0.4, math.pi - tilt, -1.9)
    for x, y, z in (drawn, tuple(-a for a in drawn), steep, (0.4, 0.5 * math.pi, -0.7)):
        wanted = map_of(x, y, z)
        about.call = f"rate_map({x}, {y}, {z})"
        about.cause = "a column for each angle's axis: Z stays, Y is turned by z, X by y and then "
        about.cause += "by z"
        got = entries(rate_map(x, y, z))
        slips = {
            "the identity, as if the rates were the angular velocity": IDENTITY,
            "the axes as rows, and they are the columns": transposed(wanted),
            "the map to axes of the object, not of the world": map_to_own(x, y, z),
            "the map with the last angle's axis first": [
                wanted[3 * row + column] for row in range(3) for column in (2, 1, 0)
            ],
            "the map of y and z exchanged": map_of(x, z, y),
        }
        why = named(got, about.cause, slips, wanted)
        expect_close(got, wanted, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("B9.17")
def test_the_rates_of_the_angles_are_those_of_the_turning(rng: Random) -> None:
    about.read = BACK
    w = components(rng)
    velocity = Vector3(*w)
    drawn = draw_angles(rng)  # first, for a plain message, and last, for what follows the loop
    for angles in (drawn, (0.4, 2.5, 0.7), (0.4, -2.5, 0.7), (0.4, 4.0, 0.7), drawn):
        x, y, z = angles
        about.call = f"euler_rates({x}, {y}, {z}, Vector3{w})"
        about.cause = "only where |cos y| is next to nothing there are no rates"
        if math.cos(y) < 0.0:
            about.cause += ": beyond a quarter turn too there are some, and cos y is "
            about.cause += f"{math.cos(y):.3g}"
        rates = xyz(euler_rates(*angles, velocity))
        about.cause = "the rates are the inverse of the rate map times the angular velocity"
        there = map_of(*angles)
        slips = {
            "the angular velocity as it was": w,
            "the rate map itself times it": applied(there, w),
            "the transpose times it, which is the inverse of rotations only": applied(
                transposed(there), w
            ),
        }
        about.cause = named(rates, about.cause, slips)
        got = applied(there, rates) if isinstance(rates, tuple) and len(rates) == 3 else rates
        expect_close(got, w, then=": the angular velocity that these rates make", tolerance=1e-11)
    expect_unchanged("angular_velocity", xyz(velocity), w, cause=UNCHANGED)
    step = 1e-6
    x, y, z = (angle + step * rate for angle, rate in zip(angles, rates, strict=True))
    q = in_order(*angles)
    got = hamilton(in_order(x, y, z), (q[0], -q[1], -q[2], -q[3]))
    about.call += f", after {step} s: the turn that they have made, per second"
    about.cause = "these rates do not make this angular velocity"
    # First order in the step: 1e-6 of the square of rates of up to some 50.
    got = tuple(2.0 * component / step for component in got[1:])
    expect_close(got, w, tolerance=0.05)


def draw_locked(rng: Random) -> tuple[float, float, Components]:
    """Draw the first and the third angle beside a quarter turn, and an angular velocity."""
    # The rows' lengths make 0.55 to 0.66 then: ten times SINGULAR of that is above 5e-13.
    return number(rng, 0.3, 2.9), number(rng, 0.45, 0.6), components(rng)


@scoped
def expect_rates_near_lock(x: float, z: float, w: Components, off: float) -> None:
    """Expect rates of the angles where the second one is so far off a quarter turn."""
    about(f"euler_rates({x}, pi / 2 + {off}, {z}, Vector3{w})", read=BACK)
    about.cause = f"this is near gimbal lock, and not in it: |cos y| is {abs(off)}, above "
    about.cause += "SINGULAR, 1e-13"
    rates = euler_rates(x, 0.5 * math.pi + off, z, Vector3(*w))
    expect_vector(rates)


@pytest.mark.exercise("B9.17")
def test_near_gimbal_lock_there_are_rates(rng: Random) -> None:
    x, z, w = draw_locked(rng)
    for off in (1e-6, -1e-6):
        expect_rates_near_lock(x, z, w, off)


@pytest.mark.exercise("B9.17")
@pytest.mark.robust
def test_gimbal_lock_is_refused_and_what_is_near_is_not(rng: Random) -> None:
    about.read = BACK
    x, z, w = draw_locked(rng)
    quarter = 0.5 * math.pi
    for off in (5e-13, -5e-13):
        expect_rates_near_lock(x, z, w, off)
    about.cause = "at a quarter turn two axes are one: ask abs(cos y) > SINGULAR. Matrix3.inverse "
    about.cause += "compares with the lengths of the rows, which may shrink with it"
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
            lambda y=y, turn=turn: euler_rates(x, y, turn, Vector3(*w)),
            ValueError,
            call=f"euler_rates({x}, {y}, {turn}, Vector3{w})",
            allowed=lambda: [
                euler_rates(x, near, z, Vector3(*w))
                for near in (quarter - 1e-6, 1e-6 - quarter, quarter - 5e-13, quarter + 5e-13)
            ],
        )


@pytest.mark.exercise("B9.17", weight=0.5)
@pytest.mark.robust
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
    about.cause = "finite_vector of arguments.py refuses it"
    good = (1.0, 2.0, 3.0)
    for bad, error in (((1.0, math.nan, 3.0), ValueError), ((math.inf, 2.0, 3.0), ValueError)):
        expect_error(
            lambda bad=bad: euler_rates(1, 1, 1, Vector3(*bad)),
            error,
            call=f"euler_rates(1, 1, 1, Vector3{bad})",
            allowed=lambda: euler_rates(1, 1, 1, Vector3(*good)),
            read=ANGLES,
        )
    expect_error(
        lambda: euler_rates(1, 1, 1, good),
        TypeError,
        call="euler_rates(1, 1, 1, (1, 2, 3))",
        allowed=lambda: euler_rates(1, 1, 1, Vector3(*good)),
        cause="three numbers are no Vector3",
        read=ANGLES,
    )
