"""A class of 60 with the names that real classes have, from the roster to the import file.

The same students hand in the same work through Canvas, Moodle, Gradescope and GitHub Classroom.
"""

from __future__ import annotations

import csv
import json
from datetime import UTC, datetime
from pathlib import Path

import pytest

from autograder.course.model import Deadline, LatePolicy
from autograder.platforms.uploads import Column
from moodle_sheet import Sheet, download, upload
from small import RIGHT, make_root
from small_class import HALF, grade, results, table
from staging import zip_of

NAMES = [
    *("José Ñandú", "Ana María López", "Zoë Müller", "Łukasz Żak", "Åsa Öberg", "Đorđe Ilić"),
    *("Sean O'Neill", "Shaq O'Neal", "Doe, Jane", "Anna Schmidt", "Anna Schmidt", "Li Wei"),
    *("Wei Li", "王小明", "李小龙", "Jan van der Berg", "Jean-Luc Picard", "J. R. Ewing"),
    *("Ann Doe", "Ann Dow", "X Æ", "Ann-Marie Doe"),
]
NAMES += [f"Student Nr {i}" for i in range(len(NAMES), 60)]
CLASH = (9, 10, 11, 12)  # those whose names in Canvas are those of others
IDS = [f"00{42 + i}" if i % 3 == 0 and i not in CLASH else f"{7000 + i}" for i in range(60)]
EMAILS = [f"p{i}@example.org" for i in range(60)]
WORK = {"right": RIGHT, "half": HALF, "zero": "x = 1\n"}
# What each student hands in, by the position on the roster.
KINDS = [
    "right",
    "half",
    "right",
    "zero",
    "pdf",
    "nothing",
    "flat",
    "damaged",
    "right",
    "right",
] * 6
WORTH = {"right": 6.0, "half": 5.0, "zero": 0.0}  # of 6; "half" fails one check of two
NO_GRADE = ("pdf", "flat", "damaged", "nothing")
DUE = datetime(2026, 10, 23, tzinfo=UTC)


def roster_in(folder: Path) -> Path:
    rows = [[IDS[i], NAMES[i], EMAILS[i], f"login{i}"] for i in range(60)]
    with (folder / "roster.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([["id", "name", "email", "login"], *rows])
    return folder / "roster.csv"


def given_first(name: str) -> str:
    last, comma, first = name.partition(", ")
    return f"{first} {last}" if comma else name


def family_first(name: str) -> str:
    """Return what Canvas makes of a name: lower case, letters only, the family name first."""
    last, comma, first = name.partition(", ")
    given, _, family = name.partition(" ")
    text = last + first if comma else family + given
    return "".join(c for c in text.lower() if c.isalnum())


SHEET = Sheet(most=100)
IN_MOODLE = {3000 + i: (given_first(NAMES[i]), IDS[i], EMAILS[i]) for i in range(60)}


def files_of(kind: str) -> tuple[str, bytes]:
    """Return the name and the content of what a student uploads."""
    if kind == "pdf":
        return "report.pdf", b"%PDF"
    if kind == "damaged":
        return "work.zip", b"no zip"
    place = "" if kind == "flat" else "my work/ch90_small/"
    return "work.zip", zip_of({f"{place}small.py": WORK.get(kind, RIGHT).encode()})


def hand_in(folder: Path, platform: str) -> None:
    folder.mkdir()
    submitters, repositories = {}, [["student_repository_name", "roster_identifier"]]
    for i, kind in enumerate(KINDS):
        if kind == "nothing":
            continue
        file, content = files_of(kind)
        if platform == "canvas":  # whose ids are other ones, but for those whose names clash
            number = IDS[i] if i in CLASH else str(500_000 + i)
            (folder / f"{family_first(NAMES[i])}_{number}_{900 + i}_{file}").write_bytes(content)
            continue
        place = {
            "moodle": f"{given_first(NAMES[i])}_{3000 + i}_assignsubmission_file",
            "gradescope": f"submission_{i}",
            "github": f"lab1-octo{i}",
        }[platform]
        (folder / place).mkdir()
        (folder / place / file).write_bytes(content)
        submitters[place] = {":submitters": [{":name": NAMES[i], ":email": EMAILS[i].upper()}]}
        repositories.append([place, EMAILS[i] if i % 2 else IDS[i]])
    if platform == "moodle":
        (folder / "worksheet.csv").write_text(download(SHEET, IN_MOODLE), encoding="utf-8")
    if platform == "gradescope":  # JSON is YAML, too
        text = json.dumps(submitters, ensure_ascii=False)
        (folder / "submission_metadata.yml").write_text(text, encoding="utf-8")
    if platform == "github":
        with (folder / "grades.csv").open("w", encoding="utf-8", newline="") as table:
            csv.writer(table).writerows(repositories)


def write_tables(folder: Path) -> None:
    """Name the students as people and spreadsheets do."""
    names = list(NAMES)
    names[0], names[3], names[8] = "42", "ŁUKASZ żak", "Jane Doe"  # 00042, and "Doe, Jane"
    times = [
        [EMAILS[i] if NAMES.count(NAMES[i]) > 1 else names[i], "2026-10-22T12:00:00+00:00"]
        for i, kind in enumerate(KINDS)
        if kind != "nothing"
    ]
    for row in times:
        if row[0] in (names[0], names[9], EMAILS[9], names[10], EMAILS[10]):
            row[1] = "2026-10-23T12:00:00+00:00"
    with (folder / "times.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([["student", "submitted"], *times])


@pytest.mark.parametrize("platform", ["canvas", "moodle", "gradescope", "github"])
def test_every_student_gets_the_grade_of_the_own_work(
    platform: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    root, roster = make_root(tmp_path / "root"), roster_in(tmp_path)
    hand_in(tmp_path / "class", platform)
    write_tables(tmp_path / "class")
    deadline = Deadline(DUE, LatePolicy(1, "points"), {IDS[10]: DUE.replace(day=25)})
    options = {"deadline": deadline, "column": Column("Lab 1", 6)}
    assert grade(tmp_path / "class", tmp_path / "out", root, roster=roster, **options) == 0
    out = tmp_path / "out"

    wanted = {
        IDS[i]: None if kind in NO_GRADE else round(WORTH[kind] - (i in (0, 9)), 2)
        for i, kind in enumerate(KINDS)
    }
    canvas = {row["SIS User ID"]: row["Lab 1"] for row in table(out / "canvas.csv")[1:]}
    assert {i: float(grade) if grade else None for i, grade in canvas.items()} == wanted
    moodle = {row["ID number"]: row["Lab 1"] for row in table(out / "moodle.csv")}
    assert {i: None if grade == "-" else float(grade) for i, grade in moodle.items()} == wanted
    if platform == "moodle":
        grades, _ = upload((out / "moodle-worksheet.csv").read_bytes(), SHEET, IN_MOODLE)
        by_id = {IDS[number - 3000]: value for number, value in grades.items()}
        assert by_id == {i: value for i, value in wanted.items() if value is not None}

    book = table(out / "gradebook.csv")[1:]
    states = [row["status"].partition(":")[0] for row in book]
    counts = {kind: KINDS.count(kind) for kind in {*KINDS}}
    assert len(book) == 60
    assert states.count("nothing handed in") == counts["nothing"]
    nothing = counts["pdf"] + counts["flat"] + counts["damaged"]
    assert states.count("handed in, nothing to grade") == nothing
    assert states.count("graded") == 60 - nothing - counts["nothing"]
    why = [report["nothing"] for report in results(out).values() if "nothing" in report]
    assert len(why) == nothing
    assert sum("report.pdf" in text for text in why) == counts["pdf"]
    assert sum("small.py was found" in text for text in why) == counts["flat"]

    printed = " ".join(capsys.readouterr().out.split())
    assert f"Nothing handed in: {counts['nothing']} (" in printed
    assert f"Handed in, nothing to grade: {nothing}. " in printed
    assert "Not on the roster" not in printed
    assert "Late: 2. With a penalty: 2." in printed
    assert "unknown" not in printed
