"""Compute the numbers of chapter 9's lesson with the reference."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import first_order_drift, velocity_of_point
from ch09_rotations.euler import euler_rates, euler_to_quaternion
from ch09_rotations.exercises import (
    back_to_reference,
    product_without_j_and_k,
    turned_by_sense,
    turned_by_steps,
)
from ch09_rotations.matrix import Matrix4
from ch09_rotations.matrix3 import Matrix3
from ch09_rotations.plane import rotate_point, wrap_angle
from ch09_rotations.quaternion import Quaternion
from lessons.lesson import Facts

Z = Vector3(0, 0, 1)
QUARTER = Quaternion.from_axis_angle(Z, math.pi / 2)
facts = Facts()

facts.section("Flat first: one angle", "5 10 20 90")
x, y = rotate_point((2, 1), math.pi / 2, (10, 5))
facts.says("3.142 6.283 2.283 9 7", math.pi, math.tau, wrap_angle(4), x, y)

facts.section("In space, the order matters", "90")

facts.section("Euler angles, and where they fail", "20 50 90")
locked = euler_to_quaternion(*map(math.radians, (20, 90, 50)))
same = euler_to_quaternion(0, math.radians(90), math.radians(30))
assert (locked * same.conjugate()).to_axis_angle()[1] < 1e-7
facts.says("30", 50 - 20)

facts.section("Matrices", "5 90")

facts.section("Quaternions", "60 90 180 1e-13")
facts.says("0.707 0.5", QUARTER.k, QUARTER.k**2)
facts.says("45", math.degrees(math.acos(QUARTER.r)))
columns = [Vector3(1), Vector3(0, 1), Vector3(0, 0, 1)]
small = Matrix3.from_quaternion(Quaternion.from_axis_angle(Vector3(1, 2, 3), 0.1))
product = Matrix3(1, 0, 0, 0, 1, 0, 0, 0, 1)
for _ in range(1000):  # cheap steps at 1 rad/s, and products of rotations
    for column in columns:
        column.add_scaled(Z.cross(column), 1 / 60)
    product = small.product(product)
facts.says("15", 100 * (max(column.magnitude() for column in columns) - 1))
square = product.product(product.transpose())
assert max(abs(square[i, j] - (i == j)) for i in range(3) for j in range(3)) < 1e-13

facts.section("Spinning: a rotation step", "15")
step = Quaternion()
step.add_scaled(Vector3(0, 0, math.tau), 1 / 15)
_, missing = first_order_drift(math.tau, 1, 15)
facts.says("6.283 0.4189 0.4129", math.tau, math.tau / 15, 2 * math.atan2(step.k, step.r))
facts.says("0.09 5.1", missing, math.degrees(missing))
facts.says("0.2094 1.0217", step.k, step.magnitude())

facts.section("From quaternions to matrices and back", "120")
facts.says("0.5", -math.cos(math.radians(120)))

facts.section("How fast Euler angles must change", "45 60 89 89.9 90")
rates = [euler_rates(0, math.radians(pitch), 0, Vector3(1, 0, 0)).x for pitch in (89, 89.9)]
facts.says("57 573", *rates)

facts.section("Objects in the world", "5 90")
placed = Matrix4.from_orientation_and_position(QUARTER, Vector3(10, 0, 5))
muzzle = placed.transform(Vector3(3, 0, 1))
facts.says("10 6", muzzle.x, muzzle.z)
turn = Matrix4(0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0)
move = Matrix4(1, 0, 0, 10, 0, 1, 0, 0, 0, 0, 1, 5)
facts.says("13", turn.product(move).transform(Vector3(3, 0, 1)).y)

facts.section("A step for a spinning body")
facts.says("6", velocity_of_point(Vector3(2), Vector3(), Vector3(), Vector3(0, 0, 3)).y)

facts.section("The book's exercises", "0.5 90")
half = Quaternion(0.5, 0.5, 0.5, 0.5)
facts.says("120", math.degrees(back_to_reference(half)[1]))
product = product_without_j_and_k(Quaternion(2, 3), Quaternion(4, -1))
facts.says("11 10 12", product.r, product.i, 3 * 4)
by_steps, _ = turned_by_steps(half, 0.5, 2)
exact = turned_by_sense(half, 0.5, 2)
half.add_scaled(Vector3(0.5), 2)
facts.says("0.25 0.75", half.r, half.i)
facts.says("0.224 0.671 0.199 0.679", by_steps.r, by_steps.i, exact.r, exact.i)
