"""Find failures that a student's chapter has inherited from earlier chapters.

To find them, the checks of the chapter are run a second time, with the earlier chapters taken from
the reference. A check that fails only in the first run has failed because of an earlier chapter.
"""

from __future__ import annotations

import re
import shutil
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from autograder.checks.verdict import Verdict
from autograder.manifest import ROOT, Chapter, chapters_below
from autograder.message import Kind

LOST = ("failed", "blocked")
Run = Callable[[Chapter, list[Path]], list[Verdict]]  # runs a chapter's checks on an engine


@contextmanager
def with_given(
    given: Sequence[Chapter], engine: list[Path], root: Path = ROOT
) -> Iterator[list[Path]]:
    """Yield an engine in which the given chapters are replaced by those of the reference.

    Raises:
        ValueError: The reference of a chapter is not in this folder, as in a hand-out.
    """
    if not given:
        yield engine
        return
    with tempfile.TemporaryDirectory(prefix="given-") as folder:
        for chapter in given:
            if not has_reference(chapter, root):
                raise ValueError(
                    f"chapter {chapter.number} cannot be given: its reference is not in this folder"
                )
            target = Path(folder) / chapter.name
            target.mkdir()
            for file in (root / "solutions" / chapter.name).glob("*.py*"):  # a site has .pyc
                shutil.copyfile(file, target / file.name)
        yield [Path(folder), *engine]


def has_reference(chapter: Chapter, root: Path = ROOT) -> bool:
    """Return whether this folder contains the reference of a chapter."""
    return (root / "solutions" / chapter.name).is_dir()


def run_on_given(
    chapter: Chapter,
    verdicts: list[Verdict],
    engine: list[Path],
    below: Sequence[Chapter],
    run: Run,
    root: Path = ROOT,
) -> list[Verdict]:
    """Run the checks again, with the chapters ``below`` taken from the reference.

    Return the verdicts of this second run. The result is empty, and nothing is run, in three cases:
    the reference is not available, all failures come from functions that the student has not
    written yet, or a loop in this chapter does not end.

    Raises:
        GraderError: The checks cannot be run.
    """
    lost = [verdict for verdict in verdicts if verdict.status in LOST]
    pointless = all(_is_unwritten(verdict) for verdict in lost)
    available = all(has_reference(other, root) for other in below)
    if not below or not available or pointless or _hangs(chapter, lost):
        return []
    with with_given(below, engine, root) as better:
        return run(chapter, better)


def mark_inherited(verdicts: list[Verdict], again: list[Verdict]) -> list[Verdict]:
    """Return the verdicts. A failed check that passed in the second run is marked as inherited."""
    passed = {verdict.name for verdict in again if verdict.status == "passed"}
    return [
        replace(verdict, status="inherited")
        if verdict.status in LOST and verdict.name in passed
        else verdict
        for verdict in verdicts
    ]


def explained_on_given(verdicts: list[Verdict], again: list[Verdict]) -> list[Verdict]:
    """Return the verdicts of the first run, but replace the verdicts of checks that failed in both.

    For those checks, the verdict of the second run is better, because only the student's own
    chapter can be its cause.
    """
    second = {verdict.name: verdict for verdict in again if verdict.status in LOST}
    return [
        second.get(verdict.name, verdict) if verdict.status in LOST else verdict
        for verdict in verdicts
    ]


def suspects(
    verdicts: list[Verdict], engine: list[Path], below: Sequence[Chapter], run: Run
) -> list[Chapter]:
    """Return the earlier chapters that fail some of their own checks.

    This is used when a second run is not possible. It is then unknown which failures are inherited,
    but the student should know that an earlier chapter may be the cause.
    """
    lost = [verdict for verdict in verdicts if verdict.status in LOST]
    if all(_is_unwritten(verdict) for verdict in lost):
        return []
    return [
        other
        for other in below
        if any(
            verdict.status != "passed" and not _is_unwritten(verdict)
            for verdict in run(other, engine)
        )
    ]


def below_and_not_given(
    chapter: Chapter, given: Sequence[Chapter], root: Path = ROOT
) -> list[Chapter]:
    """Return the earlier chapters that a chapter builds on and that are the student's own work."""
    return [other for other in chapters_below(chapter, root) if other not in given]


def _is_unwritten(verdict: Verdict) -> bool:
    """Return whether a check fails because a function of its own chapter is not written yet."""
    message = verdict.message
    return message.kind is Kind.UNWRITTEN and _number(message.exercise) == _number(verdict.exercise)


def _number(exercise: str) -> str:
    """Return the chapter number in the id of an exercise: 4 in B4.2."""
    return re.sub(r"^[A-Z]|\..*", "", exercise)


def _hangs(chapter: Chapter, lost: list[Verdict]) -> bool:
    """Return whether a check hung in this chapter's own code."""
    hung = [verdict.message for verdict in lost if verdict.message.kind is Kind.HUNG]
    return any(m.where and m.where.file.startswith(f"{chapter.name}/") for m in hung)
