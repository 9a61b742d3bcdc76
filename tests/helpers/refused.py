"""Test that an error names the argument that it refuses, and shows its value."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import pytest

Refused = tuple[str, Any, Callable[[Any], object]]  # name, bad value, function of the value
Case = tuple[str, type[Exception], str, Any, Callable[[Any], object]]


def cases(tables: Mapping[type[Exception], Mapping[str, list[Refused]]]) -> list[Case]:
    """Return the rows of all tables, each with its chapter and the expected error."""
    return [
        (chapter, error, *row)
        for error, table in tables.items()
        for chapter, rows in table.items()
        for row in rows
    ]


def ids(cases: list[Case]) -> list[str]:
    return [f"{case[0]}-{case[2]}" for case in cases]


def names_the_argument(
    error: type[Exception], name: str, bad: Any, call: Callable[[Any], object]
) -> None:
    """Expect a refusal. A text stands for the shown value itself."""
    with pytest.raises(error) as refusal:
        call(bad)
    shown = bad if isinstance(bad, str) else repr(bad)
    assert name in str(refusal.value)
    assert shown in str(refusal.value)
