"""Make the wrong submissions that a chapter's wrong.toml describes, as tests/README.md explains."""

from __future__ import annotations

import ast
import functools
import textwrap
import tomllib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from autograder.definitions import functions
from autograder.manifest import ROOT, Chapter


@dataclass(frozen=True)
class Wrong:
    """The reference with one function written as a student might have written it.

    ``replace`` has old texts, each there once, and new ones in turn, for ``body`` or the reference.
    """

    edit: str
    mistake: str
    caught_by: str  # the check that is meant to fail
    replace: Sequence[str] = ()
    body: str = ""
    says: str = ""  # words in the first message, if its numbers reveal the mistake
    usual: str = ""  # words of the lesson, if it names this mistake as a usual one
    opens: str = ""  # the function that the screen points to, if it is a different one


def read_wrong(chapter: Chapter) -> list[Wrong]:
    return [
        Wrong(edit, mistake, check, **_fields(entry, checks.get("right", "")))
        for edit, checks in _read(chapter).items()
        for check, mistakes in checks.items()
        if check != "right"
        for mistake, entry in mistakes.items()
    ]


def read_right(chapter: Chapter) -> dict[str, str]:
    """Return a chapter's alternative correct bodies, keyed by function."""
    return {edit: each["right"] for edit, each in _read(chapter).items() if "right" in each}


def _read(chapter: Chapter) -> dict[str, Any]:
    text = (ROOT / "tests" / chapter.name / "wrong.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)


def _fields(entry: list[str] | dict[str, Any], right: str) -> dict[str, Any]:
    """Return those fields of a wrong submission that its entry in the file determines."""
    if isinstance(entry, list):
        return {"replace": entry}
    if "in_right" in entry:
        return {"body": right, "replace": entry.pop("in_right"), **entry}
    return entry


def write_wrong(chapter: Chapter, wrongs: Iterable[Wrong], engine: Path) -> None:
    """Write the modules that differ from the reference into an engine folder."""
    bodies: dict[str, dict[str, str]] = {}
    for wrong in wrongs:
        module, _, name = wrong.edit.partition(".")
        bodies.setdefault(f"{module}.py", {})[name] = body_of(chapter, wrong)
    for file, changed in bodies.items():
        _write_changed(chapter, file, changed, engine)


def write_all(chapter: Chapter, body: str | None, engine: Path, *, but: Sequence[str] = ()) -> None:
    """Write modules with the same body in every function of students, or empty ones for None.

    Data files of students are left empty. The exercises in ``but`` stay as in the reference.
    """
    changed = [e for e in chapter.exercises if e.id not in but]
    names = [name.partition(".") for exercise in changed for name in exercise.edit]
    for file in chapter.edited_files:
        if body is None:
            (engine / chapter.name).mkdir(exist_ok=True)
            (engine / chapter.name / file).touch()
            continue
        bodies = {name: body for module, _, name in names if f"{module}.py" == file}
        _write_changed(chapter, file, bodies, engine)
    for exercise in changed:
        for name in exercise.files:
            (engine / chapter.name / name).touch()


def _write_changed(chapter: Chapter, file: str, bodies: dict[str, str], engine: Path) -> None:
    """Write a module of the reference with other bodies in some functions. Docstrings stay."""
    source, found = _lines_and_bodies(ROOT / "solutions" / chapter.name / file)
    lines = [*source]
    for name in sorted(bodies, key=lambda name: found[name].start, reverse=True):  # from the end
        where, indent = found[name], "    " * (1 + name.removesuffix(".setter").count("."))
        lines[where.start : where.stop] = textwrap.indent(bodies[name].strip("\n"), indent).split(
            "\n"
        )
    (engine / chapter.name).mkdir(parents=True, exist_ok=True)
    (engine / chapter.name / file).write_text("\n".join(lines) + "\n", encoding="utf-8")


def body_of(chapter: Chapter, wrong: Wrong) -> str:
    body = wrong.body
    if not body:
        module, _, name = wrong.edit.partition(".")
        lines, found = _lines_and_bodies(ROOT / "solutions" / chapter.name / f"{module}.py")
        body = textwrap.dedent("\n".join(lines[found[name].start : found[name].stop]))
    for old, new in zip(wrong.replace[::2], wrong.replace[1::2], strict=True):
        if body.count(old) != 1:
            raise ValueError(f"{wrong.edit}, {wrong.mistake}: {old!r} must be there once")
        body = body.replace(old, new)
    return body


@functools.cache
def _lines_and_bodies(file: Path) -> tuple[tuple[str, ...], dict[str, slice]]:
    """Return the lines of a module, and for each function the range of lines that is its body."""
    source = file.read_text(encoding="utf-8")
    found = {}
    for name, function in functions(ast.parse(source)).items():
        first = function.body[0]
        start = first.end_lineno if ast.get_docstring(function) else first.lineno - 1
        found[name] = slice(start, function.end_lineno)
    return tuple(source.splitlines()), found
