"""Draw the error of solutions to an open exercise against their cost, as SVG for a page.

An open exercise has more than one good answer. The Pareto front is a line through the best ones:
every other solution of the same or lower cost has a larger error.
"""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from threading import Lock
from typing import Any

from markupsafe import Markup

from autograder.checks.verdict import Point

_DRAWING = Lock()  # students' pages are written by several threads
# Colors that the page replaces by its own, for light and dark screens.
INK, RULE, DOT, FRONT, OURS, PAPER = (f"#00000{digit}" for digit in range(1, 7))
COLORS = {INK: "ink", RULE: "rule", DOT: "link", FRONT: "held", OURS: "good", PAPER: "paper"}
NO_METADATA = dict.fromkeys(("Creator", "Date", "Format", "Type"))
STYLE: dict[Any, str] = {
    "svg.hashsalt": "chart",  # the same chart is drawn with the same names
    "svg.fonttype": "none",
    "font.family": "sans-serif",
    "axes.edgecolor": RULE,
    "axes.labelcolor": INK,
    "grid.color": RULE,
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
}


def front(points: Sequence[Point]) -> list[Point]:
    """Select the points, each a cost and an error, that no other one equals or beats in both."""
    kept: list[Point] = []
    for cost, error in sorted(points):
        if not kept or error < kept[-1][1]:
            kept.append((cost, error))
    return kept


def draw_chart(
    axes: Sequence[str], points: Sequence[Point], reference: Point | None, what: str
) -> Markup:
    """Draw a dot for each solution, filled on the front, and a diamond for the reference.

    ``axes`` names the cost and the error, and a screen reader says ``what`` the chart shows.
    """
    from matplotlib import rc_context  # slow to import, and few assignments have open exercises
    from matplotlib.figure import Figure
    from matplotlib.ticker import LogLocator

    every = [*points, *([reference] if reference else [])]
    edge = front(every)
    # So wide that at least one of 1, 2, 5, 10, 20 and so on lies on each axis.
    left, right = 0.6 * edge[0][0], 1.6 * max(cost for cost, _ in every)
    bottom, top = 0.6 * edge[-1][1], 1.6 * max(error for _, error in every)
    svg = io.StringIO()
    with _DRAWING, rc_context(STYLE):
        figure = Figure((5.0, 3.0))
        figure.subplots_adjust(left=0.18, right=0.97, bottom=0.17, top=0.97)
        plot = figure.add_subplot(xscale="log", yscale="log", xlabel=axes[0], ylabel=axes[1])
        plot.set(xlim=(left, right), ylim=(bottom, top))
        for axis, ratio in ((plot.xaxis, right / left), (plot.yaxis, top / bottom)):
            axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if ratio < 1000.0 else (1.0,)))
            axis.set_major_formatter("{x:g}")
            axis.minorticks_off()
        plot.grid()
        for point in dict.fromkeys(points):
            fill = DOT if point in edge else PAPER
            plot.plot(*point, "o", color=DOT, markerfacecolor=fill, zorder=3)
        if reference:
            plot.plot(*reference, "D", color=OURS, markerfacecolor="none", zorder=3)
        costs = [edge[0][0], *(cost for cost, _ in edge), right]
        errors = [top, *(error for _, error in edge), edge[-1][1]]
        plot.step(costs, errors, "--", where="post", color=FRONT)
        figure.savefig(svg, format="svg", transparent=True, metadata=NO_METADATA)
    text = svg.getvalue().partition("<svg ")[2]
    for color, name in COLORS.items():
        text = text.replace(color, f"var(--{name})")
    text = re.sub('<g id="[^"]*"', "<g", text)  # there may be several charts on a page
    start = Markup('<svg class="scatter" role="img" aria-label="{}" ').format(what)
    return start + Markup(text.rstrip())
