"""Import a student's modules from bytecode that was compiled earlier.

Every check has a new worker, which imports the same modules. Compiling them only once saves time.
"""

from __future__ import annotations

import importlib.util
import marshal
from collections.abc import Mapping, Sequence
from importlib.machinery import ModuleSpec, SourceFileLoader
from types import CodeType, ModuleType


class CompiledLoader(SourceFileLoader):
    """Loads a module from bytecode that is already in memory instead of from a file."""

    def __init__(self, name: str, path: str, code: CodeType) -> None:
        super().__init__(name, path)
        self._code = code

    def get_code(self, fullname: str) -> CodeType:  # noqa: ARG002
        return self._code


class CompiledFinder:
    """An import hook that supplies the student's modules and our probes from bytecode in memory.

    ``compiled`` maps the name of a module, such as ch02_vectors.vector, to its bytecode in the
    format of ``marshal``. Loading bytecode does not run it, so even the trusted launcher can do
    that safely.
    """

    def __init__(self, compiled: Mapping[str, bytes]) -> None:
        self.specs: dict[str, ModuleSpec] = {}
        for name, data in compiled.items():
            spec = importlib.util.find_spec(name)
            code = marshal.loads(data)
            if spec is not None and spec.origin == code.co_filename:
                spec.loader = CompiledLoader(name, code.co_filename, code)
                self.specs[name] = spec

    def find_spec(
        self,
        name: str,
        path: Sequence[str] | None = None,  # noqa: ARG002
        target: ModuleType | None = None,  # noqa: ARG002
    ) -> ModuleSpec | None:
        return self.specs.get(name)
