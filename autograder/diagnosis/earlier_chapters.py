"""Find out which failures in a chapter come from mistakes in earlier chapters.

The chapter's checks run a second time, with our solutions in place of the student's earlier
chapters. If a failed check now passes, an earlier chapter was to blame, and the check is marked as
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
    """Use our solutions instead of the student's code for the ``given`` chapters.

    This context manager yields the folders to search for code. The first is a temporary folder with
    copies of our solutions, and the folders in ``engine`` follow.

    Raises:
        ValueError: ``root`` does not contain our solution to a given chapter. Handouts contain no
            solutions.
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
    """Return True if our solution to a chapter is available. Handouts contain no solutions."""
    return (root / "solutions" / chapter.name).is_dir()


def run_on_given(
    chapter: Chapter,
    verdicts: list[Verdict],
    engine: list[Path],
    below: Sequence[Chapter],
    run: Run,
    root: Path = ROOT,
) -> list[Verdict]:
    """Run a chapter's checks again, with our solutions in place of the student's earlier chapters.

    Return the new verdicts. In the following cases, a second run is impossible or would reveal
    nothing new, so the list is empty:

    - The student wrote no earlier chapter that this one builds on.
    - Our solutions are not available.
    - All failures are due to functions that are not written yet.
    - An endless loop in this chapter would run again.

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
    """Mark a failed check as inherited if it passes with our solutions to the earlier chapters.

    ``verdicts`` comes from the run with the student's own earlier chapters, and ``again`` from the
    run with our solutions.
    """
    passed = {verdict.name for verdict in again if verdict.status == "passed"}
    return [
        replace(verdict, status="inherited")
        if verdict.status in LOST and verdict.name in passed
        else verdict
        for verdict in verdicts
    ]


def explained_on_given(verdicts: list[Verdict], again: list[Verdict]) -> list[Verdict]:
    """For each check that failed in both runs, replace the first verdict with the second.

    ``verdicts`` comes from the first run, and ``again`` from the run with our solutions to the
    earlier chapters. In the second run, only the student's code in this chapter can have caused a
    failure. The second verdict therefore explains the failure better.
    """
    second = {verdict.name: verdict for verdict in again if verdict.status in LOST}
    return [
        second.get(verdict.name, verdict) if verdict.status in LOST else verdict
        for verdict in verdicts
    ]


def suspects(
    verdicts: list[Verdict], engine: list[Path], below: Sequence[Chapter], run: Run
) -> list[Chapter]:
    """List earlier chapters that may have caused a failure, because they fail checks themselves.

    A handout contains no solutions, so the checks cannot be repeated with correct earlier chapters.
    Instead, this list is used to warn the student about earlier chapters. The list is empty if all
    failures in ``verdicts`` come from functions that are not written yet. Robust checks do not
    count, because students leave them open until the physics works.
    """
    lost = [verdict for verdict in verdicts if verdict.status in LOST]
    if all(_is_unwritten(verdict) for verdict in lost):
        return []
    return [
        other
        for other in below
        if any(
            verdict.status != "passed" and not (verdict.robust or _is_unwritten(verdict))
            for verdict in run(other, engine)
        )
    ]


def below_and_not_given(
    chapter: Chapter, given: Sequence[Chapter], root: Path = ROOT
) -> list[Chapter]:
    """List the earlier chapters that a chapter imports, except those given as finished code."""
    return [other for other in chapters_below(chapter, root) if other not in given]


def _is_unwritten(verdict: Verdict) -> bool:
    """Return True if a check fails only because a function of its chapter is not written yet."""
    message = verdict.message
    return message.kind is Kind.UNWRITTEN and _number(message.exercise) == _number(verdict.exercise)


def _number(exercise: str) -> str:
    """Return the chapter number in an exercise id, such as "4" for B4.2."""
    return re.sub(r"^[A-Z]|\..*", "", exercise)


def _hangs(chapter: Chapter, lost: list[Verdict]) -> bool:
    """Return True if a failed check hung in this chapter's code, for example in an endless loop."""
    hung = [verdict.message for verdict in lost if verdict.message.kind is Kind.HUNG]
    return any(m.where and m.where.file.startswith(f"{chapter.name}/") for m in hung)
