"""Sparks that are drawn as rotating squares (book 4.2.3).

The rotation has no effect on the motion of the sparks. Angles are in radians.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, positive

Point = tuple[float, float]


def screen_angle(start: float, rate: float, time: float) -> float:
    """Compute the angle of a spark that rotates on the screen at a constant rate.

    The angle is ``start`` at time 0 and grows by ``rate`` per second. Full turns make no difference
    on the screen, so remove them. The result then lies between -pi and pi.

    >>> screen_angle(0.5, 2.0, 0.25)
    1.0
    """
    angle = finite("start", start) + finite("rate", rate) * finite("time", time)
    return math.remainder(finite("angle", angle), 2.0 * math.pi)


def screen_corners(center: Point, size: float, angle: float) -> list[Point]:
    """Compute the four corners of a rotated square on the screen, in order.

    Its sides have the length ``size``. A positive angle rotates the square from X toward Y. Start
    with the corner that is at the upper right at an angle of 0, and continue in this direction.

    >>> screen_corners((10.0, 20.0), 2.0, 0.0)
    [(11.0, 21.0), (9.0, 21.0), (9.0, 19.0), (11.0, 19.0)]
    """
    x, y = finite("center", center[0]), finite("center", center[1])
    half = positive("size", size) / 2.0
    cosine, sine = math.cos(finite("angle", angle)) * half, math.sin(angle) * half
    return [
        (x + a * cosine - b * sine, y + a * sine + b * cosine)
        for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1))
    ]
