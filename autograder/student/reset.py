"""Put the stub of one exercise back, and keep a copy of the file as it was.

A stub is made from the student's own file and the manifest. Where a function was deleted, its stub
comes from the reference, or from the folder stubs/ that a hand-out has in its place.
"""

from __future__ import annotations

import ast
from dataclasses import dataclass, replace
from itertools import count
from pathlib import Path

import libcst as cst

from autograder.commands import command
from autograder.definitions import bound_names, functions
from autograder.manifest import ROOT, Chapter, Exercise
from autograder.stubs import messages_of, pristine_stub, without_bodies
from autograder.student.put_back import put_back

COPIES = ROOT / "build" / "reset"


@dataclass(frozen=True)
class Change:
    """What a reset makes of one file. ``gone`` says that the functions ``names`` were deleted."""

    file: Path
    before: bytes
    after: bytes
    names: list[str]
    gone: bool = False


def reset(
    chapter: Chapter,
    exercise: Exercise,
    engine: Path,
    copies: Path = COPIES,
    *,
    whole: bool = False,
) -> str:
    """Put the stub back into the engine's files; return what was done, and where the copies are.

    Nothing but the bodies of the exercise changes, or the ``whole`` of its files goes back. Where
    some of its functions were deleted, those are put back and the others stay as they are. Raises
    ValueError where a file has no such body, or cannot be read; then nothing has changed.
    """
    done = []
    for change in planned(chapter, exercise, engine, whole=whole):
        file = _short(change.file)
        if change.after == change.before:
            done.append(f"{file} has the stub already.")
            continue
        if change.before:
            copy = _short(_keep(change.file, change.before, copies / chapter.name))
        change.file.write_bytes(change.after)
        names = "all of it" if whole else ", ".join(change.names)
        what = "the missing stub is back" if change.gone else "the stub is back"
        done.append(f"{exercise.id} {exercise.title}: {what} in {file} ({names}).")
        if change.gone:
            done.append("The other functions are as they were.")
        if change.before:
            done.append(f"A copy of the file as it was: {copy}")
    return "\n".join(done)


def question(chapter: Chapter, exercise: Exercise, engine: Path, copies: Path = COPIES) -> str:
    """Return what to ask before a reset. Raises ValueError as reset does."""
    changes = planned(chapter, exercise, engine)
    names = ", ".join(name for change in changes for name in change.names)
    files = " and ".join(str(_short(change.file)) for change in changes)
    if any(change.gone for change in changes):
        does = f"This puts the missing stub of {names} back into {files}. Your other code stays."
    else:
        does = f"This replaces your code of {names} in {files} with the stub."
    return (
        f"Reset {exercise.id} {exercise.title}? {does} A copy of the file is kept in "
        f"{_short(copies / chapter.name)}."
    )


def planned(
    chapter: Chapter, exercise: Exercise, engine: Path, *, whole: bool = False
) -> list[Change]:
    """Return what a reset would do, without doing it. Raises ValueError as reset does."""
    if not exercise.edit:
        raise ValueError(f"{exercise.id} is answered in answers.md, and has no stub to put back")
    alone = replace(chapter, exercises=[exercise])
    changes = []
    for name in alone.edited_files:
        file = engine / chapter.name / name
        messages = messages_of(alone, name)
        if whole:
            before = file.read_bytes() if file.exists() else b""
            changes.append(Change(file, before, _whole_stub(chapter, name), [*messages]))
        else:
            changes.append(_change(chapter, exercise, file, messages))
    return [change for change in changes if change.gone] or changes


def _change(chapter: Chapter, exercise: Exercise, file: Path, messages: dict[str, str]) -> Change:
    """Return the change of one file: its stubs, or those of them that are missing."""
    try:
        before = file.read_bytes()
        tree, module = ast.parse(before), cst.parse_module(before)
        missing = [name for name in messages if name not in functions(tree)]
        if not missing:
            return Change(file, before, without_bodies(module, messages).bytes, [*messages])
        if missing_stub := pristine_stub(chapter, file.name):
            classes = {node.name for node in tree.body if isinstance(node, ast.ClassDef)}
            lost = {name.partition(".")[0] for name in missing if "." in name} - classes
            if lost and classes:  # most likely renamed: a second class would take its place
                raise ValueError(
                    f"it has no class {min(lost)}, but a class {min(classes)}. If you renamed it, "
                    "change the name back"
                )
            if bound := [name for name in missing if name in bound_names(tree)]:
                raise ValueError(f"it defines {', '.join(bound)} without a def")
            after = put_back(module, cst.parse_module(missing_stub), missing).bytes
            return Change(file, before, after, missing, gone=True)
        why = f"it does not define {', '.join(missing)}"
    except FileNotFoundError:
        why = "it is not there"
    except SyntaxError as error:
        why = f"it cannot be read: line {error.lineno}: {error.msg}"
    except (ValueError, cst.ParserSyntaxError) as error:
        why = str(error)
    engine, way = file.parent.parent, "take the file from the hand-out again"
    if pristine_stub(chapter, file.name):
        elsewhere = {} if engine == ROOT / "chapters" else {"ENGINE": str(engine)}
        back = command("reset", EX=exercise.id, WHOLE="1", **elsewhere)
        way = f"put the whole file back (a copy is kept): {back}"
    raise ValueError(f"nothing was reset in {_short(file)}: {why}. Fix that, or {way}")


def _whole_stub(chapter: Chapter, file: str) -> bytes:
    stub = pristine_stub(chapter, file)
    if stub is None:
        raise ValueError(
            f"the whole of {file} cannot be put back, because this folder has neither a reference "
            "nor the folder stubs. Take the file from the hand-out again"
        )
    return stub.encode()


def _keep(file: Path, content: bytes, folder: Path) -> Path:
    """Write a copy with the first number that is free; return its path."""
    folder.mkdir(parents=True, exist_ok=True)
    for number in count(1):
        copy = folder / f"{file.stem}-{number}{file.suffix}"
        if not copy.exists():
            break
    with copy.open("xb") as out:
        out.write(content)
    return copy


def _short(path: Path) -> Path:
    """Return the path from the working folder where it is below it."""
    return path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path
