"""Define the verdict on a check, and find the exercises that a failed prerequisite blocks."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

from autograder.manifest import Chapter
from autograder.message import NOTHING, Kind, Message

Status = Literal["passed", "failed", "blocked", "inherited", "error"]
Point = tuple[float, float]  # the cost (counted work) and the error, on an open exercise's chart


@dataclass(frozen=True)
class Secret:
    """The name of a hidden check and its full message, which only the instructor may see."""

    name: str
    message: Message


@dataclass(frozen=True)
class Verdict:
    """The outcome of one check: whether it passed and, if not, the message for the student.

    Students may see the name and message of a hidden check: the real ones are in its ``secret``.
    """

    name: str
    exercise: str
    weight: float
    status: Status
    message: Message = NOTHING
    hidden: bool = False
    on_chart: Point | None = None
    robust: bool = False  # whether it tests bad arguments, overflow or NaN, not the physics
    secret: Secret | None = None

    @property
    def state(self) -> str:
        """The status, or "not written yet" if the check fails only because its exercise is not."""
        is_own = self.message.exercise == self.exercise and self.status in ("failed", "blocked")
        unwritten = is_own and self.message.kind is Kind.UNWRITTEN
        return Kind.UNWRITTEN.value if unwritten else self.status


def needs_of(chapter: Chapter, exercise: str) -> set[str]:
    """Collect all prerequisites of an exercise, both direct and indirect."""
    needs = set(chapter.exercise(exercise).needs)
    return needs.union(*(needs_of(chapter, need) for need in needs))


def with_needs(chapter: Chapter, exercises: list[str] | None) -> list[str]:
    """Return these exercises (by default all) and their prerequisites, in manifest order."""
    everything = [exercise.id for exercise in chapter.exercises]
    if exercises is None:
        return everything
    wanted = set(exercises).union(*(needs_of(chapter, exercise) for exercise in exercises))
    return [exercise for exercise in everything if exercise in wanted]


def asked_for(chapter: Chapter) -> list[str]:
    """List the exercises that students must do, together with all of their prerequisites."""
    return with_needs(chapter, [e.id for e in chapter.exercises if not e.optional])


def mark_blocked(chapter: Chapter, verdicts: list[Verdict]) -> list[Verdict]:
    """Change each failed verdict to blocked if its exercise builds on one that still fails.

    Only the physics checks of a prerequisite matter. A check that passes although its exercise is
    blocked keeps its verdict and its points.
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
