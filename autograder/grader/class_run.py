"""Grade the submissions of a class in parallel, and write each report as soon as it is ready.

If the run is interrupted, the reports written so far are kept.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import closing
from dataclasses import replace
from pathlib import Path

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table

from autograder.checks.judge import is_stopped, stopping
from autograder.checks.runner import GraderError
from autograder.grader.assignment import Assignment, OnceForAll
from autograder.grader.grading import digest_of, grade_submission
from autograder.grader.run_key import run_key
from autograder.reports.marks import Marks, apply_marks
from autograder.reports.report import CheckReport, Late, StudentReport
from autograder.reports.results import read_result, write_student
from autograder.scores import shown
from autograder.submissions.codes import without_names
from autograder.submissions.find import Submission, file_name


class ClassRun:
    """Grades the submissions of a class, or reuses the reports of an earlier run.

    The object stores everything that applies to the whole class, such as the assignment and the
    folder for the reports. It also stores the marks for written answers and how late each student
    was.
    """

    def __init__(
        self,
        assignment: Assignment,
        out: Path,
        marks: Marks,
        console: Console,
        late: Mapping[str, Late] | None = None,
        *,
        anonymous: bool = False,
    ) -> None:
        self.assignment = assignment
        self.out = out
        self.marks = marks
        self.late = late or {}
        self.key = run_key(assignment)
        self.once = OnceForAll()
        self.console = console
        self.anonymous = anonymous
        self.reused: list[str] = []
        self.keeps_reports = True  # whether a valid report of an earlier run is kept

    def collect(
        self, submissions: list[Submission], arriving: Generator[StudentReport]
    ) -> list[StudentReport]:
        """Collect the students' reports as they arrive, and show a progress bar in the meantime.

        The reports are returned in the order of ``submissions``, whatever order they arrive in.
        """
        columns = (
            TextColumn("{task.description}", markup=False),
            BarColumn(),
            MofNCompleteColumn(),
            TimeRemainingColumn(),
        )
        reports: dict[str, StudentReport] = {}
        with (
            closing(arriving),
            Progress(*columns, console=self.console, transient=True) as progress,
        ):
            task = progress.add_task("grading", total=len(submissions))
            try:
                for report in arriving:
                    reports[report.student] = report
                    progress.update(task, advance=1, description=f"graded {report.student}")
                    if not self.console.is_terminal:
                        line = f"{len(reports)}/{len(submissions)} {report.student}"
                        self.console.print(line, markup=False)
            except BaseException:  # most often Ctrl-C; reports that are already written stay
                progress.stop()
                line = f"Stopping: {len(reports)} of {len(submissions)} reports are complete. "
                self.console.print(line + "Run the same command again to resume.")
                raise
        return [reports[submission.student] for submission in submissions]

    def here(self, submissions: list[Submission], jobs: int) -> Generator[StudentReport]:
        """Grade the submissions on this machine, up to ``jobs`` at a time, and yield the reports.

        Each report is yielded as soon as it is ready, so they may not be in the order of
        ``submissions``.
        """
        with ThreadPoolExecutor(jobs) as pool:
            try:
                futures = [pool.submit(self.one, submission) for submission in submissions]
                for future in as_completed(futures):
                    yield future.result()
            except BaseException:  # GeneratorExit too, if nobody needs more reports
                with stopping():
                    pool.shutdown(cancel_futures=True)
                raise

    def elsewhere(
        self,
        submissions: list[Submission],
        grade_over: Callable[[list[Submission]], Iterator[StudentReport]],
    ) -> Generator[StudentReport]:
        """Grade the submissions on a cluster, and yield each report when it arrives.

        Submissions that have a valid report from an earlier run are not graded again. The function
        ``grade_over`` sends all others to the cluster and yields the reports on them.
        """
        left = []
        for submission in submissions:
            if report := self.earlier(submission):
                yield self.save(report)
            else:
                left.append(submission)
        for report in grade_over(left):
            yield self.save(replace(report, run=self.key))

    def one(self, submission: Submission) -> StudentReport:
        """Grade one student's submission, or reuse an earlier report on it that is still valid."""
        report = self.earlier(submission)
        if report is None:
            report = replace(grade_submission(self.assignment, submission, self.once), run=self.key)
            if is_stopped():
                raise GraderError("the run was stopped")  # while this submission was being graded
        return self.save(report)

    def save(self, report: StudentReport) -> StudentReport:
        """Add marks and lateness to a student's report, and write the report to disk.

        The marks are those that people gave for written answers. In an anonymous class, names are
        also removed from the notes in the report.
        """
        report = replace(apply_marks(report, self.marks), late=self.late.get(report.student))
        if self.anonymous:
            report = replace(report, notes=[without_names(note) for note in report.notes])
        write_student(self.out, report)
        return report

    def earlier(self, submission: Submission) -> StudentReport | None:
        """Return the report of an earlier run on this submission, or None if it cannot be reused.

        A report cannot be reused if the submission or the conditions of grading have changed.
        """
        path = self.out / "results" / f"{file_name(submission.student)}.json"
        report = read_result(path)
        if not self.keeps_reports or report is None or not self.is_valid(report, submission):
            return None
        self.reused.append(submission.student)
        return report

    def is_valid(self, report: StudentReport, submission: Submission) -> bool:
        """Return True if grading the submission again would produce the same report.

        This is the case if the submitted files and the conditions of grading, such as the checks
        and the seed, have not changed. A report that says that the grader itself failed is never
        valid.
        """
        if report.status != "graded" or report.run != self.key:
            return False
        return report.submission == digest_of(self.assignment, submission)


def print_class(console: Console, reports: list[StudentReport]) -> None:
    """Print a table of the class's results, with one row for each student.

    Each row shows the points, the number of passed checks, and the message of the most important
    check that did not pass. That may be a check of an earlier assignment that blocks this one.
    """
    table = Table("student", box=SIMPLE_HEAD, pad_edge=False)
    for heading in ("points", "on given", "checks"):
        table.add_column(heading, justify="right")
    table.add_column("status")
    table.add_column("first problem")
    for report in reports:
        checks = [(e.id, check) for e in report.exercises for check in e.checks]
        passed = sum(check.status == "passed" for _, check in checks)
        order = ("error", "failed", "inherited", "blocked")
        cause = report.first_cause
        causes = [(cause.name, check) for check in cause.checks] if cause else []
        lost = [pair for pair in [*causes, *checks] if pair[1].status in order]
        lost.sort(key=lambda pair: (order.index(pair[1].status), pair[1].robust))
        table.add_row(
            report.student,
            f"{shown(report.score)}/{shown(report.points)}",
            shown(report.score_on_given),
            f"{passed}/{len(checks)}",
            report.status,
            _problem(*lost[0]) if lost else "",
        )
    console.print(table)


def _problem(exercise: str, check: CheckReport) -> str:
    """Describe a failed check to the instructor, who may read the messages of hidden checks too."""
    return f"{exercise}: {(check.secret or check).message.in_short[:200]}"
