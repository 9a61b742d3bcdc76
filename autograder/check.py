"""Check chapters for a student, and tell failures of their own from inherited ones."""

from __future__ import annotations

from pathlib import Path

from autograder.given import mark_inherited, suspects
from autograder.manifest import Chapter, Exercise
from autograder.runner import run_checks, with_needs
from autograder.scores import Result, results_of
from autograder.screen import ProgressBar, print_chapter, print_failure, print_suspects

URGENCY = {"blocked": 1, "inherited": 2}  # what is shown last: another failure is behind it


def check(
    chapters: list[Chapter], exercise: Exercise | None, engine: list[Path], seed: str
) -> bool:
    """Check the chapters, or one exercise and what it needs; print it all; return success.

    A check that an earlier chapter fails, and not this one, is shown as inherited.
    """
    results: dict[str, list[Result]] = {}
    doubtful: dict[str, list[Chapter]] = {}
    with ProgressBar() as progress:
        for chapter in chapters:
            progress.title = f"chapter {chapter.number}"
            wanted = with_needs(chapter, [exercise.id] if exercise else None)
            verdicts = run_checks(
                chapter, engine, seed=seed, exercises=wanted, on_verdict=progress.show
            )
            verdicts = mark_inherited(chapter, verdicts, engine, seed)
            doubtful[chapter.name] = suspects(chapter, verdicts, engine, seed)
            results[chapter.name] = [
                result for result in results_of(chapter, verdicts) if result.exercise.id in wanted
            ]
    console = progress.console
    for chapter in chapters:
        print_chapter(console, chapter, results[chapter.name], engine)
        print_suspects(console, doubtful[chapter.name])
    everything = [(chapter, result) for chapter in chapters for result in results[chapter.name]]
    open_ones = [pair for pair in everything if pair[1].status not in ("passed", "waiting")]
    if not open_ones:
        console.print("Everything that can be checked passes.", style="bold green")
        return True
    first = min(open_ones, key=lambda pair: URGENCY.get(pair[1].status, 0))
    print_failure(console, *first, engine)
    return False
