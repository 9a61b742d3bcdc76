"""The roster, and whom a submission belongs to: nobody is dropped, doubled or mixed up unseen."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from autograder.submissions.roster import read_roster
from listed import class_in, handed_in
from moodle_sheet import Sheet, download

ANN, BO, CY = "1042,Ann Lee,ann@x.org,al7\n", "7,Bo,bo@x.org,\n", "8,Cy,,\n"
ANN2, ONEILL = "7,ann lee,,\n", '7,"O\'Neill, Bo",,\n'
TEAM = "1,Ann,,,team 1\n2,Bo,,,team 1\n"
MOODLE = "assignsubmission_file"
ANN_12 = f"Ann Lee_12_{MOODLE}"
BO_13 = f"Bo O'Neill_13_{MOODLE}"
HEADER = "id,name,email,login\n"
GRADESCOPE, GITHUB, WORKSHEET = "submission_metadata.yml", "grades.csv", "worksheet.csv"
SUBMITTERS = """\
s_1:
  :submitters:
  - {":name": Anna, ":sid": '1042', ":email": other@x.org}
s_2:
  :submitters:
  - {":name": Bo, ":email": BO@x.org}
  - {":name": Cy}
s_3:
  :submitters:
  - {":name": Stranger}
"""
OVERLAP = "s_1: {':submitters': [{':name': Ann Lee}, &bo {':name': Bo}]}\n"
OVERLAP += "s_2: {':submitters': [*bo, {':name': Cy}]}"
WITH_EVE = "s_1: {':submitters': [{':name': Bo}, {':name': Eve}]}"
REPOSITORIES = "github_username,roster_identifier,student_repository_name,submission_timestamp\n"
SHEET = download(Sheet())
NAMESAKES = "u77,Ann Lee,ann@x.org,\nu78,Bo O'Neill,bo@x.org,\nu80,Bo O'Neill,bo2@x.org,\n"
BO_TWICE = "a: &a {':submitters': [{':name': Bo}]}\nb: *a\n"
TWO = f"{REPOSITORIES}al,ann@x.org,l-al,\nbo,,l-bo,\n"
ONE = f"{REPOSITORIES}b,7,l-x,\nc,8,l-x,\n"
B_O = {78: f"B. O_13_{MOODLE}", 80: f"B. O_14_{MOODLE}"}


def dotted(text: str) -> str:
    return text.replace("Bo O'Neill", "B. O")


@pytest.mark.parametrize(
    "name",
    [
        *("1042", "ANN@x.org.zip", "al7", "Ann Lee", "ann_lee.zip", "Lee, Ann"),
        # As Canvas names them: by the id, and by the name where the id is that of another system.
        *("leeann_1042_7_work.zip", "leeann_555_7_work-2.zip", "leeann_LATE_555_7_x.zip"),
        *("leeann_1042_7_work", "leeann_555_7_work"),  # unpacked by hand
        *(f"Ann Lee_12345_{MOODLE}{rest}" for rest in ("", "_", "_work.zip")),
    ],
)
def test_a_submission_is_found_by_id_email_login_or_name(tmp_path: Path, name: str) -> None:
    found = class_in(tmp_path, f"{name}|oneillbo_9_1_w.zip|zoe", ANN + ONEILL)
    assert handed_in(found) == {"Ann Lee": name, "O'Neill, Bo": "oneillbo_9_1_w.zip", "zoe": "zoe"}
    assert (found.absent, found.unmatched) == ([], ["zoe"])
    assert [one.late for one in found.submissions] == ["LATE" in name, False, False]
    for known in ("Ann Lee", "1042", "ann@x.org", "AL7", name):
        assert found.report_of(known) == "Ann Lee"


@pytest.mark.parametrize(
    ("names", "roster", "found"),
    [
        # A name that is only similar is another student's.
        *((name, ANN, {"Ann Lee": "", name: name}) for name in ("ann", "Ann Lée")),
        ("कमल", "1,कमला,,\n", {"कमला": "", "कमल": "कमल"}),  # a vowel sign
        ("annlee_555_7_w", ANN, {"Ann Lee": "annlee_555_7_w"}),
        ("Wei Li|Li Wei", "1,Li Wei,,\n2,Wei Li,,\n", {"Li Wei": "Li Wei", "Wei Li": "Wei Li"}),
        # A participant's number in Moodle is no id.
        (f"Bo_1042_{MOODLE}", ANN + BO, {"Ann Lee": "", "Bo": f"Bo_1042_{MOODLE}"}),
        # The ids distinguish students with the same name. An exact match of a name comes first.
        ("Ann Lee (1042)", ANN + ANN2, {"Ann Lee (1042)": "Ann Lee (1042)", "ann lee (7)": ""}),
        ("Ann Lee", ANN + ANN2, {"Ann Lee (1042)": "Ann Lee", "ann lee (7)": ""}),
        # An unusual space is a space.
        ("山田\u3000太郎", "1,山田\u3000太郎,,\n", {"山田 太郎": "山田\u3000太郎"}),
        # A name is one of Canvas's only if all of them look like one download from there.
        *(
            (names, "", {name.removesuffix(".zip"): name for name in names.split("|")})
            for names in (
                "lab1_2026_10_ann.zip|lab1_2026_11_bob.zip",  # two uploads of one student?
                "lab1_2026_10_ann.zip|lab2_2026_11_bob.zip",  # two students with one number?
                "doejane_77_1_work.zip|leebo_78_2_work.zip|carl.zip",  # not all are Canvas's
                "doejane_77_1_work|leebo_78_2_work",  # Canvas has no folders
            )
        ),
        # A group hands in once, under the name of any member or its own.
        ("Bo", TEAM.replace("Bo,,,t", "Bo,,,T") + CY, {"Ann": "Bo", "Bo": "Bo", "Cy": ""}),
        ("team 1|8", TEAM + CY, {"Ann": "team 1", "Bo": "team 1", "Cy": "8"}),
    ],
)
def test_a_name_means_the_student_who_has_it(
    tmp_path: Path, names: str, roster: str, found: dict[str, str]
) -> None:
    assert handed_in(class_in(tmp_path, names, roster)) == found


@pytest.mark.parametrize(
    ("names", "roster", "file", "text", "found"),
    [
        (
            *("s_1|s_2|s_3", ANN + BO + CY, GRADESCOPE, SUBMITTERS),
            {"Ann Lee": "s_1", "Bo": "s_2", "Cy": "s_2", "Stranger": "s_3"},
        ),
        # Without a roster, students of one name stay two.
        ("a|b", "", GRADESCOPE, BO_TWICE, {"Bo (a)": "a", "Bo (b)": "b"}),
        ("l-al|l-bo", ANN + BO, GITHUB, TWO, {"Ann Lee": "l-al", "Bo": "", "l-bo": "l-bo"}),
        ("l-al|l-bo", "", GITHUB, TWO, {"ann@x.org": "l-al", "l-bo": "l-bo"}),
        # The students of one repository are a group.
        ("l-x", BO + CY, GITHUB, "\ufeff" + ONE.replace(",", ";"), {"Bo": "l-x", "Cy": "l-x"}),
        # The worksheet tells students of one name apart, whatever dots are in it.
        (
            *(f"{ANN_12}|B. O_13_{MOODLE}|B. O_14_{MOODLE}", dotted(NAMESAKES), WORKSHEET),
            *(dotted(SHEET), {"Ann Lee": ANN_12, **{f"B. O (u{n})": B_O[n] for n in B_O}}),
        ),
    ],
)
def test_a_platforms_file_says_who_handed_in(
    tmp_path: Path, names: str, roster: str, file: str, text: str, found: dict[str, str]
) -> None:
    assert handed_in(class_in(tmp_path, names, roster, {file: text})) == found


@pytest.mark.parametrize(
    ("names", "roster", "files", "words"),
    [
        ("notes.txt", "", {}, "has no submissions"),
        ("ann|ann.ZIP", "", {}, "ann must hand in only once, got 'ann' and 'ann.ZIP'"),
        ("ANN LEE", ANN + ANN2, {}, "lines 2 and 3 match the submission 'ANN LEE'"),
        # The id is Ann's, and the name is Bo's: ids of another system. All is said at once.
        ("bo_1042_7_w.zip|1042|al7", ANN + BO, {}, "must hand in only once, got '1042' and 'al7'"),
        ("bo_1042_7_w.zip|1042|al7", ANN + BO, {}, "lines 2 and 3 match"),
        ("cy_1042_7_w.zip", ANN + BO, {}, "its number 1042 is that of Ann Lee in line 2"),
        (BO_13, NAMESAKES, {}, "or save the grading worksheet from Moodle as"),
        # Groups
        ("Bo|Ann", TEAM, {}, "lines 2 and 3: Ann and Bo must hand in only once"),
        ("team 1 (Ann, Bo)|Ann", TEAM, {}, "would both be called 'team 1 (Ann, Bo)'. Rename"),
        ("3", "1,Ann,,,3\n3,Bo,,\n4,Cy,,,3\n", {}, "lines 2 and 3 and 4 match the submission '3'"),
        (
            *("s_1", "1,Ann,,,a\n2,Bo,,,b\n3,Cy,,,b\n"),
            {GRADESCOPE: "s_1: {':submitters': [{':name': Ann}, {':name': Bo}]}"},
            "s_1: Gradescope says that Ann (group 'a') and Bo (group 'b') handed in together",
        ),
        # Files of platforms
        (
            "s_1|s_2",
            ANN + BO + CY,
            {GRADESCOPE: OVERLAP},
            "handed in twice, with different students",
        ),
        ("s_1", "", {GITHUB: "student,points\nAnn,3\n"}, "line 1: the grades of GitHub Classroom"),
        ("s_1", "", {GRADESCOPE: "- a\n"}, "is not the file of this name in an export from Grades"),
    ],
)
def test_what_is_not_clear_is_an_error(
    tmp_path: Path, names: str, roster: str, files: dict[str, str], words: str
) -> None:
    with pytest.raises(ValueError, match=re.escape(words)):
        class_in(tmp_path, names, roster, files)


@pytest.mark.parametrize(
    ("names", "roster", "files", "note"),
    [
        (
            *("s_1", ANN + BO, {GRADESCOPE: WITH_EVE}),
            "s_1: Gradescope also names Eve, who is not on the roster",
        ),
        (
            *(f"{ANN_12}|Bo_14_{MOODLE}", "", {WORKSHEET: SHEET}),
            "1 participants in worksheet.csv have handed in, but not in CLASS: Bo O'Neill (13)",
        ),
        (
            *("l-1", "", {GITHUB: REPOSITORIES + "".join(f"x,,l-{n},\n" for n in range(1, 9))}),
            "7 submissions of the platform's files are not in CLASS: l-2; l-3; l-4; l-5; l-6; and "
            "2 more",
        ),
        (
            "leexy_1042_7_w.zip",
            ANN,
            {},
            "leexy_1042_7_w.zip is by Ann Lee, because of its number. Its name is another one",
        ),
    ],
)
def test_what_is_only_odd_is_noted(
    tmp_path: Path, names: str, roster: str, files: dict[str, str], note: str
) -> None:
    people = class_in(tmp_path, names, roster, files)
    assert people.notes == [note.replace("CLASS", str(tmp_path / "class"))]


@pytest.mark.parametrize(
    ("name", "report"),
    [
        *((name, "Ann Lee (1042)") for name in ("1042", "ann@x.org", "al7", "Ann Lee (1042)")),
        ("8", ""),  # has handed in nothing
        ("42", "José Ñandú"),  # as a spreadsheet writes the id
        ("Ann Lee", "!'Ann Lee' could be Ann Lee (1042) and Ann Lee (8). Write the id or the"),
        ("Jose Nandu", "!there is no student 'Jose Nandu'."),
        ("Ann", "team 1 (Ann, Bo)"),
        ("2", "team 1 (Ann, Bo)"),
        ("team 1", "team 1 (Ann, Bo)"),
    ],
)
def test_a_name_in_a_table_means_one_report_or_is_an_error(
    tmp_path: Path, name: str, report: str
) -> None:
    roster = f"{ANN}8,Ann Lee,,\n00042,José Ñandú,,\n{TEAM}"
    found = class_in(tmp_path, "al7|00042|team 1", roster)
    if report.startswith("!"):
        with pytest.raises(ValueError, match=re.escape(report[1:])):
            found.report_of(name)
    else:
        assert found.report_of(name) == report
    assert found.students_of("team 1 (Ann, Bo)") == ["Ann", "Bo"]


def test_a_dot_in_the_name_of_a_folder_begins_no_suffix(tmp_path: Path) -> None:
    assert class_in(tmp_path, "ann|ann.lee").report_of("ann") == "ann"


def test_moodle_has_the_files_of_a_team_once_for_each_student(tmp_path: Path) -> None:
    names = [f"Team 1-{name}_{MOODLE}" for name in ("Ann_1", "Bo_2")]
    for name in names:
        (tmp_path / "class" / name).mkdir(parents=True)
        (tmp_path / "class" / name / "work.zip").write_bytes(b"zip")
    found = class_in(tmp_path, "|".join(names), TEAM)
    assert handed_in(found) == {"Ann": names[0], "Bo": names[0]}
    (submission,) = found.submissions
    assert submission.notes == (
        f"'{names[0]}' was graded, and '{names[1]}' was not: it has the same files",
    )


@pytest.mark.parametrize(
    ("content", "line"),
    [
        (HEADER + "1042,Ann Lee,ann@x.org,al7\n", 2),
        ("\ufeffID;Name;Email;Login\r\n1042;Ann Lee;ann@x.org;al7\r\n;;;\r\n", 2),
        ("login,section,name,id,email\n\n,,,,\nal7,B,Ann  Lee , 1042,ann@x.org,,\n", 4),
    ],
)
def test_a_roster_is_read_as_spreadsheets_write_it(tmp_path: Path, content: str, line: int) -> None:
    file = tmp_path / "roster.csv"
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
        ("id,name,email\n1,Ann,a@x\n", 1, "are 0 columns 'login'. The header must have id,name,e"),
        ("id,name,id,email,login\n", 1, "there are 2 columns 'id'"),
        (HEADER + "1,Ann,,\n\n2,Bo,,\n01,Cy,,\n1,Di,,\n", 6, "the id '1' is already in line 2"),
        (HEADER + "1,Ann,a@x,\n2,Bo,A@X,\n", 3, "the email 'A@X' is already in line 2"),
        (HEADER + ",Ann,a@x,\n", 2, "the id is empty"),
        (HEADER + "1,Lee, Ann,a@x,al\n", 2, "must be 4 cells, got 5. Put a cell that contains ','"),
        (HEADER + "1;Ann;a@x;al\n", 2, "the name is empty"),
        (HEADER + '1,"Ann,a@x,al\n2,Bo,b@x,bo\n', 2, "Close the quote"),
        (HEADER + "=1+1,Ann,,\n", 2, "the id '=1+1' must not begin like a spreadsheet formula"),
    ],
)
def test_a_mistake_in_a_roster_is_reported_with_its_line(
    tmp_path: Path, content: str, line: int, words: str
) -> None:
    file = tmp_path / "roster.csv"
    file.write_text(content, encoding="utf-8")
    with pytest.raises(ValueError, match=rf"roster\.csv, line {line}: .*{re.escape(words)}"):
        read_roster(file)


def test_other_rosters_are_refused(tmp_path: Path) -> None:
    file = tmp_path / "roster.csv"
    file.write_text(HEADER + ",,,\n", encoding="utf-8")
    with pytest.raises(ValueError, match="has no students below its header"):
        read_roster(file)
    file.write_bytes(HEADER.encode() + b"1,J\xfcrgen,,\n")
    with pytest.raises(ValueError, match="line 2: this is not UTF-8"):
        read_roster(file)
