"""Save and load the measurements of contact solvers, from which the lesson's picture is drawn."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from scenes.timing import significant
from studies.accuracy.measure import Point
from studies.accuracy.results import models_of, time_to
from studies.contacts.scenes import FRAMES
from studies.stored import store

FILE = Path(__file__).with_name("figures.json")
TOLERANCES = (1e-1, 1e-2, 1e-3)


def within(points: Sequence[Point]) -> list[tuple[str, float, dict[str, float]]]:
    """Find the times in ms per frame of all solvers that meet each tolerance in each scene."""
    found = []
    for scene in dict.fromkeys(point.scene for point in points):
        models = models_of([point for point in points if point.scene == scene])
        for tolerance in TOLERANCES:
            times = {name: time_to(own, tolerance) for name, own in models.items()}
            ms = {name: significant(1e3 * time / FRAMES, 4) for name, time in times.items() if time}
            found.append((scene, tolerance, ms))
    return found


def keep(points: Sequence[Point], file: Path) -> None:
    """Write the date, the version of Python, all points and the table to a JSON file.

    A point is (scene, model, by, steps, error, ms per frame).
    """
    rows = [
        (p.scene, p.model, p.by, p.steps, significant(p.error), significant(1e3 * p.time / FRAMES))
        for p in points
    ]
    store(file, a_row_a_line, points=rows, within=within(points))


def a_row_a_line(found: Any) -> str:
    """Format figures as JSON."""
    return json.dumps(found).replace(": [[", ": [\n  [").replace("], [", "],\n  [")
