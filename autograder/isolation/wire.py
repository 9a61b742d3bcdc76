"""The wire between trusted checks and the worker: one JSON line each way, and only plain data.

What crosses by value is None, bool, int, float, str, list, tuple and dict, of exactly these types.
Everything else is referred to: each end says how it names its own objects and finds the other's.
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
MOST_ITEMS = 20_000  # in one message
DEEPEST = 20
LARGEST_DICT = 1_000  # entries: keys may be chosen to collide, and each then meets all others

# Errors that cross by their name. Any other is told as the nearest of these that it derives from.
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
    """The other end sent something that this wire does not carry."""


class UnsendableError(Exception):
    """A value is too large, or too deep, to be handed over."""


class Wire:
    """One end of a socket pair."""

    def __init__(self, descriptor: int) -> None:
        self.descriptor = descriptor
        self._buffer = b""
        os.set_blocking(descriptor, False)

    def send(self, message: dict[str, Any], deadline: float | None = None) -> None:
        """Send a message. Raises TimeoutError, and OSError where the other end is gone."""
        data = memoryview(json.dumps(message).encode() + b"\n")
        while data:
            try:
                data = data[os.write(self.descriptor, data) :]
            except BlockingIOError:
                self._wait(deadline, for_writing=True)

    def receive(self, deadline: float | None = None) -> dict[str, Any]:
        """Return the next message.

        Raises TimeoutError, EOFError where the other end is gone, and BrokenProtocolError for what
        is no JSON object in a line of at most LONGEST_LINE bytes.
        """
        if deadline is not None and time.monotonic() > deadline:
            raise TimeoutError  # however much there is to read
        while b"\n" not in self._buffer:
            if len(self._buffer) > LONGEST_LINE:
                raise BrokenProtocolError("a line is too long")
            try:
                data = os.read(self.descriptor, 1 << 16)
            except BlockingIOError:
                self._wait(deadline, for_writing=False)
                continue
            except ConnectionError:
                data = b""
            if not data:
                raise EOFError
            self._buffer += data
        line, _, self._buffer = self._buffer.partition(b"\n")
        try:
            message = json.loads(line)
        except (ValueError, RecursionError) as error:
            raise BrokenProtocolError("a line is no JSON") from error
        if not isinstance(message, dict):
            raise BrokenProtocolError("a line is no JSON object")
        return message

    def _wait(self, deadline: float | None, *, for_writing: bool) -> None:
        left = None if deadline is None else deadline - time.monotonic()
        if left is not None and left <= 0.0:
            raise TimeoutError
        own = [self.descriptor]
        select.select([] if for_writing else own, own if for_writing else [], [], left)


def pack(value: Any, refer: Refer) -> Any:
    """Return what stands for a value in a message.

    ``refer`` names what is no plain value. Raises UnsendableError for what is too much.
    """
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
        raise UnsendableError(f"a {kind.__name__} in more than {DEEPEST} others")
    if kind is dict and len(value) > LARGEST_DICT:
        raise UnsendableError(f"a dict of more than {LARGEST_DICT} entries")
    items = [*value.items()] if kind is dict else value
    return {kind.__name__: [_pack(item, refer, left, depth - 1) for item in items]}


def unpack(data: Any, find: Find) -> Any:
    """Return the value that stands in a message; ``find`` knows what is referred to.

    Raises BrokenProtocolError for what pack does not make.
    """
    return _unpack(data, find, [2 * MOST_ITEMS + 1000], DEEPEST + 2)


def _unpack(data: Any, find: Find, left: list[int], depth: int) -> Any:
    if not isinstance(data, dict):
        if isinstance(data, list):
            raise BrokenProtocolError("a bare list")
        return data
    if depth == 0:
        raise BrokenProtocolError("a value that is too deep")
    for kind in (tuple, list, dict):
        items = data.get(kind.__name__)
        if isinstance(items, list):
            left[0] -= len(items)
            if left[0] < 0 or (kind is dict and len(items) > LARGEST_DICT):
                raise BrokenProtocolError("too many items")
            values = [_unpack(item, find, left, depth - 1) for item in items]
            try:
                return kind(values)
            except (TypeError, ValueError) as error:
                raise BrokenProtocolError("a dict of what are no pairs") from error
    return find(data)
