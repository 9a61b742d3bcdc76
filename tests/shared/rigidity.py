"""The motions that rods still allow the points that they join: the null space of a rigidity matrix.

A rod keeps its ends from moving towards or away from each other: (p_i - p_j) . (v_i - v_j) = 0.
These equations form a matrix. It is solved with fractions, because rounding errors could change its
rank.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import combinations

Position = Sequence[float]


def motions(
    positions: Sequence[Position], rods: Iterable[tuple[int, int]], held: Iterable[int]
) -> list[list[float]]:
    """Return independent motions that the rods allow, each with three numbers for every point.

    ``held`` lists the numbers that must stay 0. Number 3 i + k is the motion of point i along axis
    k.
    """
    count = 3 * len(positions)
    rows = [[Fraction(k == i) for k in range(count)] for i in held]
    for i, j in rods:
        row = [Fraction(0)] * count
        for k in range(3):
            along = Fraction(positions[i][k]) - Fraction(positions[j][k])
            row[3 * i + k] += along
            row[3 * j + k] -= along
        rows.append(row)
    pivots: list[int] = []
    for column in range(count):
        place = len(pivots)
        found = next((i for i in range(place, len(rows)) if rows[i][column]), None)
        if found is None:
            continue
        rows[place], rows[found] = rows[found], rows[place]
        first = rows[place][column]
        rows[place] = [value / first for value in rows[place]]
        for i, row in enumerate(rows):
            if i != place and row[column]:
                rows[i] = [a - row[column] * b for a, b in zip(row, rows[place], strict=True)]
        pivots.append(column)
    free = [column for column in range(count) if column not in pivots]
    found_motions = []
    for column in free:
        motion = [0.0] * count
        motion[column] = 1.0
        for place, pivot in enumerate(pivots):
            motion[pivot] = float(-rows[place][column])
        found_motions.append(motion)
    return found_motions


def changed(positions: Sequence[Position], motion: Sequence[float]) -> tuple[int, int]:
    """Return the first two points whose distance a motion changes. A rod between them forbids it.

    Raises ValueError if the motion changes no distance.
    """
    for i, j in combinations(range(len(positions)), 2):
        rates = (
            (positions[i][k] - positions[j][k]) * (motion[3 * i + k] - motion[3 * j + k])
            for k in range(3)
        )
        if abs(math.fsum(rates)) > 1e-9:
            return i, j
    raise ValueError("the motion changes no distance")


def told(motion: Sequence[float], name: str) -> str:
    """Return in words which points move in a motion, and in which direction."""
    words = []
    for i in range(0, len(motion), 3):
        x, y, z = motion[i : i + 3]
        if x or y or z:
            words.append(f"{name} {i // 3} along ({x:.3g}, {y:.3g}, {z:.3g})".lstrip())
    return ", ".join(words)
