"""Compute balance lines of a box of stones with a student's engine, and measure their errors."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from ch09_rotations.exercises import Stone, balance_offset, masses_beside
from scenes.readings import number, stopped

GRAVITY = 9.81


@dataclass(frozen=True)
class BalanceLine:
    """The line on which a box of stones balances, according to a student's engine.

    - ``angle``: the direction of the line in degrees.
    - ``offset``: the distance of the line from the corner of the box, in m.
    - ``left``, ``right``: the masses in kg on the two sides of the line, according to the engine.
    - ``message``: the text of the error that stopped the engine, if there was one.
    - ``true_left``, ``true_right``: the masses in kg on the two sides of the exact line.
    """

    angle: int
    offset: float
    left: float
    right: float
    message: str
    true_left: float
    true_right: float
    miss: float  # m, distance from the center of mass
    torque: float  # N m, torque of gravity about the line


def center(stones: Sequence[Stone]) -> tuple[float, float]:
    """Compute the exact center of mass of the stones, as x and y in m."""
    total = math.fsum(mass for _, mass, _, _ in stones)
    x = math.fsum(mass * x for _, mass, x, _ in stones) / total
    y = math.fsum(mass * y for _, mass, _, y in stones) / total
    return x, y


def balance_line(stones: Sequence[Stone], angle: int) -> BalanceLine:
    """Let the student's engine compute the line on which a box balances, and measure the errors.

    ``angle`` is the direction of the line in degrees.
    """
    a = math.radians(angle)
    found: list[object] = []
    message = stopped(lambda: found.extend((balance_offset(stones, a), masses_beside(stones, a))))
    offset, sides = found if found else (None, None)
    off = number(offset)
    left, right = (
        map(number, sides) if isinstance(sides, tuple) and len(sides) == 2 else (math.nan, math.nan)
    )
    x, y = center(stones)
    middle = math.cos(a) * y - math.sin(a) * x
    arms = [(mass, math.cos(a) * y - math.sin(a) * x) for _, mass, x, y in stones]
    return BalanceLine(
        angle,
        off,
        left,
        right,
        message,
        math.fsum(mass for mass, arm in arms if arm - middle > 1e-9),
        math.fsum(mass for mass, arm in arms if arm - middle < -1e-9),
        abs(off - middle),
        abs(GRAVITY * math.fsum(mass * (arm - off) for mass, arm in arms)),
    )
