"""Turn what went wrong into the sentences that a student reads."""

from __future__ import annotations

import re
import traceback
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from types import CodeType

# Slips of Python that say little by themselves, by a part of what Python says. They come before
# the cause that the check has at hand, which speaks of physics.
SLIPS = (
    ("SystemExit", "the code asks Python to stop: take sys.exit, exit or quit out"),
    ("reading from stdin", "the code waits for somebody to type: take input or breakpoint out"),
    (
        "No module named",
        "the engine uses Python's standard library alone; a chapter's module is imported with its "
        "folder, as in from ch02_vectors.vector import Vector3",
    ),
    (
        "must be a Vector3, got None",
        "a method that works in place returns None: do not assign that",
    ),
    ("has no setter", "a property without a setter is read, and never assigned"),
    ("for ^", "a power is written **"),
    ("'tuple'", "a function with several results gives a tuple: take it apart first"),
    ("NoneType", "something gave nothing back where a value was wanted: is a return missing?"),
    (
        "maximum recursion",
        "something calls itself: an operator, a method, or a setter that assigns its own name",
    ),
    ("is not defined", "a name is misspelt, or its import is missing at the top of the file"),
    ("local variable", "a name is read before it has a value"),
    (
        "positional argument",
        "count the arguments: is self missing in a def, or one too many given?",
    ),
    ("unexpected keyword", "an argument of the def has another name than its docstring says"),
    ("is not callable", "what is called here is no function: a property, or a name used twice?"),
    ("and 'method'", "a method is named but not called: its brackets are missing"),
    ("values to unpack", "another number of results is wanted: the docstring says which"),
    ("cannot unpack", "another number of results is wanted: the docstring says which"),
    ("has no attribute", "a name is misspelt, or this is not the type that you think"),
    ("can't decode", "save the file as UTF-8 in your editor"),
)
ESCAPED = re.compile(r"\\(?:x([0-9a-f]{2})|u([0-9a-f]{4})|U([0-9a-f]{8}))")  # as stacks have it
STACK_LINE = re.compile(r'File "(.+)", line (\d+) in (\S+)')


def explain_exception(
    error: BaseException, engine_folders: list[Path], complete: Sequence[str] = ()
) -> str:
    """Return what a check that ended with this exception tells the student.

    A failed expectation has its own words. For other exceptions: what the check was calling, the
    exception, the student's line, and the cause that Python or the check suggests. ``complete``
    are modules such as ch03_laws_of_motion/arguments.py that the student only calls.
    """
    frames = [*traceback.walk_tb(error.__traceback__)]
    own = [pair for pair in frames if _is_inside(pair[0].f_code.co_filename, engine_folders)]
    written = [pair for pair in own if not _is_given(pair[0].f_code, complete)]
    own = written or own
    where = ""
    if own:
        code = own[-1][0].f_code
        where = _place(code.co_filename, own[-1][1], code.co_name)
    if isinstance(error, AssertionError) and not own:
        return _text(error)
    if isinstance(error, NotImplementedError):
        message = _text(error) or "a body raises NotImplementedError"
        return f"not written yet: {message}" + (f"\nwhere     {where}" if where else "")
    words: dict[str, str] = {}  # a check keeps what it calls, the likely cause and where to read
    for frame, _ in frames:
        local = frame.f_locals
        if Path(frame.f_code.co_filename).name.startswith("test_") and "call" in local:
            words = {name: str(local[name]) for name in ("call", "cause", "read") if name in local}
    text = _first_line(error)
    lines = [f"called    {words['call']}"] if "call" in words else []
    lines.append(f"got       {text}")
    if where:
        source = traceback.extract_tb(error.__traceback__)[frames.index(own[-1])].line
        lines.append(f"where     {where}: {source}")
    if likely := _slip(text) or words.get("cause"):
        lines.append(f"likely    {likely}")
    if "read" in words:
        lines.append(f"read      {words['read']}")
    return "\n".join(lines)


def explain_import(error: BaseException, module: str, engine_folders: list[Path]) -> str:
    """Return why a student's module cannot be imported."""
    file = module.replace(".", "/") + ".py"
    if isinstance(error, ModuleNotFoundError) and error.name == module:
        return f"{file} is missing: not handed in, renamed, or in another folder"
    text, where = _first_line(error), ""
    if isinstance(error, SyntaxError):
        text = str(error.msg)
        source = Path(error.filename or file)
        if error.lineno:
            where = f"{source.parent.name}/{source.name}, line {error.lineno}"
            where += f": {(error.text or '').strip()}"
        message = f"{file} cannot be read: {text}"
    else:
        message = f"{file} cannot be imported: {text}"
        for summary in traceback.extract_tb(error.__traceback__):
            if _is_inside(summary.filename, engine_folders):
                where = f"{_place(summary.filename, summary.lineno, summary.name)}: {summary.line}"
    if where:
        message += f"\nwhere     {where}"
    if likely := _slip(text):
        message += f"\nlikely    {likely}"
    return message


def explain_hang(stack: str, time_limit: float, engine_folders: list[Path]) -> str:
    """Return where a process was when its time was up, from the stack that it left behind."""
    message = f"did not end within {time_limit:g} seconds: an endless loop?"
    stack = ESCAPED.sub(lambda escaped: chr(int(escaped[escaped.lastindex or 0], 16)), stack)
    for file, line, name in STACK_LINE.findall(stack):
        if _is_inside(file, engine_folders):
            return f"{message}\nwhere     {_place(file, int(line), name)}"
    return message


def _slip(text: str) -> str | None:
    return next((cause for sign, cause in SLIPS if sign in text), None)


def _is_given(code: CodeType, complete: Sequence[str]) -> bool:
    """Say whether code was there before the student came: only its callers can be wrong."""
    file = Path(code.co_filename).as_posix()
    return code.co_name == "__setattr__" or any(file.endswith(name) for name in complete)


def _is_inside(file: str, folders: list[Path]) -> bool:
    parents = _parents(file)
    return any(folder in parents for folder in folders)


@cache
def _parents(file: str) -> list[Path]:
    return list(Path(file).resolve().parents)


def _place(file: str, line: int | None, name: str) -> str:
    return f"{Path(file).parent.name}/{Path(file).name}, line {line}, in {name}"


def _text(error: BaseException) -> str:
    try:
        return str(error).strip()
    except BaseException:  # a student's exception may fail in its own __str__
        return "(its message cannot be shown)"


def _first_line(error: BaseException) -> str:
    first = (_text(error).splitlines() or [""])[0][:500]
    return f"{type(error).__name__}: {first}" if first else type(error).__name__
