"""Find the lab's scenes: the classes that have a title, in the modules in lab/scenes/chNN_*/."""

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
    """A scene in the lab's catalog, with the module and the class that define it."""

    name: str
    title: str
    chapter: int
    module: str
    kind: str  # the name of its class


@cache  # the scenes are part of the program, so they do not change while it runs
def entries() -> tuple[Entry, ...]:
    """List all scenes by chapter, from the modules' source code, so that no engine is imported."""
    found = []
    for file in sorted(FOLDER.glob("ch??_*/*.py")):
        chapter, module = file.parent.name, f"lab.scenes.{file.parent.name}.{file.stem}"
        for node in ast.parse(file.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.ClassDef) and (title := _title(node)):
                name, number = name_of(type(node.name, (), {})), int(chapter[2:4])
                found.append(Entry(name, title, number, module, node.name))
    return tuple(found)


def find(name: str) -> Entry:
    """Look up a scene by its name, such as "one-spring", or raise ValueError with all names."""
    named = {entry.name: entry for entry in entries()}
    if name not in named:
        wrong = f"there is no scene {name!r}" if name else "name a scene"
        raise ValueError(f"{wrong}; choose from {', '.join(named)}")
    return named[name]


def load(name: str) -> type[Scene]:
    """Import a scene by its name, and the chapters of the engine that it uses."""
    entry = find(name)
    scene: type[Scene] = getattr(importlib.import_module(entry.module), entry.kind)
    return scene


def _title(kind: ast.ClassDef) -> str:
    """Return the title of a scene, or "" for the class of a peer or a base class."""
    for node in kind.body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "title":
            return str(ast.literal_eval(node.value))
    return ""
