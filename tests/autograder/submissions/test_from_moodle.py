"""A class whose submissions and grading worksheet were downloaded from Moodle."""

from __future__ import annotations

import zipfile
from datetime import datetime
from pathlib import Path
from zoneinfo import ZoneInfo

import pytest

from autograder.course.times import times_of
from autograder.submissions.class_list import read_class
from autograder.submissions.platform_files import Uploads
from moodle_sheet import GERMAN, Sheet, download, upload
from small import RIGHT, hand_in, make_root
from small_class import HALF, grade

SHEET = Sheet(GERMAN, most=10)


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    folder = tmp_path / "class"
    hand_in(folder, "Ann Lee_12_assignsubmission_file", RIGHT)
    hand_in(folder, "Bo O'Neill_13_assignsubmission_file", HALF)
    (folder / "worksheet.csv").write_text(download(SHEET), encoding="utf-8-sig")
    return folder


@pytest.fixture(scope="module")
def root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make_root(tmp_path_factory.mktemp("root"))


def test_the_worksheet_is_filled_and_is_not_a_submission(
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


def test_the_worksheet_of_an_anonymous_class_is_outside_its_folder(
    root: Path, submissions: Path, tmp_path: Path
) -> None:
    assert grade(submissions, tmp_path / "out", root, anonymous=True) == 0
    assert not (tmp_path / "out/moodle-worksheet.csv").exists()
    grades, _ = upload((tmp_path / "out-named/moodle-worksheet.csv").read_bytes(), SHEET)
    assert grades.keys() == {12, 13}


@pytest.mark.parametrize(("anonymous", "folder"), [(False, "out"), (True, "out-named")])
def test_the_feedback_pages_are_in_a_zip_for_moodle(
    root: Path, submissions: Path, tmp_path: Path, anonymous: bool, folder: str
) -> None:
    assert grade(submissions, tmp_path / "out", root, anonymous=anonymous) == 0
    assert [*tmp_path.rglob("feedback-*.zip")] == [tmp_path / folder / "feedback-moodle.zip"]
    with zipfile.ZipFile(tmp_path / folder / "feedback-moodle.zip") as file:
        assert sorted(file.namelist()) == [
            "Ann Lee_12_assignfeedback_file_/feedback.html",
            "Bo O'Neill_13_assignfeedback_file_/feedback.html",
        ]
        pages = {file.read(name) for name in file.namelist()}
    assert pages == {page.read_bytes() for page in tmp_path.glob("out/feedback/*.html")}


def test_a_broken_worksheet_stops_the_run_before_anything_is_graded(
    root: Path, submissions: Path, tmp_path: Path
) -> None:
    (submissions / "worksheet.csv").write_text("a,b\n1,2\n", encoding="utf-8")
    with pytest.raises(ValueError, match=r"class/worksheet\.csv is not a worksheet from Moodle"):
        grade(submissions, tmp_path / "out", root)
    assert not (tmp_path / "out").exists()


NAMESAKES = """id,name,email,login
u77,Ann Lee,ann@x.org,
u78,Bo O'Neill,bo@x.org,
u80,Bo O'Neill,bo2@x.org,
"""


def test_the_worksheet_tells_students_of_one_name_apart_and_when_they_handed_in(
    tmp_path: Path,
) -> None:
    """A newer download has the same folders again, and nobody has to rename one."""
    for name in ("Ann Lee_12", "Bo O'Neill_13", "Bo O'Neill_14"):
        (tmp_path / f"class/{name}_assignsubmission_file").mkdir(parents=True)
    roster = tmp_path / "roster.csv"
    roster.write_text(NAMESAKES, encoding="utf-8")
    with pytest.raises(ValueError, match=r"Save Moodle's grading worksheet as worksheet\.csv"):
        read_class(tmp_path / "class", roster)
    (tmp_path / "class/worksheet.csv").write_text(download(SHEET), encoding="utf-8")
    people = read_class(tmp_path / "class", roster)
    assert {one.student: one.export and one.export.number for one in people.submissions} == {
        "Ann Lee": "12",
        "Bo O'Neill (u78)": "13",
        "Bo O'Neill (u80)": "14",
    }
    berlin = ZoneInfo("Europe/Berlin")
    times, _ = times_of(tmp_path / "class", people, berlin)
    at = datetime(2026, 10, 23, 20, 15, tzinfo=berlin)
    assert {(one.source, one.at) for one in times.values()} == {("Moodle", at)}
    assert len(times) == 3


def test_a_worksheet_row_that_is_another_student_than_the_folder_says_is_an_error(
    tmp_path: Path,
) -> None:
    (tmp_path / "class/Ann Lee_13_assignsubmission_file").mkdir(parents=True)
    (tmp_path / "class/worksheet.csv").write_text(download(SHEET), encoding="utf-8")
    (tmp_path / "roster.csv").write_text(NAMESAKES, encoding="utf-8")
    with pytest.raises(ValueError, match="lines 2 and 3: both match"):
        read_class(tmp_path / "class", tmp_path / "roster.csv")


@pytest.mark.parametrize("name", ["J. R. Ewing", "Ann Lee", "Lee, A."])
@pytest.mark.parametrize("file", ["", "_work.zip", "_report.v2.pdf"])
def test_dots_in_a_name_do_not_hide_when_the_student_handed_in(
    tmp_path: Path, name: str, file: str
) -> None:
    path = tmp_path / f"class/{name}_14_assignsubmission_file{file}"
    path.parent.mkdir()
    path.touch() if file else path.mkdir()
    sheet = download(SHEET, {14: (name, "u14", "e@x.org")})
    (tmp_path / "class/worksheet.csv").write_text(sheet, encoding="utf-8")
    upload = Uploads(tmp_path / "class").of(path)
    assert upload is not None
    assert upload.at == datetime(2026, 10, 23, 20, 15)
