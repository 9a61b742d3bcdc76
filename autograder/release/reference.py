"""Write the part of the reference solution that has been released to students.

Exercises that have not been released yet remain stubs, so that students can still solve them.
"""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from autograder.answers import FILE, sections_of
from autograder.handouts.stubs import messages_of, stub_module
from autograder.manifest import ROOT, Chapter


def chosen(chapters: Sequence[Chapter], exercises: Sequence[str]) -> list[Chapter]:
    """Return copies of the chapters that contain only the exercises to release.

    If ``exercises`` is empty, all exercises are released. A chapter in which nothing is released is
    left out.

    Raises:
        ValueError: An exercise does not exist in any of the chapters.
    """
    known = {e.id.lower(): e.id for chapter in chapters for e in chapter.exercises}
    wanted = {known.get(name.lower(), "") for name in exercises}
    if unknown := [name for name in exercises if name.lower() not in known]:
        names = ", ".join(str(chapter.number) for chapter in chapters)
        raise ValueError(f"there is no exercise {unknown[0]!r} in chapter {names}")
    picked = [
        replace(c, exercises=[e for e in c.exercises if not exercises or e.id in wanted])
        for c in chapters
    ]
    return [chapter for chapter in picked if chapter.exercises]


def released_module(chapter: Chapter, whole: Chapter, file: str, root: Path = ROOT) -> str:
    """Return the text of a reference module in which only the released exercises are solved.

    The functions of all other exercises are stubs, which do not give away the solution.
    """
    kept = {exercise.id for exercise in chapter.exercises}
    held_back = replace(whole, exercises=[e for e in whole.exercises if e.id not in kept])
    text = (root / "solutions" / whole.name / file).read_text(encoding="utf-8")
    messages = messages_of(held_back, file)
    return stub_module(text, messages) if messages else text


def write_reference(
    out: Path, chapter: Chapter, whole: Chapter, root: Path = ROOT
) -> dict[str, str]:
    """Write the released solutions of a chapter into ``out``, and return the text of each module.

    The files go into the folder reference/ in ``out``, together with the data files and the
    released model answers of the chapter.
    """
    folder = out / "reference" / whole.name
    folder.mkdir(parents=True)
    modules = {name: released_module(chapter, whole, name, root) for name in chapter.edited_files}
    for name, text in modules.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")
    for name in chapter.data_files:
        shutil.copyfile(root / "solutions" / whole.name / name, folder / name)
    if answers := _model_answers(chapter, root):
        (folder / FILE).write_text(answers, encoding="utf-8", newline="\n")
    return modules


def _model_answers(chapter: Chapter, root: Path) -> str:
    """Return the released model answers to the written exercises, without the rubrics.

    If no written exercise is released, return an empty string.
    """
    file = root / "solutions" / chapter.name / FILE
    written = {exercise.id for exercise in chapter.exercises if exercise.kind == "written"}
    if not written or not file.is_file():
        return ""
    parts = [f"# Chapter {chapter.number}: model answers"]
    for section in sections_of(file.read_text(encoding="utf-8")):
        if section.id in written:
            parts += [section.heading, section.question, section.answer]
    return "\n\n".join(parts) + "\n"
