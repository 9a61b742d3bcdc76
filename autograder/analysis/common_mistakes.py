"""Find the mistakes that are common in a class, from the likely mistakes that messages name."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from autograder.checks.verdict import Verdict
from autograder.message import Kind
from autograder.reports.report import StudentReport

MOST = 5  # misconceptions; more would not fit into one lecture
SHARED_BY = 2  # students; if only one student made a mistake, it is shown on that student's page
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


@dataclass(frozen=True)
class Mistake:
    """A mistake that students made, as described in the messages of their failed checks."""

    words: str  # the most common wording
    students: set[str]
    exercises: list[str]
    read: list[str]  # lessons and sections of the book
    robust: bool  # whether only robust checks caught it
    in_values: bool  # whether the code ran, and computed a wrong value


def mistakes_of(reports: Sequence[StudentReport]) -> tuple[list[Mistake], int]:
    """Collect the mistakes in the reports on a class, with the most common ones first.

    Only failed checks count, because the mistake behind a blocked or inherited one lies elsewhere.
    Messages that differ only in their numbers, which depend on the seed, name the same mistake. The
    failed checks that name no likely mistake are counted, including all hidden checks, because
    their messages must not reveal what they test.
    """
    found: dict[str, list[tuple[str, str, Verdict]]] = {}
    unexplained = 0
    for report in reports:
        for result in report.results:
            for check in result.checks:
                if check.status != "failed" or check.message.kind is Kind.UNWRITTEN:
                    continue
                if not check.message.likely or check.hidden:
                    unexplained += 1
                    continue
                same = found.setdefault(NUMBER.sub("#", check.message.likely), [])
                same.append((report.student, result.exercise.id, check))
    mistakes = map(_mistake, found.values())
    return sorted(mistakes, key=lambda m: (-len(m.students), m.robust, m.words)), unexplained


def _mistake(lost: list[tuple[str, str, Verdict]]) -> Mistake:
    students, exercises, checks = zip(*lost, strict=True)
    messages = [check.message for check in checks]
    return Mistake(
        words=Counter(message.likely for message in messages).most_common(1)[0][0],
        students={*students},
        exercises=[*dict.fromkeys(exercises)],
        read=[*dict.fromkeys(message.read for message in messages if message.read)],
        robust=all(check.robust for check in checks),
        in_values=any(m.wanted and m.kind is Kind.FAILED for m in messages),
    )


def misconceptions(mistakes: Sequence[Mistake]) -> list[Mistake]:
    """Return the most common wrong results in the physics, which are worth a lecture."""
    physics = [one for one in mistakes if one.in_values and not one.robust]
    return [one for one in physics if len(one.students) >= SHARED_BY][:MOST]
