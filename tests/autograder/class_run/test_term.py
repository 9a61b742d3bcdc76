"""An instructor's term with a class of 40: from a class list to a file that Canvas imports."""

from __future__ import annotations

import io
import random
import zipfile
from pathlib import Path

import pytest

from autograder.isolation.probe import best_level
from autograder.manifest import load_chapters
from copies import reference
from small_class import table
from typed import typed
from wrong import read_wrong, write_all, write_wrong

CH02 = load_chapters()[0]
FILE = f"{CH02.name}/vector.py"
RIGHT = reference(CH02.name)[FILE]
MISTAKE = "Returns the vector itself instead of a copy."
TITLE, TOTAL = "Lab 1 (4711)", 10.0
COURSE = f"""
time_zone = "UTC"
roster = "roster.csv"

[[assignment]]
name = "lab1"
title = "{TITLE}"
exercises = ["B2.1", "B2.2", "B2.5"]
points = {{ "B2.5" = 5 }}  # the chapter gives 3
total = {TOTAL:g}
due = 2026-10-23 23:59:00
late = {{ points_per_day = 1, cap = 2 }}
seed = "7"
"""
# How many students hand in what, and what it is worth: without a file there is no grade at all.
KINDS = {"right": 20, "late": 3, "partial": 6, "wrong": 2, "misnamed": 2}
KINDS |= {"hostile": 1, "empty": 3, "missing": 3}
GRADED = sum(KINDS.values()) - KINDS["missing"] + 1  # and one who is not on the roster
# A student's total is the sum of the exercises, less the penalty: 2 points for two days.
WORTH = {"right": 10.0, "late": 8.0, "partial": 5.0}


def hand_in(kind: str, folder: Path) -> dict[str, str]:
    """Return the files that a student of a kind hands in, made in a folder."""
    if kind == "partial":  # without B2.5, which is worth 5 points
        write_all(CH02, "raise NotImplementedError", folder, but=["B2.1", "B2.2"])
    if kind == "wrong":
        write_wrong(CH02, [w for w in read_wrong(CH02) if w.mistake == MISTAKE], folder)
    if (folder / FILE).exists():
        return {FILE: (folder / FILE).read_text(encoding="utf-8")}
    return {
        "misnamed": {f"{CH02.name}/my_vectors.py": RIGHT},
        "hostile": {FILE: f"{RIGHT}\nimport os\n\nos._exit(0)\n"},
        "empty": {"notes.txt": "nothing"},
    }.get(kind, {FILE: RIGHT})


@pytest.fixture(scope="module")
def kinds() -> dict[str, str]:
    """Return what each student hands in, by id."""
    drawn = [kind for kind, count in KINDS.items() for _ in range(count)]
    random.Random(40).shuffle(drawn)
    return {str(1001 + i): kind for i, kind in enumerate(drawn)}


@pytest.fixture(scope="module")
def folder(kinds: dict[str, str], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the class list, the course file and the zip downloaded from Canvas."""
    folder = tmp_path_factory.mktemp("term")
    people = [f"{i},Student {i},s{i}@example.org,login{i}" for i in kinds]
    roster = "\n".join(["id,name,email,login", *people, ""])
    (folder / "roster.csv").write_text(roster, encoding="utf-8")
    (folder / "course.toml").write_text(COURSE, encoding="utf-8")
    texts = {kind: hand_in(kind, folder / kind) for kind in KINDS}
    handed = {i: kind for i, kind in kinds.items() if kind != "missing"} | {"99": "right"}
    with zipfile.ZipFile(folder / "lab1.zip", "w") as all_of_them:
        for i, kind in handed.items():
            inner = io.BytesIO()
            with zipfile.ZipFile(inner, "w") as archive:
                for path, text in texts[kind].items():
                    archive.writestr(path, text)
            late = "_LATE" if kind == "late" else ""
            all_of_them.writestr(f"student{i}{late}_{i}_7{i}_work.zip", inner.getvalue())
    return folder


def grade(folder: Path, *more: str) -> str:
    """Grade the class, and return what the command prints, as one line."""
    if not best_level().is_sandbox:
        more = (*more, "--unsafe-no-sandbox")
    command = ["autograder", "grade", folder / "lab1.zip", "--out", folder / "grades"]
    done = typed(*command, "--assignment", "lab1", "--course", folder / "course.toml", *more)
    assert done.returncode == 0, done.stdout + done.stderr
    return " ".join(done.stdout.split())


@pytest.fixture(scope="module")
def printed(folder: Path, kinds: dict[str, str]) -> list[str]:
    """Grade the class, grade it with the times of submissions, and grade one student again.

    With the two files of the fixture above, these are all commands from a class list to an import.
    """
    said = [grade(folder)]
    days = {i: "25 23:00" if kind == "late" else "23 12:00" for i, kind in kinds.items()}
    times = [f"{i},2026-10-{day}" for i, day in days.items() if kinds[i] != "missing"]
    text = "\n".join(["student,submitted", *times, ""])
    (folder / "lab1" / "times.csv").write_text(text, encoding="utf-8")
    said.append(grade(folder))
    student = next(i for i, kind in kinds.items() if kind == "partial")
    return [*said, grade(folder, "--student", student, "--note", "asked for it")]


def test_everybody_is_accounted_for(printed: list[str], kinds: dict[str, str]) -> None:
    first, second, again = printed
    assert f"{GRADED} of {GRADED} reports" in second, "the times change penalties only"
    assert "5 points before, 5 now. Changed: no exercise. Logged in" in again
    missing = "; ".join(f"Student {i}" for i, kind in kinds.items() if kind == "missing")
    for said in printed:
        assert f"Nothing handed in: 3 ({missing})." in said
        assert "Not on the roster: 1 (student99_99)." in said
    assert "Late by an unknown amount of time, and therefore without a penalty: 3 (Student" in first
    assert "3 students were late, and 3 of them get a penalty." in second


@pytest.mark.usefixtures("printed")
def test_the_totals_are_the_sums_of_the_exercises(folder: Path, kinds: dict[str, str]) -> None:
    rows = {row["student"]: row for row in table(folder / "grades/gradebook.csv")}
    for i, kind in kinds.items():
        row = rows[f"Student {i}"]
        if kind in ("missing", "empty"):
            assert row["total"] == ""
            continue
        exercises = sum(float(row[name]) for name in ("B2.1", "B2.2", "B2.5"))
        total = exercises - 2.0 * (kind == "late")
        assert float(row["total"]) == pytest.approx(total), kind
        assert float(row["total"]) == pytest.approx(WORTH.get(kind, total)), kind
        if kind in ("misnamed", "hostile"):
            assert float(row["total"]) == 0.0
        if kind == "wrong":
            assert 8.0 <= float(row["total"]) < 10.0


@pytest.mark.usefixtures("printed")
def test_canvas_gets_a_cell_for_each_student(folder: Path, kinds: dict[str, str]) -> None:
    totals = {row["student"]: row["total"] for row in table(folder / "grades/gradebook.csv")}
    possible, *rows = table(folder / "grades/canvas.csv")
    assert float(possible[TITLE]) == TOTAL
    assert {row["ID"]: row[TITLE] for row in rows} == {i: totals[f"Student {i}"] for i in kinds}
