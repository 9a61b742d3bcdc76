"""What turns."""

import math

from ch02_vectors.arguments import finite, finite_vector, positive, whole


def velocity_of_point(point, position, velocity, angular_velocity):
    point = finite_vector("point", point)
    position = finite_vector("position", position)
    velocity = finite_vector("velocity", velocity)
    angular_velocity = finite_vector("angular_velocity", angular_velocity)
    return angular_velocity.cross(point - position) + velocity


def integrate_rotation(orientation, angular_velocity, angular_acceleration, duration):
    positive("duration", duration)
    finite_vector("angular_velocity", angular_velocity)
    finite_vector("angular_acceleration", angular_acceleration)
    # Eq. 9.5 gives a unit quaternion again
    orientation.add_scaled(angular_velocity, duration)
    angular_velocity.add_scaled(angular_acceleration, duration)


def first_order_drift(angular_speed, duration, steps):
    finite("angular_speed", angular_speed)
    positive("duration", duration)
    whole("steps", steps)
    x = angular_speed * duration / steps / 2
    return 1.0, angular_speed * duration - 2 * steps * math.atan(x)
