"""Let a student start an exercise over by restoring its stub, and keep a copy of the old file.

Only the functions of that exercise change in the student's file.
"""

from __future__ import annotations

import ast
from dataclasses import dataclass, replace
from itertools import count
from pathlib import Path

from autograder.commands import command, engine_variables
from autograder.definitions import bound_names, functions
from autograder.files import from_here, replace_bytes
from autograder.handouts.bodies import put_back
from autograder.handouts.stubs import messages_of, pristine_stub, without_bodies
from autograder.manifest import ROOT, Chapter, Exercise

KEPT = ROOT / "build" / "reset"


@dataclass(frozen=True)
class Change:
    """A planned change to one of a student's files, which restores the functions in ``names``.

    ``gone`` is True if the student has deleted these functions.
    """

    file: Path
    before: bytes
    after: bytes
    names: list[str]
    gone: bool = False


def reset(
    chapter: Chapter, exercise: Exercise, engine: Path, copies: Path = KEPT, *, whole: bool = False
) -> str:
    """Restore the stubs of an exercise, and return a text that lists the changes and the copies.

    If the student has deleted some of its functions, only those are restored. If ``whole`` is
    true, entire files are restored. Each file is first copied to the folder ``copies``.
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
        what = "restored the missing stub" if change.gone else "restored the stub"
        done.append(f"{exercise.id} {exercise.title}: {what} in {file} ({names}).")
        if change.gone:
            done.append("The other functions are unchanged.")
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
    does = f"This replaces your code for {names} in {files} with the stub."
    if any(change.gone for change in changes):
        does = f"This restores the missing stub of {names} in {files}. "
        does += "Your other code stays as it is."
    return (
        f"Reset {exercise.id} {exercise.title}? {does} A copy of the file is kept in "
        f"{from_here(copies / chapter.name)}."
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
        messages = messages_of(alone, name)
        if not whole:
            changes.append(_change(chapter, exercise, file, messages))
            continue
        if (stub := pristine_stub(chapter, name)) is None:
            raise ValueError(
                f"{name} cannot be restored, because this folder has neither the reference nor "
                "the folder stubs. Copy the file from the handout again"
            )
        before = file.read_bytes() if file.exists() else b""
        changes.append(Change(file, before, stub.encode(), [*messages]))
    return [change for change in changes if change.gone] or changes


def _change(chapter: Chapter, exercise: Exercise, file: Path, messages: dict[str, str]) -> Change:
    """Plan the change of one file. If functions of the exercise are gone, restore only those."""
    stub = pristine_stub(chapter, file.name)
    try:
        before = file.read_bytes()
        tree = ast.parse(before)
        missing = [name for name in messages if name not in functions(tree)]
        if not missing:
            return Change(file, before, without_bodies(before, messages), [*messages])
        if stub:
            classes = {node.name for node in tree.body if isinstance(node, ast.ClassDef)}
            lost = {name.partition(".")[0] for name in missing if "." in name} - classes
            if lost and classes:  # probably renamed, so do not add a second class
                raise ValueError(
                    f"it has no class {min(lost)}, but a class {min(classes)}. If you renamed it, "
                    "change the name back"
                )
            if bound := [name for name in missing if name in bound_names(tree)]:
                raise ValueError(f"it defines {', '.join(bound)} without a def")
            return Change(file, before, put_back(before, stub.encode(), missing), missing, True)
        why = f"it does not define {', '.join(missing)}"
    except FileNotFoundError:
        why = "it does not exist"
    except SyntaxError as error:
        why = f"it cannot be read: line {error.lineno}: {error.msg}"
    except ValueError as error:
        why = str(error)
    way = "copy the file from the handout again"
    if stub:
        elsewhere = engine_variables([file.parent.parent])
        back = command("reset", EX=exercise.id, WHOLE="1", **elsewhere)
        way = f"restore the whole file (a copy is kept): {back}"
    raise ValueError(f"nothing was reset in {from_here(file)}: {why}. Fix that, or {way}")


def _keep(file: Path, content: bytes, folder: Path) -> Path:
    """Save a numbered copy of a student's file, such as vector-1.py, and return its path."""
    numbered = (folder / f"{file.stem}-{number}{file.suffix}" for number in count(1))
    copy = next(path for path in numbered if not path.exists())
    if content:
        folder.mkdir(parents=True, exist_ok=True)
        copy.write_bytes(content)
    return copy
