"""Find the interactive scenes of the lab.

Each module in a chapter's folder, such as lab/scenes/ch06_springs/, lists its scene classes in a
tuple called SCENES.
"""

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
    """A scene in the lab's catalog, with the module and the class that define it.

    Entries are read from the source code of the scene modules, so listing them does not import an
    engine.
    """

    name: str
    title: str
    chapter: int
    module: str
    kind: str  # the name of its class


@cache  # the scenes are part of the program, so they do not change while it runs
def entries() -> tuple[Entry, ...]:
    """List all scenes of the lab by chapter, in the order in which their modules list them."""
    found = []
    for file in sorted(FOLDER.glob("ch??_*/*.py")):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        titles = {node.name: _title(node) for node in tree.body if isinstance(node, ast.ClassDef)}
        for kind in _listed(tree):
            found.append(
                Entry(
                    name_of(type(kind, (), {})),
                    titles[kind],
                    int(file.parent.name[2:4]),
                    f"lab.scenes.{file.parent.name}.{file.stem}",
                    kind,
                )
            )
    return tuple(found)


def find(name: str) -> Entry:
    """Look up a scene of the lab by its name, such as "one-spring".

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
    """Import a scene by its name, such as "one-spring", and return its class.

    This also imports the chapters of the engine that the scene uses.
    """
    entry = find(name)
    scene: type[Scene] = getattr(importlib.import_module(entry.module), entry.kind)
    return scene


def _listed(tree: ast.Module) -> list[str]:
    """Read the names listed in SCENES from the syntax tree of a module, without importing it."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "SCENES":
            return [ast.unparse(name) for name in node.value.elts]  # type: ignore[attr-defined]
    return []


def _title(node: ast.ClassDef) -> str:
    """Read the title of a scene from the syntax tree of its class.

    If the class does not define a title, return the name of the class.
    """
    for line in node.body:
        if isinstance(line, ast.Assign) and ast.unparse(line.targets[0]) == "title":
            return str(ast.literal_eval(line.value))
    return node.name
