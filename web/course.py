"""Collect the data that the website shows: chapters, exercises, stubs and questions."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from autograder.answers import FILE, sections_of
from autograder.handouts.stubs import make_stubs
from autograder.manifest import ROOT, Chapter, chapters_below, load_chapters


def course() -> dict[str, Any]:
    """Collect what the website shows of all chapters, without solutions and model answers."""
    stubs = {path.removeprefix("chapters/"): text for path, text in make_stubs().items()}
    return {"chapters": [_chapter(chapter, stubs) for chapter in load_chapters()]}


def _chapter(chapter: Chapter, stubs: dict[str, str]) -> dict[str, Any]:
    """Collect the data of a chapter: "files" are stubs, and "complete" are given modules."""
    files = {path: text for path, text in stubs.items() if path.startswith(f"{chapter.name}/")}
    answers = files.get(f"{chapter.name}/{FILE}")
    folder = ROOT / "chapters" / chapter.name
    return {
        "name": chapter.name,
        "number": chapter.number,
        "title": chapter.title,
        "summary": chapter.summary,
        "you_can": chapter.you_can,
        "builds_on": [below.number for below in chapters_below(chapter)],
        "exercises": [asdict(exercise) for exercise in chapter.exercises],
        "questions": {
            section.id: section.question for section in (sections_of(answers) if answers else ())
        },
        "files": files,
        "complete": {
            f"{chapter.name}/{name}": (folder / name).read_text(encoding="utf-8")
            for name in chapter.complete
        },
    }
