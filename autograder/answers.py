"""Read a student's written answers from answers.md, and our model answers from solutions/.

Each question has its own section in answers.md, with a heading, the question as a block quote, and
the answer. In solutions/, each model answer is followed by a rubric.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from autograder.accepted_files import (
    LARGEST_FILE,
    NotTakenError,
    check_text,
    read_file,
    rejection,
)
from autograder.files import from_here
from autograder.manifest import ROOT, Chapter, Exercise

PLACE = "_Write your answer here._"
RUBRIC = "**Rubric**"
FILE = "answers.md"
WORD = re.compile(r"[^\W\d_]{2,}")
ENOUGH = 2  # a text with fewer words does not count as an answer


@dataclass(frozen=True)
class Section:
    """One section of an answers.md file. The answer begins, or should begin, on line ``line``."""

    id: str
    heading: str
    question: str
    answer: str
    rubric: str
    line: int

    @property
    def places(self) -> list[str]:
        """The lines of the answer that are still the placeholder."""
        return [line for line in map(str.strip, self.answer.splitlines()) if line == PLACE]

    @property
    def has_words(self) -> bool:
        """True if the student has written an answer of at least two words."""
        return self.words >= ENOUGH

    @property
    def words(self) -> int:
        """The number of words, without the placeholder, headings, quotations and HTML comments."""
        text = re.sub(r"<!--.*?(-->|\Z)", "", self.answer, flags=re.DOTALL)
        lines = (line for line in text.splitlines() if line[:1] not in "#>")
        return sum(len(WORD.findall(line)) for line in lines if line.strip() != PLACE)


@dataclass(frozen=True)
class Question:
    """An exercise with a written answer, and the student's section for it, if it can be found."""

    exercise: Exercise
    file: Path
    section: Section | None
    problems: list[str]

    @property
    def answered(self) -> bool:
        """True if the student has written an answer that can be marked."""
        return self.section is not None and self.section.has_words and not self.problems

    @property
    def place(self) -> str:
        """The file and line where the student writes the answer, such as answers.md:12."""
        return f"{self.file}:{self.section.line}" if self.section else str(self.file)


def blank_answers(text: str) -> str:
    """Replace each model answer in our answers.md, with its rubric, by the placeholder."""
    parts = [text.partition("\n")[0]]
    for section in sections_of(text):
        parts += [section.heading, section.question, PLACE]
    return "\n\n".join(parts) + "\n"


def sections_of(text: str, ids: Iterable[str] = ()) -> list[Section]:
    """Split the text of an answers.md file into one section per level-two heading (##).

    So that a deleted # or space does no harm, any heading that begins with one of ``ids`` counts.
    """
    known = {*ids}
    lines = text.splitlines()
    starts = [
        at
        for at, line in enumerate(lines)
        if line.startswith("## ") or (line.startswith("#") and _first_word(line) in known)
    ]
    return [_section(lines, start, end) for start, end in pairwise([*starts, len(lines)])]


def questions_of(chapter: Chapter, engine: list[Path]) -> list[Question]:
    """List the written exercises of a chapter, each with the answer in the first answers.md."""
    exercises = [exercise for exercise in chapter.exercises if exercise.kind == "written"]
    ids = [exercise.id for exercise in exercises]
    files = [folder / chapter.name / FILE for folder in engine]
    file = next((file for file in files if file.is_file()), files[0])
    sections, rejected = [], ""
    if exercises and file.is_file():
        try:
            text = check_text(read_file(file, LARGEST_FILE)).decode("utf-8-sig")
            sections = sections_of(text, ids)
        except NotTakenError as error:
            rejected = rejection(chapter.name, FILE, error)
    questions = []
    for exercise in exercises:
        problem = rejected or _problem(exercise.id, ids, sections, from_here(file))
        problems = [problem] if problem else []
        own = _section_of(exercise, sections)
        questions.append(Question(exercise, from_here(file), own, problems))
    return questions


def model_answer(chapter: Chapter, exercise: Exercise, root: Path = ROOT) -> Section | None:
    """Return our model answer to a written exercise with its rubric, or None in a handout."""
    file = root / "solutions" / chapter.name / FILE
    if not file.is_file():
        return None
    return _section_of(exercise, sections_of(file.read_text(encoding="utf-8")))


def _section_of(exercise: Exercise, sections: list[Section]) -> Section | None:
    return next((section for section in sections if section.id == exercise.id), None)


def _section(lines: list[str], start: int, end: int) -> Section:
    """Parse the section with its heading on line ``start``. The next one begins on line ``end``."""

    def skip(start: int, pattern: str) -> int:
        others = (at for at in range(start, end) if not re.match(pattern, lines[at]))
        return next(others, end)

    heading = lines[start]
    first = skip(start + 1, r"\s*$")
    after = skip(first, ">")
    begin = skip(after, r"\s*$")
    question = "\n".join(lines[first:after])
    answer, _, rubric = "\n".join(lines[begin:end]).partition(f"\n{RUBRIC}\n")
    line = min(begin, end - 1) + 1
    return Section(_first_word(heading), heading, question, answer.strip(), rubric.strip(), line)


def _first_word(heading: str) -> str:
    return next(iter(heading.lstrip("# ").split()), "").rstrip(".:")


def _problem(exercise: str, ids: list[str], sections: list[Section], file: Path) -> str:
    """Say what a student must fix in answers.md before an answer can be marked, or return ""."""
    heading = f"## {exercise}"
    own = [at for at, section in enumerate(sections) if section.id == exercise]
    if not file.is_file():
        return f"{file} is missing. Create it again, with the line '{heading}' above your answer."
    if not own:
        words = f"No heading in {file} begins with '{heading}'. Put that line above your answer."
        there = ", ".join(repr(one.heading) for one in sections if one.id not in ids)
        return f"{words} Did you change it to {there}?" if there else words
    if len(own) > 1:
        lines = " and ".join(str(sections[at].line) for at in own)
        return f"The heading '{heading}' appears twice in {file} (lines {lines}). Keep only one."
    section, after = sections[own[0]], sections[own[0] + 1 : own[0] + 2]
    if section.has_words and section.places:
        return f"The line '{PLACE}' is still in {file}. Delete it."
    if after and after[0].id not in ids and not section.has_words:
        there = after[0].heading
        return f"'{there}' in {file} is not a question. Start headings of your own with ###."
    return ""
