"""Odd names, tables and uploads: nobody is dropped, doubled or mixed up in silence."""

from __future__ import annotations

import csv
import zipfile
from pathlib import Path

import pytest

from autograder.submissions.class_list import ClassList, read_class
from autograder.submissions.roster import COLUMNS, read_roster
from autograder.submissions.unpack import class_folder
from moodle_sheet import Sheet, download


def roster_of(path: Path, *rows: tuple[str, ...]) -> Path:
    with path.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([[*COLUMNS, "group"], *rows])
    return path


def class_of(folder: Path, names: str, *rows: tuple[str, ...]) -> ClassList:
    for name in names.split("|"):
        (folder / "class" / name).mkdir(parents=True, exist_ok=True)
    return read_class(folder / "class", roster_of(folder / "roster.csv", *rows) if rows else None)


def who(people: ClassList) -> dict[str, str]:
    return {m.shown: m.submission.path.name if m.submission else "" for m in people.members}


ANN, ANN2 = ("77", "Ann Lee", "", "", ""), ("78", "ann lee", "", "", "")


def test_a_submission_may_have_the_name_that_the_reports_show(tmp_path: Path) -> None:
    people = class_of(tmp_path, "Ann Lee (77)|78", ANN, ANN2)
    assert who(people) == {"Ann Lee (77)": "Ann Lee (77)", "ann lee (78)": "78"}


def test_two_reports_never_have_the_same_name(tmp_path: Path) -> None:
    rows = [("1", "Ann", "", "", "team 1"), ("2", "Bo", "", "", "team 1")]
    with pytest.raises(ValueError, match=r"would both be called 'team 1 \(Ann, Bo\)'. Rename"):
        class_of(tmp_path, "team 1 (Ann, Bo)|Ann", *rows)


@pytest.mark.parametrize(("group", "name"), [("3", "3"), ("Bo", "bo")])
def test_a_submission_that_could_be_by_a_group_or_by_another_student_is_an_error(
    tmp_path: Path, group: str, name: str
) -> None:
    rows = [("1", "Ann", "", "", group), ("3", "Bo", "", "", ""), ("4", "Cy", "", "", group)]
    with pytest.raises(ValueError, match=rf"could be by the group '{group}' or by Bo in line 3 of"):
        class_of(tmp_path, name, *rows)


def test_submitters_of_different_groups_are_an_error(tmp_path: Path) -> None:
    text = 's_1:\n  :submitters: [{":name": Ann}, {":name": Bo}]\n'
    (tmp_path / "class").mkdir()
    (tmp_path / "class/submission_metadata.yml").write_text(text, encoding="utf-8")
    rows = [("1", "Ann", "", "", "a"), ("2", "Bo", "", "", "b"), ("3", "Cy", "", "", "b")]
    words = r"s_1: Gradescope says that Ann \(group 'a'\) and Bo \(group 'b'\) handed in together"
    with pytest.raises(ValueError, match=words):
        class_of(tmp_path, "s_1", *rows)


def test_a_vowel_sign_makes_another_name(tmp_path: Path) -> None:
    people = class_of(tmp_path, "कमल", ("1", "कमला", "", "", ""))
    assert (people.absent, people.unmatched) == (["कमला"], ["कमल"])


@pytest.mark.parametrize("name", ["山田\u3000太郎", "Ann\u00a0Lee"])
def test_an_unusual_space_is_a_space(tmp_path: Path, name: str) -> None:
    plain = " ".join(name.split())
    people = class_of(tmp_path, name, ("1", name, "", "", ""))
    assert who(people) == {plain: name}


def test_a_dot_in_the_name_of_a_folder_begins_no_suffix(tmp_path: Path) -> None:
    people = class_of(tmp_path, "ann|ann.lee")
    assert people.report_of("ann") == "ann"


@pytest.mark.parametrize("number", ["1.23457E+11", "1,23457E+11", "1E+05"])
def test_an_id_that_a_spreadsheet_has_rounded_is_a_mistake(tmp_path: Path, number: str) -> None:
    path = roster_of(tmp_path / "roster.csv", (number, "Ann", "", "", ""))
    with pytest.raises(ValueError, match="line 2: a spreadsheet has rounded the id, got '1"):
        read_roster(path)


# Moodle

UPLOADS = {
    "Ann Lee_12_assignsubmission_file/README.md": "x",
    "Bo_13_assignsubmission_file/.gitignore": "x",
    "Cy_14_assignsubmission_file/a\x01.zip": "x",
    ". Suharto_15_assignsubmission_file/work.zip": "x",
    "می\u200cسر_16_assignsubmission_file/work\u202f1.zip": "x",
    ".DS_Store": "x",
    "__MACOSX/Ann Lee_12_assignsubmission_file/._README.md": "x",
}


def test_whoever_uploaded_anything_to_moodle_has_handed_in(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "lab1.zip", "w") as file:
        for name, text in UPLOADS.items():
            file.writestr(name, text)
    rows = [(str(i), name, "", "", "") for i, name in enumerate(["Ann Lee", "Bo", "Cy"], 1)]
    rows += [("4", ". Suharto", "", "", ""), ("5", "می\u200cسر", "", "", "")]
    people = read_class(
        class_folder(tmp_path / "lab1.zip"), roster_of(tmp_path / "roster.csv", *rows)
    )
    assert (people.absent, people.unmatched) == ([], [])
    assert len(people.submissions) == 5


def test_a_worksheet_knows_students_with_a_dot_in_their_name(tmp_path: Path) -> None:
    people = {
        12: ("Ann B. Lee", "u77", "a@x.org"),
        13: ("Ann B. Lee", "u78", "b@x.org"),
        14: ("Bo", "u79", "c@x.org"),
        16: ("Cy", "u80", "d@x.org"),
    }
    (tmp_path / "class").mkdir()
    (tmp_path / "class/worksheet.csv").write_text(download(Sheet(), people), encoding="utf-8")
    rows = [("u77", "Ann B. Lee", "", "", ""), ("u78", "Ann B. Lee", "", "", "")]
    names = [f"Ann B. Lee_{number}_assignsubmission_file" for number in (12, 13)]
    found = class_of(tmp_path, "|".join(names), *rows)
    assert who(found) == {"Ann B. Lee (u77)": names[0], "Ann B. Lee (u78)": names[1]}


def test_a_participant_whose_submission_was_not_downloaded_is_named(tmp_path: Path) -> None:
    (tmp_path / "class").mkdir()
    (tmp_path / "class/worksheet.csv").write_text(download(Sheet()), encoding="utf-8")
    found = class_of(tmp_path, "Ann Lee_12_assignsubmission_file|Bo_14_assignsubmission_file")
    place = tmp_path / "class"
    assert found.notes == [
        f"1 participants in worksheet.csv have handed in, but not in {place}: Bo O'Neill (13)"
    ]


def test_without_an_order_of_uploads_none_is_the_last(tmp_path: Path) -> None:
    names = "Ann_1_assignsubmission_file|Bo_2_assignsubmission_file"
    rows = [("1", "Ann", "", "", "a"), ("2", "Bo", "", "", "a")]
    (tmp_path / "class/Bo_2_assignsubmission_file/ch02_vectors").mkdir(parents=True)
    (tmp_path / "class/Bo_2_assignsubmission_file/ch02_vectors/vector.py").touch()
    with pytest.raises(ValueError, match=r"lines 2 and 3: Ann and Bo must hand in only once"):
        class_of(tmp_path, names, *rows)


def test_moodle_has_the_files_of_a_team_once_for_each_student(tmp_path: Path) -> None:
    names = [f"Team 1-{name}_assignsubmission_file" for name in ("Ann_1", "Bo_2")]
    rows = [("1", "Ann", "", "", "Team 1"), ("2", "Bo", "", "", "Team 1")]
    for name in names:
        (tmp_path / "class" / name).mkdir(parents=True)
        (tmp_path / "class" / name / "work.zip").write_bytes(b"zip")
    found = class_of(tmp_path, "|".join(names), *rows)
    assert who(found) == {"Ann": names[0], "Bo": names[0]}
    (submission,) = found.submissions
    assert submission.notes == (
        f"'{names[0]}' was graded, and '{names[1]}' was not: it has the same files",
    )


# GitHub and Gradescope

GITHUB = "student_repository_name,roster_identifier,submission_timestamp\n"


def with_grades(folder: Path, text: str) -> ClassList:
    (folder / "class").mkdir()
    (folder / "class/grades.csv").write_text(text, encoding="utf-8")
    rows = [("1", "Ann", "", "", ""), ("2", "Bo", "", "", "")]
    return class_of(folder, "lab1-x", *rows)


@pytest.mark.parametrize("separator", [",", ";"])
def test_the_students_of_one_repository_are_a_group(tmp_path: Path, separator: str) -> None:
    text = f"\ufeff{GITHUB}lab1-x,1,\nlab1-x,2,\n".replace(",", separator)
    assert who(with_grades(tmp_path, text)) == {"Ann": "lab1-x", "Bo": "lab1-x"}


def test_another_table_in_place_of_githubs_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"grades.csv, line 1: the grades of GitHub Classroom"):
        with_grades(tmp_path, "student,points\nAnn,3\n")


@pytest.mark.parametrize("text", ["- a\n", "a\n", "s_1: yes\n"])
def test_another_file_in_place_of_gradescopes_is_an_error(tmp_path: Path, text: str) -> None:
    (tmp_path / "submission_metadata.yml").write_text(text, encoding="utf-8")
    (tmp_path / "s_1").mkdir()
    with pytest.raises(ValueError, match=r"is not the file of this name in an export from Gradesc"):
        read_class(tmp_path)
