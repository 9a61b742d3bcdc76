"""Compare the contact solvers of chapter 7 in a picture and a table.

Both show the error and the computing time of each solver, measured with different numbers of steps
per frame.
"""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plots.drawing import BLUE, GRAY, GREEN, ORANGE, RED, SKY, Picture
from studies.accuracy.measure import Point
from studies.accuracy.results import models_of, time_to
from studies.contacts.kept import kept
from studies.contacts.scenes import (
    BOOK,
    COLD,
    IMPULSES,
    NET,
    RATIOS,
    ROPE,
    SMALL,
    SOLVERS,
    STACK,
    SWING,
    named,
)

TOLERANCES = (1e-1, 1e-2, 1e-3)
COLUMNS = ("scene", "error", *SOLVERS)
STYLES = {
    BOOK: (RED, "s"),
    COLD: (SKY, "v"),
    IMPULSES: (BLUE, "o"),
    SMALL: (ORANGE, "D"),
    NET: (GREEN, "^"),
}
FLOOR, CEILING = 1e-6, 10.0  # errors outside are not drawn


def of_scene(points: Sequence[Point], scene: str) -> dict[str, list[Point]]:
    """Select the points of one scene, and group them by contact solver.

    The result is a dict from the name of each solver to its points.
    """
    return models_of([point for point in points if point.scene == scene])


def time_within(points: Sequence[Point], scene: str, solver: str, tolerance: float) -> float | None:
    """Find how long a contact solver takes to meet an error tolerance, in ms per frame.

    Return None if none of its runs is accurate enough.
    """
    own = of_scene(points, scene).get(solver)
    return time_to(own, tolerance) if own else None


def table(points: Sequence[Point]) -> list[list[str]]:
    """Build the table that the command prints, with a row for each scene and each tolerance.

    A row shows how long each solver takes to meet the tolerance, or a dash if it never does.
    """
    rows = []
    for scene in dict.fromkeys(point.scene for point in points):
        for tolerance in TOLERANCES:
            times = [time_within(points, scene, solver, tolerance) for solver in SOLVERS]
            told = ["-" if time is None else f"{time:.2g}" for time in times]
            rows.append([scene, f"{tolerance:g}", *told])
    return rows


def draw(points: Sequence[Point]) -> Figure:
    """Draw the picture that compares the contact solvers, which has four panels.

    The upper panels plot the error against the computing time, for a stack and for a swinging rope.
    The lower panels are for a stack and a rope at rest. They plot the time that a solver needs to
    keep the error below 1 %, for each mass ratio.
    """
    figure, panels = pyplot.subplots(2, 2, figsize=(11, 8.4), layout="constrained")
    stack, swing = of_scene(points, named(STACK, 1)), of_scene(points, f"{SWING}, energy")
    _errors(panels[0, 0], stack, "overlap in a stack", "overlap / diameter")
    _errors(panels[0, 1], swing, "change in energy of a swinging rope", "change / energy")
    _ratios(panels[1, 0], points, STACK, "overlap of a stack")
    _ratios(panels[1, 1], points, ROPE, "stretch of a rope")
    handles, labels = [], []
    for axes in panels.flat:
        for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
            if label not in labels:
                handles.append(handle)
                labels.append(label)
    figure.legend(handles, labels, loc="outside lower center", ncols=3)
    return figure


def contact_solvers() -> Picture:
    """Draw the picture of the contact solvers for the lesson of chapter 7.

    It is drawn from measurements that are stored in the project, because measuring takes minutes.
    """
    points = kept()
    return Picture(draw(points), COLUMNS, table(points))


def _errors(axes: Axes, models: dict[str, list[Point]], title: str, what: str) -> None:
    for solver, own in models.items():
        color, marker = STYLES[solver]
        seen = [point for point in own if FLOOR <= point.error <= CEILING]
        axes.loglog(
            [point.time for point in seen],
            [point.error for point in seen],
            color=color,
            marker=marker,
            ms=5,
            label=solver,
        )
    axes.axhline(1e-2, color=GRAY, lw=1, ls=":")
    axes.set(title=f"largest {title} in 1 s", xlabel="time, ms per frame", ylabel=f"largest {what}")
    axes.grid(alpha=0.3)


def _ratios(axes: Axes, points: Sequence[Point], name: str, what: str) -> None:
    for solver, (color, marker) in STYLES.items():
        times = [time_within(points, named(name, ratio), solver, 1e-2) for ratio in RATIOS]
        seen = [(ratio, t) for ratio, t in zip(RATIOS, times, strict=True) if t is not None]
        if seen:
            axes.loglog(*zip(*seen, strict=True), color=color, marker=marker, ms=5, label=solver)
    axes.set_xticks(RATIOS, [f"{ratio:,}" for ratio in RATIOS])
    axes.set_xticks([], minor=True)
    axes.set(
        title=f"time to keep the {what} below 1 %",
        xlabel="mass ratio (no mark: not reached by the longest run)",
        ylabel="time, ms per frame",
    )
    axes.grid(alpha=0.3)
