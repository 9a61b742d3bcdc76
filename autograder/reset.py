"""Put the stub of one exercise back, and keep a copy of the file as it was.

The stub is made from the student's own file and the manifest, so that a hand-out can do it too.
"""

from __future__ import annotations

import ast
from dataclasses import replace
from itertools import count
from pathlib import Path

import libcst as cst

from autograder.commands import command
from autograder.definitions import functions
from autograder.manifest import ROOT, Chapter, Exercise
from autograder.stubs import messages_of, stub_of, without_bodies

COPIES = ROOT / "build" / "reset"


def reset(
    chapter: Chapter,
    exercise: Exercise,
    engine: Path,
    copies: Path = COPIES,
    *,
    whole: bool = False,
) -> str:
    """Put the stub back into the engine's files; return what was done, and where the copies are.

    Nothing but the bodies of the exercise changes, or the ``whole`` of its files goes back. Raises
    ValueError where a file has no such body, or cannot be read; then nothing has changed.
    """
    if not exercise.edit:
        raise ValueError(f"{exercise.id} is answered in answers.md, and has no stub to put back")
    alone = replace(chapter, exercises=[exercise])
    files = [engine / chapter.name / name for name in alone.edited_files]
    if whole:
        stubs = [_whole_stub(chapter, file).encode() for file in files]
    else:
        stubs = [_with_stub(file, messages_of(alone, file.name), exercise) for file in files]
    done = []
    for file, stub in zip(files, stubs, strict=True):
        now = file.read_bytes() if file.exists() else b""
        if stub == now:
            done.append(f"{_short(file)} has the stub already")
            continue
        names = "all of it" if whole else ", ".join(messages_of(alone, file.name))
        if now:
            copy = _keep(file, now, copies / chapter.name)
        file.write_bytes(stub)
        done.append(f"{exercise.id} {exercise.title} is reset in {_short(file)}: {names}")
        done.append(f"the file as it was: {_short(copy)}" if now else "there was nothing to keep")
    return "\n".join(done)


def _with_stub(file: Path, messages: dict[str, str], exercise: Exercise) -> bytes:
    """Return what the file says, with stubs for the bodies that ``messages`` names."""
    try:
        source = file.read_bytes()
        missing = messages.keys() - functions(ast.parse(source)).keys()
        if missing:
            raise ValueError(f"it does not define {', '.join(sorted(missing))}")
        return without_bodies(cst.parse_module(source), messages).bytes
    except FileNotFoundError:
        why = "it is not there"
    except SyntaxError as error:
        why = f"it cannot be read: line {error.lineno}: {error.msg}"
    except (ValueError, cst.ParserSyntaxError) as error:
        why = str(error)
    engine, way = file.parent.parent, "take the file out of the hand-out again"
    if (ROOT / "solutions" / file.parent.name / file.name).exists():
        elsewhere = {} if engine == ROOT / "chapters" else {"ENGINE": str(engine)}
        back = command("reset", EX=exercise.id, WHOLE="1", **elsewhere)
        way = f"put the whole file back (a copy is kept): {back}"
    raise ValueError(f"nothing is reset in {_short(file)}, for {why}. Mend that, or {way}")


def _whole_stub(chapter: Chapter, file: Path) -> str:
    try:
        return stub_of(chapter, file.name)
    except FileNotFoundError:
        raise ValueError(
            f"the whole of {file.name} cannot be put back: this folder has no reference to make it "
            "from. Take the file out of the hand-out again"
        ) from None


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
