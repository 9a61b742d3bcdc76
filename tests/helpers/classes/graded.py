"""A small invented class with its reports, for testing the pages and files made from reports."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import msgspec

from autograder.checks.verdict import Secret, Status, Verdict
from autograder.manifest import Chapter, Exercise
from autograder.message import Message
from autograder.reports.report import Cause, StudentReport
from autograder.scores import ExerciseStatus, Result
from autograder.submissions.class_list import ClassList, Member
from autograder.submissions.find import Submission

SHOUT = "<script>document.title = 'owned'</script><b onclick='x'>&amp;\"'"
# Escape sequences, control characters, half a character, a reversal of the reading direction.
NASTY = (
    "\x1b[31mred\x1b[0m\x1b]8;;http://a.example\x07link\x00\x08\x9b1m\ud800\u202ereversed\r\nnext"
)


def exercise_of(exercise_id: str, title: str, kind: str, points: float) -> Exercise:
    return Exercise(exercise_id, title, kind, 1, points, [], [])


VECTORS = [
    exercise_of("B2.1", "Copy", "build", 2.0),
    exercise_of("2.2", "Angles", "exercise", 4.0),
    exercise_of("2.3", "Why", "written", 3.0),
]
CHAPTERS = [
    Chapter("ch02_vectors", 2, "Vectors", [], VECTORS),
    Chapter("ch03_laws", 3, "Laws", [], [exercise_of("B3.1", "Mass", "build", 5.0)]),
]


def class_of(*students: str) -> ClassList:
    """Return a class without a roster, in which these students have handed something in."""
    return ClassList([Member(s, s, None, Submission(s, Path(s))) for s in students])


def points_of(*chapters: Chapter) -> float:
    """Return the points that the checks of these chapters can give, without written answers."""
    return sum(e.points for c in chapters for e in c.exercises if e.kind != "written")


def check(
    name: str,
    status: Status,
    message: Message | str = "",
    *,
    hidden: bool = False,
    robust: bool = False,
) -> Verdict:
    shown = Message(message) if isinstance(message, str) else message
    secret = Secret(f"test_secret of {name}", Message("secret message")) if hidden else None
    return Verdict(name, "", 1.0, status, shown, hidden, None, robust, secret)


def message_of(check: dict[str, Any]) -> str:
    """Return the message of a check in a report's JSON data, formatted for people to read."""
    return str(msgspec.convert(check.get("message", {}), Message))


def report_of(student: str = "ada", **changes: Any) -> StudentReport:
    """Return a report with one exercise of each kind: passed, failed, waiting and inherited."""
    statuses: list[tuple[ExerciseStatus, float | None, float | None]]
    statuses = [("passed", 2.0, 2.0), ("failed", 1.0, 1.0), ("waiting", None, None)]
    statuses.append(("inherited", 0.0, 5.0))
    checks = [
        [check("test_a_copy", "passed"), check("test_secret_plan", "passed", hidden=True)],
        [
            check("test_right_angle", "passed"),
            check("test_angle", "failed", Message(got="1", wanted="2")),
            check("test_far_away", "failed", "Angles turn once round.", hidden=True),
        ],
        [],
        [check("test_mass", "inherited", "got 3")],
    ]
    places = [(chapter, exercise) for chapter in CHAPTERS for exercise in chapter.exercises]
    results = [
        Result(exercise, status, score, own_checks, chapter.number, given)
        for (chapter, exercise), (status, score, given), own_checks in zip(
            places, statuses, checks, strict=True
        )
    ]
    report = StudentReport(
        student=student,
        status="graded",
        seed="7",
        isolation="none: an ordinary process",
        score=3.0,
        score_on_given=8.0,
        points=11.0,
        by_hand=None,
        waiting=3.0,
        earlier=[2],
        notes=[],
        results=results,
    )
    return replace(report, **changes)


def with_exercise(report: StudentReport, number: int, **changes: Any) -> StudentReport:
    """Return a copy of a report in which the result on one exercise has been changed."""
    results = [*report.results]
    results[number] = replace(results[number], **changes)
    return replace(report, results=results)


def with_words(report: StudentReport, text: str) -> StudentReport:
    """Return a copy of a report in which every check has this text as its name and its message."""
    results = [
        replace(r, checks=[replace(c, name=text, message=Message(text)) for c in r.checks])
        for r in report.results
    ]
    return replace(report, results=results)


def failed_run(student: str = "eve") -> StudentReport:
    """Return a report in which the grader failed on the last exercise."""
    report = report_of(student, status="error, retry", score=None, score_on_given=None)
    lost = [check("every check", "error", "the disk is full")]
    return with_exercise(report, 3, status="error", score=None, score_on_given=None, checks=lost)


def cause_of(
    text: str = "B2.0", status: ExerciseStatus = "failed", *more: Verdict, of: str = "lab1"
) -> Cause:
    """Return an exercise of an earlier assignment on which the failed exercise 2.2 builds."""
    checks = [check("test_zero", "passed"), check("test_one", "failed", f"{text} is wrong"), *more]
    exercise = exercise_of(text, f"Title of {text}", "build", 2.0)
    return Cause(Result(exercise, status, None, checks, chapter=2), of, ["2.2"])


def blocked(student: str = "cy") -> StudentReport:
    """Return a report in which an exercise of an earlier assignment blocks a graded one."""
    report = report_of(student, causes=[cause_of("B2.00", "blocked"), cause_of()])
    lost = [check("test_angle", "blocked", Message("wrong", blocked_by=("B2.0 (Title)",)))]
    return with_exercise(report, 1, status="blocked", checks=lost)


def nothing_done(student: str = "eli") -> StudentReport:
    report = report_of(student, score=0.0, score_on_given=0.0)
    lost = [check("test_it", "failed", "vector.py is missing")]
    for number, result in enumerate(report.results):
        if result.exercise.kind != "written":
            report = with_exercise(
                report, number, status="failed", score=0.0, score_on_given=0.0, checks=lost
            )
    return report


def hostile(student: str = SHOUT + NASTY) -> StudentReport:
    """Return a report in which every untrusted text tries to inject something into the page."""
    text = SHOUT + NASTY + "x" * 20_000
    report = report_of(student, notes=[text], seed=text, isolation=text, by_hand=1.0, waiting=0)
    report = replace(report, causes=[cause_of(text, of=text)])
    return with_exercise(with_words(report, text), 2, status="marked", score=1.0, comment=text)
