"""A plot for chapter 9 that shows how Euler angles fail near gimbal lock."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy
from matplotlib import pyplot

from ch02_vectors.vector import Vector3
from ch09_rotations.euler import euler_rates, rate_map
from plots.ch09_rotations.orientations import entries, largest
from plots.drawing import BLUE, GRAY, GREEN, ORANGE, RED, Picture, slope, tell
from scenes.readings import numbers, stopped, tried, written

X, Z = 0.4, 1.1  # rad, the first and the last Euler angle; any values would do


def gimbal_lock() -> Picture:
    """Plot how Euler angles fail near gimbal lock, where the middle angle is 90°."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.8), layout="constrained")
    degrees = range(-90, 91, 3)
    distances = [10.0 ** (-0.25 * n) for n in range(-7, 25)]  # degrees
    found: dict[str, list[Any]] = written(
        {
            "map": lambda: [_singular_values(math.radians(y)) for y in degrees],
            "rates": lambda: [_worst_rate(math.radians(distance)) for distance in distances],
        }
    )
    rows: list[Sequence[object]] = []
    if "map" in found:
        sines = [abs(math.sin(math.radians(y))) for y in degrees]
        theory = [(math.sqrt(1.0 + s), 1.0, math.sqrt(1.0 - s)) for s in sines]
        names = ("largest", "middle", "smallest")
        for i, (name, color) in enumerate(zip(names, (ORANGE, GREEN, BLUE), strict=True)):
            seen = [triple[i] for triple in found["map"]]
            left.plot(degrees, [t[i] for t in theory], color=GRAY, lw=4, alpha=0.4)
            left.plot(degrees, seen, "o", color=color, ms=4, label=f"{name}: {seen[-1]:.2g} at 90°")
            rows += [(f"{name} singular value", *pair) for pair in zip(degrees, seen, strict=True)]
        off = largest([*abs(numpy.subtract(found["map"], theory)).flat])
        left.set_title(
            f"Singular values of rate_map: the smallest is {found['map'][-1][2]:.2g} at 90°,\n"
            f"all differ from sqrt(1 + |sin y|), 1, sqrt(1 - |sin y|) (gray) by at most {off:.2g}",
            fontsize=11,
        )
        left.legend(fontsize=9, loc="lower center")
    if "rates" in found:
        lengths, messages = zip(*found["rates"], strict=True)
        curve = [1.0 / (math.sqrt(2.0) * math.sin(math.radians(0.5 * d))) for d in distances]
        right.loglog(distances, curve, color=GRAY, lw=4, alpha=0.4, label="1 / sqrt(1 - sin y)")
        label = "length of the result of euler_rates"
        right.loglog(distances, lengths, "o", color=RED, ms=4, label=label)
        refused = [_refuses(math.radians(angle)) for angle in range(0, 360, 30)]
        right.set_title(
            "The Euler rates of 1 rad/s about the worst axis: slope "
            f"{slope(distances[16:], lengths[16:]):.4f};\n"
            f"at 90° euler_rates raises an error for {sum(refused)} of {len(refused)} angles z",
            fontsize=11,
        )
        right.legend(fontsize=9)
        tell(figure, [*dict.fromkeys(filter(None, messages))])
        for distance, length in zip(distances, lengths, strict=True):
            rows.append(("rates, rad/s", 90.0 - distance, length))
    left.set(xlabel="middle angle y, degrees", ylabel="singular value of rate_map, no unit")
    left.set_xticks(range(-90, 91, 30))
    right.set(xlabel="distance of y from 90°, degrees", ylabel="length of the Euler rates, rad/s")
    for axes in (left, right):
        axes.grid(alpha=0.3)
    return Picture(figure, ("what", "y, degrees", "value"), rows)


def _singular_values(y: float) -> list[float]:
    """Compute the singular values of the student's rate_map, largest first, or three times NaN."""
    found = entries(rate_map(X, y, Z))
    if not all(map(math.isfinite, found)):
        return [math.nan] * 3
    return numpy.linalg.svd(numpy.reshape(found, (3, 3)), compute_uv=False).tolist()


def _worst_axis(distance: float, z: float) -> Vector3:
    """Return the axis halfway between Z and the rotated X, which changes the angles fastest.

    The Euler angle y is ``distance`` rad below 90 degrees.
    """
    along = math.cos(0.5 * distance)
    return Vector3(math.cos(z) * along, math.sin(z) * along, math.sin(0.5 * distance))


def _worst_rate(distance: float) -> tuple[float, str]:
    """Return the length of the Euler rates at 1 rad/s about the worst axis, and any error."""
    angles = X, 0.5 * math.pi - distance, Z
    rates, message = tried(lambda: euler_rates(*angles, _worst_axis(distance, Z)), None)
    return math.hypot(*numbers(rates)), message


def _refuses(z: float) -> bool:
    """Return True if euler_rates raises an error for the axis that is lost in gimbal lock."""
    return bool(stopped(lambda: euler_rates(X, 0.5 * math.pi, z, _worst_axis(0.0, z))))
