"""Find the failures of a chapter that are caused by earlier chapters.

The checks of the chapter are run a second time, with the earlier chapters from the reference. A
check that passes in the second run failed only because of an earlier chapter, and is marked as
inherited.
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
    """Create an engine in which the chapters of ``given`` come from the reference.

    Raises:
        ValueError: The reference of a chapter does not exist in ``root``, as in a hand-out.
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
    """Run the checks a second time, with the chapters of ``below`` from the reference.

    Return the verdicts of the second run. There is no second run, and the result is empty, if the
    reference is not available, if all failures come from functions that the student has not written
    yet, or if a loop in this chapter does not end.

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
    """Mark each failed check as inherited if it passed in the second run.

    ``verdicts`` are the verdicts of the first run. ``again`` are the verdicts of the second run.
    """
    passed = {verdict.name for verdict in again if verdict.status == "passed"}
    return [
        replace(verdict, status="inherited")
        if verdict.status in LOST and verdict.name in passed
        else verdict
        for verdict in verdicts
    ]


def explained_on_given(verdicts: list[Verdict], again: list[Verdict]) -> list[Verdict]:
    """Replace the verdict of each check that failed in both runs with the second verdict.

    ``verdicts`` are the verdicts of the first run. ``again`` are the verdicts of the second run.
    The second verdict explains the failure better, because only the student's own chapter can be
    the cause.
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

    Call this function if a second run is not possible. Without a second run, it is unknown which
    failures are inherited, but the student should know that an earlier chapter may be the cause.
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
    """Return the earlier chapters that ``chapter`` uses and that the student has written."""
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
