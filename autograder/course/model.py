"""A course as its file describes it, once every mistake in the file is corrected."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import Literal

from autograder.manifest import Chapter


@dataclass(frozen=True)
class LatePolicy:
    """The price of each day, or part of a day, after the due date, and the highest price.

    A percentage is one of the points possible.
    """

    per_day: float
    unit: Literal["points", "percent"]
    cap: float | None = None

    @property
    def words(self) -> str:
        """The policy as a sentence."""
        of = "percent of the points possible" if self.unit == "percent" else "points"
        cap = "" if self.cap is None else f", and at most {self.cap:g} {self.unit} in all"
        return f"Each day or part of a day costs {self.per_day:g} {of}{cap}."


@dataclass(frozen=True)
class Deadline:
    """When an assignment is due, for everybody and for students with an extension.

    Every time has a time zone. Without a policy, lateness is reported and costs nothing.
    """

    due: datetime
    policy: LatePolicy | None = None
    extensions: Mapping[str, datetime] = field(default_factory=dict)


@dataclass(frozen=True)
class Work:
    """What students do for one assignment, and how it is graded.

    ``chapters`` have only the exercises of the assignment, with its points. ``given`` chapters are
    complete. ``earlier`` lists the exercises of earlier assignments on which this one builds.
    ``roster`` is the class list.
    """

    name: str
    chapters: list[Chapter]
    given: list[Chapter] = field(default_factory=list)
    title: str = ""
    earlier: list[str] = field(default_factory=list)
    deadline: Deadline | None = None
    hidden: Path | None = None
    seed: str | None = None
    roster: Path | None = None


@dataclass(frozen=True)
class Course:
    """The assignments of a term, in the order in which students do them."""

    assignments: list[Work]
    title: str = ""
