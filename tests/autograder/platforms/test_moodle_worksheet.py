"""A grading worksheet of Moodle is understood and filled in any language."""

from __future__ import annotations

import csv
import io
from datetime import datetime
from pathlib import Path

import pytest

from autograder.submissions.moodle_worksheet import Worksheet, read_worksheet, worksheet_in
from moodle_sheet import GERMAN, LANGUAGES, PEOPLE, Language, Sheet, download, upload

AT = datetime(2026, 10, 23, 20, 15)
ALL = ("Ann Lee", "ann@x.org", "u77", AT)  # what is shown of Ann
LAYOUTS: dict[str, tuple[Sheet, tuple[object, ...]]] = {
    "plain": (Sheet(), ALL),
    "anonymous": (Sheet(anonymous=True, teams=True, overrides=True), ("", "", "", AT)),
    "no e-mail": (Sheet(identity=("idnumber",)), ("Ann Lee", "", "u77", AT)),
    "only the name": (Sheet(identity=()), ("Ann Lee", "", "", AT)),
    "not certain": (Sheet(identity=("username", "idnumber")), ("Ann Lee", "", "", AT)),
    "the same phones": (Sheet(identity=("idnumber", "phone1")), ("Ann Lee", "", "u77", AT)),
    "everything": (Sheet(overrides=True, teams=True, workflow=True, online_text=True), ALL),
    "nothing to hand in": (Sheet(submissions=False, graded={12: "5.00"}), (*ALL[:3], None)),
    "equal grades": (Sheet(workflow=True, graded=dict.fromkeys(PEOPLE, "80.00")), ALL),
}


def read(folder: Path, text: str, encoding: str = "utf-8-sig") -> Worksheet:
    (folder / "worksheet.csv").write_bytes(text.encode(encoding))
    return read_worksheet(folder / "worksheet.csv")


def cells(content: bytes | str, separator: str = ",") -> list[list[str]]:
    text = content if isinstance(content, str) else content.decode("utf-8-sig")
    return [*csv.reader(io.StringIO(text, newline=""), delimiter=separator)]


@pytest.mark.parametrize("language", LANGUAGES.values(), ids=LANGUAGES)
def test_a_worksheet_in_any_language_is_understood_and_taken_back(
    tmp_path: Path, language: Language
) -> None:
    sheet = Sheet(language, 87.5)
    worksheet = read(tmp_path, download(sheet))
    assert worksheet.most == 87.5
    assert [(row.number, row.name, row.email, row.id_number) for row in worksheet.rows] == [
        (str(number), name, email, id_number) for number, (name, id_number, email) in PEOPLE.items()
    ]
    assert [row.submitted for row in worksheet.rows] == [AT, AT, None, AT]
    assert worksheet.unread == []
    filled = worksheet.filled({"12": 87.5, "14": 0.0, "99": 3.0})
    assert upload(filled, sheet) == ({12: 87.5, 14: 0.0}, [])


@pytest.mark.parametrize(("sheet", "shown"), LAYOUTS.values(), ids=LAYOUTS)
def test_what_a_worksheet_shows_is_read_and_only_the_cells_of_the_grades_change(
    tmp_path: Path, sheet: Sheet, shown: tuple[object, ...]
) -> None:
    text = download(sheet)
    worksheet = read(tmp_path, text)
    ann = worksheet.rows[0]
    assert (ann.name, ann.email, ann.id_number, ann.submitted) == shown
    expected = cells(text)
    expected[1][expected[0].index("Grade")] = "87.50"
    assert cells(worksheet.filled({"12": 87.5})) == expected


@pytest.mark.parametrize(
    ("separator", "end", "encoding"), [(",", "\n", "utf-8"), (";", "\r\n", "utf-8-sig")]
)
def test_the_form_of_the_file_stays_as_it_was(
    tmp_path: Path, separator: str, end: str, encoding: str
) -> None:
    text = io.StringIO(newline="")
    writer = csv.writer(text, delimiter=separator, lineterminator=end)
    writer.writerows(cells(download(Sheet(GERMAN, graded={13: "1,00"}))))
    before = text.getvalue().encode(encoding)
    (tmp_path / "worksheet.csv").write_bytes(before)
    after = read_worksheet(tmp_path / "worksheet.csv").filled({"13": 2.5})
    assert after == before.replace(b"1,00", b"2,50")


@pytest.mark.parametrize("known", ["idnumber", "phone1"])
def test_a_class_of_one_is_understood(tmp_path: Path, known: str) -> None:
    """Its e-mail address is empty like a grade, and its other number is the same in each row."""
    suspended = '<span class="usersuspended">Ann Lee <i class="icon" title="Suspended"></i></span>'
    one = {12: (suspended, "2024", "")}
    identity = (known, "email") if known == "idnumber" else ("email", known)
    worksheet = read(tmp_path, download(Sheet(identity=identity), one))
    assert worksheet.rows[0].name == "Ann Lee"
    assert cells(worksheet.filled({"12": 3.0}))[1][5:7] == ["3.00", "100.00"]


@pytest.mark.parametrize(
    "time",
    ["Tue, 4/5/2026, 8:15", "Xyzday, 23 Foober 2026, 20:15", "Friday, 23 October 2569, 20:15"],
)
def test_a_time_that_is_not_certain_is_unknown_and_listed(tmp_path: Path, time: str) -> None:
    text = download(Sheet()).replace("Friday, 23 October 2026, 8:15 PM", time, 1)
    worksheet = read(tmp_path, text)
    assert [row.submitted for row in worksheet.rows] == [None, AT, None, AT]
    assert worksheet.unread == [time]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda _: "", "below its header"),
        (lambda text: text + "Participant 99,Eve\n", "below its header"),
        (lambda text: text + '"', "unexpected end of data"),
        (lambda text: text.replace("Participant 13", "Bo"), "different identifiers, .* got 'Part"),
        (lambda text: text.replace("Participant 13", "Participant 12"), "different identifiers"),
        (lambda text: text.replace("100.00", "A\nB"), "not certain which column"),  # a scale
        (lambda text: text.replace("100.00", "0.00"), "not certain which column"),
    ],
)
def test_what_is_no_worksheet_is_refused(tmp_path: Path, change: object, message: str) -> None:
    assert callable(change)
    text = change(download(Sheet())).replace("A\nB", '"A\nB"')
    with pytest.raises(ValueError, match=rf"(?s)worksheet\.csv.*{message}.*as Moodle wrote it"):
        read(tmp_path, text)


def test_a_class_may_have_no_worksheet_but_not_one_in_another_encoding(tmp_path: Path) -> None:
    assert worksheet_in(tmp_path) is None
    with pytest.raises(ValueError, match=r"worksheet\.csv, line 1: this is not UTF-8"):
        read(tmp_path, download(Sheet(GERMAN)), "cp1252")
    read(tmp_path, download(Sheet()))
    assert worksheet_in(tmp_path) is not None
