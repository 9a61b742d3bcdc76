"""The reference's earlier chapters under a student's later one: which failures are inherited?"""

from __future__ import annotations

import re
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from autograder.manifest import ROOT, Chapter, chapters_below
from autograder.runner import GraderError, Verdict, run_checks

LOST = ("failed", "blocked")


@contextmanager
def with_given(
    given: Sequence[Chapter], engine: list[Path], root: Path = ROOT
) -> Iterator[list[Path]]:
    """Yield an engine that has the reference's modules of the given chapters on top.

    Raises ValueError where the reference of a chapter is not at hand, as in a hand-out.
    """
    if not given:
        yield engine
        return
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
        yield [Path(folder), *engine]


def is_at_hand(chapter: Chapter, root: Path = ROOT) -> bool:
    """Say whether the reference of a chapter is in this folder."""
    return (root / "solutions" / chapter.name).is_dir()


def mark_inherited(
    chapter: Chapter,
    verdicts: list[Verdict],
    engine: list[Path],
    seed: str,
    exercises: list[str],
    given: Sequence[Chapter] = (),
) -> tuple[list[Verdict], list[Verdict]]:
    """Return the verdicts, "inherited" where only an earlier chapter fails, and a second run's.

    The second run has the reference's chapters below. A check that passes there is inherited; of
    one that fails there too, its verdict is told, since nothing but this chapter is behind it.
    There is no second run (so no verdicts of it) where the reference is not at hand or given
    already, where nothing is lost but what is not written yet, or where a loop does not end.
    """
    below = [other for other in chapters_below(chapter) if other not in given]
    lost = [verdict for verdict in verdicts if verdict.status in LOST]
    pointless = all(_is_unwritten(verdict) for verdict in lost)
    if not below or not all(map(is_at_hand, below)) or pointless or _hangs(chapter, lost):
        return verdicts, []
    try:
        with with_given(below, engine) as better:
            again = run_checks(chapter, better, seed=seed, exercises=exercises)
    except GraderError:  # the first run stands
        return verdicts, []
    second = {verdict.name: verdict for verdict in again}
    marked = []
    for verdict in verdicts:
        other = second.get(verdict.name, verdict)
        if verdict.status in LOST and other.status == "passed":
            verdict = replace(verdict, status="inherited")
        elif verdict.status in LOST and other.status in LOST:
            verdict = other
        marked.append(verdict)
    return marked, again


def suspects(
    chapter: Chapter,
    verdicts: list[Verdict],
    engine: list[Path],
    seed: str,
    given: Sequence[Chapter] = (),
) -> list[Chapter]:
    """Return the chapters below that fail checks of their own, for where there was no second run.

    Nobody can then tell which failures are inherited; that some may be is worth saying.
    """
    below = [other for other in chapters_below(chapter) if other not in given]
    lost = [verdict for verdict in verdicts if verdict.status in LOST]
    if all(_is_unwritten(verdict) for verdict in lost):
        return []
    return [
        other
        for other in below
        if any(
            verdict.status != "passed" and not _is_unwritten(verdict)
            for verdict in run_checks(other, engine, seed=seed)
        )
    ]


def _is_unwritten(verdict: Verdict) -> bool:
    """Say whether a check fails for want of a body of its own chapter."""
    number = verdict.exercise.lstrip("B").partition(".")[0]
    return re.search(rf"not written yet: Exercise B?{number}\.", verdict.message) is not None


def _hangs(chapter: Chapter, lost: list[Verdict]) -> bool:
    """Say whether a check did not end in this chapter's own code."""
    own = f"where     {chapter.name}/"
    return any("did not end" in verdict.message and own in verdict.message for verdict in lost)
