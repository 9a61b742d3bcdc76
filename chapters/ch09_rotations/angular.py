"""Angular velocity and acceleration, and a time step for an orientation (book 9.3 and 9.4.11).

An angular velocity is a vector in world axes, in rad/s. Its direction is the axis of rotation, and
its length is the angular speed. The functions raise TypeError for an argument of the wrong type.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion


def velocity_of_point(
    point: Vector3, position: Vector3, velocity: Vector3, angular_velocity: Vector3
) -> Vector3:
    """Return the velocity of a point on a moving and rotating object as a new vector (Eq. 9.6).

    The object moves with ``velocity`` in m/s, and also rotates about ``position`` in m. ``point``
    is the world position of the point in m. ``angular_velocity`` is in rad/s.

    Raises:
        ValueError: if a component is not finite.
    """
    raise NotImplementedError("Exercise B9.18: The velocity of a point, and a rotation step")


def integrate_rotation(
    orientation: Quaternion,
    angular_velocity: Vector3,
    angular_acceleration: Vector3,
    duration: float,
) -> None:
    """Advance an orientation and an angular velocity, in place, by one step of semi-implicit Euler.

    First the angular velocity w changes to w' = w + alpha h. Then the orientation rotates by w' h.
    Finally it is normalized, so that its length does not drift because of rounding errors.
    ``angular_acceleration`` (alpha) is in rad/s^2 and ``duration`` (h) in s. The method is of order
    1 if the axis of rotation changes.

    Raises:
        ValueError: if the duration is not positive and finite, or a component is not finite. After
            this error and after a TypeError, nothing has changed.
    """
    raise NotImplementedError("Exercise B9.18: The velocity of a point, and a rotation step")


def first_order_drift(angular_speed: float, duration: float, steps: int) -> tuple[float, float]:
    """Return the errors of Eq. 9.5 for a steady rotation: the final length and the missing angle.

    A unit quaternion rotates about one axis at ``angular_speed`` in rad/s for ``duration`` in s. It
    makes ``steps`` equal steps of ``Quaternion.add_scaled``, and is never normalized. The first
    result is its length at the end. The second result is the angle in radians by which it lags
    behind: ``angular_speed`` times ``duration``, minus the angle of the quaternion. This angle is
    negative for a negative speed. Normalizing would correct the length (E-31) but not the angle.

    >>> length, angle = first_order_drift(2 * math.pi, 1.0, 60)  # a turn a second, 60 frames
    >>> round(length, 4), round(math.degrees(angle), 4)
    (1.0856, 0.3284)

    Raises:
        ValueError: if ``angular_speed`` is not finite, ``duration`` is not positive and finite, or
            ``steps`` is less than 1.
        TypeError: if ``steps`` is not a whole number.
        OverflowError: if the length is too large for a float.
    """
    raise NotImplementedError("Exercise B9.19: The errors of Eq. 9.5")
