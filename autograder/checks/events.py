"""The events that a check process sends to report its progress, one JSON object per line."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

from autograder.checks.verdict import Point
from autograder.message import NOTHING, Kind, Message, Place
from autograder.records import to_json


@dataclass(frozen=True)
class Check:
    """A check that is going to run. A hidden check has a rationale, all that students see of it."""

    name: str  # says nothing about a hidden check
    exercise: str
    weight: float
    robust: bool
    rationale: str | None
    real_name: str


@dataclass(frozen=True)
class Checks:
    """Lists the checks that pytest has collected, in the order in which they will run."""

    checks: list[Check]


@dataclass(frozen=True)
class Importing:
    """Announces the import of a student's module, which is to blame if the process dies."""

    module: str


@dataclass(frozen=True)
class Imported:
    """Reports that the import that ``Importing`` announced has finished."""


@dataclass(frozen=True)
class Broken:
    """Reports that one of the student's modules cannot be imported."""

    module: str
    message: Message


@dataclass(frozen=True)
class Started:
    """Reports that a check begins. If the process dies, this check was running."""

    name: str


@dataclass(frozen=True)
class Decided:
    """Reports whether a check passed. An "error" is the fault of the grader."""

    name: str
    status: Literal["passed", "failed", "error"]
    message: Message = NOTHING
    on_chart: Point | None = None


@dataclass(frozen=True)
class Ended:
    """Reports that the process has run its last check."""


Event = Checks | Importing | Imported | Broken | Started | Decided | Ended
KINDS: dict[str, type[Event]] = {kind.__name__: kind for kind in Event.__args__}
READ: dict[str, Callable[[Any], Any]] = {  # what a value is read as, if it is not plain
    "checks": lambda checks: [Check(**check) for check in checks],
    "message": lambda message: Message(**_read(message)),
    "where": lambda place: Place(**place),
    "inside": lambda place: Place(**place),
    "kind": Kind,
    "blocked_by": tuple,
    "on_chart": tuple,
}


def write_event(event: Event) -> str:
    """Convert an event of a check process to one line of JSON."""
    return json.dumps({type(event).__name__: to_json(event)}) + "\n"


def read_event(line: str) -> Event:
    """Parse one line of a check process's output, or raise ValueError if it is not an event."""
    try:
        ((name, data),) = json.loads(line).items()
        return KINDS[name](**_read(data))
    except (AttributeError, KeyError, TypeError) as error:
        raise ValueError(f"an event is not what it must be: {error}") from error


def _read(data: dict[str, Any]) -> dict[str, Any]:
    return {key: READ[key](value) if key in READ else value for key, value in data.items()}
