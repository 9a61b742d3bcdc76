"""Explain that a check failed because the student has deleted or renamed a stub."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from autograder.checks.calls import calls
from autograder.commands import command
from autograder.definitions import own_name
from autograder.diagnosis.undefined import does_not_define
from autograder.message import Kind, Message
from autograder.text.similar import nearest

# Returns the names that a module such as vector defines, or None if it cannot be read.
Defined = Callable[[str], set[str] | None]


def explain_deleted(
    message: Message, exercise: str, edits: Mapping[str, Sequence[str]], defined: Defined
) -> Message:
    """Return the message of a failed check with how to restore the stub, if one is missing.

    ``edits`` maps each exercise to the functions to write, such as vector.Vector3.dot.
    """
    # The functions that Python's error mentions come before those that the check calls.
    says = f"{message.title}\n{message.got}"  # Python's message is in one of them
    every = [(owner, name) for owner, names in edits.items() for name in names]
    own = [(exercise, name) for name in edits.get(exercise, ()) if calls(message.called, name)]
    for owner, name in [*(pair for pair in every if _is_missing(pair[1], says)), *own]:
        module, _, path = name.partition(".")
        there = defined(module)
        if there is not None and path not in there:
            likely = _how_to_restore(module, path, owner, there, edits)
            return replace(message, likely=likely, other="", kind=Kind.GONE)
    return message


def _is_missing(name: str, says: str) -> bool:
    """Return True if Python's error says that ``name``, or the class it belongs to, is missing."""
    module, *path = name.removesuffix(".setter").split(".")
    short, outer = path[-1], path[0]
    signs = [
        f"name '{short}' is not defined",
        f"cannot import name '{outer}'",
        f"/{does_not_define(module, outer)}",
        f"'{outer}' object has no attribute '{short}'",
        f"type object '{outer}' has no attribute '{short}'",
        f"property '{short}' of '{outer}' object has no setter",
    ]
    return any(re.search(rf"{re.escape(sign)}(?!\w)", says) for sign in signs)


def _how_to_restore(
    module: str, path: str, exercise: str, there: set[str], edits: Mapping[str, Sequence[str]]
) -> str:
    short = own_name(f"{module}.{path}")
    prefix = path.removesuffix(short)
    is_class_gone = prefix and not any(name.startswith(prefix) for name in there)
    if is_class_gone:
        others = sorted(name.rpartition(".")[0] for name in there if name.endswith(f".{short}"))
        renamed = next(iter(others), "")
    else:
        listed = {name.partition(".")[2] for names in edits.values() for name in names}
        others = [n.removeprefix(prefix) for n in there - listed if n.startswith(prefix)]
        renamed = nearest(short, sorted(others), 0.75)
    undo = f" If you renamed it to {renamed}, change the name back." if renamed else ""
    if is_class_gone:
        return f"{module}.py no longer has a class {prefix.rstrip('.')}.{undo}"
    return (
        f"The stub of {path} is gone: {module}.py no longer defines it.{undo} Write its def again, "
        f"or restore the whole file (a copy is kept): {command('reset', EX=exercise, WHOLE='1')}"
    )
