"""Compare a student's solutions that passed with the reference, function by function."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from autograder.clean import clean
from autograder.manifest import Chapter, Exercise
from autograder.release.counts import Counts, count
from autograder.similarity.code import Function, read_functions
from autograder.similarity.compare import Passage
from autograder.similarity.pages import pieces_of

Texts = Mapping[str, str]  # of the modules of one chapter, keyed by file, such as vector.py
OUTSIDE = ""  # the name of the code that is in no function


@dataclass(frozen=True)
class Code:
    """The body of a function: its text without the first indentation, and its counts."""

    text: str
    counts: Counts


@dataclass(frozen=True)
class Pair:
    """A function of the student and of the reference. Either is None if it has no such function."""

    name: str
    own: Code | None
    reference: Code | None


@dataclass(frozen=True)
class Compared:
    """An exercise or the other functions of a module, function by function."""

    title: str
    pairs: list[Pair]


def compare_exercise(exercise: Exercise, own: Texts, reference: Texts) -> Compared:
    """Compare the functions of one exercise."""
    pairs = []
    for edit in exercise.edit:
        module, name = edit.split(".", 1)
        sides = [_codes(f"{module}.py", texts).get(name) for texts in (own, reference)]
        pairs.append(Pair(name, *sides))
    return Compared(f"{exercise.id} {exercise.title}", pairs)


def compare_others(
    chapter: Chapter, files: Iterable[str], own: Texts, reference: Texts
) -> list[Compared]:
    """Compare the functions that belong to no exercise, such as helpers, for each of these modules.

    Functions that are the same in both, such as given ones, are left out. So is code outside of
    functions.
    """
    edited = {name for exercise in chapter.exercises for name in exercise.edit}
    found = []
    for file in files:
        mine, theirs = _codes(file, own), _codes(file, reference)
        module = file.removesuffix(".py")
        names = [
            name
            for name in dict.fromkeys([*mine, *theirs])
            if name != OUTSIDE
            and f"{module}.{name}" not in edited
            and mine.get(name) != theirs.get(name)
        ]
        if names:
            pairs = [Pair(clean(name), mine.get(name), theirs.get(name)) for name in names]
            found.append(Compared(f"Other functions in {file}", pairs))
    return found


def _codes(file: str, texts: Texts) -> dict[str, Code]:
    """Return the functions of a module, leaving out any part that cannot be read."""
    text = texts.get(file, "")
    return {one.name: _code(file, text, one) for one in read_functions(text)[0]}


def _code(file: str, text: str, function: Function) -> Code:
    passage = Passage(file, function.name, function.tokens, text)
    body = "".join(piece.text for piece in pieces_of(passage, {}))
    return Code(body.rstrip("\n"), count(function))
