"""The reference's earlier chapters under a student's later one: which failures are inherited?"""

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
Run = Callable[[Chapter, list[Path]], list[Verdict]]  # the checks of a chapter, on an engine


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
            for file in (root / "solutions" / chapter.name).glob("*.py*"):  # a site has .pyc
                shutil.copyfile(file, target / file.name)
        yield [Path(folder), *engine]


def is_at_hand(chapter: Chapter, root: Path = ROOT) -> bool:
    """Say whether the reference of a chapter is in this folder."""
    return (root / "solutions" / chapter.name).is_dir()


def run_on_given(
    chapter: Chapter,
    verdicts: list[Verdict],
    engine: list[Path],
    below: Sequence[Chapter],
    run: Run,
    root: Path = ROOT,
) -> list[Verdict]:
    """Return the verdicts of a second run, on the reference's chapters ``below``.

    There is none (so no verdicts) where the reference is not at hand, where nothing is lost but
    what is not written yet, or where a loop does not end. Raises GraderError as run does.
    """
    lost = [verdict for verdict in verdicts if verdict.status in LOST]
    pointless = all(_is_unwritten(verdict) for verdict in lost)
    at_hand = all(is_at_hand(other, root) for other in below)
    if not below or not at_hand or pointless or _hangs(chapter, lost):
        return []
    with with_given(below, engine, root) as better:
        return run(chapter, better)


def mark_inherited(verdicts: list[Verdict], again: list[Verdict]) -> list[Verdict]:
    """Return the verdicts, "inherited" where a lost check passes in the second run."""
    passed = {verdict.name for verdict in again if verdict.status == "passed"}
    return [
        replace(verdict, status="inherited")
        if verdict.status in LOST and verdict.name in passed
        else verdict
        for verdict in verdicts
    ]


def told_on_given(verdicts: list[Verdict], again: list[Verdict]) -> list[Verdict]:
    """Return the verdicts, where a check is lost in both runs as the second one tells it.

    Nothing but the student's own chapter is behind that failure.
    """
    second = {verdict.name: verdict for verdict in again if verdict.status in LOST}
    return [
        second.get(verdict.name, verdict) if verdict.status in LOST else verdict
        for verdict in verdicts
    ]


def suspects(
    verdicts: list[Verdict], engine: list[Path], below: Sequence[Chapter], run: Run
) -> list[Chapter]:
    """Return the chapters below that fail checks of their own, for where there was no second run.

    Nobody can then tell which failures are inherited; that some may be is worth saying.
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
    """Return the chapters below that are the student's own."""
    return [other for other in chapters_below(chapter, root) if other not in given]


def _is_unwritten(verdict: Verdict) -> bool:
    """Say whether a check fails for want of a body of its own chapter."""
    message = verdict.message
    return message.kind is Kind.UNWRITTEN and _number(message.exercise) == _number(verdict.exercise)


def _number(exercise: str) -> str:
    """Return the chapter's number in the id of an exercise: 4 of B4.2."""
    return re.sub(r"^[A-Z]|\..*", "", exercise)


def _hangs(chapter: Chapter, lost: list[Verdict]) -> bool:
    """Say whether a check did not end in this chapter's own code."""
    hung = [verdict.message for verdict in lost if verdict.message.kind is Kind.HUNG]
    return any(one.where and one.where.file.startswith(f"{chapter.name}/") for one in hung)
