"""Angular velocity in rad/s, and a time step for an orientation (book 9.3, 9.4.11)."""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, finite_vector, instance_of, positive, whole
from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion


def velocity_of_point(
    point: Vector3, position: Vector3, velocity: Vector3, angular_velocity: Vector3
) -> Vector3:
    """Compute the velocity of a point on an object that moves and rotates about ``position``.

    The result is a new vector in m/s, and the arguments do not change (Eq. 9.6).
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
    then the orientation rotates by w' h. After that it is normalized, because of rounding errors.
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

    Rotate a unit quaternion about one axis at ``angular_speed`` in rad/s for ``duration`` in s, by
    ``steps`` equal steps of ``Quaternion.add_scaled`` that are never normalized. Return the length
    of the quaternion at the end, and how far the rotation lags behind ``angular_speed`` times
    ``duration``, in radians. This angle is negative for a negative speed. At a speed of 0 nothing
    rotates, so the results are 1 and 0.
    """
    half = 0.5 * finite("angular_speed", angular_speed) * positive("duration", duration)
    half /= whole("steps", steps)  # half the angle of a step, which is added at a right angle to q
    length = math.exp(0.5 * steps * math.log1p(half**2))
    return length, 2.0 * steps * (half - math.atan(half))
