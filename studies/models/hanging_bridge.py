"""Compute where the loaded rope bridge of chapter 8 comes to rest, with SciPy.

The computation shares no code with the engine. It solves for the positions and tensions with which
the forces on each plank's end add up to zero, and each taut cable has its length.
"""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy
from scipy.optimize import root  # type: ignore[import-untyped]

from ch08_mass_aggregate.bridge_plan import (
    CABLE_LENGTH,
    GRAVITY,
    HEIGHT,
    PLANK_MASS,
    ROWS,
    anchor_of,
    make_rows,
    support_length,
)

MASSES = [PLANK_MASS + (2.5 if row == 2 else 0.0) for row in range(ROWS)]  # 5 kg on the third row


@cache
def cables() -> list[tuple[int | tuple[float, float], int, float]]:
    """List the start, the end and the length in m of each cable on one side, seen from the side.

    The end is the index of a plank, and the start that of another one, or an anchor's position.
    """
    found: list[tuple[int | tuple[float, float], int, float]] = []
    for i, (end, _) in enumerate(make_rows()):
        anchor = anchor_of(end)
        across = anchor.z - end.position.z
        found.append(((anchor.x, anchor.y), i, math.sqrt(support_length(i) ** 2 - across**2)))
    return found + [(i, i + 1, CABLE_LENGTH) for i in range(ROWS - 1)]


@cache
def hanging(extra: float = 0.0) -> list[tuple[float, float]]:
    """Compute where the planks' ends on one side rest if all cables are ``extra`` m longer."""

    def off(state: Any) -> Any:
        """Compute the net force on each end in N, and the excess length of each cable in m."""
        rows, pulls = state[: 2 * ROWS].reshape(ROWS, 2), state[2 * ROWS :]
        forces = numpy.outer(MASSES, (GRAVITY.x, GRAVITY.y))
        too_long = []
        for (start, end, length), pull in zip(cables(), pulls, strict=True):
            way = rows[end] - (rows[start] if isinstance(start, int) else start)
            now = numpy.hypot(*way)
            too_long.append(now - length - extra)
            forces[end] -= pull / now * way
            if isinstance(start, int):
                forces[start] += pull / now * way
        return numpy.concatenate([forces.ravel(), too_long])

    start = [part for end, _ in make_rows() for part in (end.position.x, 0.75 * HEIGHT)]
    found = root(off, [*start, *(10.0 for _ in cables())], tol=1e-12)
    if not found.success:
        raise ArithmeticError(f"SciPy did not find where the bridge hangs: {found.message}")
    return [(float(x), float(y)) for x, y in found.x[: 2 * ROWS].reshape(ROWS, 2)]
