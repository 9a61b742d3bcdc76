"""The events that a check process sends to report its progress, one JSON object per line."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Literal

from autograder.message import NOTHING, Message
from autograder.records import from_json, to_json


@dataclass(frozen=True)
class Check:
    """A check that the check process is going to run.

    ``rationale`` is None unless the check is hidden. It is the only part of a hidden check that
    students see. The ``name`` of a hidden check says nothing about it, in contrast to
    ``real_name``.
    """

    name: str
    exercise: str
    weight: float
    robust: bool
    rationale: str | None
    real_name: str


@dataclass(frozen=True)
class Checks:
    """An event sent when pytest has collected the checks.

    It lists the checks in the order in which they will run.
    """

    checks: list[Check]


@dataclass(frozen=True)
class Importing:
    """An event sent before the check process imports one of the student's modules.

    If the process dies during the import, that module is to blame.
    """

    module: str


@dataclass(frozen=True)
class Imported:
    """An event sent when the import announced by an ``Importing`` event has finished."""


@dataclass(frozen=True)
class Broken:
    """An event sent if one of the student's modules cannot be imported."""

    module: str
    message: Message


@dataclass(frozen=True)
class Started:
    """An event sent when a check begins.

    If the process dies afterwards, this event shows which check was running.
    """

    name: str


@dataclass(frozen=True)
class Decided:
    """An event sent when the verdict on a check is known.

    The status "error" means that the failure lies in the grader, not in the student's code.
    """

    name: str
    status: Literal["passed", "failed", "error"]
    message: Message = NOTHING
    on_chart: tuple[float, float] | None = None


@dataclass(frozen=True)
class Ended:
    """An event sent by a check process after its last check."""


Event = Checks | Importing | Imported | Broken | Started | Decided | Ended
KINDS: dict[str, type[Event]] = {
    kind.__name__: kind for kind in (Checks, Importing, Imported, Broken, Started, Decided, Ended)
}


def write_event(event: Event) -> str:
    """Convert an event of a check process to one line of JSON."""
    return json.dumps({type(event).__name__: to_json(event)}) + "\n"


def read_event(line: str) -> Event:
    """Parse one line of a check process's output, and return the event that it describes.

    Raises:
        ValueError: The line is not an event.
    """
    event = json.loads(line)
    if not isinstance(event, dict) or len(event) != 1:
        raise ValueError("an event must be an object with one key")
    ((name, data),) = event.items()
    if name not in KINDS:
        raise ValueError(f"there is no event {name!r}")
    return from_json(KINDS[name], data)
