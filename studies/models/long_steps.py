"""Going further: take steps of several frames, with cubic curves for the frames in between.

The curve through the ends of a step, with the velocities there, has an error of order 4. It is
accurate only while the motion is smooth, because it cannot follow an impact.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from scenes.clock import RATE
from studies.models.smooth_net import hermite_weights

Place = Sequence[float]  # the coordinates of all bodies in a frame, in m


def in_long_steps(
    step: Callable[[], object],
    state: Callable[[], tuple[list[Any], list[Any]]],
    place: Callable[[list[Any]], Place],
    every: int,
    frames: int,
) -> list[Place]:
    """Simulate in steps of ``every`` frames, and return the positions in each frame.

    ``state`` returns all positions and velocities, which ``place`` turns into coordinates.
    """
    places: list[Place] = []
    curve = [hermite_weights(every / RATE, frame / every) for frame in range(1, every)]
    old, fast = state()
    while len(places) < frames:
        step()
        new, later = state()
        ends = [*zip(old, fast, new, later, strict=True)]
        for a, b, c, d in curve:
            places.append(place([a * x + b * v + c * y + d * w for x, v, y, w in ends]))
        places.append(place(new))
        old, fast = new, later
    return places[:frames]
