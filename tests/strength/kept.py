"""The measured figures of each chapter, in one committed file from which the table is made."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from autograder.manifest import ROOT, Chapter

FOLDER = ROOT / "build" / "strength"  # lets a measurement resume; not committed
FILE = Path(__file__).with_name("figures.json")


def kept(name: str, chapter: Chapter) -> dict[str, Any]:
    """Return the figures of this name, or an empty dict if nothing was measured."""
    return dict(_read().get(name, {}).get(chapter.name, {}))


def keep(name: str, chapter: Chapter, **figures: Any) -> None:
    """Add figures of this name. New ones replace older ones."""
    everything = _read()
    everything.setdefault(name, {}).setdefault(chapter.name, {}).update(figures)
    FILE.write_text(json.dumps(everything, indent=1, sort_keys=True) + "\n", encoding="utf-8")


def _read() -> dict[str, Any]:
    return dict(json.loads(FILE.read_text(encoding="utf-8"))) if FILE.exists() else {}
