"""Detect which functions a student has just edited, so that `watch` can check their exercise."""

from __future__ import annotations

import ast
from pathlib import Path

from autograder.definitions import functions
from autograder.manifest import Chapter, Exercise


class Edits:
    """Remembers a student's functions and data files, and notices which of them have changed."""

    def __init__(self, engine: Path, chapters: list[Chapter]) -> None:
        self.engine = engine
        self.chapters = chapters
        self.texts: dict[Path, bytes] = {}
        self.parts: dict[Path, dict[str, str]] = {}
        self.look()

    def look(self) -> list[tuple[Chapter, Exercise, list[str]]]:
        """Find the exercises edited since the last call, with their functions and data files.

        Comments and layout do not count. In an unreadable module, all functions may have changed.
        """
        edited = []
        for chapter in self.chapters:
            names = {name for file in chapter.handed_in for name in self._changes(chapter, file)}
            for exercise in chapter.exercises:
                parts = (*exercise.edit, *exercise.files)
                own = [p for p in parts if p in names or f"{p.partition('.')[0]}.*" in names]
                if own:
                    edited.append((chapter, exercise, own))
        return edited

    def _changes(self, chapter: Chapter, name: str) -> set[str]:
        """Return the functions in one file that have changed. A data file is one part."""
        path = self.engine / chapter.name / name
        text = path.read_bytes() if path.is_file() else b""
        if self.texts.get(path) == text:
            return set()
        self.texts[path] = text
        module = name.removesuffix(".py")
        parts = {name: text.hex()} if module == name else _bodies(module, text)
        if not parts:  # unreadable, or emptied by an editor that is about to write the file
            return {f"{module}.*"}
        before = self.parts.get(path, {})
        self.parts[path] = parts
        names = before.keys() | parts.keys()
        return {part for part in names if before.get(part) != parts.get(part)}


def _bodies(module: str, text: bytes) -> dict[str, str]:
    """Return the code of each function in a module, without comments and layout."""
    try:
        found = functions(ast.parse(text))
    except (SyntaxError, ValueError):
        return {}
    return {f"{module}.{name}": ast.dump(node) for name, node in found.items()}
