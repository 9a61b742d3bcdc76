"""A class from Canvas is graded under the names of its roster."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from autograder.platforms.uploads import Column
from autograder.submissions.unpack import class_folder
from small import MANIFEST, RIGHT, WRITTEN, hand_in, make_root
from small_class import HALF, grade, scores, table
from staging import zip_of
from typed import typed

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
def roster(tmp_path: Path) -> Path:
    (tmp_path / "roster.csv").write_text(ROSTER, encoding="utf-8")
    return tmp_path / "roster.csv"


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    """Return a class from Canvas, with a late student, and one who is not on the roster."""
    files = {
        "doejane_LATE_77_3_work.zip": zip_of({SMALL: HALF.encode()}),
        "leebo_501_4_work-1.zip": zip_of(
            {f"bo lee's/{SMALL}": RIGHT.encode(), f"old/{SMALL}": b""}
        ),
        "zed_502_5_work.zip": zip_of({SMALL: RIGHT.encode()}),
    }
    path = tmp_path / "lab1.zip"
    path.write_bytes(zip_of(files))
    folder = class_folder(path)
    marks = "student,exercise,points,comment\ndoejane_77,90.2,1,\nu1042,90.2,3,\n"
    (folder / "marks.csv").write_text(marks, encoding="utf-8")
    return folder


def test_a_class_is_graded_under_the_names_of_its_roster(
    root: Path, roster: Path, submissions: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    assert grade(submissions, out, root, roster=roster, column=Column("Lab 1 (12)", 18)) == 0
    assert scores(out) == {"Bo Lee": 6.0, "Jane Doe": 5.0, "zed_502": 6.0}
    rows = {row["student"]: row for row in table(out / "gradebook.csv")}
    states = {name: (row["status"], row["by hand"], row["total"]) for name, row in rows.items()}
    del states["points possible"]
    assert states == {
        "Bo Lee": ("graded", "3", "9"),
        "Jane Doe": ("graded", "1", "6"),
        "zed_502": ("graded; not on the roster", "", "6"),
        "Eve Moss": ("nothing handed in", "", ""),
    }
    page = (out / "index.html").read_text(encoding="utf-8")
    assert re.search(r"Nothing handed in: 1\.</strong> <bdi>Eve Moss</bdi>", page)
    assert re.search(r"Not on the roster: 1\.</strong> <bdi>zed_502</bdi>", page)
    printed = capsys.readouterr().out
    assert "Nothing handed in: 1 (Eve Moss)." in printed
    assert "Not on the roster: 1 (zed_502)." in printed
    grades = {row["ID"]: row["Lab 1 (12)"] for row in table(out / "canvas.csv")}
    assert grades == {"": "18", "77": "12", "501": "18", "99": ""}
    grades = {row["ID number"]: row["Lab 1"] for row in table(out / "moodle.csv")}
    assert grades == {"77": "12", "u1042": "18", "99": "-"}
    lines = [line for line in printed.splitlines() if str(tmp_path) not in line]
    assert max(map(len, lines)) <= 80, "they fit a terminal"
    assert "not marked yet" in " ".join(lines)


def test_a_mark_under_two_names_of_a_student_is_refused(
    root: Path, roster: Path, submissions: Path, tmp_path: Path
) -> None:
    with (submissions / "marks.csv").open("a", encoding="utf-8") as marks:
        marks.write("Jane Doe,90.2,2,\n")
    with pytest.raises(ValueError, match=r"line 4: a second mark for 'Jane Doe' in 90\.2, as"):
        grade(submissions, tmp_path / "out", root, roster=roster)


def test_the_command_takes_a_zip_and_reports_a_mistake_in_the_roster(
    roster: Path, tmp_path: Path
) -> None:
    (tmp_path / "lab.zip").write_bytes(zip_of({"doejane_77_3_work.zip": zip_of({SMALL: b""})}))
    roster.write_text(ROSTER + "77,Ann,,\n", encoding="utf-8")
    options = ("--roster", roster, "--out", tmp_path / "out", "--title", "Lab 1 (12)")
    done = typed("autograder", "grade", tmp_path / "lab.zip", *options)
    assert done.returncode == 2
    assert done.stdout.startswith(f"lab.zip is unpacked in {tmp_path / 'lab'}: 1 entries")
    where = f"grade: {roster}, line 5: the id '77' is already in line 2."
    assert done.stderr.startswith(where)
    assert not (tmp_path / "out").exists()


def test_a_submission_with_nearly_the_name_of_an_absent_student_is_pointed_out(
    root: Path, roster: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("evemos", "someone", "77"):
        hand_in(tmp_path / "class", name, RIGHT)
    assert grade(tmp_path / "class", tmp_path / "out", root, roster=roster) == 0
    printed = capsys.readouterr().out
    assert "If evemos is Eve Moss, rename the submission to 99." in printed
    assert printed.count("rename the submission") == 1
