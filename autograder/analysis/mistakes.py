"""Collect the mistakes of a class from the messages of its failed checks."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

from autograder.message import Kind
from autograder.reports.report import CheckReport, StudentReport

MOST = 5  # misconceptions for one lecture
SHARED_BY = 2  # students; a mistake that only one student made is shown on that student's page
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


@dataclass
class Mistake:
    """A likely cause of failures, with the students and exercises that it affects.

    ``read`` lists the sections of the book and the lessons that explain the topic. ``robust`` is
    true if only robust checks found the mistake. ``in_values`` is true if the code runs but
    computes a wrong value. It is false if the code is incomplete or raises an error.
    """

    words: str
    students: list[str] = field(default_factory=list)
    exercises: list[str] = field(default_factory=list)
    read: list[str] = field(default_factory=list)
    robust: bool = True
    in_values: bool = False


@dataclass(frozen=True)
class Mistakes:
    """The mistakes of a class, ordered by the number of students who made them.

    ``unexplained`` counts the failed checks whose message names no likely cause. This includes all
    hidden checks, because their messages never name a cause.
    """

    found: list[Mistake]
    unexplained: int

    @property
    def misconceptions(self) -> list[Mistake]:
        """The most common mistakes in the physics, as topics for the next lecture."""
        physics = [one for one in self.found if one.in_values and not one.robust]
        return [one for one in physics if len(one.students) >= SHARED_BY][:MOST]


def mistakes_of(reports: Sequence[StudentReport]) -> Mistakes:
    """Collect the mistakes from the reports of a class.

    Only failed checks count. A blocked or inherited check fails because of a mistake in another
    exercise or chapter, so the mistake is counted for that exercise or chapter. The numbers in a
    message depend on the seed. Two messages that differ only in their numbers therefore count as
    the same mistake.
    """
    found: dict[str, Mistake] = {}
    wordings: dict[str, Counter[str]] = {}
    unexplained = 0
    for report in reports:
        for exercise in report.exercises:
            for check in filter(_is_mistake, exercise.checks):
                words, read = check.message.likely, check.message.read
                if not words or check.hidden:
                    unexplained += 1
                    continue
                key = NUMBER.sub("#", words)
                wordings.setdefault(key, Counter())[words] += 1
                one = found.setdefault(key, Mistake(words))
                for known, new in (
                    (one.students, report.student),
                    (one.exercises, exercise.id),
                    (one.read, read),
                ):
                    if new and new not in known:
                        known.append(new)
                one.robust = one.robust and check.robust
                is_value = bool(check.message.wanted) and check.message.kind is Kind.FAILED
                one.in_values = one.in_values or is_value
    for key, one in found.items():
        one.words = wordings[key].most_common(1)[0][0]
    ordered = sorted(found.values(), key=lambda one: (-len(one.students), one.robust, one.words))
    return Mistakes(ordered, unexplained)


def _is_mistake(check: CheckReport) -> bool:
    return check.status == "failed" and check.message.kind is not Kind.UNWRITTEN
