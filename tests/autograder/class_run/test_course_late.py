"""Late work: days by the clock on the wall, penalties with caps, and where times come from."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta, timezone
from pathlib import Path
from zoneinfo import ZoneInfo

import pytest

from autograder.course.dates import deadline_from_json, deadline_to_json
from autograder.course.late import HandedIn, days_late, deduction, late_of
from autograder.course.lateness import for_gradescope, late_on_gradescope, lateness, times_of
from autograder.course.model import Deadline, LatePolicy
from autograder.reports.marks import Mark, apply_marks
from graded import CHAPTERS, failed_run, report_of
from listed import class_in

BERLIN = ZoneInfo("Europe/Berlin")
FALL = datetime(2026, 10, 23, 23, 59, tzinfo=BERLIN)  # 21:59 UTC; clocks go back on the 25th
SPRING = datetime(2027, 3, 27, 23, 59, tzinfo=BERLIN)  # 22:59 UTC; clocks go forward on the 28th
FIXED = datetime(2026, 10, 23, 23, 59, tzinfo=timezone(timedelta(hours=2)))
NIGHT = datetime(2026, 10, 24, 2, 30, tzinfo=BERLIN)  # the clocks show this twice on the 25th
FIVE = LatePolicy(5, "points")


@pytest.mark.parametrize(
    ("due", "submitted", "days"),
    [
        (FALL, "2026-10-23 21:59:00", 0),
        (FALL, "2026-10-23 21:59:01", 1),
        (FALL, "2026-10-24 21:59:00", 1),
        (FALL, "2026-10-25 22:59:00", 2),  # a day of 25 hours
        (FALL, "2026-10-25 22:59:01", 3),
        (FALL, "2027-10-23 21:59:00", 365),
        (SPRING, "2027-03-28 21:59:00", 1),  # a day of 23 hours
        (SPRING, "2027-03-28 21:59:01", 2),
        (FIXED, "2026-10-25 21:59:00", 2),  # an offset knows no change of the clocks
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
    late = late_of(Deadline(FALL, LatePolicy(2, "points")), [], HandedIn("it", at), 14)
    report = report_of(late=late)
    assert (report.score, report.earned, report.penalty, report.total) == (3, 3, 3, 0)
    limit = "Here that is 4 points. The penalty is never more than the points earned."
    assert report.about_lateness.endswith(limit)
    marked = apply_marks(report, {("ada", "2.3"): Mark(2, "")})
    assert marked.about_lateness.endswith("Here that is 4 points.")
    assert (marked.score, marked.earned, marked.penalty, marked.total) == (3, 5, 4, 1)
    failed = failed_run()
    assert (failed.earned, failed.penalty, failed.total) == (None, 0, None)


def test_the_words_say_why_there_is_a_penalty_or_none() -> None:
    longer = datetime(2026, 10, 25, 23, 59, tzinfo=BERLIN)
    deadline, at = Deadline(FALL, FIVE), HandedIn("times.csv", longer)
    unclear = HandedIn("Canvas", late=True)
    for granted, said, days, cost, words in (
        ([longer], at, 0, 0, "It was due 2026-10-25 23:59 CET (extended)."),
        ([], None, None, 0, "The submission time is unknown, so there is no penalty."),
        ([], unclear, None, 0, "late, but not by how much, so there is no penalty."),
    ):
        late = late_of(deadline, granted, said, 10)
        assert (late.days, late.deduction) == (days, cost)
        assert words in late.words
    assert late_of(deadline, [], at, 10).words.startswith(
        "It was due 2026-10-23 23:59 CEST. It was handed in 2026-10-25 23:59 CET, according to "
        "times.csv. That is 2 days late. "
    )


EXPORT = """\
submission_17:
  :submitters:
  - :name: Ann
    :sid: '1'
  :created_at: 2026-10-24 10:00:00.123456000 Z
submission_18:
  :created_at:
submission_19:
  :created_at: 2026-10-24 10:00:00.123456000 Z
"""
GRADES = """\
"assignment_name","student_repository_name","submission_timestamp","points_awarded"
"lab1","lab1-bob","2026-10-24 11:00:00 UTC","3"
"lab1","lab1-cem","","0"
"""
ROSTER = "7,Ann Lee,,\n8,Bo Roe,,\n9,Bo Roe,,\n"
TIMES = "student;submitted\nfay;2026-10-24 12:00\n\nGIL LEE;2026-10-24T12:00:00-04:00\n"


def test_times_come_from_the_best_source_that_knows_one(tmp_path: Path) -> None:
    files = {"submission_metadata.yml": EXPORT, "grades.csv": GRADES, "times.csv": TIMES}
    names = "submission_17|submission_18|lab1-bob|lab1-cem|fay|leegil_7_8_work"
    names += "|dee_LATE_12_34_work|eli_56_78_ch02-1|hal"
    people = class_in(tmp_path, names, "1,Ann,,\n7,Gil Lee,,\n12,Dee,,\n56,Eli,,\n", files)
    folder = tmp_path / "class"
    assert people.notes == [
        f"1 submissions of the platform's files are not in {folder}: submission_19"
    ]
    found, notes = times_of(folder, people, BERLIN)
    said = {name: (one.source, one.at, one.late) for name, one in found.items()}
    at = datetime(2026, 10, 24, 10, 0, tzinfo=UTC)
    assert notes == []
    assert said == {
        "Ann": ("Gradescope", at.replace(microsecond=123456), False),
        "lab1-bob": ("GitHub Classroom", at + timedelta(hours=1), False),
        "fay": ("times.csv", at, False),  # 12:00 in Berlin
        "Gil Lee": ("times.csv", at + timedelta(hours=6), False),
        "Dee": ("Canvas", None, True),
        "Eli": ("Canvas", None, False),
    }


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("name,time\n", r"line 1: the header must be student,submitted, got 'name,time'"),
        ("student,submitted\nann,soon\nEve,x\n", "line 2: there is no student 'ann'"),
        ("student,submitted\nbob,2026-10-24,x\n", "line 2: there must be 2 cells, got 3"),
        (
            "student,submitted\n7,2026-10-24\n007,2026-10-25\n",
            "line 3: a second time for 'Ann Lee'",
        ),
        (
            "student,submitted\nBo Roe,2026-10-24\n",
            r"line 2: 'Bo Roe' could be Bo Roe \(8\) and Bo Roe \(9\)",
        ),
        ("student,submitted\n7,soon\n", r"line 2: a time looks like .*, got 'soon'"),
    ],
)
def test_a_row_of_times_that_cannot_be_used_is_reported(
    tmp_path: Path, text: str, words: str
) -> None:
    people = class_in(tmp_path, "7|8", ROSTER, {"times.csv": text})
    with pytest.raises(ValueError, match=words):
        times_of(tmp_path / "class", people, BERLIN)


def test_the_instructor_hears_of_unknown_times_and_of_extensions_that_fit_nobody(
    tmp_path: Path,
) -> None:
    times, folder = "student,submitted\nann,2026-10-27\n", tmp_path / "class"
    people = class_in(tmp_path, "ann|bob", files={"times.csv": times})
    deadline = Deadline(FALL, LatePolicy(10, "percent"), {"anne": FALL, "Bob": FALL})
    late, notes = lateness(deadline, CHAPTERS, folder, people)
    assert "(extended)" in late["bob"].words, "by a name with another first letter"
    assert (late["ann"].days, late["ann"].deduction) == (4, 4 * 1.4), "of 14 points possible"
    assert (late["bob"].days, late["bob"].deduction) == (None, 0)
    first, second, third = notes
    assert first == "Extension of 'anne' in the course file: there is no student 'anne'."
    assert second.startswith("The submission time is unknown for 1 of 2 students")
    assert second.endswith(f"bob. To add times, write {folder / 'times.csv'}.")
    assert third == "1 student was late, and gets a penalty."


@pytest.mark.parametrize(
    ("extensions", "words"),
    [
        ({"Bo Roe": FALL}, r"'Bo Roe' could be Bo Roe \(8\) and Bo Roe \(9\)"),
        ({"Ann Le": FALL}, r"there is no student 'Ann Le'\."),
        ({"7": FALL, "Ann Lee": SPRING}, "'7' is the same student and has another date"),
    ],
)
def test_an_extension_is_that_of_one_student_on_the_roster(
    tmp_path: Path, extensions: dict[str, datetime], words: str
) -> None:
    people = class_in(tmp_path, "7|8", ROSTER)
    with pytest.raises(ValueError, match=f"Extension of .*: {words}"):
        lateness(Deadline(FALL, FIVE, extensions), CHAPTERS, tmp_path, people)
    deadline = Deadline(FALL, FIVE, {"7": SPRING, "Ann Lee": SPRING, "9": SPRING})
    late, _ = lateness(deadline, CHAPTERS, tmp_path, people)
    extended = {name for name, one in late.items() if "(extended)" in one.words}
    assert extended == {"Ann Lee"}, "the other one has handed in nothing"


def test_an_extension_by_id_holds_on_gradescope_which_knows_names_alone(tmp_path: Path) -> None:
    rows = "13,Ivan Petrov,,\n14,Bo Roe,bo@x.org,\n15,Bo Roe,,\n"
    class_in(tmp_path, "13", rows)
    longer = datetime(2026, 10, 26, 23, 59, tzinfo=BERLIN)
    given = Deadline(FALL, FIVE, {"13": longer, "14": longer})
    deadline = deadline_from_json(deadline_to_json(for_gradescope(given, tmp_path / "roster.csv")))
    assert days_late(deadline.due, datetime(2026, 10, 25, 22, 59, tzinfo=UTC)) == 2, "the same zone"

    def days(name: str, email: str) -> int | None:
        users = [{"name": name, "email": email}]
        metadata = {"created_at": "2026-10-24T14:22:32.365935-07:00", "users": users}
        return late_on_gradescope(deadline, CHAPTERS, metadata).days

    assert days("Ivan Petrov", "ip@elsewhere.org") == days("PETROV, Ivan", "") == 0
    assert (days("Bo Roe", "Bo@X.org"), days("Bo Roe", "roe@x.org")) == (0, 1), "by the email"
    for nothing in ({}, {"created_at": None}, {"created_at": "?", "users": "x"}):
        assert late_on_gradescope(deadline, CHAPTERS, nothing).days is None
    with pytest.raises(ValueError, match=r"Add one to .*, line 4"):
        for_gradescope(Deadline(FALL, FIVE, {"15": longer}), tmp_path / "roster.csv")
    with pytest.raises(ValueError, match=r"Extension of 'Ivan' in .*: there is no student 'Ivan'"):
        for_gradescope(Deadline(FALL, FIVE, {"Ivan": longer}), tmp_path / "roster.csv")
