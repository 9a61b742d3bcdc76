"""Ada's Euler angles."""

import math

from ch02_vectors.arguments import finite, finite_vector
from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import SINGULAR, Matrix3
from ch09_rotations.quaternion import Quaternion

X, Y, Z = Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)


def euler_to_quaternion(x, y, z):
    turn = Quaternion.from_axis_angle
    return turn(Z, z) * turn(Y, y) * turn(X, x)


def rate_map(x, y, z):
    finite("x", x)  # the first turn moves no axis of a later one
    about_y = Quaternion.from_axis_angle(Y, y)
    about_z = Quaternion.from_axis_angle(Z, z)
    return Matrix3.of_rows(about_z.rotate(about_y.rotate(X)), about_z.rotate(Y), Z).transpose()


def euler_rates(x, y, z, angular_velocity):
    if abs(math.cos(y)) <= SINGULAR:
        raise ValueError(f"gimbal lock: y is {y}")
    return (
        rate_map(x, y, z).inverse().transform(finite_vector("angular_velocity", angular_velocity))
    )
