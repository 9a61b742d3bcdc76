"""The roster: how it is read, what is refused with its line, and whom a submission belongs to."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from autograder.submissions.class_list import ClassList, match
from autograder.submissions.find import find_submissions
from autograder.submissions.roster import Student, read_roster

HEADER = "id,name,email,login\n"
ANN = Student("1042", "Ann Lee", "ann@x.org", "al7", 2)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "roster.csv"


@pytest.mark.parametrize(
    ("content", "line"),
    [
        (HEADER + "1042,Ann Lee,ann@x.org,al7\n", 2),
        ("\ufeffID;Name;Email;Login\r\n1042;Ann Lee;ann@x.org;al7\r\n;;;\r\n", 2),
        ("login,section,name,id,email\n\n,,,,\nal7,B,Ann  Lee , 1042,ann@x.org,,\n", 4),
    ],
    ids=["plain", "excel with a BOM and semicolons", "other order and blank rows"],
)
def test_a_roster_is_read_as_spreadsheets_write_it(file: Path, content: str, line: int) -> None:
    file.write_text(content, encoding="utf-8")
    (student,) = read_roster(file)
    assert (student.id, student.email, student.login, student.line) == (
        *("1042", "ann@x.org", "al7"),
        line,
    )
    assert student.name.split() == ["Ann", "Lee"]


@pytest.mark.parametrize(
    ("content", "line", "words"),
    [
        ("id,name,email\n1,Ann,a@x\n", 1, "no column 'login'. The header must have id,name,email,"),
        ("id,name,id,email,login\n", 1, "there are 2 columns 'id'"),
        ("", 1, "no column 'id'"),
        (HEADER + "1,Ann,,\n\n2,Bo,,\n01,Cy,,\n1,Di,,\n", 6, "the id '1' is already in line 2"),
        (HEADER + "1,Ann,a@x,\n2,Bo,A@X,\n", 3, "the email 'A@X' is already in line 2"),
        (HEADER + "1,Ann,,al\n2,Bo,,al\n", 3, "the login 'al' is already in line 2"),
        (HEADER + ",Ann,a@x,\n", 2, "the id is empty"),
        (HEADER + "1,,a@x,\n", 2, "the name is empty"),
        (HEADER + "1,Lee, Ann,a@x,al\n", 2, "must be 4 cells, got 5. Put a cell that contains ','"),
        (HEADER + "1;Ann;a@x;al\n", 2, "cells must be separated by ',', as in the header"),
        (HEADER + '1,"Ann,a@x,al\n2,Bo,b@x,bo\n', 2, "Close the quote"),
        (HEADER + "=1+1,Ann,,\n", 2, "the id must not begin like a spreadsheet formula"),
        (HEADER + "1,Ann,@SUM(A1),\n", 2, "the email must not begin like a spreadsheet formula"),
    ],
)
def test_a_mistake_in_a_roster_is_reported_with_its_line(
    file: Path, content: str, line: int, words: str
) -> None:
    file.write_text(content, encoding="utf-8")
    with pytest.raises(ValueError, match=rf"roster\.csv, line {line}: .*{re.escape(words)}"):
        read_roster(file)


def test_other_rosters_are_refused(file: Path) -> None:
    file.write_text(HEADER + ",,,\n", encoding="utf-8")
    with pytest.raises(ValueError, match="has no students below its header"):
        read_roster(file)
    file.write_bytes(HEADER.encode() + b"1,J\xfcrgen,,\n")
    with pytest.raises(ValueError, match="line 2: this is not UTF-8"):
        read_roster(file)


def people(folder: Path, names: str, roster: list[Student]) -> ClassList:
    """Return the class of a folder with these submissions, of which those with dots are zips."""
    (folder / "class").mkdir()
    for name in names.split("|"):
        (folder / "class" / name).touch() if name.endswith("zip") else (
            folder / "class" / name
        ).mkdir()
    return match(find_submissions(folder / "class")[0], roster, Path("r.csv"))


@pytest.mark.parametrize(
    "name",
    [
        *("1042", "ANN@x.org.zip", "al7", "Ann Lee", "ann_lee.zip", "LeeAnn"),
        # As Canvas names them: by the id, and by the name where the id is that of another system.
        *("leeann_1042_7_work.zip", "leeann_555_7_work-2.zip", "leeann_LATE_555_7_x.zip"),
        *("Ann Lee_12345_assignsubmission_file", "Ann Lee_12345_assignsubmission_file_"),
        "Ann Lee_12345_assignsubmission_file_work.zip",
    ],
)
def test_a_submission_is_found_by_id_email_login_or_name(tmp_path: Path, name: str) -> None:
    bo = Student("7", "O'Neill, Bo", "", "", 3)
    found = people(tmp_path, f"{name}|oneillbo_9_1_w.zip|zoe", [ANN, bo])
    shown = {one.student: one.path.name for one in found.submissions}
    assert shown == {"Ann Lee": name, "O'Neill, Bo": "oneillbo_9_1_w.zip", "zoe": "zoe"}
    assert (found.missing, found.unmatched) == ([], ["zoe"])
    assert [one.late for one in found.submissions] == ["LATE" in name, False, False]
    assert {"Ann Lee", "1042", "ann@x.org", "al7"} <= set(found.submissions[0].aliases)


def test_a_participants_number_in_moodle_is_no_id(tmp_path: Path) -> None:
    found = people(tmp_path, "Bo_1042_assignsubmission_file", [ANN, Student("7", "Bo", "", "", 3)])
    assert [one.student for one in found.submissions] == ["Bo"]
    assert found.missing == ["Ann Lee"]


@pytest.mark.parametrize(
    ("names", "other", "words"),
    [
        ("Ann Lee", Student("7", "Lee, Ann", "", "", 5), "lines 2 and 5: both match .* 'Ann Lee'"),
        ("al7", Student("al7", "Bo", "", "", 5), "lines 2 and 5: both match the submission 'al7'"),
        # The id is Ann's, and the name is Bo's: ids of another system.
        ("bo_1042_7_w.zip", Student("7", "Bo", "", "", 5), "lines 2 and 5: both match"),
        ("1042|al7", Student("7", "Bo", "", "", 5), "line 2: Ann Lee .* '1042' and 'al7'. Keep"),
    ],
)
def test_what_could_be_anothers_is_refused_with_the_lines(
    tmp_path: Path, names: str, other: Student, words: str
) -> None:
    with pytest.raises(ValueError, match=rf"r\.csv, {words}"):
        people(tmp_path, names, [ANN, other])


def test_students_of_one_name_are_told_apart_by_their_ids(tmp_path: Path) -> None:
    found = people(tmp_path, "al7|8", [ANN, Student("8", "ann lee", "", "", 3)])
    first, second = [one.student for one in found.submissions]
    assert (first, second) == ("Ann Lee (1042)", "ann lee (8)")
    assert found.names == {
        **dict.fromkeys([first, "1042", "Ann Lee", "ann@x.org", "al7"], first),
        **dict.fromkeys([second, "8", "ann lee"], second),
    }


def test_a_name_that_two_students_have_means_neither(tmp_path: Path) -> None:
    found = people(tmp_path, "al7", [ANN, Student("8", "Ann Lee", "", "", 3)])
    assert found.missing == ["Ann Lee (8)"]
    assert set(found.names) == {"Ann Lee (1042)", "1042", "ann@x.org", "al7"}
