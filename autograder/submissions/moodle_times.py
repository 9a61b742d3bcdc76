"""Read the times that Moodle has written in the language of the instructor."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime

from dateparser.date import DateDataParser

ORDERS = ("DMY", "MDY")
YEARS = range(2000, 2100)  # others are of another calendar, such as the Thai one


def read_times(cells: Sequence[str]) -> list[datetime | None]:
    """Read times such as "Friday, 23 October 2026, 8:15 PM", in any of many languages.

    The result is None for a cell that is not a time, for one whose day and month are both numbers
    that could be the other, and for a year of another calendar. A time has no time zone, because
    Moodle does not write one.
    """
    readers = [
        DateDataParser(
            settings={"STRICT_PARSING": True, "PARSERS": ["absolute-time"], "DATE_ORDER": order}
        )
        for order in ORDERS
    ]
    return [_read_time(readers, cell) if cell else None for cell in cells]


def _read_time(readers: Sequence[DateDataParser], cell: str) -> datetime | None:
    times: set[datetime | None] = {reader.get_date_data(cell).date_obj for reader in readers}
    at = times.pop()
    if at is None or times or at.year not in YEARS:
        return None
    return at.replace(tzinfo=None)
