"""Find the name that was meant, where code uses a name or an attribute that does not exist.

The error only says what is missing. What there is instead can be seen where the code runs, so this
is found there and carried along as plain data.
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

SHORTEST = 3  # letters: any shorter name is near to too many others
LONGEST = 100  # characters of a name
BUILT_IN = 0.8  # how near a built-in name must be: print is not what iter or help stands for
MOST_SLOTS = 20
STORES = "STORE_ATTR"
ATTRIBUTE = re.compile(r"'(\w+)' object has no attribute '(\w+)'")
IMPORTED = re.compile(r"cannot import name '(\w+)'")


@dataclass(frozen=True)
class Unknown:
    """A name that is not there.

    ``of`` is the type, or the file, that lacks it; it is empty for a plain name. ``nearest`` is the
    most similar name that is there. ``slots`` are the attributes that the object can hold, where
    one that it cannot hold was assigned to. ``module`` says that the name is a module of Python's
    library that was not imported.
    """

    name: str
    of: str = ""
    nearest: str = ""
    slots: list[str] = field(default_factory=list)
    module: bool = False


def unknown_of(error: BaseException) -> Unknown | None:
    """Return what an error says is missing, None where it speaks of something else."""
    try:
        if isinstance(error, UnboundLocalError):
            return None
        if isinstance(error, NameError):
            return _name(error)
        if isinstance(error, AttributeError):
            return _attribute(error)
        if isinstance(error, ImportError):
            return _import(error)
    except Exception:  # an object of the student's may fail when it is asked what it has
        return None
    return None


def nearest(name: str, there: Iterable[str], cutoff: float = 0.6) -> str:
    """Return the most similar of these names, empty where none is similar.

    Names with two underscores at both ends are left out: nobody means one by mistake.
    """
    names = [other for other in there if not (other.startswith("__") and other.endswith("__"))]
    if not SHORTEST <= len(name) <= LONGEST:
        return ""
    return next(iter(difflib.get_close_matches(name, names, 1, cutoff)), "")[:LONGEST]


def explain_unknown(unknown: Unknown) -> str:
    """Return what to do about a name that is not there; empty where nothing is near."""
    name, near = unknown.name, unknown.nearest
    if unknown.slots:
        held = ", ".join(unknown.slots)
        hint = f" The nearest to {name} is {near}." if near else ""
        return (
            f"The class {unknown.of} has __slots__, so its objects can hold only these attributes: "
            f"{held}.{hint} Store the value in one of them, in the form that its name says."
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
        # Before Python 3.13 an assignment that fails does not say to which object.
        name = says[2]
        alike = [one for one in frame.f_locals.values() if type(one).__name__ == says[1]]
        value = alike[0] if alike else None
    if type(name) is not str or len(name) > LONGEST or value is None:
        return None
    if isinstance(value, ModuleType):
        return Unknown(name, value.__name__, nearest(name, vars(value)))
    of = value.__name__ if isinstance(value, type) else type(value).__name__
    of = of[:LONGEST]
    if frame and _assigns(error.__traceback__) and (slots := _slots(type(value))):
        return Unknown(name, of, nearest(name, slots, 0.5), slots)
    return Unknown(name, of, nearest(name, _attributes(value)))


def _import(error: ImportError) -> Unknown | None:
    says, module = IMPORTED.match(str(error)), sys.modules.get(error.name or "")
    if says is None or len(says[1]) > LONGEST or module is None:
        return None
    file = module.__name__.replace(".", "/") + ".py"
    return Unknown(says[1], file, nearest(says[1], vars(module)))


def _innermost(traceback: TracebackType | None) -> FrameType | None:
    """Return the frame in which an error was raised."""
    while traceback and traceback.tb_next:
        traceback = traceback.tb_next
    return traceback.tb_frame if traceback else None


def _assigns(traceback: TracebackType | None) -> bool:
    """Say whether the code was assigning to an attribute when the error was raised."""
    while traceback and traceback.tb_next:
        traceback = traceback.tb_next
    if traceback is None:
        return False
    code = traceback.tb_frame.f_code
    opcode = code.co_code[traceback.tb_lasti]
    return code.co_name == "__setattr__" or dis.opname[opcode] == STORES


def _attributes(value: Any) -> set[str]:
    """Return the names that an object has, or that its class knows."""
    kinds = value.__mro__ if isinstance(value, type) else type(value).__mro__
    names = {name for kind in kinds for name in vars(kind)}
    return names | set(getattr(value, "__dict__", ()))


def _slots(kind: type) -> list[str]:
    """Return what objects of a class can hold, as far as it helps; nothing for any attribute.

    A name such as _damping helps where the class has a property damping, which stands for it. Any
    other name with an underscore is for the class itself.
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
