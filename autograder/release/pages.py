"""Write the page that shows a student's functions next to those of the reference solution.

Only exercises that the student has passed are compared.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from textwrap import dedent

from autograder.manifest import Chapter, Exercise
from autograder.reports.pages import render
from autograder.reports.texts import replace_file
from autograder.similarity.code import read_functions
from autograder.similarity.compare import Passage
from autograder.submissions.find import file_name
from autograder.text.clean import clean

TEMPLATES = Path(__file__).parent / "templates"
Texts = Mapping[str, str]  # the text of each module in a chapter, by file name


@dataclass(frozen=True)
class Pair:
    """A student's version of a function and ours, each None if there is no such function."""

    name: str
    own: str | None
    reference: str | None


@dataclass(frozen=True)
class Compared:
    """The functions of one exercise, or those in one file that belong to no exercise."""

    title: str
    pairs: list[Pair]


def compare_exercise(exercise: Exercise, own: Texts, reference: Texts) -> Compared:
    """Pair a student's functions for one exercise with those in the reference solution."""
    pairs = []
    for edit in exercise.edit:
        module, name = edit.split(".", 1)
        sides = [_functions(f"{module}.py", texts).get(name) for texts in (own, reference)]
        pairs.append(Pair(name, *sides))
    return Compared(f"{exercise.id} {exercise.title}", pairs)


def compare_others(
    chapter: Chapter, files: Iterable[str], own: Texts, reference: Texts
) -> list[Compared]:
    """Pair the functions that belong to no exercise, such as a student's helpers.

    Functions that are the same in both versions are left out, because students may have received
    them from us. Code outside functions is left out too.
    """
    edited = {name for exercise in chapter.exercises for name in exercise.edit}
    found = []
    for file in files:
        mine, theirs = _functions(file, own), _functions(file, reference)
        module = file.removesuffix(".py")
        pairs = [
            Pair(clean(name), mine.get(name), theirs.get(name))
            for name in dict.fromkeys([*mine, *theirs])
            if name and f"{module}.{name}" not in edited and mine.get(name) != theirs.get(name)
        ]
        if pairs:
            found.append(Compared(f"Other functions in {file}", pairs))
    return found


def write_page(
    out: Path, student: str, compared: Sequence[Compared], not_compared: Sequence[str]
) -> Path:
    """Write students/<student>.html, and return its path.

    It also lists the released exercises that the student has not solved.
    """
    path = out / "students" / f"{file_name(student)}.html"
    values = {"student": clean(student), "compared": compared, "not_compared": not_compared}
    replace_file(path, render("release.html", TEMPLATES, **values))
    return path


def _functions(file: str, texts: Texts) -> dict[str, str]:
    """Return the body of each function in a module, by names such as Particle.mass."""
    text = texts.get(file, "")
    passages = [Passage(file, one.name, one.tokens, text) for one in read_functions(text)[0]]
    return {one.name: clean(dedent("\n".join(one.lines))).rstrip() for one in passages}
