"""What the process of the checks tells the runner, one JSON object a line."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Literal

from autograder.message import NOTHING, Message
from autograder.records import from_json, to_json


@dataclass(frozen=True)
class Check:
    """A check that is to be run. A hidden one has a rationale, which is all that is told of it."""

    name: str
    exercise: str
    weight: float
    robust: bool
    rationale: str | None


@dataclass(frozen=True)
class Checks:
    """All the checks of the run, in their order."""

    checks: list[Check]


@dataclass(frozen=True)
class Importing:
    """The import of a student's module begins."""

    module: str


@dataclass(frozen=True)
class Imported:
    """The import that had begun is done."""


@dataclass(frozen=True)
class Broken:
    """A student's module cannot be imported."""

    module: str
    message: Message


@dataclass(frozen=True)
class Started:
    """A check begins."""

    name: str


@dataclass(frozen=True)
class Decided:
    """A check has ended: passed, failed, or error where that is the grader's fault."""

    name: str
    status: Literal["passed", "failed", "error"]
    message: Message = NOTHING
    on_chart: tuple[float, float] | None = None


@dataclass(frozen=True)
class Ended:
    """All checks have ended."""


Event = Checks | Importing | Imported | Broken | Started | Decided | Ended
KINDS: dict[str, type[Event]] = {
    kind.__name__: kind for kind in (Checks, Importing, Imported, Broken, Started, Decided, Ended)
}


def write_event(event: Event) -> str:
    """Return the line for an event."""
    return json.dumps({type(event).__name__: to_json(event)}) + "\n"


def read_event(line: str) -> Event:
    """Return the event that a line stands for. Raises ValueError where it stands for none."""
    told = json.loads(line)
    if not isinstance(told, dict) or len(told) != 1:
        raise ValueError("an event is an object with one key")
    ((name, data),) = told.items()
    if name not in KINDS:
        raise ValueError(f"there is no event {name!r}")
    return from_json(KINDS[name], data)
