"""Grade the submissions of a class in parallel, and write each report as soon as it is ready.

If the run is interrupted, the reports written so far are kept.
"""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Generator, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import closing
from dataclasses import replace
from pathlib import Path

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table

from autograder.checks.check_process import is_stopped, stopping
from autograder.checks.runner import GraderError
from autograder.grader.assignment import Assignment, OnceForAll
from autograder.grader.grading import grade_submission, report_of_failure, still_valid
from autograder.grader.run_key import run_key
from autograder.manifest import load_chapters
from autograder.marking.answers import answer_hashes
from autograder.marking.marked_answers import MarkedAnswers
from autograder.reports.marks import Mark, Marks, apply_marks
from autograder.reports.report import Late, StudentReport
from autograder.reports.results import read_result, write_student
from autograder.scores import shown
from autograder.submissions.codes import without_names
from autograder.submissions.find import Submission, file_name

PROBLEM = "first problem"  # the heading of a column
LONGEST_NAME = 20  # characters of a student's name in one line
LONGEST_STATE = 8


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
        marked: MarkedAnswers | None = None,
        anonymous: bool = False,
    ) -> None:
        self.assignment = assignment
        self.out = out
        self.marks = marks
        self.late = late or {}
        self.marked = marked
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
                yield self.save(report, submission)
            else:
                left.append(submission)
        by_student = {submission.student: submission for submission in left}
        for report in grade_over(left):
            yield self.save(replace(report, run=self.key), by_student[report.student])

    def one(self, submission: Submission) -> StudentReport:
        """Grade one student's submission, or reuse an earlier report on it that is still valid."""
        report = self.earlier(submission)
        if report is None:
            report = replace(grade_submission(self.assignment, submission, self.once), run=self.key)
            if is_stopped():
                raise GraderError("the run was stopped")  # while this submission was being graded
        return self.save(report, submission)

    def save(self, report: StudentReport, submission: Submission) -> StudentReport:
        """Add marks and lateness to a student's report, and write the report to disk.

        The marks are those that people gave for written answers. In an anonymous class, names are
        also removed from the report's texts about files. If the report cannot be written, the
        other students are still graded, and this one counts as not graded.
        """

        answers: dict[str, str] = {}
        if self.marked and any(student == report.student for student, _ in self.marks):
            root = self.assignment.root
            answers = answer_hashes(submission, load_chapters(root), root)

        def is_changed(exercise: str, mark: Mark) -> bool:
            marked, owner = self.marked, submission.owner
            return bool(marked and marked.is_changed(owner, exercise, mark, answers[exercise]))

        report = apply_marks(report, self.marks, is_changed)
        report = replace(report, late=self.late.get(report.student))
        if self.anonymous:
            notes = [without_names(note) for note in report.notes]
            report = replace(report, notes=notes, nothing=without_names(report.nothing))
        try:
            write_student(self.out, report)
        except Exception as error:  # whatever it is, it must not stop the rest of the class
            reason = f"its report could not be written: {error!r}"
            self.console.print(f"{report.student}: {reason}", markup=False)
            return report_of_failure(self.assignment, report.student, reason)
        return report

    def earlier(self, submission: Submission) -> StudentReport | None:
        """Return the report of an earlier run on this submission, or None if it cannot be reused.

        A report cannot be reused if the submitted files or the conditions of grading, such as the
        checks and the seed, have changed. A report that says that the grader itself failed is never
        reused.
        """
        report = read_result(self.out / "results" / f"{file_name(submission.student)}.json")
        if not self.keeps_reports or report is None or report.run != self.key:
            return None
        if report.status == "error, retry":
            return None
        if report := still_valid(self.assignment, submission, report):
            self.reused.append(submission.student)
        return report


def print_class(console: Console, reports: list[StudentReport]) -> None:
    """Print a table of the class's results, with one row for each student.

    Each row shows the points, the number of passed checks, and the message of the most important
    check that did not pass. That may be a check of an earlier assignment that blocks this one. Each
    row has at most two lines, so a long message is cut on a narrow screen.
    """
    problems = [_first_problem(report) for report in reports]
    taken = console.measure(_class_table(reports, [""] * len(reports))).maximum
    room = max(console.width - taken, len(PROBLEM))
    console.print(_class_table(reports, [_two_lines(words, room) for words in problems]))


def _class_table(reports: list[StudentReport], problems: list[str]) -> Table:
    table = Table(box=SIMPLE_HEAD, pad_edge=False, collapse_padding=True)
    table.add_column("student", no_wrap=True)
    for heading in ("points", "on given", "checks"):
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column("status", no_wrap=True)
    table.add_column(PROBLEM if any(problems) else "", no_wrap=True)
    for report, problem in zip(reports, problems, strict=True):
        checks = [check for exercise in report.exercises for check in exercise.checks]
        extra = " extra" if report.extra and not report.points else ""
        table.add_row(
            _two_lines(report.student, LONGEST_NAME),
            f"{shown(report.score)}/{shown(report.points or report.extra)}{extra}",
            shown(report.score_on_given),
            f"{sum(check.status == 'passed' for check in checks)}/{len(checks)}",
            _two_lines(report.status, LONGEST_STATE),
            problem,
        )
    return table


def _two_lines(words: str, width: int) -> str:
    first, *others = textwrap.wrap(words, width) or [""]
    rest = " ".join(others)
    return f"{first}\n{rest if len(rest) <= width else f'{rest[: width - 3]}...'}".rstrip()


def _first_problem(report: StudentReport) -> str:
    """Return the message of the most important check that did not pass, with its exercise.

    The instructor may read the messages of hidden checks too.
    """
    order = ("error", "failed", "inherited", "blocked")
    cause = report.first_cause
    checks = [(cause.name, check) for check in cause.checks] if cause else []
    checks += [(exercise.id, check) for exercise in report.exercises for check in exercise.checks]
    lost = [pair for pair in checks if pair[1].status in order]
    if not lost:
        return ""
    name, check = min(lost, key=lambda pair: (order.index(pair[1].status), pair[1].robust))
    return f"{name}: {(check.secret or check).message.in_short[:200]}"
