"""Placeholders for what is missing from a student's file, so that only checks that use it fail."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from types import ModuleType
from typing import Any

from autograder.diagnosis.faults import CheckEnded
from autograder.message import Message
from autograder.text.similar import nearest


@dataclass(frozen=True)
class MissingName:
    """A function or class that a student's module should define but does not."""

    module: str
    name: str
    nearest: str = ""  # the most similar name that the module does define
    is_empty: bool = False  # whether the module defines nothing at all

    def explain(self) -> Message:
        """Build the message for a check that needs this function or class."""
        says = does_not_define(self.module, self.name, is_empty=self.is_empty)
        return Message(says, likely=f"Did you mean {self.nearest}?" if self.nearest else "")


class MissingNameError(CheckEnded):
    """Raised when a check uses a function or class that the student's module does not define."""

    def __init__(self, missing: MissingName, message: Message) -> None:
        super().__init__(message)
        self.missing = missing


def does_not_define(module: str, name: str, *, is_empty: bool = False) -> str:
    """Return a message such as "ch02_vectors/vector.py does not define Vector3"."""
    empty = " is empty and" if is_empty else ""
    return f"{file_of(module)}{empty} does not define {name}"


def file_of(module: str) -> str:
    """Convert a module's name to the path of its file, such as ch02_vectors/vector.py."""
    return module.replace(".", "/") + ".py"


def broken_module(name: str, why: Message) -> ModuleType:
    """Create a module from which checks can import any name. A check that calls it ends."""
    module = ModuleType(name)
    module.__dict__["__getattr__"] = lambda wanted: _placeholder(MissingName(name, wanted), why)
    return module


def answer_for_missing(module: ModuleType) -> Callable[[str], Any]:
    """Create a ``__getattr__`` for a module that returns a placeholder for any missing name."""
    is_empty = all(name.startswith("__") for name in vars(module))

    def answer(name: str) -> Any:
        missing = MissingName(module.__name__, name, nearest(name, vars(module)), is_empty)
        return _placeholder(missing, missing.explain())

    return answer


def while_imported(module: str, why: Message) -> Message:
    """Build the message for a module that hung or ended the process when it was imported."""
    title = f"{file_of(module)} cannot be imported: {why.title}"
    return Message(title, where=why.where, kind=why.kind)


def _placeholder(missing: MissingName, message: Message) -> Any:
    """Create a placeholder class for a missing name. Calling it raises MissingNameError."""
    if missing.name.startswith("__"):
        raise AttributeError(missing.name)

    class MissingMeta(type):
        def __call__(cls, *args: Any, **kwargs: Any) -> Any:  # noqa: ARG002
            raise MissingNameError(missing, message)

    return MissingMeta(missing.name, (), {})
