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
    """Convert a deadline to data that can be stored as JSON, with the time zone of the course."""
    zone = deadline.due.tzinfo
    return {
        "due": deadline.due.isoformat(),
        "zone": zone.key if isinstance(zone, ZoneInfo) else None,
        "policy": vars(deadline.policy) if deadline.policy else None,
        "extensions": {name: time.isoformat() for name, time in deadline.extensions.items()},
    }


def deadline_from_json(data: dict[str, Any]) -> Deadline:
    """Convert the result of ``deadline_to_json`` back to a deadline."""

    def read(text: str) -> datetime:
        time = datetime.fromisoformat(text)
        return time.astimezone(ZoneInfo(data["zone"])) if data["zone"] else time

    policy = LatePolicy(**data["policy"]) if data["policy"] else None
    extensions = {name: read(text) for name, text in data["extensions"].items()}
    return Deadline(read(data["due"]), policy, extensions)
