"""Format a student's points for the screen, with a progress bar."""

from __future__ import annotations

from autograder.checks.verdict import asked_for
from autograder.manifest import Chapter
from autograder.scores import Result, extra_possible, of_possible, possible, shown, total

BAR = 40


def points_line(results: list[Result]) -> str:
    """Return the line that shows how many points a student has, with a progress bar."""
    earned, points = total(results)
    written = [r.exercise for r in results if r.exercise.kind == "written"]
    extra = extra_possible(r.exercise for r in results if r.exercise not in written)
    answers = possible(written) + extra_possible(written)
    if not points and not extra:
        by_person = f"Points for written answers, marked by a person: {shown(answers)}"
        return by_person if answers else "Optional exercises earn no points."
    more = f", plus {shown(answers)} for written answers, marked by a person" if answers else ""
    has_bar = bar(earned or 0.0, points or extra)
    return f"{has_bar} {of_possible(earned, points, extra)}{more}"


def points_of(chapter: Chapter, result: Result) -> str:
    """Return a student's points for an exercise, such as "2/3".

    An optional exercise is "optional", or "needed" if a required exercise builds on it.
    """
    exercise = result.exercise
    if exercise.optional:
        return "needed" if exercise.id in asked_for(chapter) else "optional"
    extra = " extra" if exercise.extra else ""
    return f"{shown(result.score)}/{shown(exercise.points)}{extra}"


def bar(part: float, whole: float) -> str:
    """Return a progress bar such as [####....], which shows the fraction ``part / whole``."""
    filled = min(BAR, int(BAR * part / whole)) if whole else 0
    return f"[{'#' * filled}{'.' * (BAR - filled)}]"
