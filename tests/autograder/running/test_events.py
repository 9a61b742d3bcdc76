"""The events of a check process are read as they were written, and no other line is one."""

from __future__ import annotations

import pytest

from autograder.checks.events import (
    Broken,
    Check,
    Checks,
    Decided,
    Ended,
    Event,
    Imported,
    Importing,
    Started,
    read_event,
    write_event,
)
from autograder.message import Kind, Message, Place

PLACE = Place("ch02_vectors/vector.py", 3, "Vector3.dot", "return x")
MESSAGE = Message("a\nb", tolerance=0.0, where=PLACE, inside=PLACE, blocked_by=("B2.1", "B2.2"))
EVENTS: list[Event] = [
    Checks([Check("test_it", "B2.1", 0.5, True, None, "test_it")]),
    Importing("ch02_vectors.vector"),
    Imported(),
    Broken("ch02_vectors.vector", Message("no", kind=Kind.BROKEN)),
    Started("test_it"),
    Decided("test_it", "failed", MESSAGE),
    Decided("test_it", "passed", on_chart=(1.0, 1e-300)),
    Ended(),
]


@pytest.mark.parametrize("event", EVENTS, ids=lambda event: type(event).__name__)
def test_an_event_is_one_line_and_read_as_it_was_written(event: Event) -> None:
    line = write_event(event)
    assert line.index("\n") == len(line) - 1
    assert read_event(line) == event


@pytest.mark.parametrize(
    "line",
    [
        *("", "{", "7", "null", "[]", "{}", '"Ended"', '{"Ended": 7}', '{"Stopped": {}}'),
        '{"Started": {}, "Ended": {}}',
        '{"Started": {"title": "test_it"}}',
        '{"Started": {"name": "test_it", "message": {}}}',
        '{"Checks": {"checks": [{"name": "test_it"}]}}',
        '{"Decided": {"name": "test_it", "status": "failed", "message": {"kind": "great"}}}',
        '{"Decided": {"name": "test_it", "status": "failed", "message": {"where": "here"}}}',
    ],
)
def test_another_line_is_no_event(line: str) -> None:
    with pytest.raises(ValueError, match=r"."):
        read_event(line)
