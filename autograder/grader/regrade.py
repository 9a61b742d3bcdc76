"""Regrade one student under the same conditions as the class, and log which scores have changed."""

from __future__ import annotations

import csv
from datetime import datetime
from pathlib import Path

from autograder.reports.report import RunKey, StudentReport
from autograder.reports.results import read_results
from autograder.reports.texts import number
from autograder.scores import Result
from autograder.submissions.class_list import ClassList
from autograder.submissions.csv_rows import as_cell

LOG = "regrades.csv"
COLUMNS = ["time", "student", "points before", "points after", "changed exercises", "why"]


class Regrade:
    """A regrade of one student, whose class, seed and points must be those of the class's run."""

    def __init__(self, out: Path, student: str, people: ClassList, why: str, key: RunKey) -> None:
        self.out = out
        self.student = people.report_of(student)
        if not self.student:
            raise ValueError(f"there is no submission of {student!r}")
        reports = read_results(out)
        self.others = [report for report in reports if report.student != self.student]
        self.before = next((one for one in reports if one.student == self.student), None)
        runs = [report.run for report in self.others or reports if report.run]
        seeds = sorted({run.seed for run in runs})
        if seeds and seeds != [key.seed]:
            wanted = " and ".join(seeds)
            raise ValueError(f"--seed must be that of the class, {wanted!r}, got {key.seed!r}")
        if any((run.points, run.extra) != (key.points, key.extra) for run in runs):
            raise ValueError(
                "the exercises and points must be the same as for the class. Use the same "
                "--assignment and --course (make: ASSIGNMENT=, COURSE=) as for the class"
            )
        # Otherwise, some of the others would be in none of the new lists, or in two of them.
        now = {one.student for one in people.submissions} - {self.student}
        if changed := now ^ {report.student for report in self.others}:
            raise ValueError(
                f"the class is not the one that was graded (new or gone: "
                f"{'; '.join(sorted(changed))}). Grade all of it again with --seed {key.seed} "
                f"(make: SEED={key.seed}, without STUDENT=), which keeps what has not changed"
            )
        changed_since = "The checks, the grader or the machine have changed since then."
        self.note = changed_since if any(run != key for run in runs) else ""
        self.why = " ".join(filter(None, (why, self.note)))

    def log(self, report: StudentReport) -> str:
        """Add a row to regrades.csv, and describe in a sentence how the points have changed.

        This happens before the new report replaces the old one. If the run is killed in between,
        the next one adds the row again, and no change is missing.
        """
        before = number(self.before.total) if self.before else ""
        after = number(report.total)
        earlier = {r.exercise.id: r for r in self.before.results} if self.before else {}
        changes = "; ".join(
            f"{new.exercise.id}: {_outcome(old)} to {_outcome(new)}"
            for new in report.results
            if (old := earlier.get(new.exercise.id)) is None
            or (old.score, old.status) != (new.score, new.status)
        )
        path = self.out / LOG
        is_new = not path.exists()
        with path.open("a", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            if is_new:
                writer.writerow(COLUMNS)
            time = datetime.now().astimezone().isoformat(timespec="seconds")
            cells = (self.student, before, after, changes, self.why)
            writer.writerow([time, *map(as_cell, cells)])
        points = f"{before or 'none'} points before, {after or 'none'} now"
        return f"{self.student}: {points}. Changed: {changes or 'no exercise'}. Logged in {path}"


def _outcome(result: Result | None) -> str:
    if result is None:
        return "nothing"
    return result.status if result.score is None else number(result.score)
