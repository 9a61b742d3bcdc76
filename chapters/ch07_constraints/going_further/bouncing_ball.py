"""Going further: a bouncing ball, computed from its impacts instead of time steps.

Between two impacts the height of the ball is a parabola, so a formula gives the time of the next
impact. Small time steps are therefore unnecessary. The function computes only the impacts, and the
height at the end of each frame.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, not_negative, positive, whole

LEAST = 1e-12  # m: a ball that would not bounce higher than this comes to rest


def heights_in_frames(
    height: float,
    speed: float,
    restitution: float,
    frame: float,
    frames: int,
    gravity: float = 9.81,
) -> list[float]:
    """Return the height of a ball above the ground in m at the end of each frame.

    The ball starts at ``height`` in m above the ground, and moves upward at ``speed`` in m/s.
    ``frame`` is the duration of a frame in s, and ``frames`` is the number of frames. ``gravity``
    is in m/s^2.

    Raises:
        ValueError: if ``height`` is negative, ``speed`` or the total time is not finite,
            ``restitution`` is not from 0 to 1, ``frame`` or ``gravity`` is not positive, or
            ``frames`` is less than 1.
        TypeError: if an argument is not a number, or ``frames`` is not a whole number.
    """
    not_negative("height", height)
    finite("speed", speed)
    if not 0.0 <= finite("restitution", restitution) <= 1.0:
        raise ValueError(f"restitution must be from 0 to 1, got {restitution!r}")
    positive("frame", frame)
    half = 0.5 * positive("gravity", gravity)
    finite("the time of all frames", frame * whole("frames", frames))
    start, impact = 0.0, _time_of_fall(height, speed, gravity)
    heights = []
    for number in range(1, frames + 1):
        now = number * frame
        while impact <= now:
            height, speed = 0.0, restitution * (gravity * (impact - start) - speed)
            start = impact
            impact += 2.0 * speed / gravity
            if speed * speed <= 2.0 * gravity * LEAST:
                speed, half, impact = 0.0, 0.0, math.inf
        passed = now - start
        heights.append(height + (speed - half * passed) * passed)
    return heights


def _time_of_fall(height: float, speed: float, gravity: float) -> float:
    """Return the time in s that a freely moving ball takes to reach the ground."""
    return (speed + math.sqrt(speed * speed + 2.0 * gravity * height)) / gravity
