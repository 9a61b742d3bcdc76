"""The tables of a course file, with the type of every value, which msgspec checks."""

from __future__ import annotations

import re
from datetime import date, datetime
from pathlib import Path
from typing import Annotated, Any

import msgspec
from msgspec import Meta, Struct

from autograder.text.clean import clean_line

Amount = Annotated[int, Meta(gt=0, le=1_000_000)] | Annotated[float, Meta(gt=0, le=1_000_000)]
PerDay = Annotated[int, Meta(ge=0, le=1_000_000)] | Annotated[float, Meta(ge=0, le=1_000_000)]
# How a message says what msgspec expects, and what it found out about a table.
WORDS = {
    "Object contains unknown field": "there is no key",
    "Object missing required field": "it must have",
    "Expected": "expected",
    "matching regex '^[A-Za-z0-9][A-Za-z0-9_-]*$'": "of letters, digits, - and _",
    "datetime": "time such as 2026-10-23 23:59:00 without quotes",
    "array": "list",
    "object": "table",
    " | null": "",
    "`": "",
}


class LateTable(Struct, forbid_unknown_fields=True):
    """The table [late] of a course file, or the value of ``late`` in an assignment."""

    points_per_day: PerDay | None = None
    percent_per_day: PerDay | None = None
    cap: Amount | None = None


class AssignmentTable(Struct, forbid_unknown_fields=True):
    """A table [[assignment]] of a course file."""

    name: Annotated[str, Meta(pattern="^[A-Za-z0-9][A-Za-z0-9_-]*$")]
    title: str = ""
    exercises: list[str] = []
    chapters: list[int] = []
    extra_credit: list[str] = []
    given: list[int] = []
    points: dict[str, Amount] = {}
    out_of: Amount | None = None
    total: Amount | None = None
    due: datetime | None = None
    late: LateTable | None = None
    extensions: dict[str, datetime] = {}
    hidden_checks: str | None = None
    seed: str | int | None = None


class CourseTable(Struct, forbid_unknown_fields=True):
    """A whole course file."""

    assignment: Annotated[list[AssignmentTable], Meta(min_length=1)]
    time_zone: str | None = None
    roster: str | None = None
    late: LateTable | None = None


def read_tables(path: Path) -> CourseTable:
    """Parse a course file, and raise ValueError at a wrong key or value."""
    if not path.is_file():
        raise ValueError(
            f"there is no file {str(path)!r}. Write one as autograder/README.md shows, or name "
            "another with --course (in make: COURSE=)"
        )
    try:
        data = msgspec.toml.decode(path.read_text(encoding="utf-8-sig"))
    except UnicodeDecodeError as error:
        raise ValueError(f"{path} is not UTF-8: save it as UTF-8 in your editor") from error
    except (ValueError, RecursionError) as error:  # also for a number of 5,000 digits
        raise ValueError(f"{path} is not valid TOML: {error}") from error
    try:
        return msgspec.convert(data, CourseTable, builtin_types=(datetime,))
    except msgspec.ValidationError as error:
        raise ValueError(f"{path}: {clean_line(_explained(str(error), data))}") from error


def _explained(message: str, data: Any) -> str:
    """Say where in a course file a value is wrong, what is wanted there, and what was found."""
    words, _, place = message.partition(" - at `$.")
    words = words.partition(", got ")[0]
    for old, new in WORDS.items():
        words = words.replace(old, new)
    value = data
    for key in re.findall(r"\w+", place):  # the keys of points and extensions are not named
        value = value[int(key) if isinstance(value, list) else key]
    place = place.replace("[...]", "").rstrip("`")
    if number := re.match(r"assignment\[(\d+)\]\.?", place):
        table = data["assignment"][int(number[1])]
        name = table.get("name") if isinstance(table, dict) else None
        name = name or int(number[1]) + 1
        place = f"assignment {name}, {place[number.end() :]}".rstrip(", ")
    text = str(value) if isinstance(value, date) else repr(value)  # a datetime is a date, too
    got = f", got {text:.60}" if words.startswith("expected") else ""
    return ": ".join(filter(None, [place, f"{words}{got}"]))
