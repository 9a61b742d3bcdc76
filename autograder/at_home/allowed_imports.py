"""Let a student's code import only Python's standard library and the chapters.

The grader has no other packages, and its chapters contain only the files that students hand in or
receive from us. This module is used at home and in the grader, so any other import fails with the
same message in both, whatever is installed on the machine.
"""

from __future__ import annotations

import builtins
import importlib
import importlib.util
import re
import sys
from collections.abc import Mapping, Sequence
from types import ModuleType
from typing import Any

from autograder.at_home.students_code import StudentsCode
from autograder.diagnosis.faults import GOING_FURTHER

LIBRARY = sys.stdlib_module_names | {"__main__"}
CHAPTER = re.compile(r"ch\d\d_\w+")


def limit_imports(code: StudentsCode) -> None:
    """Block imports in the student's code that would fail in the grader.

    Our own code can still import any package.
    """
    real_import, real_import_module = builtins.__import__, importlib.import_module

    def guarded_import(
        name: str,
        globals: Mapping[str, Any] | None = None,  # noqa: A002 - Python's own names
        locals: Mapping[str, Any] | None = None,  # noqa: A002
        fromlist: Sequence[str] | None = (),
        level: int = 0,
    ) -> ModuleType:
        if (level or name.partition(".")[0] not in LIBRARY) and code.is_calling():
            package = (globals or {}).get("__package__")
            _refuse(code, "." * level + name, package, fromlist or ())
        return real_import(name, globals, locals, fromlist or (), level)

    def guarded_import_module(name: str, package: str | None = None) -> ModuleType:
        if name.partition(".")[0] not in LIBRARY and code.is_calling():
            _refuse(code, name, package, ())
        return real_import_module(name, package)

    builtins.__import__ = guarded_import
    importlib.import_module = guarded_import_module


def _refuse(code: StudentsCode, name: str, package: str | None, fromlist: Sequence[str]) -> None:
    """Raise ImportError if an import in the student's code would fail in the grader.

    The student sees the same error as in the grader.
    """
    if name.startswith("."):
        try:
            name = importlib.util.resolve_name(name, package)
        except ImportError:
            return  # Python itself raises the error
    top, _, rest = name.partition(".")
    if top in LIBRARY:
        return
    if not CHAPTER.fullmatch(top):
        raise ModuleNotFoundError(f"No module named {top!r}", name=top)
    package, folder = top, ""
    if rest.partition(".")[0] == GOING_FURTHER:
        package, folder = f"{top}.{GOING_FURTHER}", f"{GOING_FURTHER}/"
        rest = rest.partition(".")[2]
    module = rest.partition(".")[0]
    if module and not code.is_graded(top, f"{folder}{module}.py"):
        missing = f"{package}.{module}"
        raise ModuleNotFoundError(f"No module named {missing!r}", name=missing)
    for wanted in () if module else fromlist:
        if not (wanted.startswith(("_", "*")) or code.is_graded(top, f"{folder}{wanted}.py")):
            raise ImportError(
                f"cannot import name {wanted!r} from {package!r} (unknown location)", name=package
            )
