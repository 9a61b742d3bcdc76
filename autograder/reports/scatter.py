"""Lay out a chart that plots the error of each student's solution against its cost.

Such a chart is made for open exercises, which have more than one good answer. Both axes are
logarithmic. This module only computes positions. The template scatter.svg draws the chart.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from autograder.reports.report import Chart, ExerciseReport

LEFT, RIGHT, TOP, BOTTOM = 70.0, 620.0, 20.0, 300.0
MOST_TICKS = 9
Point = Sequence[float]  # cost and error


@dataclass(frozen=True)
class Dot:
    """A dot on an exercise's chart, which shows the cost and the error of one student's solution.

    ``x`` and ``y`` are the position of the dot in the picture. ``best`` is True if every other
    solution of the same or lower cost has a larger error.
    """

    name: str
    cost: float
    error: float
    x: float
    y: float
    best: bool  # whether no solution that costs the same or less has a smaller error


@dataclass(frozen=True)
class Scatter:
    """The layout of an open exercise's chart: the axes, a dot per student, and the Pareto front.

    The Pareto front is a line through the best solutions, which may include ours. A solution is one
    of the best if every other solution of the same or lower cost has a larger error.

    Attributes:
        costs: The ticks on the cost axis, each as a position and a label.
        errors: The ticks on the error axis, each as a position and a label.
        dots: The dots of the students.
        reference: The dot for our solution, or None if there is none.
        front: The corners of the Pareto front, as text for an SVG polyline.
    """

    exercise: ExerciseReport
    axes: Sequence[str]
    costs: list[tuple[float, str]]
    errors: list[tuple[float, str]]
    dots: list[Dot]
    reference: Dot | None
    front: str  # the points of a polyline


def scatter(exercise: ExerciseReport, chart: Chart, named: Sequence[tuple[str, Point]]) -> Scatter:
    """Compute where to draw the axes, the students' dots and the Pareto front on a chart.

    The Pareto front is a line through the best solutions. ``named`` lists each student's name with
    the cost and the error of that student's solution.
    """
    reference = chart.reference
    points = [point for _, point in named] + ([reference] if reference else [])
    costs, errors = _ticks([cost for cost, _ in points]), _ticks([error for _, error in points])
    edge = front(points)

    def dot(name: str, point: Point) -> Dot:
        cost, error = point
        x = _between(cost, costs, LEFT, RIGHT)
        y = _between(error, errors, BOTTOM, TOP)
        return Dot(name, cost, error, round(x, 1), round(y, 1), [*point] in edge)

    corners = [dot("", point) for point in edge]
    line = [(corner.x, corner.y) for corner in corners]
    line = [(line[0][0], TOP), *_stairs(line), (RIGHT, line[-1][1])]
    return Scatter(
        exercise,
        chart.axes,
        [(round(_between(t, costs, LEFT, RIGHT), 1), _label(t)) for t in costs],
        [(round(_between(t, errors, BOTTOM, TOP), 1), _label(t)) for t in errors],
        sorted((dot(*pair) for pair in named), key=lambda d: (d.error, d.cost, d.name)),
        dot("the reference", reference) if reference else None,
        " ".join(f"{x:g},{y:g}" for x, y in line),
    )


def front(points: Sequence[Point]) -> list[list[float]]:
    """Select the solutions on the Pareto front from a list of costs and errors.

    A solution is left out if another one is at least as good in both cost and error. The result is
    sorted by cost, cheapest first.
    """
    kept: list[list[float]] = []
    for cost, error in sorted([*point] for point in points):
        if not kept or error < kept[-1][1]:
            kept.append([cost, error])
    return kept


def _stairs(line: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Connect the best solutions on a chart with a step line, and return the corners of the line.

    The line shows the smallest error that is possible at each cost. It stays level up to the cost
    of the next solution, and then drops vertically.
    """
    corners = line[:1]
    for x, y in line[1:]:
        corners += [(x, corners[-1][1]), (x, y)]
    return corners


def _ticks(values: Sequence[float]) -> list[float]:
    """Choose ticks for a chart's logarithmic axis, such as 0.1, 0.2, 0.5, 1 and 2.

    If there would be more than nine ticks, use only powers of ten.
    """
    low, high = 0.8 * min(values), 1.25 * max(values)
    powers = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    fine = [float(f"{digit}e{power}") for power in powers for digit in (1, 2, 5)]
    first = max(tick for tick in fine if tick <= low)
    last = min(tick for tick in fine if tick >= high)
    ticks = [tick for tick in fine if first <= tick <= last]
    if len(ticks) <= MOST_TICKS:
        return ticks
    every = math.ceil(len(powers) / MOST_TICKS)
    return [10.0**power for power in range(powers[0], powers[-1] + every, every)]


def _between(value: float, ticks: Sequence[float], start: float, end: float) -> float:
    fraction = math.log(value / ticks[0]) / math.log(ticks[-1] / ticks[0])
    return start + fraction * (end - start)


def _label(value: float) -> str:
    return f"{value:g}".replace("e-0", "e-").replace("e+0", "e").replace("e+", "e")
