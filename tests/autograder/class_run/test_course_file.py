"""The file of a term: what it says, and what is wrong in it, line by line."""

from __future__ import annotations

import re
from datetime import UTC, datetime
from fractions import Fraction
from pathlib import Path

import pytest

from autograder.course.points import rescaled
from autograder.course.reading import read_assignment, read_course
from autograder.manifest import ROOT, load_chapters
from typed import typed

CHAPTERS = {chapter.number: chapter for chapter in load_chapters()}
LAB = '[[assignment]]\nname = "lab1"\n'  # two lines, so that what is added begins on line 3


def example() -> str:
    """Return the file that the README shows."""
    page = (ROOT / "autograder/README.md").read_text(encoding="utf-8")
    (text,) = re.findall(r"(?ms)^```toml\n(.+?)^```", page)
    return str(text)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with what the example names."""
    (tmp_path / "roster.csv").write_text("student\nann\n", encoding="utf-8")
    (tmp_path / "hidden/ch03_laws_of_motion").mkdir(parents=True)
    return tmp_path


def write(folder: Path, text: str) -> Path:
    path = folder / "course.toml"
    path.write_text(text, encoding="utf-8")
    return path


def mistakes(folder: Path, text: str) -> list[tuple[int, str]]:
    """Return the line and the words of each mistake."""
    with pytest.raises(ValueError, match="mistake") as error:
        read_course(write(folder, text))
    first, *lines = str(error.value).splitlines()
    count = "one mistake" if len(lines) == 1 else f"{len(lines)} mistakes"
    assert first == f"{folder / 'course.toml'} has {count}:"
    found = [re.fullmatch(r"  line (\d+): (.+)", line) for line in lines]
    return [(int(match[1]), match[2]) for match in found if match]


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
    from autograder.course import reading

    for key in (*reading.OF_COURSE, *reading.OF_ASSIGNMENT, *reading.OF_LATE):
        assert re.search(rf"(?m)(^|\W){key}(\W|$)", example()), key


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        (f'tite = "x"\n{LAB}chapters = [2]', 1, "there is no key 'tite'. Did you mean title?"),
        (f"{LAB}exercise = []\nchapters = [2]", 3, "'exercise'. Did you mean exercises?"),
        (f"{LAB}chapters = [2]\ncolor = 1", 4, "no key 'color'. The keys here are name, title"),
        ("", 1, "there is no assignment. Each one begins with [[assignment]]"),
        (LAB, 1, "the assignment has no exercises"),
        ("[[assignment]]\nchapters = [2]", 1, "the assignment has no name"),
        ('[[assignment]]\nname = "lab 1"\nchapters = [2]', 2, 'digits, - and _, got "lab 1"'),
        (f"{LAB}chapters = [2]\n{LAB}chapters = [3]", 5, "another assignment is called lab1 too"),
        # exercises
        (
            f'{LAB}exercises = ["B2.1",\n  "B2.14"]',
            4,
            "no exercise 'B2.14'. Did you mean B2.4",
        ),
        (f'{LAB}exercises = ["B2.4a"]', 3, "there is no exercise 'B2.4a'. Did you mean B2.4"),
        (f'{LAB}exercises = ["B2.1", "2.2"]', 3, "Did you mean 2.2a or 2.2b or B2.2?"),
        (f'{LAB}exercises = ["b2.1"]', 3, "there is no exercise 'b2.1'. Did you mean B2.1"),
        (f'{LAB}exercises = ["B2.1",\n"B2.1"]', 3, "B2.1 is listed twice"),
        (f'{LAB}exercises = ["B2.1", 2.1]', 3, "exercises must be a list of strings, got 2.1"),
        (f'{LAB}exercises = "B2.1"', 3, 'exercises must be a list, got "B2.1"'),
        (f'{LAB}chapters = [2]\nexercises = ["2.4"]', 4, "2.4 belongs to chapter 2, which is l"),
        (f'{LAB}exercises = ["2.4"]\nextra_credit = ["2.4"]', 4, "2.4 is also listed in exercises"),
        (f'{LAB}extra_credit = ["2.4"]', 1, "the assignment has no exercises"),
        (f"{LAB}chapters = [12]", 3, "there is no chapter 12. The chapters are 2, 3, 4"),
        (f"{LAB}chapters = [2]\ngiven = [2]", 4, "chapter 2 is given complete, so B2.1 cannot"),
        (f'{LAB}exercises = ["2.1"]', 3, "2.1 needs B2.2, B2.4, which is not in any assignment"),
        (f"{LAB}chapters = [3]", 1, "chapter 3 builds on chapter 2, which is neither given nor"),
        # points
        (f"{LAB}chapters = [2]\ntotal = 47", 4, "the points add up to 54, not to 47"),
        (f"{LAB}chapters = [2]\ntotal = 9\nout_of = 9", 4, "but out_of changes it. Keep only one"),
        (f"{LAB}chapters = [2]\nout_of = 0", 4, "out_of must be a positive number, got 0"),
        (f'{LAB}chapters = [2]\npoints = {{"B3.1" = 1}}', 4, "lists 'B3.1', which is not an exer"),
        (f'{LAB}chapters = [2]\npoints = {{"2.4" = "a"}}', 4, "2.4 must be a positive number"),
        # dates
        (f"{LAB}chapters = [2]\ndue = 2026-10-23 23:59:00", 4, "due has no time zone. Add the"),
        (f"{LAB}chapters = [2]\ndue = 2026-10-23", 4, "due has no time of day. Write it like"),
        (f'{LAB}chapters = [2]\ndue = "Friday"', 4, 'without quotes, got "Friday"'),
        (f'time_zone = "Europe/Berln"\n{LAB}chapters = [2]', 1, "Did you mean Europe/Berlin"),
        (
            f'time_zone = "Europe/Berlin"\n{LAB}chapters = [2]\ndue = 2027-03-28 02:30:00',
            5,
            "due 2027-03-28 02:30:00 does not exist: the clocks in Europe/Berlin go forward",
        ),
        # lateness
        (
            f"{LAB}chapters = [2]\nlate = {{points_per_day = 1}}",
            4,
            "late has no effect without due",
        ),
        (f"late = {{cap = 1}}\n{LAB}chapters = [2]", 1, "late must have points_per_day or percent"),
        (
            f"[late]\npoints_per_day = 2\ncap = 1\n{LAB}chapters = [2]",
            3,
            "cap must be at least points",
        ),
        (f"[late]\npercent_per_day = 200\n{LAB}chapters = [2]", 2, "at most 100 percent, got 200"),
        (f"[late]\npercent_a_day = 2\n{LAB}chapters = [2]", 2, "Did you mean percent_per_day?"),
        (
            f"{LAB}chapters = [2]\ndue = 2026-10-23T23:59:00Z\n[assignment.extensions]\n"
            "ann = 2026-10-26T23:59:00Z\nbob = 2026-10-23T23:58:00Z",
            7,
            "the extension of bob ends before the assignment is due",
        ),
        # files
        (f'roster = "nobody.csv"\n{LAB}chapters = [2]', 1, "there is no file 'nobody.csv'"),
        (f'{LAB}chapters = [2]\nhidden_checks = "hidden2"', 4, "'hidden2'. Did you mean hidden?"),
        (f'{LAB}chapters = [2]\nhidden_checks = "hidden"', 4, "contain a folder ch02_vectors"),
        (f"{LAB}chapters = [2]\nseed = 1.5", 4, "seed must be a string or a whole number"),
    ],
)
def test_a_mistake_is_reported_with_its_line(
    folder: Path, text: str, line: int, words: str
) -> None:
    found = mistakes(folder, text)
    assert [one for one in found if one[0] == line and words in one[1]], found


def test_all_mistakes_are_reported_at_once_in_the_order_of_their_lines(folder: Path) -> None:
    text = example().replace("B2.9", "B2.99").replace('"lab2"', '"lab1"').replace("= 35", "= 36")
    text = text.replace("23 23:59:00", "23").replace("cap = 50", "capp = 50")
    words = [words for _, words in mistakes(folder, text)]
    assert [w.split(". ")[0] for w in words] == [
        "there is no key 'capp'",
        "there is no exercise 'B2.99'",
        "2.5 needs B2.9, which is not in any assignment so far",
        "due has no time of day",
        "another assignment is called lab1 too",
        "the points add up to 35, not to 36",
    ]
    lines = [line for line, _ in mistakes(folder, text)]
    marks = ("capp", "B2.99", '["2.5"]', "due = 2026-10-23", '"lab1"', "total =")
    found = [max(i for i, t in enumerate(text.splitlines(), 1) if mark in t) for mark in marks]
    assert lines == found


@pytest.mark.parametrize("text", ["name = ", '[[assignment]]\nname = "a"\nname = "b"\n'])
def test_what_is_not_toml_is_reported_with_its_line(folder: Path, text: str) -> None:
    with pytest.raises(ValueError, match=r"is not valid TOML: .*\(at .*\)"):
        read_course(write(folder, text))


def test_a_file_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"there is no file '.*course\.toml'"):
        read_course(tmp_path / "course.toml")


def test_an_assignment_builds_on_earlier_ones(folder: Path) -> None:
    text = f'{LAB}exercises = ["B2.1", "B2.2", "B2.4"]\n[[assignment]]\nname = "b"\n'
    one, two = read_course(write(folder, f'{text}exercises = ["2.1"]')).assignments
    assert one.earlier == {}
    assert two.earlier == dict.fromkeys(["B2.1", "B2.2", "B2.4"], "lab1"), "directly or indirectly"


def test_an_exercise_belongs_to_the_first_assignment_that_has_it(folder: Path) -> None:
    text = f'{LAB}exercises = ["B2.1", "B2.2"]\n[[assignment]]\nname = "b"\n'
    text += 'exercises = ["B2.2", "B2.4"]\n[[assignment]]\nname = "c"\n'
    *_, last = read_course(write(folder, f'{text}exercises = ["2.1"]')).assignments
    assert last.earlier == {"B2.1": "lab1", "B2.2": "lab1", "B2.4": "b"}


@pytest.mark.parametrize("values", [[1, 1, 1], [2, 3, 3, 5, 3, 2, 4, 1], [0.1, 7, 12.5]])
def test_rescaled_points_keep_their_proportions_and_add_up(values: list[float]) -> None:
    points = {str(i): value for i, value in enumerate(values)}
    for out_of, unit in ((100, "0.01"), (10, "0.01"), (20, "1")):
        new = rescaled(points, out_of, unit)
        assert sum(Fraction(str(value)) for value in new.values()) == out_of
        for name, value in new.items():
            assert abs(value - points[name] * out_of / sum(values)) < float(unit)


LABS = """title = "Physics"
[[assignment]]
name = "lab1"
exercises = ["B2.1", "B2.2", "B2.4"]
[[assignment]]
name = "lab2"
exercises = ["2.1"]
[[assignment]]
name = "lab3"
chapters = [3]
given = [2]
"""


@pytest.mark.parametrize(
    ("old", "new", "line", "works"),
    [
        ("chapters = [3]", "chapter = [3]", 10, "lab1 lab2"),
        ("given = [2]", "given = [2]\ntotal = 7", 12, "lab1 lab2"),
        ('["2.1"]', '["2.1"]\ndue = 2026-10-23', 8, "lab1 lab3"),
        ('"B2.4"]', '"B2.4"]\nseed = 1.5', 5, "lab3"),  # lab2 builds on exercises of lab1
        ('"lab3"', '"lab2"', 9, "lab1"),
        ("given = [2]", 'roster = "roster.csv"', 11, ""),  # it would be the roster of no assignment
        ("Physics", 'Physics"\ntimezone = "UTC', 2, ""),
    ],
)
def test_a_mistake_stops_only_the_assignments_for_which_it_matters(
    folder: Path, old: str, new: str, line: int, works: str
) -> None:
    text = LABS.replace(old, new)
    assert text != LABS
    found = mistakes(folder, text)
    assert line in [at for at, _ in found]
    for name in ("lab1", "lab2", "lab3"):
        if name in works.split():
            work, note = read_assignment(folder / "course.toml", name)
            assert work.name == name
            assert note.splitlines()[1:] == [f"  line {at}: {words}" for at, words in found]
            assert f"outside of {name}:" in note.splitlines()[0]
        else:
            with pytest.raises(ValueError, match=rf"(?s)mistakes?:.*line {line}: "):
                read_assignment(folder / "course.toml", name)


def test_an_assignment_that_builds_on_a_chapter_needs_its_assignment_too(folder: Path) -> None:
    text = LABS.replace("given = [2]", "").replace('"B2.4"]', '"B2.4"]\nseed = 1.5')
    with pytest.raises(ValueError, match="seed must be"):
        read_assignment(write(folder, text), "lab3")


def test_commands_list_a_mistake_elsewhere_but_a_release_waits_for_its_correction(
    folder: Path,
) -> None:
    """The due date of lab2 cannot be read, and it could be later than today."""
    text = LABS.replace('"lab2"', '"lab2"\ndue = "tomorrow"').replace('["2.1"]', '["B2.1"]')
    course = ["--assignment", "lab1", "--course", write(folder, text)]
    handout = typed("autograder", "handout", *course, "--out", folder / "handout")
    assert (folder / "handout/chapters/ch02_vectors").is_dir()
    mistake = f"{folder / 'course.toml'} has one mistake outside of lab1:\n  line 7: due must be"
    assert handout.stderr.startswith(mistake)
    assert handout.returncode == 0
    release = typed("autograder", "release", *course, "--out", folder / "released")
    assert release.returncode == 2
    assert "has one mistake:\n  line 7: due must be" in release.stderr
    assert not (folder / "released").exists()
