"""Check a student's chapter or exercise in the browser, as `make check` does in a terminal."""

from __future__ import annotations

import time
from functools import partial
from pathlib import Path
from typing import Any

from autograder.checks.runner import run_checks
from autograder.checks.verdict import Verdict
from autograder.diagnosis.earlier_chapters import with_given
from autograder.manifest import Chapter, Exercise, load_chapters
from autograder.message import Kind
from autograder.scores import results_of
from autograder.student.chapter_results import ChapterResults, Memory, report_on
from autograder.student.failure import failure_of
from autograder.student.screen import first_open
from web.python.browser.folder import CHAPTERS, Folder
from web.python.browser.page import post
from web.python.browser.past import Processes
from web.python.browser.report import failure_to_page, report_of_written, report_to_page

PERIOD = 0.1  # s between two reports of progress
memories: dict[str, Memory] = {}  # the results of earlier chapters' checks, keyed by seed


class Progress:
    """The progress bar that the page shows while checks run, updated about ten times per second."""

    def __init__(self, processes: Processes) -> None:
        self.processes = processes
        self.next = 0.0  # earliest time of the next report in seconds

    def show(self, _: str, done: int, of: int) -> None:
        """Send the number of finished checks, unless the past of another worker is replayed."""
        if self.processes.is_live and (done == of or time.monotonic() >= self.next):
            post("progress", done=done, of=of)
            self.next = time.monotonic() + PERIOD


class Runs:
    """Runs the checks for a report, and sends the first failure before other chapters are checked.

    The results of other chapters are remembered. After an endless loop, other chapters are not
    checked, because they would run into the same loop.
    """

    def __init__(
        self, chapter: Chapter, exercise: Exercise | None, seed: str, processes: Processes
    ) -> None:
        self.chapter = chapter
        self.exercise = exercise
        self.run = partial(run_checks, process=processes.run)
        self.seed = seed
        self.memory = memories.setdefault(seed, Memory(seed))
        self.memory.run = self.run
        self.found: list[Verdict] = []  # in the chapter that the page asked for
        self.shown = False

    def __call__(self, chapter: Chapter, engine: list[Path], **options: Any) -> list[Verdict]:
        """Return a verdict for each check of a chapter. A report calls this like ``run_checks``."""
        if chapter == self.chapter:
            self.found = self.run(chapter, engine, seed=self.seed, **options)
            return self.found
        if any(verdict.message.kind is Kind.HUNG for verdict in self.found):
            return []
        if not self.shown:
            self.show(engine)
        return self.memory(chapter, engine, **options)

    def show(self, engine: list[Path]) -> None:
        """Send the first failure to the page before any checks of other chapters are run."""
        self.shown = True
        wanted = {verdict.exercise for verdict in self.found}
        results = [r for r in results_of(self.chapter, self.found) if r.exercise.id in wanted]
        first = first_open([ChapterResults(self.chapter, results, [], [])], self.exercise)
        failure = failure_of(*first, engine) if first else None
        if failure:
            post("trouble", failure=failure_to_page(failure))


def check(request: dict[str, Any], folder: Folder) -> dict[str, Any]:
    """Run the checks that a student requested. Raise ValueError if the request is not valid."""
    chapters = load_chapters()
    chapter = _chapter(chapters, request["chapter"])
    exercise = chapter.exercise(request["exercise"]) if request["exercise"] else None
    given = [other for other in chapters if other.number in request["given"]]
    if chapter in given:
        raise ValueError(f"nothing of yours is left to check: chapter {chapter.number} is given")
    folder.lay(request["files"])
    engine = [CHAPTERS]
    if exercise and exercise.kind == "written":
        return report_of_written(chapter, exercise, engine)
    processes = Processes(request["past"], shallow=request.get("shallow", False))
    runs = Runs(chapter, exercise, request["seed"], processes)
    with with_given(given, engine) as folders:
        report = report_on(chapter, exercise, folders, given, runs, Progress(processes).show)
    return report_to_page(report, exercise, engine, given)


def _chapter(chapters: list[Chapter], name: str) -> Chapter:
    """Return the chapter with this name, or raise ValueError if there is none."""
    for chapter in chapters:
        if chapter.name == name:
            return chapter
    raise ValueError(f"there is no chapter {name!r}")
