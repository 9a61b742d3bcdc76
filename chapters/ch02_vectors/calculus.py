"""Rates of change and sums, for motions that are given as tables (book 2.2).

A table consists of a list of times in s and a list of vectors, such as the positions in the
pictures of a film. The intervals between the times may have different lengths. No function here
changes its arguments, and all vectors in the results are new.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.vector import Vector3


def difference_quotients(
    times: Sequence[float], values: Sequence[Vector3]
) -> tuple[list[float], list[Vector3]]:
    """Compute the average rate of change of a vector in each interval between two times.

    The difference quotient of an interval is the change of the vector divided by the duration of
    the interval. From positions in m you get average velocities in m/s, and from velocities you get
    average accelerations. Return the times in the middle of the intervals, and the quotients. Both
    lists are one shorter than ``times``, and you can pass them to this function again.

    Book 2.2.1. Exercise B2.12.

    >>> positions = [Vector3(0, 0, 0), Vector3(1, 2, 0), Vector3(5, -2, 0)]
    >>> difference_quotients([0, 0.5, 2.5], positions)
    ([0.25, 1.5], [Vector3(2.0, 4.0, 0.0), Vector3(2.0, -2.0, 0.0)])
    """
    raise NotImplementedError("Exercise B2.12: Average rates of change")


def add_up_accelerations(
    times: Sequence[float], accelerations: Sequence[Vector3], position: Vector3, velocity: Vector3
) -> tuple[list[Vector3], list[Vector3]]:
    """Compute positions and velocities at all times from the accelerations between the times.

    ``accelerations`` has one vector in m/s^2 for each interval, in which the acceleration is
    constant. ``position`` in m and ``velocity`` in m/s belong to the first time. In an interval of
    duration h, p' = p + v h + a h^2 / 2 and v' = v + a h. Each interval starts with the position
    and the velocity at the end of the one before. Return the positions and the velocities. Both
    lists have as many vectors as ``times``, and begin with copies of the given ones.

    Book 2.2.2, Eq. 2.8 and 2.9. Exercise B2.13.

    >>> brake = [Vector3(0, 0, 0), Vector3(-2, 0, 0)]
    >>> positions, velocities = add_up_accelerations([0, 1, 3], brake, Vector3(), Vector3(6))
    >>> positions
    [Vector3(0.0, 0.0, 0.0), Vector3(6.0, 0.0, 0.0), Vector3(14.0, 0.0, 0.0)]
    >>> velocities
    [Vector3(6.0, 0.0, 0.0), Vector3(6.0, 0.0, 0.0), Vector3(2.0, 0.0, 0.0)]
    """
    raise NotImplementedError("Exercise B2.13: From accelerations back to positions")
