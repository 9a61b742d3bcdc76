"""A class is graded with its roster: under names, and under codes that give nothing away."""

from __future__ import annotations

import re
import stat
from pathlib import Path

import pytest

from autograder.platforms.uploads import Column
from autograder.submissions.unpack import class_folder
from small import MANIFEST, RIGHT, WRITTEN, hand_in, make_root
from small_class import HALF, everything_in, grade, scores, table
from staging import zip_of
from typed import typed

SMALL = "ch90_small/small.py"
ROSTER = """id,name,email,login
77,Jane Doe,jane@x.org,jd9
u1042,Bo Lee,bo@x.org,bl8
99,Eve Moss,eve@x.org,em9
"""
IDENTITIES = re.compile(r"(?i)jane|\bdoe\b|doejane|bo lee|leebo|moss|zed_|x\.org|jd9|bl8|em9|u1042")


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return make_root(tmp_path / "root", MANIFEST + WRITTEN)


@pytest.fixture
def roster(tmp_path: Path) -> Path:
    (tmp_path / "roster.csv").write_text(ROSTER, encoding="utf-8")
    return tmp_path / "roster.csv"


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    """Return a class from Canvas, with a late student, and one who is not on the roster."""
    files = {
        "doejane_LATE_77_3_work.zip": zip_of({SMALL: HALF.encode()}),
        "leebo_501_4_work-1.zip": zip_of(
            {f"bo lee's/{SMALL}": RIGHT.encode(), f"old/{SMALL}": b""}
        ),
        "zed_502_5_work.zip": zip_of({SMALL: RIGHT.encode()}),
    }
    path = tmp_path / "lab1.zip"
    path.write_bytes(zip_of(files))
    folder = class_folder(path)
    marks = "student,exercise,points,comment\ndoejane_77,90.2,1,\nu1042,90.2,3,\n"
    (folder / "marks.csv").write_text(marks, encoding="utf-8")
    return folder


def test_a_class_is_graded_under_the_names_of_its_roster(
    root: Path, roster: Path, submissions: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    assert grade(submissions, out, root, roster=roster, column=Column("Lab 1 (12)", 18)) == 0
    assert scores(out) == {"Bo Lee": 6.0, "Jane Doe": 5.0, "zed_502": 6.0}
    rows = {row["student"]: row for row in table(out / "gradebook.csv")}
    states = {name: (row["status"], row["by hand"], row["total"]) for name, row in rows.items()}
    del states["points possible"]
    assert states == {
        "Bo Lee": ("graded", "3", "9"),
        "Jane Doe": ("graded", "1", "6"),
        "zed_502": ("graded; not on the roster", "", "6"),
        "Eve Moss": ("nothing handed in", "", ""),
    }
    page = (out / "index.html").read_text(encoding="utf-8")
    assert re.search(r"Nothing handed in: 1\.</strong> <bdi>Eve Moss</bdi>", page)
    assert re.search(r"Not on the roster: 1\.</strong> <bdi>zed_502</bdi>", page)
    printed = capsys.readouterr().out
    assert "Nothing handed in: 1 (Eve Moss)." in printed
    assert "Not on the roster: 1 (zed_502)." in printed
    grades = {row["ID"]: row["Lab 1 (12)"] for row in table(out / "canvas.csv")}
    assert grades == {"": "18", "77": "12", "501": "18", "99": ""}
    grades = {row["ID number"]: row["Lab 1"] for row in table(out / "moodle.csv")}
    assert grades == {"77": "12", "u1042": "18", "99": "-"}


def test_codes_replace_every_name_and_stay_the_same(
    root: Path, roster: Path, submissions: Path, tmp_path: Path
) -> None:
    out, key = tmp_path / "out", tmp_path / "roster-key.csv"
    for _ in range(2):
        assert grade(submissions, out, root, roster=roster, anonymous=True) == 0
        codes = {row["name"] or row["submission"]: row["code"] for row in table(key)}
    assert IDENTITIES.search(everything_in(out)) is None
    assert not [path for path in out.rglob("*") if IDENTITIES.search(path.name)]
    assert scores(out) == {codes["Jane Doe"]: 5.0, codes["Bo Lee"]: 6.0, codes["zed_502"]: 6.0}
    assert f"<bdi>{codes['Eve Moss']}</bdi>" in (out / "index.html").read_text(encoding="utf-8")
    note = "there are 2 folders called ch90_small: one of them was used"
    page = out / "feedback" / f"{codes['Bo Lee']}.html"
    assert note in page.read_text(encoding="utf-8")
    assert {path.name for path in (tmp_path / "out-named").iterdir()} == {
        *("canvas.csv", "moodle.csv", "feedback-canvas.zip", "mail.csv")
    }
    assert stat.S_IMODE(key.stat().st_mode) == 0o600
    # Another class has a secret of its own, and so has this one without its key.
    assert len(set(codes.values())) == 5
    key.rename(tmp_path / "elsewhere")
    grade(submissions, tmp_path / "again", root, roster=roster, anonymous=True)
    new = {row["code"] for row in table(key)}
    assert new & set(codes.values()) == {"(secret)"}


def test_codes_need_no_roster_but_a_folder_without_names(root: Path, tmp_path: Path) -> None:
    hand_in(tmp_path / "class", "jane", RIGHT)
    grade(tmp_path / "class", tmp_path / "named", root)
    with pytest.raises(ValueError, match=r"another --out: .* with names, such as results/jane"):
        grade(tmp_path / "class", tmp_path / "named", root, anonymous=True)
    assert not (tmp_path / "named-key.csv").exists()
    key = tmp_path / "out-key.csv"
    grade(tmp_path / "class", tmp_path / "out", root, anonymous=True)
    assert [row["submission"] for row in table(key)][1:] == ["jane"]
    key.write_text("code,id\nabc,1\n", encoding="utf-8")
    with pytest.raises(ValueError, match=r"out-key\.csv, line 2: the secret is missing"):
        grade(tmp_path / "class", tmp_path / "out", root, anonymous=True)


def test_a_mark_under_two_names_of_a_student_is_refused(
    root: Path, roster: Path, submissions: Path, tmp_path: Path
) -> None:
    with (submissions / "marks.csv").open("a", encoding="utf-8") as marks:
        marks.write("Jane Doe,90.2,2,\n")
    with pytest.raises(ValueError, match=r"line 4: a second mark for 'Jane Doe' in 90\.2, as"):
        grade(submissions, tmp_path / "out", root, roster=roster)


def test_the_command_takes_a_zip_and_reports_a_mistake_in_the_roster(
    roster: Path, tmp_path: Path
) -> None:
    (tmp_path / "lab.zip").write_bytes(zip_of({"doejane_77_3_work.zip": zip_of({SMALL: b""})}))
    roster.write_text(ROSTER + "77,Ann,,\n", encoding="utf-8")
    options = ("--roster", roster, "--out", tmp_path / "out", "--title", "Lab 1 (12)")
    done = typed("autograder", "grade", tmp_path / "lab.zip", *options)
    assert done.returncode == 2
    assert done.stdout.startswith(f"lab.zip is unpacked in {tmp_path / 'lab'}: 1 entries")
    where = f"grade: {roster}, line 5: the id '77' is already in line 2."
    assert done.stderr.startswith(where)
    assert not (tmp_path / "out").exists()


def test_a_submission_with_nearly_the_name_of_an_absent_student_is_pointed_out(
    root: Path, roster: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("evemos", "someone", "77"):
        hand_in(tmp_path / "class", name, RIGHT)
    assert grade(tmp_path / "class", tmp_path / "out", root, roster=roster) == 0
    printed = capsys.readouterr().out
    assert "If evemos is Eve Moss, rename the submission to 99." in printed
    assert printed.count("rename the submission") == 1
    assert grade(tmp_path / "class", tmp_path / "coded", root, roster=roster, anonymous=True) == 0
    assert "rename the submission" not in capsys.readouterr().out


def test_the_lines_on_the_screen_fit_a_terminal(
    root: Path, roster: Path, submissions: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert grade(submissions, tmp_path / "out", root, roster=roster) == 0
    printed = [line for line in capsys.readouterr().out.splitlines() if str(tmp_path) not in line]
    assert max(map(len, printed)) <= 80
    assert "not marked yet" in " ".join(printed)
