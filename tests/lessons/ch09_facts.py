"""Compute the numbers of chapter 9's lesson with the reference."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import first_order_drift, velocity_of_point
from ch09_rotations.euler import euler_rates
from ch09_rotations.exercises import back_to_reference, product_without_j_and_k
from ch09_rotations.matrix import Matrix4
from ch09_rotations.matrix3 import Matrix3
from ch09_rotations.plane import center_of_mass, rotate_point, wrap_angle
from ch09_rotations.quaternion import Quaternion

QUARTER = Quaternion.from_axis_angle(Vector3(0, 0, 1), math.pi / 2)


def flat() -> dict[str, float]:
    assert center_of_mass([1, 3], [(0, 0), (4, 0)]) == (3, 0)
    x, y = rotate_point((2, 1), math.pi / 2, (10, 5))
    return {"3.142": math.pi, "6.283": math.tau, "2.283": wrap_angle(4), "9": x, "7": y}


def order() -> dict[str, float]:
    rotated = Matrix3(0, -1, 0, 1, 0, 0, 0, 0, 1).transform(Vector3(2, 3, 5))
    assert rotated == Vector3(-3, 2, 5)
    assert Matrix3(1, 0, 0, 0, 1, 0, 0, 0, -1).determinant() == -1
    return {}


def stretched() -> float:
    """Return the length of the worst column after 1,000 cheap steps of a matrix at 1 rad/s."""
    columns = [Vector3(1), Vector3(0, 1), Vector3(0, 0, 1)]
    for _ in range(1000):
        for column in columns:
            column.add_scaled(Vector3(0, 0, 1).cross(column), 1 / 60)
    return max(column.magnitude() for column in columns)


def quaternions() -> dict[str, float]:
    small = Matrix3.from_quaternion(Quaternion.from_axis_angle(Vector3(1, 2, 3), 0.1))
    turned = Matrix3(1, 0, 0, 0, 1, 0, 0, 0, 1)
    for _ in range(1000):
        turned = small.product(turned)
    square = turned.product(turned.transpose())
    assert max(abs(square[i, j] - (i == j)) for i in range(3) for j in range(3)) < 1e-13
    twice = QUARTER * QUARTER
    assert abs(twice.k - 1) < 1e-15
    return {"0.707": QUARTER.k, "0.5": QUARTER.k**2, "45": math.degrees(math.acos(QUARTER.r))} | {
        "15": 100 * (stretched() - 1)
    }


def propeller() -> dict[str, float]:
    step = Quaternion()
    step.add_scaled(Vector3(0, 0, math.tau), 1 / 15)
    _, missing = first_order_drift(math.tau, 1, 15)
    return {
        "6.283": math.tau,
        "0.4189": math.tau / 15,
        "0.4129": 2 * math.atan2(step.k, step.r),
        "0.09": missing,
        "5.1": math.degrees(missing),
        "0.2094": step.k,
        "1.0217": step.magnitude(),
    }


def tank() -> dict[str, float]:
    placed = Matrix4.from_orientation_and_position(QUARTER, Vector3(10, 0, 5))
    muzzle = placed.transform(Vector3(3, 0, 1))
    assert (placed.transform_inverse(muzzle) - Vector3(3, 0, 1)).magnitude() < 1e-12
    return {"10": muzzle.x, "6": muzzle.z}


def lock() -> dict[str, float]:
    def largest(degrees: float) -> float:
        return euler_rates(0, math.radians(degrees), 0, Vector3(1, 0, 0)).x

    assert abs(largest(60) - 2) < 1e-12
    return {"57": largest(89), "573": largest(89.9)}


def spins() -> dict[str, float]:
    moving = velocity_of_point(Vector3(2), Vector3(), Vector3(), Vector3(0, 0, 3))
    return {"6": moving.y}


def exercises() -> dict[str, float]:
    _, angle = back_to_reference(Quaternion(0.5, 0.5, 0.5, 0.5))
    product = product_without_j_and_k(Quaternion(2, 3), Quaternion(4, -1))
    return {"120": math.degrees(angle), "11": product.r, "10": product.i, "12": 3 * 4}


SECTIONS = {
    "Flat first: one angle": ("5 10 20 90", flat),
    "In space, the order matters": ("5 90", order),
    "Quaternions": ("60 90 180 1e-13", quaternions),
    "Spinning: a rotation step": ("15", propeller),
    "Objects in the world": ("5 90", tank),
    "Euler angles, and where they fail": ("45 60 89 89.9 90", lock),
    "A step for a spinning body": ("", spins),
    "The book's exercises": ("0.5 90", exercises),
}
