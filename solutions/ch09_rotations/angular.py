"""What turns: angular velocity and acceleration, and the step of an orientation (book 9.3, 9.4.11).

Angular velocities are vectors in axes of the world, in rad/s: their direction is the axis, and
their length how fast. Raises TypeError for what is no number, no Vector3 or no Quaternion.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, finite_vector, positive, whole
from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion


def velocity_of_point(
    point: Vector3, position: Vector3, velocity: Vector3, angular_velocity: Vector3
) -> Vector3:
    """Return the velocity of a point of an object that moves and turns, as new (Eq. 9.6).

    ``point`` is where it is in the world, ``position`` what the object turns about, ``velocity``
    that one's own: in m and m/s, the angular velocity in rad/s.

    Raises ValueError where a component is not finite.
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
    """Move an orientation and an angular velocity on by one step, in place: semi-implicit Euler.

    The angular velocity first, by w' = w + alpha h; then the orientation turns by w' h, and is
    normalised, so that its length stays 1 whatever the roundings. angular_acceleration in rad/s^2,
    duration in s. Of the first order where the axis moves.

    Raises ValueError where the duration is not positive and finite, or a component of the two
    vectors not finite. What is refused, with TypeError too, changes nothing.
    """
    positive("duration", duration)
    if not isinstance(orientation, Quaternion):
        raise TypeError(f"orientation must be a Quaternion, got {orientation!r}")
    acceleration = finite_vector("angular_acceleration", angular_acceleration)
    new_velocity = finite_vector("angular_velocity", angular_velocity) + acceleration * duration
    orientation.rotate_by(new_velocity * duration)
    orientation.normalize()
    angular_velocity.add_scaled(acceleration, duration)


def first_order_drift(angular_speed: float, duration: float, steps: int) -> tuple[float, float]:
    """Return what Eq. 9.5 does to a steady turn: its length, and the angle that it lacks.

    An orientation of length 1 turns about one axis, by angular_speed in rad/s for duration in s, in
    so many equal steps of ``Quaternion.add_scaled``, and is not normalised. The length is what its
    1 has become; the angle, in radians, is angular_speed times duration less what it has really
    turned by, negative for a negative speed. Normalising would mend the length (E-31) and leave the
    angle as it is.

    >>> length, angle = first_order_drift(2 * math.pi, 1.0, 60)  # a turn a second, 60 frames
    >>> round(length, 4), round(math.degrees(angle), 4)
    (1.0856, 0.3284)

    Raises ValueError where angular_speed is not finite, duration not positive and finite, steps not
    1 or more; OverflowError where the length is too large for a float; TypeError where steps is no
    whole number.
    """
    half = 0.5 * finite("angular_speed", angular_speed) * positive("duration", duration)
    half /= whole("steps", steps)  # half the angle of a step: each adds it at a right angle to q
    length = math.exp(0.5 * steps * math.log1p(half**2))
    return length, 2.0 * steps * (half - math.atan(half))
