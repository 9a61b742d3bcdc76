"""The measured figures of each chapter, each with a fingerprint of what it was measured on.

A figure counts as not measured once that has changed.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from autograder.manifest import ROOT, Chapter
from fingerprint import of_check_file, of_checks

FOLDER = ROOT / "build" / "strength"  # lets a measurement resume; not committed
FILE = Path(__file__).with_name("figures.json")
SOLUTIONS = {"reference": ROOT / "solutions", "second solution": ROOT / "sample_class" / "ada"}


def mutants_of(chapter: Chapter) -> dict[str, int]:
    """Return how many mutants there are and were killed, or an empty dict if that is not known."""
    return _valid(_read().get("mutants", {}).get(chapter.name, {}), _now(chapter))


def keep_mutants(chapter: Chapter, **figures: int) -> None:
    everything = _read()
    everything.setdefault("mutants", {})[chapter.name] = figures | {"measured on": _now(chapter)}
    _write(everything)


def seeds_of(solution: str, chapter: Chapter) -> dict[str, dict[str, int]]:
    """Return the number of seeds by Python for each file of checks, if its figures are valid."""
    known = _read().get(f"seeds of {solution}", {}).get(chapter.name, {})
    return {
        check.name: _valid(known.get(check.name, {}), _now_of(check, chapter, solution))
        for check in files_of_checks(chapter)
    }


def keep_seeds(solution: str, chapter: Chapter, check: Path, python: str, seeds: int) -> None:
    """Keep with how many seeds a file of checks has passed on a Python, or 0 if it has not."""
    everything = _read()
    files = everything.setdefault(f"seeds of {solution}", {}).setdefault(chapter.name, {})
    now = _now_of(check, chapter, solution)
    files[check.name] = _valid(files.get(check.name, {}), now) | {python: seeds, "measured on": now}
    _write(everything)


def files_of_checks(chapter: Chapter) -> list[Path]:
    return sorted((ROOT / "tests" / chapter.name).glob("test_*.py"))


def _valid(figures: dict[str, Any], now: str) -> dict[str, Any]:
    if figures.get("measured on") != now:
        return {}
    return {name: value for name, value in figures.items() if name != "measured on"}


def _now(chapter: Chapter) -> str:
    return of_checks(chapter, SOLUTIONS["reference"])


def _now_of(check: Path, chapter: Chapter, solution: str) -> str:
    return of_check_file(check, chapter, SOLUTIONS[solution])


def _read() -> dict[str, Any]:
    return dict(json.loads(FILE.read_text(encoding="utf-8"))) if FILE.exists() else {}


def _write(everything: dict[str, Any]) -> None:
    FILE.write_text(json.dumps(everything, indent=1, sort_keys=True) + "\n", encoding="utf-8")
