"""Run the checks of a chapter on a student's code, and remember the results."""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from autograder.checks.runner import GraderError, run_checks
from autograder.checks.verdict import Verdict, with_needs
from autograder.diagnosis.earlier_chapters import (
    below_and_not_given,
    explained_on_given,
    mark_inherited,
    run_on_given,
    suspects,
)
from autograder.manifest import Chapter, Exercise
from autograder.scores import Result, results_of

Show = Callable[[str, int, int], None]  # takes a title, and how many checks of how many have run


@dataclass(frozen=True)
class ChapterResults:
    """The results of checking a student's code for one chapter."""

    chapter: Chapter
    results: list[Result]
    on_reference: list[Result]  # with our solutions to the earlier chapters, if that has run
    suspects: list[Chapter]  # earlier chapters whose mistakes may have caused failures


def show_progress(title: str, done: int, of: int) -> None:
    """Show on a terminal how many checks of a chapter have run so far, until all have run."""
    import rich.table  # noqa: F401 - this takes a while, in which the checks go on

    if sys.stdout.isatty():
        words = f"{title}: {done} of {of} checks" if done < of else ""
        print(f"\r{words:50}\r", end="", flush=True)


def report_on(
    chapter: Chapter,
    exercise: Exercise | None,
    folders: list[Path],
    given: list[Chapter],
    run: Callable[..., list[Verdict]],
    show: Show,
) -> ChapterResults:
    """Run the checks of a chapter, or of one exercise and its prerequisites, on a student's code.

    A check that fails only because of a mistake in an earlier chapter is reported as inherited.
    """
    wanted = with_needs(chapter, [exercise.id] if exercise else None)
    below = below_and_not_given(chapter, given)
    progress = partial(show, f"chapter {chapter.number}")
    first = run(chapter, folders, exercises=wanted, on_verdict=progress)
    try:
        again = run_on_given(chapter, first, folders, below, partial(run, exercises=wanted))
    except GraderError:  # use the first run alone
        again = []
    verdicts = explained_on_given(mark_inherited(first, again), again)
    results, better = (
        [result for result in results_of(chapter, outcome) if result.exercise.id in wanted]
        for outcome in (verdicts, again)
    )
    if again:
        return ChapterResults(chapter, results, better, [])
    return ChapterResults(chapter, results, [], suspects(first, folders, below, run))


class Memory:
    """Runs checks on a student's code, and caches the results until the student changes a file."""

    def __init__(self, seed: str, run: Callable[..., list[Verdict]] = run_checks) -> None:
        self.seed = seed
        self.run = run
        self.known: dict[tuple[str, ...], list[Verdict]] = {}

    def __call__(
        self,
        chapter: Chapter,
        engine: list[Path],
        *,
        exercises: list[str] | None = None,
        on_verdict: Callable[[int, int], None] | None = None,
    ) -> list[Verdict]:
        wanted = with_needs(chapter, exercises)
        state = state_of(engine, chapter)
        for ids in (with_needs(chapter, None), wanted):
            if known := self.known.get((state, *ids)):
                return [verdict for verdict in known if verdict.exercise in wanted]
        verdicts = self.run(
            chapter, engine, seed=self.seed, exercises=wanted, on_verdict=on_verdict
        )
        if state_of(engine, chapter) == state:  # otherwise it is unclear which files were checked
            self.known[(state, *wanted)] = verdicts
        return verdicts


def state_of(engine: list[Path], chapter: Chapter) -> str:
    """Compute a hash of all the student's files that can affect the checks of a chapter."""
    state = hashlib.sha256()
    for number, folder in enumerate(engine):
        for file in sorted(folder.glob("ch??_*/*.*")):
            name = file.parent.name
            if name <= chapter.name and file.suffix in (".py", ".csv", ".md"):
                try:
                    content = hashlib.sha256(file.read_bytes()).hexdigest()
                except OSError:  # it was just deleted, or is an editor's dangling link
                    continue
                state.update(f"{number} {name}/{file.name} {content}\n".encode())
    return f"{chapter.name} {state.hexdigest()}"
