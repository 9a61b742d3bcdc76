"""Claims of chapter 9: rotations, matrices and quaternions."""

from __future__ import annotations

import math
import random

from scipy.spatial.transform import Rotation

from ch02_vectors.vector import Vector3
from ch09_rotations.euler import euler_rates, euler_to_quaternion
from ch09_rotations.matrix import Matrix3, Matrix4
from ch09_rotations.plane import center_of_mass
from ch09_rotations.quaternion import Quaternion
from reference.claims.ledger import claim

X, Y, Z = Vector3(1.0), Vector3(0.0, 1.0), Vector3(0.0, 0.0, 1.0)
FRAME = 1.0 / 60.0


def angle_between(a: Quaternion, b: Quaternion) -> float:
    """Return the angle in radians of the rotation that takes one orientation to the other."""
    difference = a * b.conjugate()
    imaginary = math.hypot(difference.i, difference.j, difference.k)
    return 2.0 * math.atan2(imaginary, abs(difference.r))


@claim(
    "9.1.3",
    "Every cut through the center of mass leaves equal masses on both sides",
    predict="Cut a triangle of sheet metal through its center of mass, parallel to one side. "
    "What fraction of the mass is in the smaller part?",
    verdict="It fails",
    erratum="E-32",
)
def cut() -> str:
    smaller = (2.0 / 3.0) ** 2  # a similar triangle, with two thirds of the height
    rng = random.Random(1)
    drawn = [(rng.uniform(0.0, 3.0), rng.uniform(0.0, 3.0)) for _ in range(40_000)]
    sheet = [(x, y) for x, y in drawn if x + y < 3.0]
    _, height = center_of_mass([1.0] * len(sheet), sheet)
    counted = sum(y > height for _, y in sheet) / len(sheet)
    assert abs(counted - smaller) < 0.02  # four times the spread of such a count
    return (
        f"{100.0 * smaller:.0f} % of the mass. What is equal on both sides is the sum of mass "
        "times distance from the cut."
    )


@claim(
    "9.2.1",
    "The order of two rotations matters",
    predict="Rotate by 90° about X and by 90° about Y, in both orders. How large is the angle "
    "between the two results? And if both angles are 1°?",
    verdict="It holds",
)
def order() -> str:
    apart = []
    for angle in (90.0, 1.0):
        a, b = (Quaternion.from_axis_angle(axis, math.radians(angle)) for axis in (X, Y))
        apart.append(math.degrees(angle_between(a * b, b * a)))
        one = Rotation.from_euler("XY", [angle, angle], degrees=True)
        other = Rotation.from_euler("YX", [angle, angle], degrees=True)
        assert math.isclose(math.degrees((one * other.inv()).magnitude()), apart[-1], rel_tol=1e-9)
    assert apart[0] > 90.0
    return (
        f"{apart[0]:.0f}° for two quarter turns, but only {apart[1]:.3f}° for two rotations by "
        "1°. Small rotations nearly commute. That is why an angular velocity can be a vector, "
        "although a rotation cannot."
    )


@claim(
    "9.2.1",
    "Three Euler angles cannot describe every orientation",
    predict="Draw 1,000 orientations at random. How many of them have no Euler angles? What "
    "goes wrong when the second angle approaches 90°?",
    verdict="It fails",
    erratum="E-33",
)
def euler_angles() -> str:
    worst = 0.0
    for turn in Rotation.random(1000, rng=1):
        x, y, z = turn.as_euler("xyz")
        i, j, k, r = turn.as_quat()
        worst = max(worst, angle_between(euler_to_quaternion(x, y, z), Quaternion(r, i, j, k)))
    assert worst < 1e-7
    rate = max(abs(r) for r in euler_rates(0.0, math.radians(89.9), 0.0, X))
    assert rate > 100.0
    return (
        "None, every orientation has Euler angles. Their rates go wrong. With a second angle of "
        f"89.9°, an object that rotates at 1 rad/s about X needs rates of up to {rate:.0f} rad/s."
    )


@claim(
    "9.4.8",
    "All operations on unit quaternions give unit quaternions",
    predict="Rotate an object by one turn in 60 steps of Eq. 9.5. How long is its quaternion "
    "afterward? How long is it after a thousand products of unit quaternions?",
    verdict="It fails",
    erratum="E-31",
)
def unit_length() -> str:
    q, rng = Quaternion(), random.Random(1)
    for _ in range(60):
        q.add_scaled(Z * math.tau, FRAME)
    product = Quaternion()
    for _ in range(1000):
        axis = Vector3(*(rng.gauss(0.0, 1.0) for _ in range(3)))
        product = product * Quaternion.from_axis_angle(axis, rng.uniform(0.0, 3.0))
    assert q.magnitude() > 1.05
    assert abs(product.magnitude() - 1.0) < 1e-12
    return (
        f"After the steps of Eq. 9.5, which contains a sum, its length is {q.magnitude():.2f}. "
        "Products keep the length: after a thousand of them it is 1 except for rounding."
    )


@claim(
    "9.4.11",
    "If you normalize the quaternion after each step, you can update it by Eq. 9.5",
    predict="An object rotates once per second. After one second in 60 steps with normalizing, "
    "how many degrees is it off? And at ten turns per second?",
    verdict="It holds if the object rotates slowly enough for the step",
)
def normalized_steps() -> str:
    lag = []
    for turns in (1.0, 10.0):
        q, right = Quaternion(), Quaternion()
        for _ in range(60):
            q.add_scaled(Z * (math.tau * turns), FRAME)
            q.normalize()
            right.rotate_by(Z * (math.tau * turns * FRAME))
        total = 60.0 * 2.0 * math.atan(math.pi * turns * FRAME)
        lag.append(math.degrees(math.tau * turns - total))
        off = math.degrees(angle_between(q, right))
        assert math.isclose(
            math.cos(math.radians(lag[-1])), math.cos(math.radians(off)), abs_tol=1e-9
        )
    assert lag[0] < 1.0 < 90.0 < lag[1]
    return (
        f"It lags behind by {lag[0]:.2f}° after one slow turn, and by {lag[1]:.0f}° after ten "
        "turns in the same time. Normalizing corrects the length, but not the angle. The error "
        "per step grows with the cube of the angle of the step."
    )


@claim(
    "9.4.10",
    "Multiply by the quaternion (0, v) to rotate by the vector v",
    predict="By what angle does a product with (0, v) rotate an object if v is 0.1 rad long?",
    verdict="It fails",
    erratum="E-12",
)
def rotate_by_product() -> str:
    printed = Quaternion(0.0, 0.0, 0.0, 0.1) * Quaternion()
    printed.normalize()
    right = Quaternion()
    right.rotate_by(Z * 0.1)
    angles = [math.degrees(angle_between(q, Quaternion())) for q in (printed, right)]
    assert math.isclose(angles[0], 180.0)
    assert math.isclose(math.radians(angles[1]), 0.1, rel_tol=1e-12)
    return (
        f"By {angles[0]:.0f}°, for every v. The exponential of (0, v/2) rotates it by "
        f"{angles[1]:.1f}°, which is 0.1 rad."
    )


@claim(
    "9.4.3",
    "The inverse of a rotation matrix is its transpose",
    predict="Multiply a rotation matrix by its transpose. How far is the product from the "
    "identity? And if an update has stretched one entry of the matrix by 1 %?",
    verdict="It holds if the matrix is a rotation",
)
def transpose() -> str:
    turn = Matrix3.from_quaternion(Quaternion.from_axis_angle(Vector3(1.0, 2.0, 2.0), 1.0))
    stretched = Matrix3(*(entry * (1.01 if i == 0 else 1.0) for i, entry in enumerate(turn)))
    off = [_from_identity(m @ m.transpose()) for m in (turn, stretched)]
    assert off[0] < 1e-15
    assert off[1] > 1e-3
    assert _from_identity(stretched @ stretched.inverse()) < 1e-14
    return (
        "For a rotation matrix the product is the identity except for rounding. After the change "
        f"an entry of it is wrong by {off[1]:.3f}, and only the general inverse still works."
    )


def _from_identity(m: Matrix3) -> float:
    return max(abs(m[i, j] - (i == j)) for i in range(3) for j in range(3))


@claim(
    "9.4.2",
    "One product of matrices does the work of two transformations, one after the other",
    predict="A point goes through two transformations of 12 numbers each. Is the result the "
    "same if you multiply the matrices first? In which order?",
    verdict="It holds",
)
def product_of_transforms() -> str:
    first = Matrix4.from_orientation_and_position(
        Quaternion.from_axis_angle(Y, 0.7), Vector3(1.0, 2.0, 3.0)
    )
    second = Matrix4.from_orientation_and_position(
        Quaternion.from_axis_angle(X, -0.4), Vector3(-2.0, 0.5, 1.0)
    )
    point = Vector3(0.3, -1.0, 2.0)
    one_by_one = second @ (first @ point)
    same, swapped = ((m @ point - one_by_one).magnitude() for m in (second @ first, first @ second))
    assert same < 1e-14
    assert swapped > 0.1
    return (
        "The product (second × first) gives the same point except for rounding. In the other "
        f"order, the point of our example ends up {swapped:.1f} m away."
    )
