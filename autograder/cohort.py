"""Grade a class: submissions side by side, each report as it is made, and a run that can go on."""

from __future__ import annotations

import fcntl
import json
import os
import secrets
import shutil
import sys
import tempfile
from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import ExitStack, closing, contextmanager
from functools import partial
from pathlib import Path
from typing import Any

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.markup import escape
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table

from autograder.arrange import Behind
from autograder.cluster import connect, grade_over
from autograder.grading import Assignment, digest_of, grade_submission
from autograder.isolation.level import choose_level
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.reports.marks import Marks, apply_marks, read_marks
from autograder.reports.results import read_result, write_class, write_student
from autograder.reports.texts import Report, replace_file
from autograder.run_key import run_key
from autograder.runner import TIME_LIMIT, GraderError, is_stopped, run_checks, stopping
from autograder.scores import shown
from autograder.submissions.find import Submission, file_name, find_submissions


def grade(
    folder: Path,
    out: Path,
    chapters: list[Chapter],
    seed: str | None = None,
    given: Sequence[Chapter] = (),
    *,
    jobs: int | None = None,
    hidden: Path | None = None,
    unsafe: bool = False,
    root: Path = ROOT,
    time_limit: float = TIME_LIMIT,
    cluster: str | None = None,
) -> int:
    """Grade every submission in the folder; write the reports into out; return 1 for errors.

    ``jobs`` submissions are graded at a time, by default one a core; or the workers of a
    ``cluster`` grade them, named by its scheduler's address. ``hidden`` is a folder of further
    checks, chNN_name/test_*.py. What is complete, of the same submission, checks, grader
    and seed, is not graded again; without a seed, a run that was stopped goes on with its own, and
    a new run draws a new one. Raises ValueError for what cannot be graded so, OSError for what
    cannot be read or written.
    """
    if jobs is not None and jobs < 1:
        raise ValueError(f"--jobs must be at least 1, got {jobs}")
    if jobs is not None and cluster:
        raise ValueError("--jobs is of this machine: --nthreads of its workers is a cluster's")
    submissions, notes = find_submissions(folder)
    if out.resolve() == folder.resolve():
        raise ValueError(f"--out must not be the folder of the class, got {str(out)!r}")
    submissions = [one for one in submissions if one.path.resolve() != out.resolve()]
    for one in submissions:
        if out.resolve().is_relative_to(one.path.resolve()):
            raise ValueError(
                f"--out must not lie in the submission {one.student!r}, got {str(out)!r}"
            )
    everyone = [submission.student for submission in submissions]
    marks = read_marks(folder / "marks.csv", load_chapters(root), everyone)
    level = choose_level(folder, unsafe=unsafe)
    with _only_run(out) as state:
        seed = _seed(state, seed)
        assignment = Assignment(
            chapters, seed, level, given, hidden and hidden.resolve(), root, time_limit
        )
        check_hidden(assignment)
        replace_file(state, json.dumps({"seed": seed, "finished": False}) + "\n")
        console = Console(highlight=False)
        for note in notes:
            console.print(note, markup=False)
        class_run = _ClassRun(assignment, out, marks, run_key(assignment), console)
        with _temporary_files_in(out), ExitStack() as stack:
            if cluster:
                client = stack.enter_context(connect(cluster, assignment, console))
                over = partial(grade_over, client, assignment)
                arriving = class_run.elsewhere(submissions, over)
            else:
                arriving = class_run.here(submissions, jobs or _cores())
            reports = class_run.collect(submissions, arriving)
        moved = put_others_aside(out, everyone)
        places = write_class(out, chapters, reports)
        finished = all(report["status"] == "graded" for report in reports)
        replace_file(state, json.dumps({"seed": seed, "finished": finished}) + "\n")
    print_class(console, reports)
    for report in reports:
        for note in report["notes"]:
            console.print(f"{report['student']}: {note}", markup=False)
    if moved:
        console.print(f"{moved} reports of other students are in {out / 'earlier'} now.")
    if class_run.reused:
        console.print(
            f"{len(class_run.reused)} of {len(reports)} were graded before, and not again."
        )
    console.print(f"Seed {seed}. Isolation: {level}.", markup=False)
    for place in places:
        console.print(str(place), markup=False, soft_wrap=True)
    return int(any(report["status"] != "graded" for report in reports))


def put_others_aside(out: Path, students: list[str]) -> int:
    """Move the reports of students who are not in this class away; return how many students.

    They are another class's, or of somebody who has withdrawn.
    """
    names = {file_name(student) for student in students}
    others = set()
    for kind in ("results", "feedback", "gradescope"):
        for path in (out / kind).glob("*"):
            name = path.name if path.is_dir() else path.stem
            if name not in names:
                others.add(name)
                target = out / "earlier" / kind / path.name
                target.parent.mkdir(parents=True, exist_ok=True)
                if target.is_dir():
                    shutil.rmtree(target)
                path.replace(target)
    return len(others)


def check_hidden(assignment: Assignment) -> None:
    """Raise ValueError where the hidden checks are none, or fail on the reference itself."""
    hidden, root = assignment.hidden, assignment.root
    if hidden is None:
        return
    graded = [chapter for chapter in assignment.chapters if (hidden / chapter.name).is_dir()]
    if not graded:
        names = ", ".join(chapter.name for chapter in assignment.chapters)
        raise ValueError(f"--checks must be a folder that has one of {names}, got {str(hidden)!r}")
    behind = Behind(vars(assignment.level), hidden=hidden, tells=True)
    engine = [root / "solutions", root / "chapters"]
    for chapter in graded:
        for probes in (root / "tests" / chapter.name).glob("*probes.py"):
            if (hidden / chapter.name / probes.name).exists():
                raise ValueError(
                    f"{hidden / chapter.name / probes.name} has the name of a public file: "
                    "call it hidden_probes.py"
                )
        try:
            verdicts = run_checks(chapter, engine, seed=assignment.seed, root=root, behind=behind)
        except GraderError as error:
            raise ValueError(
                f"the checks in {hidden / chapter.name} do not run: {error}"
            ) from error
        if not any(verdict.hidden for verdict in verdicts):
            raise ValueError(f"there is no check in {hidden / chapter.name}: test_*.py is wanted")
        for check in verdicts:
            if check.status != "passed":
                raise ValueError(f"{check.name} fails on the reference itself: {check.message}")


class _ClassRun:
    """One run over a class: what it shares, and how many were there already."""

    def __init__(
        self,
        assignment: Assignment,
        out: Path,
        marks: Marks,
        key: dict[str, Any],
        console: Console,
    ) -> None:
        self.assignment = assignment
        self.out = out
        self.marks = marks
        self.key = key
        self.console = console
        self.reused: list[str] = []

    def collect(self, submissions: list[Submission], arriving: Generator[Report]) -> list[Report]:
        """Show the reports that arrive, and return them in the order of the submissions."""
        columns = (
            TextColumn("{task.description}"),
            BarColumn(),
            MofNCompleteColumn(),
            TimeRemainingColumn(),
        )
        reports: dict[str, Report] = {}
        with (
            closing(arriving),
            Progress(*columns, console=self.console, transient=True) as progress,
        ):
            task = progress.add_task("grading", total=len(submissions))
            try:
                for report in arriving:
                    reports[report["student"]] = report
                    progress.update(task, advance=1, description=f"graded {report['student']}")
                    if not self.console.is_terminal:
                        line = f"{len(reports)}/{len(submissions)} {report['student']}"
                        self.console.print(line, markup=False)
            except BaseException:  # Ctrl-C above all: what has landed stays, the rest is dropped
                progress.stop()
                line = f"Stopping: {len(reports)} of {len(submissions)} are complete. "
                self.console.print(line + "The same command goes on from there.")
                raise
        return [reports[submission.student] for submission in submissions]

    def here(self, submissions: list[Submission], jobs: int) -> Generator[Report]:
        """Grade the submissions, so many at a time, and yield the reports that have landed."""
        with ThreadPoolExecutor(jobs) as pool:
            try:
                futures = [pool.submit(self.one, submission) for submission in submissions]
                for future in as_completed(futures):
                    yield future.result()
            except BaseException:  # that nobody wants any more is one, too
                with stopping():
                    pool.shutdown(cancel_futures=True)
                raise

    def elsewhere(
        self,
        submissions: list[Submission],
        grade_over: Callable[[list[Submission]], Iterator[Report]],
    ) -> Generator[Report]:
        """Have the submissions graded by others, and yield the reports that have landed."""
        left = []
        for submission in submissions:
            if report := self.earlier(submission):
                yield self.land(report)
            else:
                left.append(submission)
        for report in grade_over(left):
            yield self.land(report | {"run": self.key})

    def one(self, submission: Submission) -> Report:
        """Return the report of one submission, an earlier one where it still holds."""
        report = self.earlier(submission)
        if report is None:
            report = grade_submission(self.assignment, submission) | {"run": self.key}
            if is_stopped():
                raise GraderError("the run was stopped")  # in the middle of this submission
        return self.land(report)

    def land(self, report: Report) -> Report:
        """Write a report and all that is made of it, with the marks of a person; return it."""
        report = apply_marks(report, self.marks)
        write_student(self.out, report)
        return report

    def earlier(self, submission: Submission) -> Report | None:
        """Return the report of an earlier run, where it still holds."""
        path = self.out / "results" / f"{file_name(submission.student)}.json"
        report = read_result(path)
        if report is None or not self.still_holds(report, submission):
            return None
        self.reused.append(submission.student)
        return report

    def still_holds(self, report: Report, submission: Submission) -> bool:
        """Say whether grading again would give this report."""
        if report["status"] != "graded" or report.get("run") != self.key:
            return False
        return bool(report.get("submission") == digest_of(self.assignment, submission))


def _seed(state: Path, seed: str | None) -> str:
    """Return the seed that is wanted, that of a run that was stopped here, or a new one."""
    if seed:
        return seed
    try:
        last = json.loads(state.read_text(encoding="utf-8"))
        if last["finished"] is False and isinstance(last["seed"], str):
            return last["seed"]
    except (OSError, ValueError, KeyError, TypeError):
        pass  # no run was stopped here
    return secrets.token_hex(4)


@contextmanager
def _only_run(out: Path) -> Iterator[Path]:
    """Make the folder and hold it for this run; yield the file that keeps the run's state."""
    if out.exists() and not out.is_dir():
        raise ValueError(f"--out must be a folder, got {str(out)!r}")
    out.mkdir(parents=True, exist_ok=True)
    with (out / ".lock").open("w", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise ValueError(f"another run is grading into {str(out)!r}") from None
        yield out / "run.json"


@contextmanager
def _temporary_files_in(out: Path) -> Iterator[None]:
    """Have temporary files in the folder of the reports, where a later run finds and removes them.

    A run that is killed cannot remove its own.
    """
    own, before = out / ".temporary", tempfile.tempdir
    shutil.rmtree(own, ignore_errors=True)
    own.mkdir(mode=0o700, exist_ok=True)
    tempfile.tempdir = str(own.resolve())
    try:
        yield
    finally:
        tempfile.tempdir = before
        shutil.rmtree(own, ignore_errors=True)


def _cores() -> int:
    if sys.platform == "linux":
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def print_class(console: Console, reports: list[Report]) -> None:
    """Print a line for each student: points, checks, and the first problem."""
    table = Table("student", box=SIMPLE_HEAD, pad_edge=False)
    for heading in ("points", "on given", "checks"):
        table.add_column(heading, justify="right")
    table.add_column("status")
    table.add_column("first trouble")
    for report in reports:
        checks = [(e, check) for e in report["exercises"] for check in e["checks"]]
        passed = sum(check["status"] == "passed" for _, check in checks)
        order = ("error", "failed", "inherited", "blocked")
        lost = [pair for pair in checks if pair[1]["status"] in order]
        lost.sort(key=lambda pair: (order.index(pair[1]["status"]), pair[1]["robust"]))
        table.add_row(
            escape(report["student"]),
            f"{shown(report['score'])}/{report['points']}",
            shown(report["score_on_given"]),
            f"{passed}/{len(checks)}",
            report["status"],
            escape(f"{lost[0][0]['id']}: {_in_short(lost[0][1]['message'])}") if lost else "",
        )
    console.print(table)


def _in_short(message: str) -> str:
    """Return the line of a message that says most on its own: the cause, or the exception."""
    lines = message.splitlines() or [""]
    labelled = dict(line.split(maxsplit=1) for line in reversed(lines) if " " in line.strip())
    return labelled.get("likely" if "wanted" in labelled else "got", lines[0])[:200]
