"""Three angles for an orientation, for input only (book 9.2.1), and where they fail.

The angles are turns in radians about axes of the world: by x about X first, then by y about Y, then
by z about Z. Every orientation can be reached so (E-33). But where y is a quarter turn, X has been
turned onto Z or its opposite: the first turn and the last are then about one axis, and two of the
three angles do the work of one. That is gimbal lock, and why an engine keeps a quaternion.

Raises ValueError where an angle or a component is not finite, TypeError for what is no number or no
Vector3.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, finite_vector
from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import SINGULAR, Matrix3
from ch09_rotations.quaternion import Quaternion


def euler_to_quaternion(x: float, y: float, z: float) -> Quaternion:
    """Return the orientation of three angles, of length 1."""
    first = Quaternion.from_axis_angle(Vector3(1.0, 0.0, 0.0), x)
    second = Quaternion.from_axis_angle(Vector3(0.0, 1.0, 0.0), y)
    third = Quaternion.from_axis_angle(Vector3(0.0, 0.0, 1.0), z)
    return third * second * first


def rate_map(x: float, y: float, z: float) -> Matrix3:
    """Return the matrix that takes the rates of the three angles to the angular velocity.

    It depends on y and z; x has no part in it, but must be a finite number too. The rates are the
    components of a Vector3, in rad/s; the angular velocity is in axes of the world. Each column
    is the axis that its angle turns about: Z itself, Y as the turn about Z has left it, X as the
    turns about Y and then Z have.
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
    """Return how fast the three angles change, in rad/s, where an object turns so.

    angular_velocity in rad/s, in axes of the world.

    Raises ValueError in gimbal lock, where |cos y|, the determinant of the rate map, is not above
    SINGULAR of matrix3.py: no rates make a turn about the axis that is lost. Close to it they are
    as large as you like. Matrix3.inverse alone would not refuse all of these: at z = 0, say, a row
    of the map is as short as the determinant is small.
    """
    velocity = finite_vector("angular_velocity", angular_velocity)
    rates = rate_map(x, y, z)
    if not abs(rates.determinant()) > SINGULAR:
        raise ValueError(f"y must not be a quarter turn, where two axes are one, got {y!r}")
    return rates.inverse().transform(velocity)
