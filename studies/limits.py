"""Where methods fail: the stiffest spring that each bears, beside theory, and what lies outside.

A step is a linear map of place and velocity, so its limit is where the larger eigenvalue leaves 1;
it is found by bisection. Just outside, at 1.02 of the limit, swings must grow; and far inside, what
a method does to the energy in ten thousand swings is measured.
"""

from __future__ import annotations

import argparse
import csv
import math
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

from autograder.manifest import ROOT
from studies.plot import shown

FRAME = 1.0 / 60.0
KEPT = (1.0, 0.9, 0.5)  # of the velocity, by the particle's damping, in a step
LEAST, OUTSIDE, HUGE = 1e-3, 1.02, 1e6
PERIODS = 10_000
STIFFNESS = 100.0  # N/m: 38 frames a swing
State = tuple[float, float]


def main(arguments: list[str]) -> int:
    """Print and write the table; return 1 where a limit is off its theory by more than 5 %."""
    parser = argparse.ArgumentParser(prog="python -m studies limits", description=__doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "limits.csv")
    options = parser.parse_args(arguments)
    sys.path[:0] = [str(ROOT / "solutions"), str(ROOT / "chapters")]
    console = Console(highlight=False)
    with console.status("looking for limits"):
        bounds = spring_limits()
    with console.status(f"letting springs swing {PERIODS} times"):
        drifts = energy_drifts()
    headings = ("method", "kept of v", "limit of k h^2 / m", "theory", "off, %", "steps to x 1e6")
    table = Table(*headings, box=SIMPLE_HEAD, pad_edge=False)
    for name, kept, found, true, steps in bounds:
        off = f"{100.0 * (found / true - 1.0):.1g}" if true else ""
        table.add_row(name, f"{kept:g}", _number(found), _number(true), off, _number(steps))
    console.print(table)
    table = Table("method", f"energy after {PERIODS} swings / energy", box=SIMPLE_HEAD)
    for name, ratio in drifts:
        table.add_row(name, f"{ratio:.6g}")
    console.print(table)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    with options.out.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerows([headings[:4] + headings[5:], *bounds])
        writer.writerows([("method", "energy / energy at the start"), *drifts])
    console.print(
        f"Steps are counted at {OUTSIDE} of the limit; a limit of 0 means growth at {LEAST:g} "
        f"already. The swings are at k h^2 / m = {STIFFNESS * FRAME**2:.3g}, which explicit Euler "
        f"does not bear. All numbers: {shown(options.out)}",
        soft_wrap=True,
    )
    return 0 if all(abs(found - true) <= 0.05 * true for _, _, found, true, _ in bounds) else 1


def spring_limits() -> list[tuple[str, float, float, float, float]]:
    """Return method, share kept, limit, theory, and steps until a swing just outside is huge."""
    from studies.stability import INTEGRATORS, theory

    rows = []
    for name in INTEGRATORS:
        for kept in KEPT:
            growth = partial(_growth_of, name, kept)
            rows.append((name, kept, *limit(growth, theory(name, kept))))
    # A spring of its own is stepped as semi-implicit Euler does, a force by hand as explicit Euler.
    for name, by_hand, true in (("pymunk's spring", False, 4.0), ("pymunk, by hand", True, 0.0)):
        rows.append((name, 1.0, *limit(partial(_growth_in_pymunk, by_hand), true)))
    return rows


def limit(growth: Callable[[float], float], theory: float) -> tuple[float, float, float]:
    """Return a limit of k h^2 / m, what theory has, and how soon a swing just outside is huge.

    That is in steps. The limit is 0 where swings grow at LEAST already; there are no steps then.
    """
    from studies.stability import limit_of

    if growth(LEAST) > 1.0 + 1e-13:
        return 0.0, theory, math.nan
    found = limit_of(growth)
    return found, theory, math.log(HUGE) / math.log(growth(OUTSIDE * found))


def _growth_of(name: str, kept: float, kappa: float) -> float:
    from studies.stability import growth_of

    return growth_of(name, kappa, kept, FRAME)


def _growth_in_pymunk(by_hand: bool, kappa: float) -> float:
    from studies.stability import Pull, growth, solving

    k = kappa / FRAME**2
    return growth(solving(partial(pymunk_step, by_hand), k), Pull(k), FRAME)


def pymunk_step(
    by_hand: bool, x: float, v: float, k: float, c: float, mass: float, duration: float
) -> State:
    """Return place and velocity of a body of pymunk on a spring a step later, as a Solver does."""
    import pymunk

    space = pymunk.Space()
    body = pymunk.Body(mass, 1.0)
    body.position, body.velocity = (x, 0.0), (v, 0.0)
    space.add(body)
    if by_hand:
        body.apply_force_at_world_point((-k * x - c * v, 0.0), body.position)
    else:
        still = space.static_body
        space.add(pymunk.DampedSpring(body, still, (0, 0), (0, 0), 0.0, k, c))
    space.step(duration)
    return body.position.x, body.velocity.x


def energy_drifts() -> list[tuple[str, float]]:
    """Return each method with what many swings have made of an energy of 1."""
    from studies.stability import Pull, methods, solving, step_matrix

    ways = methods(STIFFNESS) | {"pymunk's spring": solving(partial(pymunk_step, False), STIFFNESS)}
    del ways["explicit Euler"]
    steps = round(PERIODS * 2.0 * math.pi / math.sqrt(STIFFNESS) / FRAME)
    return [
        (name, energy_after(step_matrix(way, Pull(STIFFNESS), FRAME), steps))
        for name, way in ways.items()
    ]


def energy_after(matrix: tuple[float, float, float, float], steps: int) -> float:
    """Return the energy after so many steps, in units of that at the start, as the mean of a swing.

    ``matrix`` is that of a step of (x, v h). The energy of a symplectic method swings, and its mean
    stays.
    """
    a, b, c, d = matrix
    swing = round(2.0 * math.pi / math.sqrt(STIFFNESS) / FRAME)
    x, vh, first, last = 1.0, 0.0, 0.0, 0.0
    for i in range(steps + swing):
        energy = 0.5 * STIFFNESS * x * x + 0.5 * (vh / FRAME) ** 2
        if i < swing:
            first += energy
        if i >= steps:
            last += energy
        x, vh = a * x + b * vh, c * x + d * vh
    return last / first


def _number(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.6g}"
