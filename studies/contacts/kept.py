"""Save and load the measurements of contact solvers, from which the lesson's picture is drawn."""

from __future__ import annotations

import json
import platform
from collections.abc import Sequence
from datetime import date
from pathlib import Path

from scenes.timing import significant
from studies.accuracy.measure import Point
from studies.accuracy.results import models_of, time_to
from studies.contacts.scenes import FRAMES

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
    start = {"measured": date.today().isoformat(), "python": platform.python_version()}
    text = json.dumps(start | {"points": rows, "within": within(points)})
    file.write_text(
        text.replace(": [[", ": [\n  [").replace("], [", "],\n  [") + "\n", encoding="utf-8"
    )
