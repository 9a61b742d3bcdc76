"""Send plain data between the trusted checks and the process that runs a student's code.

Each message is one line of JSON. A value is sent as it is if its type is exactly None, bool, int,
float, str, list, tuple or dict. Any other object stays in its process, because it could lie about
itself. Only a reference such as ``{"object": 3}`` is sent, which stands for the object when it is
sent back. All sizes are limited, so that no message can fill the memory of the check process.
"""

from __future__ import annotations

import json
import os
import select
import time
from collections.abc import Callable
from typing import Any

LONGEST_LINE = 1_000_000  # bytes
LONGEST_INT = 4096  # bits
MOST_ITEMS = 20_000  # a message may contain at most this many items
DEEPEST = 20
LONGEST_TEXT = 2000  # characters of each text of a report on an exception
LARGEST_DICT = 1_000  # entries; keys that were chosen to collide could make a larger dict slow

# We send these exceptions by name. For any other, we send its nearest base class in this list.
_ERRORS = (
    "ArithmeticError AssertionError AttributeError BufferError EOFError Exception "
    "FloatingPointError ImportError IndexError KeyError LookupError MemoryError "
    "ModuleNotFoundError NameError NotImplementedError OSError OverflowError PermissionError "
    "RecursionError RuntimeError StopIteration SyntaxError TypeError UnboundLocalError "
    "UnicodeError ValueError ZeroDivisionError"
)
KNOWN_ERRORS = _ERRORS.split()

Refer = Callable[[Any], dict[str, Any]]
Find = Callable[[dict[str, Any]], Any]


class BrokenProtocolError(Exception):
    """Raised when a message is not valid. The student's code may send such a one on purpose."""


class UnsendableError(Exception):
    """Raised when a value is too large or too deeply nested to be sent."""


COPIED = {float, bool, str, type(None)}  # types of values that are packed as they are
_ENCODER = json.JSONEncoder(check_circular=False)  # pack never makes circular messages


class Wire:
    """One end of the socket between the checks and the worker that runs a student's code.

    The worker's end is ``patient``: it waits for a request as long as necessary. The checks' end
    has deadlines, as ``time.monotonic()`` times, because the student's code may never answer.
    """

    def __init__(self, descriptor: int, *, patient: bool = False) -> None:
        self.descriptor = descriptor
        self.patient = patient
        self._buffer = b""
        os.set_blocking(descriptor, patient)
        self._readable, self._writable = select.poll(), select.poll()
        self._readable.register(descriptor, select.POLLIN)
        self._writable.register(descriptor, select.POLLOUT)

    def send(self, message: dict[str, Any], deadline: float | None = None) -> None:
        """Send a message. Raise TimeoutError at the deadline, and OSError without a receiver."""
        data = memoryview(_ENCODER.encode(message).encode() + b"\n")
        while data:
            try:
                data = data[os.write(self.descriptor, data) :]
            except BlockingIOError:
                self._wait(self._writable, deadline)

    def receive(self, deadline: float | None = None) -> dict[str, Any]:
        """Wait for the next message. Raise TimeoutError at the deadline, or EOFError at the end.

        A line that is too long or not a JSON object is a BrokenProtocolError.
        """
        if deadline is not None and time.monotonic() > deadline:
            raise TimeoutError  # even if there is more to read
        while b"\n" not in self._buffer:
            if len(self._buffer) > LONGEST_LINE:
                raise BrokenProtocolError("a line is too long")
            if not self.patient:
                self._wait(self._readable, deadline)
            try:
                data = os.read(self.descriptor, 1 << 16)
            except BlockingIOError:
                continue
            except ConnectionError:
                data = b""
            if not data:
                raise EOFError
            self._buffer += data
        line, _, self._buffer = self._buffer.partition(b"\n")
        try:
            message = json.loads(line.decode())
        except (ValueError, RecursionError) as error:
            raise BrokenProtocolError("a line is not JSON") from error
        if not isinstance(message, dict):
            raise BrokenProtocolError("a line is not a JSON object")
        return message

    def _wait(self, poll: select.poll, deadline: float | None) -> None:
        left = None if deadline is None else deadline - time.monotonic()
        if left is not None and left <= 0.0:
            raise TimeoutError
        poll.poll(None if left is None else left * 1000.0)


def pack(value: Any, refer: Refer) -> Any:
    """Convert a value to JSON data, in which ``refer`` replaces each object that is not plain."""
    return _pack(value, refer, [MOST_ITEMS], DEEPEST)


def _pack(value: Any, refer: Refer, left: list[int], depth: int) -> Any:
    kind = type(value)
    if value is None or kind in (bool, float, str):
        return value
    if kind is int:
        if value.bit_length() > LONGEST_INT:
            raise UnsendableError(f"an integer of {value.bit_length()} bits")
        return value
    if kind not in (list, tuple, dict):
        return refer(value)
    left[0] -= len(value)
    if left[0] < 0:
        raise UnsendableError(f"a {kind.__name__} of more than {MOST_ITEMS} items")
    if depth == 0:
        raise UnsendableError(f"a {kind.__name__} nested in more than {DEEPEST} others")
    if kind is dict and len(value) > LARGEST_DICT:
        raise UnsendableError(f"a dict of more than {LARGEST_DICT} entries")
    if kind is not dict and COPIED.issuperset(map(type, value)):
        # Most are rows of floats, which are packed up to 6 times as fast in this way.
        return {kind.__name__: value}
    items = [*value.items()] if kind is dict else value
    return {kind.__name__: [_pack(item, refer, left, depth - 1) for item in items]}


def unpack(data: Any, find: Find) -> Any:
    """Rebuild a value from the JSON data of ``pack``, in which ``find`` looks up each reference."""
    return _unpack(data, find, [2 * MOST_ITEMS + 1000], DEEPEST + 2)


_KINDS: dict[str, type] = {kind.__name__: kind for kind in (tuple, list, dict)}


def _unpack(data: Any, find: Find, left: list[int], depth: int) -> Any:
    if type(data) is not dict:
        if type(data) is list:
            raise BrokenProtocolError("a bare list")
        return data
    if depth == 0:
        raise BrokenProtocolError("a value that is nested too deeply")
    if len(data) == 1:
        ((name, items),) = data.items()
        kind = _KINDS.get(name)
        if kind is not None and type(items) is list:
            left[0] -= len(items)
            if left[0] < 0 or (kind is dict and len(items) > LARGEST_DICT):
                raise BrokenProtocolError("too many items")
            if kind is not dict and COPIED.issuperset(map(type, items)):
                return kind(items)
            values = [_unpack(item, find, left, depth - 1) for item in items]
            try:
                return kind(values)
            except (TypeError, ValueError) as error:
                raise BrokenProtocolError("a dict whose items are not pairs") from error
    return find(data)
