"""The assignments, deadlines and late policies that an instructor describes in a course file.

These objects are created only if the file has no mistakes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import Literal

from autograder.manifest import Chapter


@dataclass(frozen=True)
class LatePolicy:
    """How many points a submission loses for each day that it is late, and the most it can lose.

    A part of a day counts as a full day. If ``unit`` is "percent", the numbers are percentages of
    the points that the assignment is worth.
    """

    per_day: float
    unit: Literal["points", "percent"]
    cap: float | None = None

    @property
    def words(self) -> str:
        """The penalty for late work, described in a sentence for students.

        One example is "Each day or part of a day costs 2 points."
        """
        of = "percent of the points possible" if self.unit == "percent" else "points"
        cap = "" if self.cap is None else f", and at most {self.cap:g} {self.unit} in all"
        return f"Each day or part of a day costs {self.per_day:g} {of}{cap}."


@dataclass(frozen=True)
class Deadline:
    """When an assignment is due, and the penalty for late work.

    ``extensions`` has the later due dates of individual students. Every time has a time zone.
    Without a late policy, the reports still say how late a submission is, but it loses no points.
    """

    due: datetime
    policy: LatePolicy | None = None
    extensions: Mapping[str, datetime] = field(default_factory=dict)


@dataclass(frozen=True)
class Work:
    """An assignment: the exercises that students have to do, and how they are graded.

    ``chapters`` contain only the assigned exercises, with their points in this assignment. The
    ``given`` chapters are handed out complete. ``earlier`` lists exercises from earlier assignments
    that this one builds on. ``hidden`` is the folder of hidden checks. ``roster`` is the path of
    the class list.
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
    """All the assignments of a term, in the order in which students do them."""

    assignments: list[Work]
    title: str = ""
