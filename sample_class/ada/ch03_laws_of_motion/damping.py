"""Two ways of damping a velocity during one frame: by a share per frame, or a share per second."""

from __future__ import annotations

import math
import sys

from ch02_vectors.vector import Vector3


def damp_per_frame(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    _check(velocity, acceleration, damping, duration)
    return velocity * damping + acceleration * duration


def damp_per_second(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    _check(velocity, acceleration, damping, duration)
    kept = math.exp(duration * math.log(damping)) if damping else 0.0
    return velocity * kept + acceleration * duration


def _check(velocity: object, acceleration: object, damping: object, duration: object) -> None:
    """Refuse what neither equation can use."""
    for name, vector in (("velocity", velocity), ("acceleration", acceleration)):
        if not isinstance(vector, Vector3):
            raise TypeError(f"{name} has to be a Vector3 and is {vector!r}")
    for name, number in (("damping", damping), ("duration", duration)):
        if not isinstance(number, (int, float)):
            raise TypeError(f"{name} has to be a number and is {number!r}")
        # An int past the largest float counts as infinite: it compares above it.
        if not 0 <= number <= sys.float_info.max or (number == 0 and name == "duration"):
            above = "above 0" if name == "duration" else "not below 0"
            raise ValueError(f"{name} has to be finite and {above}, and is {number!r}")
