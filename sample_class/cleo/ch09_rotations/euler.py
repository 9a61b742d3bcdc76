"""Euler angles."""

from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion


def euler_to_quaternion(x, y, z):
    q = Quaternion.from_axis_angle(Vector3(1, 0, 0), x)  # first about X
    q *= Quaternion.from_axis_angle(Vector3(0, 1, 0), y)
    q *= Quaternion.from_axis_angle(Vector3(0, 0, 1), z)
    return q


def rate_map(x, y, z):
    raise NotImplementedError("Exercise B9.17: Three angles, and where they fail")


def euler_rates(x, y, z, angular_velocity):
    raise NotImplementedError("Exercise B9.17: Three angles, and where they fail")
