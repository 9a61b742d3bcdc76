"""Read a student's written answers from answers.md, and our model answers from solutions/.

Each question has its own section in answers.md, with a heading, the question as a block quote, and
the answer. The copies of answers.md in solutions/ contain our model answers. Each model answer is
followed by a rubric, which lists what an answer must contain to earn points.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from difflib import SequenceMatcher
from itertools import pairwise
from pathlib import Path

from autograder.accepted_files import (
    LARGEST_FILE,
    NotTakenError,
    check_text,
    read_file,
    rejection,
)
from autograder.manifest import ROOT, Chapter, Exercise

PLACE = "_Write your answer here._"
RUBRIC = "**Rubric**"
FILE = "answers.md"
WORD = re.compile(r"[^\W\d_]{2,}")
ENOUGH = 2  # a text with fewer words does not count as an answer


@dataclass(frozen=True)
class Section:
    """One section of an answers.md file, with a question about the chapter and the answer to it.

    Attributes:
        rubric: How to mark the answer. It is empty in a student's file, because only our own copy
            has rubrics.
        line: The number of the line where the answer begins, or should begin.
    """

    id: str
    heading: str
    question: str
    answer: str
    rubric: str
    line: int

    @property
    def places(self) -> list[str]:
        """The lines of the answer that still contain the placeholder "_Write your answer here._".

        A line counts as a placeholder even if the student has changed a few letters of it by
        accident.
        """
        return [line.strip() for line in self.answer.splitlines() if _is_place(line)]

    @property
    def has_words(self) -> bool:
        """True if the student has written an answer of at least two words.

        The words of a placeholder that the student forgot to delete do not count.
        """
        return self.words >= ENOUGH

    @property
    def words(self) -> int:
        """The number of words in the student's answer.

        Placeholder lines, headings, quotations and HTML comments do not count.
        """
        text = re.sub(r"<!--.*?(-->|\Z)", "", self.answer, flags=re.DOTALL)
        lines = [line for line in text.splitlines() if not (line[:1] in "#>" or _is_place(line))]
        return len(WORD.findall(" ".join(lines)))


@dataclass(frozen=True)
class Question:
    """An exercise that asks for a written answer, together with the student's answer.

    Attributes:
        section: The student's section in answers.md, or None if it cannot be found.
        problems: What is wrong with that section, such as a duplicate heading.
    """

    exercise: Exercise
    file: Path
    section: Section | None
    problems: list[str]

    @property
    def answered(self) -> bool:
        """True if the student has written an answer that can be marked.

        Such an answer has at least two words, and its section of answers.md has no problems.
        """
        return self.section is not None and self.section.has_words and not self.problems

    @property
    def place(self) -> str:
        """The file and line where the student writes the answer, such as answers.md:12.

        The line is left out if answers.md has no section for the question.
        """
        return f"{self.file}:{self.section.line}" if self.section else str(self.file)


def blank_answers(text: str) -> str:
    """Remove the model answers from our answers.md, to make the file that students receive.

    The questions remain. Each model answer is replaced by "_Write your answer here._", and its
    rubric is removed.
    """
    title = text.partition("\n")[0]
    parts = [title]
    for section in sections_of(text):
        parts += [section.heading, section.question, PLACE]
    return "\n\n".join(parts) + "\n"


def sections_of(text: str, ids: Iterable[str] = ()) -> list[Section]:
    """Split the text of an answers.md file into one section per question.

    A section begins at a level-two heading (##). Students sometimes delete a # or the space after
    it by accident. For this reason, any other heading also begins a section if its first word is
    one of the exercise ids in ``ids``.
    """
    known = {*ids}
    lines = text.splitlines()
    starts = [i for i, line in enumerate(lines) if _begins(line, known)]
    return [_section(lines, start, end) for start, end in pairwise([*starts, len(lines)])]


def questions_of(chapter: Chapter, engine: list[Path]) -> list[Question]:
    """List the written exercises of a chapter, each with the student's answer from answers.md.

    ``engine`` lists the folders to search. The answers come from the first of them that contains
    an answers.md file for this chapter.
    """
    exercises = [exercise for exercise in chapter.exercises if exercise.kind == "written"]
    if not exercises:
        return []
    ids = [exercise.id for exercise in exercises]
    files = [folder / chapter.name / FILE for folder in engine]
    file = next((file for file in files if file.is_file()), files[0])
    sections: dict[str, list[Section]] = {exercise_id: [] for exercise_id in ids}
    strangers: dict[str, list[Section]] = {"": []}  # keyed by the preceding question
    last = ""
    rejected = ""
    if file.is_file():
        try:
            text = check_text(read_file(file, LARGEST_FILE)).decode("utf-8-sig")
        except NotTakenError as error:
            text, rejected = "", rejection(chapter.name, FILE, error)
        for section in sections_of(text, ids):
            if section.id in ids:
                last = section.id
                sections[last].append(section)
            else:
                strangers.setdefault(last, []).append(section)
    file = file.relative_to(Path.cwd()) if file.is_relative_to(Path.cwd()) else file
    questions = []
    for exercise in exercises:
        own = sections[exercise.id]
        after = strangers.get(exercise.id, []) if all(sections.values()) else []
        maybe = after if own else [section for group in strangers.values() for section in group]
        problems = [rejected] if rejected else _problems(exercise, own, maybe, file)
        questions.append(Question(exercise, file, own[0] if own else None, problems))
    return questions


def model_answer(chapter: Chapter, exercise: Exercise, root: Path = ROOT) -> Section | None:
    """Return our model answer to a written exercise, together with the rubric for marking it.

    In a handout the result is None, because students do not receive the model answers.
    """
    file = root / "solutions" / chapter.name / FILE
    if not file.is_file():
        return None
    sections = sections_of(file.read_text(encoding="utf-8"))
    return next((section for section in sections if section.id == exercise.id), None)


def _section(lines: list[str], start: int, end: int) -> Section:
    """Parse one section of an answers.md file into its heading, question, answer and rubric.

    The heading is on line ``start``, and the next section begins on line ``end``.
    """
    heading = lines[start]
    first = start + 1
    while first < end and not lines[first].strip():
        first += 1
    after = first
    while after < end and lines[after].startswith(">"):
        after += 1
    question = "\n".join(lines[first:after])
    while after < end and not lines[after].strip():
        after += 1
    answer, _, rubric = "\n".join(lines[after:end]).partition(f"\n{RUBRIC}\n")
    line = min(after, end - 1) + 1
    return Section(_first_word(heading), heading, question, answer.strip(), rubric.strip(), line)


def _begins(line: str, ids: set[str]) -> bool:
    return line.startswith("## ") or (line.startswith("#") and _first_word(line) in ids)


def _first_word(heading: str) -> str:
    return next(iter(heading.lstrip("# ").split()), "").rstrip(".:")


def _is_place(line: str) -> bool:
    """Return True if a line of answers.md is the placeholder, even with a few letters changed."""
    words, wanted = (" ".join(re.findall(r"\w+", text)) for text in (line.lower(), PLACE.lower()))
    return SequenceMatcher(None, words.strip("_"), wanted.strip("_")).ratio() > 0.8


def _problems(
    exercise: Exercise, own: list[Section], strangers: list[Section], file: Path
) -> list[str]:
    """List what a student must fix in answers.md before one of the answers can be marked.

    Each problem is a sentence addressed to the student. ``own`` contains the sections whose heading
    begins with the id of the exercise. There should be exactly one of them. ``strangers`` contains
    sections that match no exercise, which can happen if the student has changed a heading.
    """
    heading = f"## {exercise.id}"
    if not file.is_file():
        return [f"{file} is missing. Create it again, with the line '{heading}' above your answer."]
    if not own:
        words = f"No heading in {file} begins with '{heading}'. Put that line above your answer."
        if strangers:
            there = ", ".join(repr(section.heading) for section in strangers)
            words += f" Did you change it to {there}?"
        return [words]
    if len(own) > 1:
        lines = " and ".join(str(section.line) for section in own)
        return [f"The heading '{heading}' appears twice in {file} (lines {lines}). Keep only one."]
    if own[0].has_words and own[0].places:
        return [f"The line '{own[0].places[0]}' is still in {file}. Delete it."]
    if strangers and not own[0].has_words:
        there = strangers[0].heading
        return [f"'{there}' in {file} is not a question. Start headings of your own with ###."]
    return []
