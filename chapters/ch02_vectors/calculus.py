"""Rates of change and sums, for motions that are given as tables of times in s and vectors.

No function here changes its arguments, and all vectors in the results are new.
"""

from __future__ import annotations

from collections.abc import Sequence

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
    raise NotImplementedError("Exercise B2.12: Average rates of change")


def add_up_accelerations(
    times: Sequence[float], accelerations: Sequence[Vector3], position: Vector3, velocity: Vector3
) -> tuple[list[Vector3], list[Vector3]]:
    """Compute positions and velocities at all times (exercise B2.13, Eq. 2.8 and 2.9).

    ``accelerations`` has one vector for each interval, in which it is constant. ``position`` and
    ``velocity`` belong to the first time. In an interval of duration h, p' = p + v h + a h^2 / 2
    and v' = v + a h. Return both lists, which begin with copies of the given vectors.
    """
    raise NotImplementedError("Exercise B2.13: From accelerations back to positions")
