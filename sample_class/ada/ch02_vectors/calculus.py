"""Chapter 2: slopes of a table, and the motion that a table of accelerations leads to."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import accumulate, pairwise

from ch02_vectors.vector import Vector3

State = tuple[Vector3, Vector3]


def difference_quotients(
    times: Sequence[float], values: Sequence[Vector3]
) -> tuple[list[float], list[Vector3]]:
    _require_table(times, values, 0)
    rows = list(zip(times, values, strict=True))
    slopes = [
        (end - start) * (1 / (late - early)) for (early, start), (late, end) in pairwise(rows)
    ]
    return [early / 2 + late / 2 for early, late in pairwise(times)], slopes


def add_up_accelerations(
    times: Sequence[float], accelerations: Sequence[Vector3], position: Vector3, velocity: Vector3
) -> tuple[list[Vector3], list[Vector3]]:
    _require_table(times, accelerations, 1)
    _require_finite([position, velocity])

    def advance(state: State, piece: tuple[float, Vector3]) -> State:
        (place, slow), (span, pull) = state, piece
        fast = slow + span * pull
        return place + (slow + fast) * (span / 2), fast

    spans = [late - early for early, late in pairwise(times)]
    start = position.copy(), velocity.copy()
    states = accumulate(zip(spans, accelerations, strict=True), advance, initial=start)
    places, motions = zip(*states, strict=True)
    return list(places), list(motions)


def _require_table(times: Sequence[float], vectors: Sequence[Vector3], gaps: int) -> None:
    """Raise an error unless the times increase and there are as many vectors, less the gaps."""
    if not all(isinstance(time, (int, float)) for time in times):
        raise TypeError(f"times should be numbers; they are {times!r}")
    rising = all(early < late for early, late in pairwise(times))
    if len(times) < 2 or not rising or not all(map(math.isfinite, times)):
        raise ValueError(f"times should be two or more that rise; they are {times!r}")
    if len(times) != len(vectors) + gaps:
        raise ValueError(f"{len(vectors)} vectors do not fit {len(times)} times")
    _require_finite(vectors)


def _require_finite(vectors: Sequence[Vector3]) -> None:
    for vector in vectors:
        if not isinstance(vector, Vector3):
            raise TypeError(f"a Vector3 is wanted, not {vector!r}")
        if not all(map(math.isfinite, vector)):
            raise ValueError(f"a finite vector is wanted, not {vector!r}")
