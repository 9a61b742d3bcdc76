"""Find the mistakes that are common in a class, from the likely mistakes that messages name."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

from autograder.message import Kind
from autograder.reports.report import StudentReport

MOST = 5  # misconceptions; more would not fit into one lecture
SHARED_BY = 2  # students; if only one student made a mistake, it is shown on that student's page
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


@dataclass
class Mistake:
    """A mistake that students made, as described in the messages of their failed checks."""

    wordings: Counter[str] = field(default_factory=Counter)
    students: dict[str, None] = field(default_factory=dict)  # in the order in which they appear
    exercises: dict[str, None] = field(default_factory=dict)
    read: dict[str, None] = field(default_factory=dict)  # lessons and sections of the book
    robust: bool = True  # whether only robust checks caught it
    in_values: bool = False  # whether the code ran, and computed a wrong value

    @property
    def words(self) -> str:
        """The most common wording, such as "This is the squared length. Take its square root."."""
        return self.wordings.most_common(1)[0][0]


def mistakes_of(reports: Sequence[StudentReport]) -> tuple[list[Mistake], int]:
    """Collect the mistakes in the reports on a class, with the most common ones first.

    Only checks with the status "failed" count. If a check is blocked or inherited, the mistake lies
    elsewhere, and is counted there. Messages that differ only in their numbers count as the same
    mistake, because those numbers depend on the random seed.

    Returns:
        The mistakes, and the number of failed checks that name no likely mistake. This includes all
        hidden checks, because their messages must not reveal what they test.
    """
    found: dict[str, Mistake] = {}
    unexplained = 0
    for report in reports:
        for result in report.results:
            for check in result.checks:
                message = check.message
                if check.status != "failed" or message.kind is Kind.UNWRITTEN:
                    continue
                if not message.likely or check.hidden:
                    unexplained += 1
                    continue
                one = found.setdefault(NUMBER.sub("#", message.likely), Mistake())
                one.wordings[message.likely] += 1
                one.students[report.student] = one.exercises[result.exercise.id] = None
                if message.read:
                    one.read[message.read] = None
                one.robust = one.robust and check.robust
                is_value = bool(message.wanted) and message.kind is Kind.FAILED
                one.in_values = one.in_values or is_value
    order = sorted(found.values(), key=lambda one: (-len(one.students), one.robust, one.words))
    return order, unexplained


def misconceptions(mistakes: Sequence[Mistake]) -> list[Mistake]:
    """Return the most common wrong results in the physics, which are worth a lecture."""
    physics = [one for one in mistakes if one.in_values and not one.robust]
    return [one for one in physics if len(one.students) >= SHARED_BY][:MOST]
