"""Rates of change and sums, for motions that are given as tables of times in s and vectors.

No function here changes its arguments, and all vectors in the results are new.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.arguments import finite, finite_vector
from ch02_vectors.vector import Vector3


def difference_quotients(
    times: Sequence[float], values: Sequence[Vector3]
) -> tuple[list[float], list[Vector3]]:
    """Compute the average rate of change in each interval (exercise B2.12, book 2.2.1).

    It is the change of the vector divided by the duration. Return the times in the middle of the
    intervals, and the quotients. Both lists are one shorter than ``times``.

    >>> positions = [Vector3(0, 0, 0), Vector3(1, 2, 0), Vector3(5, -2, 0)]
    >>> difference_quotients([0, 0.5, 2.5], positions)
    ([0.25, 1.5], [Vector3(2.0, 4.0, 0.0), Vector3(2.0, -2.0, 0.0)])
    """
    _check_table(times, "values", values, len(times))
    middles, quotients = [], []
    for i in range(len(times) - 1):
        duration = times[i + 1] - times[i]
        middles.append(times[i] + duration / 2.0)
        quotients.append((values[i + 1] - values[i]) / duration)
    return middles, quotients


def add_up_accelerations(
    times: Sequence[float], accelerations: Sequence[Vector3], position: Vector3, velocity: Vector3
) -> tuple[list[Vector3], list[Vector3]]:
    """Compute positions and velocities at all times (exercise B2.13, Eq. 2.8 and 2.9).

    ``accelerations`` has one vector for each interval, in which it is constant. ``position`` and
    ``velocity`` belong to the first time. In an interval of duration h, p' = p + v h + a h^2 / 2
    and v' = v + a h. Return both lists, which begin with copies of the given vectors.
    """
    _check_table(times, "accelerations", accelerations, len(times) - 1)
    positions = [finite_vector("position", position)]
    velocities = [finite_vector("velocity", velocity)]
    for i, acceleration in enumerate(accelerations):
        h = times[i + 1] - times[i]
        p, v = positions[-1], velocities[-1]
        positions.append(p + v * h + acceleration * (h * h / 2.0))
        velocities.append(v + acceleration * h)
    return positions, velocities


def _check_table(
    times: Sequence[float], name: str, vectors: Sequence[Vector3], length: int
) -> None:
    """Raise an error unless the times increase and there is a list of so many finite vectors."""
    if len(times) < 2:
        raise ValueError(f"times must contain at least two times, got {times!r}")
    if len(vectors) != length:
        raise ValueError(f"{name} must contain {length} vectors, got {len(vectors)}")
    for vector in vectors:
        finite_vector(name, vector)
    for i, time in enumerate(times):
        if finite("time", time) <= times[i - 1] and i > 0:
            raise ValueError(f"times must increase, got {time!r} after {times[i - 1]!r}")
