"""Compute the numbers of chapter 2's lesson with the reference."""

from __future__ import annotations

import math

from ch02_vectors.calculus import add_up_accelerations, difference_quotients
from ch02_vectors.exercises import (
    angle_by_scalar_product,
    angles_by_vector_product,
    make_perpendicular,
    position_after,
    remove_projection,
)
from ch02_vectors.recordings import BALL_RATE, thrown_ball
from ch02_vectors.vector import Vector3, make_orthonormal_basis


def lengths() -> dict[str, float]:
    v = Vector3(2, 3, 6)
    return {"9": v.y**2, "36": v.z**2, "49": v.squared_magnitude(), "7": v.magnitude()}


def unit_vectors() -> dict[str, float]:
    v = Vector3(2, 3, 6)
    unit = v.normalized()
    run = (Vector3(4, 0, 6) - Vector3(1, 0, 2)).normalized()
    return {
        "0.286": unit.x,
        "0.429": unit.y,
        "0.857": unit.z,
        "0.082": unit.x**2,
        "0.184": unit.y**2,
        "0.735": unit.z**2,
        "7": v.magnitude(),
        "0.6": run.x,
        "0.8": run.z,
        "8": (run * 10).z,
    }


def sums() -> dict[str, float]:
    start = Vector3(0, 10, 0)
    start.add_scaled(Vector3(6, -3, 0), 0.5)
    return {"8.5": start.y, "5": (Vector3(4, 6, 0) - Vector3(1, 2, 0)).magnitude()}


def component_products() -> dict[str, float]:
    v = Vector3(1, 2, 3).component_product(Vector3(4, 5, 6))
    return {"10": v.y, "18": v.z}


def dot_products() -> dict[str, float]:
    wind, course = Vector3(3, 4, 0), Vector3(-0.8, 0.6, 0)
    angle = angle_by_scalar_product(wind, Vector3(1, 0, 0))
    return {
        "5": wind.magnitude(),
        "0.6": math.cos(angle),
        "53.1": math.degrees(angle),
        "2.4": wind.x * course.x,
        "90": math.degrees(angle_by_scalar_product(wind, course)),
        "0.5": math.cos(math.radians(60)),
    }


def cross_products() -> dict[str, float]:
    product = Vector3(1, 2, 0).cross(Vector3(3, 1, 0))
    return {"5": product.z}


def basis() -> dict[str, float]:
    first, second, third = make_orthonormal_basis(Vector3(0, 0, 2), Vector3(0, 3, 4))
    assert (first, second) == (Vector3(0, 0, 1), Vector3(0, 1, 0))
    assert third == Vector3(-1, 0, 0)
    return {}


def at_work() -> dict[str, float]:
    a, b = Vector3(0, 1, 1), Vector3(0, -1, 0)
    small, large = angles_by_vector_product(a, b)
    moved = position_after(Vector3(3, 5, -4), Vector3(1, -1, 2), 10)
    rest = remove_projection(Vector3(1, 0, 0), Vector3(0.6, 0.8, 0))
    assert make_perpendicular(Vector3(1, 2, 3), 7, -2) == -1
    return {
        "3.46": Vector3(2, -2, -2).magnitude(),
        "12": Vector3(2, -2, -2).squared_magnitude(),
        "1.414": a.magnitude(),
        "0.707": math.cos(large),
        "45": math.degrees(small),
        "135": math.degrees(large),
        "0.6": rest[0],
        "0.8": rest[1].y,
        "13": moved.x,
        "16": moved.z,
    }


def fallen(time: float) -> float:
    return 5 * time * time


def average(duration: float) -> float:
    """Return the average velocity of the falling ball in an interval that begins after 1 s."""
    times = [1.0, 1.0 + duration]
    return difference_quotients(times, [Vector3(0, fallen(t)) for t in times])[1][0].y


def sum_of_bars(duration: float) -> float:
    """Add up v h over 2 s, with the velocity at the start of each interval."""
    return sum(10 * i * duration * duration for i in range(round(2 / duration)))


def motion() -> dict[str, float]:
    times = [0.0, 1.0, 2.0]
    middles, velocities = difference_quotients(times, [Vector3(0, -fallen(t)) for t in times])
    _, accelerations = difference_quotients(middles, velocities)
    (_, _, end), (_, _, last) = add_up_accelerations(
        times, [Vector3(10), Vector3(10)], Vector3(), Vector3()
    )
    assert (end.x, last.x, accelerations[0].y) == (20, 20, -10)
    assert sum_of_bars(1) == 10
    assert sum_of_bars(1e-3) > 19.9
    film = thrown_ball()
    rate = len(film[0]) - 1  # of a film of 1 s
    assert rate == BALL_RATE
    noisy = sorted({round(-a.y, 6) for a in difference_quotients(*difference_quotients(*film))[1]})
    assert noisy == [7.2, 10.8, 14.4]
    return {
        "1.05": fallen(1.1) - fallen(1),
        "0.1005": fallen(1.01) - fallen(1),
        "15": average(1),
        "10.5": average(0.1),
        "10.05": average(0.01),
        "1.5": middles[1],
        "0.06": 2 * 0.5e-3 * rate,
        "7.2": 4 * 0.5e-3 * rate**2,
        "10.8": noisy[1],
        "14.4": noisy[2],
        "20": end.x,
    }


SECTIONS = {
    "One arrow, three numbers": ("7", dict),
    "How long is it?": ("6 10 100", lengths),
    "Longer, shorter, and exactly one": ("5 6 10", unit_vectors),
    "Adding arrows": ("6 10 0.5", sums),
    "Three ways to multiply": ("5 6", component_products),
    "The dot product: how much of one points along the other?": ("60 0.8", dot_products),
    "The cross product: a direction that both are perpendicular to": ("180 90", cross_products),
    "Three perpendicular axes": ("", basis),
    "Bad arguments": ("", dict),
    "How a motion changes": ("5 10 0.5 0.1 0.01 60 9.81", motion),
    "Put the vectors to work": ("5 7 10 1.0000000000000002", at_work),
}
