"""Euler angles, and why they fail (book 9.2.1).

Three angles x, y and z in radians describe an orientation. The object rotates first by x about the
X axis, then by y about the Y axis, and then by z about the Z axis. All three axes are those of the
world. Every orientation can be described in this way (erratum E-33). But if y is a quarter turn,
the second rotation turns the X axis onto Z or -Z. The first and the last rotation then have the
same axis, so one degree of freedom is lost. This state is called gimbal lock, and it is the reason
why engines store orientations as quaternions. The functions do not change their arguments.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3
from ch09_rotations.quaternion import Quaternion


def euler_to_quaternion(x: float, y: float, z: float) -> Quaternion:
    """Convert three Euler angles to a unit quaternion that describes the same orientation.

    The angles are in radians. The object rotates by x about the world's X axis first, then by y
    about Y, and then by z about Z.
    """
    raise NotImplementedError("Exercise B9.17: Euler angles, and where they fail")


def rate_map(x: float, y: float, z: float) -> Matrix3:
    """Return the matrix that converts the rates of the three Euler angles to an angular velocity.

    The rates are the speeds in rad/s at which the three angles change. The angular velocity is a
    vector in rad/s, in world axes. Each column of the matrix is the axis about which the object
    rotates when only one of the angles changes:

    - First column, for x: the X axis, after it has been rotated by y and then by z.
    - Second column, for y: the Y axis, after it has been rotated by z.
    - Third column, for z: the Z axis itself, because the rotation by z comes last.

    The matrix does not depend on x.
    """
    raise NotImplementedError("Exercise B9.17: Euler angles, and where they fail")


def euler_rates(x: float, y: float, z: float, angular_velocity: Vector3) -> Vector3:
    """Compute how fast the three Euler angles must change to produce ``angular_velocity``.

    The result is a vector that contains the rates of the angles x, y and z in rad/s.
    ``angular_velocity`` is in world axes, and also in rad/s. Near gimbal lock, the rates become
    very large. In gimbal lock, no rates can produce a rotation about the lost axis.

    Raises:
        ValueError: in gimbal lock, which means that |cos y| is at most ``SINGULAR``, a constant of
            matrix3.py. Check this yourself, because ``Matrix3.inverse`` does not always detect
            gimbal lock. It compares the determinant, which is cos y, with the product of the
            lengths of the rows. At z = 0 this product is nearly as small as the determinant, so the
            ratio of the two is not small.
    """
    raise NotImplementedError("Exercise B9.17: Euler angles, and where they fail")
