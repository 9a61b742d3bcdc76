"""The study guide names exercises and checks that exist."""

from __future__ import annotations

import re

from autograder.manifest import ROOT, load_chapters

GUIDE = (ROOT / "study_guide.md").read_text(encoding="utf-8")
CHAPTERS = {chapter.number: chapter for chapter in load_chapters()}
EXERCISES = [exercise.id for chapter in CHAPTERS.values() for exercise in chapter.exercises]


def test_every_misconception_names_a_check_of_its_chapter() -> None:
    rows = re.findall(r"(?m)^\| (\d) \| .+ \| `(test_\w+)` \|$", GUIDE)
    assert {int(number) for number, _ in rows} == set(CHAPTERS)
    for number, check in rows:
        folder = ROOT / "tests" / CHAPTERS[int(number)].name
        texts = [file.read_text(encoding="utf-8") for file in folder.glob("test_*.py")]
        assert any(f"def {check}(" in text for text in texts), check


def test_the_plans_name_exercises() -> None:
    plans = GUIDE.partition("## Twelve weeks")[2].partition("## Common")[0]
    rows = re.findall(r"(?m)^\| +(\d+) \| (.+?) \| (.+?) \| +(\d+) \|$", plans)
    assert [int(week) for week, *_ in rows] == [*range(1, 13), *range(1, 5)]
    named = re.findall(r"\b[BGP]?\d\.\d+[a-d]?\b", plans)
    assert len(named) > 70
    assert [name for name in named if name not in EXERCISES] == []
    assert sum(int(hours) for *_, hours in rows[:12]) <= 12 * 6


def test_the_rubric_adds_up() -> None:
    rubric = GUIDE.partition("| criterion |")[2]
    assert sum(map(int, re.findall(r"(?m)^\| \w+ \| (\d+) \|", rubric))) == 20
