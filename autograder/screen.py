"""What a student sees: every exercise with its state, one failure in full, the next step.

rich is loaded when it is needed: by then the checks run in their own process, so nobody waits.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

from autograder.answers import answered
from autograder.given import chapters_below
from autograder.manifest import Chapter
from autograder.places import next_place
from autograder.scores import Result, shown, total, without_inherited

if TYPE_CHECKING:
    from rich.console import Console

STYLES = {
    "passed": "green",
    "failed": "red",
    "blocked": "yellow",
    "inherited": "cyan",
    "error": "magenta",
}
UNWRITTEN = "not written yet"
BAR = 40


class ProgressBar:
    """A bar on a terminal while the checks run, silent elsewhere."""

    title = ""
    _bar = None

    def __enter__(self) -> ProgressBar:
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.stop()

    @property
    def console(self) -> Console:
        from rich.console import Console

        return Console(highlight=False)

    def show(self, done: int, of: int) -> None:
        from rich.progress import Progress

        if self._bar is None:
            self._bar = Progress(console=self.console, transient=True)
            self._task = self._bar.add_task(self.title)
            self._bar.start()
        self._bar.update(self._task, description=self.title, completed=done, total=of)


def print_chapter(
    console: Console, chapter: Chapter, results: list[Result], engine: list[Path]
) -> None:
    """Print the table of a chapter, its points, and what an earlier chapter took of them."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    console.print(f"\nChapter {chapter.number}: {chapter.title}", style="bold")
    table = Table("", "exercise", "stars", "state", box=SIMPLE_HEAD, pad_edge=False)
    table.add_column("checks", justify="right")
    table.add_column("points", justify="right")
    written = _answered(chapter, engine)
    for result in results:
        exercise = result.exercise
        state = _state(result, written)
        passed = sum(check.status == "passed" for check in result.checks)
        table.add_row(
            exercise.id,
            exercise.title,
            "*" * exercise.stars,
            state,
            f"{passed}/{len(result.checks)}" if result.checks else "",
            f"{shown(result.score)}/{exercise.points}",
            style=STYLES.get(state, ""),
        )
    console.print(table)
    earned, points = total(results)
    filled = int(BAR * (earned or 0.0) / points) if points else 0
    bar = "#" * filled + "." * (BAR - filled)
    answers = sum(result.exercise.points for result in results) - points
    more = f", and {answers} for written answers, which a person marks" if answers else ""
    console.print(f"[{bar}] {shown(earned)} of {points} points{more}\n", markup=False)
    _print_inherited(console, chapter, results)


def _print_inherited(console: Console, chapter: Chapter, results: list[Result]) -> None:
    """Say how many checks an earlier chapter fails, and the two ways to go on."""
    lost = sum(check.status == "inherited" for result in results for check in result.checks)
    if not lost:
        return
    below = _below(chapter)
    checks = f"{lost} check fails" if lost == 1 else f"{lost} checks fail"
    earlier = f"chapters {below}" if "-" in below else f"chapter {below}"
    console.print(
        f"{checks} here for what is wrong in {earlier}. On the reference's {earlier} this one has "
        f"{shown(without_inherited(results))} points.\n"
        f"Mend it:     make check CH={below}\n"
        f"Or go on:    make check CH={chapter.number} GIVEN={below}\n",
        style=STYLES["inherited"],
        soft_wrap=True,
    )


def print_suspects(console: Console, chapters: list[Chapter]) -> None:
    """Say which chapters below may be the reason for some failures."""
    for chapter in chapters:
        console.print(
            f"Chapter {chapter.number} fails checks of its own, which may be the reason for some "
            f"failures here: make check CH={chapter.number}\n",
            style=STYLES["inherited"],
            soft_wrap=True,
        )


def _below(chapter: Chapter) -> str:
    """Return the chapters below one as a text, such as 2 or 2-5."""
    numbers = [other.number for other in chapters_below(chapter)]
    return str(numbers[0]) if len(numbers) == 1 else f"{numbers[0]}-{numbers[-1]}"


def _state(result: Result, written: set[str]) -> str:
    if result.status == "waiting":
        return "answered" if result.exercise.id in written else "to answer"
    if result.status == "inherited":
        return result.status
    lost = [check for check in result.checks if check.status != "passed"]
    if not lost or any(UNWRITTEN not in check.message for check in lost):
        return result.status
    return UNWRITTEN if len(lost) == len(result.checks) else "half written"


def _answered(chapter: Chapter, engine: list[Path]) -> set[str]:
    for folder in engine:
        file = folder / chapter.name / "answers.md"
        if file.exists():
            return answered(file.read_text(encoding="utf-8", errors="replace"))
    return set()


def print_failure(console: Console, chapter: Chapter, result: Result, engine: list[Path]) -> None:
    """Print one failed check in full, and what to do next."""
    exercise = result.exercise
    failed = next((check for check in result.checks if check.status == result.status), None)
    if failed is None:
        console.print(f"No check was found for exercise {exercise.id}.", style="magenta")
        return
    inherited = failed.status == "inherited"
    heading = "Inherited, for example" if inherited else "First to repair"
    console.print(f"{heading}: {exercise.id} {exercise.title}", style="bold")
    console.print(f"check     {failed.name}\n{failed.message}\n", markup=False, soft_wrap=True)
    if inherited:
        console.print(f"Next: make check CH={_below(chapter)}", style="bold")
        return
    place = next_place(engine, chapter, exercise, failed)
    console.print(f"Next: open {place}", style="bold", markup=False, soft_wrap=True)
    unwritten = re.search(rf"{UNWRITTEN}: Exercise (B?\d+\.\w+)", failed.message)
    console.print(f"A nudge: make hint EX={unwritten[1] if unwritten else exercise.id}")
