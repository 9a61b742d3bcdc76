"""Ada's angular motion."""

import math

from ch02_vectors.arguments import finite, finite_vector, positive, whole
from ch09_rotations.matrix import need
from ch09_rotations.quaternion import Quaternion


def velocity_of_point(point, position, velocity, angular_velocity):
    finite_vector("point", point)
    finite_vector("position", position)
    finite_vector("velocity", velocity)
    finite_vector("angular_velocity", angular_velocity)
    return angular_velocity.cross(point - position) + velocity


def integrate_rotation(orientation, angular_velocity, angular_acceleration, duration):
    need("orientation", orientation, Quaternion)
    # look at everything first: a refused step changes nothing
    h = positive("duration", duration)
    finite_vector("angular_velocity", angular_velocity)
    finite_vector("angular_acceleration", angular_acceleration)
    angular_velocity.add_scaled(angular_acceleration, h)
    orientation.rotate_by(angular_velocity * h)
    orientation.normalize()


def first_order_drift(angular_speed, duration, steps):
    finite("angular_speed", angular_speed)
    positive("duration", duration)
    whole("steps", steps)
    x = angular_speed * duration / steps / 2
    length = (1 + x**2) ** (steps / 2)
    return length, 2 * steps * (x - math.atan(x))
