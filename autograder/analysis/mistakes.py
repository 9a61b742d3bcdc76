"""Find out which mistakes a class has made, using the messages of the checks that failed."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

from autograder.message import Kind
from autograder.reports.report import CheckReport, StudentReport

MOST = 5  # misconceptions; more would not fit into one lecture
SHARED_BY = 2  # students; if only one student made a mistake, it is shown on that student's page
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


@dataclass
class Mistake:
    """A mistake that students have made, as the messages of their failed checks describe it.

    Attributes:
        words: The message about the mistake.
        students: Who has made it.
        exercises: In which exercises it was made.
        read: The sections of the book and the lessons that explain the topic.
        robust: Whether only robust checks have found it.
        in_values: Whether the code runs but computes a wrong value. If this is false, the code is
            incomplete or raises an error.
    """

    words: str
    students: list[str] = field(default_factory=list)
    exercises: list[str] = field(default_factory=list)
    read: list[str] = field(default_factory=list)
    robust: bool = True
    in_values: bool = False


@dataclass(frozen=True)
class Mistakes:
    """All mistakes of a class, starting with the one that most students made.

    ``unexplained`` counts the failed checks whose messages do not name a likely mistake. Hidden
    checks are always among them, because their messages must not reveal what they test.
    """

    found: list[Mistake]
    unexplained: int

    @property
    def misconceptions(self) -> list[Mistake]:
        """The most common mistakes in the physics, which deserve a few minutes of a lecture."""
        physics = [one for one in self.found if one.in_values and not one.robust]
        return [one for one in physics if len(one.students) >= SHARED_BY][:MOST]


def mistakes_of(reports: Sequence[StudentReport]) -> Mistakes:
    """Collect the mistakes that the reports of a class describe.

    We count only checks with the status "failed". If a check is blocked or inherited, the mistake
    is in another exercise or chapter, and it is counted there. The numbers in a message depend on
    the random seed, so we treat two messages that differ only in their numbers as the same mistake.
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
