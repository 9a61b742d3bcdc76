"""Import modules from compiled code, so that not every worker has to compile them again."""

from __future__ import annotations

import importlib.util
import marshal
from collections.abc import Mapping, Sequence
from importlib.machinery import ModuleSpec, SourceFileLoader
from types import CodeType, ModuleType


class CompiledLoader(SourceFileLoader):
    """Loads a module from compiled code in memory, much as Python loads one from a .pyc file."""

    def __init__(self, name: str, path: str, code: CodeType) -> None:
        super().__init__(name, path)
        self._code = code

    def get_code(self, fullname: str) -> CodeType:  # noqa: ARG002
        return self._code


class CompiledFinder:
    """Finds the modules of the engine and the probes that have already been compiled.

    ``compiled`` holds each module's marshaled code. Unmarshaling it is safe, because the code does
    not run until a worker imports the module.
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
