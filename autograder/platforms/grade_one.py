"""Grade the submission that Gradescope hands over, and print its results.json.

run_autograder calls it, in the zip that gradescope.py makes.
"""

from __future__ import annotations

import json
import os
import secrets
import sys
import traceback
from dataclasses import replace
from pathlib import Path

from autograder.grader.assignment import Assignment
from autograder.grader.grading import grade_submission
from autograder.isolation.level import choose_level
from autograder.isolation.probe import best_level
from autograder.isolation.sandbox import Level, drop_privileges
from autograder.manifest import ROOT, load_chapters
from autograder.reports.gradescope import as_text, gradescope_results, ungraded_results
from autograder.reports.report import StudentReport
from autograder.submissions.find import Submission, printable


def main(folder: Path, root: Path = ROOT) -> None:
    """Print the results of ``folder``/submission, whatever goes wrong."""
    try:
        results = gradescope_results(grade_one(folder, root))
    except ValueError as error:  # a sentence already
        print(error, file=sys.stderr)
        results = ungraded_results(str(error))
    except Exception as error:
        traceback.print_exc()  # Gradescope shows it to the instructor
        results = ungraded_results(f"{type(error).__name__}: {error}")
    print(as_text(results), end="")


def grade_one(folder: Path, root: Path) -> StudentReport:
    """Return the report on ``folder``/submission, on what the zip's assignment.json asks for.

    The numbers of checks are new in each run. Raises ValueError where there is nothing to grade,
    or no wall to grade it behind.
    """
    settings = json.loads((root / "assignment.json").read_text(encoding="utf-8"))
    submission = folder / "submission"
    if not submission.is_dir():
        raise ValueError(f"there is no folder {submission}")
    level = _level(submission, unsafe=settings["unsafe"])
    chapters = {chapter.number: chapter for chapter in load_chapters(root)}
    graded, given = ([chapters[n] for n in settings[key]] for key in ("chapters", "given"))
    assignment = Assignment(graded, secrets.token_hex(4), level, given, root=root)
    student = students(folder / "submission_metadata.json")
    print(f"grading {student}, seed {assignment.seed}, isolation: {level}", file=sys.stderr)
    report = grade_submission(assignment, Submission(student, submission))
    # A zip that is made so has no reference for a second run.
    return replace(report, score_on_given=None) if settings["unsafe"] else report


def students(metadata: Path) -> str:
    """Return the names of those who hand in, as Gradescope tells them; "submission" for none."""
    try:
        users = json.loads(metadata.read_text(encoding="utf-8"))["users"]
        return ", ".join(printable(user["name"]) for user in users) or "submission"
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return "submission"


def _level(submission: Path, *, unsafe: bool) -> Level:
    """Return the walls that stand here, as grade does.

    Where there is none, and the instructor accepts that, root becomes an unprivileged user first.
    """
    if unsafe and os.geteuid() == 0 and not best_level().is_wall:
        drop_privileges()
    return choose_level(submission, unsafe=unsafe)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
