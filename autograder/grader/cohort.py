"""Grade a whole class: run the checks on every submission, and write all reports.

A run that was interrupted is resumed, so that no submission is graded twice.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from autograder.analysis.class_page import write_class_page
from autograder.checks.arrange import SandboxSettings
from autograder.checks.runner import GraderError, Limits, run_checks
from autograder.course.model import Deadline
from autograder.course.of_class import lateness, scaled_marks
from autograder.grader.assignment import Assignment
from autograder.grader.class_folder import (
    only_run,
    put_others_aside,
    refuse_dropped,
    refuse_other_class,
    refuse_place,
    seed_of,
    temporary_files_in,
)
from autograder.grader.class_run import ClassRun, print_class
from autograder.grader.cluster import connect, grade_over
from autograder.grader.people import differences, folder_with_names, people_of
from autograder.grader.regrade import Regrade
from autograder.isolation.level import choose_level
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.marking.marked_answers import MarkedAnswers
from autograder.platforms.give_back import give_back
from autograder.platforms.uploads import Column, write_uploads
from autograder.reports.marks import Marks, read_marks
from autograder.reports.report import Late, StudentReport
from autograder.reports.results import write_class
from autograder.reports.texts import replace_file
from autograder.submissions.codes import key_path
from autograder.submissions.moodle_worksheet import worksheet_in
from autograder.text.wrapping import plain_console


@dataclass(frozen=True)
class ClassOptions:
    """The options with which an instructor grades a class.

    Attributes:
        given: Chapters that come from the reference solution, even if students hand in files for
            them.
        earlier: The exercises of earlier assignments that the graded ones build on, with the names
            of these assignments.
        seed: The seed for the random numbers in the checks. If it is None, a new run draws a seed,
            and an interrupted run keeps its own.
        hidden: A folder of hidden checks, with paths such as chNN_name/test_*.py.
        unsafe: True to allow grading without a sandbox on a machine that has none.
        jobs: The number of submissions to grade at a time, by default one per core.
        cluster: The address of a Dask scheduler. Its workers then grade instead of this machine.
        deadline: When the work was due. The reports then say who was late.
        roster: A CSV file that lists the students of the class.
        anonymous: True if the reports must show codes instead of names.
        column: The gradebook column of Canvas or Moodle that the grades are for.
        assignment: The name of the assignment, or "" if whole chapters are graded.
        student: The only student to regrade, if the class has been graded before.
        why: The reason for the regrade, as it appears in the log.
    """

    given: Sequence[Chapter] = ()
    earlier: Mapping[str, str] = field(default_factory=dict)
    seed: str | None = None
    hidden: Path | None = None
    unsafe: bool = False
    root: Path = ROOT
    time_limit: float = Limits.check
    jobs: int | None = None
    cluster: str | None = None
    deadline: Deadline | None = None
    roster: Path | None = None
    anonymous: bool = False
    column: Column = field(default_factory=Column)
    assignment: str = ""
    student: str | None = None
    why: str = ""

    def __post_init__(self) -> None:
        if self.jobs is not None and self.jobs < 1:
            raise ValueError(f"--jobs must be at least 1, got {self.jobs}")
        if self.jobs is not None and self.cluster:
            raise ValueError("--jobs is for this machine; on a cluster, set --nthreads of workers")
        if self.why and not self.student:
            raise ValueError("--note is for the log of regrades: add --student")


def grade(folder: Path, out: Path, chapters: list[Chapter], options: ClassOptions) -> int:
    """Grade every submission in ``folder``, and write the reports to the folder ``out``.

    A complete report from an earlier run is kept if it is still valid. That means that the
    submission, the checks, the grader and the seed have not changed.

    Returns:
        The exit code, which is 1 if the grader failed on a submission.

    Raises:
        ValueError: The class cannot be graded with these options.
        OSError: A file cannot be read or written.
    """
    named = folder_with_names(out, folder, anonymous=options.anonymous)
    people = people_of(folder, out, options.roster, anonymous=options.anonymous)
    worksheet = worksheet_in(folder)
    submissions = people.submissions
    refuse_place(out, folder, submissions)
    work = {
        "assignment": options.assignment,
        "chapters": [chapter.number for chapter in chapters],
        "given": [chapter.number for chapter in options.given],
        "anonymous": options.anonymous,
    }
    refuse_other_class(out, people, folder, work)
    everyone = [submission.student for submission in submissions]
    manifests = load_chapters(options.root)
    marks, unused = read_marks(folder / "marks.csv", manifests, people)
    notes = [*people.notes, *unused, *_marks_elsewhere(marks, chapters)]
    marks = scaled_marks(marks, chapters, manifests)
    marked = MarkedAnswers(folder)
    late: dict[str, Late] = {}
    if options.deadline:
        late, more_notes = lateness(options.deadline, chapters, folder, people)
        notes += more_notes
    level = choose_level(folder, unsafe=options.unsafe)
    with only_run(out) as state:
        has_roster = options.roster is not None
        has_checks = options.hidden is not None
        refuse_dropped(
            state,
            has_roster=has_roster,
            has_checks=has_checks,
            is_regrade=options.student is not None,
        )
        again = Regrade(out, options.student, people) if options.student else None
        seed = again.seed(options.seed) if again else seed_of(state, options.seed)
        hidden = options.hidden and options.hidden.resolve()
        assignment = Assignment(
            chapters,
            seed,
            level,
            options.given,
            hidden,
            options.root,
            options.time_limit,
            options.earlier,
        )
        check_hidden(assignment)
        console = plain_console()
        class_run = ClassRun(
            assignment, out, marks, console, late, marked=marked, anonymous=options.anonymous
        )
        if again:
            submissions = again.prepare(class_run)
        record = {"seed": seed, "finished": False, "roster": has_roster, "checks": has_checks}
        record |= {"folder": str(folder.resolve()), **work}
        replace_file(state, json.dumps(record) + "\n")
        for note in notes:
            console.print(note, markup=False)
        with temporary_files_in(out), ExitStack() as stack:
            if options.cluster:
                client = stack.enter_context(connect(options.cluster, assignment, console))
                over = partial(grade_over, client, assignment)
                arriving = class_run.elsewhere(submissions, over)
            else:
                arriving = class_run.here(submissions, options.jobs or _cores())
            graded = class_run.collect(submissions, arriving)
        marked.save()
        reports = again.finish(graded, options.why, console) if again else graded
        moved = put_others_aside(out, [report.student for report in reports])
        places = write_class(out, chapters, reports, people)
        places.append(write_class_page(out, chapters, reports))
        uploads, lines = write_uploads(named, chapters, people, reports, options.column, worksheet)
        uploads += give_back(named, out, people, reports)
        finished = all(report.status != "error, retry" for report in reports)
        finished = finished and {*everyone} == {report.student for report in reports}
        replace_file(state, json.dumps({**record, "finished": finished}) + "\n")
    print_class(console, graded)
    if any(report.penalty or report.by_hand or report.waiting for report in graded):
        console.print(
            "The points in this table are from checks alone. The totals, which include answers "
            f"marked by hand and late penalties, are in {out / 'gradebook.csv'}.",
            markup=False,
        )
    for report in graded:
        for note in [] if report.nothing else report.notes:
            console.print(f"{report.student}: {note}", markup=False)
    if moved:
        console.print(
            f"Reports of students outside this class: {moved}, moved to {out / 'earlier'}"
        )
    if class_run.reused:
        console.print(
            f"{len(class_run.reused)} of {len(graded)} reports were kept from an earlier run."
        )
    lines += _marks_for_nothing(marks, graded)
    for line in [*differences(people, reports), *lines]:
        console.print(line, markup=False)
    console.print(f"Seed {seed}. Isolation: {level}.", markup=False)
    if options.anonymous:
        uploads.append(key_path(options.roster, out))
    for place in places:
        console.print(str(place), markup=False, soft_wrap=True)
    for place in uploads:
        only_you = ": keep this private, because it contains names" if options.anonymous else ""
        console.print(f"{place}{only_you}", markup=False, soft_wrap=True)
    return int(any(report.status == "error, retry" for report in graded))


def _marks_elsewhere(marks: Marks, chapters: list[Chapter]) -> list[str]:
    """Say which marks are for exercises that are not graded here."""
    graded = {exercise.id for chapter in chapters for exercise in chapter.exercises}
    others = sorted({name for _, name in marks if name not in graded})
    if not others:
        return []
    count = sum(name in others for _, name in marks)
    return [f"Marks for exercises that are not graded here: {count} ({', '.join(others)})."]


def _marks_for_nothing(marks: Marks, reports: Sequence[StudentReport]) -> list[str]:
    """Say whose marks do not count because nothing was handed in that can be graded."""
    names = [r.student for r in reports if r.nothing and any(who == r.student for who, _ in marks)]
    if not names:
        return []
    return [f"Marks that do not count, since there is nothing to grade: {'; '.join(names)}."]


def check_hidden(assignment: Assignment) -> None:
    """Test the instructor's hidden checks on the reference solution before any student is graded.

    A hidden check that fails on the reference solution contains a mistake and would cost students
    points.

    Raises:
        ValueError: The folder has no hidden checks for a graded chapter, they cannot be run, or the
            reference solution fails one of them.
    """
    hidden, root = assignment.hidden, assignment.root
    if hidden is None:
        return
    graded = [chapter for chapter in assignment.chapters if (hidden / chapter.name).is_dir()]
    if not graded:
        names = ", ".join(chapter.name for chapter in assignment.chapters)
        raise ValueError(f"--checks must be a folder with one of {names}, got {str(hidden)!r}")
    sandbox = SandboxSettings(vars(assignment.level), hidden=hidden)
    engine = [root / "solutions", root / "chapters"]
    for chapter in graded:
        for probes in (root / "tests" / chapter.name).glob("*probes.py"):
            if (hidden / chapter.name / probes.name).exists():
                raise ValueError(
                    f"{hidden / chapter.name / probes.name} has the name of a public file. "
                    "Rename it to hidden_probes.py"
                )
        try:
            verdicts = run_checks(
                assignment.whole(chapter),
                engine,
                seed=assignment.seed,
                root=root,
                sandbox=sandbox,
                exercises=[exercise.id for exercise in chapter.exercises],
            )
        except GraderError as error:
            raise ValueError(
                f"the checks in {hidden / chapter.name} cannot be run: {error}"
            ) from error
        if not any(verdict.hidden for verdict in verdicts):
            raise ValueError(
                f"there is no check in {hidden / chapter.name} of a graded exercise: "
                "add a test_*.py"
            )
        for check in verdicts:
            if check.status != "passed":
                told = check.secret or check
                raise ValueError(f"{told.name} fails on the reference itself: {told.message}")


def _cores() -> int:
    if sys.platform == "linux":
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
