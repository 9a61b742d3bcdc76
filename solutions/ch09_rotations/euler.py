"""Euler angles, and why they fail (book 9.2.1).

If y is a quarter turn, the first and the last rotation have the same axis. This is gimbal lock.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, finite_vector
from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import SINGULAR, Matrix3
from ch09_rotations.quaternion import Quaternion


def euler_to_quaternion(x: float, y: float, z: float) -> Quaternion:
    """Return the unit quaternion of Euler angles: by x about X, by y about Y, then by z about Z."""
    first = Quaternion.from_axis_angle(Vector3(1.0, 0.0, 0.0), x)
    second = Quaternion.from_axis_angle(Vector3(0.0, 1.0, 0.0), y)
    third = Quaternion.from_axis_angle(Vector3(0.0, 0.0, 1.0), z)
    return third * second * first


def rate_map(x: float, y: float, z: float) -> Matrix3:
    """Return the matrix that converts the rates of the three Euler angles to an angular velocity.

    Each column of the matrix is the axis about which the object rotates, in world axes, when only
    one of the angles changes: for x the X axis rotated by y and then by z, for y the Y axis rotated
    by z, and for z the Z axis itself. The matrix does not depend on x.
    """
    finite("x", x)
    cos_y, sin_y = math.cos(finite("y", y)), math.sin(y)
    cos_z, sin_z = math.cos(finite("z", z)), math.sin(z)
    return Matrix3(
        *(cos_z * cos_y, -sin_z, 0.0),
        *(sin_z * cos_y, cos_z, 0.0),
        *(-sin_y, 0.0, 1.0),
    )


def euler_rates(x: float, y: float, z: float, angular_velocity: Vector3) -> Vector3:
    """Compute how fast the three Euler angles must change to produce ``angular_velocity``.

    Both vectors are in rad/s. Near gimbal lock, the rates become very large. Raises ValueError in
    gimbal lock, which means that |cos y| is at most ``SINGULAR``. Check this yourself, because
    ``Matrix3.inverse`` does not always detect it.
    """
    velocity = finite_vector("angular_velocity", angular_velocity)
    rates = rate_map(x, y, z)
    if not abs(rates.determinant()) > SINGULAR:
        raise ValueError(f"y must not be a quarter turn (gimbal lock), got {y!r}")
    return rates.inverse().transform(velocity)
