"""Put a stop at the beginning of each of a student's functions while its module is imported.

The stop is one statement, ``if call_counts(...): breakpoint()``, in front of the function's own
code. It works with pdb as well as with the debugger of an editor, and the line numbers stay those
of the file. The file itself does not change.
"""

from __future__ import annotations

import ast
import builtins
import sys
from collections.abc import Sequence
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from pathlib import Path
from types import CodeType, FrameType, ModuleType

from autograder.diagnosis.faults import is_inside, short

NAME = "__stop_at_this_call__"  # of a built-in function


class Stops:
    """Counts the calls of a student's functions, and says at which of them to stop.

    ``edits`` names the functions that count, such as ch02_vectors/vector.Vector3.cross. A call
    counts only if no other counted call is still running.

    Attributes:
        calls: The number of calls so far.
        at: The number of the call to stop at, or 0 to stop at none.
    """

    def __init__(self, edits: Sequence[str], folders: Sequence[Path]) -> None:
        self.edits = set(edits)
        self.folders = [folder.resolve() for folder in folders]
        self.calls = 0
        self.at = 0

    def install(self) -> None:
        """Put stops into all of the student's modules that are imported from now on."""
        setattr(builtins, NAME, self.count)
        sys.meta_path.insert(0, self)
        sys.dont_write_bytecode = True

    def count(self, name: str) -> bool:
        """Count the call of a function, and return True if it is the one to stop at."""
        if name not in self.edits or self._is_inside_another(sys._getframe(2)):
            return False
        self.calls += 1
        return self.calls == self.at

    def _is_inside_another(self, frame: FrameType | None) -> bool:
        while frame is not None:
            code = frame.f_code
            if f"{_module(code.co_filename)}.{code.co_qualname}" in self.edits:
                return True
            frame = frame.f_back
        return False

    def find_spec(
        self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Find a module as Python does, but load it with stops if it is the student's."""
        spec = PathFinder.find_spec(name, path, target) if "." in name else None
        if spec and spec.origin and is_inside(spec.origin, self.folders):
            spec.loader = WithStops(name, spec.origin)
            return spec
        return None


class WithStops(SourceFileLoader):
    """Loads a module from its source, with stops in its functions."""

    def get_code(self, fullname: str) -> CodeType:  # noqa: ARG002
        """Return the module's code. Python's cached bytecode has no stops."""
        return self.source_to_code(self.get_data(self.path), self.path)

    def source_to_code(self, data: bytes, path: str) -> CodeType:  # type: ignore[override]
        """Compile the module with stops."""
        tree = ast.parse(data, path)
        _add_stops(tree, _module(path))
        return compile(tree, path, "exec", dont_inherit=True)


def _module(path: str) -> str:
    """Return a file's folder and name, such as ch02_vectors/vector."""
    return short(path).removesuffix(".py")


def _add_stops(node: ast.AST, name: str) -> None:
    """Put a stop into each function below a node, after the function's docstring."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.ClassDef):
            _add_stops(child, f"{name}.{child.name}")
        elif isinstance(child, ast.FunctionDef):
            setter = any(
                isinstance(d, ast.Attribute) and d.attr == "setter" for d in child.decorator_list
            )
            own = f"{name}.{child.name}{'.setter' if setter else ''}"
            first = min(1, len(child.body) - 1) if ast.get_docstring(child) is not None else 0
            (stop,) = ast.parse(f"if {NAME}({own!r}): breakpoint()").body
            # On the line of the def, because a debugger goes on to the next line.
            for part in ast.walk(stop):
                if isinstance(part, ast.stmt | ast.expr):
                    part.lineno = part.end_lineno = child.lineno
            child.body.insert(first, stop)
