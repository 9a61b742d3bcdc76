"""Compute how many days late a submission is, and how many points the student loses for that."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta

from autograder.course.model import Deadline, LatePolicy
from autograder.reports.report import Late
from autograder.scores import shown


@dataclass(frozen=True)
class HandedIn:
    """The time of a submission, and the platform or file that reports it."""

    source: str
    at: datetime | None = None
    late: bool = False  # for Canvas, which does not report the time


def days_late(due: datetime, submitted: datetime) -> int:
    """Count how many days late a submission is, where any part of a day counts as a full day.

    Each late day begins at the hour at which the work was due, in the time zone of ``due``. A day
    on which the clocks change therefore has 23 or 25 hours.
    """
    at = submitted.astimezone(UTC)
    if at <= due.astimezone(UTC):
        return 0
    days = max(1, (at - due.astimezone(UTC)).days - 1)
    while _end(due + timedelta(days=days)) < at:
        days += 1
    return days


def _end(time: datetime) -> datetime:
    """Convert to UTC, where the second occurrence of a time that clocks show twice counts."""
    return max(time.replace(fold=fold).astimezone(UTC) for fold in (0, 1))


def deduction(policy: LatePolicy, days: int, possible: float) -> float:
    """Compute the points for ``days`` late days, if ``possible`` ones can be earned."""
    price = policy.per_day * days
    if policy.cap is not None:
        price = min(price, policy.cap)
    return round(price * possible / 100 if policy.unit == "percent" else price, 2)


def late_of(
    deadline: Deadline, granted: Sequence[datetime], said: HandedIn | None, possible: float
) -> Late:
    """Compute the lateness of a submission and the resulting penalty, with an explanation."""
    due = max([deadline.due, *granted], key=lambda time: time.astimezone(UTC))
    was = f"It was due {clock(due)}{' (extended)' if granted else ''}."
    if said is None:
        return Late(None, 0.0, f"{was} The submission time is unknown, so there is no penalty.")
    if said.at is None and said.late:
        words = f"{said.source} says that it is late, but not by how much, so there is no penalty."
        return Late(None, 0.0, f"{was} {words}")
    if said.at is None:
        return Late(0, 0.0, f"{was} {said.source} says that it was handed in on time.")
    local = said.at.astimezone(due.tzinfo)
    when = f"{was} It was handed in {clock(local)}, according to {said.source}."
    days = days_late(due, said.at)
    if not days:
        return Late(0, 0.0, f"{when} That is on time.")
    late = f"{when} That is {days} {'day' if days == 1 else 'days'} late."
    if deadline.policy is None:
        return Late(days, 0.0, f"{late} There is no penalty.")
    cost = deduction(deadline.policy, days, possible)
    return Late(days, cost, f"{late} {deadline.policy.words} Here that is {shown(cost)} points.")


def clock(time: datetime) -> str:
    """Format a time for people to read, as in 2026-10-23 23:59 CEST."""
    return f"{time:%Y-%m-%d %H:%M} {time.tzname()}"
