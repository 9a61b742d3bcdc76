"""Find the modules that Python files import, directly or indirectly, without importing them."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterable, Iterator
from pathlib import Path


def imported_by(
    roots: Iterable[Path], folders: Iterable[Path], packages: Collection[str]
) -> list[Path]:
    """Find all files of ``packages`` that ``roots`` import, directly or indirectly.

    ``folders`` contain the packages. A root that belongs to one of them is included in the result.
    """
    folders = list(folders)
    found: set[Path] = set()
    waiting = list(roots)
    while waiting:
        file = waiting.pop()
        for name in imports_of(file, folders):
            for module in _files(name, folders) if name.split(".")[0] in packages else ():
                if module not in found:
                    found.add(module)
                    waiting.append(module)
        own = file.relative_to(folder).parts[0] if (folder := _home(file, folders)) else ""
        if own in packages:
            found.add(file)
    return sorted(found)


def imports_of(file: Path, folders: Iterable[Path]) -> Iterator[str]:
    """Yield the names of all modules that a Python file may import.

    `from a import b` may import a module or another object, so it yields both `a` and `a.b`.
    """
    for node in ast.walk(ast.parse(file.read_bytes())):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            if node.level and (home := _home(file, folders)):
                package = file.relative_to(home).parts[: -node.level]
                base = ".".join([*package, *filter(None, [node.module])])
            yield base
            yield from (f"{base}.{alias.name}" for alias in node.names)


def _home(file: Path, folders: Iterable[Path]) -> Path | None:
    return next((folder for folder in folders if file.is_relative_to(folder)), None)


def _files(name: str, folders: Iterable[Path]) -> Iterator[Path]:
    """Yield the file of a module, and the __init__.py files of the packages that contain it."""
    parts = name.split(".")
    for count in range(1, len(parts) + 1):
        for folder in folders:
            place = folder.joinpath(*parts[:count])
            for file in (place / "__init__.py", place.with_suffix(".py")):
                if file.is_file():
                    yield file
