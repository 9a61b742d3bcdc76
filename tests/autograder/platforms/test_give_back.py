"""Moodle and Canvas hand each page to its own student, whom they find by the name of the file."""

from __future__ import annotations

import io
import re
import zipfile
from pathlib import Path, PurePosixPath

from autograder.platforms.give_back import give_back
from autograder.reports.feedback import write_feedback
from autograder.reports.report import StudentReport
from autograder.submissions.class_list import ClassList
from autograder.submissions.find import file_name
from autograder.submissions.roster import Student
from graded import failed_run, report_of
from listed import listed
from small_class import table

FROM_MOODLE = [
    "Ann Lee_12_assignsubmission_file",
    "Bo O'Neill_13_assignsubmission_file_",  # from a Moodle before 4.1
    "Bo O'Neill_14_assignsubmission_file",
    "R2_D2 7_15_assignsubmission_file",
    "Participant_16_assignsubmission_file",
    "Zoë 李_17_assignsubmission_file_work.zip",
]
FROM_CANVAS = {  # each with the user and the upload
    "doejane_77_101_work-1.zip": (77, 101),
    "leebo_LATE_78_102_work.zip": (78, 102),
    "anon_x3f9q_103_work.zip": (79, 103),
    "LATE_anon_a1b2c_104_my_work.zip": (80, 104),
    "leebo_81_105_linked.zip": (81, 105),
    "3po_82_106_7_8_work.ZIP": (82, 106),
}
ANONYMOUS = {"x3f9q": 79, "a1b2c": 80}


def written(out: Path, people: ClassList, reports: list[StudentReport]) -> list[Path]:
    for report in reports:
        write_feedback(out, report)
    return give_back(out, people, reports)


def give_back_to(out: Path, *names: str) -> Path:
    """Return the zip for a class in which everybody has been graded."""
    people = listed(*names)
    (path,) = written(out, people, [report_of(member.shown) for member in people.members])
    return path


def files_in(path: Path | io.BytesIO) -> dict[str, bytes]:
    with zipfile.ZipFile(path) as file:
        return {name: file.read(name) for name in file.namelist()}


def moodle_finds(path: str, participants: set[int]) -> tuple[int, str, str]:
    """Return the participant, the plugin and the name of a file in a zip that is uploaded.

    As in Moodle's mod/assign/feedback/file/importziplib.php. Before 4.1 names needed 5 parts.
    """
    parts = f"/import/{path}".split("/")
    assert not parts[-1].startswith((".", "~"))
    while parts:
        info = parts.pop(0).split("_", 4)
        if len(info) < 5 or not info[1].isdecimal() or int(info[1]) not in participants:
            continue
        assert (info[2], info[3]) == ("assignfeedback", "file"), "there is no such plugin"
        name = PurePosixPath("/".join([info[4], *parts]))
        assert str(name.parent) == "/", "the file would be in a folder"
        return int(info[1]), f"{info[2]}_{info[3]}", name.name
    raise AssertionError(f"Moodle ignores {path}")


def canvas_finds(path: str) -> tuple[int, int]:
    """Return the user and the upload for which Canvas takes a file in a zip.

    As in infer_comment_context_from_filename() of its app/models/abstract_assignment.rb.
    """
    name = PurePosixPath(path).name
    parts = [part for part in name.split("_") if part != "LATE"]
    if parts[0] == "anon":
        user, upload = ANONYMOUS[parts[1]], int(parts[2])
    else:
        user, upload = [int(part) for part in parts if re.fullmatch(r"\d+", part)][:2]
    assert not parts[-1].startswith("link"), "Canvas takes it for a URL that was handed in"
    assert not name.startswith("._")
    return user, upload


def test_moodle_finds_each_participant(tmp_path: Path) -> None:
    path = give_back_to(tmp_path, *FROM_MOODLE)
    assert path.name == "feedback-moodle.zip"
    found = {moodle_finds(name, {*range(12, 18)}): page for name, page in files_in(path).items()}
    assert {one[0] for one in found} == {*range(12, 18)}
    assert {one[1:] for one in found} == {("assignfeedback_file", "feedback.html")}
    for (number, *_), page in found.items():
        (name,) = (name for name in FROM_MOODLE if f"_{number}_" in name)
        shown = name.partition("_assign")[0]
        assert page == (tmp_path / f"feedback/{shown}.html").read_bytes()


def test_canvas_finds_each_upload(tmp_path: Path) -> None:
    path = give_back_to(tmp_path, *FROM_CANVAS)
    assert path.name == "feedback-canvas.zip"
    assert all(name.endswith(".zip") for name in files_in(path))
    found = {canvas_finds(name): content for name, content in files_in(path).items()}
    assert {*found} == {*FROM_CANVAS.values()}
    for name, upload in FROM_CANVAS.items():
        export = listed(name).submissions[0].export
        assert export
        page = (tmp_path / f"feedback/{export.student}.html").read_bytes()
        assert files_in(io.BytesIO(found[upload])) == {"feedback.html": page}, "a zip, as uploaded"


def test_only_pages_of_graded_students_from_a_platform_are_given_back(tmp_path: Path) -> None:
    reports = [report_of("ann"), report_of("bob")]
    assert written(tmp_path, listed("ann", "bob"), reports) == []
    people = listed(*FROM_MOODLE[:3])
    reports = [report_of("Ann Lee_12"), failed_run("Bo O'Neill_13")]
    (path,) = written(tmp_path, people, reports)
    assert [moodle_finds(name, {12, 13, 14})[0] for name in files_in(path)] == [12]


def test_mail_csv_says_who_gets_which_page(tmp_path: Path) -> None:
    roster = [
        Student("77", "Ann Lee", "ann@x.org", "", 2),
        Student("78", "=1+1", "", "", 3),
        Student("79", "Cy", "cy@x.org", "", 4),  # handed nothing in
    ]
    people = listed("77", "78", "zoe", roster=roster)
    reports = [report_of(one.student) for one in people.submissions]
    assert written(tmp_path, people, reports) == [tmp_path / "mail.csv"]
    rows = {row.pop("name"): row for row in table(tmp_path / "mail.csv")}
    assert {name: row["email"] for name, row in rows.items()} == {
        "Ann Lee": "ann@x.org",
        "'=1+1": "",
    }
    for name, report in (("Ann Lee", "Ann Lee"), ("'=1+1", "=1+1")):
        assert rows[name]["file"] == str(tmp_path / f"feedback/{file_name(report)}.html")
