"""Students who hand in together have one report, and each of them has its grade everywhere."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

import pytest

from autograder.course.model import Deadline, LatePolicy
from autograder.platforms.uploads import Column
from small import RIGHT, hand_in
from small_class import HALF, SmallClass

ROSTER = """id,name,email,login,group
1,Ann Lee,ann@x.org,al,team 1
2,Bo Ek,bo@x.org,be,team 1
3,Cy Oz,cy@x.org,co,team 2
4,Di Ahn,di@x.org,da,team 2
5,Eve Moss,eve@x.org,em,
6,Fay Ng,fay@x.org,fn,team 3
"""
DUE = datetime(2026, 10, 23, tzinfo=UTC)


@pytest.fixture
def roster(tmp_path: Path) -> Path:
    (tmp_path / "roster.csv").write_text(ROSTER, encoding="utf-8")
    return tmp_path / "roster.csv"


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    hand_in(tmp_path / "class", "Bo Ek", RIGHT)  # for Ann as well
    hand_in(tmp_path / "class", "Team 2", HALF)
    hand_in(tmp_path / "class", "eve@x.org", RIGHT)
    times = "student,submitted\nann@x.org,2026-10-24T12:00Z\nteam 2,2026-10-24T12:00Z\n"
    (tmp_path / "class/times.csv").write_text(times, encoding="utf-8")
    return tmp_path / "class"


def test_each_member_has_the_grade_of_the_group(small: SmallClass, roster: Path) -> None:
    extended = {"Di Ahn": DUE.replace(day=26)}  # who is in team 2
    deadline = Deadline(DUE, LatePolicy(1, "points"), extended)
    options = {"roster": roster, "deadline": deadline, "column": Column("Lab 1", 6)}
    assert small.grade(**options) == 0
    groups = ["Eve Moss", "team 1 (Ann Lee, Bo Ek)", "team 2 (Cy Oz, Di Ahn)"]
    assert sorted(small.results()) == groups
    assert len([*(small.out / "feedback").iterdir()]) == 3
    wanted = {"1": 4.0, "2": 4.0, "3": 5.0, "4": 5.0, "5": 6.0, "6": None}  # team 1 is late
    canvas = {row["SIS User ID"]: row["Lab 1"] for row in small.table("canvas.csv")[1:]}
    assert {i: float(g) if g else None for i, g in canvas.items()} == wanted
    moodle = {row["ID number"]: row["Lab 1"] for row in small.table("moodle.csv")}
    assert {i: None if g == "-" else float(g) for i, g in moodle.items()} == wanted
    book = {row["student"]: (row["status"], row["total"]) for row in small.table("gradebook.csv")}
    assert book.pop("points possible")
    assert book == {
        "Ann Lee": ("graded", "4"),
        "Bo Ek": ("graded", "4"),
        "Cy Oz": ("graded", "5"),
        "Di Ahn": ("graded", "5"),
        "Eve Moss": ("graded", "6"),
        "Fay Ng": ("nothing handed in", ""),
    }
    page = small.text("feedback/team 1 (Ann Lee, Bo Ek).html")
    assert "Feedback for <bdi>team 1 (Ann Lee, Bo Ek)</bdi>" in page
    mail = {row["name"]: Path(row["file"]).stem for row in small.table("mail.csv")}
    assert mail == {
        **dict.fromkeys(["Ann Lee", "Bo Ek"], groups[1]),
        **dict.fromkeys(["Cy Oz", "Di Ahn"], groups[2]),
        "Eve Moss": "Eve Moss",
    }
    small.printed()
    assert small.grade(student="Ann Lee", why="asked", seed=None, **options) == 0
    assert "1/1 team 1 (Ann Lee, Bo Ek)" in small.printed()
    assert len(small.table("gradebook.csv")) == 7
