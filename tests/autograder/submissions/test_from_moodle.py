"""A class whose submissions and grading worksheet were downloaded from Moodle."""

from __future__ import annotations

import zipfile
from datetime import datetime
from pathlib import Path
from zoneinfo import ZoneInfo

import pytest

from autograder.course.times import times_of
from listed import class_in
from moodle_sheet import GERMAN, Sheet, download, upload
from small import RIGHT, hand_in
from small_class import HALF, grade

SHEET = Sheet(GERMAN, most=10)


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    folder = tmp_path / "class"
    hand_in(folder, "Ann Lee_12_assignsubmission_file", RIGHT)
    hand_in(folder, "Bo O'Neill_13_assignsubmission_file", HALF)
    (folder / "worksheet.csv").write_text(download(SHEET), encoding="utf-8-sig")
    return folder


def test_the_worksheet_is_filled_and_the_pages_are_in_a_zip_for_moodle(
    root: Path, submissions: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    assert grade(submissions, out, root) == 0
    printed = capsys.readouterr().out
    assert "worksheet.csv was left out" not in printed
    assert str(out / "moodle-worksheet.csv") in printed
    grades, comments = upload((out / "moodle-worksheet.csv").read_bytes(), SHEET)
    assert grades.keys() == {12, 13}
    assert 0 < grades[13] < grades[12] == 10
    assert comments == []
    assert [*tmp_path.rglob("feedback-*.zip")] == [out / "feedback-moodle.zip"]
    with zipfile.ZipFile(out / "feedback-moodle.zip") as file:
        assert sorted(file.namelist()) == [
            "Ann Lee_12_assignfeedback_file_/feedback.html",
            "Bo O'Neill_13_assignfeedback_file_/feedback.html",
        ]
        pages = {file.read(name) for name in file.namelist()}
    assert pages == {page.read_bytes() for page in out.glob("feedback/*.html")}


def test_a_broken_worksheet_stops_the_run_before_anything_is_graded(
    root: Path, submissions: Path, tmp_path: Path
) -> None:
    (submissions / "worksheet.csv").write_text("a,b\n1,2\n", encoding="utf-8")
    with pytest.raises(ValueError, match=r"class/worksheet\.csv is not a worksheet from Moodle"):
        grade(submissions, tmp_path / "out", root)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", ["J. R. Ewing", "Ann Lee", "Lee, A."])
@pytest.mark.parametrize("file", ["", "_work.zip", "_report.v2.pdf"])
def test_the_worksheet_says_when_a_student_handed_in_whatever_dots_are_in_the_name(
    tmp_path: Path, name: str, file: str
) -> None:
    sheet = download(SHEET, {14: (name, "u14", "e@x.org"), 12: ("Bo", "u12", "b@x.org")})
    names = f"{name}_14_assignsubmission_file{file}"
    people = class_in(tmp_path, names, files={"worksheet.csv": sheet})
    berlin = ZoneInfo("Europe/Berlin")
    ((_, said),) = times_of(tmp_path / "class", people, berlin)[0].items()
    assert (said.source, said.at) == ("Moodle", datetime(2026, 10, 23, 20, 15, tzinfo=berlin))
