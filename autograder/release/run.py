"""The `release` command, which gives students the reference solution after the deadline."""

from __future__ import annotations

import argparse
import shutil
import tempfile
from collections.abc import Collection, Mapping, Sequence
from datetime import UTC, datetime
from pathlib import Path

from rich.progress import track

from autograder.course.choose import work_of
from autograder.course.late import clock
from autograder.course.model import Course
from autograder.course.reading import read_course
from autograder.diagnosis.earlier_chapters import has_reference
from autograder.files import is_new
from autograder.grader.reports_folder import graded_folder
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.release.pages import Compared, Texts, compare, write_page
from autograder.release.reference import chosen, write_reference
from autograder.reports.report import StudentReport
from autograder.reports.results import read_results
from autograder.reports.texts import replace_file
from autograder.submissions.class_list import ClassList, read_class
from autograder.submissions.find import Submission, file_name
from autograder.submissions.stage import stage
from autograder.submissions.unpack import class_folder
from autograder.text.wrapping import plain_console

RECORD = "released.txt"  # lists what was released, and shows that the folder is a release
UNFINISHED = "This release was interrupted. Run the same command again.\n"


def run_release(arguments: argparse.Namespace) -> int:
    """Release what the arguments say, unless a student may still hand it in."""
    course = None
    if arguments.assignment or arguments.course.is_file():
        # Any mistake in the file is an error here, because it could hide a due date.
        course = read_course(arguments.course)
    work = work_of(arguments, handed_out=True)
    exercises = arguments.exercises.replace(",", " ").split()
    assigned = [exercise.id for chapter in work.chapters for exercise in chapter.exercises]
    if course:
        refuse_early(course, exercises or assigned, datetime.now(UTC))
    if arguments.assignment:
        exercises = exercises or assigned
    numbers = [chapter.number for chapter in work.chapters]
    chapters = [chapter for chapter in load_chapters() if chapter.number in numbers]
    submissions = arguments.submissions and class_folder(arguments.submissions)
    roster = arguments.roster or work.roster
    return release(chapters, exercises, submissions, arguments.grades, arguments.out, roster=roster)


def refuse_early(course: Course, released: Collection[str], now: datetime) -> None:
    """Raise ValueError if any student may still hand in work for one of these exercises."""
    wanted = {name.lower() for name in released}
    for work in course.assignments:  # an exercise may belong to several
        ids = [exercise.id for chapter in work.chapters for exercise in chapter.exercises]
        both = [name for name in ids if name.lower() in wanted]
        if work.deadline is None or not both:
            continue
        dues = [work.deadline.due, *work.deadline.extensions.values()]
        last = max(dues, key=lambda due: due.astimezone(UTC))
        if now < last.astimezone(UTC):
            raise ValueError(
                f"{work.name} is due {clock(last)}, counting extensions. Release its reference "
                f"later, or name other exercises: {', '.join(both)} must wait"
            )


def release(
    chapters: Sequence[Chapter],
    exercises: Sequence[str],
    submissions: Path | None,
    grades: Path | None,
    out: Path,
    root: Path = ROOT,
    *,
    roster: Path | None = None,
) -> int:
    """Write the reference solution of some chapters, or of some exercises in them, for students.

    With ``submissions`` and ``grades``, each student also gets a page that compares the student's
    code with the reference solution. The ``roster`` must be the one used for grading.
    """
    released = chosen(chapters, exercises)
    if missing := [chapter.name for chapter in released if not has_reference(chapter, root)]:
        raise ValueError(f"the reference of {missing[0]} is not in this folder")
    _refuse_place(out, submissions, root)
    if submissions and not grades:
        raise ValueError("--submissions needs the --grades of the same class")
    if grades and not submissions and not (submissions := graded_folder(grades)):
        raise ValueError(f"{grades} does not say which class it is about: name its --submissions")
    reports = read_results(grades) if grades else []
    people = read_class(submissions, roster) if submissions else ClassList([])
    found, notes = people.submissions, [*people.notes]
    _empty(out, submissions, found)
    whole = {chapter.name: chapter for chapter in chapters}
    texts = {c.name: write_reference(out, c, whole[c.name], root) for c in released}
    console = plain_console()
    of = {report.student: report for report in reports}
    pages = 0
    silent = not console.is_terminal
    for one in track(found, "comparing", console=console, transient=True, disable=silent):
        compared, left_out, why = _compare(one, of.get(one.student), released, texts, root)
        if compared:
            write_page(out, one.student, compared, left_out)
            pages += 1
        else:
            notes.append(f"{one.student} has no page: {why}")
    lines = [f"chapter {c.number}: {', '.join(e.id for e in c.exercises)}" for c in released]
    replace_file(out / RECORD, "\n".join(lines) + "\n")
    notes += [f"Released of {line}" for line in lines]
    count = f"{pages} of {len(found)} students have a page in {out / 'students'}"
    no_class = "No class was compared. Name a graded one with --submissions and --grades."
    for note in [*notes, count if reports else no_class, f"Reference: {out / 'reference'}"]:
        console.print(note, markup=False, soft_wrap=True)
    return 0


def _refuse_place(out: Path, submissions: Path | None, root: Path) -> None:
    """Raise ValueError if ``out`` would get into a handout or a class, or has other files."""
    place, record, problem = out.resolve(), out / RECORD, ""
    if place.is_relative_to(root.resolve()) and not place.is_relative_to(root.resolve() / "build"):
        problem = "outside of the companion or in its build/, so that no handout contains it"
    elif submissions and place.is_relative_to(submissions.resolve()):
        problem = "outside of the folder of the class"
    elif not record.is_file() and not is_new(out, record):
        problem = "a new folder or an earlier release"
    if problem:
        raise ValueError(f"--out must be {problem}, got {str(out)!r}")


def _empty(out: Path, submissions: Path | None, found: Sequence[Submission]) -> None:
    """Delete an earlier release, or raise ValueError if pages of other students would be lost."""
    names = {file_name(one.student) for one in found}
    others = [path.stem for path in (out / "students").glob("*.html") if path.stem not in names]
    if others:
        raise ValueError(
            f"{out} has the pages of {len(others)} students who are not in {submissions}, "
            f"such as {others[0]}. Name their class with --submissions and --grades "
            "(make: SUBMISSIONS=, GRADES=), or use another --out (make: OUT=)"
        )
    replace_file(out / RECORD, UNFINISHED)  # so that a run that is killed can be started again
    for name in ("reference", "students"):
        shutil.rmtree(out / name, ignore_errors=True)


def _compare(
    submission: Submission,
    report: StudentReport | None,
    released: Sequence[Chapter],
    reference: Mapping[str, Texts],
    root: Path,
) -> tuple[list[Compared], list[str], str]:
    """Compare a student's solved exercises with the reference solution, function by function.

    Returns:
        The comparisons, the ids of the released exercises that the student has not solved, and the
        reason to report if there are no comparisons.
    """
    if report is None or submission.nothing:
        return [], [], submission.nothing if report else "the work was not graded"
    chapters = {chapter.name: chapter for chapter in load_chapters(root)}
    with tempfile.TemporaryDirectory(prefix="release-") as folder:
        staged = stage(submission.path, [*chapters.values()], Path(folder), root)
        if staged.digest != report.submission:  # then the results may no longer be correct
            return [], [], "the work has changed since it was graded. Grade it again first"
        texts = {
            path: (Path(folder) / path).read_text(encoding="utf-8-sig")
            for path in staged.taken
            if path.endswith(".py")
        }
    passed = {result.exercise.id for result in report.results if result.status == "passed"}
    compared: list[Compared] = []
    left_out = []
    for chapter in released:
        start = f"{chapter.name}/"
        own = {p.removeprefix(start): text for p, text in texts.items() if p.startswith(start)}
        solved = [exercise for exercise in chapter.exercises if exercise.id in passed]
        left_out += [e.id for e in chapter.exercises if e.edit and e.id not in passed]
        compared += compare(chapters[chapter.name], solved, own, reference[chapter.name])
    return compared, left_out, "no released exercise passed"
