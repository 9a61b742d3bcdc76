"""Collect the written answers of a class, from submissions that are copied as for grading."""

from __future__ import annotations

import hashlib
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from autograder.answers import FILE, Question, model_answer, questions_of
from autograder.manifest import ROOT, Chapter, Exercise
from autograder.student.written import flowing
from autograder.submissions.find import Submission
from autograder.submissions.stage import stage
from autograder.text.clean import clean

LONGEST = 20_000  # the page shows at most this many characters of an answer


@dataclass(frozen=True)
class Answer:
    """One student's answer to a written question, as shown on the marking page."""

    submission: Submission
    code: str  # shown in place of the name, so that the name cannot influence the mark
    text: str  # the whole file answers.md if something is wrong with it
    note: str  # what is wrong with the file answers.md, if anything
    hash: str  # of the whole answer, which shows whether the student has changed it


@dataclass(frozen=True)
class Task:
    """A written question to mark, with its model answer, its rubric and the students' answers."""

    exercise: Exercise
    question: str
    model: str
    rubric: str
    answers: list[Answer]


def collect_tasks(
    submissions: list[Submission], chapters: list[Chapter], root: Path = ROOT
) -> list[Task]:
    """Collect the written questions with every student's answer, sorted by code, missing last."""
    answers: dict[str, list[Answer]] = {}
    for submission in submissions:
        for exercise_id, answer in _answers_of(submission, chapters, root):
            answers.setdefault(exercise_id, []).append(answer)
    tasks = []
    for chapter in chapters:
        for exercise in _written(chapter):
            model = model_answer(chapter, exercise, root)
            if model is None:
                raise ValueError(f"there is no model answer for {exercise.id} in solutions/")
            own = sorted(answers.get(exercise.id, []), key=lambda a: (not a.text, a.code))
            question, text, rubric = map(flowing, (model.question, model.answer, model.rubric))
            tasks.append(Task(exercise, question, text, rubric, own))
    return tasks


def answer_hashes(
    submission: Submission, chapters: list[Chapter], root: Path = ROOT
) -> dict[str, str]:
    """Return a hash of each written answer, which shows whether the student has changed it."""
    return {name: answer.hash for name, answer in _answers_of(submission, chapters, root)}


def _answers_of(
    submission: Submission, chapters: list[Chapter], root: Path
) -> Iterator[tuple[str, Answer]]:
    """Yield one student's answer to each question. The text of a missing answer is empty."""
    # Students' code is left out, because an instructor marks only the written answers.
    wanted = [
        replace(chapter, complete=[], exercises=[replace(written[0], edit=[], files=[FILE])])
        for chapter in chapters
        if (written := _written(chapter))
    ]
    with tempfile.TemporaryDirectory(prefix="marking-") as folder:
        staged = stage(submission.path, wanted, Path(folder), root)
        for chapter in chapters:
            refused = staged.rejected.get(f"{chapter.name}.{FILE}", "")
            for question in questions_of(chapter, [Path(folder)]):
                name = question.exercise.id
                text, note = _text_of(question, Path(folder) / chapter.name / FILE)
                code = hash_of(f"{name}\0{submission.student}")
                yield name, Answer(submission, code, _shown(text), refused or note, hash_of(text))


def _text_of(question: Question, file: Path) -> tuple[str, str]:
    """Return a student's answer, or the whole file and a note if a heading is missing or twice."""
    if not file.exists():
        return "", ""
    if question.problems:
        note = question.problems[0].replace(str(question.file), FILE)
        return file.read_text(encoding="utf-8-sig"), f"This is the whole file. {note}"
    if (section := question.section) is None:
        return "", ""
    lines = section.answer.splitlines()
    return "\n".join(line for line in lines if line.strip() not in section.places), ""


def _written(chapter: Chapter) -> list[Exercise]:
    return [exercise for exercise in chapter.exercises if exercise.kind == "written"]


def hash_of(text: str) -> str:
    """Return a short hash, such as that of a written answer."""
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()[:16]


def _shown(text: str) -> str:
    if len(text) > LONGEST:
        text = f"{text[:LONGEST]}\n\n... and {len(text) - LONGEST} characters more"
    return flowing(clean(text)).strip()
