"""Draw the picture that compares pymunk's times with ours in all scenes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

from matplotlib import pyplot
from matplotlib.axes import Axes

from plots.drawing import BLACK, BLUE, GRAY, GREEN, ORANGE
from studies.accuracy.catalog import group_of
from studies.accuracy.results import TOLERANCES, Row

TITLES = (
    "our steps of the same equations",
    "our better models: closed forms, angles, impacts, rest",
)
OPEN = {
    "o": "open: pymunk's time is extrapolated",
    ">": "at least this ratio (pymunk was too slow)",
    "<": "at most this ratio (ours was too slow)",
}
# The color, the mark and the vertical offset in a scene's row of each tolerance.
LOOKS = ((ORANGE, "o", 0.25), (BLUE, "^", 0.0), (GREEN, "s", -0.25))
MARKS = dict(zip(TOLERANCES, LOOKS, strict=True))


def draw_overview(rows: Sequence[Row], png: Path) -> None:
    """Plot the ratio of pymunk's time to ours for every scene and every error tolerance.

    The left panel is for models that step the equations, the right one for better models.
    """
    scenes = list(dict.fromkeys(row.scene for row in rows))[::-1]
    groups = [group_of().get(scene) for scene in scenes]
    figure, panels = pyplot.subplots(
        1, 2, figsize=(13, 0.42 * len(scenes) + 2.6), layout="constrained", sharey=True
    )
    for axes, is_formula, title in zip(panels, (False, True), TITLES, strict=True):
        own = [row for row in rows if row.is_formula == is_formula]
        ends = [end for row in own for end in row.bounds if 0.0 < end < math.inf]
        low, high = min([0.1, *ends]) / 3.0, max([10.0, *ends]) * 3.0
        axes.set(xscale="log", xlim=(low, high), ylim=(-0.7, len(scenes) - 0.3))
        axes.set(yticks=range(len(scenes)), yticklabels=scenes)
        axes.axvspan(low, 1.0, color=GRAY, alpha=0.12, lw=0)
        axes.axvline(1.0, color=BLACK, lw=1)
        for i, (below, above) in enumerate(pairwise(groups)):
            if below != above:
                axes.axhline(i + 0.5, color=GRAY, lw=1)
        for row in own:
            _draw_ratio(axes, row, scenes.index(row.scene))
        axes.set_xlabel("time of pymunk / time of our fastest model with the same error")
        axes.set_title(title, fontsize=11)
        axes.grid(alpha=0.3)
    for tolerance, (color, mark, _) in MARKS.items():
        label = f"error of {tolerance:g} of the scale"
        panels[0].plot([], [], mark, color=color, label=label)
    for mark, label in OPEN.items():
        if mark != "o" or any(row.is_extrapolated for row in rows):
            panels[0].plot([], [], mark, color=GRAY, mfc="none", label=label)
    figure.suptitle(
        "How many times as long as ours does pymunk at its best take? In the gray area it is faster"
    )
    figure.legend(loc="outside lower center", ncols=3, fontsize=9)
    figure.savefig(png, dpi=100)
    pyplot.close(figure)


def _draw_ratio(axes: Axes, row: Row, line: int) -> None:
    """Draw a filled mark, an open one if extrapolated, an arrow if only bounded, or "never"."""
    color, mark, up = MARKS[row.tolerance]
    if row.ratio:
        face = "none" if row.is_extrapolated else color
        axes.plot(row.ratio, line + up, mark, color=color, mfc=face, ms=5)
    elif row.ours.time or row.pymunk.time:
        most = row.ours.time is None
        if (row.ours if most else row.pymunk).never:
            edge = axes.get_xlim()[not most] * (2.5 if most else 0.4)
            axes.text(edge, line + up, "never", color=color, ha="center", va="center", fontsize=7)
        else:
            arrow = "<" if most else ">"
            axes.plot(row.bounds[most], line + up, arrow, color=color, mfc="none", ms=6)
