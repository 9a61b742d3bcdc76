"""One failed check in full, with what to do next: the diagnosis that check and watch show."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from autograder.calls import calls
from autograder.commands import check_command, command
from autograder.definitions import own_name
from autograder.manifest import Chapter, chapters_below, numbers_of
from autograder.places import next_place
from autograder.runner import Verdict
from autograder.scores import Result
from autograder.wrapping import PRINTED, few_lines, print_wrapped, without_printed

if TYPE_CHECKING:
    from rich.console import Console

UNWRITTEN = "not written yet"


@dataclass(frozen=True)
class Failure:
    """A failed check: its diagnosis, what the student's code printed, and what to do next."""

    heading: str
    diagnosis: str
    printed: str
    steps: list[str]


def failure_of(
    chapter: Chapter,
    result: Result,
    engine: list[Path],
    title: str = "",
    edited: Collection[str] = (),
) -> Failure | None:
    """Return the first failure of an exercise, None where it has no check that fails.

    A check that calls one of the functions ``edited`` comes before the others, and one of code that
    is written before one that waits for a body.
    """
    exercise = result.exercise
    candidates = [check for check in result.checks if check.status == result.status]
    if not candidates:
        return None
    failed = min(
        candidates,
        key=lambda check: (check.robust, not _is_about(check, edited), UNWRITTEN in check.message),
    )
    message = failed.message
    inherited = failed.status == "inherited"
    if inherited:  # the cause that a check of this chapter suggests is another
        message = re.sub(r"(?m)^(likely|or|read) .*\n?", "", message).strip()
    diagnosis, printed = without_printed(message)
    lines = [f"check     {failed.name}", diagnosis]
    if failed.robust and exercise.robust:
        lines.insert(0, f"robust    {exercise.robust}")
    title = title or ("Make this robust" if failed.robust else "Fix this first")
    heading = f"{'Inherited, for example' if inherited else title}: {exercise.id} {exercise.title}"
    if inherited:
        steps = [f"Next: {check_command(engine, CH=numbers_of(chapters_below(chapter)))}"]
    else:
        unwritten = re.search(rf"{UNWRITTEN}: Exercise (B?\d+\.\w+)", failed.message)
        nudge = command("hint", EX=unwritten[1] if unwritten else exercise.id)
        place = next_place(engine, chapter, exercise, failed)
        steps = [f"Next: open {place}", f"A nudge: {nudge}"]
    return Failure(heading, "\n".join(lines), printed, steps)


def print_failure(console: Console, chapter: Chapter, result: Result, engine: list[Path]) -> None:
    """Print one failed check in full, and what to do next."""
    failure = failure_of(chapter, result, engine)
    if failure is None:
        words = f"No check was found for exercise {result.exercise.id}."
        console.print(words, style="magenta")
        return
    message = "\n".join(filter(None, [failure.diagnosis, failure.printed]))
    for words, style in [
        (failure.heading, "bold"),
        (message, ""),
        ("", ""),
        (failure.steps[0], "bold"),
        *((step, "") for step in failure.steps[1:]),
    ]:
        print_wrapped(console, words, style)


def few_printed(printed: str, lines: int, characters: int) -> str:
    """Return what the student's code printed, with its label, cut to a few lines."""
    if not printed:
        return ""
    few = few_lines(printed.removeprefix(PRINTED), lines, characters)
    return PRINTED + few.replace("\n", "\n" + " " * len(PRINTED))


def _is_about(check: Verdict, edited: Collection[str]) -> bool:
    """Say whether a check calls one of these functions, or fails in one that is not written."""
    called = re.search(r"(?m)^called +(.*)", check.message)
    where = re.search(r"(?m)^where +.*, in (\w+)", check.message)
    return any(
        (called and calls(called[1], name))
        or (where and where[1] == own_name(name).removesuffix(".setter"))
        for name in edited
    )
