"""Three angles for an orientation, for input only (book 9.2.1), and where they fail."""

from __future__ import annotations

from ch02_vectors.arguments import finite, finite_vector
from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3
from ch09_rotations.plane import angle_to_vector, rotate_point
from ch09_rotations.quaternion import Quaternion


def euler_to_quaternion(x: float, y: float, z: float) -> Quaternion:
    orientation = Quaternion()
    for scaled_axis in (
        Vector3(finite("x", x), 0.0, 0.0),
        Vector3(0.0, finite("y", y), 0.0),
        Vector3(0.0, 0.0, finite("z", z)),
    ):
        orientation.rotate_by(scaled_axis)
    orientation.normalize()
    return orientation


def rate_map(x: float, y: float, z: float) -> Matrix3:
    return _axes(x, y, z).transpose()


def euler_rates(x: float, y: float, z: float, angular_velocity: Vector3) -> Vector3:
    spin = finite_vector("angular_velocity", angular_velocity)
    try:
        return _axes(x, y, z).inverse().transpose().transform(spin)
    except ValueError as error:
        raise ValueError(f"no rates at the angles {x!r}, {y!r} and {z!r}: {error}") from None


def _axes(x: float, y: float, z: float) -> Matrix3:
    """Return, as rows, what the three angles turn about: X, turned by y and z; Y, by z; Z."""
    finite("x", x)  # no axis depends on it
    along, up = angle_to_vector(finite("y", y))  # from X towards -Z, about Y
    x_axis = (*rotate_point((along, 0.0), z, (0.0, 0.0)), -up)
    y_axis = (*rotate_point((0.0, 1.0), z, (0.0, 0.0)), 0.0)
    return Matrix3(*x_axis, *y_axis, 0.0, 0.0, 1.0)
