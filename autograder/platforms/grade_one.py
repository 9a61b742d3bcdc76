"""Grade a submission on Gradescope, where the script run_autograder runs this module."""

from __future__ import annotations

import json
import os
import secrets
import sys
import traceback
from dataclasses import replace
from pathlib import Path
from typing import Any

from autograder.course.dates import deadline_from_json
from autograder.course.lateness import late_on_gradescope
from autograder.grader.conditions import Conditions
from autograder.grader.grading import grade_submission
from autograder.isolation.probe import best_level, choose_level
from autograder.isolation.sandbox import drop_privileges
from autograder.manifest import ROOT, load_chapters
from autograder.platforms.gradescope import HIDDEN
from autograder.reports.gradescope import as_text, gradescope_results, ungraded_results
from autograder.reports.report import StudentReport
from autograder.submissions.find import Submission, printable


def main(folder: Path, root: Path = ROOT) -> None:
    """Grade one submission, and print the results, or why there are none, as JSON."""
    try:
        results = gradescope_results(grade_one(folder, root))
    except ValueError as error:  # its text is written for people to read
        print(error, file=sys.stderr)
        results = ungraded_results(str(error))
    except Exception as error:
        traceback.print_exc()  # Gradescope shows this output to the instructor
        results = ungraded_results(f"{type(error).__name__}: {error}")
    print(as_text(results), end="")


def grade_one(folder: Path, root: Path) -> StudentReport:
    """Grade the submission that Gradescope has put into ``folder``, as assignment.json says.

    Every run draws a new seed, even if the course file has one. Otherwise students could submit
    again with the numbers that they saw in the results of an earlier run.
    """
    settings = json.loads((root / "assignment.json").read_text(encoding="utf-8"))
    submission = folder / "submission"
    if not submission.is_dir():
        raise ValueError(f"there is no folder {submission}")
    if settings["unsafe"] and os.geteuid() == 0 and not best_level().is_sandbox:
        drop_privileges()  # without a sandbox, students' code must not run as root
    level = choose_level(submission, unsafe=settings["unsafe"])
    chapters = {chapter.number: chapter for chapter in load_chapters(root)}
    graded, given = ([chapters[n] for n in settings[key]] for key in ("chapters", "given"))
    points, extra = settings["points"], settings["extra"]
    for index, chapter in enumerate(graded):
        exercises = [e for e in chapter.exercises if e.id in points]
        exercises = [replace(e, points=points[e.id], extra=e.id in extra) for e in exercises]
        graded[index] = replace(chapter, exercises=exercises)
    hidden = root / HIDDEN if (root / HIDDEN).is_dir() else None
    seed, earlier = secrets.token_hex(4), settings["earlier"]
    assignment = Conditions(graded, seed, level, given, hidden, root, earlier=earlier)
    student = students(folder / "submission_metadata.json")
    print(f"grading {student}, seed {assignment.seed}, isolation: {level}", file=sys.stderr)
    report = grade_submission(assignment, Submission(student, submission))
    if settings["deadline"]:
        metadata = _metadata(folder / "submission_metadata.json")
        deadline = deadline_from_json(settings["deadline"])
        report = replace(report, late=late_on_gradescope(deadline, graded, metadata))
    # A zip made with this option lacks the reference for a second run.
    return replace(report, score_on_given=None) if settings["unsafe"] else report


def students(metadata: Path) -> str:
    """Return the names in Gradescope's metadata, such as "Ann Lee, Bo Chen", or "submission"."""
    try:
        users = _metadata(metadata)["users"]
        return ", ".join(printable(user["name"]) for user in users) or "submission"
    except (KeyError, TypeError, AttributeError):
        return "submission"


def _metadata(path: Path) -> dict[str, Any]:
    """Read who submitted and when, or return an empty dict if the file is unreadable."""
    try:
        metadata = json.loads(path.read_text(encoding="utf-8"))
        return metadata if isinstance(metadata, dict) else {}
    except (OSError, ValueError):
        return {}


if __name__ == "__main__":
    main(Path(sys.argv[1]))
