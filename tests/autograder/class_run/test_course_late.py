"""Late work: days by the clock on the wall, penalties with caps, and where times come from."""

from __future__ import annotations

import math
import random
from dataclasses import replace
from datetime import UTC, datetime, timedelta, timezone
from pathlib import Path
from typing import Any
from zoneinfo import ZoneInfo

import pytest

from autograder.course.dates import deadline_from_json, deadline_to_json
from autograder.course.late import HandedIn, days_late, deduction, late_of
from autograder.course.model import Deadline, LatePolicy
from autograder.course.of_class import late_on_gradescope, lateness
from autograder.course.times import times_of
from autograder.reports.marks import Mark, apply_marks
from autograder.submissions.exports import read_export
from autograder.submissions.find import Submission
from graded import CHAPTERS, failed_run, report_of

BERLIN = ZoneInfo("Europe/Berlin")
FALL = datetime(2026, 10, 23, 23, 59, tzinfo=BERLIN)  # 21:59 UTC; clocks go back on the 25th
SPRING = datetime(2027, 3, 27, 23, 59, tzinfo=BERLIN)  # 22:59 UTC; clocks go forward on the 28th
FIXED = datetime(2026, 10, 23, 23, 59, tzinfo=timezone(timedelta(hours=2)))
NIGHT = datetime(2026, 10, 24, 2, 30, tzinfo=BERLIN)  # the clocks show this twice on the 25th
FIVE = LatePolicy(5, "points")


@pytest.mark.parametrize(
    ("due", "submitted", "days"),
    [
        (FALL, "2026-10-01 00:00:00", 0),
        (FALL, "2026-10-23 21:59:00", 0),
        (FALL, "2026-10-23 21:59:01", 1),
        (FALL, "2026-10-24 21:59:00", 1),
        (FALL, "2026-10-24 21:59:01", 2),
        (FALL, "2026-10-25 22:59:00", 2),  # a day of 25 hours
        (FALL, "2026-10-25 22:59:01", 3),
        (FALL, "2027-10-23 21:59:00", 365),
        (SPRING, "2027-03-28 21:59:00", 1),  # a day of 23 hours
        (SPRING, "2027-03-28 21:59:01", 2),
        (FIXED, "2026-10-25 21:59:00", 2),  # an offset knows no change of the clocks
        (FIXED, "2026-10-25 22:59:00", 3),
        (NIGHT, "2026-10-25 01:30:00", 1),  # 02:30 for the second time
        (NIGHT, "2026-10-25 01:30:01", 2),
    ],
)
def test_the_late_days_are_those_of_the_clock_on_the_wall(
    due: datetime, submitted: str, days: int
) -> None:
    at = datetime.fromisoformat(submitted).replace(tzinfo=UTC)
    assert days_late(due, at) == days
    assert days_late(due, at.astimezone(ZoneInfo("Asia/Tokyo"))) == days, "wherever it is written"


def test_the_late_days_agree_with_the_difference_of_two_clocks() -> None:
    rng = random.Random(7)
    for _ in range(300):
        zone = ZoneInfo(rng.choice(["Europe/Berlin", "America/New_York", "Australia/Sydney"]))
        due = datetime(2026, rng.randint(1, 12), rng.randint(1, 28), 12, 0, tzinfo=zone)
        at = due.astimezone(UTC) + timedelta(minutes=rng.randint(-9000, 40_000))
        passed = at.astimezone(zone).replace(tzinfo=None) - due.replace(tzinfo=None)
        assert days_late(due, at) == max(0, math.ceil(passed / timedelta(days=1))), (due, at)


@pytest.mark.parametrize(
    ("policy", "days", "possible", "points"),
    [
        (FIVE, 0, 40, 0),
        (FIVE, 3, 40, 15),
        (LatePolicy(5, "points", 12), 3, 40, 12),
        (LatePolicy(10, "percent"), 3, 40, 12),
        (LatePolicy(10, "percent", 25), 3, 40, 10),
        (LatePolicy(10, "percent", 25), 2, 40, 8),
        (LatePolicy(1, "percent"), 1, 33.33, 0.33),
    ],
)
def test_the_price_is_that_of_the_days_up_to_the_cap(
    policy: LatePolicy, days: int, possible: float, points: float
) -> None:
    assert deduction(policy, days, possible) == points


def test_the_penalty_is_apart_from_the_points_and_never_more_than_they_are() -> None:
    """The invented report has 3 points from checks, and 2 by hand once they are marked."""
    at = FALL + timedelta(hours=30)
    late = late_of(Deadline(FALL, LatePolicy(2, "points")), ["ada"], HandedIn("it", at), 14)
    report = report_of(late=late)
    assert (report.score, report.earned, report.penalty, report.total) == (3, 3, 3, 0)
    marked = apply_marks(report, {("ada", "2.3"): Mark(2, "")})
    assert (marked.score, marked.earned, marked.penalty, marked.total) == (3, 5, 4, 1)
    failed = failed_run()
    assert (failed.earned, failed.penalty, failed.total) == (None, 0, None)


def test_an_extension_moves_the_due_date_of_one_student() -> None:
    longer = datetime(2026, 10, 25, 23, 59, tzinfo=BERLIN)
    deadline = Deadline(FALL, FIVE, {"ann": longer})
    said = HandedIn("times.csv", longer)
    assert late_of(deadline, ["ann"], said, 10).days == 0
    assert "due 2026-10-25 23:59 CET (extended)" in late_of(deadline, ["ann"], said, 10).words
    bob = late_of(deadline, ["bob"], said, 10)
    assert (bob.days, bob.deduction) == (2, 10)
    assert bob.words == (
        "It was due 2026-10-23 23:59 CEST. It was handed in 2026-10-25 23:59 CET, according to "
        "times.csv. That is 2 days late. Each day or part of a day costs 5 points. Here that is "
        "10 points."
    )


@pytest.mark.parametrize(
    ("said", "words"),
    [
        (None, "The submission time is unknown, so there is no penalty."),
        (HandedIn("Canvas", late=True), "late, but not by how much, so there is no penalty."),
    ],
)
def test_without_a_time_there_is_no_penalty_and_the_words_say_so(said: Any, words: str) -> None:
    late = late_of(Deadline(FALL, FIVE), ["ann"], said, 10)
    assert (late.days, late.deduction) == (None, 0)
    assert late.words.endswith(words)


EXPORT = """\
submission_17:
  :submitters:
  - :name: Ann
    :sid: '1'
  :created_at: 2026-10-24 10:00:00.123456000 Z
submission_18:
  :created_at:
"""
GRADES = """\
"assignment_name","student_repository_name","submission_timestamp","points_awarded"
"lab1","lab1-bob","2026-10-24 11:00:00 UTC","3"
"lab1","lab1-cem","","0"
"""


def test_times_come_from_the_best_source_that_knows_one(tmp_path: Path) -> None:
    (tmp_path / "submission_metadata.yml").write_text(EXPORT, encoding="utf-8")
    (tmp_path / "grades.csv").write_text(GRADES, encoding="utf-8")
    times = (
        "student;submitted\nfay;2026-10-24 12:00\n\ngil;2026-10-24T12:00:00-04:00\nnobody;2026\n"
    )
    (tmp_path / "times.csv").write_text(times.replace("2026\n", "2026-01-01\n"), encoding="utf-8")
    names = ["submission_17", "submission_18", "lab1-bob", "lab1-cem", "fay", "gil_7_8_work.zip"]
    names += ["dee_LATE_12_34_work.zip", "eli_56_78_ch02-1.zip", "hal"]
    submissions = [
        Submission(Path(name).stem, tmp_path / name, read_export(Path(name).stem)) for name in names
    ]
    submissions[5] = replace(submissions[5], student="Gil Lee", aliases=("gil",))  # of a roster
    found = times_of(tmp_path, submissions, BERLIN)
    said = {name: (one.source, one.at, one.late) for name, one in found.items()}
    at = datetime(2026, 10, 24, 10, 0, tzinfo=UTC)
    assert said == {
        "submission_17": ("Gradescope", at.replace(microsecond=123456), False),
        "lab1-bob": ("GitHub Classroom", at + timedelta(hours=1), False),
        "fay": ("times.csv", at, False),  # 12:00 in Berlin
        "Gil Lee": ("times.csv", at + timedelta(hours=6), False),
        "dee_LATE_12_34_work": ("Canvas", None, True),
        "eli_56_78_ch02-1": ("Canvas", None, False),
    }


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("name,time\n", r"line 1: the header must be student,submitted, got 'name,time'"),
        (
            "student,submitted\nann,soon\nbob,2026-10-24,x\nann,2026-10-24\n",
            r"(?s)line 2: a time looks like .*, got 'soon'.*line 3: .* 2 cells, got 3"
            r".*line 4: a second time for 'ann'",
        ),
    ],
)
def test_wrong_lines_of_times_are_reported_together(tmp_path: Path, text: str, words: str) -> None:
    (tmp_path / "times.csv").write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=words):
        times_of(tmp_path, [], BERLIN)


def test_the_instructor_hears_of_unknown_times_and_of_extensions_that_fit_nobody(
    tmp_path: Path,
) -> None:
    submissions = [
        Submission("ann", tmp_path / "ann"),
        Submission("bob", tmp_path / "bob", aliases=("bob@example.org",)),
    ]
    (tmp_path / "times.csv").write_text("student,submitted\nann,2026-10-27\n", encoding="utf-8")
    late, notes = lateness(
        Deadline(FALL, LatePolicy(10, "percent"), {"anne": FALL, "bob@example.org": FALL}),
        CHAPTERS,
        tmp_path,
        submissions,
    )
    assert "(extended)" in late["bob"].words, "by another name of the roster"
    assert (late["ann"].days, late["ann"].deduction) == (4, 4 * 1.4), "of 14 points possible"
    assert (late["bob"].days, late["bob"].deduction) == (None, 0)
    first, second, third = notes
    assert first == "Extension for 'anne': no submission has this name. Did you mean ann?"
    assert second.startswith("The submission time is unknown for 1 of 2 students")
    assert second.endswith(f"bob. To add times, write {tmp_path / 'times.csv'}.")
    assert third == "Late: 1. With a penalty: 1."


def test_gradescope_says_when_and_who() -> None:
    longer = datetime(2026, 10, 26, 23, 59, tzinfo=BERLIN)
    deadline = Deadline(FALL, FIVE, {"ann@example.org": longer})
    again = deadline_from_json(deadline_to_json(deadline))
    assert again == deadline
    assert days_late(again.due, datetime(2026, 10, 25, 22, 59, tzinfo=UTC)) == 2, "the same zone"
    metadata = {"created_at": "2026-10-24T14:22:32.365935-07:00", "users": [{"name": "Bo"}]}
    assert late_on_gradescope(again, CHAPTERS, metadata).days == 1
    ann = {"name": "Ann", "email": "ann@example.org"}
    assert late_on_gradescope(again, CHAPTERS, metadata | {"users": [ann]}).days == 0
    for nothing in ({}, {"created_at": None}, {"created_at": "?", "users": "x"}):
        assert late_on_gradescope(again, CHAPTERS, nothing).days is None
