"""Say what is wrong with the files that a student has handed in."""

from __future__ import annotations

import re

from autograder.manifest import Chapter
from autograder.submissions.stage import Staged


def why_nothing(staged: Staged, graded: list[Chapter]) -> str:
    """Say why nothing of a submission can be graded, or return "" if something can.

    Work on other chapters than the graded ones cannot be graded, and is not worth 0 points either.
    """
    rejected = [module for module in staged.rejected if module not in staged.misplaced]
    found = {re.split(r"[./]", name)[0] for name in [*staged.taken, *rejected]}
    names = {chapter.name for chapter in graded}
    if staged.refused or found & names:
        return staged.refused
    if misplaced := _misplaced(staged, graded):
        return "; ".join(misplaced)
    if found:
        return f"it has no files of {', '.join(sorted(names))}, only of {', '.join(sorted(found))}"
    if staged.misplaced:
        return "; ".join(staged.rejected.values())
    there = f". There is {', '.join(staged.others)}" if staged.others else ""
    return f"no folder of a chapter was found, at most three levels down{there}"


def notes_on(staged: Staged, graded: list[Chapter]) -> list[str]:
    """Return the instructor's notes on a student's submission, and on files in the wrong folder."""
    return [*staged.notes, *_misplaced(staged, graded)]


def _misplaced(staged: Staged, graded: list[Chapter]) -> list[str]:
    names = {chapter.name for chapter in graded}
    return [staged.rejected[m] for m in staged.misplaced if m.partition(".")[0] in names]
