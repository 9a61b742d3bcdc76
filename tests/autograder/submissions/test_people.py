"""A class that was downloaded from Canvas or Moodle is graded, and its grades go back there."""

from __future__ import annotations

import re
import zipfile
from datetime import UTC, datetime
from pathlib import Path

import pytest

from autograder.course.lateness import times_of
from autograder.platforms.uploads import Column
from autograder.submissions.unpack import class_folder
from listed import class_in
from moodle_sheet import GERMAN, Sheet, download, upload
from small import MANIFEST, RIGHT, WRITTEN, make_root
from small_class import HALF, SmallClass, grade, scores, table
from staging import zip_of

SMALL = "ch90_small/small.py"
ROSTER = """id,name,email,login
77,Jane Doe,jane@x.org,jd9
u1042,Bo Lee,bo@x.org,bl8
99,Eve Moss,eve@x.org,em9
"""


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return make_root(tmp_path / "root", MANIFEST + WRITTEN)


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    """Return the folder of a class that has handed in nothing yet."""
    (tmp_path / "class").mkdir()
    return tmp_path / "class"


def test_a_class_is_graded_under_the_names_of_its_roster(
    root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    roster = tmp_path / "roster.csv"
    roster.write_text(ROSTER, encoding="utf-8")
    files = {
        "doejane_LATE_77_3_work.zip": {SMALL: HALF.encode()},
        "leebo_501_4_work-1.zip": {f"bo lee's/{SMALL}": RIGHT.encode(), f"old/{SMALL}": b""},
        "evemos_502_5_work.zip": {SMALL: RIGHT.encode()},  # who is not on the roster
    }
    path, out = tmp_path / "lab1.zip", tmp_path / "out"
    path.write_bytes(zip_of({name: zip_of(files[name]) for name in files}))
    submissions = class_folder(path)
    marks = "student,exercise,points,comment\ndoejane_77,90.2,1,\nu1042,90.2,3,\n"
    (submissions / "marks.csv").write_text(f"{marks}Jane Doe,90.2,2,\n", encoding="utf-8")
    with pytest.raises(ValueError, match=r"line 4: a second mark for 'Jane Doe' in 90\.2, as"):
        grade(submissions, out, root, roster=roster)
    (submissions / "marks.csv").write_text(marks, encoding="utf-8")
    assert grade(submissions, out, root, roster=roster, column=Column("Lab 1 (12)", 18)) == 0
    assert scores(out) == {"Bo Lee": 6.0, "Jane Doe": 5.0, "evemos_502": 6.0}
    rows = {row["student"]: row for row in table(out / "gradebook.csv")}
    states = {name: (row["status"], row["by hand"], row["total"]) for name, row in rows.items()}
    del states["points possible"]
    assert states == {
        "Bo Lee": ("graded", "3", "9"),
        "Jane Doe": ("graded", "1", "6"),
        "evemos_502": ("graded; not on the roster", "", "6"),
        "Eve Moss": ("nothing handed in", "", ""),
    }
    page = (out / "index.html").read_text(encoding="utf-8")
    assert re.search(r"Nothing handed in: 1\.</strong> <bdi>Eve Moss</bdi>", page)
    assert re.search(r"Not on the roster: 1\.</strong> <bdi>evemos_502</bdi>", page)
    printed = capsys.readouterr().out
    assert "Nothing handed in: 1 (Eve Moss)." in printed
    assert "Not on the roster: 1 (evemos_502)." in printed
    assert "If evemos_502 is Eve Moss, rename the submission to 99." in printed
    assert printed.count("rename the submission") == 1
    grades = {row["ID"]: row["Lab 1 (12)"] for row in table(out / "canvas.csv")}
    assert grades == {"": "18", "77": "12", "501": "18", "99": ""}
    grades = {row["ID number"]: row["Lab 1"] for row in table(out / "moodle.csv")}
    assert grades == {"77": "12", "u1042": "18", "99": "-"}
    lines = [line for line in printed.splitlines() if str(tmp_path) not in line]
    assert max(map(len, lines)) <= 80, "they fit a terminal"
    assert "not marked yet" in " ".join(lines)


def test_moodles_worksheet_is_filled_and_the_pages_are_in_a_zip_for_moodle(
    small: SmallClass,
) -> None:
    sheet = Sheet(GERMAN, most=10)
    for name, code in (("Ann Lee_12", RIGHT), ("Bo O'Neill_13", HALF)):
        small.hand_in(f"{name}_assignsubmission_file", code)
    small.write("worksheet.csv", "a,b\n1,2\n")
    with pytest.raises(ValueError, match=r"class/worksheet\.csv is not a worksheet from Moodle"):
        small.grade()
    assert not small.out.exists(), "nothing was graded"
    small.write("worksheet.csv", download(sheet))
    assert small.grade() == 0
    printed = small.printed()
    assert "worksheet.csv was left out" not in printed
    assert str(small.out / "moodle-worksheet.csv") in printed
    grades, comments = upload((small.out / "moodle-worksheet.csv").read_bytes(), sheet)
    assert grades == {12: 6.67, 13: 5.56}, "of 9 points"
    assert comments == []
    with zipfile.ZipFile(small.out / "feedback-moodle.zip") as file:
        pages = {file.read(name) for name in file.namelist()}
    assert pages == {page.read_bytes() for page in small.out.glob("feedback/*.html")}


@pytest.mark.parametrize("name", ["J. R. Ewing", "Lee, A."])
@pytest.mark.parametrize("file", ["", "_work.zip", "_report.v2.pdf"])
def test_the_worksheet_says_when_a_student_handed_in_whatever_dots_are_in_the_name(
    tmp_path: Path, name: str, file: str
) -> None:
    sheet = download(Sheet(GERMAN), {14: (name, "u14", "e@x.org"), 12: ("Bo", "u12", "b@x.org")})
    names = f"{name}_14_assignsubmission_file{file}"
    people = class_in(tmp_path, names, files={"worksheet.csv": sheet})
    ((_, said),) = times_of(tmp_path / "class", people, UTC)[0].items()
    assert (said.source, said.at) == ("Moodle", datetime(2026, 10, 23, 20, 15, tzinfo=UTC))
