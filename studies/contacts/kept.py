"""Save and load the measurements of the last complete `make contacts`.

They are stored as a JSON file in the project, so that the lesson's picture can be redrawn without
measuring again.
"""

from __future__ import annotations

import json
import platform
from collections.abc import Sequence
from dataclasses import replace
from datetime import date
from pathlib import Path

from studies.accuracy.measure import Point
from studies.contacts.scenes import FRAMES

FILE = Path(__file__).with_name("figures.json")


def rounded(points: Sequence[Point]) -> list[Point]:
    """Round the measurements of the contact solvers to three digits, with times in ms per frame."""

    def digits(value: float) -> float:
        return float(f"{value:.3g}")

    return [
        replace(point, error=digits(point.error), times=[digits(1e3 * point.time / FRAMES)])
        for point in points
    ]


def keep(points: Sequence[Point], file: Path = FILE) -> None:
    """Write the measurements of the contact solvers to ``file`` as JSON, one per line.

    The file also contains today's date and the version of Python.
    """
    start = {"measured": date.today().isoformat(), "python": platform.python_version()}
    lines = [json.dumps([p.scene, p.model, p.by, p.steps, p.error, p.time]) for p in points]
    text = json.dumps(start, indent=1)[:-2] + ',\n "points": [\n  ' + ",\n  ".join(lines)
    file.write_text(text + "\n ]\n}\n", encoding="utf-8")


def kept(file: Path = FILE) -> list[Point]:
    """Load the stored measurements of the contact solvers, with times in ms per frame."""
    rows = json.loads(file.read_text(encoding="utf-8"))["points"]
    return [
        Point(scene, model, by, steps, error, 0, [time])
        for scene, model, by, steps, error, time in rows
    ]
