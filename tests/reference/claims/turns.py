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
    """Return the angle in degrees of the rotation that takes one orientation to the other."""
    difference = a * b.conjugate()
    imaginary = math.hypot(difference.i, difference.j, difference.k)
    return math.degrees(2.0 * math.atan2(imaginary, abs(difference.r)))


@claim("fails", "Every cut through the center of mass leaves equal masses")
def cut() -> list[str]:
    smaller = (2.0 / 3.0) ** 2  # a similar triangle, with two thirds of the height
    rng = random.Random(1)
    drawn = [(rng.uniform(0.0, 3.0), rng.uniform(0.0, 3.0)) for _ in range(40_000)]
    sheet = [(x, y) for x, y in drawn if x + y < 3.0]
    _, height = center_of_mass([1.0] * len(sheet), sheet)
    counted = sum(y > height for _, y in sheet) / len(sheet)
    assert abs(counted - smaller) < 0.02  # four times the spread of such a count
    return [f"{100.0 * smaller:.0f} % of the mass"]


@claim("holds", "The order of two rotations matters")
def order() -> list[str]:
    apart = []
    for angle in (90.0, 1.0):
        a, b = (Quaternion.from_axis_angle(axis, math.radians(angle)) for axis in (X, Y))
        apart.append(angle_between(a * b, b * a))
    return [f"{apart[0]:.0f}° for two quarter turns, but only {apart[1]:.3f}° for"]


@claim("fails", "Three Euler angles cannot describe every orientation")
def euler_angles() -> list[str]:
    for turn in Rotation.random(1000, rng=1):
        x, y, z = turn.as_euler("xyz")
        i, j, k, r = turn.as_quat()
        assert angle_between(euler_to_quaternion(x, y, z), Quaternion(r, i, j, k)) < 1e-5
    rate = max(abs(r) for r in euler_rates(0.0, math.radians(89.9), 0.0, X))
    return [f"rates of up to {rate:.0f} rad/s"]


@claim("fails", "All operations on unit quaternions give unit quaternions")
def unit_length() -> list[str]:
    q, product, rng = Quaternion(), Quaternion(), random.Random(1)
    for _ in range(60):
        q.add_scaled(Z * math.tau, FRAME)
    for _ in range(1000):
        axis = Vector3(*(rng.gauss(0.0, 1.0) for _ in range(3)))
        product = product * Quaternion.from_axis_angle(axis, rng.uniform(0.0, 3.0))
    assert abs(product.magnitude() - 1.0) < 1e-12
    return [f"its length is {q.magnitude():.2f}. Products"]


@claim("holds if", "If you normalize the quaternion after each step")
def normalized_steps() -> list[str]:
    lag = []
    for turns in (1.0, 10.0):
        q, right = Quaternion(), Quaternion()
        for _ in range(60):
            q.add_scaled(Z * (math.tau * turns), FRAME)
            q.normalize()
            right.rotate_by(Z * (math.tau * turns * FRAME))
        lag.append(360.0 * turns - math.degrees(120.0 * math.atan(math.pi * turns * FRAME)))
        off = abs(math.remainder(lag[-1], 360.0))
        assert math.isclose(angle_between(q, right), off, abs_tol=1e-6)
    assert lag[0] < 1.0 < 90.0 < lag[1]
    return [f"behind by {lag[0]:.2f}° after one slow turn, and by {lag[1]:.0f}° after"]


@claim("fails", "Multiply by the quaternion (0, v)")
def rotate_by_product() -> list[str]:
    printed, right = Quaternion(0.0, 0.0, 0.0, 0.1) * Quaternion(), Quaternion()
    printed.normalize()
    right.rotate_by(Z * 0.1)
    by_product, angle = (angle_between(q, Quaternion()) for q in (printed, right))
    assert math.isclose(math.radians(angle), 0.1, rel_tol=1e-12)
    return [f"By {by_product:.0f}°, for every v", f"rotates it by {angle:.1f}°, which"]


@claim("holds if", "The inverse of a rotation matrix is its transpose")
def transpose() -> list[str]:
    turn = Matrix3.from_quaternion(Quaternion.from_axis_angle(Vector3(1.0, 2.0, 2.0), 1.0))
    stretched = Matrix3(turn[0, 0] * 1.01, *list(turn)[1:])
    products = turn @ turn.transpose(), stretched @ stretched.inverse()
    assert all(_from_identity(product) < 1e-14 for product in products)
    return [f"wrong by {_from_identity(stretched @ stretched.transpose()):.3f}, and only"]


def _from_identity(m: Matrix3) -> float:
    return max(abs(m[i, j] - (i == j)) for i in range(3) for j in range(3))


@claim("holds", "One product of matrices does the work of two transformations")
def product_of_transforms() -> list[str]:
    first, second = (
        Matrix4.from_orientation_and_position(Quaternion.from_axis_angle(axis, angle), place)
        for axis, angle, place in (
            (Y, 0.7, Vector3(1.0, 2.0, 3.0)),
            (X, -0.4, Vector3(-2.0, 0.5, 1.0)),
        )
    )
    point = Vector3(0.3, -1.0, 2.0)
    one_by_one = second @ (first @ point)
    same, swapped = ((m @ point - one_by_one).magnitude() for m in (second @ first, first @ second))
    assert same < 1e-14
    return [f"ends up {swapped:.1f} m away"]
