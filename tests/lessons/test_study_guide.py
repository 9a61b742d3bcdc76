"""The study guide names checks that exist, and its plans agree with their course files."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from autograder.course.reading import read_course
from autograder.manifest import ROOT, load_chapters
from lessons.doable import lost

GUIDE = (ROOT / "docs/study_guide.md").read_text(encoding="utf-8")
CHAPTERS = {chapter.number: chapter for chapter in load_chapters()}
EXERCISES = [exercise.id for chapter in CHAPTERS.values() for exercise in chapter.exercises]
PLANS = {
    path.stem: read_course(path).assignments
    for path in sorted((ROOT / "docs/plans").glob("*.toml"))
}
WEEKS = [(name, week) for name, works in PLANS.items() for week in range(1, len(works) + 1)]


def test_every_misconception_names_a_check_of_its_chapter() -> None:
    rows = re.findall(r"(?m)^\| (\d) \| .+ \| `(test_\w+)` \|$", GUIDE)
    assert {int(number) for number, _ in rows} == set(CHAPTERS)
    for number, check in rows:
        folder = ROOT / "tests" / CHAPTERS[int(number)].name
        texts = [file.read_text(encoding="utf-8") for file in folder.glob("test_*.py")]
        assert any(f"def {check}(" in text for text in texts), check


def exercises_of(cell: str) -> set[str]:
    """Return the exercises that a cell of a plan names, such as "B2.1 to B2.4, and 2.5"."""
    found = set(re.findall(r"\b[BGP]?\d\.\d+[a-d]?\b", cell))
    for kind, first, last in re.findall(r"\b([BGP]?\d)\.(\d+) to \1\.(\d+)\b", cell):
        numbers = range(int(first), int(last) + 1)
        found |= {
            e for e in EXERCISES if re.sub(r"[a-d]$", "", e) in {f"{kind}.{n}" for n in numbers}
        }
    return found


@pytest.mark.parametrize("name", PLANS)
def test_the_tables_of_the_plans_agree_with_their_course_files(name: str) -> None:
    title = name.replace("_", " ").capitalize()
    section = GUIDE.partition(f"## {title}")[2].partition("\n## ")[0]
    assert f"](plans/{name}.toml)" in section
    rows = [re.split(r" *\| ?", line)[1:-1] for line in re.findall(r"(?m)^\| +\d.*", section)]
    assert [f"week{number}" for number, *_ in rows] == [work.name for work in PLANS[name]]
    for (_, chapters, cell, *given, _), work in zip(rows, PLANS[name], strict=True):
        ids = [exercise.id for chapter in work.chapters for exercise in chapter.exercises]
        if cell == "all":
            assert work.chapters == [CHAPTERS[int(chapters)]]
        else:
            assert exercises_of(cell) == {*ids}, work.name
        numbers = [chapter.number for chapter in work.chapters]
        assert [int(number) for number in re.findall(r"\d", chapters)] == numbers
        assert re.findall(r"\d", "".join(given)) == [str(c.number) for c in work.given]
    assert sum(int(row[-1]) for row in rows) <= {"twelve_weeks": 12 * 6, "four_weeks": 4 * 8}[name]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "week"), WEEKS)
def test_a_week_can_be_done_with_what_the_weeks_before_it_assign(
    name: str, week: int, tmp_path: Path
) -> None:
    assigned = [
        [e.id for chapter in work.chapters for e in chapter.exercises]
        for work in PLANS[name][:week]
    ]
    given = [chapter.number for chapter in PLANS[name][week - 1].given]
    assert lost(tmp_path, [name for ids in assigned for name in ids], assigned[-1], given) == {}


def test_the_rubric_adds_up() -> None:
    rubric = GUIDE.partition("| criterion |")[2]
    assert sum(map(int, re.findall(r"(?m)^\| \w+ \| (\d+) \|", rubric))) == 20
