"""Make a class in which most students solved the exercises themselves, and a few copied.

Functions come from the reference, the sample class and wrong.toml, in each student's own style.
"""

from __future__ import annotations

import ast
import builtins
import textwrap
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from random import Random
from typing import Any

from autograder.definitions import functions
from autograder.manifest import ROOT, Chapter, load_chapters
from wrong import body_of, read_wrong

COPIED = 0.85  # fraction of the exercises; the others are the copier's own work
Bodies = dict[tuple[str, str], str]  # by file, such as ch02_vectors/vector.py, and function
Files = dict[str, str]
HABITS = ["swap operands", "expand +=", "whole numbers", "name results"]
NAMES = (
    "a b c d e f g h i j k m n p q r s t u w val tmp res out num cur acc cnt idx item thing old "
    "new left right first second total diff amount part length vec pos speed step size factor"
)
Body = list[ast.stmt]


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


class Student(ast.NodeTransformer):
    """A student's habits: different ways to write an expression, and how often each is used."""

    def __init__(self, rng: Random) -> None:
        self.rng = rng
        self.habits = {habit: rng.choice([0.0, 0.1, 0.3, 0.6, 0.9]) for habit in HABITS}

    def does(self, habit: str) -> bool:
        return self.rng.random() < self.habits[habit]

    def write(self, source: str, parameters: Iterable[str] = ()) -> str:
        """Return a function's body, with these parameters, in this student's style."""
        body = []
        for statement in map(self.visit, parsed(source)):
            body += statement if isinstance(statement, list) else [statement]
        return written(renamed(body, self.rng, parameters))

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        self.generic_visit(node)
        if isinstance(node.op, (ast.Mult, ast.Add)) and self.does("swap operands"):
            node.left, node.right = node.right, node.left
        return node

    def visit_AugAssign(self, node: ast.AugAssign) -> ast.AST:
        self.generic_visit(node)
        if self.does("expand +="):
            read = ast.parse(ast.unparse(node.target), mode="eval").body
            return ast.Assign([node.target], ast.BinOp(read, node.op, node.value), lineno=1)
        return node

    def visit_Constant(self, node: ast.Constant) -> ast.AST:
        value = node.value
        whole = isinstance(value, float) and abs(value) < 1e9 and value == int(value)
        return ast.Constant(int(value)) if whole and self.does("whole numbers") else node

    def visit_JoinedStr(self, node: ast.JoinedStr) -> ast.AST:
        return node

    def visit_Return(self, node: ast.Return) -> Any:
        self.generic_visit(node)
        if isinstance(node.value, (ast.Call, ast.BinOp)) and self.does("name results"):
            name = self.rng.choice(["result", "answer", "value"])
            value = ast.Assign([ast.Name(name, ast.Store())], node.value, lineno=1)
            return [value, ast.Return(ast.Name(name, ast.Load()))]
        return node


def disguised(source: str, rng: Random, parameters: Iterable[str] = ()) -> str:
    """Return a body whose variables are renamed and whose statements are reordered."""
    return written(renamed(reordered(parsed(source), rng), rng, parameters))


def renamed(body: Body, rng: Random, parameters: Iterable[str]) -> Body:
    """Rename the local variables of a body, but not its parameters."""
    nodes = [node for statement in body for node in ast.walk(statement)]
    names = [node for node in nodes if isinstance(node, ast.Name)]
    used = {name.id for name in names} | {*dir(builtins)}
    free = [name for name in NAMES.split() if name not in used]
    rng.shuffle(free)
    stored = {name.id for name in names if isinstance(name.ctx, ast.Store)}
    local = sorted(stored - {*parameters})
    new = dict(zip(local, free, strict=False))
    for name in names:
        name.id = new.get(name.id, name.id)
    return body


def reordered(body: Body, rng: Random) -> Body:
    """Swap most pairs of neighboring statements that do not depend on each other."""
    body = [*body]
    for i in range(len(body) - 1):
        if independent(body[i], body[i + 1]) and rng.random() < 0.7:
            body[i], body[i + 1] = body[i + 1], body[i]
    for statement in body:
        for field in ("body", "orelse"):
            if isinstance(getattr(statement, field, None), list):
                setattr(statement, field, reordered(getattr(statement, field), rng))
    return body


def independent(one: ast.stmt, other: ast.stmt) -> bool:
    if not all(isinstance(statement, (ast.Assign, ast.AugAssign)) for statement in (one, other)):
        return False
    return not (stored(one) & names_in(other) or stored(other) & names_in(one))


def names_in(statement: ast.stmt, context: type = ast.expr_context) -> set[str]:
    kinds = (ast.Name, ast.Attribute, ast.Subscript)
    found = [node for node in ast.walk(statement) if isinstance(node, kinds)]
    return {ast.unparse(node) for node in found if isinstance(node.ctx, context)}


def stored(statement: ast.stmt) -> set[str]:
    return names_in(statement, ast.Store)


def parsed(source: str) -> Body:
    (function,) = ast.parse("def f():\n" + textwrap.indent(source, "    ")).body
    assert isinstance(function, ast.FunctionDef)
    return function.body


def written(body: Iterable[ast.stmt]) -> str:
    return "\n".join(ast.unparse(ast.fix_missing_locations(statement)) for statement in body)
