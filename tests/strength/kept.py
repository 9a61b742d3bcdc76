"""The measured figures of each chapter, in one committed file from which the table is made.

Each figure is kept with a fingerprint of what it was measured on. Once that has changed, the figure
is old, and counts as not measured.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from autograder.manifest import ROOT, Chapter
from fingerprint import of_checks

FOLDER = ROOT / "build" / "strength"  # lets a measurement resume; not committed
FILE = Path(__file__).with_name("figures.json")
SECOND = ROOT / "sample_class" / "ada"
MEASURED_ON = {  # each name of figures, and the solution that they were measured on
    "mutants": ROOT / "solutions",
    "seeds of reference": ROOT / "solutions",
    "seeds of second solution": SECOND,
}


def kept(name: str, chapter: Chapter) -> dict[str, Any]:
    """Return the figures of this name, or an empty dict if none of them is valid."""
    figures = dict(_read().get(name, {}).get(chapter.name, {}))
    is_old = figures.pop("measured on", "") != _now(name, chapter)
    return {} if is_old else figures


def keep(name: str, chapter: Chapter, **figures: Any) -> None:
    """Add figures of this name. New ones replace older ones."""
    everything = _read()
    before = everything.setdefault(name, {}).get(chapter.name, {})
    now = _now(name, chapter)
    same = before if before.get("measured on") == now else {}
    everything[name][chapter.name] = same | figures | {"measured on": now}
    FILE.write_text(json.dumps(everything, indent=1, sort_keys=True) + "\n", encoding="utf-8")


def _now(name: str, chapter: Chapter) -> str:
    return of_checks(chapter, MEASURED_ON[name])


def _read() -> dict[str, Any]:
    return dict(json.loads(FILE.read_text(encoding="utf-8"))) if FILE.exists() else {}
