"""Lines below a box of stones: the masses on their two sides, and how far off they balance."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from ch09_rotations.exercises import Stone, balance_offset, masses_beside
from studies.readings import number, stopped

GRAVITY = 9.81


@dataclass(frozen=True)
class BalanceLine:
    """A line below a box with stones by its angle in degrees: what the engine has, what is true."""

    angle: int
    offset: float
    left: float
    right: float
    message: str
    true_left: float
    true_right: float
    miss: float  # m, how far it passes the center of mass
    torque: float  # N m, of gravity about it


def center(stones: Sequence[Stone]) -> tuple[float, float]:
    """Return the center of mass of stones."""
    total = math.fsum(mass for _, mass, _, _ in stones)
    x = math.fsum(mass * x for _, mass, x, _ in stones) / total
    y = math.fsum(mass * y for _, mass, _, y in stones) / total
    return x, y


def balance_line(stones: Sequence[Stone], angle: int) -> BalanceLine:
    """Return what the engine has of a line by balance_offset and masses_beside, measured."""
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
