"""Random classes never lose, double or mix up a student, on the way from roster to import file.

No code under test made the account of what went in. CLASSES=2000 draws more classes.
"""

from __future__ import annotations

import csv
import os
from collections import Counter
from pathlib import Path

import pytest

from autograder.platforms.uploads import Column, write_uploads
from autograder.reports.gradebook import write_gradebook
from autograder.reports.report import StudentReport
from autograder.submissions.class_list import ClassList, Member, read_class
from autograder.submissions.moodle_worksheet import worksheet_in
from graded import CHAPTERS, report_of
from random_class import Person, RandomClass, random_class
from small_class import table

CLASSES = int(os.environ.get("CLASSES", "130"))
SEEDS = range(CLASSES)


@pytest.fixture(params=SEEDS)
def made(request: pytest.FixtureRequest, tmp_path: Path) -> RandomClass:
    return random_class(request.param, tmp_path)


def read(made: RandomClass) -> ClassList | None:
    """Return the class, or None if it cannot be read and this is said."""
    words = ""
    if made.is_unclear:
        words = "match the submission|must hand in only once"
    elif not any(person.path for person in made.people) and not made.strangers:
        words = "has no submissions"
    if not words:
        return read_class(made.folder, made.roster)
    with pytest.raises(ValueError, match=words):
        read_class(made.folder, made.roster)
    return None


def read_lines(path: Path) -> list[list[str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return [*csv.reader(file)][1:]


def member_of(people: ClassList, person: Person) -> Member:
    (member,) = [m for m in people.members if m.student and m.student.id == person.id]
    return member


def test_every_student_is_in_one_state_and_has_the_own_submission(made: RandomClass) -> None:
    people = read(made)
    if people is None:
        return
    for person in made.people:
        submission = member_of(people, person).submission
        assert (submission.path.name if submission else "") == person.path
        if submission:
            assert (submission.nothing == "") is person.is_gradable
    assert len(people.members) == len(made.people) + len(made.strangers)
    assert len({member.shown for member in people.members}) == len(people.members)
    assert sorted(people.unmatched) == sorted(made.strangers)
    handed_in = Counter(one.path.name for one in people.submissions)
    expected = {person.path for person in made.people if person.path} | {*made.strangers}
    assert handed_in == Counter(expected), "each once"


def test_every_grade_reaches_its_student_in_every_file(made: RandomClass) -> None:
    people = read(made)
    if people is None:
        return
    reports: list[StudentReport] = []
    points: dict[str, float] = {}
    for number, submission in enumerate(people.submissions, start=1):
        reports.append(report_of(submission.student, score=number / 8, waiting=0))
        points[submission.path.name] = round(number / 8, 2)
    out = made.folder.parent
    write_gradebook(out, CHAPTERS, reports, people)
    worksheet = worksheet_in(made.folder)
    write_uploads(out, CHAPTERS, people, reports, Column("Lab", 14), worksheet)
    book = table(out / "gradebook.csv")[1:]
    assert len(book) == len(people.members)
    totals = {row["student"]: row["total"] for row in book}
    in_canvas = {row["SIS User ID"]: row["Lab"] for row in table(out / "canvas.csv")[1:]}
    in_moodle = {row["ID number"]: row["Lab"] for row in table(out / "moodle.csv")}
    numbers = {row["SIS User ID"]: row["ID"] for row in table(out / "canvas.csv")[1:] if row["ID"]}
    assert len({*numbers.values()}) == len(numbers), "Canvas would give two grades to one student"
    if made.how in ("canvas", "canvas with groups"):  # whose ids are those of the roster
        assert all(number == own for own, number in numbers.items())
    if worksheet and (filled := out / "moodle-worksheet.csv").exists():
        in_worksheet = {line[2]: line[worksheet.grade] for line in read_lines(filled)}
        for person in made.people:
            grade, wanted = in_worksheet[person.id].replace(",", "."), points.get(person.path)
            assert (float(grade) if grade else None) == wanted
    ids = sorted(person.id for person in made.people)
    assert sorted(in_canvas) == sorted(in_moodle) == ids
    for person in made.people:
        wanted = points.get(person.path)
        shown = totals[member_of(people, person).shown]
        assert (float(shown) if shown else None) == wanted
        assert (float(in_canvas[person.id]) if in_canvas[person.id] else None) == wanted
        grade = in_moodle[person.id]
        assert (None if grade == "-" else float(grade)) == wanted


def test_the_classes_differ_and_most_are_clear(tmp_path: Path) -> None:
    """Otherwise the tests above would test little."""
    seen = Counter[str]()
    for seed in SEEDS:
        place = tmp_path / str(seed)
        place.mkdir()
        made = random_class(seed, place)
        seen["unclear" if made.is_unclear else made.how] += 1
        seen["namesakes"] += len({p.name() for p in made.people}) < len(made.people)
        seen["nothing"] += any(p.path and not p.is_gradable for p in made.people)
    if CLASSES >= 130:
        assert min(seen.values()) >= 3, seen
        assert seen["unclear"] <= CLASSES / 3
