"""Read chapter.toml, the manifest that lists a chapter's exercises and the functions to write.

The keys of a manifest are explained in chapters/README.md.
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass, field, fields
from functools import cache
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent.parent
KINDS = ("build", "exercise", "mini-project", "project", "written")
FOLDER_NAME = re.compile(r"ch(\d\d)_[a-z0-9_]+")


@dataclass(frozen=True)
class Exercise:
    """One exercise, as described in the manifest of its chapter.

    Attributes:
        extra: True if the exercise gives extra credit in an assignment. Its points are then added
            on top of the total.
        optional: True if the exercise is not part of the assignment. Students may do it, but it
            does not count.
    """

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
    extra: bool = False
    optional: bool = False


@dataclass(frozen=True)
class Chapter:
    """A chapter of the book with its exercises, as described in its manifest.

    Attributes:
        name: The name of the chapter's folder and package, such as ch02_vectors.
        complete: The modules that students use without changing them, such as cloth.py.
        builds_on: The numbers of the earlier chapters whose code this one imports. None means that
            it may import all of them.
        summary: A sentence about the topic of the chapter.
        you_can: Sentences about what students are able to do after the chapter.
        picture: The plot that best shows the topic of the chapter.
    """

    name: str
    number: int
    title: str
    complete: list[str]
    exercises: list[Exercise]
    builds_on: list[int] | None = None
    summary: str = ""
    you_can: list[str] = field(default_factory=list)
    picture: str = ""

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
        """Find the exercise in this chapter whose id is ``exercise_id``, such as B2.3.

        Raises:
            ValueError: The chapter has no such exercise.
        """
        for exercise in self.exercises:
            if exercise.id == exercise_id:
                return exercise
        known = ", ".join(exercise.id for exercise in self.exercises)
        raise ValueError(f"there is no exercise {exercise_id!r} in {self.name}; it has {known}")


def load_chapter(folder: Path) -> Chapter:
    """Read and validate the manifest in a chapter's folder.

    Raises:
        ValueError: The manifest is not valid. The error message describes the problem.
    """
    path = folder / "chapter.toml"
    return _read_chapter(path, path.read_text(encoding="utf-8"))


@cache  # grading a class starts hundreds of runs, and each of them reads every manifest
def _read_chapter(path: Path, text: str) -> Chapter:
    folder = path.parent
    match = FOLDER_NAME.fullmatch(folder.name)
    if match is None:
        raise ValueError(f"{folder}: a chapter's folder must be named chNN_name")
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"{path}: {error}") from error
    exercises = [_exercise(path, entry) for entry in data.pop("exercise", [])]
    known = {item.name for item in fields(Chapter)} - {"name", "number", "exercises"}
    if unknown := data.keys() - known:
        raise ValueError(f"{path}: unknown key {min(unknown)!r}")
    if "title" not in data:
        raise ValueError(f"{path}: 'title' is missing")
    complete = data.pop("complete", [])
    chapter = Chapter(folder.name, int(match[1]), complete=complete, exercises=exercises, **data)
    for key, value in (("summary", chapter.summary), ("picture", chapter.picture)):
        if not isinstance(value, str):
            raise ValueError(f"{path}: {key} must be a string, got {value!r}")
    if not _are_words(chapter.you_can):
        raise ValueError(f"{path}: you_can must be a list of sentences, got {chapter.you_can!r}")
    _check_needs(path, chapter)
    return chapter


def load_chapters(root: Path = ROOT) -> list[Chapter]:
    """Read the manifest of every chapter in ``root``/chapters, in chapter order."""
    return [load_chapter(path.parent) for path in sorted(root.glob("chapters/*/chapter.toml"))]


def split_given(chapters: list[Chapter], numbers: str) -> tuple[list[Chapter], list[Chapter]]:
    """Divide chapters into those that students are given and those that they write.

    For a given chapter, students receive our solution. ``numbers`` lists the given chapters, as in
    "2,4-6". If it is empty, students write all chapters.

    Returns:
        Two lists of chapters: the given ones, and those that students write.

    Raises:
        ValueError: No chapter is left for students to write, or ``numbers`` is malformed.
    """
    given = select_chapters(numbers) if numbers else []
    left = [chapter for chapter in chapters if chapter not in given]
    if not left:
        raise ValueError(f"there is nothing left to check: chapter {numbers} is given")
    return given, left


def refuse_given(chapter: Chapter, exercise: Exercise, numbers: str) -> None:
    """Raise ValueError if an exercise belongs to a chapter that students receive complete.

    In such a chapter, the autograder uses our solution, so the student has nothing to write.
    ``numbers`` lists these chapters, as in "2-5".
    """
    if numbers and chapter in select_chapters(numbers):
        raise ValueError(
            f"exercise {exercise.id} is in chapter {chapter.number}, which is given. The "
            "reference replaces your code there, so there is nothing for you to write"
        )


def chapters_below(chapter: Chapter, root: Path = ROOT) -> list[Chapter]:
    """List the earlier chapters whose code a chapter imports.

    These are the chapters in the ``builds_on`` list of its manifest. Without such a list, they are
    all earlier chapters.
    """
    below = [other for other in load_chapters(root) if other.number < chapter.number]
    if chapter.builds_on is None:
        return below
    return [other for other in below if other.number in chapter.builds_on]


def select_chapters(numbers: str) -> list[Chapter]:
    """Return the chapters that a user has selected on the command line, as in "2,4-6".

    An empty selection stands for all chapters.

    Raises:
        ValueError: The selection is malformed or contains a chapter that does not exist.
    """
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
    for number in wanted:
        if number not in chapters:
            there = ", ".join(map(str, chapters))
            raise ValueError(f"there is no chapter {number} here, only {there}")
    return [chapters[number] for number in sorted(set(wanted))] if wanted else [*chapters.values()]


def numbers_of(chapters: list[Chapter]) -> str:
    """Format the numbers of consecutive chapters as a range for the command line, such as "2-5"."""
    first, last = chapters[0].number, chapters[-1].number
    return str(first) if first == last else f"{first}-{last}"


def _exercise(path: Path, entry: dict[str, Any]) -> Exercise:
    where = f"{path}, exercise {entry.get('id', '(without an id)')}"
    known = {item.name for item in fields(Exercise)}
    wanted = {"id", "title", "kind", "stars", "points", "hints", "terms"}
    if unknown := entry.keys() - known:
        raise ValueError(f"{where}: unknown key {min(unknown)!r}")
    if missing := wanted - entry.keys():
        raise ValueError(f"{where}: {min(missing)!r} is missing")
    exercise = Exercise(**entry)
    if exercise.kind not in KINDS:
        raise ValueError(f"{where}: kind must be one of {', '.join(KINDS)}, got {exercise.kind!r}")
    if exercise.stars not in (1, 2, 3):
        raise ValueError(f"{where}: stars must be 1, 2 or 3, got {exercise.stars!r}")
    if type(exercise.points) not in (int, float) or exercise.points <= 0:
        raise ValueError(f"{where}: points must be a positive number, got {exercise.points!r}")
    if len(exercise.chart) not in (0, 2):
        raise ValueError(f"{where}: chart must name the cost and the error, got {exercise.chart!r}")
    if not _are_words(exercise.play):
        raise ValueError(f"{where}: play must be a list of scenes, got {exercise.play!r}")
    return exercise


def _are_words(value: object) -> bool:
    return isinstance(value, list) and all(isinstance(item, str) for item in value)


def _check_needs(path: Path, chapter: Chapter) -> None:
    """Check that no exercise id is used twice, and that each exercise follows its prerequisites.

    Raises:
        ValueError: An id is used twice, or an exercise is listed before one of its prerequisites.
    """
    seen: set[str] = set()
    for exercise in chapter.exercises:
        if exercise.id in seen:
            raise ValueError(f"{path}: exercise {exercise.id} is listed twice")
        for need in exercise.needs:
            if need not in seen:
                raise ValueError(f"{path}: {exercise.id} needs {need}, which does not precede it")
        seen.add(exercise.id)
