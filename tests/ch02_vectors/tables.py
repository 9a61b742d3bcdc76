"""Draw and compare the tables of times and vectors in the checks of B2.12 and B2.13."""

from __future__ import annotations

from random import Random
from typing import Any

from draw import Components, number, rounded
from expect import about, expect_exactly, scoped

TIMES = [0.0, 0.5, 2.5]
ZERO = (0.0, 0.0, 0.0)
# Numbers of up to 200 and intervals of at least 0.2 s have rounding errors below this limit.
SMALL = 1e-11


def draw_times(rng: Random, count: int) -> list[float]:
    """Draw times whose intervals have different lengths. The first time is not 0."""
    times = [number(rng, 1.0, 3.0)]
    for i in range(count - 1):
        times.append(round(times[-1] + (0.2, 0.9)[i % 2] + rng.uniform(0.0, 0.5), 3))
    return times


def shown(rows: list[Components]) -> str:
    return f"[{', '.join(f'Vector3{rounded(row)}' for row in rows)}]"


def flat(rows: list[Components]) -> list[float]:
    return [n for row in rows for n in row]


@scoped
def pair_of_lists(result: Any, lengths: tuple[int, int], names: tuple[str, str]) -> tuple[Any, Any]:
    """Return the two lists of a result, after a check that they are lists of these lengths."""
    __tracebackhide__ = True
    about.cause = f"Return a pair of two lists: the {names[0]} and the {names[1]}."
    is_pair = isinstance(result, (tuple, list)) and len(result) == 2
    are_lists = is_pair and all(isinstance(part, (tuple, list)) for part in result)
    expect_exactly(are_lists, True, then="; is the result a pair of two lists?")
    for part, length, name in zip(result, lengths, names, strict=True):
        about.cause = f"The list of {name} has {len(part)} elements. It must have {length}."
        if len(part) == length + 1 and "quotients" in names:
            about.cause += " Between n times there are only n - 1 intervals."
        if len(part) == length - 1:
            about.cause += " You leave out the first or the last one."
        expect_exactly(len(part), length, then=f"; the number of {name}")
    return result[0], result[1]
