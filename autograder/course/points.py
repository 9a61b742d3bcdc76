"""Scale the points of exercises and of marks to those that an assignment gives."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction

from autograder.manifest import Chapter
from autograder.reports.marks import Marks
from autograder.scores import possible


def rescaled(points: Mapping[str, float], out_of: float, unit: str = "0.01") -> dict[str, float]:
    """Scale all points by one factor, to multiples of ``unit`` that add up to ``out_of``.

    All points are first rounded down. Then one ``unit`` is added to each of the exercises that lost
    the most by rounding, until the sum is right.
    """
    step = Fraction(unit)
    total = sum(map(Fraction, points.values()))
    exact = {name: Fraction(value) * Fraction(out_of) / total for name, value in points.items()}
    units = {name: value // step for name, value in exact.items()}
    left = round(Fraction(out_of) / step) - sum(units.values())
    by_loss = sorted(exact, key=lambda name: units[name] * step - exact[name])
    for name in by_loss[:left]:
        units[name] += 1
    return {name: plain(count * step) for name, count in units.items()}


def plain(value: Fraction | float) -> float:
    """Return a whole number as an int, so that it is printed as 3 instead of 3.0."""
    return int(value) if value == int(value) else float(value)


def points_of(chapters: Iterable[Chapter]) -> float:
    """Add up the points of all exercises, without extra credit and optional exercises."""
    return possible(exercise for chapter in chapters for exercise in chapter.exercises)


def scaled_marks(marks: Marks, chapters: Iterable[Chapter], manifests: list[Chapter]) -> Marks:
    """Scale marks from the points of the rubrics, in the manifests, to those of an assignment."""
    rubric = {e.id: e.points for chapter in manifests for e in chapter.exercises}
    assigned = {e.id: e.points for chapter in chapters for e in chapter.exercises}
    return {
        (student, name): replace(
            mark, points=round(mark.points * assigned.get(name, rubric[name]) / rubric[name], 2)
        )
        for (student, name), mark in marks.items()
    }
