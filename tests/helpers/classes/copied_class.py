"""Make a class in which most students solved the exercises themselves, and a few copied.

Correct functions come from the reference and from Ada. Wrong functions come from wrong.toml and
from the sample class. Each student writes in a personal style, gets some functions wrong, and
leaves some out.
"""

from __future__ import annotations

import ast
import textwrap
from collections.abc import Iterator, Sequence
from functools import cache
from random import Random

from autograder.definitions import functions
from autograder.manifest import ROOT, Chapter, load_chapters
from restyled import Student, disguised
from wrong import body_of, read_wrong

COPIED = 0.85  # fraction of the exercises; the others are the copier's own work
Bodies = dict[tuple[str, str], str]  # by file, such as ch02_vectors/vector.py, and function
Files = dict[str, str]


def copied_class(
    chapters: Sequence[Chapter], seed: int, size: int = 40, copiers: int = 10
) -> tuple[list[Files], list[tuple[int, int]]]:
    """Return the files of each student, and the pairs (source, copier)."""
    rng = Random(seed)
    students = [_solved(chapters, rng) for _ in range(size)]
    order = rng.sample(range(size), 2 * copiers)
    pairs = [(min(pair), max(pair)) for pair in zip(order[::2], order[1::2], strict=True)]
    for one, other in pairs:
        students[other] = _copied(chapters, students[one], students[other], rng)
    return [_files(chapters, bodies) for bodies in students], pairs


def _solved(chapters: Sequence[Chapter], rng: Random) -> Bodies:
    """Return the functions that a student has written without copying."""
    student = Student(rng)
    skill, diligence = rng.choice([0.6, 0.8, 0.9, 0.95, 1.0]), rng.choice([0.5, 0.7, 0.9, 1.0, 1.0])
    bodies = {}
    for chapter in chapters:
        right, wrong = _known_bodies(chapter.name)
        for exercise in chapter.exercises:
            if rng.random() > diligence:
                continue
            for edit in exercise.edit:
                place = _place(chapter, edit)
                is_right = rng.random() < skill or place not in wrong
                body = rng.choice((right if is_right else wrong)[place])
                bodies[place] = student.write(body, _parameters(*place))
    return bodies


def _copied(chapters: Sequence[Chapter], source: Bodies, own: Bodies, rng: Random) -> Bodies:
    """Return the functions of a student who has copied most of them from ``source``."""
    bodies = {}
    for chapter in chapters:
        for exercise in chapter.exercises:
            copies = rng.random() < COPIED
            for place in (_place(chapter, edit) for edit in exercise.edit):
                if copies and place in source:
                    bodies[place] = disguised(source[place], rng, _parameters(*place))
                elif not copies and place in own:
                    bodies[place] = own[place]
    return bodies


def _files(chapters: Sequence[Chapter], bodies: Bodies) -> Files:
    """Return the stubs in which these bodies have been filled in."""
    files = {}
    for chapter in chapters:
        for name in chapter.edited_files:
            file = f"{chapter.name}/{name}"
            source = (ROOT / "chapters" / file).read_text(encoding="utf-8")
            lines = source.splitlines()
            found = functions(ast.parse(source))
            mine = [(found[n], body) for (path, n), body in bodies.items() if path == file]
            for function, body in sorted(mine, key=lambda pair: -pair[0].lineno):
                first = function.body[0]  # the docstring, which every stub has
                indent = " " * first.col_offset
                new = textwrap.indent(body, indent).split("\n")
                lines[first.end_lineno : function.end_lineno] = new
            files[file] = "\n".join(lines) + "\n"
    return files


@cache
def _known_bodies(name: str) -> tuple[dict[tuple[str, str], list[str]], ...]:
    """Return the correct and the wrong bodies that are known for a chapter's functions."""
    (chapter,) = (chapter for chapter in load_chapters() if chapter.name == name)
    right: dict[tuple[str, str], list[str]] = {}
    wrong: dict[tuple[str, str], list[str]] = {}
    for found, folders in (
        (right, ("solutions", "sample_class/ada")),
        (wrong, ("sample_class/cleo", "sample_class/ben", "sample_class/hana")),
    ):
        for folder in folders:
            for file in chapter.edited_files:
                path = ROOT / folder / name / file
                for function, body in _bodies_in(
                    path.read_text(encoding="utf-8") if path.exists() else ""
                ):
                    found.setdefault((f"{name}/{file}", function), []).append(body)
    for each in read_wrong(chapter):
        wrong.setdefault(_place(chapter, each.edit), []).append(body_of(chapter, each).strip("\n"))
    return right, wrong


def _bodies_in(source: str) -> Iterator[tuple[str, str]]:
    """Yield the functions in a module that are not stubs, with their bodies."""
    for name, function in functions(ast.parse(source)).items():
        statements = function.body[1:] if ast.get_docstring(function) else function.body
        body = "\n".join(map(ast.unparse, statements))
        if body and not body.startswith("raise NotImplementedError"):
            yield name, body


@cache
def _parameters(file: str, function: str) -> list[str]:
    source = (ROOT / "chapters" / file).read_text(encoding="utf-8")
    return [
        node.arg
        for node in ast.walk(functions(ast.parse(source))[function].args)
        if isinstance(node, ast.arg)
    ]


def _place(chapter: Chapter, edit: str) -> tuple[str, str]:
    module, _, name = edit.partition(".")
    return f"{chapter.name}/{module}.py", name
