"""The roster: how it is read, what is refused with its line, and whom a submission belongs to."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import pytest

from autograder.submissions.class_list import ClassList, read_class
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
        (HEADER + ",Ann,,\n1,,,\n", 3, "the name is empty"),  # all lines at once
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
    (folder / "class").mkdir(exist_ok=True)
    for name in names.split("|"):
        path = folder / "class" / name
        path.touch() if name.endswith(("zip", "pdf")) else path.mkdir()
    rows = [[one.id, one.name, one.email, one.login, one.group] for one in roster]
    with (folder / "r.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([[*HEADER.strip().split(","), "group"], *rows])
    return read_class(folder / "class", folder / "r.csv")


@pytest.mark.parametrize(
    "name",
    [
        *("1042", "ANN@x.org.zip", "al7", "Ann Lee", "ann_lee.zip", "Lee, Ann"),
        # As Canvas names them: by the id, and by the name where the id is that of another system.
        *("leeann_1042_7_work.zip", "leeann_555_7_work-2.zip", "leeann_LATE_555_7_x.zip"),
        *("leeann_1042_7_work", "leeann_555_7_work"),  # unpacked by hand
        *("Ann Lee_12345_assignsubmission_file", "Ann Lee_12345_assignsubmission_file_"),
        "Ann Lee_12345_assignsubmission_file_work.zip",
    ],
)
def test_a_submission_is_found_by_id_email_login_or_name(tmp_path: Path, name: str) -> None:
    bo = Student("7", "O'Neill, Bo", "", "", 3)
    found = people(tmp_path, f"{name}|oneillbo_9_1_w.zip|zoe", [ANN, bo])
    shown = {one.student: one.path.name for one in found.submissions}
    assert shown == {"Ann Lee": name, "O'Neill, Bo": "oneillbo_9_1_w.zip", "zoe": "zoe"}
    assert (found.absent, found.unmatched) == ([], ["zoe"])
    assert [one.late for one in found.submissions] == ["LATE" in name, False, False]
    for known in ("Ann Lee", "1042", "ann@x.org", "AL7", name):
        assert found.report_of(known) == "Ann Lee"


@pytest.mark.parametrize(
    "name", ["LeeAnn", "Lee Ann", "annlee_555_7_w", "lab1_1042_7_w.zip", "ann", "Ann Lée"]
)
def test_a_name_that_is_only_similar_is_another_student(tmp_path: Path, name: str) -> None:
    """Li Wei and Wei Li are two people, and a Canvas name begins with the family name."""
    if name == "lab1_1042_7_w.zip":
        with pytest.raises(ValueError, match="its number 1042 is that of Ann Lee in line 2"):
            people(tmp_path, name, [ANN])
        return
    if name == "annlee_555_7_w":
        assert people(tmp_path, name, [ANN]).unmatched == []
        return
    assert people(tmp_path, name, [ANN]).absent == ["Ann Lee"]


def test_two_people_whose_names_are_swapped_stay_two(tmp_path: Path) -> None:
    roster = [Student("1", "Li Wei", "", "", 2), Student("2", "Wei Li", "", "", 3)]
    found = people(tmp_path, "Wei Li|Li Wei", roster)
    assert {one.student: one.path.name for one in found.submissions} == {
        "Li Wei": "Li Wei",
        "Wei Li": "Wei Li",
    }
    assert (found.report_of("li wei"), found.report_of("Li, Wei")) == ("Li Wei", "Wei Li")


def test_a_participants_number_in_moodle_is_no_id(tmp_path: Path) -> None:
    found = people(tmp_path, "Bo_1042_assignsubmission_file", [ANN, Student("7", "Bo", "", "", 3)])
    assert [one.student for one in found.submissions] == ["Bo"]
    assert found.absent == ["Ann Lee"]


@pytest.mark.parametrize(
    ("names", "other", "words"),
    [
        ("Ann Lee", Student("7", "ann lee", "", "a2", 3), ""),  # exactly the first one's name
        ("ANN LEE", Student("7", "ann lee", "", "", 3), "lines 2 and 3: both match .* 'ANN LEE'"),
        ("al7", Student("al7", "Bo", "", "", 3), "lines 2 and 3: both match the submission 'al7'"),
        # The id is Ann's, and the name is Bo's: ids of another system.
        ("bo_1042_7_w.zip", Student("7", "Bo", "", "", 3), "lines 2 and 3: both match"),
        ("cy_1042_7_w.zip", Student("7", "Bo", "", "", 3), "its number 1042 is that of Ann Lee"),
        ("1042|al7", Student("7", "Bo", "", "", 3), "line 2: Ann Lee .* '1042' and 'al7'. Keep"),
        (
            "Ann Lee_9_assignsubmission_file",
            Student("7", "Ann Lee", "", "", 3),
            "lines 2 and 3: .* rename the submission to 'ID_9_assignsubmission_file', where ID",
        ),
    ],
)
def test_what_could_be_anothers_is_refused_with_the_lines(
    tmp_path: Path, names: str, other: Student, words: str
) -> None:
    if not words:
        assert people(tmp_path, names, [ANN, other]).absent == ["ann lee (7)"]
        return
    with pytest.raises(ValueError, match=words):
        people(tmp_path, names, [ANN, other])


def test_all_that_is_not_clear_is_reported_at_once(tmp_path: Path) -> None:
    names = "bo_1042_7_w.zip|1042|al7|ANN@x.org"
    with pytest.raises(ValueError, match="both match") as caught:
        people(tmp_path, names, [ANN, Student("7", "Bo", "", "", 3)])
    assert len(str(caught.value).splitlines()) == 2


def test_students_of_one_name_are_told_apart_by_their_ids(tmp_path: Path) -> None:
    found = people(tmp_path, "al7|8", [ANN, Student("8", "ann lee", "", "", 3)])
    first, second = [one.student for one in found.submissions]
    assert (first, second) == ("Ann Lee (1042)", "ann lee (8)")
    for name in ("1042", "Ann Lee", "ann@x.org", "al7", first):
        assert found.report_of(name) == first
    for name in ("8", "ann lee", second):
        assert found.report_of(name) == second


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("Ann Lee", r"'Ann Lee' could be Ann Lee \(1042\) and Ann Lee \(8\). Write the id or"),
        ("Jose Nandu", r"there is no student 'Jose Nandu'. Did you mean José Ñandú\?"),
        ("Ñandú", r"there is no student 'Ñandú'. Did you mean José Ñandú\?"),
        ("Eve Nobody", r"there is no student 'Eve Nobody'.$"),
    ],
)
def test_a_name_that_means_nobody_or_several_is_an_error(
    tmp_path: Path, name: str, words: str
) -> None:
    jose = Student("00042", "José Ñandú", "", "", 4)
    found = people(tmp_path, "al7|00042", [ANN, Student("8", "Ann Lee", "", "", 3), jose])
    assert found.report_of("42") == "José Ñandú", "as a spreadsheet writes the id"
    assert found.report_of("8") == "", "has handed in nothing"
    with pytest.raises(ValueError, match=words):
        found.report_of(name)


def test_a_student_is_in_exactly_one_state(tmp_path: Path) -> None:
    roster = [ANN, Student("7", "Bo", "", "", 3), Student("8", "Cy", "", "", 4)]
    found = people(tmp_path, "Bo.pdf|1042|1042.pdf|zoe", roster)
    states = {m.shown: m.submission and (m.submission.nothing or "graded") for m in found.members}
    assert states == {
        "Ann Lee": "graded",
        "Bo": "'Bo.pdf' cannot be graded: it is neither a folder nor a .zip file",
        "Cy": None,
        "zoe": "graded",
    }


def test_a_group_hands_in_once(tmp_path: Path) -> None:
    roster = [
        Student("1", "Ann", "", "", 2, "team 1"),
        Student("2", "Bo", "", "", 3, "Team 1"),
        Student("3", "Cy", "", "", 4, "team 2"),
        Student("4", "Di", "", "", 5, "team 2"),
        Student("5", "Eve", "", "", 6),
    ]
    found = people(tmp_path, "Bo|team 2|5", roster)
    reports = {one.student: one.path.name for one in found.submissions}
    assert set(reports.values()) == {"Bo", "team 2", "5"}
    (first,) = [name for name, path in reports.items() if path == "Bo"]
    assert found.students_of(first) == ["Ann", "Bo"]
    assert found.report_of("Ann") == found.report_of("2") == first
    assert found.report_of("team 2") == "team 2 (Cy, Di)"
    assert found.absent == []
    (tmp_path / "class/Ann").mkdir()
    with pytest.raises(ValueError, match="Ann and Bo must hand in only once, got 'Ann' and 'Bo'"):
        read_class(tmp_path / "class", tmp_path / "r.csv")


GRADESCOPE = """\
submission_1:
  :submitters:
  - {":name": Anna, ":sid": '1042', ":email": other@x.org}
submission_2:
  :submitters:
  - {":name": Bo, ":email": BO@x.org}
  - {":name": Cy}
submission_3:
  :submitters:
  - {":name": Stranger}
"""
GITHUB = """\
assignment_name,github_username,roster_identifier,student_repository_name
lab1,al,ann@x.org,lab1-al
lab1,bo,,lab1-bo
"""
CLASSMATES = [ANN, Student("7", "Bo", "bo@x.org", "", 3), Student("8", "Cy", "", "", 4)]


def with_file(folder: Path, name: str, text: str, submissions: str) -> ClassList:
    (folder / "class").mkdir()
    (folder / "class" / name).write_text(text, encoding="utf-8")
    return people(folder, submissions, CLASSMATES)


def test_gradescope_says_who_handed_in(tmp_path: Path) -> None:
    names = "submission_1|submission_2|submission_3"
    found = with_file(tmp_path, "submission_metadata.yml", GRADESCOPE, names)
    who = {m.shown: m.submission.path.name for m in found.members if m.submission}
    assert who == {
        "Ann Lee": "submission_1",
        "Bo": "submission_2",  # a pair, which has one report
        "Cy": "submission_2",
        "Stranger": "submission_3",
    }
    assert found.students_of("Bo, Cy") == ["Bo", "Cy"]
    assert (found.absent, found.unmatched) == ([], ["Stranger"])


def test_github_says_who_a_repository_belongs_to(tmp_path: Path) -> None:
    found = with_file(tmp_path, "grades.csv", GITHUB, "lab1-al|lab1-bo")
    assert {one.student: one.path.name for one in found.submissions} == {
        "Ann Lee": "lab1-al",
        "lab1-bo": "lab1-bo",
    }
    assert found.unmatched == ["lab1-bo"]
    without = read_class(tmp_path / "class")
    assert [one.student for one in without.submissions] == ["ann@x.org", "lab1-bo"]


def test_submitters_who_contradict_the_roster_are_an_error(tmp_path: Path) -> None:
    text = "submission_1:\n  :submitters: [{':name': Bo, ':sid': '1042'}]\n"
    with pytest.raises(ValueError, match="lines 2 and 3: both match the submission"):
        with_file(tmp_path, "submission_metadata.yml", text, "submission_1")


def test_a_submitter_who_is_not_on_the_roster_is_noted(tmp_path: Path) -> None:
    text = "submission_1:\n  :submitters: [{':name': Bo}, {':name': Eve}]\n"
    found = with_file(tmp_path, "submission_metadata.yml", text, "submission_1")
    assert [one.student for one in found.submissions] == ["Bo"]
    assert found.notes == ["submission_1: Gradescope also names Eve, who is not on the roster"]


def test_two_members_of_a_group_who_upload_must_be_told_apart(tmp_path: Path) -> None:
    roster = [Student("1", "Ann", "", "", 2, "team 1"), Student("2", "Bo", "", "", 3, "team 1")]
    (tmp_path / "class").mkdir()
    (tmp_path / "class/ann_1_7_w.zip").write_bytes(b"other work")
    with pytest.raises(ValueError, match="must hand in only once, got"):
        people(tmp_path, "ann_1_7_w.zip|bo_2_8_w.zip", roster)


def test_students_of_one_name_on_gradescope_stay_two_without_a_roster(tmp_path: Path) -> None:
    text = 'a:\n  :submitters: [{":name": Bo}]\nb:\n  :submitters: [{":name": Bo}]\n'
    (tmp_path / "submission_metadata.yml").write_text(text, encoding="utf-8")
    for name in "ab":
        (tmp_path / name).mkdir()
    assert [one.student for one in read_class(tmp_path).submissions] == ["Bo (a)", "Bo (b)"]
