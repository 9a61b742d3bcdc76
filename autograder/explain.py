"""Turn what went wrong into the sentences that a student reads."""

from __future__ import annotations

import re
import traceback
from functools import cache
from pathlib import Path
from typing import Any

LIKELY = (
    ("SystemExit", "the code asks Python to stop: take sys.exit, exit or quit out"),
    ("NoneType", "a method gave nothing back where a value was wanted: is a return missing?"),
    ("maximum recursion depth", "a method calls itself, perhaps through an operator"),
    ("local variable", "a name is read before it has a value"),
    ("has no attribute", "a method is missing, or spelt in another way"),
)
STACK_LINE = re.compile(r'File "(.+)", line (\d+) in (\S+)')


def explain_exception(error: BaseException, engine_folders: list[Path]) -> str:
    """Return what a check that ended with this exception tells the student.

    The checks' own messages stay as they are. For any other exception: the line of the check, the
    numbers that it had drawn, the exception and the student's line.
    """
    frames = list(traceback.walk_tb(error.__traceback__))
    summaries = traceback.extract_tb(error.__traceback__)
    own = [summary for summary in summaries if _is_inside(summary.filename, engine_folders)]
    where = _place(own[-1].filename, own[-1].lineno, own[-1].name) if own else ""
    if isinstance(error, AssertionError) and not own:
        return str(error)
    if isinstance(error, NotImplementedError):
        return f"not written yet: {error}" + (f"\nopen      {where}" if where else "")
    lines = []
    checks = [i for i, s in enumerate(summaries) if Path(s.filename).name.startswith("test_")]
    if checks:
        lines.append(f"called    {(summaries[checks[-1]].line or '').strip().rstrip(',')}")
        if drawn := _plain_values(frames[checks[-1]][0].f_locals):
            lines.append(f"with      {drawn}")
    text = _first_line(error)
    lines.append(f"got       {text}")
    if own:
        lines.append(f"where     {where}: {own[-1].line}")
    lines += [f"likely    {cause}" for sign, cause in LIKELY if sign in text][:1]
    return "\n".join(lines)


def explain_import(error: BaseException, module: str, engine_folders: list[Path]) -> str:
    """Return why a student's module cannot be imported."""
    file = module.replace(".", "/") + ".py"
    if isinstance(error, SyntaxError):
        line = (error.text or "").strip()
        where = f"{Path(error.filename or file).name}, line {error.lineno}"
        return f"{file} cannot be read: {error.msg}\nwhere     {where}: {line}"
    if isinstance(error, ModuleNotFoundError) and error.name == module:
        return f"{file} was not handed in, or is not where it should be"
    own = [
        summary
        for summary in traceback.extract_tb(error.__traceback__)
        if _is_inside(summary.filename, engine_folders)
    ]
    where = f"\nwhere     {_place(own[-1].filename, own[-1].lineno, own[-1].name)}" if own else ""
    return f"{file} cannot be imported: {_first_line(error)}{where}"


def explain_hang(stack: str, time_limit: float, engine_folders: list[Path]) -> str:
    """Return where a process was when its time was up, from the stack that it left behind."""
    message = f"did not end within {time_limit:g} seconds: an endless loop?"
    for file, line, name in STACK_LINE.findall(stack):
        if _is_inside(file, engine_folders):
            return f"{message}\nwhere     {_place(file, int(line), name)}"
    return message


def _is_inside(file: str, folders: list[Path]) -> bool:
    parents = _parents(file)
    return any(folder in parents for folder in folders)


@cache
def _parents(file: str) -> list[Path]:
    return list(Path(file).resolve().parents)


def _place(file: str, line: int | None, name: str) -> str:
    return f"{Path(file).parent.name}/{Path(file).name}, line {line}, in {name}"


def _first_line(error: BaseException) -> str:
    try:
        text = str(error)
    except BaseException:  # a student's exception may fail in its own __str__
        text = "(its message cannot be shown)"
    first = text.strip().splitlines()[0][:500] if text.strip() else ""
    return f"{type(error).__name__}: {first}" if first else type(error).__name__


def _plain_values(values: dict[str, Any]) -> str:
    """Return the plain numbers and tuples among a check's variables: what it had drawn."""
    plain = {
        name: value
        for name, value in values.items()
        if type(value) in (int, float)
        or (type(value) is tuple and all(type(item) in (int, float) for item in value))
    }
    return ", ".join(f"{name} = {value}" for name, value in plain.items())
