"""Give check files placeholders for the functions and classes of a student.

A check file can import the student's code as usual, although it runs only in workers, because an
import hook answers with placeholders. Each use of a placeholder becomes a request to the worker.
"""

from __future__ import annotations

import importlib.abc
import re
from collections.abc import Callable, Sequence
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

from autograder.diagnosis.faults import GOING_FURTHER
from autograder.isolation.handles import ObjectHandle, Session

PACKAGE = re.compile(rf"ch\d\d_\w+(\.{GOING_FURTHER})?")
CHAPTER_MODULE = re.compile(rf"{PACKAGE.pattern}(\.\w+)?")


# Returns the session with the worker of the current check, or None outside a check.
Current = Callable[[], Session | None]


def placeholder(current: Current, module: str, name: str) -> ObjectHandle:
    """Create a placeholder for a name in a student's module, such as Vector3.

    It serves all checks of a file. In each check, it is a handle on the class or function in the
    worker of that check.
    """

    def session() -> Session:
        if (found := current()) is None:
            raise AttributeError(f"{module}.{name} is used while no check is running")
        return found

    return ObjectHandle(session, {"name": [module, name]})


class ChapterFinder(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """An import hook that gives check files placeholders when they import a chapter."""

    def __init__(self, current: Current) -> None:
        self.current = current

    def find_spec(
        self,
        name: str,
        path: Sequence[str] | None,  # noqa: ARG002
        target: ModuleType | None = None,  # noqa: ARG002
    ) -> ModuleSpec | None:
        if CHAPTER_MODULE.fullmatch(name):
            return ModuleSpec(name, self, is_package=bool(PACKAGE.fullmatch(name)))
        return None

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        if spec.submodule_search_locations is None:
            return ChapterModule(self.current, spec.name)
        return ModuleType(spec.name)

    def exec_module(self, module: ModuleType) -> None:
        """Do not execute the module, because student code may run only in workers."""


class ChapterModule(ModuleType):
    """The stand-in that a check file gets when it imports a student's module.

    Outside a check, its attributes are placeholders. During a check, they are read from the worker.
    """

    def __init__(self, current: Current, name: str) -> None:
        super().__init__(name)
        self._current = current

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        session = self._current()
        if session is None:
            return placeholder(self._current, self.__name__, name)
        return session.ask("name", self.__name__, name)
