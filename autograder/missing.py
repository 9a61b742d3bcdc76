"""What stands for modules that cannot be imported and names that they do not define.

Whatever uses such a name fails with the sentence that says so, where it is used and not before.
"""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType
from typing import Any

from autograder.faults import CheckEnded
from autograder.nearest import nearest


class MissingNameError(CheckEnded):
    """A check uses a name that is not there."""


def broken_module(name: str, message: str) -> ModuleType:
    """Return a module whose every name is missing, for this reason."""
    module = ModuleType(name)
    module.__dict__["__getattr__"] = lambda wanted: _missing_name(wanted, message)
    return module


def answer_for_missing(module: ModuleType) -> Callable[[str], Any]:
    """Return what answers for the names that a student's module does not define."""
    file = module.__name__.replace(".", "/") + ".py"
    empty = all(name.startswith("__") for name in vars(module))
    says = f"{file} is empty and" if empty else file

    def answer(name: str) -> Any:
        near = nearest(name, vars(module))
        meant = f"\nlikely    Did you mean {near}?" if near else ""
        return _missing_name(name, f"{says} does not define {name}{meant}")

    return answer


def _missing_name(name: str, message: str) -> Any:
    """Return what stands for a name that is not there: a class, or a function, that fails."""
    if name.startswith("__"):
        raise AttributeError(name)

    class MissingMeta(type):
        def __call__(cls, *args: Any, **kwargs: Any) -> Any:  # noqa: ARG002
            raise MissingNameError(message)

    return MissingMeta(name, (), {})
