"""Let a student start an exercise over by restoring its stub, and keep a copy of the old file.

Only the functions of that exercise change in the student's file.
"""

from __future__ import annotations

import ast
from dataclasses import dataclass, replace
from itertools import count
from pathlib import Path

from autograder.commands import command, engine_variables
from autograder.definitions import functions
from autograder.files import from_here, replace_bytes
from autograder.handouts.stubs import messages_of, pristine_stub, without_bodies
from autograder.manifest import ROOT, Chapter, Exercise

KEPT = ROOT / "build" / "reset"


@dataclass(frozen=True)
class Change:
    """A planned change to one of a student's files, which restores the functions in ``names``."""

    file: Path
    before: bytes
    after: bytes
    names: list[str]


def reset(
    chapter: Chapter, exercise: Exercise, engine: Path, copies: Path = KEPT, *, whole: bool = False
) -> str:
    """Restore the stubs of an exercise, and return a text that lists the changes and the copies.

    If ``whole`` is true, entire files are restored. Each file is first copied to ``copies``.
    """
    done = []
    for change in planned(chapter, exercise, engine, whole=whole):
        file = from_here(change.file)
        if change.after == change.before:
            done.append(f"{file} already has the stub.")
            continue
        copy = _keep(change.file, change.before, copies / chapter.name)
        replace_bytes(change.file, change.after)
        names = "the whole file" if whole else ", ".join(change.names)
        done.append(f"{exercise.id} {exercise.title}: restored the stub in {file} ({names}).")
        if change.before:
            done.append(f"A copy of your previous file: {from_here(copy)}")
    return "\n".join(done)


def question(
    chapter: Chapter, exercise: Exercise, engine: Path, copies: Path = KEPT, *, whole: bool = False
) -> str:
    """Return the question that asks a student to confirm the reset of an exercise."""
    changes = planned(chapter, exercise, engine, whole=whole)
    names = "all exercises" if whole else ", ".join(n for change in changes for n in change.names)
    files = " and ".join(str(from_here(change.file)) for change in changes)
    return (
        f"Reset {exercise.id} {exercise.title}? This replaces your code for {names} in {files} "
        f"with the stub. A copy of the file is kept in {from_here(copies / chapter.name)}."
    )


def planned(
    chapter: Chapter, exercise: Exercise, engine: Path, *, whole: bool = False
) -> list[Change]:
    """Plan the changes of a reset without making them, so that the student can confirm them."""
    if not exercise.edit:
        raise ValueError(f"{exercise.id} is answered in answers.md, so it has no stub to restore")
    alone = replace(chapter, exercises=[exercise])
    changes = []
    for name in alone.edited_files:
        file = engine / chapter.name / name
        before = file.read_bytes() if file.exists() else b""
        messages = messages_of(alone, name)
        why = "" if whole else _problem(before, messages)
        stub = pristine_stub(chapter, name) if whole or why else None
        if whole and stub is None:
            raise ValueError(
                f"{name} cannot be restored, because this folder has neither the reference nor "
                "the folder stubs. Copy the file from the handout again"
            )
        if why:
            way = "copy the file from the handout again"
            if stub:
                variables = engine_variables([engine])
                back = command("reset", EX=exercise.id, WHOLE="1", **variables)
                way = f"restore the whole file (a copy is kept): {back}"
            raise ValueError(f"nothing was reset in {from_here(file)}: {why}. Fix that, or {way}")
        after = stub.encode() if stub else without_bodies(before, messages)
        changes.append(Change(file, before, after, [*messages]))
    return changes


def _problem(source: bytes, messages: dict[str, str]) -> str:
    """Say why the stubs cannot be restored in a file, or return "" if they can."""
    try:
        missing = messages.keys() - functions(ast.parse(source)).keys()
    except SyntaxError as error:
        return f"it cannot be read: line {error.lineno}: {error.msg}"
    except ValueError as error:  # such as a null byte
        return str(error)
    return f"it does not define {', '.join(sorted(missing))}" if missing else ""


def _keep(file: Path, content: bytes, folder: Path) -> Path:
    """Save a numbered copy of a student's file, such as vector-1.py, and return its path."""
    numbered = (folder / f"{file.stem}-{number}{file.suffix}" for number in count(1))
    copy = next(path for path in numbered if not path.exists())
    if content:
        folder.mkdir(parents=True, exist_ok=True)
        copy.write_bytes(content)
    return copy
