"""Write the page that shows a student's functions next to those of the reference solution."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
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


def compare(
    chapter: Chapter, solved: Sequence[Exercise], own: Texts, reference: Texts
) -> list[Compared]:
    """Pair a student's functions for solved exercises of a chapter with those of the reference.

    Other functions in the same files follow, such as a student's helpers, unless both versions are
    the same, because students may have received them from us.
    """
    files = dict.fromkeys(f"{edit.split('.')[0]}.py" for e in solved for edit in e.edit)
    mine, theirs = ({f: _functions(f, texts) for f in files} for texts in (own, reference))
    compared = []
    for exercise in solved:
        places = [
            (f"{module}.py", name)
            for module, _, name in (edit.partition(".") for edit in exercise.edit)
        ]
        pairs = [Pair(name, mine[file].get(name), theirs[file].get(name)) for file, name in places]
        compared.append(Compared(f"{exercise.id} {exercise.title}", pairs))
    edited = {name for exercise in chapter.exercises for name in exercise.edit}
    for file in files:
        others = [
            Pair(clean(name), mine[file].get(name), theirs[file].get(name))
            for name in dict.fromkeys([*mine[file], *theirs[file]])
            if name and f"{file.removesuffix('.py')}.{name}" not in edited
        ]
        if others := [pair for pair in others if pair.own != pair.reference]:
            compared.append(Compared(f"Other functions in {file}", others))
    return compared


def write_page(
    out: Path, student: str, compared: Sequence[Compared], not_compared: Sequence[str]
) -> Path:
    """Write students/<student>.html, and return its path."""
    path = out / "students" / f"{file_name(student)}.html"
    values = {"student": clean(student), "compared": compared, "not_compared": not_compared}
    replace_file(path, render("release.html", TEMPLATES, **values))
    return path


def _functions(file: str, texts: Texts) -> dict[str, str]:
    """Return the body of each function in a module, by names such as Particle.mass."""
    text = texts.get(file, "")
    passages = [Passage(file, one.name, one.tokens, text) for one in read_functions(text)[0]]
    return {one.name: clean(dedent("\n".join(one.lines))).rstrip() for one in passages}
