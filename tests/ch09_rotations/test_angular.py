"""The velocity of a point, rotation steps, and the drift of Eq. 9.5: tasks B9.18 and B9.19."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import first_order_drift, integrate_rotation, velocity_of_point
from ch09_rotations.probes import steps
from ch09_rotations.quaternion import Quaternion
from draw import Components, components, number, positive_number
from expect import (
    about,
    expect_close,
    expect_exactly,
    expect_unchanged,
    xyz,
)
from turning import (
    TIGHT,
    Quad,
    added,
    draw_quad,
    expect_kept,
    hamilton,
    named,
    quad,
    rijk,
    same_sign,
    short,
    subtracted,
)

POINT = "book 9.3.1, Eq. 9.6"
STEP = "the docstring of integrate_rotation"
DRIFT = "the docstring of first_order_drift, and E-31"
LENGTH = "; the length of the quaternion after all steps"
LAG = "; the angle in radians by which the rotation lags behind"


@pytest.mark.exercise("B9.18", asks="Compute the velocity of a point on an object")
def test_a_point_of_a_rotating_object() -> None:
    about.read = POINT
    about.call = "q = Vector3(1, 0, 0); p = p' = Vector3(); w = Vector3(0, 0, 2); "
    about.call += "velocity_of_point(q, p, p', w)"
    about.cause = "Compute w x (q - p). The rotation moves a point on the X axis along +Y."
    args = [Vector3(1, 0, 0), Vector3(), Vector3(), Vector3(0, 0, 2)]
    got = xyz(velocity_of_point(*args))
    slips = {
        "Your point rotates in the wrong direction. The vector product is w x (q - p), in exactly "
        "this order.": (0.0, -2.0, 0.0),
        "the velocity without any rotation": (0.0, 0.0, 0.0),
        "the angular velocity itself": (0.0, 0.0, 2.0),
    }
    expect_close(got, (0.0, 2.0, 0.0), cause=named(got, about.cause, slips))


@pytest.mark.exercise("B9.18", asks="a new vector in m/s, and the arguments do not change")
def test_a_point_of_a_moving_and_rotating_object(rng: Random) -> None:
    about.read = POINT
    point, place, v, w = (components(rng) for _ in range(4))
    given = [Vector3(*a) for a in (point, place, v, w)]
    about.call = f"q = Vector3{short(point)}; p = Vector3{short(place)}; p' = Vector3{short(v)}; "
    about.call += f"w = Vector3{short(w)}; velocity_of_point(q, p, p', w)"
    about.cause = "The point moves with the object and also rotates about the object's position p, "
    about.cause += "so its velocity is w x (q - p) + p'."
    got = xyz(velocity_of_point(*given))
    # The vector part of (0, w) times (0, arm) is their cross product.
    turning, about_world = (
        hamilton((0.0, *w), (0.0, *arm))[1:] for arm in (subtracted(point, place), point)
    )
    wanted = added(turning, v)
    slips = {
        "You leave out p', the velocity of the object itself. Add it to w x (q - p).": turning,
        "You compute w x q, so the point rotates about the world's origin. Compute w x (q - p), "
        "where p is the object's position.": added(about_world, v),
        "You subtract the velocity p'. Add it instead.": subtracted(turning, v),
        "You return only p', without the rotation. Add w x (q - p).": v,
        "You compute w x q - p + p'. Put parentheses around q - p.": added(
            subtracted(about_world, place), v
        ),
        "You compute w x (q + p). Subtract p from q instead.": added(
            hamilton((0.0, *w), (0.0, *added(point, place)))[1:], v
        ),
        "You compute w x (q - p + p'). Add p' to the vector product, not inside it.": hamilton(
            (0.0, *w), (0.0, *added(subtracted(point, place), v))
        )[1:],
    }
    why = named(got, about.cause, slips, wanted)
    # Two products of up to 200 each.
    expect_close(got, wanted, cause=why, tolerance=1e-11)
    names = ("point", "position", "velocity", "angular_velocity")
    for name, now, before in zip(names, given, (point, place, v, w), strict=True):
        instead = "If you use += or -= on it, use + or - instead."
        expect_kept(name, xyz(now), before, instead)
    about.call = f"v = Vector3{short(v)}; velocity_of_point(q, p, v, Vector3(0, 0, 0)).invert(); v"
    about.cause = "You return p' itself, so a change of the result also changes p'. Return a new "
    about.cause += "vector, even if nothing rotates."
    same = velocity_of_point(*given[:3], Vector3())
    same.invert()
    expect_unchanged("v", xyz(given[2]), v)


def step_slips(q: Quad, old: Components, new: Components, h: float) -> dict[str, Quad]:
    """Return the orientations that likely mistakes give after a step."""
    mean = tuple(0.5 * (a + b) for a, b in zip(old, new, strict=True))
    change = hamilton((0.0, *new), q)
    longer = tuple(a + 0.5 * h * b for a, b in zip(q, change, strict=True))
    size = math.hypot(*new)
    gained = tuple(b - a for a, b in zip(old, new, strict=True))  # alpha h
    rate = tuple(part / h for part in gained)
    return {
        "You rotate by the old w. Change w first, and then rotate by the new w.": hamilton(
            quad(old, h * math.hypot(*old)), q
        ),
        "You rotate by the mean of the old and the new w. Rotate by the new w.": hamilton(
            quad(mean, h * math.hypot(*mean)), q
        ),
        "You use Eq. 9.5 and then normalize, which is accurate only to first order. Call rotate_by "
        "instead, which rotates exactly.": tuple(c / math.hypot(*longer) for c in longer),
        "You take a step of Eq. 9.5 (E-31). Rotate exactly instead, with rotate_by.": longer,
        "You rotate by w + alpha. Multiply alpha by h before you add it.": hamilton(
            quad(added(old, rate), h * math.hypot(*added(old, rate))), q
        ),
        "You rotate by the new w alone. Multiply it by h.": hamilton(quad(new, size), q),
        "You rotate about an axis of the object. Rotate about w in world axes.": hamilton(
            q, quad(new, h * size)
        ),
        "You rotate by alpha h. Rotate by w h, where w is the new angular velocity.": hamilton(
            quad(gained, math.hypot(*gained)), q
        ),
        "The orientation hasn't changed. Change its components in place, as rotate_by does, "
        "because a new quaternion assigned to the parameter is lost.": q,
    }


@pytest.mark.exercise("B9.18", asks="then the orientation rotates by w' h")
def test_a_step_turns_by_the_new_angular_velocity(rng: Random) -> None:
    about.read = STEP
    q, w, a = draw_quad(rng), components(rng), components(rng)
    h = positive_number(rng, 0.05, 0.2)
    orientation, velocity, acceleration = Quaternion(*q), Vector3(*w), Vector3(*a)
    about.call = f"q = Quaternion{short(q)}; w = Vector3{short(w)}; alpha = Vector3{short(a)}; h = "
    about.call += f"{h}; integrate_rotation(q, w, alpha, h); "
    about.cause = "Change the components of w in place to those of w + alpha h."
    returned = integrate_rotation(orientation, velocity, acceleration, h)
    new = tuple(p + h * r for p, r in zip(w, a, strict=True))
    got = xyz(velocity)
    slips = {
        "The angular velocity hasn't changed. Change the components of w in place, because a new "
        "vector assigned to the parameter is lost.": w,
        "You add alpha without multiplying it by h.": added(w, a),
        "You replace w by alpha h instead of adding alpha h to it.": subtracted(new, w),
        "You multiply alpha by h^2. Multiply it by h only.": tuple(
            p + h * h * r for p, r in zip(w, a, strict=True)
        ),
        "You multiply w itself by h. Use w h only for the rotation.": tuple(h * p for p in new),
        "You subtract alpha h. Add it instead.": tuple(
            p - h * r for p, r in zip(w, a, strict=True)
        ),
    }
    why = named(got, about.cause, slips)
    expect_close(got, new, then="w", cause=why, tolerance=TIGHT)
    wanted = hamilton(quad(new, h * math.hypot(*new)), q)
    about.cause = "Rotate the orientation by the new w times h, with rotate_by."
    got = same_sign(rijk(orientation), wanted)
    slips = {name: same_sign(slip, wanted) for name, slip in step_slips(q, w, new, h).items()}
    why = named(got, about.cause, slips)
    expect_close(got, wanted, then="q", cause=why, tolerance=TIGHT)
    expect_kept("the acceleration", xyz(acceleration), a)
    about.cause = "integrate_rotation works in place, so it shouldn't return anything."
    expect_exactly(returned, None, then="the returned value")


@pytest.mark.exercise("B9.18", asks="The step is semi-implicit Euler")
def test_many_steps_about_one_axis(rng: Random) -> None:
    about.read = STEP
    axis = components(rng)
    length = math.hypot(*axis)
    unit = tuple(component / length for component in axis)
    speed, gain, h, count = 1.5, number(rng, 0.2, 0.9), 0.01, 200
    w, a = tuple(speed * u for u in unit), tuple(gain * u for u in unit)
    about.call = f"q = Quaternion(); w = Vector3{short(w)}; alpha = Vector3{short(a)}; h = {h}; "
    about.call += f"{count} times integrate_rotation(q, w, alpha, h); q"
    about.cause = "In each step, change w first, and then rotate exactly by the new w times h."
    got, after, alpha = steps((1.0, 0.0, 0.0, 0.0), w, a, h, count)
    angle = speed * h * count + gain * h * h * count * (count + 1) / 2.0
    wanted = quad(unit, angle)
    # Rounding of 200 steps.
    got = same_sign(got, wanted)
    expect_close(got, wanted, tolerance=1e-11)
    wanted = [p + h * count * r for p, r in zip(w, a, strict=True)]
    about.cause = "Your angular velocity is wrong after these steps. Add alpha h in each step."
    expect_close(after, wanted, call=f"{about.call[:-1]}w", tolerance=1e-11)
    expect_kept("alpha", alpha, a)


@pytest.mark.exercise("B9.18", asks="After that it is normalized")
def test_a_step_leaves_the_length_at_one(rng: Random) -> None:
    about.read = STEP
    about.cause = "You don't normalize q, so the error in its length remains. Normalize q at the "
    about.cause += "end of each step."
    for off in (1.001, 1.0 + 5e-7):
        q = tuple(off * component for component in draw_quad(rng))
        orientation = Quaternion(*q)
        about.call = f"q = Quaternion{short(q)}, whose length is {off}; integrate_rotation(q, "
        about.call += "Vector3(1, 2, 3), Vector3(), 0.1); the length of q"
        integrate_rotation(orientation, Vector3(1.0, 2.0, 3.0), Vector3(), 0.1)
        got = math.hypot(*rijk(orientation))
        expect_close(got, 1.0, tolerance=TIGHT)


@pytest.mark.exercise("B9.18", asks="so a zero vector changes nothing", weight=0.5)
def test_a_step_from_rest(rng: Random) -> None:
    about.read = STEP
    q, a, h = draw_quad(rng), components(rng), 0.1
    for acceleration in ((0.0, 0.0, 0.0), a):
        orientation, velocity = Quaternion(*q), Vector3()
        about.call = f"q = Quaternion{short(q)}; w = Vector3(); integrate_rotation(q, w, "
        about.call += f"Vector3{short(acceleration)}, {h})"
        about.cause = "The new angular velocity is 0, so there is no axis. Leave q as it is."
        if any(acceleration):
            about.cause = "w is zero at first, but alpha changes it. Rotate q by the new w."
        integrate_rotation(orientation, velocity, Vector3(*acceleration), h)
        new = tuple(h * component for component in acceleration)
        expect_close(xyz(velocity), new, then="; w", tolerance=TIGHT)
        wanted = hamilton(quad(new, h * math.hypot(*new)), q) if any(new) else q
        got = same_sign(rijk(orientation), wanted)
        expect_close(got, wanted, then="; q", tolerance=TIGHT)


def drift_of(speed: float, duration: float, count: int) -> tuple[float, float]:
    """Return the length and the missing angle after steps of Eq. 9.5, one by one in the plane."""
    point, turned = complex(1.0, 0.0), 0.0
    for _ in range(count):
        new = point * complex(1.0, 0.5 * speed * duration / count)
        ratio = new / point
        turned += 2.0 * math.atan2(ratio.imag, ratio.real)
        point = new
    return abs(point), speed * duration - turned


def length_slips(speed: float, duration: float, count: int) -> dict[str, float]:
    """Return the lengths that likely mistakes give."""
    turn = abs(speed) * duration / count
    growth = 1.0 + 0.25 * turn * turn
    grown = 0.5 * count * math.log1p(0.25 * (speed * duration) ** 2)
    added, start = 1.0 + count * (math.sqrt(growth) - 1.0), 1.0 + 0.125 * count * turn * turn
    return {
        "the squared length, without the square root": growth**count,
        "the length after a single step": math.sqrt(growth),
        "You add the same amount to the length in every step, instead of multiplying it.": added,
        f"You return 1 + {count} (w h)^2 / 8, which is only an approximation.": start,
        "You use w h instead of w h / 2.": (1.0 + turn * turn) ** (0.5 * count),
        "You use the whole duration as h. Divide it by the number of steps.": math.exp(
            min(grown, 700.0)
        ),
        "You return how much longer the quaternion is. Return its length.": growth ** (0.5 * count)
        - 1.0,
    }


def lag_slips(right: float, turn: float, count: int) -> dict[str, float]:
    """Return the missing angles that likely mistakes give, out of a whole turn."""
    return {
        "You return half of the angle, because a quaternion contains half the angle of rotation. "
        "Double your result.": 0.5 * right,
        "Either you return the actual angle instead of subtracting it from the intended one, or "
        "you read the actual angle off the last quaternion, which shows at most half a turn. Add "
        "up the angles of the steps.": turn - right,
        "You use atan(w h) instead of 2 atan(w h / 2).": turn - count * math.atan(turn / count),
        "Your angle has the wrong sign."
        + " If the speed is negative, the angle is negative too." * (turn < 0.0): -right,
        "You return the angle in degrees. Return it in radians.": math.degrees(right),
    } | (
        {"You return what a single step misses. Multiply it by the number of steps.": right / count}
        if count > 2
        else {}
    )


@pytest.mark.exercise("B9.19", asks="Return the length of the quaternion at the end")
def test_a_turn_a_second_in_sixty_frames() -> None:
    about("first_order_drift(angular_speed=2 pi, duration=1, steps=60)", read=DRIFT)
    about.cause = "Each of the 60 steps multiplies the length by sqrt(1 + (w h / 2)^2), where w = "
    about.cause += "2 pi and h = 1/60."
    length, lag = first_order_drift(math.tau, 1.0, 60)
    # Four decimals of the known figure of E-31.
    wanted = math.tau - 120.0 * math.atan(math.pi / 60.0)
    swapped = {"You swap the two results. Return the length first, and then the angle.": wanted}
    why = named(length, about.cause, length_slips(math.tau, 1.0, 60) | swapped)
    expect_close(length, 1.0856, then=LENGTH, cause=why, tolerance=5e-5)
    about.cause = "A step should rotate by w h, but it rotates by only 2 atan(w h / 2). Return the "
    about.cause += "sum of these differences over all steps."
    why = named(lag, about.cause, lag_slips(wanted, math.tau, 60))
    expect_close(lag, wanted, then=LAG, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("B9.19", asks="This angle is negative for a negative speed")
def test_the_drift_of_a_few_rotations(rng: Random) -> None:
    about.read = DRIFT
    for steps_, low, high in ((1, 0.2, 1.0), (7, 3.0, 9.0), (7, -9.0, -3.0), (500, 20.0, 30.0)):
        speed, duration = positive_number(rng, low, high), positive_number(rng, 0.5, 1.5)
        about.call = f"first_order_drift(angular_speed={speed}, duration={duration}, "
        about.call += f"steps={steps_})"
        about.cause = "Each step multiplies the length by sqrt(1 + (w h / 2)^2), where w is the "
        about.cause += "angular speed, and h is the duration of a step."
        length, lag = first_order_drift(speed, duration, steps_)
        wanted, missing = drift_of(speed, duration, steps_)
        # Rounding of 500 steps.
        near = 1e-10 * wanted
        why = named(length, about.cause, length_slips(speed, duration, steps_))
        expect_close(length, wanted, then=LENGTH, cause=why, tolerance=near)
        about.cause = "Return the intended angle, which is the speed times the duration, minus the "
        about.cause += "angle of all steps together."
        why = named(lag, about.cause, lag_slips(missing, speed * duration, steps_))
        expect_close(lag, missing, then=LAG, cause=why, tolerance=1e-10)


@pytest.mark.exercise("B9.19", asks="At a speed of 0 nothing rotates")
def test_no_drift_at_a_speed_of_zero() -> None:
    about("first_order_drift(0, 2, 10)", read=DRIFT)
    about.cause = "At a speed of 0 nothing rotates, so the length stays 1 and no angle is missing."
    got = tuple(first_order_drift(0.0, 2.0, 10))
    expect_close(got, (1.0, 0.0), tolerance=TIGHT)
