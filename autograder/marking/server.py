"""The local web server behind the marking page, on which an instructor marks written answers."""

from __future__ import annotations

import asyncio
import webbrowser
from pathlib import Path
from typing import Any

from tornado.escape import json_decode
from tornado.web import Application

from autograder.local_server import Files, Handler, Site, is_own_page
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.marking.answers import Task, collect_tasks
from autograder.marking.marked_answers import MarkedAnswers
from autograder.marking.marks_file import ChangedError, MarksFile
from autograder.reports.marks import Mark, read_marks
from autograder.reports.texts import LONGEST
from autograder.submissions.class_list import read_class

PAGE = Path(__file__).parent / "page"
LOOK = Path(__file__).parent.parent / "reports" / "templates"


class Marking(Site):
    """The data behind the marking page: the students' written answers and their marks.

    All request handlers of the server share this object.
    """

    def __init__(self, tasks: list[Task], marks: MarksFile, folder: Path) -> None:
        super().__init__()
        self.folder = folder
        self.tasks = {task.exercise.id: task for task in tasks}
        self.marks = marks
        self.answers = {
            (task.exercise.id, answer.code): answer for task in tasks for answer in task.answers
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
        """Read the marks from marks.csv, and group them by exercise and by student.

        For example, ``known()["2.2b"]`` is a dict of all marks for exercise 2.2b. Its keys are the
        codes that the marking page shows instead of students' names.
        """
        marks, marked = self.marks.read(), self.marked()
        found: dict[str, dict[str, Any]] = {name: {} for name in self.tasks}
        for (exercise, code), answer in self.answers.items():
            if mark := marks.get((answer.submission.student, exercise)):
                owner = answer.submission.owner
                changed = marked.is_changed(owner, exercise, mark, answer.hash)
                found[exercise][code] = {**vars(mark), "changed": changed}
        marked.save()
        return found

    def marked(self) -> MarkedAnswers:
        """Read which answers the marks are for. Others may be marking at the same time."""
        return MarkedAnswers(self.folder)


class Questions(Handler):
    """Handles requests for the written questions and the students' answers to them.

    The questions and answers do not change while the server runs.
    """

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
            for task in self.site.tasks.values()
        ]
        self.write({"questions": questions})


class Marks(Handler):
    """Handles requests to read or change the marks for written answers.

    A request to change a mark includes the old mark that the marking page displayed. If somebody
    has changed the mark in the file since then, the request is refused. In this way, nobody
    overwrites a mark without having seen it.
    """

    site: Marking

    def prepare(self) -> None:
        super().prepare()
        if self.request.method != "POST":
            return
        if not is_own_page(self.request, self.request.headers.get("Origin", "")):
            self.send_error(403)
        elif not self.request.headers.get("Content-Type", "").startswith("application/json"):
            self.send_error(415)

    def get(self) -> None:
        self.answer()

    def post(self) -> None:
        try:
            asked = json_decode(self.request.body)
            exercise, code = str(asked["exercise"]), str(asked["code"])
            answer = self.site.answers[exercise, code]
            points = self.site.tasks[exercise].exercise.points
            mark, seen = mark_of(asked["mark"], points), mark_of(asked["seen"], points)
        except (ValueError, KeyError, TypeError, RecursionError) as error:
            self.refuse(400, f"this is not a valid mark: {error}")
            return
        try:
            self.site.marks.change(answer.submission.student, exercise, mark, seen)
            if mark:
                self.site.marked().mark_now(answer.submission.owner, exercise, mark, answer.hash)
        except ChangedError:
            self.answer(409, why="This mark has been changed on another page in the meantime.")
            return
        except (ValueError, OSError) as error:
            self.refuse(503, str(error))
            return
        self.answer()

    def answer(self, status: int = 200, **more: str) -> None:
        """Send the current marks of all answers to the marking page.

        They are read from marks.csv again, so they include marks entered on another marking page.
        """
        try:
            known = self.site.known()
        except (ValueError, OSError) as error:
            self.refuse(503, str(error))
            return
        self.set_status(status)
        self.write({"marks": known, **more})

    def refuse(self, status: int, why: str) -> None:
        """Send the marking page an error response that explains why its request failed."""
        self.set_status(status)
        self.write({"why": why})


def mark_of(value: Any, most: float) -> Mark | None:
    """Validate a mark that the marking page sent, and return it.

    Return None if the page sent no mark, for example because an instructor has deleted it. ``most``
    is the maximum number of points for the answer.

    Raises:
        ValueError: The data is not a valid mark.
    """
    if value is None:
        return None
    points, comment = value["points"], value["comment"]
    if isinstance(points, bool) or not isinstance(points, (int, float)) or not 0 <= points <= most:
        raise ValueError(f"points must be a number from 0 to {most}")
    if not isinstance(comment, str) or len(comment) > LONGEST:
        raise ValueError(f"a comment must be a text of at most {LONGEST} characters")
    return Mark(float(points), comment)


def mark(
    folder: Path,
    chapters: list[Chapter],
    *,
    roster: Path | None = None,
    browser: bool = True,
    root: Path = ROOT,
) -> int:
    """Serve the page for marking a class's written answers until the instructor presses Ctrl-C.

    The marks are saved in marks.csv. The page shows only questions that belong to the exercises in
    ``chapters``, which may be those of a single assignment. With a roster, marks.csv has the names
    that the gradebook has.

    Raises:
        ValueError: There is nothing to mark, or marks.csv contains a mistake.
    """
    people = read_class(folder, roster)
    submissions = [one for one in people.submissions if not one.nothing]
    whole = {chapter.name: chapter for chapter in load_chapters(root)}
    asked = {exercise.id for chapter in chapters for exercise in chapter.exercises}
    tasks = collect_tasks(submissions, [whole[chapter.name] for chapter in chapters], root)
    tasks = [task for task in tasks if task.exercise.id in asked]
    if not tasks:
        raise ValueError("there are no written exercises to mark")
    marks = MarksFile(folder / "marks.csv", load_chapters(root), people)
    _, unused = read_marks(marks.path, marks.chapters, people)
    site = Marking(tasks, marks, folder)
    for note in [*people.notes, *unused]:
        print(note)

    async def serve() -> None:
        site.listen(site.application())
        print(f"The answers are at {site.address}")
        print(f"Marks are saved in {marks.path}. Press Ctrl-C to stop.", flush=True)
        if browser:
            webbrowser.open(site.address)
        await asyncio.Event().wait()

    try:
        asyncio.run(serve())
    except KeyboardInterrupt:
        print("\nRun make grade again to add the marks to the reports.")
    return 0
