"""The colors, labels, legends and arrows that the plots of all chapters and studies share."""

from __future__ import annotations

import math
import statistics
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap, LogNorm
from matplotlib.figure import Figure

from scenes.readings import Numbers, is_drawable

# Okabe and Ito's colors, which color-blind readers can tell apart.
BLUE, ORANGE, GREEN, GRAY, BLACK = "#0072B2", "#E69F00", "#009E73", "#777777", "#000000"
RED, SKY, YELLOW, PINK = "#D55E00", "#56B4E9", "#F0E442", "#CC79A7"
VIOLET = "#9600F0"  # one more that can be told apart from these
# The colors of chapter 6's integrators, by name, in all pictures.
COLORS = {
    "explicit Euler": RED,
    "semi-implicit Euler": BLUE,
    "leapfrog": VIOLET,
    "velocity Verlet": SKY,
    "Runge-Kutta 4": GREEN,
    "backward Euler": ORANGE,
    "trapezoidal rule": PINK,
}

THEORY: dict[str, Any] = {"color": GRAY, "lw": 5, "alpha": 0.5}  # of a curve behind the results
LABEL: dict[str, Any] = {
    "fontsize": 12,
    "bbox": {"facecolor": "white", "edgecolor": "none", "pad": 1, "alpha": 0.8},
}

# Red means growth and blue means decay. A gap between them makes even slow growth visible.
GROWTH = ListedColormap(
    [*colormaps["RdBu_r"](range(0, 116)), *colormaps["RdBu_r"](range(140, 256))]
)


@dataclass(frozen=True)
class Picture:
    """A plot and the numbers that it shows, which are saved in a CSV file next to the image."""

    figure: Figure
    columns: Sequence[str]  # the header row
    rows: Sequence[Sequence[object]]


def finish(axes: Axes, title: str, x: str, y: str, legend: int = 0, **settings: Any) -> None:
    """Add a title, labels, a grid, and a legend with letters of size ``legend`` if it is not 0."""
    axes.set(title=title, xlabel=x, ylabel=y, **settings)
    axes.grid(alpha=0.3, which="both")
    if legend:
        axes.legend(fontsize=legend)


def legends(*panels: Axes, size: float = 8, **settings: Any) -> None:
    """Add a grid and a legend to each of the panels, or say that nothing is drawn in it yet."""
    for axes in panels:
        axes.grid(alpha=0.3)
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=size, **settings)
        else:
            axes.text(0.5, 0.5, "not written yet", transform=axes.transAxes, ha="center")


def tell(figure: Figure, notes: Sequence[str]) -> None:
    """Write the reasons why simulations stopped early below a plot, but at most three."""
    lines = [line for note in notes[:3] for line in textwrap.wrap(note, 150)[:2]]
    if len(notes) > 3:
        lines.append(f"and {len(notes) - 3} more like these")
    if lines:
        figure.supxlabel("\n".join(lines), fontsize=8)


def arrow(
    axes: Any, tip: Numbers, label: str, color: str, style: str = "-", tail: Numbers = (0, 0, 0)
) -> None:
    """Draw a vector in the X-Y plane or in 3D as a labeled arrow, unless it has NaN or infinity."""
    if not is_drawable(tip, tail):
        return
    if axes.name == "3d":
        x, y, z = (end - start for end, start in zip(tip, tail, strict=True))
        # In matplotlib the third axis points up, and in the engine the second.
        place = (tail[2], tail[0], tail[1])
        axes.quiver(*place, z, x, y, color=color, lw=2.0, linestyle=style, arrow_length_ratio=0.12)
        beyond = (place[0] + 1.15 * z, place[1] + 1.15 * x, place[2] + 1.15 * y)
        if label:
            axes.text(*beyond, label, color=color, **LABEL)
    else:
        arrowprops = {"arrowstyle": "-|>", "color": color, "linestyle": style, "lw": 2.0}
        axes.annotate("", tip[:2], tail[:2], arrowprops=arrowprops | {"shrinkA": 0, "shrinkB": 0})
        middle = ((tip[0] + tail[0]) / 2, (tip[1] + tail[1]) / 2)
        axes.text(*middle, label, color=color, ha="center", va="center", **LABEL)


def axes_3d(figure: Figure, place: Any, size: float) -> Any:
    """Add a 3D plot to a figure, with +Y pointing up and axes from -size to size."""
    axes: Any = figure.add_subplot(place, projection="3d")
    axes.set(xlim=(-size, size), ylim=(-size, size), zlim=(-size, size))
    axes.set(xlabel="z", ylabel="x", zlabel="y")
    axes.set_box_aspect((1, 1, 1))
    axes.view_init(elev=22, azim=35)
    return axes


def slope(x: Sequence[float], y: Sequence[float]) -> float:
    """Fit a power law y ~ x^p to data, and return p, or NaN if a value is not positive."""
    if not all(value > 0.0 for value in (*x, *y)):
        return math.nan
    return statistics.linear_regression([*map(math.log, x)], [*map(math.log, y)]).slope


def growth_map(
    axes: Axes,
    kappas: Sequence[float],
    dampings: Sequence[float],
    grown: Sequence[Sequence[float]],
    *,
    in_spring: bool,
) -> Any:
    """Draw a heat map of how much oscillations grow in one time step.

    ``grown`` has a row of factors for each damping. Pass the result to ``growth_bar``.
    """
    axes.set(xscale="log", xlim=(kappas[0], kappas[-1]), xlabel="k h$^2$ / m")
    axes.set_ylabel(f"damping of the {'spring, c h / m' if in_spring else 'particle, d$^h$'}")
    shades = [[_shade(value) for value in row] for row in grown]
    return axes.pcolormesh(kappas, dampings, shades, cmap=GROWTH, norm=LogNorm(0.25, 4.0))


def growth_bar(figure: Figure, panels: Any, colored: Any) -> None:
    """Draw the color scale of a heat map from ``growth_map`` beside the panels."""
    label = "growth of the oscillation per step (red: explodes)"
    bar = figure.colorbar(colored, ax=panels, label=label, shrink=0.7, extend="both")
    bar.set_ticks([0.25, 0.5, 1.0, 2.0, 4.0], labels=["1/4", "1/2", "1", "2", "4"])
    bar.minorticks_off()


def _shade(growth: float) -> float:
    """Make a factor clearly red or blue. One above 1 by a rounding error counts as 1."""
    return max(growth, 1.001) if growth > 1.0 + 1e-12 else max(min(growth, 0.999), 0.25)
