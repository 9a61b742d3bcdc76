"""What stands for modules that cannot be imported and names that they do not define.

Whatever uses such a name fails with the message that says so, where it is used and not before.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from types import ModuleType
from typing import Any

from autograder.checks.faults import CheckEnded
from autograder.checks.nearest import nearest
from autograder.message import Message


@dataclass(frozen=True)
class MissingName:
    """A name that a module of the student's does not define, and the nearest that it does."""

    module: str
    name: str
    nearest: str = ""
    is_empty: bool = False  # the module, which defines nothing

    def explain(self) -> Message:
        """Return what a check says that uses the name."""
        says = does_not_define(self.module, self.name, is_empty=self.is_empty)
        likely = f"Did you mean {self.nearest}?" if self.nearest else ""
        return Message(says, likely=likely)


class MissingNameError(CheckEnded):
    """A check uses a name that is not there."""

    def __init__(self, missing: MissingName, message: Message) -> None:
        super().__init__(message)
        self.missing = missing


def does_not_define(module: str, name: str, *, is_empty: bool = False) -> str:
    """Return the sentence on a name that is not in a module."""
    empty = " is empty and" if is_empty else ""
    return f"{file_of(module)}{empty} does not define {name}"


def file_of(module: str) -> str:
    """Return a module's file as students know it, such as ch02_vectors/vector.py."""
    return module.replace(".", "/") + ".py"


def broken_module(name: str, why: Message) -> ModuleType:
    """Return a module whose every name is missing, for this reason."""
    module = ModuleType(name)
    module.__dict__["__getattr__"] = lambda wanted: _stand_in(MissingName(name, wanted), why)
    return module


def answer_for_missing(module: ModuleType) -> Callable[[str], Any]:
    """Return what answers for the names that a student's module does not define."""
    is_empty = all(name.startswith("__") for name in vars(module))

    def answer(name: str) -> Any:
        missing = MissingName(module.__name__, name, nearest(name, vars(module)), is_empty)
        return _stand_in(missing, missing.explain())

    return answer


def while_imported(module: str, message: Message) -> Message:
    """Return the message on a module at whose import the process hung or ended."""
    return Message(
        f"{file_of(module)}, while it is imported: {message.title}",
        where=message.where,
        kind=message.kind,
    )


def _stand_in(missing: MissingName, message: Message) -> Any:
    """Return what stands for a name that is not there: a class, or a function, that fails."""
    if missing.name.startswith("__"):
        raise AttributeError(missing.name)

    class MissingMeta(type):
        def __call__(cls, *args: Any, **kwargs: Any) -> Any:  # noqa: ARG002
            raise MissingNameError(missing, message)

    return MissingMeta(missing.name, (), {})
