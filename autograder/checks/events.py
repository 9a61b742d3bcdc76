"""The events that a check process sends to the runner, as one JSON object per line."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Literal

from autograder.message import NOTHING, Message
from autograder.records import from_json, to_json


@dataclass(frozen=True)
class Check:
    """A check that will be run.

    For a hidden check, students see only the ``rationale``.
    """

    name: str
    exercise: str
    weight: float
    robust: bool
    rationale: str | None


@dataclass(frozen=True)
class Checks:
    """All checks of the run, in order."""

    checks: list[Check]


@dataclass(frozen=True)
class Importing:
    """The process is about to import a module of the student's."""

    module: str


@dataclass(frozen=True)
class Imported:
    """The import that was announced last has finished."""


@dataclass(frozen=True)
class Broken:
    """A module of the student's cannot be imported."""

    module: str
    message: Message


@dataclass(frozen=True)
class Started:
    """A check begins."""

    name: str


@dataclass(frozen=True)
class Decided:
    """A check has ended. Its status is passed, failed, or error if the grader is at fault."""

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
    """Return the line that represents an event."""
    return json.dumps({type(event).__name__: to_json(event)}) + "\n"


def read_event(line: str) -> Event:
    """Parse ``line`` and return the event.

    Raises:
        ValueError: The line does not contain an event.
    """
    event = json.loads(line)
    if not isinstance(event, dict) or len(event) != 1:
        raise ValueError("an event must be an object with one key")
    ((name, data),) = event.items()
    if name not in KINDS:
        raise ValueError(f"there is no event {name!r}")
    return from_json(KINDS[name], data)
