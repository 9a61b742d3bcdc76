"""Plots for chapter 7: how well chains of rods keep their length, and the energy of a pendulum."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from matplotlib import pyplot

from ch07_constraints.links import Rod, TwoSidedRod
from plots.drawing import BLACK, BLUE, GRAY, GREEN, ORANGE, PINK, RED, SKY, Picture, tell
from scenes.clock import FRAME
from scenes.constraints import LINK, Link, by_resolver, chain, chain_by_direct_solve, pendulum
from scenes.integrators import INTEGRATORS
from scenes.readings import written
from scenes.track import Track

LINKS = 25
KINDS: dict[str, Link] = {"Rod": Rod, "TwoSidedRod": TwoSidedRod}


def rope_by_method() -> Picture:
    """Plot the length error of a rope made of rods over time, for each simulation method.

    The rope is released at 30 degrees from the vertical.
    """
    figure, axes = pyplot.subplots(figsize=(10, 5.6), layout="constrained")
    frames = 120
    colors = (RED, ORANGE, PINK, SKY, BLUE, GREEN)
    scenes: dict[str, Callable[[], tuple[Track, Track]]] = {
        "Rod": lambda: chain(LINKS, Rod, by_resolver(), frames, 30.0),
        "Rod, 10 times the iterations": lambda: chain(LINKS, Rod, by_resolver(20), frames, 30.0),
        "Rod, 8 substeps": lambda: chain(LINKS, Rod, by_resolver(), frames, 30.0, 8),
        "TwoSidedRod": lambda: chain(LINKS, TwoSidedRod, by_resolver(), frames, 30.0),
        "TwoSidedRod, 8 substeps": lambda: chain(
            LINKS, TwoSidedRod, by_resolver(), frames, 30.0, 8
        ),
        "DirectChain": lambda: chain_by_direct_solve(LINKS, frames, 30.0),
    }
    found = written(scenes)
    rows: list[Sequence[object]] = []
    for color, name in zip(colors, scenes, strict=True):
        if name not in found:
            continue
        run, worst = found[name]
        # A rope whose length is exact except for rounding is drawn at the lower edge.
        off = [max(abs(value), 1e-10) for value in run.values]
        label = f"{name}: at most {max(off):.2g} m"
        axes.semilogy(run.times, off, color=color, lw=3.0 if name == "Rod" else 1.3, label=label)
        rows += [(name, *row) for row in zip(run.times, run.values, worst.values, strict=True)]
    label = f"length of the rope: {LINKS * LINK:g} m"
    axes.axhline(LINKS * LINK, color=GRAY, lw=1, ls=":", label=label)
    last = {name: run.values[-1] for name, (run, _) in found.items()}
    words = [f"{name} {last[name]:.2g}" for name in ("Rod", "DirectChain") if name in last]
    axes.set_title(
        f"{LINKS} links of {LINK:g} m, released at 30$\\degree$: "
        f"error in length after {frames * FRAME:g} s, in m: {', '.join(words)}",
        fontsize=11,
    )
    axes.set(xlabel="time, s", ylabel="error in the length of the rope, m (60 Hz)")
    axes.grid(alpha=0.3)
    figure.legend(fontsize=8, ncols=3, loc="outside lower center")
    tell(figure, [f"{name}: {run.message}" for name, (run, _) in found.items() if run.message])
    columns = ("method", "time, s", "error of the rope, m", "largest error of a rod, m")
    return Picture(figure, columns, rows)


def rods_hold() -> Picture:
    """Plot the largest length error of a rod in a hanging chain against the number of rods.

    Each curve is for a different number of iterations or substeps.
    """
    figure, panels = pyplot.subplots(1, 2, figsize=(12, 5.4), layout="constrained", sharey=True)
    panels[0].set(yscale="log", ylim=(5e-11, 10.0))  # a wrong engine may have no finite error
    # Cases that take longer than all other cases together are left out.
    ways = {
        "default iterations": (None, 1, 30, RED),
        "x 10": (20, 1, 10, ORANGE),
        "x 100": (200, 1, 3, GREEN),
        "4 substeps": (None, 4, 10, SKY),
        "16 substeps": (None, 16, 10, BLUE),
    }
    found = written(
        {
            (kind, way, count): _hanging(KINDS[kind], count, iterations, substeps)
            for kind in KINDS
            for way, (iterations, substeps, most, _) in ways.items()
            for count in (1, 3, 10, 30)
            if count <= most
        }
    )
    rows: list[Sequence[object]] = [(*key, value) for key, (value, _) in found.items()]
    for axes, kind in zip(panels, KINDS, strict=True):
        for way, (*_, color) in ways.items():
            seen = {
                n: max(off, 1e-10) for (k, w, n), (off, _) in found.items() if (k, w) == (kind, way)
            }
            if seen:
                style = "s--" if "substeps" in way else "o-"
                n, off = [*seen.items()][-1]
                label = f"{way}: {off:.2g} m for {n} rods"
                axes.loglog(*zip(*seen.items(), strict=True), style, color=color, ms=5, label=label)
        at = [value for (k, _, n), (value, _) in found.items() if (k, n) == (kind, 10)]
        words = f"{min(at):.2g} to {max(at):.2g}" if at else "?"
        axes.set_title(f"{kind}: the largest error of 10 rods is {words} m", fontsize=10)
        axes.axhline(LINK, color=GRAY, lw=1, ls=":")
        axes.set_xticks((1, 3, 10, 30), ("1", "3", "10", "30"))
        axes.set_xticks([], minor=True)
        axes.set(xlabel="number of rods in the chain, 0.1 m each (dotted)")
        axes.grid(alpha=0.3)
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=8)
        else:
            axes.text(0.5, 0.5, "not written yet", transform=axes.transAxes, ha="center")
    panels[0].set_ylabel("largest error of a rod from 1.5 to 2 s, m (60 Hz; 1e-10 or less at edge)")
    tell(figure, [f"{key}: {message}" for key, (_, message) in found.items() if message])
    return Picture(figure, ("link", "method", "rods", "largest error of a rod, m"), rows)


def pendulum_energy() -> Picture:
    """Plot the energy of a pendulum on a rod for 10 s, starting with the rod horizontal."""
    figure, axes = pyplot.subplots(figsize=(10, 5.6), layout="constrained")
    shown = [("explicit Euler", 60, RED), ("semi-implicit Euler", 60, SKY)]
    shown += [("semi-implicit Euler", 240, PINK), ("semi-implicit Euler", 960, BLACK)]
    shown += [("DirectChain", 60, GREEN)]
    found = written({(name, rate): _swinging(name, rate) for name, rate, _ in shown})
    rows: list[Sequence[object]] = []
    words = []
    for name, rate, color in shown:
        if (run := found.get((name, rate))) is None:
            continue
        label = f"{name}, {rate} Hz: {run.values[-1]:.4g} J at the end"
        axes.plot(run.times, run.values, color=color, lw=1.2, label=label)
        rows += [(name, rate, *row) for row in run.points]
        words.append(f"{100.0 * (run.values[-1] / run.values[0] - 1.0):+.3g} %")
    axes.set_title(
        "A pendulum of 1 m and 1 kg, released from horizontal: change in energy in 10 s, in the "
        f"order of the legend:\n{', '.join(words)}",
        fontsize=11,
    )
    axes.set(xlabel="time, s", ylabel="energy relative to the lowest point, J")
    axes.set_ylim(bottom=0.0)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    notes = [
        f"{name}, {rate} Hz: {run.message}" for (name, rate), run in found.items() if run.message
    ]
    tell(figure, notes)
    return Picture(figure, ("method", "frame rate, Hz", "time, s", "energy, J"), rows)


def _hanging(
    link: Link, count: int, iterations: int | None, substeps: int
) -> Callable[[], tuple[float, str]]:
    """Return a function that simulates a hanging chain for 2 s.

    That function returns the largest error in the length of a rod, in m, and the message of any
    exception.
    """

    def scene() -> tuple[float, str]:
        resolve = by_resolver(iterations)
        _, worst = chain(count, link, resolve, 120, substeps=substeps)
        return max(worst.values[90:], default=math.inf), worst.message

    return scene


def _swinging(name: str, rate: int) -> Callable[[], Track]:
    return lambda: pendulum(INTEGRATORS.get(name), rate, 10.0)
