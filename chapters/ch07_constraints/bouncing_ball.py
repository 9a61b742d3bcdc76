"""Going further, complete: a ball that bounces, without steps and without contacts.

All that happens to it are its impacts, and when they are is known: between two of them its height
is a parabola. So nothing is worked out but each impact once, and a height where one is wanted.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, not_negative, positive, whole

LEAST = 1e-12  # m: a ball that would bounce no higher lies still, whatever its restitution


def heights_in_frames(
    height: float,
    speed: float,
    restitution: float,
    frame: float,
    frames: int,
    gravity: float = 9.81,
) -> list[float]:
    """Return a ball's height above the ground in m at the end of each of so many frames.

    It begins at ``height`` in m, above the ground, with ``speed`` in m/s upwards; ``frame`` is in s
    and gravity in m/s^2. Raises ValueError where a height is negative, a speed not finite, a
    restitution outside 0 to 1, frame or gravity not positive, or there is not a whole number of
    frames, 1 or more, which all together last for a finite time.
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
    """Return when a ball that moves freely comes to the ground, in s."""
    return (speed + math.sqrt(speed * speed + 2.0 * gravity * height)) / gravity
