"""Check a chapter or an exercise for the page, by the same steps as make check."""

from __future__ import annotations

from functools import partial
from typing import Any

from autograder.checks.given import with_given
from autograder.checks.runner import run_checks
from autograder.manifest import Chapter, load_chapters
from autograder.student.check import report_on
from autograder.student.screen import ProgressBar
from web.python.browser.folder import CHAPTERS, Folder
from web.python.browser.page import post
from web.python.browser.past import Processes
from web.python.browser.report import report_of_written, report_to_page


class Progress(ProgressBar):
    """Tells the page how many checks are done."""

    def __init__(self, processes: Processes) -> None:
        self.processes = processes

    def show(self, done: int, of: int) -> None:
        """Tell the page, unless it has been told by a worker before this one."""
        if self.processes.is_live:
            post("progress", done=done, of=of)


def check(request: dict[str, Any], folder: Folder) -> dict[str, Any]:
    """Return the report on what the page asks for. Raises ValueError and GraderError."""
    chapters = load_chapters()
    chapter = _chapter(chapters, request["chapter"])
    exercise = chapter.exercise(request["exercise"]) if request["exercise"] else None
    given = [other for other in chapters if other.number in request["given"]]
    if chapter in given:
        raise ValueError(f"nothing is left of your own: chapter {chapter.number} is given")
    folder.lay(request["files"])
    engine = [CHAPTERS]
    if exercise and exercise.kind == "written":
        return report_of_written(chapter, exercise, engine)
    processes = Processes(request["past"], shallow=request.get("shallow", False))
    run = partial(run_checks, seed=request["seed"], judge=processes.judge)
    with with_given(given, engine) as folders:
        report = report_on(chapter, exercise, folders, given, run, Progress(processes))
    return report_to_page(report, exercise, engine, given)


def _chapter(chapters: list[Chapter], name: str) -> Chapter:
    """Return the chapter of that name. Raises ValueError where there is none."""
    for chapter in chapters:
        if chapter.name == name:
            return chapter
    raise ValueError(f"there is no chapter {name!r}")
