"""Find out which failures in a chapter come from mistakes in earlier chapters.

The chapter's checks run again, with our solutions in place of the student's earlier chapters. If a
failed check now passes, an earlier chapter was to blame, and the check is marked as inherited.
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

Run = Callable[[Chapter, list[Path]], list[Verdict]]  # runs a chapter's checks on an engine


@contextmanager
def with_given(
    given: Sequence[Chapter], engine: list[Path], root: Path = ROOT
) -> Iterator[list[Path]]:
    """Yield the folders to search for code, with our solutions to the ``given`` chapters first."""
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


def below_and_not_given(
    chapter: Chapter, given: Sequence[Chapter], root: Path = ROOT
) -> list[Chapter]:
    """List the earlier chapters that a chapter imports, except those given as finished code."""
    return [other for other in chapters_below(chapter, root) if other not in given]


def run_on_given(
    chapter: Chapter,
    verdicts: list[Verdict],
    engine: list[Path],
    below: Sequence[Chapter],
    run: Run,
    root: Path = ROOT,
) -> list[Verdict]:
    """Run a chapter's checks again, with our solutions to earlier chapters if that can help."""
    lost = [verdict for verdict in verdicts if _is_lost(verdict)]
    hung = [v.message.where for v in lost if v.message.kind is Kind.HUNG]
    # An endless loop in this chapter would run again.
    hangs = any(where and where.file.startswith(f"{chapter.name}/") for where in hung)
    available = below and all(has_reference(other, root) for other in below)
    if hangs or not available or all(_is_unwritten(verdict) for verdict in lost):
        return []
    with with_given(below, engine, root) as better:
        return run(chapter, better)


def mark_inherited(verdicts: list[Verdict], again: list[Verdict]) -> list[Verdict]:
    """Mark a failed check as inherited if it passes in the run with our solutions, ``again``."""
    passed = {verdict.name for verdict in again if verdict.status == "passed"}
    return [
        replace(v, status="inherited") if _is_lost(v) and v.name in passed else v for v in verdicts
    ]


def explained_on_given(verdicts: list[Verdict], again: list[Verdict]) -> list[Verdict]:
    """Use the second run's verdicts on checks that failed in both, as only this chapter did it."""
    second = {verdict.name: verdict for verdict in again if _is_lost(verdict)}
    return [second.get(v.name, v) if _is_lost(v) else v for v in verdicts]


def suspects(
    verdicts: list[Verdict], engine: list[Path], below: Sequence[Chapter], run: Run
) -> list[Chapter]:
    """List earlier chapters that fail physics checks, for handouts, which have no solutions."""
    if all(_is_unwritten(verdict) for verdict in verdicts if _is_lost(verdict)):
        return []
    return [
        other
        for other in below
        if any(
            verdict.status != "passed" and not (verdict.robust or _is_unwritten(verdict))
            for verdict in run(other, engine)
        )
    ]


def _is_lost(verdict: Verdict) -> bool:
    return verdict.status in ("failed", "blocked")


def _is_unwritten(verdict: Verdict) -> bool:
    """Return True if a check fails only because a function of its chapter is not written yet."""
    named = (verdict.message.exercise, verdict.exercise)
    numbers = {re.sub(r"^[A-Z]|\..*", "", exercise) for exercise in named}  # 4 for B4.2
    return verdict.message.kind is Kind.UNWRITTEN and len(numbers) == 1
