"""Euler angles, and why they fail (book 9.2.1).

If y is a quarter turn, the first and the last rotation have the same axis. This is gimbal lock.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3
from ch09_rotations.quaternion import Quaternion


def euler_to_quaternion(x: float, y: float, z: float) -> Quaternion:
    """Return the unit quaternion of Euler angles: by x about X, by y about Y, then by z about Z."""
    raise NotImplementedError("Exercise B9.17: Euler angles, and where they fail")


def rate_map(x: float, y: float, z: float) -> Matrix3:
    """Return the matrix that converts the rates of the three Euler angles to an angular velocity.

    Each column of the matrix is the axis about which the object rotates, in world axes, when only
    one of the angles changes: for x the X axis rotated by y and then by z, for y the Y axis rotated
    by z, and for z the Z axis itself. The matrix does not depend on x.
    """
    raise NotImplementedError("Exercise B9.17: Euler angles, and where they fail")


def euler_rates(x: float, y: float, z: float, angular_velocity: Vector3) -> Vector3:
    """Compute how fast the three Euler angles must change to produce ``angular_velocity``.

    Both vectors are in rad/s. Near gimbal lock, the rates become very large. Raises ValueError in
    gimbal lock, which means that |cos y| is at most ``SINGULAR``. Check this yourself, because
    ``Matrix3.inverse`` does not always detect it.
    """
    raise NotImplementedError("Exercise B9.17: Euler angles, and where they fail")
