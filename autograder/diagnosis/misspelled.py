"""Find the name that a student probably meant, in the process that knows the existing names."""

from __future__ import annotations

import builtins
import re
import sys
from dataclasses import dataclass, field
from types import FrameType, ModuleType, TracebackType
from typing import Any

from autograder.text.similar import LONGEST, nearest

BUILT_IN = 0.8  # how similar a built-in name must be before we suggest it
MOST_SLOTS = 20
ATTRIBUTE = re.compile(r"'(\w+)' object has no attribute '(\w+)'")
IMPORTED = re.compile(r"cannot import name '(\w+)'")


@dataclass(frozen=True)
class Unknown:
    """A name or attribute that the student's code uses but that does not exist."""

    name: str
    of: str = ""  # the type or file that lacks the name, or "" for a variable
    nearest: str = ""  # the most similar name that exists
    slots: list[str] = field(default_factory=list)  # what the class allows, if the code sets it
    module: bool = False  # whether it is a standard library module that was not imported

    def explain(self) -> str:
        """Suggest what to use in place of the name, or return "" if nothing is similar."""
        name, near = self.name, self.nearest
        if self.slots:
            hint = f" The closest to {name} is {near}." if near else ""
            return (
                f"The class {self.of} has __slots__, so its objects can hold only these "
                f"attributes: {', '.join(self.slots)}.{hint} Store the value in one of them, in "
                "the form that its name suggests."
            )
        if self.module:
            return f"{name} is not imported. Write import {name} at the top of the file."
        where = f"{self.of} has nothing" if self.of else "Nothing here is"
        return f"{where} called {name}. Did you mean {near}?" if near else ""


def unknown_of(error: BaseException) -> Unknown | None:
    """Find the missing name that caused an error in a student's code, if one did."""
    last = innermost(error.__traceback__)
    try:
        if isinstance(error, ImportError):
            return _import(error)
        if isinstance(error, AttributeError) and last:
            return _attribute(error, last.tb_frame)
        if isinstance(error, NameError) and last and not isinstance(error, UnboundLocalError):
            return _name(error.name, last.tb_frame)
    except Exception:  # inspecting a student's object may fail
        return None
    return None


def innermost(traceback: TracebackType | None) -> TracebackType | None:
    """Return the last entry of a traceback, where the error was raised."""
    while traceback and traceback.tb_next:
        traceback = traceback.tb_next
    return traceback


def _name(name: str | None, frame: FrameType) -> Unknown | None:
    if type(name) is not str or len(name) > LONGEST:
        return None
    own = frame.f_locals.get("self")
    if own is not None and name in _attributes(own):
        return Unknown(name, nearest=f"self.{name}")
    if name in sys.stdlib_module_names:
        return Unknown(name, module=True)
    near = nearest(name, [*frame.f_locals, *frame.f_globals])
    return Unknown(name, nearest=near or nearest(name, dir(builtins), BUILT_IN))


def _attribute(error: AttributeError, frame: FrameType) -> Unknown | None:
    name, value = error.name, error.obj
    assigns = name is None or "for setting new attributes" in str(error)
    if name is None and (says := ATTRIBUTE.match(str(error))):
        # Before Python 3.13, a failed assignment does not say which object it was for.
        name = says[2]
        alike = [one for one in frame.f_locals.values() if type(one).__name__ == says[1]]
        value = alike[0] if alike else None
    if type(name) is not str or len(name) > LONGEST or value is None:
        return None
    if isinstance(value, ModuleType):
        return Unknown(name, value.__name__, nearest(name, vars(value)))
    of = (value.__name__ if isinstance(value, type) else type(value).__name__)[:LONGEST]
    if value is frame.f_locals.get("self") and name in frame.f_code.co_varnames:
        return Unknown(name, of, f"{name} without self.")
    if assigns and (slots := _slots(type(value))):
        return Unknown(name, of, nearest(name, slots, 0.5), slots)
    ours = type(value).__module__ == "builtins"  # such as a list, where a method is rarely meant
    return Unknown(name, of, nearest(name, _attributes(value), BUILT_IN if ours else 0.6))


def _import(error: ImportError) -> Unknown | None:
    says, module = IMPORTED.match(str(error)), sys.modules.get(error.name or "")
    if says is None or len(says[1]) > LONGEST or module is None:
        return None
    file = module.__name__.replace(".", "/") + ".py"
    return Unknown(says[1], file, nearest(says[1], vars(module)))


def _attributes(value: Any) -> set[str]:
    """Collect the names of an object's attributes, including those of its class."""
    kind = value if isinstance(value, type) else type(value)
    return {name for base in kind.__mro__ for name in vars(base)} | {
        *getattr(value, "__dict__", ())
    }


def _slots(kind: type) -> list[str]:
    """List what a class with __slots__ can hold, without slots that only it should use."""
    if kind.__dictoffset__:
        return []  # it accepts any attribute
    listed = [vars(base).get("__slots__", ()) for base in kind.__mro__]
    every = [slot for slots in listed for slot in ([slots] if isinstance(slots, str) else slots)]
    slots = {slot[:LONGEST] for slot in every if type(slot) is str}
    known = _attributes(kind)
    helpful = [slot for slot in slots if not slot.startswith("_") or slot.lstrip("_") in known]
    return sorted(helpful or slots)[:MOST_SLOTS]
