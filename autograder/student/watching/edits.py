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
        """Find the exercises that the student has edited since the last call.

        Each exercise is returned with the functions or data files that have changed. Changes to
        comments and layout do not count. If a module is unreadable at the moment, all of its
        functions count as edited, because any of them may have changed.
        """
        edited = []
        for chapter in self.chapters:
            names = {name for file in chapter.handed_in for name in self._look_at(chapter, file)}
            for exercise in chapter.exercises:
                own = [name for name in (*exercise.edit, *exercise.files) if _is_in(name, names)]
                if own:
                    edited.append((chapter, exercise, own))
        return edited

    def _look_at(self, chapter: Chapter, name: str) -> set[str]:
        """Return the functions in one of the student's files that have changed since the last call.

        A data file, such as drops.csv, is compared as a whole.
        """
        path = self.engine / chapter.name / name
        try:
            text = path.read_bytes()
        except OSError:
            text = b""
        if self.texts.get(path) == text:
            return set()
        self.texts[path] = text
        module = name.removesuffix(".py")
        parts = {name: text.hex()} if module == name else _bodies(module, text)
        if parts is None:
            return {f"{module}.*"}
        before = self.parts.get(path, {})
        self.parts[path] = parts
        names = before.keys() | parts.keys()
        return {part for part in names if before.get(part) != parts.get(part)}


def _bodies(module: str, text: bytes) -> dict[str, str] | None:
    """Return the code of each function in a student's module, without comments and layout.

    The result is None if the module is unreadable or defines no functions. This can happen while a
    file is being saved, because some editors empty the file first.
    """
    try:
        found = functions(ast.parse(text))
    except (SyntaxError, ValueError):
        return None
    return {f"{module}.{name}": ast.dump(node) for name, node in found.items()} or None


def _is_in(name: str, edited: set[str]) -> bool:
    """Return True if the student has edited a function, or made its whole module unreadable."""
    return name in edited or f"{name.partition('.')[0]}.*" in edited
