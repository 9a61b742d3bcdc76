"""Remember the results of checks, so that `watch` runs them again only if a file has changed."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from pathlib import Path

from autograder.checks.runner import run_checks
from autograder.checks.verdict import Verdict, with_needs
from autograder.manifest import Chapter


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
        """Return the results of a chapter's checks, or of some exercises and what they need."""
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
