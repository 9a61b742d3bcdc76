"""Angular velocity and acceleration, and a time step for an orientation (book 9.3, 9.4.11).

An angular velocity is a vector in world axes. Its direction is the axis of rotation, and its length
is the angular speed in rad/s.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, finite_vector, instance_of, positive, whole
from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion


def velocity_of_point(
    point: Vector3, position: Vector3, velocity: Vector3, angular_velocity: Vector3
) -> Vector3:
    """Compute the velocity of a point on an object that moves and rotates at the same time.

    The object moves with ``velocity`` in m/s, and rotates about ``position`` in m with
    ``angular_velocity`` in rad/s. ``point`` is the world position of the point in m. The result is
    a new vector in m/s, and the arguments do not change. Book: Eq. 9.6.
    """
    arm = finite_vector("point", point) - finite_vector("position", position)
    turning = finite_vector("angular_velocity", angular_velocity).cross(arm)
    return turning + finite_vector("velocity", velocity)


def integrate_rotation(
    orientation: Quaternion,
    angular_velocity: Vector3,
    angular_acceleration: Vector3,
    duration: float,
) -> None:
    """Rotate an orientation and update its angular velocity by one time step, both in place.

    The step is semi-implicit Euler: first the angular velocity w changes to w' = w + alpha h, and
    then the orientation rotates by w' h. After that it is normalized, because rounding errors would
    otherwise let its length drift. ``angular_acceleration`` (alpha) is in rad/s^2 and does not
    change, and ``duration`` (h) is in s. If the axis of rotation changes, the method has only order
    1.
    """
    positive("duration", duration)
    instance_of("orientation", orientation, Quaternion)
    acceleration = finite_vector("angular_acceleration", angular_acceleration)
    new_velocity = finite_vector("angular_velocity", angular_velocity) + acceleration * duration
    orientation.rotate_by(new_velocity * duration)
    orientation.normalize()
    angular_velocity.add_scaled(acceleration, duration)


def first_order_drift(angular_speed: float, duration: float, steps: int) -> tuple[float, float]:
    """Measure the error of a steady rotation that is computed with Eq. 9.5.

    Rotate a unit quaternion about one axis at ``angular_speed`` in rad/s for ``duration`` in s.
    Make ``steps`` equal steps of ``Quaternion.add_scaled``, and never normalize the quaternion, so
    that the errors add up. The first result is the length of the quaternion at the end, which
    should be 1. The second result says how far the rotation lags behind, in radians:
    ``angular_speed`` times ``duration``, minus the actual angle of rotation. This angle is negative
    for a negative speed. At a speed of 0 nothing rotates, so the results are 1 and 0. Normalizing
    would correct the length (erratum E-31), but not the angle.

    >>> length, angle = first_order_drift(2 * math.pi, 1.0, 60)  # a turn a second, 60 frames
    >>> round(length, 4), round(math.degrees(angle), 4)
    (1.0856, 0.3284)
    """
    half = 0.5 * finite("angular_speed", angular_speed) * positive("duration", duration)
    half /= whole("steps", steps)  # half the angle of a step, which is added at a right angle to q
    length = math.exp(0.5 * steps * math.log1p(half**2))
    return length, 2.0 * steps * (half - math.atan(half))
