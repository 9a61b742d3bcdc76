"""Find the lab's scenes, which the modules in lab/scenes/chNN_*/ list in tuples called SCENES."""

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
        body = ast.parse(file.read_text(encoding="utf-8")).body
        classes = {node.name: node for node in body if isinstance(node, ast.ClassDef)}
        listed = _assigned(body, "SCENES")
        for kind in map(ast.unparse, listed.elts if isinstance(listed, ast.Tuple) else ()):
            title = _assigned(classes[kind].body, "title")
            words = ast.literal_eval(title) if title else kind
            found.append(Entry(name_of(type(kind, (), {})), words, int(chapter[2:4]), module, kind))
    return tuple(found)


def find(name: str) -> Entry:
    """Look up a scene by its name, such as "one-spring", or raise ValueError with all names."""
    for entry in entries():
        if entry.name == name:
            return entry
    names = ", ".join(entry.name for entry in entries())
    wrong = f"there is no scene {name!r}" if name else "name a scene"
    raise ValueError(f"{wrong}; choose from {names}")


def load(name: str) -> type[Scene]:
    """Import a scene by its name, and the chapters of the engine that it uses."""
    entry = find(name)
    scene: type[Scene] = getattr(importlib.import_module(entry.module), entry.kind)
    return scene


def _assigned(body: list[ast.stmt], name: str) -> ast.expr | None:
    """Return what a module or a class assigns to a name, if it does."""
    for node in body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == name:
            return node.value
    return None
