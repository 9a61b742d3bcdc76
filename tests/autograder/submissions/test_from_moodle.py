"""A class whose submissions and grading worksheet were downloaded from Moodle."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest

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
