"""Find the mistakes that the students of a class have made.

The message of a failed check usually suggests a likely mistake. Counting these messages shows which
mistakes are common.
"""

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
    """A mistake that students made, as described in the messages of their failed checks.

    Attributes:
        words: The message, such as "This is the squared length. Take its square root."
        students: The students who have made the mistake.
        exercises: The exercises in which they made it.
        read: The lessons and sections of the book that explain the topic.
        robust: True if the mistake was caught only by robust checks, which try bad arguments,
            overflow and NaN.
        in_values: True if the student's code runs but computes a wrong value. False if the code is
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
    """The mistakes that the students of a class made, with the most common ones first.

    ``unexplained`` is the number of failed checks whose messages do not suggest a likely mistake.
    This includes all hidden checks, because their messages must not reveal what they test.
    """

    found: list[Mistake]
    unexplained: int

    @property
    def misconceptions(self) -> list[Mistake]:
        """The most common physics mistakes in the class, which are worth reviewing in a lecture.

        The list contains at most five mistakes. Each of them was made by at least two students.
        """
        physics = [one for one in self.found if one.in_values and not one.robust]
        return [one for one in physics if len(one.students) >= SHARED_BY][:MOST]


def mistakes_of(reports: Sequence[StudentReport]) -> Mistakes:
    """Collect the mistakes that are described in the reports on a class's students.

    Only checks with the status "failed" count. If a check is blocked or inherited, the mistake lies
    in another exercise or chapter, and is counted there. Messages that differ only in their numbers
    count as the same mistake, because those numbers depend on the random seed.
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
