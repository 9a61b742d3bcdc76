"""Pair each function that a student wrote with the same function in the reference solution.

Only exercises that the student has passed are compared.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from autograder.manifest import Chapter, Exercise
from autograder.release.counts import Counts, count
from autograder.similarity.code import Function, read_functions
from autograder.similarity.compare import Passage
from autograder.similarity.pages import pieces_of
from autograder.text.clean import clean

Texts = Mapping[str, str]  # the text of each module in a chapter, by file name
OUTSIDE = ""  # stands for code outside of functions


@dataclass(frozen=True)
class Code:
    """The body of a function, to be compared with another version of the function.

    Attributes:
        text: The code, without the indentation that all lines share.
        counts: The numbers of lines, calls and new objects in the code.
    """

    text: str
    counts: Counts


@dataclass(frozen=True)
class Pair:
    """Two versions of a function: the student's and the one in the reference solution.

    Attributes:
        name: The name of the function, such as "Particle.mass".
        own: The student's version, or None if the student has no such function.
        reference: Our version, or None if the reference solution has no such function.
    """

    name: str
    own: Code | None
    reference: Code | None


@dataclass(frozen=True)
class Compared:
    """A student's functions for one exercise, each paired with the one in the reference solution.

    Functions that belong to no exercise, such as helpers, are grouped by file instead.
    """

    title: str
    pairs: list[Pair]


def compare_exercise(exercise: Exercise, own: Texts, reference: Texts) -> Compared:
    """Pair a student's functions for one exercise with those in the reference solution."""
    pairs = []
    for edit in exercise.edit:
        module, name = edit.split(".", 1)
        sides = [_codes(f"{module}.py", texts).get(name) for texts in (own, reference)]
        pairs.append(Pair(name, *sides))
    return Compared(f"{exercise.id} {exercise.title}", pairs)


def compare_others(
    chapter: Chapter, files: Iterable[str], own: Texts, reference: Texts
) -> list[Compared]:
    """Compare a student's functions that belong to no exercise with the reference solution.

    An example is a helper that the student has added. Functions that are the same in both versions
    are left out, because students may have received them from us. Code outside functions is left
    out too.
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
    """Read the functions in one module, from a student's files or from the reference solution.

    The result maps each name, such as "Particle.mass", to the function's code. Functions that
    cannot be parsed are left out.
    """
    text = texts.get(file, "")
    return {one.name: _code(file, text, one) for one in read_functions(text)[0]}


def _code(file: str, text: str, function: Function) -> Code:
    passage = Passage(file, function.name, function.tokens, text)
    body = "".join(piece.text for piece in pieces_of(passage, {}))
    return Code(body.rstrip("\n"), count(function))
