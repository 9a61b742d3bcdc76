"""Convert frozen dataclasses to JSON and back, and validate every value that is read.

The JSON may come from another process or from an older version of this program. If a value does not
have the type declared for its field, the error says which value is wrong.
"""

from __future__ import annotations

import types
import typing
from collections.abc import Callable
from dataclasses import MISSING, fields, is_dataclass
from enum import Enum
from functools import cache
from typing import Any, Literal, TypeVar

Record = TypeVar("Record")


class RecordError(ValueError):
    """Raised when a value in JSON data does not have the type declared for its field."""


def to_json(value: Any) -> Any:
    """Convert a dataclass to plain lists and dictionaries for json.dumps.

    Fields that have their default value are omitted, to keep the JSON short.
    """
    if is_dataclass(value) and not isinstance(value, type):
        data = {}
        for field, default in _fields(type(value)):
            if (own := getattr(value, field)) != default:
                data[field] = to_json(own)
        return data
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, (list, tuple)):
        return [to_json(item) for item in value]
    if isinstance(value, dict):
        return {key: to_json(item) for key, item in value.items()}
    return value


def from_json(kind: type[Record], data: Any, what: str = "") -> Record:
    """Create an instance of the dataclass ``kind`` from parsed JSON, and validate every value.

    ``what`` describes the JSON in error messages, as in "the report".

    Raises:
        RecordError: A value is missing or has the wrong type, or a key is unknown.
    """
    read: Callable[[Any, str], Record] = _reader(kind)  # type: ignore[arg-type]
    return read(data, what or kind.__name__)


@cache
def _fields(kind: type) -> list[tuple[str, Any]]:
    """Return the name and the default value of each field of a dataclass.

    If a field has no default value, dataclasses.MISSING takes its place.
    """
    found = []
    for field in fields(kind):
        made = field.default_factory
        found.append((field.name, field.default if made is MISSING else made()))
    return found


@cache
def _reader(kind: Any) -> Callable[[Any, str], Any]:
    """Build a function that validates parsed JSON and converts it to the type ``kind``.

    The function takes the JSON and a description of it, such as "the report.score". Error messages
    contain this description, so that they show which value is wrong.
    """
    origin, arguments = typing.get_origin(kind), typing.get_args(kind)
    if is_dataclass(kind):
        return _record_reader(kind)  # type: ignore[arg-type]
    if origin in (typing.Union, types.UnionType):
        return _union_reader(arguments)
    if origin is list:
        return _list_reader(list, _reader(arguments[0]))
    if origin is tuple and arguments[-1] is Ellipsis:
        return _list_reader(tuple, _reader(arguments[0]))
    if origin is tuple:
        return _tuple_reader([_reader(argument) for argument in arguments])
    if origin is dict:
        return _dict_reader(_reader(arguments[1]))
    if origin is Literal or (isinstance(kind, type) and issubclass(kind, Enum)):
        return _choice_reader({one.value: one for one in kind} if origin is None else arguments)
    return _plain_reader(kind)


def _record_reader(kind: type) -> Callable[[Any, str], Any]:
    hints = typing.get_type_hints(kind)
    names = dict(_fields(kind))

    def read(data: Any, what: str) -> Any:
        if not isinstance(data, dict):
            raise RecordError(f"{what} must be an object, got {_short(data)}")
        if unknown := sorted(data.keys() - names.keys()):
            raise RecordError(f"{what} has an unknown key {unknown[0]!r}")
        for name, default in names.items():
            if default is MISSING and name not in data:
                raise RecordError(f"{what} is missing {name!r}")
        values = {
            name: _reader(hints[name])(value, f"{what}.{name}") for name, value in data.items()
        }
        return kind(**values)

    return read


def _union_reader(kinds: tuple[Any, ...]) -> Callable[[Any, str], Any]:
    """Build a function that validates a JSON value and converts it to one of the given types.

    If the value has none of the types in ``kinds``, the error describes the mismatch with the first
    type.
    """
    readers = [_reader(kind) for kind in kinds if kind is not type(None)]

    def read(data: Any, what: str) -> Any:
        if data is None and len(readers) < len(kinds):
            return None
        for reader in readers[1:]:
            try:
                return reader(data, what)
            except RecordError:
                pass
        return readers[0](data, what)

    return read


def _list_reader(
    collect: Callable[[Any], Any], reader: Callable[[Any, str], Any]
) -> Callable[[Any, str], Any]:
    def read(data: Any, what: str) -> Any:
        if not isinstance(data, list):
            raise RecordError(f"{what} must be a list, got {_short(data)}")
        return collect(reader(item, f"{what}[{i}]") for i, item in enumerate(data))

    return read


def _tuple_reader(readers: list[Callable[[Any, str], Any]]) -> Callable[[Any, str], Any]:
    def read(data: Any, what: str) -> Any:
        if not isinstance(data, list) or len(data) != len(readers):
            raise RecordError(f"{what} must be a list of {len(readers)}, got {_short(data)}")
        return tuple(
            reader(item, f"{what}[{i}]")
            for i, (reader, item) in enumerate(zip(readers, data, strict=True))
        )

    return read


def _dict_reader(reader: Callable[[Any, str], Any]) -> Callable[[Any, str], Any]:
    def read(data: Any, what: str) -> Any:
        if not isinstance(data, dict):
            raise RecordError(f"{what} must be an object, got {_short(data)}")
        return {key: reader(item, f"{what}[{key!r}]") for key, item in data.items()}

    return read


def _choice_reader(choices: Any) -> Callable[[Any, str], Any]:
    known = choices if isinstance(choices, dict) else {choice: choice for choice in choices}

    def read(data: Any, what: str) -> Any:
        if not isinstance(data, str) or data not in known:
            raise RecordError(f"{what} must be one of {', '.join(known)}, got {_short(data)}")
        return known[data]

    return read


def _plain_reader(kind: Any) -> Callable[[Any, str], Any]:
    """Build a function that validates a string, number or boolean read from JSON.

    Where a float is expected, an int is accepted too.
    """
    accepted = (int, float) if kind is float else (kind,)

    def read(data: Any, what: str) -> Any:
        if kind is not Any and type(data) not in accepted:
            raise RecordError(f"{what} must be {_NAMES[kind]}, got {_short(data)}")
        return data

    return read


_NAMES = {str: "a string", int: "a whole number", float: "a number", bool: "true or false"}


def _short(data: Any) -> str:
    text = repr(data)
    return text if len(text) <= 60 else f"{text[:57]}..."
