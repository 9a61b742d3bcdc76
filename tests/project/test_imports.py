"""Imports go downwards only, and no files import each other in a circle."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from graphlib import TopologicalSorter
from pathlib import Path

from autograder.manifest import ROOT

# From the bottom to the top. A room imports only from itself and from the rooms below it.
ROOMS = ("autograder", "scenes", "plots", "studies", "lab", "web")
FOLDERS = ("solutions", "chapters", *ROOMS)


def modules() -> dict[str, Path]:
    """Return the files of all modules by name, but for the tuned engine, which replaces some."""
    found: dict[str, Path] = {}
    for folder in FOLDERS:
        for file in sorted((ROOT / folder).rglob("*.py")):
            parts = file.relative_to(ROOT).with_suffix("").parts
            name = ".".join(parts[folder in ("solutions", "chapters") :])
            if "tuned" not in parts:
                found.setdefault(name.removesuffix(".__init__"), file)
    return found


MODULES = modules()


def imported(file: Path) -> Iterator[str]:
    """Yield the names of our modules that a file imports, anywhere in it."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name in MODULES)
        elif isinstance(node, ast.ImportFrom) and node.module:
            names = {f"{node.module}.{alias.name}" for alias in node.names} & MODULES.keys()
            yield from names or {node.module} & MODULES.keys()


def test_no_files_import_each_other_in_a_circle() -> None:
    graph = {name: {*imported(file)} - {name} for name, file in MODULES.items()}
    TopologicalSorter(graph).prepare()  # raises CycleError with the circle


def test_no_files_of_the_pages_import_each_other_in_a_circle() -> None:
    graph = {}
    for file in [*ROOT.glob("web/page/**/*.js"), *ROOT.glob("lab/page/**/*.js")]:
        text = file.read_text(encoding="utf-8")
        found = re.findall(r'(?m)^(?:import|export) [^;"]*"(\.[^"]+)"', text)
        graph[file] = {(file.parent / path).resolve() for path in found}
    assert any(graph.values())
    TopologicalSorter(graph).prepare()


def test_a_room_imports_only_from_the_rooms_below() -> None:
    upwards = {
        f"{name} imports {other}"
        for name, file in MODULES.items()
        if (room := name.split(".")[0]) in ROOMS
        for other in imported(file)
        if other.split(".")[0] in ROOMS[ROOMS.index(room) + 1 :]
    }
    assert upwards == set()
