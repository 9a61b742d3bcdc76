"""What turns: angular velocity and acceleration, and the step of an orientation (9.4.10, 9.5)."""

from __future__ import annotations

import cmath
import math

from ch02_vectors.arguments import finite, finite_vector, positive, whole
from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion


def velocity_of_point(
    point: Vector3, position: Vector3, velocity: Vector3, angular_velocity: Vector3
) -> Vector3:
    arm = finite_vector("point", point) - finite_vector("position", position)
    spin = finite_vector("angular_velocity", angular_velocity)
    return finite_vector("velocity", velocity) - arm.cross(spin)


def integrate_rotation(
    orientation: Quaternion,
    angular_velocity: Vector3,
    angular_acceleration: Vector3,
    duration: float,
) -> None:
    if not isinstance(orientation, Quaternion):
        raise TypeError(f"orientation must be a Quaternion, got {orientation!r}")
    duration = positive("duration", duration)
    spin = finite_vector("angular_velocity", angular_velocity)
    spin.add_scaled(finite_vector("angular_acceleration", angular_acceleration), duration)
    orientation.rotate_by(spin * duration)  # refuses what has become too large
    orientation.normalize()
    angular_velocity.x, angular_velocity.y, angular_velocity.z = spin


def first_order_drift(angular_speed: float, duration: float, steps: int) -> tuple[float, float]:
    angular_speed, duration = finite("angular_speed", angular_speed), positive("duration", duration)
    x = angular_speed * (duration / whole("steps", steps)) / 2.0
    step = cmath.log(complex(1.0, x))
    try:
        length = math.exp(steps * step.real)
    except OverflowError:
        length = math.inf
    return length, 2.0 * steps * _lag(x, step.imag)


def _lag(x: float, arc_tangent: float) -> float:
    """Return x less its arc tangent: by the series where the two are nearly the same."""
    if abs(x) > 0.1:
        return x - arc_tangent
    return -sum(x * (-x * x) ** n / (2 * n + 1) for n in range(9, 0, -1))
