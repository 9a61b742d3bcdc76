"""Explain to a student why a check has failed and what to do next."""

from __future__ import annotations

import ast
import re
from collections.abc import Collection
from dataclasses import dataclass, replace
from pathlib import Path

from autograder.checks.calls import calls, names_class
from autograder.checks.verdict import Verdict
from autograder.commands import check_command, command
from autograder.definitions import functions, own_name, read_module
from autograder.files import from_here
from autograder.manifest import Chapter, Exercise, chapters_below, load_chapters, numbers_of
from autograder.message import Kind, Row
from autograder.scores import Result
from autograder.text.wrapping import plain_console, print_rows, print_wrapped

FOLDER = re.compile(r"ch\d\d_\w+")  # a chapter's folder has such a name


@dataclass(frozen=True)
class Failure:
    """An explanation of a failed check for the student, with the next steps to take."""

    heading: str
    diagnosis: list[Row]
    printed: str  # by the student's code
    steps: list[str]
    place: str = ""  # the line to open in an editor, unless the mistake is in an earlier chapter
    hints: str = ""  # the exercise whose hints may help


def failure_of(
    chapter: Chapter,
    result: Result,
    engine: list[Path],
    title: str = "",
    edited: Collection[str] = (),
) -> Failure | None:
    """Choose the failed check of an exercise that the student should see first, and explain it.

    Physics checks come before robust checks, then those of functions that the student has just
    edited. Checks of functions that are not written yet come last. Return None if no check failed.
    """

    def order(check: Verdict) -> tuple[bool, bool, bool]:
        is_unwritten = check.message.kind is Kind.UNWRITTEN
        return check.robust, not _is_about(check, edited), is_unwritten

    candidates = [check for check in result.checks if check.status == result.status]
    if not candidates:
        return None
    failed = min(candidates, key=order)
    exercise, message = result.exercise, failed.message
    inherited = failed.status == "inherited"
    if inherited:  # then the cause that this chapter's check suggests is wrong
        message = replace(message, likely="", other="", read="")
    rows = [("check", failed.name), *message.rows(printed=False)]
    if failed.robust and exercise.robust:
        rows.append(("why", exercise.robust))  # last: an example, not what this check found
    title = title or ("Make this robust" if failed.robust else "Fix this first")
    heading = f"{'Inherited, for example' if inherited else title}: {exercise.id} {exercise.title}"
    if inherited:
        steps = [f"Next: {check_command(engine, CH=numbers_of(chapters_below(chapter)))}"]
        return Failure(heading, rows, message.printed, steps)
    place, hints = next_place(engine, chapter, exercise, failed), message.exercise or exercise.id
    steps = [f"Next: open {place}", f"For a hint: {command('hint', EX=hints)}"]
    return Failure(heading, rows, message.printed, steps, place, hints)


def print_failure(chapter: Chapter, result: Result, engine: list[Path]) -> None:
    """Print why an exercise fails and what the student should do next."""
    console = plain_console()
    failure = failure_of(chapter, result, engine)
    if failure is None:
        console.print(f"No check was found for exercise {result.exercise.id}.", style="magenta")
        return
    print_wrapped(console, failure.heading, "bold")
    printed = [("printed", failure.printed)] if failure.printed else []
    print_rows(console, [*failure.diagnosis, *printed])
    console.print()
    for number, step in enumerate(failure.steps):
        print_wrapped(console, step, "" if number else "bold")


def _is_about(check: Verdict, edited: Collection[str]) -> bool:
    """Return True if a check calls a function just edited, or fails inside it."""
    called, where = check.message.called, check.message.where
    return any(
        calls(called, name) or (where and where.function == own_name(name).removesuffix(".setter"))
        for name in edited
    )


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
    return _definition(engine, chapter, (named or bodies or exercise.edit)[0])


def _definition(engine: list[Path], chapter: Chapter, name: str) -> str:
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
