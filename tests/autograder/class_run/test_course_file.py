"""The course file: what it says, and what is wrong in it."""

from __future__ import annotations

import re
from datetime import UTC, datetime
from fractions import Fraction
from pathlib import Path

import pytest

from autograder.course.points import rescaled
from autograder.course.reading import read_course
from autograder.course.tables import AssignmentTable, CourseTable, LateTable
from autograder.manifest import ROOT, load_chapters
from typed import typed

CHAPTERS = {chapter.number: chapter for chapter in load_chapters()}
LAB = '[[assignment]]\nname = "lab1"\n'


def example() -> str:
    page = (ROOT / "autograder/README.md").read_text(encoding="utf-8")
    (text,) = re.findall(r"(?ms)^```toml\n(.+?)^```", page)
    return str(text)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "roster.csv").write_text("student\nann\n", encoding="utf-8")
    (tmp_path / "hidden/ch03_laws_of_motion").mkdir(parents=True)
    return tmp_path


def write(folder: Path, text: str) -> Path:
    path = folder / "course.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_the_example_of_the_readme_is_a_course(folder: Path) -> None:
    course = read_course(write(folder, example()))
    one, two = course.assignments
    assert one.roster == two.roster == folder / "roster.csv"
    own = {e.id: e for chapter in one.chapters for e in chapter.exercises}
    assert list(own) == ["B2.1", "B2.2", "B2.3", "B2.4", "B2.5", "B2.8", "B2.9", "2.2b", "2.5"]
    assert [name for name, e in own.items() if e.extra] == ["2.5"]
    # By hand: 2 + 3 + 3 + 5 + 3 + 2 + 4 + 1 = 23 points become 100.
    assert own["B2.1"].points == pytest.approx(2 * 100 / 23, abs=0.01)
    assert own["B2.4"].points == pytest.approx(5 * 100 / 23, abs=0.01)
    assert own["2.5"].points == pytest.approx(4 * 100 / 23, abs=0.01)
    assert round(sum(e.points for e in own.values() if not e.extra), 6) == 100
    assert one.seed == "lab1"
    assert one.deadline is not None
    assert one.deadline.due.astimezone(UTC) == datetime(2026, 10, 23, 21, 59, tzinfo=UTC)
    ann = one.deadline.extensions["ann"]  # after the clocks went back, on October 25
    assert ann.astimezone(UTC) == datetime(2026, 10, 26, 22, 59, tzinfo=UTC)
    assert two.chapters == [CHAPTERS[3]], "unchanged"
    assert two.given == [CHAPTERS[2]]
    assert two.hidden == folder / "hidden"
    assert two.seed is None
    assert two.deadline is not None
    assert two.deadline.due.astimezone(UTC) == datetime(2026, 11, 6, 22, 59, tzinfo=UTC)
    policies = [work.deadline.policy for work in course.assignments if work.deadline]
    assert [(p.per_day, p.unit, p.cap) for p in policies if p] == [
        (10, "percent", 50),
        (2, "points", 10),
    ]


def test_the_example_has_every_key() -> None:
    """A key that only the code knows would be a key that nobody uses."""
    for table in (CourseTable, AssignmentTable, LateTable):
        for key in table.__struct_fields__:
            assert re.search(rf"(?m)(^|\W){key}(\W|$)", example()), key


DUE = f"{LAB}chapters = [2]\ndue = 2026-10-23T23:59:00Z\n"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        # keys and types
        ("name = ", r"is not valid TOML: .*\(at .*\)"),
        (f"{LAB}roster = 'x'", r"assignment\[0\]: Object contains unknown field roster"),
        (f"[late]\npercent_a_day = 2\n{LAB}", "late: Object contains unknown field percent_a_day"),
        ("", "missing required field assignment"),
        ('[[assignment]]\nname = "a b"', r"assignment\[0\].name: Expected str matching"),
        (f"{LAB}chapters = [2]\n{LAB}chapters = [3]", "name: two assignments are called lab1"),
        (f'{LAB}exercises = ["B2.1", 2.1]', "exercises.*: Expected str, got float"),
        (f"{LAB}out_of = 0", "out_of: Expected int >= 1"),
        # exercises
        (LAB, "exercises: there are none"),
        (f'{LAB}exercises = ["B2.14"]', "exercises: there is no exercise 'B2.14'"),
        (f"{LAB}chapters = [12]", "there is no chapter 12. The chapters are 2, 3, 4"),
        (f"{LAB}chapters = [2]\ngiven = [2]", "chapter 2 is complete, so B2.1 cannot"),
        (f'{LAB}exercises = ["2.1"]', "2.1 needs B2.2, B2.4, which is in no assignment so far"),
        (f"{LAB}chapters = [3]", "chapter 3 builds on chapter 2, which is neither given nor"),
        # points
        (f"{LAB}chapters = [2]\ntotal = 47", "total: the points add up to 54, not to 47"),
        (f"{LAB}chapters = [2]\ntotal = 9\nout_of = 9", "but out_of changes them. Keep only one"),
        (f'{LAB}chapters = [2]\npoints = {{"B3.1" = 1}}', "points: 'B3.1' is not an exercise of"),
        # dates
        (f"{LAB}chapters = [2]\ndue = 2026-10-23 23:59:00", "due .* has no time zone"),
        (f"{LAB}due = 2026-10-23", "due: Expected datetime | null, got date"),
        (f"{LAB}chapters = [2]\ndue = 0001-01-01T00:00:00Z", "due must be from 1970 to 2999, got"),
        (f'time_zone = "Europe/Berln"\n{LAB}chapters = [2]', "there is none called 'Europe/Berln'"),
        # lateness
        (f"{LAB}chapters = [2]\nlate = {{points_per_day = 1}}", "late has no effect without due"),
        (f"late = {{cap = 1}}\n{LAB}chapters = [2]", "late must have points_per_day or percent"),
        (f"{DUE}late = {{points_per_day = 2, cap = 1}}", "lab1, late: cap must be at least 2"),
        (f"{DUE}late = {{percent_per_day = 200}}", "percent_per_day and cap must be at most 100"),
        (f"{DUE}extensions = {{bob = 2026-10-23T23:58:00Z}}", "that of bob ends before the assig"),
        # files
        (f'roster = "nobody.csv"\n{LAB}chapters = [2]', "roster: 'nobody.csv' is not there"),
        (f'{LAB}chapters = [2]\nhidden_checks = "hidden"', "contain a folder ch02_vectors"),
    ],
)
def test_a_mistake_is_one_line_with_its_key_and_what_is_wanted(
    folder: Path, text: str, words: str
) -> None:
    with pytest.raises(ValueError, match=words) as error:
        read_course(write(folder, text))
    assert str(error.value).startswith(str(folder / "course.toml"))
    assert "\n" not in str(error.value)


def test_an_assignment_builds_on_the_first_ones_that_have_what_it_needs(folder: Path) -> None:
    with pytest.raises(ValueError, match=r"there is no file '.*course\.toml'"):
        read_course(folder / "course.toml")
    text = f'{LAB}exercises = ["B2.1", "B2.2"]\n[[assignment]]\nname = "b"\n'
    text += 'exercises = ["B2.2", "B2.4"]\n[[assignment]]\nname = "c"\n'
    first, *_, last = read_course(write(folder, f'{text}exercises = ["2.1"]')).assignments
    assert first.earlier == {}
    assert last.earlier == {"B2.1": "lab1", "B2.2": "lab1", "B2.4": "b"}, "directly or indirectly"


@pytest.mark.parametrize("values", [[1, 1, 1], [2, 3, 3, 5, 3, 2, 4, 1], [0.1, 7, 12.5]])
def test_rescaled_points_keep_their_proportions_and_add_up(values: list[float]) -> None:
    points = {str(i): value for i, value in enumerate(values)}
    for out_of, unit in ((100, "0.01"), (10, "0.01"), (20, "1")):
        new = rescaled(points, out_of, unit)
        assert sum(Fraction(str(value)) for value in new.values()) == out_of
        for name, value in new.items():
            assert abs(value - points[name] * out_of / sum(values)) < float(unit)


def test_commands_stop_at_a_mistake_in_another_assignment_too(folder: Path) -> None:
    """The due date of lab2 cannot be read, and it could be later than that of lab1."""
    text = f'{LAB}chapters = [2]\n[[assignment]]\nname = "lab2"\nexercises = ["B2.1"]\n'
    course = ["--assignment", "lab1", "--course", write(folder, f'{text}due = "tomorrow"')]
    for command in ("handout", "release"):
        done = typed("autograder", command, *course, "--out", folder / "out")
        assert done.returncode == 2
        assert done.stderr == (
            f"{command}: {folder / 'course.toml'}: assignment[1].due: Expected datetime | null, "
            "got str\n"
        )
        assert not (folder / "out").exists()
