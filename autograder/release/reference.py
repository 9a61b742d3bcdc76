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


def write_reference(
    out: Path, chapter: Chapter, whole: Chapter, root: Path = ROOT
) -> dict[str, str]:
    """Write a chapter's released files into ``out``/reference, and return its modules' texts."""
    folder, solution = out / "reference" / whole.name, root / "solutions" / whole.name
    folder.mkdir(parents=True)
    modules = {name: released_module(chapter, whole, name, root) for name in chapter.edited_files}
    answers = _model_answers(chapter, solution / FILE)
    for name, text in {**modules, **({FILE: answers} if answers else {})}.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")
    for name in chapter.data_files:
        shutil.copyfile(solution / name, folder / name)
    return modules


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
