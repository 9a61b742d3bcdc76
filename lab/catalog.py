"""Find the lab's scenes, which each module in lab/scenes/ lists in a tuple called SCENES."""

from __future__ import annotations

import ast
import importlib
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from lab.scene import Scene, name_of

FOLDER = Path(__file__).parent / "scenes"


@dataclass(frozen=True)
class Entry:
    """A scene that the lab can open, and the module that defines it.

    Entries are read from the source of the scene modules, so no engine has to be imported.
    """

    name: str
    title: str
    chapter: int
    module: str
    kind: str  # the name of its class


@cache  # the scenes are part of the program, so they do not change while it runs
def entries() -> tuple[Entry, ...]:
    """Return the entries of all scenes, by chapter and then in the order of their modules."""
    found = []
    for file in sorted(FOLDER.glob("ch??_*.py")):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        titles = {node.name: _title(node) for node in tree.body if isinstance(node, ast.ClassDef)}
        for kind in _listed(tree):
            found.append(
                Entry(
                    name_of(type(kind, (), {})),
                    titles[kind],
                    int(file.name[2:4]),
                    f"lab.scenes.{file.stem}",
                    kind,
                )
            )
    return tuple(found)


def find(name: str) -> Entry:
    """Return the entry of the scene with this name.

    Raises:
        ValueError: The scene does not exist. The message lists all scenes.
    """
    for entry in entries():
        if entry.name == name:
            return entry
    names = ", ".join(entry.name for entry in entries())
    wrong = f"there is no scene {name!r}" if name else "name a scene"
    raise ValueError(f"{wrong}; choose from {names}")


def load(name: str) -> type[Scene]:
    """Import a scene, along with the chapters of the engine that it uses, and return its class."""
    entry = find(name)
    scene: type[Scene] = getattr(importlib.import_module(entry.module), entry.kind)
    return scene


def _listed(tree: ast.Module) -> list[str]:
    """Return the class names listed in a module's SCENES."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "SCENES":
            return [ast.unparse(name) for name in node.value.elts]  # type: ignore[attr-defined]
    return []


def _title(node: ast.ClassDef) -> str:
    """Return the title of a scene class, or the name of the class if it has no title."""
    for line in node.body:
        if isinstance(line, ast.Assign) and ast.unparse(line.targets[0]) == "title":
            return str(ast.literal_eval(line.value))
    return node.name
