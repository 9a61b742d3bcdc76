"""Euler angles, angular velocity, and the drift of Eq. 9.5: build tasks B9.17 to B9.19."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch09_rotations.angular import first_order_drift, integrate_rotation, velocity_of_point
from ch09_rotations.euler import euler_rates, euler_to_quaternion, rate_map
from ch09_rotations.probes import steps
from ch09_rotations.quaternion import Quaternion
from draw import Triple, number, positive_number, vector
from expect import (
    about,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    expect_vector,
)
from turning import (
    IDENTITY,
    TIGHT,
    X_AXIS,
    Y_AXIS,
    Z_AXIS,
    Nine,
    Quad,
    applied,
    draw_quad,
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
POINT = "book 9.3.1, Eq. 9.6"
STEP = "the docstring of integrate_rotation"
DRIFT = "the docstring of first_order_drift, and E-31"


# B9.17 Euler angles


def draw_angles(rng: Random) -> Triple:
    """Draw three angles away from zero, the middle one also away from a quarter turn."""
    return Triple((number(rng, 0.3, 2.9), number(rng, 0.3, 1.2), number(rng, 0.3, 2.9)))


def in_order(angles: Triple, order: str = "ZYX") -> Quad:
    """Return the product of rotations about axes of the world, of which the last comes first."""
    first, second, last = ("XYZ".index(letter) for letter in order)
    turns = [quad(axis, t) for axis, t in zip((X_AXIS, Y_AXIS, Z_AXIS), angles, strict=True)]
    return hamilton(turns[first], hamilton(turns[second], turns[last]))


def map_of(_x: float, y: float, z: float) -> Nine:
    """Return the axes of the three angles as columns. They do not depend on the first angle."""
    turn = quad(Z_AXIS, z)
    axes = turned(turn, turned(quad(Y_AXIS, y), X_AXIS)), turned(turn, Y_AXIS), Z_AXIS
    return transposed([part for axis in axes for part in axis])


@pytest.mark.exercise("B9.17", asks="by x about X, by y about Y, then by z about Z", read=ANGLES)
def test_one_turn_after_another(rng: Random) -> None:
    x, y, z = draw_angles(rng)
    far = math.copysign(math.pi - abs(y), y)
    for angles in ((x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z), (x, y, z), (x, far, z)):
        x, y, z = angles
        with calls(
            "The product should be Z Y X, so that the object rotates about X first, then Y, then Z."
        ):
            q = euler_to_quaternion(x, y, z)
        wanted = in_order(angles)
        slips = {
            f"You multiply the rotations in the order {' '.join(order)}.": in_order(angles, order)
            for order in ("XYZ", "XZY", "YXZ", "YZX", "ZXY")
        } | {
            "You rotate in the opposite direction. Keep the signs of the angles.":
                in_order((-x, -y, -z)),
            "You treat the angles as degrees. They are in radians.":
                in_order(map(math.radians, angles)),
            "You halve the angles. from_axis_angle already does this, so pass whole angles.":
                in_order((0.5 * x, 0.5 * y, 0.5 * z)),
            "You use the three angles as one rotation vector. Multiply three rotations.":
                quad(angles, math.hypot(*angles)),
            "You swap x and z.": in_order((z, y, x)),
        }  # fmt: skip
        slips = {name: same_sign(slip, wanted) for name, slip in slips.items()}
        expect_close(same_sign(rijk(q), wanted), wanted, slips, tolerance=TIGHT)


@pytest.mark.exercise("B9.17", asks="Each column of the matrix is the axis", read=RATES)
def test_the_rate_map(rng: Random) -> None:
    drawn, (_, tilt, _) = draw_angles(rng), draw_angles(rng)
    for x, y, z in (drawn, -drawn, (0.4, math.pi - tilt, -1.9), (0.4, 0.5 * math.pi, -0.7)):
        with calls(
            "Column 1 should be the X axis after the rotations by y and z. Column 2 should be the "
            "Y axis after the rotation by z, and column 3 the Z axis."
        ):
            m = rate_map(x, y, z)
        got, wanted = entries(m), map_of(x, y, z)
        r, *back = in_order((x, y, z))
        own = [turned((r, *(-c for c in back)), wanted[column::3]) for column in range(3)]
        slips = {
            "You return the identity, as if the rates were the angular velocity.": IDENTITY,
            "Your matrix has the rotation axes as rows. Write them as columns.": transposed(wanted),
            "You use the axes of the object instead of the world.":
                transposed([part for axis in own for part in axis]),
            "the rotation matrix of the three angles": matrix_of(in_order((x, y, z))),
            "the map with its columns in reverse order":
                [wanted[3 * row + column] for row in range(3) for column in (2, 1, 0)],
            "the map with y and z swapped": map_of(x, z, y),
        }  # fmt: skip
        if math.cos(y) < 0.0:
            slips[
                "You use a positive cos y, but here it is negative. Use math.cos(y), not the "
                "square root of 1 - sin(y)^2."
            ] = [-n if place in (0, 3) else n for place, n in enumerate(wanted)]
        why = named(got, about.cause, slips, wanted)
        expect_close(got, wanted, then=", row by row", cause=why, tolerance=TIGHT)


@pytest.mark.exercise(
    "B9.17", asks="Compute how fast the three Euler angles must change", read=BACK
)
def test_the_rates_produce_the_angular_velocity(rng: Random) -> None:
    w = vector(rng)
    multiply = "Multiply the angular velocity by the inverse of rate_map(x, y, z)."
    drawn = draw_angles(rng)  # first for a plain message, last for the code after the loop
    for angles in (drawn, (0.4, 2.5, 0.7), (0.4, -2.5, 0.7), (0.4, 4.0, 0.7), drawn):
        x, y, z = angles
        cause = "These angles are not gimbal lock, so the rates exist. Raise an error only if "
        cause += "|cos y| is at most SINGULAR."
        if math.cos(y) < 0.0:
            cause = f"You reject a negative cos y, which is {math.cos(y):.3g} here. Compare its "
            cause += "absolute value with SINGULAR."
        with calls(cause):
            velocity = Vector3(*w)
            rates = euler_rates(x, y, z, velocity)
        there, found = map_of(x, y, z), expect_vector(rates, cause=multiply)
        slips = {
            "the angular velocity itself": w,
            "You multiply the angular velocity by rate_map(x, y, z). Multiply by the inverse of "
            "this matrix instead.": applied(there, w),
            "You multiply by the transpose of rate_map(x, y, z) instead of its inverse. The two "
            "differ, because this matrix is not a rotation.": applied(transposed(there), w),
        }
        why = named(found, multiply, slips)
        then = "; the angular velocity that results from these rates"
        expect_close(applied(there, found), w, then=then, cause=why, tolerance=1e-11)
    expect_kept("angular_velocity", velocity, w)
    q, step = in_order(drawn), 1e-6
    end = in_order(drawn + step * Triple(found))
    got = Triple(hamilton(end, (q[0], -q[1], -q[2], -q[3]))[1:]) * (2.0 / step)
    then = f"; the angles change at these rates for {step} s; the rotation per second"
    why = f"Your rates don't produce this angular velocity. {multiply}"
    # First order in the step: 1e-6 of the square of rates of up to some 50.
    expect_close(got, w, then=then, cause=why, tolerance=0.05)


def draw_locked(rng: Random) -> tuple[float, float, Triple]:
    """Draw the first and third angle for a quarter turn of the second, and a velocity."""
    # The product of the rows' lengths is then 0.55 to 0.66. Ten times SINGULAR of it exceeds 5e-13.
    return number(rng, 0.3, 2.9), number(rng, 0.45, 0.6), vector(rng)


def expect_rates_near_lock(x: float, z: float, w: Triple, off: float) -> None:
    """Expect rates when the second angle is ``off`` a quarter turn."""
    with calls(
        f"These angles are close to gimbal lock, but |cos y| is {abs(off)}, which is greater than "
        "SINGULAR (1e-13). So return the rates."
    ):
        rates = euler_rates(x, math.pi / 2 + off, z, Vector3(*w))
    expect_vector(rates)


@pytest.mark.exercise("B9.17", asks="Near gimbal lock, the rates become very large", read=BACK)
def test_near_gimbal_lock_there_are_rates(rng: Random) -> None:
    x, z, w = draw_locked(rng)
    for off in (1e-6, -1e-6):
        expect_rates_near_lock(x, z, w, off)


@pytest.mark.exercise("B9.17", asks="which means that |cos y| is at most", read=BACK)
@pytest.mark.robust
def test_rejects_gimbal_lock_but_not_angles_near_it(rng: Random) -> None:
    x, z, w = draw_locked(rng)
    quarter = 0.5 * math.pi
    for off in (5e-13, -5e-13):
        expect_rates_near_lock(x, z, w, off)
    raise_it = "unless abs(cos y) > SINGULAR."
    near, far = quarter - 2e-14, quarter + 2e-14
    for y, turn in (
        *((quarter, z), (-quarter, z), (quarter, 0.0), (3.0 * quarter, z), (3.0 * quarter, 0.0)),
        *((near, 0.0), (near, z), (far, z)),
    ):
        cause = "This is gimbal lock: y is a quarter turn, so there are no rates. Raise ValueError "
        if turn == 0.0:
            cause = "Matrix3.inverse doesn't detect this gimbal lock. Raise ValueError yourself "
        expect_error(
            lambda y=y, turn=turn: euler_rates(x, y, turn, Vector3(*w)),
            ValueError,
            call=f"euler_rates({x}, {y}, {turn}, Vector3{short(w)})",
            cause=cause + raise_it,
            allowed=lambda: [
                euler_rates(x, allowed, z, Vector3(*w))
                for allowed in (quarter - 1e-6, 1e-6 - quarter, quarter - 5e-13, quarter + 5e-13)
            ],
        )


# B9.18 The velocity of a point, and a step of a rotation


@pytest.mark.exercise("B9.18", asks="Compute the velocity of a point on an object", read=POINT)
def test_a_point_of_a_rotating_object() -> None:
    with calls("Compute w x (q - p). The rotation moves a point on the X axis along +Y."):
        q, p, w = Vector3(1.0, 0.0, 0.0), Vector3(), Vector3(0.0, 0.0, 2.0)
        got = velocity_of_point(q, p, Vector3(), w)
    slips = {
        "Your point rotates in the wrong direction. The vector product is w x (q - p), in exactly "
        "this order.": (0.0, -2.0, 0.0),
        "the velocity without any rotation": (0.0, 0.0, 0.0),
        "the angular velocity itself": (0.0, 0.0, 2.0),
    }
    expect_close(got, (0.0, 2.0, 0.0), slips)


@pytest.mark.exercise(
    "B9.18", asks="a new vector in m/s, and the arguments do not change", read=POINT
)
def test_a_point_of_a_moving_and_rotating_object(rng: Random) -> None:
    point, place, speed, spin = vector(rng), vector(rng), vector(rng), vector(rng)
    with calls(
        "The point moves with the object and also rotates about the object's position p, so its "
        "velocity is w x (q - p) + p'."
    ):
        q, p, v, w = Vector3(*point), Vector3(*place), Vector3(*speed), Vector3(*spin)
        got = velocity_of_point(point=q, position=p, velocity=v, angular_velocity=w)
    spun, about_world = spin.cross(point - place), spin.cross(point)
    slips = {
        "You leave out p', the velocity of the object itself.": spun,
        "You compute w x q, so the point rotates about the world's origin. Compute w x (q - p), "
        "where p is the object's position.": about_world + speed,
        "You subtract the velocity p'. Add it instead.": spun - speed,
        "You return only p', without the rotation.": speed,
        "You compute w x q - p + p'. Put parentheses around q - p.": about_world - place + speed,
        "You compute w x (q + p). Subtract p from q instead.": spin.cross(point + place) + speed,
        "You compute w x (q - p + p'). Add p' to the vector product, not inside it.":
            spin.cross(point - place + speed),
    }  # fmt: skip
    # Two products of up to 200 each.
    expect_close(got, spun + speed, slips, tolerance=1e-11)
    for name, now, before in (
        *(("point", q, point), ("position", p, place), ("velocity", v, speed)),
        ("angular_velocity", w, spin),
    ):
        expect_kept(name, now, before, "If you use += or -= on it, use + or - instead.")
    with calls(
        "You return p' itself, so a change of the result also changes p'. Return a new vector, "
        "even if nothing rotates.",
        more=True,
    ):
        velocity_of_point(q, p, v, Vector3(0.0, 0.0, 0.0)).invert()
    expect_unchanged("v", v, speed)


def step_slips(q: Quad, old: Triple, new: Triple, h: float) -> dict[str, Quad]:
    """Return the orientations that likely mistakes give after a step."""
    change = hamilton((0.0, *new), q)
    longer = tuple(a + 0.5 * h * b for a, b in zip(q, change, strict=True))
    gained = new - old  # alpha h
    slips = {
        "You rotate by the old w. Change w first, and then rotate by the new w.": h * old,
        "You rotate by the mean of the old and the new w.": 0.5 * h * (old + new),
        "You rotate by w + alpha. Multiply alpha by h before you add it.": h * (old + gained / h),
        "You rotate by the new w alone. Multiply it by h.": new,
        "You rotate by alpha h. Rotate by w h, where w is the new angular velocity.": gained,
    }
    return {name: hamilton(quad(turn, abs(turn)), q) for name, turn in slips.items()} | {
        "You use Eq. 9.5 and then normalize, which is accurate only to first order. Call rotate_by "
        "instead, which rotates exactly.": tuple(c / math.hypot(*longer) for c in longer),
        "You take a step of Eq. 9.5 (E-31). Rotate exactly instead, with rotate_by.": longer,
        "You rotate about an axis of the object. Rotate about w in world axes.":
            hamilton(q, quad(new, h * abs(new))),
        "The orientation hasn't changed. Change its components in place, as rotate_by does, "
        "because a new quaternion assigned to the parameter is lost.": q,
    }  # fmt: skip


@pytest.mark.exercise("B9.18", asks="then the orientation rotates by w' h", read=STEP)
def test_a_step_turns_by_the_new_angular_velocity(rng: Random) -> None:
    turn, spin, gain = draw_quad(rng), vector(rng), vector(rng)
    h = positive_number(rng, 0.05, 0.2)
    with calls("Change the components of w in place to those of w + alpha h."):
        q, w, alpha = Quaternion(*turn), Vector3(*spin), Vector3(*gain)
        returned = integrate_rotation(q, w, alpha, h)
    new = spin + h * gain
    slips = {
        "The angular velocity hasn't changed. Change the components of w in place, because a new "
        "vector assigned to the parameter is lost.": spin,
        "You add alpha without multiplying it by h.": spin + gain,
        "You replace w by alpha h instead of adding alpha h to it.": h * gain,
        "You multiply alpha by h^2. Multiply it by h only.": spin + h * h * gain,
        "You multiply w itself by h. Use w h only for the rotation.": h * new,
        "You subtract alpha h. Add it instead.": spin - h * gain,
    }
    expect_close(w, new, slips, then="; w", tolerance=TIGHT)
    wanted = hamilton(quad(new, h * abs(new)), turn)
    slips = step_slips(turn, spin, new, h)
    slips = {name: same_sign(slip, wanted) for name, slip in slips.items()}
    got = same_sign(rijk(q), wanted)
    why = named(got, "Rotate the orientation by the new w times h, with rotate_by.", slips)
    expect_close(got, wanted, then="; q", cause=why, tolerance=TIGHT)
    expect_kept("the acceleration", alpha, gain)
    none = "integrate_rotation works in place, so it shouldn't return anything."
    expect_exactly(returned, None, then=", the returned value", cause=none)


@pytest.mark.exercise("B9.18", asks="The step is semi-implicit Euler", read=STEP)
def test_many_steps_about_one_axis(rng: Random) -> None:
    axis = vector(rng)
    gain, h, count = number(rng, 0.2, 0.9), 0.01, 200
    w, a = 1.5 / abs(axis) * axis, gain / abs(axis) * axis
    with calls(
        "In each step, change w first, and then rotate exactly by the new w times h.",
        f"q = Quaternion(); w = Vector3{short(w)}; alpha = Vector3{short(a)}; {count} times "
        f"integrate_rotation(q, w, alpha, {h})",
    ):
        got, after, alpha = steps((1.0, 0.0, 0.0, 0.0), w, a, h, count)
    wanted = quad(axis, 1.5 * h * count + gain * h * h * count * (count + 1) / 2.0)
    # Rounding of 200 steps.
    expect_close(same_sign(got, wanted), wanted, then="; q", tolerance=1e-11)
    why = "Your angular velocity is wrong after these steps. Add alpha h in each step."
    expect_close(after, w + h * count * a, then="; w", cause=why, tolerance=1e-11)
    expect_kept("alpha", alpha, a)


@pytest.mark.exercise("B9.18", asks="After that it is normalized", read=STEP)
def test_a_step_leaves_the_length_at_one(rng: Random) -> None:
    for off in (1.001, 1.0 + 5e-7):
        turn = tuple(off * component for component in draw_quad(rng))
        with calls(
            "You don't normalize q, so the error in its length remains. Normalize q at the end of "
            "each step."
        ):
            q = Quaternion(*turn)
            integrate_rotation(q, Vector3(1.0, 2.0, 3.0), Vector3(), 0.1)
        then = f", from a length of {off}; the length of q"
        expect_close(math.hypot(*rijk(q)), 1.0, then=then, tolerance=TIGHT)


@pytest.mark.exercise("B9.18", asks="so a zero vector changes nothing", weight=0.5, read=STEP)
def test_a_step_from_rest(rng: Random) -> None:
    turn, gain, h = draw_quad(rng), vector(rng), 0.1
    for a, cause in (
        (
            Triple((0.0, 0.0, 0.0)),
            "The new angular velocity is 0, so there is no axis. Leave q as it is.",
        ),
        (gain, "w is zero at first, but alpha changes it. Rotate q by the new w."),
    ):
        with calls(cause):
            q, w = Quaternion(*turn), Vector3()
            integrate_rotation(q, w, Vector3(*a), h)
        new = h * a
        expect_close(w, new, then="; w", tolerance=TIGHT)
        wanted = hamilton(quad(new, h * abs(new)), turn) if any(new) else turn
        expect_close(same_sign(rijk(q), wanted), wanted, then="; q", tolerance=TIGHT)


# B9.19 The drift of Eq. 9.5


def drift_of(speed: float, duration: float, count: int) -> tuple[float, float]:
    """Return the length and the missing angle after steps of Eq. 9.5, one by one in the plane."""
    point, turned_by = complex(1.0, 0.0), 0.0
    for _ in range(count):
        new = point * complex(1.0, 0.5 * speed * duration / count)
        ratio = new / point
        turned_by += 2.0 * math.atan2(ratio.imag, ratio.real)
        point = new
    return abs(point), speed * duration - turned_by


def length_slips(turn: float, count: int) -> dict[str, float]:
    """Return the lengths that likely mistakes give."""
    step = turn / count
    growth = 1.0 + 0.25 * step * step
    return {
        "the squared length, without the square root": growth**count,
        "the length after a single step": math.sqrt(growth),
        "You add the same amount to the length in every step, instead of multiplying it.":
            1.0 + count * (math.sqrt(growth) - 1.0),
        f"You return 1 + {count} (w h)^2 / 8, which is only an approximation.":
            1.0 + 0.125 * count * step * step,
        "You use w h instead of w h / 2.": (1.0 + step * step) ** (0.5 * count),
        "You use the whole duration as h. Divide it by the number of steps.":
            math.exp(min(0.5 * count * math.log1p(0.25 * turn * turn), 700.0)),
        "You return how much longer the quaternion is. Return its length.":
            growth ** (0.5 * count) - 1.0,
    }  # fmt: skip


def lag_slips(right: float, turn: float, count: int) -> dict[str, float]:
    """Return the missing angles that likely mistakes give, out of a whole turn."""
    negative = " If the speed is negative, the angle is negative too." * (turn < 0.0)
    slips = {
        "You return half of the angle, because a quaternion contains half the angle of rotation. "
        "Double your result.": 0.5 * right,
        "Either you return the actual angle instead of subtracting it from the intended one, or "
        "you read the actual angle off the last quaternion, which shows at most half a turn. Add "
        "up the angles of the steps.": turn - right,
        "You use atan(w h) instead of 2 atan(w h / 2).": turn - count * math.atan(turn / count),
        f"Your angle has the wrong sign.{negative}": -right,
        "You return the angle in degrees. Return it in radians.": math.degrees(right),
    }
    if count > 2:
        slips["You return what a single step misses. Multiply it by the number of steps."] = (
            right / count
        )
    return slips


def expect_drift(
    speed: float, duration: float, count: int, length_wanted: float, lag_wanted: float, near: float
) -> None:
    """Expect the two results of first_order_drift, the length to within ``near``."""
    with calls(
        "Each step multiplies the length by sqrt(1 + (w h / 2)^2), where w is the angular speed, "
        "and h is the duration of a step."
    ):
        length, lag = first_order_drift(angular_speed=speed, duration=duration, steps=count)
    turn = speed * duration
    slips = length_slips(turn, count)
    slips["You swap the two results. Return the length first, and then the angle."] = lag_wanted
    then = "; length, that of the quaternion after all steps"
    expect_close(length, length_wanted, slips, then=then, tolerance=near)
    why = "A step should rotate by w h, but it rotates by only 2 atan(w h / 2). Return the sum of "
    why += "these differences over all steps."
    why = named(lag, why, lag_slips(lag_wanted, turn, count))
    then = "; lag, the angle by which the rotation lags behind"
    tolerance = TIGHT if count < 100 else 1e-10  # rounding of 500 steps
    expect_close(lag, lag_wanted, then=then, cause=why, unit="rad", tolerance=tolerance)


@pytest.mark.exercise("B9.19", asks="Return the length of the quaternion at the end", read=DRIFT)
def test_a_turn_a_second_in_sixty_frames() -> None:
    # Four decimals of the known figure of E-31.
    lag = math.tau - 120.0 * math.atan(math.pi / 60.0)
    expect_drift(math.tau, 1.0, 60, 1.0856, lag, near=5e-5)


@pytest.mark.exercise("B9.19", asks="This angle is negative for a negative speed", read=DRIFT)
def test_the_drift_of_a_few_rotations(rng: Random) -> None:
    for count, low, high in ((1, 0.2, 1.0), (7, 3.0, 9.0), (7, -9.0, -3.0), (500, 20.0, 30.0)):
        speed, duration = positive_number(rng, low, high), positive_number(rng, 0.5, 1.5)
        length, lag = drift_of(speed, duration, count)
        expect_drift(speed, duration, count, length, lag, near=1e-10 * length)


@pytest.mark.exercise("B9.19", asks="At a speed of 0 nothing rotates", read=DRIFT)
def test_no_drift_at_a_speed_of_zero() -> None:
    with calls("At a speed of 0 nothing rotates, so the length stays 1 and no angle is missing."):
        got = first_order_drift(angular_speed=0.0, duration=2.0, steps=10)
    expect_close(tuple(got), (1.0, 0.0), tolerance=TIGHT)
