"""Test the instructor's hidden checks on the reference before any student is graded."""

from __future__ import annotations

from autograder.checks.runner import GraderError
from autograder.grader.conditions import Conditions


def check_hidden(conditions: Conditions) -> None:
    """Raise ValueError if hidden checks are missing, cannot be run, or fail on the reference.

    A hidden check that fails on the reference contains a mistake and would cost students points.
    """
    hidden, root = conditions.hidden, conditions.root
    if hidden is None:
        return
    graded = [chapter for chapter in conditions.chapters if (hidden / chapter.name).is_dir()]
    if not graded:
        names = ", ".join(chapter.name for chapter in conditions.chapters)
        raise ValueError(f"--checks must be a folder with one of {names}, got {str(hidden)!r}")
    for chapter in graded:
        folder = hidden / chapter.name
        for probes in (root / "tests" / chapter.name).glob("*probes.py"):
            if (folder / probes.name).exists():
                raise ValueError(
                    f"{folder / probes.name} has the name of a public file. "
                    "Rename it to hidden_probes.py"
                )
        exercises = [exercise.id for exercise in chapter.exercises]
        try:
            engine = [root / "solutions", root / "chapters"]
            verdicts = conditions.run(chapter, engine, exercises=exercises)
        except GraderError as error:
            raise ValueError(f"the checks in {folder} cannot be run: {error}") from error
        if not any(verdict.hidden for verdict in verdicts):
            raise ValueError(f"there is no check in {folder} of a graded exercise: add a test_*.py")
        for check in verdicts:
            if check.status != "passed":
                told = check.secret or check
                raise ValueError(f"{told.name} fails on the reference itself: {told.message}")
