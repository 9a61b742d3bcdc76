"""The picture of chapter 7 that compares contact solvers, from the measured results."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from matplotlib import pyplot
from matplotlib.axes import Axes

from autograder.manifest import ROOT
from plots.drawing import BLUE, GRAY, GREEN, ORANGE, RED, SKY, Picture

FIGURES = ROOT / "studies" / "contacts" / "figures.json"
STYLES = {
    "the book's resolver": (RED, "s"),
    "without warm starting": (SKY, "v"),
    "sequential impulses": (BLUE, "o"),
    "soft constraints": (ORANGE, "D"),
    "direct net": (GREEN, "^"),
}
RATIOS = (1, 10, 100, 1000)
FLOOR, CEILING = 1e-6, 10.0  # errors outside are not drawn


def contact_solvers(file: Path = FIGURES) -> Picture:
    """Draw the error against the computing time, and the time to keep it below 1 %.

    The table has the time in ms per frame to meet a tolerance, or a dash if it is never met.
    """
    data = json.loads(file.read_text(encoding="utf-8"))
    figure, panels = pyplot.subplots(2, 2, figsize=(11, 8.4), layout="constrained")
    _errors(panels[0, 0], data, "stack, ratio 1", "overlap in a stack", "overlap / diameter")
    swing = "change in energy of a swinging rope", "change / energy"
    _errors(panels[0, 1], data, "swing, energy", *swing)
    _ratios(panels[1, 0], data, "stack", "overlap of a stack")
    _ratios(panels[1, 1], data, "rope", "stretch of a rope")
    shown = {}
    for axes in panels.flat:
        axes.grid(alpha=0.3)
        handles, labels = axes.get_legend_handles_labels()
        shown = dict(zip(labels, handles, strict=True)) | shown
    solvers = [solver for solver in STYLES if solver in shown]
    figure.legend([shown[s] for s in solvers], solvers, loc="outside lower center", ncols=3)
    rows = [
        (scene, f"{error:g}", *(f"{ms[s]:.2g}" if s in ms else "-" for s in STYLES))
        for scene, error, ms in data["within"]
    ]
    return Picture(figure, ("scene", "error", *STYLES), rows)


def _errors(axes: Axes, data: Any, scene: str, title: str, what: str) -> None:
    for solver, (color, marker) in STYLES.items():
        seen = [
            (ms, error)
            for own, model, _, _, error, ms in data["points"]
            if (own, model) == (scene, solver) and FLOOR <= error <= CEILING
        ]
        if seen:
            axes.loglog(*zip(*seen, strict=True), color=color, marker=marker, ms=5, label=solver)
    axes.axhline(1e-2, color=GRAY, lw=1, ls=":")
    axes.set(title=f"largest {title} in 1 s", xlabel="time, ms per frame", ylabel=f"largest {what}")


def _ratios(axes: Axes, data: Any, name: str, what: str) -> None:
    within = {scene: ms for scene, error, ms in data["within"] if error == 1e-2}
    times = {ratio: within.get(f"{name}, ratio {ratio:,}", {}) for ratio in RATIOS}
    for solver, (color, marker) in STYLES.items():
        seen = [(ratio, ms[solver]) for ratio, ms in times.items() if solver in ms]
        if seen:
            axes.loglog(*zip(*seen, strict=True), color=color, marker=marker, ms=5, label=solver)
    axes.set_xticks(RATIOS, [f"{ratio:,}" for ratio in RATIOS])
    axes.set_xticks([], minor=True)
    axes.set(
        title=f"time to keep the {what} below 1 %",
        xlabel="mass ratio (no mark: not reached by the longest run)",
        ylabel="time, ms per frame",
    )
