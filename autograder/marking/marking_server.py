"""The local web server behind the marking page, on which an instructor marks written answers."""

from __future__ import annotations

import asyncio
import webbrowser
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
from tornado.web import Application

from autograder.local_server import Files, Handler, Site, is_own_page
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.marking.answers import Task, collect_tasks
from autograder.marking.marked_answers import MarkedAnswers
from autograder.marking.marks_file import ChangedError, change_mark
from autograder.reports.marks import Mark, read_marks
from autograder.reports.texts import LONGEST
from autograder.submissions.class_list import ClassList, read_class

PAGE = Path(__file__).parent / "page"
LOOK = Path(__file__).parent.parent / "reports" / "templates"


@dataclass(frozen=True)
class Change:
    """A new mark for an answer, with the old mark that the marking page displayed."""

    exercise: str
    code: str
    mark: Mark | None
    seen: Mark | None


class Marking(Site):
    """What all request handlers share: the students' written answers and the file of marks."""

    def __init__(
        self, tasks: list[Task], folder: Path, chapters: list[Chapter], people: ClassList
    ) -> None:
        super().__init__()
        self.tasks = tasks
        self.folder = folder
        self.file = folder / "marks.csv", chapters, people  # what is needed to read the marks
        self.answers = {
            (task.exercise.id, answer.code): (task.exercise, answer)
            for task in tasks
            for answer in task.answers
        }

    def application(self) -> Application:
        """Build the web application that serves the marking page, the answers and the marks."""
        below, shared = f"/{self.token}", {"site": self}
        return Application(
            [
                (f"{below}/questions.json", Questions, shared),
                (f"{below}/marks.json", Marks, shared),
                (rf"{below}/look/(style\.css)", Files, {**shared, "path": str(LOOK)}),
                (f"{below}/(.*)", Files, {**shared, "path": str(PAGE)}),
            ]
        )

    def known(self) -> dict[str, dict[str, Any]]:
        """Read the marks from marks.csv, and group them by exercise and by the answers' codes."""
        marks, marked = read_marks(*self.file)[0], MarkedAnswers(self.folder)
        found: dict[str, dict[str, Any]] = {task.exercise.id: {} for task in self.tasks}
        for (exercise, code), (_, answer) in self.answers.items():
            who = answer.submission
            if mark := marks.get((who.student, exercise)):
                changed = marked.is_changed(who.owner, exercise, mark, answer.hash)
                found[exercise][code] = {**vars(mark), "changed": changed}
        marked.save()
        return found

    def change(self, change: Change) -> None:
        """Write a new mark into marks.csv, and remember the answer that it was given for."""
        exercise, answer = self.answers[change.exercise, change.code]
        who, mark = answer.submission, change.mark
        change_mark(*self.file, (who.student, exercise.id), mark, change.seen)
        if mark:
            MarkedAnswers(self.folder).mark_now(who.owner, exercise.id, mark, answer.hash)


class Questions(Handler):
    """Handles requests for the written questions and the students' answers to them."""

    site: Marking

    def get(self) -> None:
        questions = [
            {
                "id": task.exercise.id,
                "title": task.exercise.title,
                "points": task.exercise.points,
                "question": task.question,
                "model": task.model,
                "rubric": task.rubric,
                "answers": [
                    {"code": answer.code, "text": answer.text, "note": answer.note}
                    for answer in task.answers
                ],
            }
            for task in self.site.tasks
        ]
        self.write({"questions": questions})


class Marks(Handler):
    """Handles requests to read or change the marks for written answers."""

    site: Marking

    def prepare(self) -> None:
        super().prepare()
        if self.request.method != "POST":
            return
        if not is_own_page(self.request, self.request.headers.get("Origin", "")):
            self.send_error(403)
        elif not self.request.headers.get("Content-Type", "").startswith("application/json"):
            self.send_error(415)

    def get(self, change: Change | None = None) -> None:
        """Make a change, if there is one, and send the marks in marks.csv or why that failed."""
        why = ""
        try:
            try:
                if change:
                    self.site.change(change)
            except ChangedError as error:
                self.set_status(409)
                why = str(error)
            self.write({"marks": self.site.known(), "why": why})
        except (ValueError, OSError) as error:
            self.set_status(503)
            self.write({"why": str(error)})

    def post(self) -> None:
        try:
            change = msgspec.json.decode(self.request.body, type=Change)
            points = self.site.answers[change.exercise, change.code][0].points
            mark = change.mark
            if mark and not (0 <= mark.points <= points and len(mark.comment) <= LONGEST):
                limits = f"0 to {points:g} points and {LONGEST} characters"
                raise ValueError(f"it must be within {limits}")
        except (ValueError, KeyError, RecursionError) as error:
            self.set_status(400)
            self.write({"why": f"this is not a valid mark: {error}"})
        else:
            self.get(change)


def mark(
    folder: Path,
    chapters: list[Chapter],
    *,
    roster: Path | None = None,
    browser: bool = True,
    again: str = "make grade",
    root: Path = ROOT,
) -> int:
    """Serve the page for marking the exercises in ``chapters`` until the instructor presses Ctrl-C.

    ``again`` is the command that grades this class. A mistake in marks.csv is a ValueError, and so
    is a class with nothing to mark.
    """
    people = read_class(folder, roster)
    submissions = [one for one in people.submissions if not one.nothing]
    every = load_chapters(root)
    whole = {chapter.name: chapter for chapter in every}
    asked = {exercise.id for chapter in chapters for exercise in chapter.exercises}
    tasks = collect_tasks(submissions, [whole[chapter.name] for chapter in chapters], root)
    tasks = [task for task in tasks if task.exercise.id in asked]
    if not tasks:
        raise ValueError("there are no written exercises to mark")
    site = Marking(tasks, folder, every, people)
    _, unused = read_marks(*site.file)
    for note in [*people.notes, *unused]:
        print(note)

    async def serve() -> None:
        site.listen(site.application())
        print(f"The answers are at {site.address}")
        print(f"Marks are saved in {site.file[0].resolve()}. Press Ctrl-C to stop.", flush=True)
        if browser:
            webbrowser.open(site.address)
        await asyncio.Event().wait()

    try:
        asyncio.run(serve())
    except KeyboardInterrupt:
        print(f"\nTo add the marks to the reports, grade with the same options as before: {again}")
    return 0
