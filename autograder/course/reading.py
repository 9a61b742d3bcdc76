"""Read an instructor's course.toml, and report all of its mistakes with their line numbers."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from datetime import UTC, datetime, tzinfo
from pathlib import Path
from typing import Any

from autograder.course.dates import read_time, read_zone
from autograder.course.exercises import Chooser, chapters_under
from autograder.course.mistakes import Mistakes, nearest, shown
from autograder.course.model import Course, Deadline, LatePolicy, Work
from autograder.manifest import ROOT, Chapter, load_chapters

OF_COURSE = ("title", "time_zone", "roster", "late", "assignment")
OF_ASSIGNMENT = (
    *("name", "title", "exercises", "chapters", "extra_credit", "given", "points", "out_of"),
    *("total", "due", "late", "extensions", "hidden_checks", "seed"),
)
OF_LATE = ("points_per_day", "percent_per_day", "cap")
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]*")


def read_course(path: Path, root: Path = ROOT) -> Course:
    """Read the course file, in which an instructor describes the assignments of a term.

    Relative paths in the file are resolved from the folder that contains it.

    Raises:
        ValueError: The file contains mistakes. The message lists all of them with their lines.
        OSError: The file cannot be read.
    """
    reader = _reader(path, root)
    course = reader.course()
    reader.mistakes.raise_any()
    return course


def read_assignment(path: Path, name: str, root: Path = ROOT) -> tuple[Work, str]:
    """Read one assignment from the course file, even if other assignments have mistakes.

    Returns:
        The assignment, and a note that lists the mistakes in other assignments, if there are any.

    Raises:
        ValueError: There is no such assignment, or there are mistakes at the top of the file, in
            this assignment, or in one that it builds on. The message lists all mistakes.
        OSError: The file cannot be read.
    """
    reader = _reader(path, root)
    works = reader.course().assignments
    called = [number for number, work in enumerate(works) if work.name == name]
    if not called:
        reader.mistakes.raise_any()
        wanted = nearest(name, [work.name for work in works])
        known = f"It has {', '.join(work.name for work in works)}"
        raise ValueError(
            " ".join(filter(None, [f"{path} has no assignment {name!r}.", wanted, known]))
        )
    reader.mistakes.raise_any([*called, *reader.needed_by(called[0], works)])
    return works[called[0]], reader.mistakes.listed(f" outside of {name}")


def _reader(path: Path, root: Path) -> Reader:
    """Parse the course file.

    Raises:
        ValueError: The file is not valid TOML.
        OSError: The file cannot be read.
    """
    if not path.is_file():
        raise ValueError(
            f"there is no file {str(path)!r}. Write one as autograder/README.md shows, or name "
            "another with --course (in make: COURSE=)"
        )
    try:
        text = path.read_text(encoding="utf-8-sig")
        data = tomllib.loads(text)
    except UnicodeDecodeError as error:
        raise ValueError(f"{path} is not UTF-8: save it as UTF-8 in your editor") from error
    except (ValueError, RecursionError) as error:  # also for a number of 5,000 digits
        raise ValueError(f"{path} is not valid TOML: {error}") from error
    return Reader(data, path.parent, load_chapters(root), Mistakes(str(path), text))


class Reader:
    """Converts the tables of a course file to assignments, and records any mistakes in the file."""

    def __init__(
        self, data: dict[str, Any], folder: Path, chapters: list[Chapter], mistakes: Mistakes
    ) -> None:
        self.data = data
        self.folder = folder
        self.chapters = chapters
        self.mistakes = mistakes
        self.before: dict[str, str] = {}  # exercises read so far, with their first assignment

    def course(self) -> Course:
        """Read all assignments of the term.

        If the course file contains mistakes, they are recorded, and the result may be incomplete.
        The caller must therefore check for recorded mistakes before using the result.
        """
        mistakes, data = self.mistakes, self.data
        mistakes.check_keys(data, (), OF_COURSE)
        self.zone: tzinfo | None = None
        if "time_zone" in data:
            self.zone = read_zone(data["time_zone"], ("time_zone",), mistakes)
        self.policy = self._policy(data, ())
        tables = data.get("assignment", [])
        if not (isinstance(tables, list) and tables and all(type(t) is dict for t in tables)):
            mistakes.add(
                ("assignment",), "there is no assignment. Each one begins with [[assignment]]"
            )
            tables = []
        self.roster = self._path(data, (), "roster")
        assignments = [self._assignment(i, table) for i, table in enumerate(tables)]
        return Course(assignments, mistakes.value(data, (), "title", str) or "")

    def needed_by(self, number: int, works: list[Work]) -> list[int]:
        """List the earlier assignments on which an assignment builds, by their numbers in the file.

        They contain the exercises that it needs, or exercises of the earlier chapters that its code
        imports.
        """
        work = works[number]
        below = {
            earlier.number
            for chapter in work.chapters
            for earlier in chapters_under(chapter, self.chapters)
            if earlier not in work.given
        }
        return [
            other
            for other in range(number)
            for chapter in works[other].chapters
            if chapter.number in below or any(e.id in work.earlier for e in chapter.exercises)
        ]

    def _assignment(self, index: int, table: dict[str, Any]) -> Work:
        mistakes, path = self.mistakes, ("assignment", index)
        mistakes.check_keys(table, path, OF_ASSIGNMENT, ("roster", "time_zone"))
        name = mistakes.value(table, path, "name", str)
        others = [other.get("name") for other in self.data["assignment"][:index]]
        if name is None and "name" not in table:
            mistakes.add(path, 'the assignment has no name. Write one such as name = "lab1"')
        elif name is not None and not NAME.fullmatch(name):
            words = f"name must have only letters, digits, - and _, got {shown(name)}"
            mistakes.add((*path, "name"), words)
        elif name is not None and name in others:
            mistakes.add((*path, "name"), f"another assignment is called {name} too")
        chosen = Chooser(table, path, self.chapters, self.before, mistakes).choose()
        for exercise in (e for chapter in chosen.chapters for e in chapter.exercises):
            self.before.setdefault(exercise.id, name or "")
        seed = table.get("seed")
        if type(seed) not in (str, int, type(None)) or seed == "":
            mistakes.add(
                (*path, "seed"), f"seed must be a string or a whole number, got {shown(seed)}"
            )
        return Work(
            name or "",
            chosen.chapters,
            chosen.given,
            title=mistakes.value(table, path, "title", str) or "",
            earlier=chosen.earlier,
            deadline=self._deadline(table, path),
            hidden=self._hidden(table, path, chosen.chapters),
            seed=None if seed is None else str(seed),
            roster=self.roster,
        )

    def _deadline(self, table: dict[str, Any], path: tuple[str | int, ...]) -> Deadline | None:
        wrong = "time_zone" in self.data and self.zone is None
        policy = self._policy(table, path) if "late" in table else self.policy
        times: dict[str, datetime] = {}
        extensions = self.mistakes.value(table, path, "extensions", dict) or {}
        for student, value in extensions.items():
            at = (*path, "extensions", student)
            time = read_time(value, at, self.zone, self.mistakes, is_zone_wrong=wrong)
            if time:
                times[student] = time
        if "due" not in table:
            for key in (key for key in ("extensions", "late") if key in table):
                self.mistakes.add((*path, key), f"{key} has no effect without due. Add a due date")
            return None
        due = read_time(table["due"], (*path, "due"), self.zone, self.mistakes, is_zone_wrong=wrong)
        if due is None:
            return None
        for student, time in times.items():
            if time.astimezone(UTC) < due.astimezone(UTC):
                words = f"the extension of {student} ends before the assignment is due"
                self.mistakes.add((*path, "extensions", student), words)
        return Deadline(due, policy, times)

    def _policy(self, table: Mapping[str, Any], path: tuple[str | int, ...]) -> LatePolicy | None:
        """Read the penalty for late work from a table of the course file.

        The result is None if late work loses no points.
        """
        mistakes, at = self.mistakes, (*path, "late")
        late = mistakes.value(table, path, "late", dict)
        if late is None:
            return None
        mistakes.check_keys(late, at, OF_LATE)
        given = [key for key in ("points_per_day", "percent_per_day") if key in late]
        if len(given) != 1:
            words = "late must have points_per_day or percent_per_day"
            mistakes.add(at, f"{words}, and not both" if given else words)
            return None
        if late[given[0]] == 0 and late.keys() == {*given}:
            return None
        per_day = mistakes.number(late, at, given[0])
        cap = mistakes.number(late, at, "cap")
        if per_day is None:
            return None
        unit = "percent" if given[0] == "percent_per_day" else "points"
        if cap is not None and cap < per_day:
            words = f"cap must be at least {given[0]}, since it limits the {unit} for all days"
            mistakes.add((*at, "cap"), words)
        if unit == "percent" and max(per_day, cap or 0) > 100:
            key = "cap" if (cap or 0) > 100 else given[0]
            mistakes.add((*at, key), f"{key} must be at most 100 percent, got {shown(late[key])}")
        return LatePolicy(per_day, "percent" if unit == "percent" else "points", cap)

    def _path(self, table: Mapping[str, Any], path: tuple[str | int, ...], key: str) -> Path | None:
        """Read the path of a file or folder, such as the class list, from the course file.

        If nothing exists at that path, record a mistake and return None.
        """
        name = self.mistakes.value(table, path, key, str)
        if name is None:
            return None
        found = self.folder / str(name)
        if found.is_dir() if key == "hidden_checks" else found.is_file():
            return found
        what = "folder" if key == "hidden_checks" else "file"
        there = [other.name for other in self.folder.iterdir()] if self.folder.is_dir() else []
        wanted = nearest(name, there) or f"It should be in {str(self.folder.resolve())!r}."
        self.mistakes.add((*path, key), f"{key}: there is no {what} {name!r}. {wanted}")
        return None

    def _hidden(
        self, table: Mapping[str, Any], path: tuple[str | int, ...], chapters: list[Chapter]
    ) -> Path | None:
        """Read the path of the folder that holds an assignment's hidden checks.

        If none of these checks belong to an assigned chapter, record a mistake in the course file.
        """
        hidden = self._path(table, path, "hidden_checks")
        if hidden and chapters and not any((hidden / c.name).is_dir() for c in chapters):
            wanted = " or ".join(chapter.name for chapter in chapters)
            words = f"hidden_checks: {str(table['hidden_checks'])!r} must contain a folder {wanted}"
            self.mistakes.add((*path, "hidden_checks"), words)
        return hidden
