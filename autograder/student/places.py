"""Find the line in a student's file that a failed check is about.

The student can then open the file at that line in an editor.
"""

from __future__ import annotations

import ast
import re
from pathlib import Path

from autograder.checks.calls import calls, names_class
from autograder.checks.verdict import Verdict
from autograder.definitions import functions
from autograder.manifest import Chapter, Exercise, load_chapters

FOLDER = re.compile(r"ch\d\d_\w+")  # a chapter's folder has such a name


def next_place(engine: list[Path], chapter: Chapter, exercise: Exercise, failed: Verdict) -> str:
    """Find the line that the student should open to fix a failed check, in the form path:line.

    The line is taken from the check's message if possible. Otherwise, it is the start of the
    function that the check calls. Lines in files that must not be edited are ignored. Lines in
    functions of other exercises are usually ignored too, because the mistake may lie elsewhere. If
    the check is about data that the student entered, the result is the path of the data file.
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
        body = _body_at(engine, folder, file, where.line)
        others = {name for other in chapter.exercises for name in other.edit} - {*exercise.edit}
        if not called or (folder == chapter.name and body not in others):
            return f"{_file(engine, folder, file)}:{where.line}"
    bodies = [name for name in exercise.edit if calls(called, name)]
    named = [name for name in bodies if names_class(called, name)]
    return find_definition(engine, chapter, (named or bodies or exercise.edit)[0])


def find_definition(engine: list[Path], chapter: Chapter, name: str) -> str:
    """Find the line at which one of the student's functions is defined, as path:line.

    ``name`` is the function's name in the manifest, such as vector.Vector3.dot. If the file is
    missing or unreadable, the result is only the path of the file. A file inside the working folder
    gets a relative path.
    """
    module, _, path = name.partition(".")
    file = _file(engine, chapter.name, f"{module}.py")
    tree = _read(file)
    if tree is None:
        return str(file)
    places = {node.name: node.lineno for node in tree.body if isinstance(node, ast.ClassDef)}
    places |= {name: node.lineno for name, node in functions(tree).items()}
    return f"{file}:{places.get(path) or places.get(path.partition('.')[0], 1)}"


def _body_at(engine: list[Path], chapter: str, file: str, line: int) -> str | None:
    """Return the function at a certain line of a student's file, such as vector.Vector3.dot.

    The result is None if the line is outside all functions.
    """
    tree = _read(_file(engine, chapter, file))
    for name, node in functions(tree).items() if tree else ():
        if node.lineno <= line <= (node.end_lineno or 0):
            return f"{file.removesuffix('.py')}.{name}"
    return None


def _read(file: Path) -> ast.Module | None:
    """Parse a student's Python file, or return None if it is missing or unreadable."""
    try:
        return ast.parse(file.read_text(encoding="utf-8-sig"))  # some editors add a BOM
    except (OSError, SyntaxError, ValueError):
        return None


def _file(engine: list[Path], chapter: str, name: str) -> Path:
    """Return the path of a file in the student's engine, such as chapters/ch02_vectors/vector.py.

    If the file lies inside the working folder, the path is relative to that folder.
    """
    files = [folder / chapter / name for folder in engine]
    file = next((file for file in files if file.exists()), files[0])
    return file.relative_to(Path.cwd()) if file.is_relative_to(Path.cwd()) else file
