"""Save and load the measurements of contact solvers, from which the lesson's picture is drawn."""

from __future__ import annotations

import json
import platform
from collections.abc import Sequence
from datetime import date
from pathlib import Path

from studies.accuracy.measure import Point
from studies.accuracy.results import models_of, time_to
from studies.contacts.scenes import FRAMES

FILE = Path(__file__).with_name("figures.json")
TOLERANCES = (1e-1, 1e-2, 1e-3)

Within = tuple[str, float, dict[str, float]]  # scene, tolerance, and ms per frame by solver


def within(points: Sequence[Point]) -> list[Within]:
    """Find how long each solver takes to keep the error of each scene within each tolerance.

    A solver of which no run is accurate enough is left out.
    """
    found = []
    for scene in dict.fromkeys(point.scene for point in points):
        models = models_of([point for point in points if point.scene == scene])
        for tolerance in TOLERANCES:
            times = {name: time_to(own, tolerance) for name, own in models.items()}
            ms = {name: _rounded(1e3 * time / FRAMES, 4) for name, time in times.items() if time}
            found.append((scene, tolerance, ms))
    return found


def keep(points: Sequence[Point], file: Path) -> None:
    """Write the date, the version of Python, all points and the table to a JSON file.

    Each point has an error and a time in ms per frame, both with three digits.
    """
    rows = [
        (p.scene, p.model, p.by, p.steps, _rounded(p.error), _rounded(1e3 * p.time / FRAMES))
        for p in points
    ]
    parts = [
        f'"measured": {json.dumps(date.today().isoformat())}',
        f'"python": {json.dumps(platform.python_version())}',
        *(
            f'"{name}": [\n  ' + ",\n  ".join(map(json.dumps, lines)) + "\n ]"
            for name, lines in (("points", rows), ("within", within(points)))
        ),
    ]
    file.write_text("{\n " + ",\n ".join(parts) + "\n}\n", encoding="utf-8")


def _rounded(value: float, digits: int = 3) -> float:
    return float(f"{value:.{digits}g}")
