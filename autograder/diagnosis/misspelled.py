"""Suggest the name that a student probably meant when the code uses one that does not exist.

Python's error contains only the missing name. The existing names are known only to the process that
ran the student's code. For this reason, that process finds the most similar name and reports it as
plain data.
"""

from __future__ import annotations

import builtins
import difflib
import dis
import re
import sys
from collections.abc import Iterable
from dataclasses import dataclass, field
from types import FrameType, ModuleType, TracebackType
from typing import Any

SHORTEST = 3  # letters; a shorter name would be similar to too many others
LONGEST = 100  # characters of a name
BUILT_IN = 0.8  # how similar a built-in name must be before we suggest it
MOST_SLOTS = 20
STORES = "STORE_ATTR"
ATTRIBUTE = re.compile(r"'(\w+)' object has no attribute '(\w+)'")
IMPORTED = re.compile(r"cannot import name '(\w+)'")


@dataclass(frozen=True)
class Unknown:
    """A name or attribute that the student's code uses but that does not exist.

    Attributes:
        of: The type or file that lacks the name. It is empty for a variable.
        nearest: The most similar name that exists.
        slots: The attributes that the class allows, if the code tried to set another one.
        module: True if the name is a standard library module that was not imported.
    """

    name: str
    of: str = ""
    nearest: str = ""
    slots: list[str] = field(default_factory=list)
    module: bool = False


def unknown_of(error: BaseException) -> Unknown | None:
    """Find the missing name that caused an error in a student's code.

    If the error has another cause, such as a division by zero, return None.
    """
    try:
        if isinstance(error, UnboundLocalError):
            return None
        if isinstance(error, NameError):
            return _name(error)
        if isinstance(error, AttributeError):
            return _attribute(error)
        if isinstance(error, ImportError):
            return _import(error)
    except Exception:  # inspecting a student's object may fail
        return None
    return None


def nearest(name: str, there: Iterable[str], cutoff: float = 0.6) -> str:
    """Return the existing name that is most similar to ``name``, to suggest it to the student.

    ``there`` contains the existing names. Special names such as __init__ are never suggested. If no
    name is similar enough, return an empty string.
    """
    names = [other for other in there if not (other.startswith("__") and other.endswith("__"))]
    if not SHORTEST <= len(name) <= LONGEST:
        return ""
    return next(iter(difflib.get_close_matches(name, names, 1, cutoff)), "")[:LONGEST]


def explain_unknown(unknown: Unknown) -> str:
    """Suggest to the student what to use in place of a name that does not exist.

    If there is nothing to suggest, return an empty string.
    """
    name, near = unknown.name, unknown.nearest
    if unknown.slots:
        held = ", ".join(unknown.slots)
        hint = f" The closest to {name} is {near}." if near else ""
        return (
            f"The class {unknown.of} has __slots__, so its objects can hold only these attributes: "
            f"{held}.{hint} Store the value in one of them, in the form that its name suggests."
        )
    if unknown.module:
        return f"{name} is not imported. Write import {name} at the top of the file."
    if not near:
        return ""
    where = f"{unknown.of} has nothing" if unknown.of else "Nothing here is"
    return f"{where} called {name}. Did you mean {near}?"


def _name(error: NameError) -> Unknown | None:
    frame = _innermost(error.__traceback__)
    name = error.name
    if frame is None or type(name) is not str or len(name) > LONGEST:
        return None
    own = frame.f_locals.get("self")
    there = [*frame.f_locals, *frame.f_globals]
    if own is not None and name in _attributes(own):
        return Unknown(name, nearest=f"self.{name}")
    if name in sys.stdlib_module_names:
        return Unknown(name, module=True)
    return Unknown(name, nearest=nearest(name, there) or nearest(name, dir(builtins), BUILT_IN))


def _attribute(error: AttributeError) -> Unknown | None:
    frame = _innermost(error.__traceback__)
    name, value = error.name, error.obj
    if name is None and frame and (says := ATTRIBUTE.match(str(error))):
        # Before Python 3.13, a failed assignment does not say which object it was for.
        name = says[2]
        alike = [one for one in frame.f_locals.values() if type(one).__name__ == says[1]]
        value = alike[0] if alike else None
    if type(name) is not str or len(name) > LONGEST or value is None:
        return None
    if isinstance(value, ModuleType):
        return Unknown(name, value.__name__, nearest(name, vars(value)))
    of = value.__name__ if isinstance(value, type) else type(value).__name__
    of = of[:LONGEST]
    if frame and value is frame.f_locals.get("self") and name in frame.f_code.co_varnames:
        return Unknown(name, of, f"{name} without self.")
    if frame and _assigns(error.__traceback__) and (slots := _slots(type(value))):
        return Unknown(name, of, nearest(name, slots, 0.5), slots)
    ours = type(value).__module__ == "builtins"  # such as a list, where a method is rarely meant
    return Unknown(name, of, nearest(name, _attributes(value), BUILT_IN if ours else 0.6))


def _import(error: ImportError) -> Unknown | None:
    says, module = IMPORTED.match(str(error)), sys.modules.get(error.name or "")
    if says is None or len(says[1]) > LONGEST or module is None:
        return None
    file = module.__name__.replace(".", "/") + ".py"
    return Unknown(says[1], file, nearest(says[1], vars(module)))


def innermost(traceback: TracebackType | None) -> TracebackType | None:
    """Return the innermost entry of a traceback, where the error was raised."""
    while traceback and traceback.tb_next:
        traceback = traceback.tb_next
    return traceback


def _innermost(traceback: TracebackType | None) -> FrameType | None:
    last = innermost(traceback)
    return last.tb_frame if last else None


def _assigns(traceback: TracebackType | None) -> bool:
    """Return True if an assignment to an attribute, such as p.mas = 3, raised an error."""
    traceback = innermost(traceback)
    if traceback is None:
        return False
    code = traceback.tb_frame.f_code
    opcode = code.co_code[traceback.tb_lasti]
    return code.co_name == "__setattr__" or dis.opname[opcode] == STORES


def _attributes(value: Any) -> set[str]:
    """Collect the names of an object's attributes, including those of its class."""
    kinds = value.__mro__ if isinstance(value, type) else type(value).__mro__
    names = {name for kind in kinds for name in vars(kind)}
    return names | set(getattr(value, "__dict__", ()))


def _slots(kind: type) -> list[str]:
    """List the attributes that a student may assign to, if a class limits them with __slots__.

    If the class accepts any attribute, the list is empty. A private slot such as _damping is
    internal to the class, so it is listed only if there is a property named damping. If that would
    leave no slots at all, all of them are listed.
    """
    if kind.__dictoffset__:
        return []
    slots = {slot for base in kind.__mro__ for slot in _listed(vars(base).get("__slots__", ()))}
    known = _attributes(kind)
    helpful = [slot for slot in slots if not slot.startswith("_") or slot.lstrip("_") in known]
    return sorted(helpful or slots)[:MOST_SLOTS]


def _listed(slots: Any) -> list[str]:
    return (
        [slots]
        if isinstance(slots, str)
        else [slot[:LONGEST] for slot in slots if type(slot) is str]
    )
