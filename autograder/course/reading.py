"""Read course.toml, in which an instructor describes the assignments of a term."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime, tzinfo
from pathlib import Path
from typing import Any
from zoneinfo import ZoneInfo, available_timezones

from autograder.checks.verdict import needs_of
from autograder.course.dates import YEARS
from autograder.course.model import Course, Deadline, LatePolicy, Work
from autograder.course.points import plain, rescaled
from autograder.course.tables import AssignmentTable, LateTable, read_tables
from autograder.manifest import ROOT, Chapter, Exercise, chapters_below, load_chapters
from autograder.scores import possible, shown
from autograder.text.clean import clean_line


def read_course(path: Path, root: Path = ROOT) -> Course:
    """Read a course file. Relative paths in it are resolved from the folder that contains it."""
    table = read_tables(path)
    works: list[Work] = []
    try:
        zone = _zone(table.time_zone)
        roster = _path(path.parent, "roster", table.roster)
        policy = _policy(table.late)
        for one in table.assignment:
            if one.name in [work.name for work in works]:
                raise ValueError(f"name: two assignments are called {one.name}")
            try:
                work = _work(one, works, load_chapters(root), root)
                hidden = _hidden(path.parent, one, work.chapters)
                deadline = _deadline(one, _policy(one.late) if one.late else policy, zone)
            except ValueError as error:
                raise ValueError(f"assignment {one.name}, {error}") from error
            works.append(replace(work, deadline=deadline, hidden=hidden, roster=roster))
    except ValueError as error:
        raise ValueError(f"{path}: {clean_line(str(error))}") from error
    return Course(works)


def _work(table: AssignmentTable, works: list[Work], chapters: list[Chapter], root: Path) -> Work:
    """Find the exercises of an assignment, and those of earlier ``works`` that they build on."""
    before: dict[str, str] = {}
    for work in works:
        for exercise in (e for chapter in work.chapters for e in chapter.exercises):
            before.setdefault(exercise.id, work.name)
    home = {e.id: chapter for chapter in chapters for e in chapter.exercises}
    given = _chapters("given", table.given, chapters)
    whole = _chapters("chapters", table.chapters, chapters)
    for key, names in (("exercises", table.exercises), ("extra_credit", table.extra_credit)):
        for name in names:
            if name not in home:
                raise ValueError(f"{key}: there is no exercise {name!r}")
    ids = {*table.exercises, *(e.id for chapter in whole for e in chapter.exercises)}
    if not ids - {*table.extra_credit}:
        raise ValueError('exercises: there are none. Write exercises = ["B2.1"] or chapters = [2]')
    ids |= {*table.extra_credit}
    earlier: set[str] = set()
    for name in (name for name in home if name in ids):
        if home[name] in given:
            number = home[name].number
            raise ValueError(f"given: chapter {number} is complete, so {name} cannot be assigned")
        needs = [e for e in home[name].exercise(name).needs if e not in ids | before.keys()]
        if needs:
            raise ValueError(f"{name} needs {', '.join(needs)}, which is in no assignment so far")
        earlier |= (needs_of(home[name], name) - ids) & before.keys()
    own = [chapter for chapter in chapters if any(e.id in ids for e in chapter.exercises)]
    for chapter in own:
        for below in chapters_below(chapter, root):
            if below not in given and not any(e.id in ids | before.keys() for e in below.exercises):
                raise ValueError(
                    f"given: chapter {chapter.number} builds on chapter {below.number}, which is "
                    f"neither given nor assigned so far. Add {below.number} to given"
                )
    worth = _points(table, [e for c in own for e in c.exercises if e.id in ids])
    return Work(
        table.name,
        [replace(c, exercises=[worth[e.id] for e in c.exercises if e.id in ids]) for c in own],
        given,
        title=table.title,
        earlier={name: before[name] for name in home if name in earlier},
        seed=None if table.seed is None else str(table.seed),
    )


def _chapters(key: str, numbers: list[int], chapters: list[Chapter]) -> list[Chapter]:
    known = {chapter.number: chapter for chapter in chapters}
    for number in numbers:
        if number not in known:
            there = ", ".join(map(str, known))
            raise ValueError(f"{key}: there is no chapter {number}. The chapters are {there}")
    return [chapter for number, chapter in known.items() if number in numbers]


def _points(table: AssignmentTable, exercises: list[Exercise]) -> dict[str, Exercise]:
    """Give each exercise its points in the assignment, scaled to ``out_of`` if that is set."""
    chosen = {e.id: replace(e, extra=e.id in table.extra_credit) for e in exercises}
    for name, value in table.points.items():
        if name not in chosen:
            raise ValueError(f"points: {name!r} is not an exercise of this assignment")
        chosen[name] = replace(chosen[name], points=plain(value))
    now = possible(chosen.values())
    if table.total and table.out_of:
        raise ValueError("total: it checks the points, but out_of changes them. Keep only one")
    if table.total and abs(table.total - now) > 0.005:
        raise ValueError(f"total: the points add up to {shown(now)}, not to {shown(table.total)}")
    if not table.out_of:
        return chosen
    new = rescaled({e.id: e.points for e in chosen.values() if not e.extra}, table.out_of)
    new |= {e.id: round(e.points * table.out_of / now, 2) for e in chosen.values() if e.extra}
    return {name: replace(e, points=plain(new[name])) for name, e in chosen.items()}


def _deadline(
    table: AssignmentTable, policy: LatePolicy | None, zone: tzinfo | None
) -> Deadline | None:
    if table.due is None:
        for key in ("extensions", "late"):
            if getattr(table, key):
                raise ValueError(f"{key} has no effect without due. Add a due date")
        return None
    due = _with_zone("due", table.due, zone)
    extensions = {
        name: _with_zone(f"extensions: {name}", time, zone)
        for name, time in table.extensions.items()
    }
    for name, time in extensions.items():
        if time.astimezone(UTC) < due.astimezone(UTC):
            raise ValueError(f"extensions: that of {name} ends before the assignment is due")
    return Deadline(due, policy, extensions)


def _policy(late: LateTable | None) -> LatePolicy | None:
    """Return the penalty for late work, or None if late work loses no points."""
    if late is None:
        return None
    if (late.points_per_day is None) == (late.percent_per_day is None):
        raise ValueError("late must have points_per_day or percent_per_day, and not both")
    unit: Any = "points" if late.percent_per_day is None else "percent"
    per_day = (late.points_per_day or 0) + (late.percent_per_day or 0)
    if late.cap is not None and late.cap < per_day:
        raise ValueError(f"late: cap must be at least {per_day}, since it is for all days")
    if unit == "percent" and max(per_day, late.cap or 0) > 100:
        raise ValueError("late: percent_per_day and cap must be at most 100")
    return LatePolicy(plain(per_day), unit, late.cap and plain(late.cap)) if per_day else None


def _zone(name: str | None) -> tzinfo | None:
    if name is not None and name not in available_timezones():
        raise ValueError(f"time_zone: there is none called {name!r}. Write one like Europe/Berlin")
    return ZoneInfo(name) if name else None


def _with_zone(key: str, time: datetime, zone: tzinfo | None) -> datetime:
    """Return a time of the course file in the time zone of the course."""
    if time.year not in YEARS:
        raise ValueError(f"{key} must be from {YEARS[0]} to {YEARS[-1]}, got {time}")
    if time.tzinfo:
        return time.astimezone(zone) if zone else time
    if zone is None:
        raise ValueError(
            f"{key} {time} has no time zone. Write an offset from UTC, as in {time.isoformat()}"
            '+02:00, or time_zone = "Europe/Berlin" at the top of the file'
        )
    return time.replace(tzinfo=zone, fold=1)  # if clocks show it twice, use the later time


def _path(folder: Path, key: str, name: str | None) -> Path | None:
    """Return the path of a file or a folder that the course file names."""
    if name is None or (folder / name).exists():
        return None if name is None else folder / name
    raise ValueError(f"{key}: {name!r} is not there. It should be in {str(folder.resolve())!r}")


def _hidden(folder: Path, table: AssignmentTable, chapters: list[Chapter]) -> Path | None:
    """Return the folder of hidden checks, which must have some for an assigned chapter."""
    hidden = _path(folder, "hidden_checks", table.hidden_checks)
    if hidden and not any((hidden / chapter.name).is_dir() for chapter in chapters):
        wanted = " or ".join(chapter.name for chapter in chapters)
        raise ValueError(f"hidden_checks: {table.hidden_checks!r} must contain a folder {wanted}")
    return hidden
