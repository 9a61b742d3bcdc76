"""Regrade one student under the same conditions as the class, and log which scores have changed."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import fields
from datetime import datetime
from pathlib import Path

from rich.console import Console

from autograder.grader.class_run import ClassRun
from autograder.reports.report import RunKey, StudentReport
from autograder.reports.results import keep_report, read_result, read_results
from autograder.reports.texts import number
from autograder.scores import Result
from autograder.submissions.class_list import ClassList
from autograder.submissions.csv_rows import as_cell
from autograder.submissions.find import Submission, file_name

LOG = "regrades.csv"
COLUMNS = ["time", "student", "points before", "points after", "changed exercises", "why"]
# These may have changed since the class was graded, for example because a check was wrong. If so,
# the log contains a note.
MAY_DIFFER = {
    "earlier": "the names of earlier assignments",
    "checks": "the checks or the reference",
    "grader": "the grader",
    "python": "Python",
    "level": "the sandbox",
    "time_limit": "the time limit of a check",
}


class Regrade:
    """Regrades one student after an earlier run has graded the class.

    The seed, the exercises and their points must be the same as when the class was graded, so that
    the grades remain comparable.

    Raises:
        ValueError: The folder has no earlier run, the name does not mean one student, or the
            student did not hand anything in.
    """

    def __init__(self, out: Path, student: str, people: ClassList) -> None:
        self.out = out
        self.reports = read_results(out)
        self.changed = ""
        self.student = people.report_of(student)
        if not self.student:
            raise ValueError(f"there is no submission of {student!r}")
        self._refuse_changed(people)
        self.submissions = [one for one in people.submissions if one.student == self.student]
        self.kept = out / f".before-{file_name(self.student)}.json"

    def _refuse_changed(self, people: ClassList) -> None:
        """Raise ValueError if the others who have handed in are not those who have a report.

        Otherwise, they would be in none of the new lists, or in two of them.
        """
        now = {one.student for one in people.submissions} - {self.student}
        graded = {report.student for report in self.reports} - {self.student}
        parts = [
            f"{what}: {'; '.join(sorted(names))}"
            for what, names in (("not graded yet", now - graded), ("not there", graded - now))
            if names
        ]
        if parts:
            seed = self.reports[0].seed
            raise ValueError(
                f"the class is not the one that was graded ({', and '.join(parts)}). Grade all of "
                f"it again with --seed {seed} (make: SEED={seed}, without STUDENT=). Whatever has "
                "not changed keeps its result"
            )

    @property
    def before(self) -> StudentReport | None:
        """The student's report before this regrade, or None if there is none.

        An earlier regrade may have been killed before it could write the log. In that case, this is
        the report from before both regrades, so that the log covers all changes.
        """
        kept = read_result(self.kept)
        if kept and any(report.seed == kept.seed for report in self.reports):
            return kept
        return next((one for one in self.reports if one.student == self.student), None)

    def seed(self, seed: str | None) -> str:
        """Return the random seed with which the class was graded, for use in the regrade.

        ``seed`` is the seed that the instructor has requested, or None.

        Raises:
            ValueError: A different seed was requested, or the class was graded with several.
        """
        seeds = sorted({report.seed for report in self.reports if report.student != self.student})
        seeds = seeds or [report.seed for report in self.reports]
        if len(seeds) > 1:
            names = ", ".join(seeds)
            raise ValueError(f"the class was graded with several seeds ({names}). Grade it again")
        if seed and seed != seeds[0]:
            raise ValueError(f"--seed must be that of the class, {seeds[0]!r}, got {seed!r}")
        return seeds[0]

    def prepare(self, run: ClassRun) -> list[Submission]:
        """Check that the regrade uses the same conditions as the grading of the class.

        Some differences, such as a new version of the grader, are allowed. They are printed and
        noted in the log.

        Returns:
            The student's submission, as a list with one item.

        Raises:
            ValueError: The exercises, their points or the hidden checks differ from those of the
                class.
        """
        run.keeps_reports = False
        differing = self._differing(run.key)
        checks = [check for one in self.reports for r in one.results for check in r.checks]
        were_hidden = any(check.hidden for check in checks)
        if were_hidden != (run.assignment.hidden is not None):
            how = "with hidden checks: add" if were_hidden else "without hidden checks: leave out"
            raise ValueError(f"the class was graded {how} --checks (make: CHECKS=)")
        for name in differing:
            if name not in MAY_DIFFER:
                earlier = next(getattr(one.run, name) for one in self.reports if one.run)
                new = getattr(run.key, name)
                if name in ("points", "extra"):
                    raise ValueError(
                        "the exercises and points must be the same as for the class. Use the same "
                        "--assignment and --course (make: ASSIGNMENT=, COURSE=) as for the class"
                    )
                raise ValueError(f"{name} must be the same as for the class, {earlier}, got {new}")
        if differing:
            changed = ", ".join(MAY_DIFFER[name] for name in differing)
            self.changed = f"Changed since the class was graded: {changed}."
            run.console.print(self.changed, markup=False)
        if before := self.before:
            keep_report(self.kept, before)
        return self.submissions

    def finish(
        self, graded: Sequence[StudentReport], why: str, console: Console
    ) -> list[StudentReport]:
        """Log how the student's scores have changed, and return the reports of the whole class.

        The student's old report is replaced by the new one.
        """
        (report,) = graded
        console.print(self._log(report, why), markup=False)
        self.kept.unlink(missing_ok=True)
        others = [one for one in self.reports if one.student != self.student]
        return sorted([*others, report], key=lambda one: one.student)

    def _differing(self, key: RunKey) -> list[str]:
        """List the conditions of grading that have changed since the class was graded.

        For example, the list contains "checks" if somebody has corrected a check.
        """
        others = [report.run for report in self.reports if report.run]
        names = [field.name for field in fields(RunKey) if field.name != "seed"]
        return [n for n in names if any(getattr(one, n) != getattr(key, n) for one in others)]

    def _log(self, report: StudentReport, why: str) -> str:
        """Add a row to regrades.csv, and describe in a sentence how the points have changed."""
        before, after = _points(self.before), _points(report)
        changes = "; ".join(_changes(self.before, report))
        path = self.out / LOG
        is_new = not path.exists()
        with path.open("a", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            if is_new:
                writer.writerow(COLUMNS)
            time = datetime.now().astimezone().isoformat(timespec="seconds")
            reason = " ".join(filter(None, (why, self.changed)))
            writer.writerow([time, *map(as_cell, (self.student, before, after, changes, reason))])
        points = f"{before or 'none'} points before, {after or 'none'} now"
        return f"{self.student}: {points}. Changed: {changes or 'no exercise'}. Logged in {path}"


def earlier_choice(out: Path) -> tuple[str, str]:
    """Find out which chapters an earlier run graded, so that the same ones can be graded again.

    Returns:
        Two strings for the command line, such as "4,5" and "2,3". The first lists the graded
        chapters, and the second lists those taken from the reference solution.

    Raises:
        ValueError: There is no earlier run, or it did not record its chapters.
    """
    run = next((report.run for report in read_results(out) if report.run), None)
    if run is None:
        raise ValueError(f"the run in {str(out)!r} did not record its chapters: name them")
    return ",".join(map(str, run.chapters)), ",".join(map(str, run.given))


def _points(report: StudentReport | None) -> str:
    return number(report.total) if report else ""


def _changes(before: StudentReport | None, after: StudentReport) -> list[str]:
    """List the exercises whose score or status has changed, with the old and new values.

    If the score of exercise 2.5 has changed from 1 to 3, for example, its entry is "2.5: 1 to 3".
    """
    earlier = {result.exercise.id: result for result in before.results} if before else {}
    return [
        f"{new.exercise.id}: {_outcome(old)} to {_outcome(new)}"
        for new in after.results
        if (old := earlier.get(new.exercise.id)) is None
        or (old.score, old.status) != (new.score, new.status)
    ]


def _outcome(result: Result | None) -> str:
    if result is None:
        return "nothing"
    return result.status if result.score is None else number(result.score)
