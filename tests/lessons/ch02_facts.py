"""Compute the numbers of chapter 2's lesson with the reference."""

from __future__ import annotations

import math

from ch02_vectors.calculus import add_up_accelerations, difference_quotients
from ch02_vectors.exercises import (
    angle_by_scalar_product,
    angles_by_vector_product,
    position_after,
    remove_projection,
)
from ch02_vectors.recordings import thrown_ball
from ch02_vectors.vector import Vector3
from lessons.lesson import Facts

facts = Facts()

facts.section("One arrow, three numbers", "7")

facts.section("How long is it?", "6 10 100")
v = Vector3(2, 3, 6)
facts.says("9 36 49 7", v.y**2, v.z**2, v.squared_magnitude(), v.magnitude())

facts.section("Longer, shorter, and exactly one", "5 6 10")
unit = v.normalized()
facts.says("7 0.286 0.429 0.857", v.magnitude(), unit.x, unit.y, unit.z)
facts.says("0.082 0.184 0.735", unit.x**2, unit.y**2, unit.z**2)
run = (Vector3(4, 0, 6) - Vector3(1, 0, 2)).normalized()
facts.says("0.6 0.8 8", run.x, run.z, (run * 10).z)

facts.section("Adding arrows", "6 10 0.5")
moved = Vector3(0, 10, 0)
moved.add_scaled(Vector3(6, -3, 0), 0.5)
facts.says("8.5 5", moved.y, (Vector3(4, 6, 0) - Vector3(1, 2, 0)).magnitude())

facts.section("Three ways to multiply", "5 6")
product = Vector3(1, 2, 3).component_product(Vector3(4, 5, 6))
facts.says("10 18", product.y, product.z)

facts.section("The dot product: how much of one points along the other?", "60 0.8")
wind, course = Vector3(3, 4, 0), Vector3(-0.8, 0.6, 0)
angle = angle_by_scalar_product(wind, Vector3(1, 0, 0))
facts.says("5 0.6 53.1", wind.magnitude(), math.cos(angle), math.degrees(angle))
facts.says("2.4 90", wind.x * course.x, math.degrees(angle_by_scalar_product(wind, course)))
facts.says("0.5", math.cos(math.radians(60)))

facts.section("The cross product: a direction that both are perpendicular to", "180 90")
facts.says("5", Vector3(1, 2, 0).cross(Vector3(3, 1, 0)).z)

facts.section("How a motion changes", "5 10 0.5 0.1 0.01 60 9.81")


def fallen(time: float) -> float:
    return 5 * time * time


def average(duration: float) -> float:
    """Return the average velocity of the falling ball in an interval that begins after 1 s."""
    times = [1.0, 1.0 + duration]
    return difference_quotients(times, [Vector3(0, fallen(t)) for t in times])[1][0].y


facts.says("1.05 0.1005", fallen(1.1) - fallen(1), fallen(1.01) - fallen(1))
facts.says("15 10.5 10.05", average(1), average(0.1), average(0.01))
middles, _ = difference_quotients([0, 1, 2], [Vector3(0, -fallen(t)) for t in range(3)])
positions, _ = add_up_accelerations([0, 1, 2], [Vector3(10)] * 2, Vector3(), Vector3())
facts.says("1.5 20", middles[1], positions[2].x)
film = thrown_ball()
rate = len(film[0]) - 1  # of a film of 1 s
noisy = sorted({round(-a.y, 6) for a in difference_quotients(*difference_quotients(*film))[1]})
facts.says("0.06 7.2 10.8 14.4", 2 * 0.5e-3 * rate, 4 * 0.5e-3 * rate**2, *noisy[1:])

facts.section("Put the vectors to work", "5 7 10 1.0000000000000002")
a = Vector3(0, 1, 1)
small, large = map(math.degrees, angles_by_vector_product(a, Vector3(0, -1, 0)))
facts.says("1.414 45 135", a.magnitude(), small, large)
facts.says("0.707", math.cos(math.radians(large)))
between = Vector3(2, -2, -2)
facts.says("3.46 12", between.magnitude(), between.squared_magnitude())
moved = position_after(Vector3(3, 5, -4), Vector3(1, -1, 2), 10)
facts.says("13 16", moved.x, moved.z)
projection, rest, _ = remove_projection(Vector3(1, 0, 0), Vector3(0.6, 0.8, 0))
facts.says("0.6 0.8", projection, rest.y)
