"""Explain to a student why a check failed, and suggest how to fix the code."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from autograder.checks.asked import about, short_numbers
from autograder.definitions import module_that_defines
from autograder.diagnosis.faults import Fault, fault_of, is_inside, short, text_of
from autograder.diagnosis.slips import POWER, fact_of, guess_of, slip_of
from autograder.diagnosis.undefined import file_of
from autograder.message import ExpectationError, Kind, Message, Place

ESCAPED = re.compile(r"\\(x[0-9a-f]{2}|u[0-9a-f]{4}|U(000[0-9a-f]|0010)[0-9a-f]{4})")
EXERCISE = re.compile(r"Exercise ([A-Z]?\d+\.\w+)")  # in the NotImplementedError of a stub
STACK_LINE = re.compile(r'File "([^"\n]{1,500})", line (\d{1,6}) in (\S{1,100})')


def explain_exception(
    error: BaseException, engine_folders: list[Path], complete: Sequence[str] = ()
) -> Message:
    """Explain why an exception ended a check. The student did not write the ``complete`` files."""
    # An exception from a worker process has an attribute that describes the original error.
    fault = getattr(error, "fault", None) or fault_of(error, engine_folders)
    # If code raised it that the student did not write, the mistake is in the line that called this
    # code. Students never write constructors.
    given = ("__init__", "__setattr__")
    written = [f for f in fault.frames if f.function not in given and f.file not in complete]
    own = written or fault.frames
    if isinstance(error, AssertionError) and not own:
        return error.message if isinstance(error, ExpectationError) else Message(text_of(error))
    if isinstance(error, NotImplementedError):
        return _unwritten(fault, own)
    # The check called the code of the first file. The error itself may come from a function of
    # another file that this code calls.
    first = [frame for frame in own if frame.file == own[0].file]
    where, deepest = (_with_source(frames, engine_folders) for frames in (first, own))
    # If there is no call yet, the cause was not set for this exception.
    cause, read = (about.cause, about.read) if about.call else ("", "")
    likely, other = _likely(fault, deepest, engine_folders, cause)
    return Message(
        called=short_numbers(about.call),
        got=fault.first_line,
        where=where,
        inside=None if deepest == where else deepest,
        likely=likely,
        other=other,
        read=read,
        kind=Kind.HUNG if fault.type == "MemoryError" else Kind.FAILED,
    )


def explain_import(
    fault: Fault, module: str, engine_folders: list[Path], complete: Sequence[str] = ()
) -> Message:
    """Explain why a module cannot be imported. The student did not write ``complete`` files."""
    file = file_of(module)
    if fault.missing_module == module:
        title = f"{file} is missing: it was not handed in, was renamed, or is in another folder"
        return Message(title, kind=Kind.BROKEN)
    if fault.type == "NotImplementedError":  # the module calls a stub while it is imported
        return _unwritten(fault, fault.frames)
    if fault.syntax:
        source, line, words = fault.syntax
        where: Place | None = Place(source or file, line, source=words)
        title = f"{file} cannot be read: {fault.text}"
    else:
        title = f"{file} cannot be imported: {fault.first_line}"
        written = [frame for frame in fault.frames if frame.file not in complete]
        where = _with_source(written or fault.frames, engine_folders)
    likely, _ = _likely(fault, where, engine_folders)
    return Message(title, where=where, likely=likely, kind=Kind.BROKEN)


def explain_hang(stack: str, time_limit: float, engine_folders: list[Path]) -> Message:
    """Build the message for a check that ran out of time, from a stack that may be forged."""
    says = f"{Kind.HUNG.value} within {time_limit:g} seconds. Is there an endless loop?"
    folders = [folder.resolve() for folder in engine_folders]
    for file, line, name in STACK_LINE.findall(stack):
        for path in (file, _unescaped(file)):  # a Windows folder such as \xfaces looks escaped
            try:
                if is_inside(path, folders):
                    where = Place(short(path), int(line), _unescaped(name))
                    return Message(says, where=where, kind=Kind.HUNG)
            except (ValueError, OSError):
                continue  # not a valid file name on any system
    return Message(says, kind=Kind.HUNG)


def _unescaped(text: str) -> str:
    """Decode the special characters in a stack trace."""
    return ESCAPED.sub(lambda escaped: chr(int(escaped[1][1:], 16)), text)


def _unwritten(fault: Fault, frames: list[Place]) -> Message:
    """Build the message for a stub that the student has not written yet."""
    says = fault.text.partition("\n")[0] or "a body raises NotImplementedError"
    named = EXERCISE.match(says)
    return Message(
        f"{Kind.UNWRITTEN.value}: {says}",
        where=frames[-1] if frames else None,
        kind=Kind.UNWRITTEN,
        exercise=named[1] if named else "",
    )


def _likely(
    fault: Fault, place: Place | None, engine_folders: list[Path], cause: str = ""
) -> tuple[str, str]:
    """Return the most likely mistake behind an exception, and a second possibility, or "".

    What the error proves comes before ``cause``, which the check suggests, and a guess after it.
    """
    text, line = fault.first_line, place.source if place else ""
    if place and fault.unknown and fault.type == "NameError":
        name = fault.unknown.name
        if module := module_that_defines(name, place.file, engine_folders):
            words = f"Write from {module} import {name} at the top of the file."
            return f"{name} is not imported. {words}", ""
    if slip := (fault.unknown and fault.unknown.explain()) or slip_of(text):
        return slip, ""
    if cause and f"raise {text.partition(':')[0]}" in line:
        return cause, ""
    if text.startswith("TypeError") and "^" in line:
        return POWER, ""
    if fact := fact_of(text):
        return fact, cause
    return (cause, guess_of(text)) if cause else (guess_of(text), "")


def _with_source(frames: list[Place], engine_folders: list[Path]) -> Place | None:
    """Return the last of these places with the text of its line, for the failure message."""
    if not frames:
        return None
    place = frames[-1]
    for folder in engine_folders:
        file = folder / place.file
        if file.is_file():
            lines = file.read_text(encoding="utf-8", errors="replace").splitlines()
            line = lines[place.line - 1].strip() if 0 < place.line <= len(lines) else ""
            return replace(place, source=line[:200])
    return place
