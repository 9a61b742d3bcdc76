"""The learning path lists every exercise once, and its spine is short and complete."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from autograder.manifest import ROOT, Chapter, load_chapters
from lessons.doable import lost
from lessons.lesson import lesson_of, minutes_of

CHAPTERS = load_chapters()
EXERCISES = {exercise.id: exercise for chapter in CHAPTERS for exercise in chapter.exercises}
PAGE = (ROOT / "docs/learning_path.md").read_text(encoding="utf-8")
SHORT, WHOLE = PAGE.split("## The whole course")
MINUTES = {
    number: time for chapter in CHAPTERS for number, time in minutes_of(lesson_of(chapter.name))
}


def ids(cell: str) -> list[str]:
    return cell.replace(",", " ").split()


def rows(table: str) -> list[list[str]]:
    """Return the cells of the rows that begin with a link to a chapter, without that link."""
    lines = re.findall(r"(?m)^\| \[\d\]\(.+?\) \| (.+) \|$", table)
    return [[cell.strip() for cell in line.split("|")] for line in lines]


SPINE = [number for row in rows(WHOLE) for number in ids(row[0])]
SPINE_OF = {
    int(number): ids(cell)
    for number, cell in re.findall(r"(?m)^\| \[(\d)\]\(.+?\) \| (.+?) \|", WHOLE)
}
TEN_HOURS = [number for row in rows(SHORT) for number in ids(row[0])]


def test_every_exercise_is_named_once() -> None:
    named = [
        number for row in rows(WHOLE) for cell in (row[0], row[2], row[3]) for number in ids(cell)
    ]
    assert sorted(named) == sorted(EXERCISES)
    assert f"has {len(EXERCISES)} exercises" in PAGE


@pytest.mark.parametrize("path", [SPINE, TEN_HOURS], ids=["spine", "ten hours"])
def test_what_an_exercise_needs_is_on_the_path_before_it(path: list[str]) -> None:
    order = list(EXERCISES)
    for number in path:
        assert {*EXERCISES[number].needs} <= {*path[: path.index(number)]}, number
    assert sorted(TEN_HOURS, key=order.index) == TEN_HOURS


def short_list(chapter: Chapter) -> list[str]:
    """Return the exercises that a lesson recommends to a student with little time, if any."""
    found = re.search(
        r"If you have only [^.]+? do exercises (.+?)\.\s", " ".join(lesson_of(chapter.name).split())
    )
    words = found[1] if found else ""
    for first, last in re.findall(r"B\d\.(\d+) to B\d\.(\d+)", words):
        numbers = range(int(first), int(last) + 1)
        between = ", ".join(f"B{chapter.number}.{number}" for number in numbers)
        words = words.replace(f"B{chapter.number}.{first} to B{chapter.number}.{last}", between)
    return re.findall(r"B?\d\.\d+[a-d]?", words)


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
def test_what_a_short_list_needs_is_in_the_list(chapter: Chapter) -> None:
    short, own = short_list(chapter), {exercise.id for exercise in chapter.exercises}
    for number in short:
        assert {*EXERCISES[number].needs} & own <= {*short}, number
    if chapter.number == 9:
        assert sorted(short) == sorted(SPINE_OF[9])


@pytest.mark.slow
@pytest.mark.parametrize("path", [SPINE, TEN_HOURS], ids=["spine", "ten hours"])
def test_no_other_exercise_is_needed_even_in_other_chapters(
    path: list[str], tmp_path: Path
) -> None:
    assert lost(tmp_path, path, path) == {}


def test_the_hours_are_those_of_the_lessons() -> None:
    assert sum(MINUTES[number] for number in TEN_HOURS) <= 10 * 60
    for row in rows(WHOLE):
        assert abs(sum(MINUTES[number] for number in ids(row[0])) / 60 - int(row[1])) <= 0.5, row
