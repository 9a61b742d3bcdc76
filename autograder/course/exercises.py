"""Find out which exercises belong to an assignment, and how many points each of them is worth."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from autograder.checks.verdict import needs_of
from autograder.course.lines import Path
from autograder.course.mistakes import Mistakes, nearest
from autograder.course.points import rescaled, scaled_alike
from autograder.manifest import Chapter, Exercise
from autograder.scores import possible, shown


@dataclass(frozen=True)
class Chosen:
    """The exercises in an assignment, grouped by chapter.

    Attributes:
        chapters: The chapters with only the assigned exercises.
        given: The chapters that students receive as finished code.
        earlier: The exercises of earlier assignments that this one builds on, with the names of
            these assignments.
    """

    chapters: list[Chapter]
    given: list[Chapter]
    earlier: dict[str, str]


def chapters_under(chapter: Chapter, chapters: list[Chapter]) -> list[Chapter]:
    """List those of the ``chapters`` whose code a chapter imports.

    These are the chapters in the ``builds_on`` list of its manifest. Without such a list, they are
    all earlier chapters.
    """
    earlier = [other for other in chapters if other.number < chapter.number]
    numbers = chapter.builds_on
    return [other for other in earlier if numbers is None or other.number in numbers]


class Chooser:
    """Finds out which exercises belong to an assignment, by reading its table in the course file.

    Mistakes in the table are collected in ``mistakes``. ``before`` contains the exercises of all
    earlier assignments, because this one may build on them. Each is mapped to the name of its
    assignment.
    """

    def __init__(
        self,
        table: Mapping[str, Any],
        path: Path,
        chapters: list[Chapter],
        before: Mapping[str, str],
        mistakes: Mistakes,
    ) -> None:
        self.table = table
        self.path = path
        self.chapters = chapters
        self.before = before
        self.mistakes = mistakes
        self.home = {e.id: chapter for chapter in chapters for e in chapter.exercises}

    def choose(self) -> Chosen:
        """Return the exercises that an assignment in the course file contains.

        If the course file contains mistakes, they are recorded, and the result may be incomplete.
        The caller must therefore check for recorded mistakes before using the result.
        """
        given = self._chapters("given")
        listed = self._ids("exercises")
        extra = self._ids("extra_credit")
        whole = self._chapters("chapters")
        for name in (name for name in listed if name in extra):
            self._wrong(
                "extra_credit", f"{name} is also listed in exercises. List it only once", name
            )
        for name in (name for name in listed if self.home[name] in whole):
            words = f"{name} belongs to chapter {self.home[name].number}, which is listed already"
            self._wrong("exercises", words, name)
        ids = {*listed, *extra, *(e.id for chapter in whole for e in chapter.exercises)}
        if not ids - {*extra}:
            wanted = 'exercises = ["B2.1", "2.4"] or chapters = [2]'
            self.mistakes.add(self.path, f"the assignment has no exercises. Write {wanted}")
        for chapter in given:
            if inside := [name for name in self.home if name in ids and self.home[name] == chapter]:
                words = f"chapter {chapter.number} is given complete, so {inside[0]} cannot be "
                self._wrong("given", f"{words}assigned")
        earlier = self._earlier(ids, given)
        points = self._points(ids, {*extra})
        return Chosen(
            [assigned for chapter in self.chapters if (assigned := _only(chapter, points))],
            given,
            earlier,
        )

    def _wrong(self, key: str, words: str, word: str = "") -> None:
        self.mistakes.add((*self.path, key), words, word)

    def _ids(self, key: str) -> list[str]:
        """Read the list of exercise ids under a key of the course file, such as "extra_credit".

        An id that does not exist or is listed twice is recorded as a mistake.
        """
        found: list[str] = []
        for name in self.mistakes.items(self.table, self.path, key, str):
            if name not in self.home:
                wanted = nearest(name, self.home) or f"Ids look like {next(iter(self.home))}."
                self._wrong(key, f"there is no exercise {name!r}. {wanted}", name)
            elif name in found:
                self._wrong(key, f"{name} is listed twice", name)
            else:
                found.append(name)
        return found

    def _chapters(self, key: str) -> list[Chapter]:
        """Return the chapters that are listed under a key of the course file, such as "given".

        If a chapter does not exist, its number is skipped and recorded as a mistake.
        """
        known = {chapter.number: chapter for chapter in self.chapters}
        numbers = self.mistakes.items(self.table, self.path, key, int)
        for number in numbers:
            if number not in known:
                there = ", ".join(map(str, known))
                self._wrong(key, f"there is no chapter {number}. The chapters are {there}")
        return [chapter for number, chapter in known.items() if number in numbers]

    def _earlier(self, ids: set[str], given: list[Chapter]) -> dict[str, str]:
        """List the exercises from earlier assignments that this assignment builds on.

        If it builds on an exercise that was never assigned, record a mistake in the course file.
        """
        earlier: set[str] = set()
        for name in (name for name in self.home if name in ids):
            chapter = self.home[name]
            missing = [e for e in chapter.exercise(name).needs if e not in ids | self.before.keys()]
            if missing and chapter not in given:
                words = f"{name} needs {', '.join(missing)}, which is not in any assignment so far"
                self._wrong(*self._where(name), word=name, words=words)
            earlier |= (needs_of(chapter, name) - ids) & self.before.keys()
        for chapter in {self.home[name].number: self.home[name] for name in ids}.values():
            for below in chapters_under(chapter, self.chapters):
                if below in given or any(e.id in ids | self.before.keys() for e in below.exercises):
                    continue
                self.mistakes.add(
                    self.path,
                    f"chapter {chapter.number} builds on chapter {below.number}, which is neither "
                    f"given nor assigned so far. Add {below.number} to given",
                )
        return {name: self.before[name] for name in self.home if name in earlier}

    def _where(self, name: str) -> tuple[str]:
        """Find the key in the course file that adds an exercise to the assignment.

        This is "exercises" or "extra_credit" if the exercise is listed there, and "chapters" if its
        whole chapter was assigned. Messages about mistakes point to the line of that key.
        """
        lists = {key: self.table.get(key) for key in ("exercises", "extra_credit")}
        return (
            next((k for k, v in lists.items() if isinstance(v, list) and name in v), "chapters"),
        )

    def _points(self, ids: set[str], extra: set[str]) -> dict[str, Exercise]:
        """Work out how many points each exercise is worth in this assignment.

        The points come from the manifests, unless the table ``points`` in the course file overrides
        them. If the assignment sets ``out_of``, the points are then scaled to add up to that total.
        """
        chosen = {
            name: replace(home.exercise(name), extra=name in extra)
            for name, home in self.home.items()
            if name in ids
        }
        table = self.mistakes.value(self.table, self.path, "points", dict) or {}
        for name in table:
            at = (*self.path, "points")
            value = self.mistakes.number(table, at, name)
            if name not in chosen:
                wanted = nearest(name, chosen)
                words = (
                    f"points lists {name!r}, which is not an exercise of this assignment. {wanted}"
                )
                self.mistakes.add((*at, name), words.strip(), name)
            elif value is not None:
                chosen[name] = replace(chosen[name], points=value)
        return self._rescaled(chosen)

    def _rescaled(self, chosen: dict[str, Exercise]) -> dict[str, Exercise]:
        """Scale the points of the exercises, so that they add up to the assignment's ``out_of``.

        If the course file sets no ``out_of`` for this assignment, the points stay as they are.
        """
        out_of = self.mistakes.number(self.table, self.path, "out_of")
        total = self.mistakes.number(self.table, self.path, "total")
        now = possible(chosen.values())
        if total is not None and out_of is not None:
            self._wrong(
                "total", "total checks the sum of the points, but out_of changes it. Keep only one"
            )
        elif total is not None and now and abs(total - now) > 0.005:
            self._wrong("total", f"the points add up to {shown(now)}, not to {shown(total)}")
        if out_of is None or not now:
            return chosen
        new = rescaled({e.id: e.points for e in chosen.values() if not e.extra}, out_of)
        new |= {e.id: scaled_alike(e.points, out_of, now) for e in chosen.values() if e.extra}
        return {name: replace(e, points=new[name]) for name, e in chosen.items()}


def _only(chapter: Chapter, exercises: Mapping[str, Exercise]) -> Chapter | None:
    """Return a copy of a chapter with only the assigned exercises, or None if there are none."""
    mine = [exercises[e.id] for e in chapter.exercises if e.id in exercises]
    return replace(chapter, exercises=mine) if mine else None
