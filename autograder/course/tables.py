"""The tables of a course file, with the type of every value, which msgspec checks."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import Annotated

import msgspec
from msgspec import Meta, Struct

from autograder.text.clean import clean_line

Amount = Annotated[int, Meta(gt=0, le=1_000_000)] | Annotated[float, Meta(gt=0, le=1_000_000)]
PerDay = Annotated[int, Meta(ge=0, le=1_000_000)] | Annotated[float, Meta(ge=0, le=1_000_000)]


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
        words, _, place = str(error).replace("`", "").partition(" - at $.")
        raise ValueError(
            f"{path}: {clean_line(f'{place}: {words}' if place else words)}"
        ) from error
