"""Read the due dates and the time zone in a course file, and convert deadlines to JSON and back."""

from __future__ import annotations

import re
from datetime import UTC, date, datetime, tzinfo
from typing import Any
from zoneinfo import ZoneInfo, available_timezones

from autograder.course.lines import Path
from autograder.course.mistakes import Mistakes, nearest, shown
from autograder.course.model import Deadline, LatePolicy

YEARS = range(1970, 3000)  # close to the years 1 and 9999, Python may fail to convert a time


def read_zone(name: Any, path: Path, mistakes: Mistakes) -> ZoneInfo | None:
    """Look up a time zone that is set in the course file, such as Europe/Berlin.

    If there is no such time zone, record a mistake in the course file and return None.
    """
    if isinstance(name, str) and name in available_timezones():
        return ZoneInfo(name)
    wanted = nearest(str(name), available_timezones()) or "Names look like Europe/Berlin."
    mistakes.add(path, f"there is no time zone {shown(name)}. {wanted}")
    return None


def read_time(
    value: Any, path: Path, zone: tzinfo | None, mistakes: Mistakes, *, is_zone_wrong: bool = False
) -> datetime | None:
    """Read the due date of an assignment or an extension from the course file.

    A time without a UTC offset is taken to be in ``zone``, the time zone of the course. If the time
    is invalid, record a mistake in the course file and return None.
    """
    key = path[-1]
    example = "2026-10-23T23:59:00+02:00"
    if isinstance(value, date) and value.year not in YEARS:  # a datetime is a date, too
        mistakes.add(path, f"{key} must be from {YEARS[0]} to {YEARS[-1]}, got {shown(value)}")
    elif type(value) is date:
        mistakes.add(path, f"{key} has no time of day. Write it like {example}")
    elif not isinstance(value, datetime):
        unquoted = " without quotes" if isinstance(value, str) else ""
        mistakes.add(path, f"{key} must be a time like {example}{unquoted}, got {shown(value)}")
    elif value.tzinfo is not None:
        return value.astimezone(zone) if zone else value
    elif zone is None:
        if not is_zone_wrong:  # that mistake is already reported
            mistakes.add(
                path,
                f"{key} has no time zone. Add the offset from UTC, as in {value.isoformat()}"
                '+02:00, or write time_zone = "Europe/Berlin" at the top of the file',
            )
    else:
        time = value.replace(tzinfo=zone, fold=1)  # if clocks show it twice, use the later time
        if time.astimezone(UTC).astimezone(zone).replace(tzinfo=None) == value:
            return time
        mistakes.add(path, f"{key} {value} does not exist: the clocks in {zone} go forward then")
    return None


def parse_time(text: str, zone: tzinfo) -> datetime:
    """Parse a submission time in ISO 8601 format, such as 2026-10-23T20:15:00+02:00.

    If it has no UTC offset, it is taken to be in ``zone``.

    Raises:
        ValueError: The text is not a time.
    """
    time = datetime.fromisoformat(re.sub(r"\s*(UTC|Z)$", "+00:00", text.strip()))
    if time.year not in YEARS:
        raise ValueError(f"a time must be from {YEARS[0]} to {YEARS[-1]}")
    return time if time.tzinfo else time.replace(tzinfo=zone, fold=1)


def deadline_to_json(deadline: Deadline) -> dict[str, Any]:
    """Convert a deadline, its late policy and its extensions to data that can be stored as JSON."""
    return {
        "due": _to_text(deadline.due),
        "policy": vars(deadline.policy) if deadline.policy else None,
        "extensions": {name: _to_text(time) for name, time in deadline.extensions.items()},
    }


def deadline_from_json(data: dict[str, Any]) -> Deadline:
    """Convert the result of ``deadline_to_json`` back to a deadline."""
    policy = LatePolicy(**data["policy"]) if data["policy"] else None
    extensions = {name: _from_text(text) for name, text in data["extensions"].items()}
    return Deadline(_from_text(data["due"]), policy, extensions)


def _to_text(time: datetime) -> str:
    """Format a time with its UTC offset and the name of its time zone, as specified in RFC 9557.

    An example is 2026-10-23T23:59:00+02:00[Europe/Berlin].
    """
    name = f"[{time.tzinfo.key}]" if isinstance(time.tzinfo, ZoneInfo) else ""
    return time.isoformat() + name


def _from_text(text: str) -> datetime:
    stamp, _, name = text.rstrip("]").partition("[")
    time = datetime.fromisoformat(stamp)
    return time.astimezone(ZoneInfo(name)) if name else time
