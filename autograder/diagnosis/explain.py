"""Explain to a student why a check failed, and suggest how to fix the code."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from autograder.checks.asked import about, short_numbers
from autograder.definitions import module_that_defines
from autograder.diagnosis.faults import Fault, fault_of, is_inside, short, text_of
from autograder.diagnosis.misspelled import explain_unknown
from autograder.diagnosis.none_values import explain_none
from autograder.diagnosis.slips import PERHAPS, POWER, fact_of, slip_of
from autograder.diagnosis.undefined import file_of
from autograder.message import ExpectationError, Kind, Message, Place

ESCAPED = re.compile(
    r"\\(?:x([0-9a-f]{2})|u([0-9a-f]{4})|U(000[0-9a-f]{5}|0010[0-9a-f]{4}))"
)  # an escape sequence in a stack trace
EXERCISE = re.compile(r"Exercise ([A-Z]?\d+\.\w+)")  # in the NotImplementedError of a stub
STACK_LINE = re.compile(r'File "([^"\n]{1,500})", line (\d{1,6}) in (\S{1,100})')


def explain_exception(
    error: BaseException, engine_folders: list[Path], complete: Sequence[str] = ()
) -> Message:
    """Build the message that explains to a student why an exception ended a check.

    An exception that reports a wrong value already contains its message. For any other exception,
    the message shows the check's call, the exception, the student's line and a likely mistake.

    If the exception is a common Python error, the likely mistake is our explanation of that error.
    Otherwise it is the mistake that the check has stored in ``about``.

    ``complete`` lists modules that the student uses but did not write, such as
    ch02_vectors/arguments.py. If the exception comes from a worker process, its attribute ``fault``
    describes the original error.
    """
    fault = getattr(error, "fault", None) or fault_of(error, engine_folders)
    written = [frame for frame in fault.frames if not _is_given(frame, complete)]
    own = written or fault.frames
    if isinstance(error, AssertionError) and not own:
        return error.message if isinstance(error, ExpectationError) else Message(text_of(error))
    deepest = own[-1] if own else None
    if isinstance(error, NotImplementedError):
        return _unwritten(fault, deepest)
    # If there is no call yet, the cause was not set for this exception.
    cause, read = (about.cause, about.read) if about.call else ("", "")
    where = _in_first_file(own)
    where, deepest = (place and _with_source(place, engine_folders) for place in (where, deepest))
    line = deepest.source if deepest else ""
    likely, other = _likely(fault, cause, line, _course_import(fault, deepest, engine_folders))
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
    """Build the message that explains to a student why a module cannot be imported.

    ``complete`` lists the files that students receive as finished code. The message points to a
    line in one of these files only if the traceback contains no line that the student wrote.
    """
    file = file_of(module)
    if fault.missing_module == module:
        title = f"{file} is missing: it was not handed in, was renamed, or is in another folder"
        return Message(title, kind=Kind.BROKEN)
    text, where = fault.first_line, None
    if fault.type == "NotImplementedError":  # the module calls a stub while it is imported
        return _unwritten(fault, fault.frames[-1] if fault.frames else None)
    if fault.syntax:
        text = fault.text
        source, line, words = fault.syntax
        where = Place(source or file, line, source=words)
        title = f"{file} cannot be read: {text}"
    else:
        title = f"{file} cannot be imported: {text}"
        written = [frame for frame in fault.frames if frame.file not in complete]
        if own := written or fault.frames:
            where = _with_source(own[-1], engine_folders)
    likely, _ = _likely(fault, course=_course_import(fault, where, engine_folders))
    return Message(title, where=where, likely=likely, kind=Kind.BROKEN)


def explain_hang(stack: str, time_limit: float, engine_folders: list[Path]) -> Message:
    """Build the message for a check that ran out of time, with the line that was running.

    ``stack`` is the stack trace that the process wrote to a file. It may contain anything, because
    the student's code can write to that file too.
    """
    hung = Message(
        f"{Kind.HUNG.value} within {time_limit:g} seconds. Is there an endless loop?",
        kind=Kind.HUNG,
    )
    folders = [folder.resolve() for folder in engine_folders]
    for file, line, name in STACK_LINE.findall(stack):
        for path in (file, _unescaped(file)):  # a Windows folder such as \xfaces looks escaped
            try:
                if is_inside(path, folders):
                    return replace(hung, where=Place(short(path), int(line), _unescaped(name)))
            except (ValueError, OSError):
                continue  # not a valid file name on any system
    return hung


def _unwritten(fault: Fault, where: Place | None) -> Message:
    """Build the message for a stub that the student has not written yet."""
    says = fault.text.partition("\n")[0] or "a body raises NotImplementedError"
    named = EXERCISE.match(says)
    title, exercise = f"{Kind.UNWRITTEN.value}: {says}", named[1] if named else ""
    return Message(title, where=where, kind=Kind.UNWRITTEN, exercise=exercise)


def _unescaped(text: str) -> str:
    """Decode the escape sequences that Python writes for special characters in a stack trace."""
    return ESCAPED.sub(lambda escaped: chr(int(escaped[escaped.lastindex or 0], 16)), text)


def _likely(fault: Fault, cause: str = "", line: str = "", course: str = "") -> tuple[str, str]:
    """Guess which mistake caused an exception in a student's code.

    Return the most likely mistake and a second possibility. Either may be an empty string.

    If the exception clearly comes from a mistake in the use of Python, only that mistake is
    returned. What Python's error proves comes before ``cause``, the mistake that the check
    suggests, and a guess comes after it. If the exception comes from a ``raise`` statement in the
    student's ``line``, only ``cause`` is returned. ``course`` is the import that would make an
    undefined name known.
    """
    if course:
        return course, ""
    text = fault.first_line
    meant = explain_unknown(fault.unknown) if fault.unknown else ""
    if slip := meant or slip_of(text):
        return slip, ""
    if cause and f"raise {text.partition(':')[0]}" in line:
        return cause, ""
    if text.startswith("TypeError") and "^" in line:
        return POWER, ""
    if fact := explain_none(fault.none) if fault.none else fact_of(text):
        return fact, cause
    perhaps = next((slip for sign, slip in PERHAPS if sign in text), "")
    return (cause, perhaps) if cause else (perhaps, "")


def _in_first_file(frames: list[Place]) -> Place | None:
    """Return the deepest line in the file whose code the check called.

    The error itself may come from a function of another file that this line calls.
    """
    own = [frame for frame in frames if frame.file == frames[0].file]
    return own[-1] if own else None


def _course_import(fault: Fault, place: Place | None, engine_folders: list[Path]) -> str:
    """Return the import that an undefined name needs, if the course defines the name."""
    if not (place and fault.unknown and fault.type == "NameError"):
        return ""
    module = module_that_defines(fault.unknown.name, place.file, engine_folders)
    if not module:
        return ""
    name = fault.unknown.name
    return f"{name} is not imported. Write from {module} import {name} at the top of the file."


def _is_given(place: Place, complete: Sequence[str]) -> bool:
    """Return True if an exception was raised in code that the student did not write.

    The mistake is then in the student's line that called this code. Constructors are included,
    because students never write them.
    """
    return place.function in ("__init__", "__setattr__") or place.file in complete


def _with_source(place: Place, engine_folders: list[Path]) -> Place:
    """Return ``place`` with the text of its source line, so that the failure message can show it.

    The line is read from the first folder in ``engine_folders`` that contains the file.
    """
    for folder in engine_folders:
        file = folder / place.file
        if file.is_file():
            lines = file.read_text(encoding="utf-8", errors="replace").splitlines()
            line = lines[place.line - 1].strip() if 0 < place.line <= len(lines) else ""
            return replace(place, source=line[:200])
    return place
