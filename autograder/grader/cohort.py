"""Grade a class: choose the conditions, run a ``ClassRun``, and write what is about everybody."""

from __future__ import annotations

import json
import os
import secrets
import sys
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

from autograder.analysis.class_page import write_class_page
from autograder.checks.runner import Limits
from autograder.course.lateness import lateness
from autograder.course.model import Work
from autograder.course.points import scaled_marks
from autograder.grader.class_run import ClassRun, grade_here, print_class
from autograder.grader.cluster import connect, grade_over
from autograder.grader.conditions import Conditions, check_hidden, run_key
from autograder.grader.people import differences, people_of
from autograder.grader.regrade import Regrade
from autograder.grader.reports_folder import (
    SAMPLE,
    only_run,
    put_others_aside,
    recorded,
    refuse_dropped,
    refuse_other_grades,
    refuse_place,
    temporary_files_in,
)
from autograder.isolation.probe import choose_level
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.marking.marked_answers import MarkedAnswers
from autograder.platforms.give_back import give_back
from autograder.platforms.uploads import Column, write_uploads
from autograder.reports.marks import Marks, read_marks
from autograder.reports.report import Late, StudentReport
from autograder.reports.results import write_class
from autograder.reports.texts import replace_file
from autograder.submissions.class_list import ClassList
from autograder.submissions.find import RECORD
from autograder.submissions.moodle_worksheet import worksheet_in
from autograder.text.wrapping import plain_console


@dataclass(frozen=True)
class ClassOptions:
    """How an instructor grades a class, apart from the work that is graded."""

    unsafe: bool = False  # whether to grade without a sandbox on a machine that has none
    root: Path = ROOT
    time_limit: float = Limits.check
    jobs: int | None = None  # submissions at a time, by default one per core
    cluster: str | None = None  # the address of a Dask scheduler, whose workers then grade
    column: Column = field(default_factory=Column)
    student: str | None = None  # the only one to regrade, if the class has been graded before
    why: str = ""  # the reason for the regrade, for the log

    def __post_init__(self) -> None:
        if self.jobs is not None and self.jobs < 1:
            raise ValueError(f"--jobs must be at least 1, got {self.jobs}")
        if self.jobs is not None and self.cluster:
            raise ValueError("--jobs is for this machine; on a cluster, set --nthreads of workers")
        if self.why and not self.student:
            raise ValueError("--note is for the log of regrades: add --student")


def grade(folder: Path, out: Path, work: Work, options: ClassOptions) -> int:
    """Grade every submission in ``folder``, and write the reports to the folder ``out``.

    A report from an earlier run is kept if the submission, the checks, the grader and the seed have
    not changed. Without a seed, a run draws one, but resumes an unfinished one with its seed.

    Returns:
        The exit code, which is 1 if the grader failed on a submission.

    Raises:
        ValueError: The class cannot be graded with these options.
        OSError: A file cannot be read or written.
    """
    people = people_of(folder, out, work.roster)
    refuse_place(out, folder, people.submissions)
    worksheet = worksheet_in(folder)
    marks, notes = _marks(folder, work.chapters, people, options.root)
    late: dict[str, Late] = {}
    if work.deadline:
        late, more_notes = lateness(work.deadline, work.chapters, folder, people)
        notes += more_notes
    console = plain_console()
    with only_run(out):
        conditions, regrade, record = _begin(folder, out, work, options, people)
        for note in [*([regrade.note] if regrade and regrade.note else []), *notes]:
            console.print(note, markup=False)
        key, marked = run_key(conditions), MarkedAnswers(folder)
        run = ClassRun(conditions, key, out, console, marks, marked, late, regrade)
        graded = _graded(run, people, options)
        reports = [*graded, *(run.regrade.others if run.regrade else ())]
        reports.sort(key=lambda report: report.student)
        moved = put_others_aside(out, [report.student for report in reports])
        places = write_class(out, work.chapters, reports, people)
        places.append(write_class_page(out, work.chapters, reports))
        column = options.column
        uploads, lines = write_uploads(out, work.chapters, people, reports, column, worksheet)
        places += [*uploads, *give_back(out, people, reports)]
        record["finished"] = all(report.status != "error, retry" for report in reports)
        replace_file(out / RECORD, json.dumps(record) + "\n")
    print_class(console, graded)
    for line in [*_about(run, graded, moved), *differences(people, reports), *lines]:
        console.print(line, markup=False)
    console.print(f"Seed {key.seed}. Isolation: {conditions.level}.", markup=False)
    for place in places:
        console.print(str(place), markup=False, soft_wrap=True)
    return int(any(report.status == "error, retry" for report in graded))


def _begin(
    folder: Path, out: Path, work: Work, options: ClassOptions, people: ClassList
) -> tuple[Conditions, Regrade | None, dict[str, Any]]:
    """Choose the conditions of a run, unless it would mix up grades, and record the run."""
    before = recorded(out)
    if before.get("folder") == str(SAMPLE) != str(folder.resolve()):
        before = {}  # another class takes the place of the sample class
    keeps_seed = options.student or not before.get("finished", True)
    record: dict[str, Any] = {
        "seed": work.seed or (keeps_seed and before.get("seed")) or secrets.token_hex(4),
        "finished": False,
        "roster": work.roster is not None,
        "checks": work.hidden is not None,
        "folder": str(folder.resolve()),
        "assignment": work.name,
        "chapters": [chapter.number for chapter in work.chapters],
        "given": [chapter.number for chapter in work.given],
    }
    refuse_other_grades(out, before, record)
    refuse_dropped(before, record, is_regrade=options.student is not None)
    conditions = Conditions(
        work.chapters,
        record["seed"],
        choose_level(folder, unsafe=options.unsafe),
        work.given,
        work.hidden and work.hidden.resolve(),
        options.root,
        options.time_limit,
        work.earlier,
    )
    regrade = None
    if options.student:
        regrade = Regrade(out, options.student, people, options.why, run_key(conditions))
    check_hidden(conditions)
    replace_file(out / RECORD, json.dumps(record) + "\n")
    return conditions, regrade, record


def _graded(run: ClassRun, people: ClassList, options: ClassOptions) -> list[StudentReport]:
    """Grade the submissions on this machine or on a cluster."""
    wanted = run.regrade.student if run.regrade else None
    submissions = [one for one in people.submissions if wanted in (None, one.student)]
    with temporary_files_in(run.out), ExitStack() as stack:
        if options.cluster:
            client = stack.enter_context(connect(options.cluster, run.console))
            reports = run.collect(submissions, partial(grade_over, client, run.conditions))
        else:
            on_linux = sys.platform == "linux"
            cores = len(os.sched_getaffinity(0)) if on_linux else os.cpu_count() or 1
            jobs = options.jobs or cores
            reports = run.collect(submissions, partial(grade_here, run.conditions, jobs))
    run.marked.save()
    return reports


def _marks(
    folder: Path, chapters: list[Chapter], people: ClassList, root: Path
) -> tuple[Marks, list[str]]:
    """Read marks.csv, and say which marks are for nobody or for exercises not graded here."""
    manifests = load_chapters(root)
    marks, unused = read_marks(folder / "marks.csv", manifests, people)
    notes = [*people.notes, *unused]
    graded = {exercise.id for chapter in chapters for exercise in chapter.exercises}
    if others := [name for _, name in marks if name not in graded]:
        names = ", ".join(sorted({*others}))
        notes.append(f"Marks for exercises that are not graded here: {len(others)} ({names}).")
    return scaled_marks(marks, chapters, manifests), notes


def _about(run: ClassRun, graded: Sequence[StudentReport], moved: int) -> list[str]:
    """Say what the instructor should know about the reports of a run."""
    lines = []
    if any(report.penalty or report.by_hand or report.waiting for report in graded):
        lines.append(
            "The scores in this table are from checks alone. The totals, which include answers "
            f"marked by hand and late penalties, are in {run.out / 'gradebook.csv'}."
        )
    for report in graded:
        lines += [f"{report.student}: {note}" for note in ([] if report.nothing else report.notes)]
    if moved:
        there = run.out / "earlier"
        lines.append(f"Reports of students outside this class: {moved}, moved to {there}")
    if run.reused:
        lines.append(f"{len(run.reused)} of {len(graded)} reports were kept from an earlier run.")
    marked = {student for student, _ in run.marks}
    if unused := [one.student for one in graded if one.nothing and one.student in marked]:
        names = "; ".join(unused)
        lines.append(f"Marks that do not count, since there is nothing to grade: {names}.")
    return lines
