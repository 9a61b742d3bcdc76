"""Read chapter.toml, the manifest that lists a chapter's exercises and the functions to write.

The keys of a manifest are explained in chapters/README.md.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable
from dataclasses import MISSING, dataclass, field, fields
from functools import cache
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent.parent
KINDS = ("build", "exercise", "mini-project", "project", "written")
FOLDER_NAME = re.compile(r"ch(\d\d)_[a-z0-9_]+")
# What a value must be, by the type of its field or by its key.
WANTED: dict[str, tuple[str, Callable[[Any], bool]]] = {
    "str": ("a string", lambda value: isinstance(value, str)),
    "float": ("a positive number", lambda value: type(value) in (int, float) and value > 0),
    "list[str]": (
        "a list of strings",
        lambda value: isinstance(value, list) and all(isinstance(text, str) for text in value),
    ),
    "kind": (f"one of {', '.join(KINDS)}", lambda kind: kind in KINDS),
    "stars": ("1, 2 or 3", lambda stars: stars in (1, 2, 3)),
    "chart": ("the names of the cost and the error", lambda axes: len(axes) in (0, 2)),
}


@dataclass(frozen=True)
class Exercise:
    """One exercise, as described in the manifest of its chapter."""

    id: str
    title: str
    kind: str
    stars: int
    points: float
    hints: list[str]
    terms: list[str]
    edit: list[str] = field(default_factory=list)
    files: list[str] = field(default_factory=list)
    needs: list[str] = field(default_factory=list)
    chart: list[str] = field(default_factory=list)  # axes of an open exercise: cost and error
    robust: str = ""  # why an engine needs the robust checks, if there are any
    play: list[str] = field(default_factory=list)  # scenes of the lab that become playable
    extra: bool = False  # in an assignment, its points are added on top of the total
    optional: bool = False  # not part of the assignment, so it does not count


@dataclass(frozen=True)
class Chapter:
    """A chapter of the book with its exercises, as described in its manifest."""

    name: str  # of its folder and package, such as ch02_vectors
    number: int
    title: str
    complete: list[str]  # modules that students use without changing them, such as cloth.py
    exercises: list[Exercise]
    builds_on: list[int] | None = None  # chapters whose code it imports, or None for all earlier
    summary: str = ""
    you_can: list[str] = field(default_factory=list)  # what students are able to do afterwards
    picture: str = ""  # the plot that best shows its topic

    @property
    def edited_files(self) -> list[str]:
        """The modules that students edit, such as vector.py, in the order of the manifest."""
        modules = [name.split(".")[0] for exercise in self.exercises for name in exercise.edit]
        return [f"{module}.py" for module in dict.fromkeys(modules)]

    @property
    def data_files(self) -> list[str]:
        """The files in which students record their own measurements, such as drops.csv."""
        return [name for exercise in self.exercises for name in exercise.files]

    @property
    def handed_in(self) -> list[str]:
        """The files that the grader copies from a submission, such as vector.py and drops.csv."""
        return [*self.edited_files, *self.data_files]

    def exercise(self, exercise_id: str) -> Exercise:
        """Find an exercise by its id, such as B2.3. If there is none, raise ValueError."""
        known = {exercise.id: exercise for exercise in self.exercises}
        if exercise_id in known:
            return known[exercise_id]
        raise ValueError(
            f"there is no exercise {exercise_id!r} in {self.name}; it has {', '.join(known)}"
        )


def load_chapter(folder: Path) -> Chapter:
    """Read the manifest in a chapter's folder. If it is not valid, raise ValueError."""
    path = folder / "chapter.toml"
    return _read_chapter(path, path.read_text(encoding="utf-8"))


@cache  # grading a class starts hundreds of runs, and each of them reads every manifest
def _read_chapter(path: Path, text: str) -> Chapter:
    match = FOLDER_NAME.fullmatch(path.parent.name)
    if match is None:
        raise ValueError(f"{path.parent}: a chapter's folder must be named chNN_name")
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"{path}: {error}") from error
    exercises: dict[str, Exercise] = {}
    for entry in data.pop("exercise", []):
        where = f"{path}, exercise {entry.get('id', '(without an id)')}"
        _check(where, entry, Exercise)
        exercise = Exercise(**entry)
        if exercise.id in exercises:
            raise ValueError(f"{where} is listed twice")
        if missing := [need for need in exercise.needs if need not in exercises]:
            raise ValueError(f"{where} needs {missing[0]}, which does not precede it")
        exercises[exercise.id] = exercise
    own = {"name": path.parent.name, "number": int(match[1]), "exercises": [*exercises.values()]}
    chapter = {"complete": []} | data | own
    _check(str(path), chapter, Chapter)
    return Chapter(**chapter)


def _check(where: str, entry: dict[str, Any], kind: type) -> None:
    """Check the keys of a table and their values."""
    known = {item.name: item for item in fields(kind)}
    if unknown := entry.keys() - known.keys():
        raise ValueError(f"{where}: unknown key {min(unknown)!r}")
    for name, item in known.items():
        if name not in entry and item.default is item.default_factory is MISSING:
            raise ValueError(f"{where}: {name!r} is missing")
        for wanted, fits in (WANTED[key] for key in (str(item.type), name) if key in WANTED):
            if name in entry and not fits(entry[name]):
                raise ValueError(f"{where}: {name} must be {wanted}, got {entry[name]!r}")


def load_chapters(root: Path = ROOT) -> list[Chapter]:
    """Read the manifest of every chapter in ``root``/chapters, in chapter order."""
    return [load_chapter(path.parent) for path in sorted(root.glob("chapters/*/chapter.toml"))]


def split_given(chapters: list[Chapter], numbers: str) -> tuple[list[Chapter], list[Chapter]]:
    """Divide chapters into those that are given, as in "2,4-6", and those that students write."""
    given = select_chapters(numbers) if numbers else []
    left = [chapter for chapter in chapters if chapter not in given]
    if not left:
        raise ValueError(f"there is nothing left to check: chapter {numbers} is given")
    return given, left


def chapters_below(chapter: Chapter, root: Path = ROOT) -> list[Chapter]:
    """List the earlier chapters whose code a chapter imports."""
    earlier = [other for other in load_chapters(root) if other.number < chapter.number]
    on = chapter.builds_on
    return [other for other in earlier if on is None or other.number in on]


def select_chapters(numbers: str) -> list[Chapter]:
    """Return the chapters that a user has selected, as in "2,4-6". If empty, it is all."""
    chapters = {chapter.number: chapter for chapter in load_chapters()}
    wanted: list[int] = []
    for part in numbers.split(",") if numbers else []:
        match = re.fullmatch(r"\s*(\d+)(?:-(\d+))?\s*", part)
        if match is None:
            raise ValueError(f"chapters must look like 2 or 2,4-6, got {numbers!r}")
        first, last = int(match[1]), int(match[2] or match[1])
        if last < first:
            raise ValueError(f"chapters must count upwards, got {part.strip()!r}")
        wanted += range(first, last + 1)
    if lacking := [number for number in wanted if number not in chapters]:
        there = ", ".join(map(str, chapters))
        raise ValueError(f"there is no chapter {lacking[0]} here, only {there}")
    return [chapters[number] for number in sorted({*wanted} or chapters)]


def numbers_of(chapters: list[Chapter]) -> str:
    """Format the numbers of consecutive chapters as a range for the command line, such as "2-5"."""
    first, last = chapters[0].number, chapters[-1].number
    return str(first) if first == last else f"{first}-{last}"
