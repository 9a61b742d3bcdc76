"""Angular velocity in rad/s, and a time step for an orientation (book 9.3, 9.4.11)."""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion


def velocity_of_point(
    point: Vector3, position: Vector3, velocity: Vector3, angular_velocity: Vector3
) -> Vector3:
    """Compute the velocity of a point on an object that moves and rotates about ``position``.

    The result is a new vector in m/s, and the arguments do not change (Eq. 9.6).
    """
    raise NotImplementedError("Exercise B9.18: The velocity of a point, and a rotation step")


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
    raise NotImplementedError("Exercise B9.18: The velocity of a point, and a rotation step")


def first_order_drift(angular_speed: float, duration: float, steps: int) -> tuple[float, float]:
    """Measure the error of a steady rotation that is computed with Eq. 9.5.

    Rotate a unit quaternion about one axis at ``angular_speed`` in rad/s for ``duration`` in s, by
    ``steps`` equal steps of ``Quaternion.add_scaled`` that are never normalized. Return the length
    of the quaternion at the end, and how far the rotation lags behind ``angular_speed`` times
    ``duration``, in radians. This angle is negative for a negative speed. At a speed of 0 nothing
    rotates, so the results are 1 and 0.
    """
    raise NotImplementedError("Exercise B9.19: The errors of Eq. 9.5")
