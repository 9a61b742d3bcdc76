"""Which motions rods leave to the places that they join: the null space of the rigidity matrix.

A rod forbids its ends to move towards or away from each other: (p_i - p_j) . (v_i - v_j) = 0. All
rods together are a matrix, whose rank is what decides: whole numbers are solved without rounding.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import combinations

Place = Sequence[float]


def motions(
    places: Sequence[Place], rods: Iterable[tuple[int, int]], held: Iterable[int]
) -> list[list[float]]:
    """Return independent motions that rods allow, each as three numbers for every place.

    ``held`` are numbers that stay 0: number 3 i + k is how place i moves along axis k.
    """
    count = 3 * len(places)
    rows = [[Fraction(k == i) for k in range(count)] for i in held]
    for i, j in rods:
        row = [Fraction(0)] * count
        for k in range(3):
            way = Fraction(places[i][k]) - Fraction(places[j][k])
            row[3 * i + k] += way
            row[3 * j + k] -= way
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


def changed(places: Sequence[Place], motion: Sequence[float]) -> tuple[int, int]:
    """Return the first two places whose distance a motion changes. A rod there forbids it."""
    for i, j in combinations(range(len(places)), 2):
        rates = (
            (places[i][k] - places[j][k]) * (motion[3 * i + k] - motion[3 * j + k])
            for k in range(3)
        )
        if abs(math.fsum(rates)) > 1e-9:
            return i, j
    raise ValueError("the motion changes no distance")


def told(motion: Sequence[float], name: str) -> str:
    """Return in words which places move in a motion, and along what."""
    words = []
    for i in range(0, len(motion), 3):
        x, y, z = motion[i : i + 3]
        if x or y or z:
            words.append(f"{name} {i // 3} along ({x:.3g}, {y:.3g}, {z:.3g})".lstrip())
    return ", ".join(words)
