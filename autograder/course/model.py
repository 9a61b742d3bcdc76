"""The assignments, deadlines and late policies that an instructor describes in a course file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import Literal

from autograder.manifest import Chapter


@dataclass(frozen=True)
class LatePolicy:
    """The points that each day of lateness costs, and optionally the most that all days cost.

    A part of a day counts as a full day. If ``unit`` is "percent", both numbers are percentages of
    the points that the assignment is worth.
    """

    per_day: float
    unit: Literal["points", "percent"]
    cap: float | None = None

    @property
    def words(self) -> str:
        """A sentence for students, such as "Each day or part of a day costs 2 points."."""
        of = "percent of the points possible" if self.unit == "percent" else "points"
        cap = "" if self.cap is None else f", and at most {self.cap:g} {self.unit} in all"
        return f"Each day or part of a day costs {self.per_day:g} {of}{cap}."


@dataclass(frozen=True)
class Deadline:
    """When an assignment is due. All times have a time zone."""

    due: datetime
    policy: LatePolicy | None = None  # without one, late work loses no points
    extensions: Mapping[str, datetime] = field(default_factory=dict)  # by student


@dataclass(frozen=True)
class Work:
    """What students have to do, and how it is graded: an assignment, or whole chapters.

    ``earlier`` are the exercises of earlier assignments that it builds on, with the names of the
    first assignments that contain them.
    """

    name: str  # of the assignment, or ""
    chapters: list[Chapter]  # with only the assigned exercises, and their points here
    given: list[Chapter] = field(default_factory=list)  # students receive them as finished code
    title: str = ""
    earlier: Mapping[str, str] = field(default_factory=dict)
    deadline: Deadline | None = None
    hidden: Path | None = None  # the folder of hidden checks
    seed: str | None = None
    roster: Path | None = None


@dataclass(frozen=True)
class Course:
    """All the assignments of a term, in the order in which students do them."""

    assignments: list[Work]
