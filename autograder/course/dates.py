"""Read the time of a submission, and convert deadlines to JSON and back."""

from __future__ import annotations

import re
from datetime import datetime, tzinfo
from typing import Any
from zoneinfo import ZoneInfo

from autograder.course.model import Deadline, LatePolicy

YEARS = range(1970, 3000)  # close to the years 1 and 9999, Python may fail to convert a time


def parse_time(text: str, zone: tzinfo) -> datetime:
    """Parse a time in ISO 8601 format, which is in ``zone`` if it has no UTC offset."""
    time = datetime.fromisoformat(re.sub(r"\s*(UTC|Z)$", "+00:00", text.strip()))
    if time.year not in YEARS:
        raise ValueError(f"a time must be from {YEARS[0]} to {YEARS[-1]}")
    return time if time.tzinfo else time.replace(tzinfo=zone, fold=1)


def deadline_to_json(deadline: Deadline) -> dict[str, Any]:
    """Convert a deadline to data that can be stored as JSON."""
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
    """Format a time as in RFC 9557, such as 2026-10-23T23:59:00+02:00[Europe/Berlin]."""
    name = f"[{time.tzinfo.key}]" if isinstance(time.tzinfo, ZoneInfo) else ""
    return time.isoformat() + name


def _from_text(text: str) -> datetime:
    stamp, _, name = text.rstrip("]").partition("[")
    time = datetime.fromisoformat(stamp)
    return time.astimezone(ZoneInfo(name)) if name else time
