"""Turning sparks for the eye only, in the complex plane of the screen."""

from __future__ import annotations

import cmath
import math

from ch02_vectors.arguments import finite, positive

Point = tuple[float, float]


def screen_angle(start: float, rate: float, time: float) -> float:
    turned = finite("start", start) + finite("rate", rate) * finite("time", time)
    return math.atan2(math.sin(turned), math.cos(turned))


def screen_corners(center: Point, size: float, angle: float) -> list[Point]:
    across, up = center
    middle = complex(finite("center", across), finite("center", up))
    arm = complex(1, 1) * (positive("size", size) / 2)
    arm *= cmath.rect(1.0, finite("angle", angle))
    corners = [middle + arm * quarter for quarter in (1, 1j, -1, -1j)]
    return [(corner.real, corner.imag) for corner in corners]
