"""The contents of a course file. These objects are created only if the file has no mistakes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import Literal

from autograder.manifest import Chapter


@dataclass(frozen=True)
class LatePolicy:
    """The points that a late submission loses per day, and the most that it can lose.

    A day counts in full as soon as it has begun. A percentage is a percentage of the points that
    the assignment can give.
    """

    per_day: float
    unit: Literal["points", "percent"]
    cap: float | None = None

    @property
    def words(self) -> str:
        """The policy, written as a sentence."""
        of = "percent of the points possible" if self.unit == "percent" else "points"
        cap = "" if self.cap is None else f", and at most {self.cap:g} {self.unit} in all"
        return f"Each day or part of a day costs {self.per_day:g} {of}{cap}."


@dataclass(frozen=True)
class Deadline:
    """The due date of an assignment, and the later due dates of students with an extension.

    Every time has a time zone. Without a policy, lateness is reported but costs no points.
    """

    due: datetime
    policy: LatePolicy | None = None
    extensions: Mapping[str, datetime] = field(default_factory=dict)


@dataclass(frozen=True)
class Work:
    """One assignment: what students have to do, and how it is graded.

    ``chapters`` contain only the exercises of the assignment, with their points in the assignment.
    ``given`` chapters are complete. ``earlier`` lists exercises of earlier assignments that the
    assignment builds on. ``roster`` is the path of the class list.
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
    """All assignments of a term, in the order in which students do them."""

    assignments: list[Work]
    title: str = ""
