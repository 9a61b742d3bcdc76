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
from expect import about, expect_close, expect_error, expect_exactly, expect_vector, xyz
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
    times,
    transposed,
    turned,
)

ANGLES = "book 9.2.1, and the docstring at the top of euler.py"
RATES = "the docstring of rate_map"
BACK = "the docstring of euler_rates"
POINT = "book 9.3.1, Eq. 9.6"
STEP = "the docstring of integrate_rotation"
DRIFT = "the docstring of first_order_drift, and E-31"
ZERO = Triple((0.0, 0.0, 0.0))


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
        with calls("Return the product Z Y X, which rotates about X first, then Y, then Z."):
            q = euler_to_quaternion(x, y, z)
        wanted = in_order(angles)
        slips = {
            f"You multiply the rotations in the order {' '.join(order)}.": in_order(angles, order)
            for order in ("XYZ", "XZY", "YXZ", "YZX", "ZXY")
        } | {
            "You rotate in the opposite direction. Keep the signs.": in_order((-x, -y, -z)),
            "You treat the angles as degrees.": in_order(map(math.radians, angles)),
            "You halve the angles, but from_axis_angle does this.": in_order(Triple(angles) / 2.0),
            "You use the angles as one rotation vector.": quad(angles, math.hypot(*angles)),
            "You swap x and z.": in_order((z, y, x)),
        }
        slips = {name: same_sign(slip, wanted) for name, slip in slips.items()}
        expect_close(same_sign(rijk(q), wanted), wanted, slips, tolerance=TIGHT)


@pytest.mark.exercise("B9.17", asks="Each column of the matrix is the axis", read=RATES)
def test_the_rate_map(rng: Random) -> None:
    drawn, (_, tilt, _) = draw_angles(rng), draw_angles(rng)
    for x, y, z in (drawn, -drawn, (0.4, math.pi - tilt, -1.9), (0.4, 0.5 * math.pi, -0.7)):
        with calls("The columns are the axes X (rotated by y and z), Y (rotated by z) and Z."):
            m = rate_map(x, y, z)
        got, wanted = entries(m), map_of(x, y, z)
        turn = matrix_of(in_order((x, y, z)))
        slips = {
            "You return the identity, as if the rates were the angular velocity.": IDENTITY,
            "Your matrix has the rotation axes as rows. Write them as columns.": transposed(wanted),
            "You use the axes of the object instead of the world.": times(transposed(turn), wanted),
            "the rotation matrix of the three angles": turn,
            "the map with its columns reversed": times(wanted, (0, 0, 1, 0, 1, 0, 1, 0, 0)),
            "the map with y and z swapped": map_of(x, z, y),
        }
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
        cause = "This is not gimbal lock. Raise an error only if |cos y| is at most SINGULAR."
        if math.cos(y) < 0.0:
            cause = "You reject a negative cos y. Compare its absolute value with SINGULAR."
        with calls(cause):
            velocity = Vector3(*w)
            rates = euler_rates(x, y, z, velocity)
        there, found = map_of(x, y, z), expect_vector(rates, cause=multiply)
        slips = {
            "the angular velocity itself": w,
            "You multiply the angular velocity by rate_map(x, y, z).": applied(there, w),
            "You multiply by the transpose of rate_map(x, y, z).": applied(transposed(there), w),
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


def rates_near_lock(rng: Random, off: float) -> tuple[float, float, Triple]:
    """Expect rates when the second angle is ``off`` a quarter turn, and return x, z and w."""
    # The product of the rows' lengths is then 0.55 to 0.66. Ten times SINGULAR of it exceeds 5e-13.
    x, z, w = number(rng, 0.3, 2.9), number(rng, 0.45, 0.6), vector(rng)
    with calls("This is close to gimbal lock, but |cos y| > SINGULAR, so return the rates."):
        rates = euler_rates(x, math.pi / 2 + off, z, Vector3(*w))
    expect_vector(rates)
    return x, z, w


@pytest.mark.exercise("B9.17", asks="Near gimbal lock, the rates become very large", read=BACK)
def test_near_gimbal_lock_there_are_rates(rng: Random) -> None:
    rates_near_lock(rng, 1e-6)
    rates_near_lock(rng, -1e-6)


@pytest.mark.exercise("B9.17", asks="which means that |cos y| is at most", read=BACK)
@pytest.mark.robust
def test_rejects_gimbal_lock_but_not_angles_near_it(rng: Random) -> None:
    rates_near_lock(rng, 5e-13)
    x, z, w = rates_near_lock(rng, -5e-13)
    quarter = 0.5 * math.pi
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
            cause=f"{cause}unless abs(cos y) > SINGULAR.",
            allowed=lambda: [
                euler_rates(x, allowed, z, Vector3(*w))
                for allowed in (quarter - 1e-6, 1e-6 - quarter, quarter - 5e-13, quarter + 5e-13)
            ],
        )


@pytest.mark.exercise("B9.18", asks="Compute the velocity of a point on an object", read=POINT)
def test_a_point_of_a_rotating_object() -> None:
    with calls("Compute w x (q - p), in this order. A point on the X axis moves along +Y."):
        q, p, w = Vector3(1.0, 0.0, 0.0), Vector3(), Vector3(0.0, 0.0, 2.0)
        got = velocity_of_point(q, p, Vector3(), w)
    slips = {
        "Your point rotates in the wrong direction.": (0.0, -2.0, 0.0),
        "the velocity without any rotation": (0.0, 0.0, 0.0),
        "the angular velocity itself": (0.0, 0.0, 2.0),
    }
    expect_close(xyz(got), (0.0, 2.0, 0.0), slips)


@pytest.mark.exercise(
    "B9.18", asks="a new vector in m/s, and the arguments do not change", read=POINT
)
def test_a_point_of_a_moving_and_rotating_object(rng: Random) -> None:
    point, place, speed, spin = vector(rng), vector(rng), vector(rng), vector(rng)
    with calls("The velocity of the point is w x (q - p) + p', with the object's position p."):
        q, p, v, w = Vector3(*point), Vector3(*place), Vector3(*speed), Vector3(*spin)
        got = velocity_of_point(point=q, position=p, velocity=v, angular_velocity=w)
    spun, about_world = spin.cross(point - place), spin.cross(point)
    slips = {
        "You leave out p', the velocity of the object itself.": spun,
        "You compute w x q, so the point rotates about the world's origin.": about_world + speed,
        "You subtract the velocity p'. Add it instead.": spun - speed,
        "You return only p', without the rotation.": speed,
        "You compute w x q - p + p'. Put parentheses around q - p.": about_world - place + speed,
        "You compute w x (q + p). Subtract p from q instead.": spin.cross(point + place) + speed,
        "You compute w x (q - p + p').": spin.cross(point - place + speed),
    }
    # Two products of up to 200 each.
    expect_close(xyz(got), spun + speed, slips, tolerance=1e-11)
    kept = {"point": (q, point), "position": (p, place), "velocity": (v, speed)}
    for name, (now, old) in (kept | {"angular_velocity": (w, spin)}).items():
        expect_kept(name, now, old, "If you use += or -= on it, use + or - instead.")
    with calls("You return p' itself. Return a new vector, even if nothing rotates.", more=True):
        velocity_of_point(q, p, v, Vector3(0.0, 0.0, 0.0)).invert()
    expect_close(v, speed, then="; v", tolerance=0.0)


@pytest.mark.exercise("B9.18", asks="then the orientation rotates by w' h", read=STEP)
def test_a_step_turns_by_the_new_angular_velocity(rng: Random) -> None:
    turn, spin, gain = draw_quad(rng), vector(rng), vector(rng)
    h = positive_number(rng, 0.05, 0.2)
    with calls("Change the components of w in place to those of w + alpha h."):
        q, w, alpha = Quaternion(*turn), Vector3(*spin), Vector3(*gain)
        returned = integrate_rotation(q, w, alpha, h)
    new = spin + h * gain
    slips = {
        "The angular velocity hasn't changed. Change its components in place, because a new vector "
        "assigned to the parameter is lost.": spin,
        "You add alpha without multiplying it by h.": spin + gain,
        "You replace w by alpha h instead of adding alpha h to it.": h * gain,
        "You multiply alpha by h^2. Multiply it by h only.": spin + h * h * gain,
        "You multiply w itself by h. Use w h only for the rotation.": h * new,
        "You subtract alpha h. Add it instead.": spin - h * gain,
    }
    expect_close(w, new, slips, then="; w", tolerance=TIGHT)
    wanted = hamilton(quad(new, h * abs(new)), turn)
    change = hamilton((0.0, *new), turn)
    longer = tuple(a + 0.5 * h * b for a, b in zip(turn, change, strict=True))
    turns = {
        "You rotate by the old w. Change w first, and then rotate by the new w.": h * spin,
        "You rotate by the mean of the old and the new w.": 0.5 * h * (spin + new),
        "You rotate by w + alpha. Multiply alpha by h before you add it.": h * (spin + gain),
        "You rotate by the new w alone. Multiply it by h.": new,
        "You rotate by alpha h. Rotate by w h, where w is the new angular velocity.": h * gain,
    }
    slips = {slip: hamilton(quad(by, abs(by)), turn) for slip, by in turns.items()} | {
        "You use Eq. 9.5 and then normalize, which is accurate only to first order. Call rotate_by "
        "instead, which rotates exactly.": tuple(c / math.hypot(*longer) for c in longer),
        "You take a step of Eq. 9.5 (E-31). Rotate exactly instead, with rotate_by.": longer,
        "You rotate about an axis of the object.": hamilton(turn, quad(new, h * abs(new))),
        "It hasn't changed, because a new quaternion assigned to the parameter is lost.": turn,
    }
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
        with calls("You don't normalize q. Do this at the end of each step."):
            q = Quaternion(*turn)
            integrate_rotation(q, Vector3(1.0, 2.0, 3.0), Vector3(), 0.1)
        then = f", from a length of {off}; the length of q"
        expect_close(math.hypot(*rijk(q)), 1.0, then=then, tolerance=TIGHT)


@pytest.mark.exercise("B9.18", asks="so a zero vector changes nothing", weight=0.5, read=STEP)
def test_a_step_from_rest(rng: Random) -> None:
    turn, gain, h = draw_quad(rng), vector(rng), 0.1
    for a, cause in (
        (ZERO, "The new angular velocity is 0, so there is no axis. Leave q as it is."),
        (gain, "w is zero at first, but alpha changes it. Rotate q by the new w."),
    ):
        with calls(cause):
            q, w = Quaternion(*turn), Vector3()
            integrate_rotation(q, w, Vector3(*a), h)
        new = h * a
        expect_close(w, new, then="; w", tolerance=TIGHT)
        wanted = hamilton(quad(new, h * abs(new)), turn) if any(new) else turn
        expect_close(same_sign(rijk(q), wanted), wanted, then="; q", tolerance=TIGHT)


def expect_drift(speed: float, duration: float, count: int, cause: str, near: float) -> None:
    """Expect the two results of first_order_drift, the length to within ``near`` of itself."""
    with calls(cause):
        length, lag = first_order_drift(angular_speed=speed, duration=duration, steps=count)
    turn = speed * duration
    step = turn / count
    growth = math.hypot(1.0, 0.5 * step)
    wanted, late = growth**count, turn - 2.0 * count * math.atan(0.5 * step)
    slips = {
        "You swap the two results. Return the length first, and then the angle.": late,
        "the squared length, without the square root": wanted**2,
        "the length after a single step": growth,
        "You add the same amount to the length in every step.": 1.0 + count * (growth - 1.0),
        f"You return 1 + {count} (w h)^2 / 8, which is only an approximation.":
            1.0 + 0.125 * count * step * step,
        "You use w h instead of w h / 2.": math.hypot(1.0, step) ** count,
        "You use the whole duration as h. Divide it by the number of steps.":
            math.exp(min(0.5 * count * math.log1p(0.25 * turn * turn), 700.0)),
        "You return how much longer the quaternion is. Return its length.": wanted - 1.0,
    }  # fmt: skip
    then = "; length, that of the quaternion after all steps"
    expect_close(length, wanted, slips, then=then, tolerance=near * wanted)
    negative = " If the speed is negative, the angle is negative too." * (turn < 0.0)
    slips = {
        "You return half of the angle. Double your result.": 0.5 * late,
        "Either you return the actual angle instead of subtracting it from the intended one, or "
        "you read the actual angle off the last quaternion, which shows at most half a turn. Add "
        "up the angles of the steps.": turn - late,
        "You use atan(w h) instead of 2 atan(w h / 2).": turn - count * math.atan(step),
        f"Your angle has the wrong sign.{negative}": -late,
        "You return the angle in degrees. Return it in radians.": math.degrees(late),
    }
    if count > 2:
        once = "You return what a single step misses. Multiply it by the number of steps."
        slips[once] = late / count
    why = "A step should rotate by w h, but it rotates by only 2 atan(w h / 2). Return the sum of "
    why = named(lag, f"{why}these differences over all steps.", slips)
    then = "; lag, the angle by which the rotation lags behind"
    expect_close(lag, late, then=then, cause=why, unit="rad", tolerance=near)


EACH = "Each step of a duration h multiplies the length by sqrt(1 + (w h / 2)^2)."


@pytest.mark.exercise("B9.19", asks="Return the length of the quaternion at the end", read=DRIFT)
def test_a_turn_a_second_in_sixty_frames() -> None:
    # The length is 1.0856, which is the known figure of E-31.
    expect_drift(math.tau, 1.0, 60, EACH, near=TIGHT)


@pytest.mark.exercise("B9.19", asks="This angle is negative for a negative speed", read=DRIFT)
def test_the_drift_of_a_few_rotations(rng: Random) -> None:
    for count, low, high in ((1, 0.2, 1.0), (7, 3.0, 9.0), (7, -9.0, -3.0), (500, 20.0, 30.0)):
        speed, duration = positive_number(rng, low, high), positive_number(rng, 0.5, 1.5)
        expect_drift(speed, duration, count, EACH, near=1e-10)  # rounding of 500 steps


@pytest.mark.exercise("B9.19", asks="At a speed of 0 nothing rotates", read=DRIFT)
def test_no_drift_at_a_speed_of_zero() -> None:
    still = "At a speed of 0 nothing rotates, so the length stays 1 and no angle is missing."
    expect_drift(0.0, 2.0, 10, still, near=TIGHT)
