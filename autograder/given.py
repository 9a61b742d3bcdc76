"""The reference's earlier chapters under a student's later one: which failures are inherited?"""

from __future__ import annotations

import re
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.runner import Verdict, run_checks

LOST = ("failed", "blocked")


@contextmanager
def with_given(given: list[Chapter], engine: list[Path], root: Path = ROOT) -> Iterator[list[Path]]:
    """Yield an engine that has the reference's modules of the given chapters on top.

    Raises ValueError where the reference of a chapter is not at hand, as in a hand-out.
    """
    with tempfile.TemporaryDirectory(prefix="given-") as folder:
        for chapter in given:
            if not is_at_hand(chapter, root):
                raise ValueError(
                    f"chapter {chapter.number} cannot be given: this folder has no reference of it"
                )
            target = Path(folder) / chapter.name
            target.mkdir()
            for file in (root / "solutions" / chapter.name).glob("*.py"):
                shutil.copyfile(file, target / file.name)
        yield [Path(folder), *engine] if given else engine


def is_at_hand(chapter: Chapter, root: Path = ROOT) -> bool:
    """Say whether the reference of a chapter is in this folder."""
    return (root / "solutions" / chapter.name).is_dir()


def chapters_below(chapter: Chapter, root: Path = ROOT) -> list[Chapter]:
    """Return the chapters with smaller numbers, on which this one may build."""
    return [other for other in load_chapters(root) if other.number < chapter.number]


def mark_inherited(
    chapter: Chapter, verdicts: list[Verdict], engine: list[Path], seed: str
) -> list[Verdict]:
    """Return the verdicts, with "inherited" for the checks that only an earlier chapter fails.

    Such a check passes as soon as the chapters below are the reference's. Where those are not at
    hand, or nothing is lost but what is not written yet, all verdicts stay as they are.
    """
    below = chapters_below(chapter)
    lost = [verdict for verdict in verdicts if verdict.status in LOST]
    if not below or not all(map(is_at_hand, below)) or all(_is_unwritten(v) for v in lost):
        return verdicts
    exercises = list({verdict.exercise for verdict in lost})
    with with_given(below, engine) as better:
        again = run_checks(chapter, better, seed=seed, exercises=exercises)
    passing = {verdict.name for verdict in again if verdict.status == "passed"}
    return [
        replace(verdict, status="inherited")
        if verdict.status in LOST and verdict.name in passing
        else verdict
        for verdict in verdicts
    ]


def suspects(
    chapter: Chapter, verdicts: list[Verdict], engine: list[Path], seed: str
) -> list[Chapter]:
    """Return the chapters below that fail checks of their own, where no reference is at hand.

    Nobody can then tell which failures are inherited; that some may be is worth saying.
    """
    below = chapters_below(chapter)
    lost = [verdict for verdict in verdicts if verdict.status in LOST]
    if all(map(is_at_hand, below)) or all(_is_unwritten(v) for v in lost):
        return []
    return [
        other
        for other in below
        if any(v.status != "passed" for v in run_checks(other, engine, seed=seed))
    ]


def _is_unwritten(verdict: Verdict) -> bool:
    """Say whether a check fails for want of a body of its own chapter."""
    number = verdict.exercise.lstrip("B").partition(".")[0]
    return re.search(rf"not written yet: Exercise B?{number}\.", verdict.message) is not None
