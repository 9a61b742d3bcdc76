"""Grade submissions at the same time, and write the report on each student once it is ready."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Generator, Mapping
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import closing
from dataclasses import dataclass, field, replace
from pathlib import Path

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table

from autograder.checks.check_process import is_stopped, stopping
from autograder.checks.runner import GraderError
from autograder.grader.conditions import Conditions
from autograder.grader.grading import grade_submission, report_of_failure, still_valid
from autograder.grader.regrade import Regrade
from autograder.manifest import load_chapters
from autograder.marking.answers import answer_hashes
from autograder.marking.marked_answers import MarkedAnswers
from autograder.reports.marks import Mark, Marks, apply_marks
from autograder.reports.report import Late, RunKey, StudentReport
from autograder.reports.results import read_result, write_student
from autograder.scores import shown
from autograder.submissions.find import Submission, file_name

PROBLEM = "first problem"  # the heading of a column
LONGEST_NAME = 20  # characters of a student's name in one line
LONGEST_STATE = 8

GradeAll = Callable[[list[Submission]], Generator[StudentReport]]


@dataclass
class ClassRun:
    """A run over a class. Valid reports of an earlier run are kept, unless it is a regrade."""

    conditions: Conditions
    key: RunKey
    out: Path
    console: Console
    marks: Marks
    marked: MarkedAnswers  # the record of the answers for which marks were given
    late: Mapping[str, Late]
    regrade: Regrade | None = None
    reused: list[str] = field(default_factory=list)  # the students whose reports were kept

    def collect(self, submissions: list[Submission], grade_all: GradeAll) -> list[StudentReport]:
        """Grade the submissions, show a progress bar, and return the reports in the same order."""
        columns = (
            TextColumn("{task.description}", markup=False),
            BarColumn(),
            MofNCompleteColumn(),
            TimeRemainingColumn(),
        )
        reports: dict[str, StudentReport] = {}
        number = len(submissions)
        self.console.print(f"Grading {number} {'student' if number == 1 else 'students'} ...")
        with (
            closing(self._reports(submissions, grade_all)) as arriving,
            Progress(*columns, console=self.console, transient=True) as progress,
        ):
            task = progress.add_task("grading", total=number)
            try:
                for report in arriving:
                    reports[report.student] = report
                    progress.update(task, advance=1, description=f"graded {report.student}")
                    if not self.console.is_terminal:
                        line = f"{len(reports)}/{number} {report.student}"
                        self.console.print(line, markup=False)
            except BaseException:  # most often Ctrl-C; reports that are already written stay
                progress.stop()
                line = f"Stopping: {len(reports)} of {number} reports are complete. "
                self.console.print(line + "Run the same command again to resume.")
                raise
        return [reports[submission.student] for submission in submissions]

    def _reports(
        self, submissions: list[Submission], grade_all: GradeAll
    ) -> Generator[StudentReport]:
        left = {}
        for submission in submissions:
            if report := None if self.regrade else self._kept(submission):
                self.reused.append(submission.student)
                yield self._save(report, submission)
            else:
                left[submission.student] = submission
        with closing(grade_all([*left.values()])) as arriving:
            for report in arriving:
                yield self._save(replace(report, run=self.key), left[report.student])

    def _kept(self, submission: Submission) -> StudentReport | None:
        """Return the report of an earlier run if the files and the conditions have not changed."""
        report = read_result(self.out / "results" / f"{file_name(submission.student)}.json")
        if report is None or report.run != self.key or report.status == "error, retry":
            return None
        return still_valid(self.conditions, submission, report)

    def _save(self, report: StudentReport, submission: Submission) -> StudentReport:
        """Add marks and lateness to a report, and write it, or return a report of the failure."""
        answers: dict[str, str] = {}
        if any(student == report.student for student, _ in self.marks):
            root = self.conditions.root
            answers = answer_hashes(submission, load_chapters(root), root)

        def is_changed(exercise: str, mark: Mark) -> bool:
            return self.marked.is_changed(submission.owner, exercise, mark, answers[exercise])

        report = apply_marks(report, self.marks, is_changed)
        report = replace(report, late=self.late.get(report.student))
        try:
            logged = self.regrade.log(report) if self.regrade else ""
            write_student(self.out, report)
        except Exception as error:  # whatever it is, it must not stop the rest of the class
            reason = f"its report could not be written: {error!r}"
            self.console.print(f"{report.student}: {reason}", markup=False)
            return report_of_failure(self.conditions, report.student, reason)
        if logged:
            self.console.print(logged, markup=False)
        return report


def grade_here(
    conditions: Conditions, jobs: int, submissions: list[Submission]
) -> Generator[StudentReport]:
    """Grade submissions on this machine, up to ``jobs`` at a time, and yield each report."""

    def grade(submission: Submission) -> StudentReport:
        report = grade_submission(conditions, submission)
        if is_stopped():
            raise GraderError("the run was stopped")  # while this submission was being graded
        return report

    with ThreadPoolExecutor(jobs) as pool:
        try:
            futures = [pool.submit(grade, submission) for submission in submissions]
            for future in as_completed(futures):
                yield future.result()
        except BaseException:  # GeneratorExit too, if nobody needs more reports
            with stopping():
                pool.shutdown(cancel_futures=True)
            raise


def print_class(console: Console, reports: list[StudentReport]) -> None:
    """Print the points of each student and the first problem, with at most two lines a row."""
    problems = [_first_problem(report) for report in reports]
    taken = console.measure(_class_table(reports, [""] * len(reports))).maximum
    room = max(console.width - taken, len(PROBLEM))
    console.print(_class_table(reports, [_two_lines(words, room) for words in problems]))


def _class_table(reports: list[StudentReport], problems: list[str]) -> Table:
    table = Table(box=SIMPLE_HEAD, pad_edge=False, collapse_padding=True)
    table.add_column("student", no_wrap=True)
    for heading in ("score", "on given", "checks"):
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column("status", no_wrap=True)
    table.add_column(PROBLEM if any(problems) else "", no_wrap=True)
    for report, problem in zip(reports, problems, strict=True):
        checks = [check for result in report.results for check in result.checks]
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
    """Return the message of the most important check that did not pass, hidden or not."""
    order = ("error", "failed", "inherited", "blocked")
    cause = report.first_cause
    checks = [(cause.name, check) for check in cause.result.checks] if cause else []
    checks += [(result.exercise.id, check) for result in report.results for check in result.checks]
    lost = [pair for pair in checks if pair[1].status in order]
    if not lost:
        return ""
    name, check = min(lost, key=lambda pair: (order.index(pair[1].status), pair[1].robust))
    return f"{name}: {(check.secret or check).message.in_short[:200]}"
