"""The `release` command, which gives students the reference solution after the deadline.

Exercises that have not been released yet remain stubs, so that students can still solve them.
"""

from __future__ import annotations

import argparse
import shutil
from collections.abc import Collection, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

from autograder.answers import FILE, sections_of
from autograder.course.choose import work_of
from autograder.course.late import clock
from autograder.course.model import Course
from autograder.course.reading import read_course
from autograder.diagnosis.earlier_chapters import has_reference
from autograder.files import is_new
from autograder.handouts.stubs import messages_of, stub_module
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.reports.texts import replace_file

RECORD = "released.txt"  # lists what was released, and shows that the folder is a release


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
    release(chapters, exercises, arguments.out)
    return 0


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
    chapters: Sequence[Chapter], exercises: Sequence[str], out: Path, root: Path = ROOT
) -> None:
    """Write the reference solution of some chapters, or of some exercises in them, for students."""
    released = chosen(chapters, exercises)
    if missing := [chapter.name for chapter in released if not has_reference(chapter, root)]:
        raise ValueError(f"the reference of {missing[0]} is not in this folder")
    place, record, problem = out.resolve(), out / RECORD, ""
    if place.is_relative_to(root.resolve()) and not place.is_relative_to(root.resolve() / "build"):
        problem = "outside of the companion or in its build/, so that no handout contains it"
    elif not record.is_file() and not is_new(out, record):
        problem = "a new folder or an earlier release"
    if problem:
        raise ValueError(f"--out must be {problem}, got {str(out)!r}")
    lines = [f"chapter {c.number}: {', '.join(e.id for e in c.exercises)}" for c in released]
    replace_file(record, "\n".join(lines) + "\n")  # first, so that a killed run can be repeated
    shutil.rmtree(out / "reference", ignore_errors=True)
    whole = {chapter.name: chapter for chapter in chapters}
    for chapter in released:
        write_reference(out, chapter, whole[chapter.name], root)
    print(*[f"Released of {line}" for line in lines], f"Reference: {out / 'reference'}", sep="\n")


def chosen(chapters: Sequence[Chapter], exercises: Sequence[str]) -> list[Chapter]:
    """Return the chapters with only these exercises, or with all of them if there are none."""
    known = {e.id.lower() for chapter in chapters for e in chapter.exercises}
    wanted = {name.lower() for name in exercises} or known
    if unknown := [name for name in exercises if name.lower() not in known]:
        names = ", ".join(str(chapter.number) for chapter in chapters)
        raise ValueError(f"there is no exercise {unknown[0]!r} in chapter {names}")
    picked = [
        replace(c, exercises=[e for e in c.exercises if e.id.lower() in wanted]) for c in chapters
    ]
    return [chapter for chapter in picked if chapter.exercises]


def released_module(chapter: Chapter, whole: Chapter, file: str, root: Path = ROOT) -> str:
    """Return the text of a reference module in which all exercises but the released are stubs."""
    kept = {exercise.id for exercise in chapter.exercises}
    held_back = replace(whole, exercises=[e for e in whole.exercises if e.id not in kept])
    text = (root / "solutions" / whole.name / file).read_text(encoding="utf-8")
    messages = messages_of(held_back, file)
    return stub_module(text, messages) if messages else text


def write_reference(out: Path, chapter: Chapter, whole: Chapter, root: Path = ROOT) -> None:
    """Write a chapter's released files into ``out``/reference."""
    folder, solution = out / "reference" / whole.name, root / "solutions" / whole.name
    folder.mkdir(parents=True)
    texts = {name: released_module(chapter, whole, name, root) for name in chapter.edited_files}
    if answers := _model_answers(chapter, solution / FILE):
        texts[FILE] = answers
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")
    for name in chapter.data_files:
        shutil.copyfile(solution / name, folder / name)


def _model_answers(chapter: Chapter, file: Path) -> str:
    """Return the released model answers without the rubrics, or "" if there are none."""
    written = {exercise.id for exercise in chapter.exercises if exercise.kind == "written"}
    if not written or not file.is_file():
        return ""
    parts = [f"# Chapter {chapter.number}: model answers"]
    for section in sections_of(file.read_text(encoding="utf-8")):
        if section.id in written:
            parts += [section.heading, section.question, section.answer]
    return "\n\n".join(parts) + "\n"
