"""Put a stop at the beginning of each of a student's functions while its module is imported.

The stop is one statement, ``if call_counts(): breakpoint()``, in front of the function's own
code. It works with pdb as well as with the debugger of an editor, and the line numbers stay those
of the file. The file itself does not change.
"""

from __future__ import annotations

import ast
import builtins
import sys
from collections.abc import Sequence
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import CodeType, FrameType

from autograder.definitions import functions
from autograder.diagnosis.faults import is_inside, short

NAME = "__stop_at_this_call__"  # of a built-in function
LOAD = SourceFileLoader.get_code


class Stops:
    """Counts the calls of a student's functions, and says at which of them to stop.

    ``edits`` names the functions that count, such as ch02_vectors/vector.Vector3.cross. A call
    counts only if no other counted call is still running. The stop is at call number ``at``.
    """

    def __init__(self, edits: Sequence[str], folders: Sequence[Path]) -> None:
        self.edits = set(edits)
        self.folders = [folder.resolve() for folder in folders]
        self.calls = 0
        self.at = 0

    def install(self) -> None:
        """Put stops into all of the student's modules that are imported from now on."""
        setattr(builtins, NAME, self.count)
        setattr(SourceFileLoader, "get_code", lambda loader, name: self.get_code(loader, name))  # noqa: B010

    def count(self) -> bool:
        """Count the call of a function, and return True if it is the one to stop at."""
        frame: FrameType | None = sys._getframe(1)  # of the function itself
        while frame and (frame := frame.f_back):
            code = frame.f_code
            if f"{_module(code.co_filename)}.{code.co_qualname}" in self.edits:
                return False
        self.calls += 1
        return self.calls == self.at

    def get_code(self, loader: SourceFileLoader, fullname: str) -> CodeType | None:
        """Compile a module of the student's with stops. Python's cached bytecode has none."""
        path = loader.path
        if not is_inside(path, self.folders):
            return LOAD(loader, fullname)
        tree = ast.parse(loader.get_data(path), path)
        for name, node in functions(tree).items():
            if f"{_module(path)}.{name}" in self.edits:
                first = min(1, len(node.body) - 1) if ast.get_docstring(node) is not None else 0
                (stop,) = ast.parse(f"if {NAME}(): breakpoint()").body
                # On the line of the def, because a debugger goes on to the next line.
                for part in ast.walk(stop):
                    if isinstance(part, ast.stmt | ast.expr):
                        part.lineno = part.end_lineno = node.lineno
                node.body.insert(first, stop)
        return compile(tree, path, "exec", dont_inherit=True)


def _module(path: str) -> str:
    """Return a file's folder and name, such as ch02_vectors/vector."""
    return short(path).removesuffix(".py")
