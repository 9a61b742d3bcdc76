"""Give students their feedback pages, through Moodle, through Canvas or by mail."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from autograder.files import replace_bytes, replace_table
from autograder.platforms.zipped import zipped
from autograder.reports.report import StudentReport
from autograder.submissions.class_list import ClassList
from autograder.submissions.csv_rows import as_cell
from autograder.submissions.exports import Exported
from autograder.submissions.find import file_name

PAGE = "feedback.html"


def give_back(out: Path, people: ClassList, reports: Sequence[StudentReport]) -> list[Path]:
    """Write the zips of feedback pages for Moodle and Canvas, and mail.csv, and return their paths.

    Students on whose work the grader failed are left out.
    """
    graded = {report.student for report in reports if report.status != "error, retry"}
    pages = {
        member: out / "feedback" / f"{file_name(member.report)}.html"
        for member in people.members
        if member.report in graded
    }
    to_moodle, to_canvas = {}, {}
    for member, page in pages.items():
        submission = member.submission
        export = submission.export if submission else None
        if export and export.platform == "moodle":
            to_moodle[f"{_in_moodle(export)}/{PAGE}"] = page.read_bytes()
        elif submission and export:
            to_canvas[_in_canvas(submission.path)] = zipped({PAGE: page.read_bytes()})
    paths = []
    for name, contents in (("moodle", to_moodle), ("canvas", to_canvas)):
        if contents:
            paths.append(out / f"feedback-{name}.zip")
            replace_bytes(paths[-1], zipped(contents))
    if people.has_roster:
        paths.append(out / "mail.csv")
        rows = [
            [as_cell(member.student.name), member.student.email, str(page.resolve())]
            for member, page in pages.items()
            if member.student
        ]
        replace_table(paths[-1], [["name", "email", "file"], *rows])
    return paths


def _in_moodle(export: Exported) -> str:
    """Name a participant's folder in a zip for Moodle.

    Moodle splits the name at underscores, takes the second part as the participant's number, and
    the next two as the part of the assignment that the files are for. Versions before 4.1 need the
    underscore at the end.
    """
    return f"{export.name.replace('_', ' ')}_{export.number}_assignfeedback_file_"


def _in_canvas(path: Path) -> str:
    """Name a student's file in a zip for Canvas, given the path of the submission.

    Canvas finds the numbers of the student and of the upload in the name that it gave the
    submission. If the last part of a name begins with "link", Canvas ignores the file, so another
    part is added. The student sees the file under the name of the upload, which was a zip, so it
    must be a zip too.
    """
    return f"{re.sub(r'(?i)[.]zip$', '', path.name)}_feedback.zip"
