"""The verdict on a check, and the dependencies between exercises."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

from autograder.manifest import Chapter
from autograder.message import NOTHING, Message

Status = Literal["passed", "failed", "blocked", "inherited", "error"]
Point = tuple[float, float]  # on the chart of an open exercise: cost (counted work), error


@dataclass(frozen=True)
class Verdict:
    """The verdict on one check.

    A ``robust`` check tests bad arguments, overflow or NaN instead of the physics.
    """

    name: str
    exercise: str
    weight: float
    status: Status
    message: Message = NOTHING
    hidden: bool = False
    on_chart: Point | None = None
    robust: bool = False


def needs_of(chapter: Chapter, exercise: str) -> set[str]:
    """Return all exercises on which an exercise depends, directly or indirectly."""
    needs = set(chapter.exercise(exercise).needs)
    return needs.union(*(needs_of(chapter, need) for need in needs))


def with_needs(chapter: Chapter, exercises: list[str] | None) -> list[str]:
    """Return ``exercises`` and their prerequisites in the order of the manifest.

    If ``exercises`` is None, return all exercises of the chapter.
    """
    everything = [exercise.id for exercise in chapter.exercises]
    if exercises is None:
        return everything
    wanted = set(exercises).union(*(needs_of(chapter, exercise) for exercise in exercises))
    return [exercise for exercise in everything if exercise in wanted]


def asked_for(chapter: Chapter) -> list[str]:
    """Return the exercises that are not optional, together with their prerequisites."""
    return with_needs(chapter, [e.id for e in chapter.exercises if not e.optional])


def mark_blocked(chapter: Chapter, verdicts: list[Verdict]) -> list[Verdict]:
    """Change failed verdicts of an exercise to blocked if one of its prerequisites fails.

    An exercise blocks others only if its physics checks fail. Failed robust checks do not block. A
    check that passes keeps its verdict and earns its points, even if its exercise is blocked.
    """
    failing = {v.exercise for v in verdicts if v.status != "passed" and not v.robust}
    marked = []
    for verdict in verdicts:
        needs = [need for need in chapter.exercise(verdict.exercise).needs if need in failing]
        if needs and verdict.status == "failed":
            titles = tuple(f"{need} ({chapter.exercise(need).title})" for need in needs)
            message = replace(verdict.message, blocked_by=titles)
            verdict = replace(verdict, status="blocked", message=message)
        marked.append(verdict)
    return marked
