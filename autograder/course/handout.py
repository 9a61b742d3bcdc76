"""Write the parts of a handout that differ between assignments: the manifests and the README."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from autograder.course.late import clock
from autograder.course.model import Work
from autograder.course.points import points_of
from autograder.manifest import Chapter, Exercise, load_chapters
from autograder.scores import shown

POINTS = re.compile(r'(?ms)(?P<before>^id = "(?P<id>[^"]+)"$.*?)^points = [^\n]*')


def for_students(whole: Chapter, assigned: Chapter) -> Chapter:
    """Return the whole chapter with the points of the assignment. Other exercises are optional."""
    own = {exercise.id: exercise for exercise in assigned.exercises}
    exercises = [own.get(e.id) or replace(e, optional=True) for e in whole.exercises]
    return replace(whole, exercises=exercises)


def manifest_of(text: str, chapter: Chapter) -> str:
    """Write a chapter's points, extra credit and optional exercises into its chapter.toml."""

    def entry(found: re.Match[str]) -> str:
        exercise = chapter.exercise(found["id"])
        options = [key for key in ("extra", "optional") if getattr(exercise, key)]
        lines = [f"points = {exercise.points}", *(f"{key} = true" for key in options)]
        return found["before"] + "\n".join(lines)

    return POINTS.sub(entry, text)


def about(work: Work, on_github: Mapping[str, float] | None = None) -> str:
    """Write the README section about an assignment, or "" if the work is whole chapters."""
    if not work.name:
        return ""
    title = f"{work.name}: {work.title}" if work.title else work.name
    due = []
    if work.deadline:
        policy = work.deadline.policy
        due = [f"Due {clock(work.deadline.due)}." + (f"\n{policy.words}" if policy else "")]
    parts = [f"## {title}", *due, _table(work, on_github or {})]
    if on_github:
        parts.append(
            "GitHub Classroom shows whole points only, so its points are rounded. It does not\n"
            "grade written answers, and it adds extra credit to the total."
        )
    whole = {chapter.name: len(chapter.exercises) for chapter in load_chapters()}
    if any(len(chapter.exercises) < whole[chapter.name] for chapter in work.chapters):
        parts.append(
            "The other exercises are optional: you may do them, but they do not count.\n"
            "`make check` marks them."
        )
    if work.earlier:
        parts.append(
            f"This assignment builds on exercises of earlier ones: {', '.join(work.earlier)}.\n"
            "If you begin with a new folder, first copy your own files of these chapters into it."
        )
    return "\n\n".join(parts)


def _table(work: Work, on_github: Mapping[str, float]) -> str:
    exercises = [exercise for chapter in work.chapters for exercise in chapter.exercises]
    rows = [["exercise", "title", "points"], ["---"] * 3]
    rows += [[e.id, e.title, _points(e)] for e in exercises]
    rows.append(["", "total", shown(points_of(work.chapters))])
    if on_github:
        there = [shown(on_github[e.id]) if e.id in on_github else "" for e in exercises]
        there = ["on GitHub", "---", *there, shown(sum(on_github.values()))]
        rows = [[*row, cell] for row, cell in zip(rows, there, strict=True)]
    return "\n".join(
        "|".join(["", *(f" {cell} " if cell else " " for cell in r), ""]) for r in rows
    )


def _points(exercise: Exercise) -> str:
    return f"{shown(exercise.points)}{' (extra credit)' if exercise.extra else ''}"
