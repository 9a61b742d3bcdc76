"""A class that was downloaded from Canvas or Moodle is graded, and its grades go back there."""

from __future__ import annotations

import re
import zipfile
from datetime import UTC, datetime
from pathlib import Path

import pytest

from autograder.course.lateness import times_of
from autograder.grader.people import differences
from autograder.reports.feedback import write_index
from graded import report_of
from listed import class_in
from moodle_sheet import GERMAN, Sheet, download, upload
from small import MANIFEST, RIGHT, WRITTEN, make_root
from small_class import HALF, SmallClass

ROSTER = "77,Jane Doe,jane@x.org,jd9\n99,Eve Moss,eve@x.org,em9\n"


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return make_root(tmp_path / "root", MANIFEST + WRITTEN)


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    """Return the folder of a class that has handed in nothing yet."""
    (tmp_path / "class").mkdir()
    return tmp_path / "class"


def test_who_is_missing_and_who_is_a_stranger_is_said_and_on_the_index(tmp_path: Path) -> None:
    people = class_in(tmp_path, "doejane_77_3_work.zip|evemos_502_5_work.zip", ROSTER)
    said = differences(people, [])
    assert said == [
        "Nothing handed in: 1 (Eve Moss).",
        "Not on the roster: 1 (evemos_502).",
        "If evemos_502 is Eve Moss, rename the submission to 99.",
    ]
    page = write_index(tmp_path, [], [report_of("Jane Doe")], people).read_text(encoding="utf-8")
    assert re.search(r"Nothing handed in: 1\.</strong> <bdi>Eve Moss</bdi>", page)
    assert re.search(r"Not on the roster: 1\.</strong> <bdi>evemos_502</bdi>", page)


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


@pytest.mark.parametrize(
    ("name", "file"), [("J. R. Ewing", "_report.v2.pdf"), ("Lee, A.", ""), ("Lee, A.", "_w.zip")]
)
def test_the_worksheet_says_when_a_student_handed_in_whatever_dots_are_in_the_name(
    tmp_path: Path, name: str, file: str
) -> None:
    sheet = download(Sheet(GERMAN), {14: (name, "u14", "e@x.org"), 12: ("Bo", "u12", "b@x.org")})
    names = f"{name}_14_assignsubmission_file{file}"
    people = class_in(tmp_path, names, files={"worksheet.csv": sheet})
    ((_, said),) = times_of(tmp_path / "class", people, UTC)[0].items()
    assert (said.source, said.at) == ("Moodle", datetime(2026, 10, 23, 20, 15, tzinfo=UTC))
