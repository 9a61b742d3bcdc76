"""Let a student start an exercise over by restoring its stub, and keep a copy of the old file.

Only the functions of that exercise change in the student's file. If the student has deleted a
function, its stub is derived from our solution. A handout has no solutions, so it keeps the stubs
in its stubs/ folder.
"""

from __future__ import annotations

import ast
from dataclasses import dataclass, replace
from itertools import count
from pathlib import Path

import libcst as cst

from autograder.commands import command
from autograder.definitions import bound_names, functions
from autograder.files import replace_bytes
from autograder.handouts.stubs import messages_of, pristine_stub, without_bodies
from autograder.manifest import ROOT, Chapter, Exercise
from autograder.student.put_back import put_back

COPIES = ROOT / "build" / "reset"


@dataclass(frozen=True)
class Change:
    """A planned change to one of a student's files, which resets an exercise.

    Attributes:
        file: The file to change.
        before: The content of the file before the change.
        after: The content of the file after the change.
        names: The functions to restore.
        gone: True if the student has deleted these functions.
    """

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
    """Let the student start an exercise over by restoring the stubs of its functions.

    If the student has deleted some of these functions, only those are restored. If ``whole`` is
    true, entire files are restored. Each file is copied to the folder ``copies`` before it is
    changed.

    Returns:
        A text for the student that lists the changes and the copies.

    Raises:
        ValueError: A file cannot be read or lacks a function. Nothing is changed.
    """
    done = []
    for change in planned(chapter, exercise, engine, whole=whole):
        file = _short(change.file)
        if change.after == change.before:
            done.append(f"{file} already has the stub.")
            continue
        if change.before:
            copy = _short(_keep(change.file, change.before, copies / chapter.name))
        replace_bytes(change.file, change.after)
        names = "the whole file" if whole else ", ".join(change.names)
        what = "restored the missing stub" if change.gone else "restored the stub"
        done.append(f"{exercise.id} {exercise.title}: {what} in {file} ({names}).")
        if change.gone:
            done.append("The other functions are unchanged.")
        if change.before:
            done.append(f"A copy of your previous file: {copy}")
    return "\n".join(done)


def question(
    chapter: Chapter,
    exercise: Exercise,
    engine: Path,
    copies: Path = COPIES,
    *,
    whole: bool = False,
) -> str:
    """Return the question that asks a student to confirm the reset of an exercise.

    The question lists the functions to reset, their files, and the folder for the copy.

    Raises:
        ValueError: The exercise cannot be reset, for example because a file is unreadable.
    """
    changes = planned(chapter, exercise, engine, whole=whole)
    names = "all exercises" if whole else ", ".join(n for change in changes for n in change.names)
    files = " and ".join(str(_short(change.file)) for change in changes)
    if any(change.gone for change in changes):
        does = (
            f"This restores the missing stub of {names} in {files}. Your other code stays as it is."
        )
    else:
        does = f"This replaces your code for {names} in {files} with the stub."
    return (
        f"Reset {exercise.id} {exercise.title}? {does} A copy of the file is kept in "
        f"{_short(copies / chapter.name)}."
    )


def planned(
    chapter: Chapter, exercise: Exercise, engine: Path, *, whole: bool = False
) -> list[Change]:
    """Plan the changes that a reset would make to the student's files, without making them.

    The student can then be asked to confirm the reset.

    Raises:
        ValueError: The exercise cannot be reset, for example because a file is unreadable.
    """
    if not exercise.edit:
        raise ValueError(f"{exercise.id} is answered in answers.md, so it has no stub to restore")
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
    """Plan the change that resets an exercise in one of the student's files.

    If the student has deleted any functions of the exercise, only those are restored.
    """
    try:
        before = file.read_bytes()
        tree, module = ast.parse(before), cst.parse_module(before)
        missing = [name for name in messages if name not in functions(tree)]
        if not missing:
            return Change(file, before, without_bodies(module, messages).bytes, [*messages])
        if missing_stub := pristine_stub(chapter, file.name):
            classes = {node.name for node in tree.body if isinstance(node, ast.ClassDef)}
            lost = {name.partition(".")[0] for name in missing if "." in name} - classes
            if lost and classes:  # probably renamed, so do not add a second class
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
        why = "it does not exist"
    except SyntaxError as error:
        why = f"it cannot be read: line {error.lineno}: {error.msg}"
    except (ValueError, cst.ParserSyntaxError) as error:
        why = str(error)
    engine, way = file.parent.parent, "copy the file from the handout again"
    if pristine_stub(chapter, file.name):
        elsewhere = {} if engine == ROOT / "chapters" else {"ENGINE": str(engine)}
        back = command("reset", EX=exercise.id, WHOLE="1", **elsewhere)
        way = f"restore the whole file (a copy is kept): {back}"
    raise ValueError(f"nothing was reset in {_short(file)}: {why}. Fix that, or {way}")


def _whole_stub(chapter: Chapter, file: str) -> bytes:
    stub = pristine_stub(chapter, file)
    if stub is None:
        raise ValueError(
            f"{file} cannot be restored, because this folder has neither the reference nor the "
            "folder stubs. Copy the file from the handout again"
        )
    return stub.encode()


def _keep(file: Path, content: bytes, folder: Path) -> Path:
    """Save a copy of a student's file before it is reset, and return the path of the copy.

    The copies of vector.py are numbered: vector-1.py, vector-2.py and so on.
    """
    folder.mkdir(parents=True, exist_ok=True)
    for number in count(1):
        copy = folder / f"{file.stem}-{number}{file.suffix}"
        if not copy.exists():
            break
    with copy.open("xb") as out:
        out.write(content)
    return copy


def _short(path: Path) -> Path:
    """Shorten a path that is shown to a student.

    If the file is inside the working folder, the path becomes relative to that folder.
    """
    return path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path
