"""Figures that have been measured here, by chapter, in one file for the table."""

from __future__ import annotations

import json
from typing import Any

from autograder.manifest import ROOT, Chapter

FOLDER = ROOT / "build" / "strength"
FILE = FOLDER / "figures.json"


def kept(name: str, chapter: Chapter) -> dict[str, Any]:
    """Return the figures of this name, empty where there are none."""
    return dict(_read().get(name, {}).get(chapter.name, {}))


def keep(name: str, chapter: Chapter, **figures: Any) -> None:
    """Add figures of this name; new ones take the place of older ones."""
    everything = _read()
    everything.setdefault(name, {}).setdefault(chapter.name, {}).update(figures)
    FOLDER.mkdir(parents=True, exist_ok=True)
    FILE.write_text(json.dumps(everything, indent=1) + "\n", encoding="utf-8")


def _read() -> dict[str, Any]:
    return dict(json.loads(FILE.read_text(encoding="utf-8"))) if FILE.exists() else {}
