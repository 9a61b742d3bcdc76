"""Compute where a box of stones balances, both with an engine and exactly."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from ch09_rotations.exercises import Stone, balance_offset, masses_beside
from studies.readings import number, stopped

GRAVITY = 9.81


@dataclass(frozen=True)
class BalanceLine:
    """A line on which a box of stones balances: the one the engine found, and the exact one.

    ``angle`` is in degrees, and ``left`` and ``right`` are the masses on either side in kg.
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
    """Return the stones' exact center of mass, as x and y in m."""
    total = math.fsum(mass for _, mass, _, _ in stones)
    x = math.fsum(mass * x for _, mass, x, _ in stones) / total
    y = math.fsum(mass * y for _, mass, _, y in stones) / total
    return x, y


def balance_line(stones: Sequence[Stone], angle: int) -> BalanceLine:
    """Have the engine find the balance line at ``angle`` degrees, and compute the exact one."""
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
