"""Advice in checks, hints and docstrings can be followed: what it mentions exists."""

from __future__ import annotations

import ast
import importlib
import re
from collections.abc import Iterator
from functools import cache

import pytest

from autograder.checks.verdict import Verdict
from autograder.definitions import functions
from autograder.diagnosis.explain import explain_import
from autograder.diagnosis.faults import Fault
from autograder.handouts.handout import STUDENT_TOOLS
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.message import Message, Place
from autograder.student.failure import next_place

CHAPTERS = load_chapters()
by_chapter = pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
FILE = re.compile(r"\b[a-z]\w*\.(?:py|md|csv|toml)\b")
OF_A_FILE = re.compile(r"((?:\w+(?:, | and ))*\w+) (?:of|from) (\w+\.py)")
PROSE = {"functions", "lines", "line", "head", "top", "rest"}  # words about a file, not names in it
LIBRARY = re.compile(r"\b(math|random|itertools|functools|statistics|copy)\.([a-z]\w*)")
# A name of two words or more. A name that begins with one letter, such as v_s, is from a formula.
NAME = re.compile(r"(?<![\w.\"'{/-])_?[a-z]{2,}_[a-z_0-9]+\b(?!\.(?:py|csv|md))")
FOR_ALL_CHAPTERS = ("tests/shared/expect.py", "autograder/diagnosis/slips.py")
ROOT_FILES = {*STUDENT_TOOLS["."].split(), "README.md", "claims.md", "errata.md"}


def texts(tree: ast.Module, *, docstrings: bool) -> Iterator[str]:
    """Yield the texts of a file: its docstrings, or all others."""
    documented = {
        id(node.body[0].value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef)
        if node.body and isinstance(node.body[0], ast.Expr)
    }
    for node in ast.walk(tree):
        is_text = isinstance(node, ast.Constant) and isinstance(node.value, str)
        if is_text and (id(node) in documented) == docstrings:
            yield node.value


@cache
def stub(chapter: str, file: str) -> ast.Module:
    """Return a student's file: the reference, without the bodies that students write."""
    tree = parsed(f"solutions/{chapter}/{file}")
    (manifest,) = [each for each in CHAPTERS if each.name == chapter]
    edited = {name for exercise in manifest.exercises for name in exercise.edit}
    for name, node in functions(tree).items():
        if f"{file.removesuffix('.py')}.{name}" in edited:
            node.body = node.body[:1]
    return tree


def parsed(path: str) -> ast.Module:
    return ast.parse((ROOT / path).read_text(encoding="utf-8"))


def advice(chapter: Chapter) -> list[str]:
    given = [hint for exercise in chapter.exercises for hint in exercise.hints]
    for file in sorted((ROOT / "tests" / chapter.name).glob("test_*.py")):
        given += texts(parsed(str(file.relative_to(ROOT))), docstrings=False)
    for path in FOR_ALL_CHAPTERS:
        given += texts(parsed(path), docstrings=False)
    for file in chapter.edited_files:
        given += texts(stub(chapter.name, file), docstrings=True)
    return [text.replace("`", "").replace("() from ", " from ") for text in given if " " in text]


def below(chapter: Chapter) -> list[Chapter]:
    return [other for other in CHAPTERS if other.number <= chapter.number]


def names_in(tree: ast.AST) -> set[str]:
    """Return every name that a file uses or defines, and every string in it."""
    found: set[str] = set()
    for node in ast.walk(tree):
        for key in ("id", "name", "arg", "attr", "value"):
            if isinstance(word := getattr(node, key, None), str):
                found.add(word)
    return found


def file_named(chapter: Chapter, name: str) -> str | None:
    """Return the path of a module of this chapter, or of an earlier one, that a student has."""
    for other in reversed(below(chapter)):
        if name in other.edited_files:
            return f"solutions/{other.name}/{name}"
        if name in other.complete:
            return f"chapters/{other.name}/{name}"
    return None


@by_chapter
def test_each_file_that_is_named_is_there_for_students(chapter: Chapter) -> None:
    there = {*ROOT_FILES, "chapter.toml"}
    for other in below(chapter):
        there |= {*other.handed_in, *other.complete}
        there |= {path.name for path in (ROOT / "chapters" / other.name).glob("*.md")}
    named = {name for text in advice(chapter) for name in FILE.findall(text)}
    assert named, "advice names files"
    assert named - there == set()


def functions_of_files(chapter: Chapter) -> set[tuple[str, str]]:
    """Return the file and the name of each function that advice attributes to a file."""
    named = {found for text in advice(chapter) for found in OF_A_FILE.findall(text)}
    names = {(file, name) for words, file in named for name in re.split(r", | and ", words)}
    return {(file, name) for file, name in names if name not in PROSE}


@by_chapter
def test_each_function_of_a_file_and_of_the_library_is_there(chapter: Chapter) -> None:
    for file, name in functions_of_files(chapter):
        path = file_named(chapter, file)
        assert path, file
        assert name in names_in(parsed(path)), f"{name} of {file}"
    for module, name in LIBRARY.findall(" ".join(advice(chapter))):
        assert hasattr(importlib.import_module(module), name), f"{module}.{name}"


@by_chapter
def test_each_name_of_several_words_is_one_that_students_see(chapter: Chapter) -> None:
    known: set[str] = set()
    for other in below(chapter):
        for file in other.edited_files:
            known |= names_in(stub(other.name, file))
        for file in other.complete:
            if file.endswith(".py"):
                known |= names_in(parsed(f"chapters/{other.name}/{file}"))
    named = {(name, text) for text in advice(chapter) for name in NAME.findall(text)}
    assert {(name, text) for name, text in named if name not in known} == set()


@pytest.mark.parametrize("called", ["Vector3(1, 2, 3).copy()", ""])
def test_nobody_is_sent_to_a_file_that_is_not_to_be_edited(called: str) -> None:
    where = Place("ch02_vectors/arguments.py", 40, "finite", "x")
    exercise = CHAPTERS[0].exercises[0]
    message = Message(called=called, got="TypeError", where=where)
    failed = Verdict("test", exercise.id, 1.0, "failed", message)
    place = next_place([ROOT / "solutions", ROOT / "chapters"], CHAPTERS[0], exercise, failed)
    assert "ch02_vectors/vector.py:" in place


def test_a_complete_module_that_an_edit_breaks_leads_to_the_students_line() -> None:
    """The name of Contact was lost: joints.py cannot import it, and bridge.py imports joints.py."""
    folder = "ch08_mass_aggregate"
    lines = (("bridge", 13), ("joints", 9))
    frames = [Place(f"{folder}/{module}.py", line, "<module>") for module, line in lines]
    text = "cannot import name 'Contact' from 'ch07_constraints.contacts'"
    engine = [ROOT / "solutions", ROOT / "chapters"]
    fault = Fault("ImportError", text, frames)
    message = explain_import(fault, f"{folder}.bridge", engine, [f"{folder}/joints.py"])
    assert text in message.title
    assert (message.where.file, message.where.line) == (f"{folder}/bridge.py", 13)
