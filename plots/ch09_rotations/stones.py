"""A plot for chapter 9 that shows the balance lines of a box of stones (exercise 9.7)."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from typing import NamedTuple

from matplotlib import pyplot
from matplotlib.patches import Circle

from ch09_rotations.exercises import Stone, balance_offset, masses_beside
from ch09_rotations.stones import own_stones, read_stones
from plots.ch09_rotations.orientations import largest
from plots.drawing import BLACK, BLUE, GRAY, LABEL, ORANGE, RED, SKY, Picture, legends, tell
from scenes.readings import number, tried

SMALL = LABEL | {"fontsize": 9}


class Line(NamedTuple):
    """A balance line in a certain direction, according to the engine, and its errors."""

    angle: int  # degrees
    offset: float  # m, of the line from the corner of the box
    left: float  # kg, the mass on this side
    right: float  # kg
    miss: float  # m, distance from the center of mass
    torque: float  # N m, of gravity about the line
    true_left: float  # kg, the mass on this side of the exact line
    true_right: float  # kg
    message: str  # the text of the error that stopped the engine, if there was one


def balance_lines() -> Picture:
    """Draw a box of the student's stones, its balance lines, and the masses beside them."""
    masses_beside([("a stone", 1.0, 0.0, 0.0)], 0.0)  # reports a stub even if the file is empty
    stones = read_stones(own_stones())
    if not stones:
        raise ValueError("there are no stones in stones.csv: weigh some for exercise 9.7")
    figure, (left, right) = pyplot.subplots(
        1, 2, figsize=(14, 6.2), layout="constrained", width_ratios=(6, 5)
    )
    heaviest = max(mass for _, mass, _, _ in stones)
    xs, ys = [0.0, *(stone[2] for stone in stones)], [0.0, *(stone[3] for stone in stones)]
    reach = max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0
    for name, mass, x, y in stones:
        radius = 0.07 * reach * math.sqrt(mass / heaviest)
        left.add_patch(Circle((x, y), radius, facecolor=SKY, edgecolor=BLUE, alpha=0.5))
        words = f"{textwrap.fill(name, 16)}\n{mass:g} kg"
        left.text(x, y - 1.1 * radius, words, ha="center", va="top", **SMALL)
    left.axvline(0.0, color=BLACK, lw=2)
    left.axhline(0.0, color=BLACK, lw=2, label="sides of the box, left and front")

    lines = [_line(stones, angle) for angle in range(0, 181, 3)]
    uneven = max(lines[:-1:10], key=lambda line: abs(line.left - line.right))
    sides = f"{uneven.left:.3g} kg on the left, {uneven.right:.3g} kg on the right"
    for line in lines[:-1:10]:
        if math.isfinite(line.offset):
            color, width = (RED, 2.5) if line is uneven else (GRAY, 1.0)
            a = math.radians(line.angle)
            through = (-math.sin(a) * line.offset, math.cos(a) * line.offset)
            beyond = (through[0] + math.cos(a), through[1] + math.sin(a))
            left.axline(through, beyond, color=color, lw=width, zorder=1)
    x, y = _center(stones)
    label = f"exact center of mass: {x:.3f} m, {y:.3f} m"
    left.plot(x, y, "+", color=BLACK, ms=14, mew=2, label=label)
    left.plot([], [], color=GRAY, lw=1, label="balance_offset, every 30°")
    left.plot([], [], color=RED, lw=2.5, label=f"at {uneven.angle}°: {sides}")
    left.set(xlabel="x, m", ylabel="y, m", aspect="equal")
    left.set_xlim(min(xs) - 0.2 * reach, max(xs) + 0.2 * reach)
    left.set_ylim(min(ys) - 0.12 * reach, max(ys) + 0.5 * reach)
    left.legend(fontsize=9, loc="upper left")
    left.set_title(
        f"{len(stones)} stones: the lines miss the center of mass by at most "
        f"{largest([line.miss for line in lines]):.2g} m,\n"
        "the torque of gravity about them is at most "
        f"{largest([line.torque for line in lines]):.2g} N m",
        fontsize=11,
    )
    angles = [line.angle for line in lines]
    off = []
    for name, color, marker in (("left", ORANGE, "o"), ("right", BLUE, "s")):
        seen = [getattr(line, name) for line in lines]
        right.plot(angles, seen, marker, color=color, ms=4, label=f"on the {name}, masses_beside")
        wanted = [getattr(line, f"true_{name}") for line in lines]
        right.plot(angles, wanted, drawstyle="steps-mid", color=color, lw=1)
        off += [abs(a - b) for a, b in zip(seen, wanted, strict=True)]
    right.set_title(
        f"At {uneven.angle}°: {sides} (E-32);\n"
        f"the error of masses_beside (exact: lines) is at most {largest(off):.2g} kg",
        fontsize=11,
    )
    right.set(xlabel="angle of the balance line, degrees", ylabel="mass, kg")
    right.set_xticks(range(0, 181, 30))
    right.set_ylim(0.0, 1.3 * math.fsum(stone[1] for stone in stones))
    legends(right, size=9, loc="upper right")
    tell(figure, [*dict.fromkeys(line.message for line in lines if line.message)])
    rows: list[Sequence[object]] = [("stone", *stone) for stone in stones]
    rows += [("line", *line[:6]) for line in lines]
    head = ("row", "what; angle, degrees", "mass, kg; offset, m", "x, m; mass on the left, kg")
    head = (*head, "y, m; mass on the right, kg", "distance from center, m", "torque, N m")
    return Picture(figure, head, rows)


def _center(stones: Sequence[Stone]) -> tuple[float, float]:
    """Compute the exact center of mass of the stones, as x and y in m."""
    total = math.fsum(mass for _, mass, _, _ in stones)
    x = math.fsum(mass * x for _, mass, x, _ in stones) / total
    return x, math.fsum(mass * y for _, mass, _, y in stones) / total


def _line(stones: Sequence[Stone], angle: int) -> Line:
    """Let the engine compute the balance line in a direction, and measure its errors."""
    a = math.radians(angle)
    acts = (balance_offset, masses_beside)
    (offset, sides), message = tried(lambda: [act(stones, a) for act in acts], (None, None))
    off = number(offset)
    pair = sides if isinstance(sides, tuple) and len(sides) == 2 else (math.nan, math.nan)
    x, y = _center(stones)
    middle = math.cos(a) * y - math.sin(a) * x
    arms = [(mass, math.cos(a) * y - math.sin(a) * x) for _, mass, x, y in stones]
    return Line(
        angle,
        off,
        number(pair[0]),
        number(pair[1]),
        abs(off - middle),
        abs(9.81 * math.fsum(mass * (arm - off) for mass, arm in arms)),
        math.fsum(mass for mass, arm in arms if arm - middle > 1e-9),
        math.fsum(mass for mass, arm in arms if arm - middle < -1e-9),
        message,
    )
