"""Lines from a worker hold only plain data, and those of a check process only its events."""

from __future__ import annotations

import contextlib
import json
import os
import socket
import threading
import time
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

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
from autograder.isolation.wire import (
    LONGEST_LINE,
    BrokenProtocolError,
    UnsendableError,
    Wire,
    pack,
    unpack,
)
from autograder.message import Kind, Message, Place

plain = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
    lambda inner: (
        st.lists(inner)
        | st.lists(inner).map(tuple)
        | st.dictionaries(st.text() | st.integers() | st.tuples(st.integers()), inner)
    ),
    max_leaves=20,
)


def no_reference(value: Any) -> Any:
    raise AssertionError(value)


@given(plain)
def test_plain_data_comes_back_from_the_wire(value: Any) -> None:
    sent = json.dumps(pack(value, no_reference))
    back = unpack(json.loads(sent), no_reference)
    assert back == value
    assert repr(back) == repr(value), "1 is not 1.0, and a tuple is no list"


class Number(int):
    pass


@pytest.mark.parametrize(
    "data", [[1], {"list": [[1]]}, {"dict": [1]}, {"dict": [{"tuple": [{"list": []}, 1]}]}]
)
def test_what_pack_does_not_make_is_refused(data: Any) -> None:
    with pytest.raises(BrokenProtocolError):
        unpack(data, no_reference)


def test_a_subclass_is_referred_to() -> None:
    assert pack([Number(3)], lambda value: {"object": type(value).__name__}) == {
        "list": [{"object": "Number"}]
    }
    endless: list[Any] = []
    endless.append(endless)
    with pytest.raises(UnsendableError):
        pack(endless, no_reference)


@pytest.mark.parametrize(
    ("sent", "complaint"),
    [
        (b"no json\n", "not JSON"),
        (b"[1]\n", "not a JSON object"),
        (b"[" * 100_000 + b"\n", "not JSON"),
        (b'{"n": ' + b"9" * 5000 + b"}\n", "not JSON"),
        (b'{"text": "' + b"x" * (LONGEST_LINE + 70_000), "too long"),
    ],
)
def test_lines_that_are_no_messages(sent: bytes, complaint: str) -> None:
    ours, theirs = socket.socketpair()
    with ours, theirs:
        writer = threading.Thread(target=theirs.sendall, args=(sent,))
        writer.start()
        with pytest.raises(BrokenProtocolError, match=complaint):
            Wire(ours.fileno()).receive(time.monotonic() + 10.0)
        while writer.is_alive():
            with contextlib.suppress(BlockingIOError):
                os.read(ours.fileno(), 1 << 16)
        writer.join()


def test_who_talks_without_end_is_not_listened_to_beyond_the_deadline() -> None:
    ours, theirs = socket.socketpair()
    with ours, theirs:
        theirs.sendall(b"{}\n{}\n")
        wire = Wire(ours.fileno())
        assert wire.receive(time.monotonic() + 1.0) == {}
        with pytest.raises(TimeoutError):
            wire.receive(time.monotonic() - 1.0)


def test_silence_and_an_end_are_told_apart() -> None:
    ours, theirs = socket.socketpair()
    with ours:
        wire = Wire(ours.fileno())
        with pytest.raises(TimeoutError):
            wire.receive(time.monotonic() + 0.01)
        theirs.close()
        with pytest.raises(EOFError):
            wire.receive(time.monotonic() + 1.0)


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
        *(
            "",
            "null",
            "[]",
            "{}",
            '{"Ended": 7}',
            '{"Stopped": {}}',
            '{"Started": {}, "Ended": {}}',
        ),
        '{"Started": {"title": "test_it"}}',
        '{"Decided": {"name": "test_it", "status": "failed", "message": {"where": "here"}}}',
    ],
)
def test_another_line_is_no_event(line: str) -> None:
    with pytest.raises(ValueError, match=r"."):
        read_event(line)
