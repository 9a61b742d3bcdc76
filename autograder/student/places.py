"""Find the line in a student's file that a failed check is about, to open it in an editor."""

from __future__ import annotations

import ast
import re
from pathlib import Path

from autograder.checks.calls import calls, names_class
from autograder.checks.verdict import Verdict
from autograder.definitions import functions, read_module
from autograder.files import from_here
from autograder.manifest import Chapter, Exercise, load_chapters

FOLDER = re.compile(r"ch\d\d_\w+")  # a chapter's folder has such a name


def next_place(engine: list[Path], chapter: Chapter, exercise: Exercise, failed: Verdict) -> str:
    """Find the line that the student should open to fix a failed check, in the form path:line.

    It is the line in the check's message, unless it is in a file that students must not edit or in
    another exercise, or else the start of the function that the check calls, or a data file.
    """
    complete = {(other.name, file) for other in load_chapters() for file in other.complete}
    called, where = failed.message.called, failed.message.where
    folder, _, file = where.file.partition("/") if where else ("", "", "")
    if not FOLDER.fullmatch(folder) or (folder, file) in complete:
        where = None
    data = [name for name in exercise.files if name in called]
    if data and not (where and file in chapter.edited_files):
        return str(_file(engine, chapter.name, data[0]))
    if where:
        body = _body_at(_file(engine, folder, file), where.line)
        others = {name for other in chapter.exercises for name in other.edit} - {*exercise.edit}
        if not called or (folder == chapter.name and body not in others):
            return f"{_file(engine, folder, file)}:{where.line}"
    bodies = [name for name in exercise.edit if calls(called, name)]
    named = [name for name in bodies if names_class(called, name)]
    return find_definition(engine, chapter, (named or bodies or exercise.edit)[0])


def find_definition(engine: list[Path], chapter: Chapter, name: str) -> str:
    """Find the line that defines vector.Vector3.dot, as path:line, or the path if unreadable."""
    module, _, path = name.partition(".")
    file = _file(engine, chapter.name, f"{module}.py")
    tree = read_module(file)
    if tree is None:
        return str(file)
    lines = {node.name: node.lineno for node in tree.body if isinstance(node, ast.ClassDef)}
    lines |= {name: node.lineno for name, node in functions(tree).items()}
    return f"{file}:{lines.get(path) or lines.get(path.partition('.')[0], 1)}"


def _body_at(file: Path, line: int) -> str | None:
    """Return the function at a line of a file, such as vector.Vector3.dot, or None."""
    tree = read_module(file)
    for name, node in functions(tree).items() if tree else ():
        if node.lineno <= line <= (node.end_lineno or 0):
            return f"{file.stem}.{name}"
    return None


def _file(engine: list[Path], chapter: str, name: str) -> Path:
    files = [folder / chapter / name for folder in engine]
    return from_here(next((file for file in files if file.exists()), files[0]))
