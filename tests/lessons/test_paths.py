"""The learning path, the lessons' short lists and the study guide's plans can be followed."""

from __future__ import annotations

import re
from collections.abc import Collection
from pathlib import Path

import pytest

from autograder.checks.runner import run_checks
from autograder.course.reading import read_course
from autograder.manifest import ROOT, Chapter, load_chapters
from copies import copy_tree
from lessons.lesson import lesson_of, minutes_of
from wrong import write_all

CHAPTERS = {chapter.number: chapter for chapter in load_chapters()}
EXERCISES = {e.id: e for chapter in CHAPTERS.values() for e in chapter.exercises}
MINUTES = dict(pair for c in CHAPTERS.values() for pair in minutes_of(lesson_of(c.name)))


def exercises_of(words: str) -> set[str]:
    """Return the exercises that a text names, such as "B2.1 to B2.4, and 2.5"."""
    found = {*re.findall(r"\b[BGP]?\d\.\d+[a-d]?\b", words)}
    for kind, first, last in re.findall(r"\b([BGP]?\d)\.(\d+) to \1\.(\d+)\b", words):
        between = {f"{kind}.{n}" for n in range(int(first), int(last) + 1)}
        found |= {number for number in EXERCISES if number.rstrip("abcd") in between}
    return found


def lost(
    folder: Path, done: Collection[str], graded: Collection[str], given: Collection[int] = ()
) -> dict[str, str]:
    """Return the checks of ``graded`` exercises that fail while only those in ``done`` are solved.

    The chapters in ``given`` are complete. Exercises with measurements are left out.
    """
    for chapter in CHAPTERS.values():
        if chapter.number in given:
            copy_tree(ROOT / "solutions" / chapter.name, folder / chapter.name)
        else:
            write_all(chapter, "raise NotImplementedError('not done')", folder, but=[*done])
    found = {}
    for chapter in CHAPTERS.values():
        if ids := [e.id for e in chapter.exercises if e.id in graded and e.edit and not e.files]:
            verdicts = run_checks(chapter, [folder, ROOT / "chapters"], seed="1", exercises=ids)
            found |= {v.name: str(v.message) for v in verdicts if v.status != "passed"}
    return found


PAGE = (ROOT / "docs/learning_path.md").read_text(encoding="utf-8")


def rows(table: str) -> list[list[str]]:
    """Return the cells of the rows that begin with a link to a chapter, without that link."""
    lines = re.findall(r"(?m)^\| \[\d\]\(.+?\) \| (.+) \|$", table)
    return [[cell.strip() for cell in line.split("|")] for line in lines]


def ids(cell: str) -> list[str]:
    return cell.replace(",", " ").split()


SHORT, WHOLE = map(rows, PAGE.split("## The whole course"))
SPINE, TEN_HOURS = ([n for cells in table for n in ids(cells[0])] for table in (WHOLE, SHORT))
each_path = pytest.mark.parametrize("path", [SPINE, TEN_HOURS], ids=["spine", "ten hours"])


@pytest.mark.parametrize(("chapter", "cells"), [*zip(CHAPTERS.values(), WHOLE, strict=True)])
def test_every_exercise_is_named_once(chapter: Chapter, cells: list[str]) -> None:
    named = [number for cell in (cells[0], *cells[2:4]) for number in ids(cell)]
    assert sorted(named) == sorted(e.id for e in chapter.exercises), "see docs/learning_path.md"
    words = f"has {len(EXERCISES)} exercises"
    assert words in PAGE, f"the first sentence of docs/learning_path.md must say {words!r}"


@each_path
def test_what_an_exercise_needs_is_on_the_path_before_it(path: list[str]) -> None:
    for number in path:
        assert {*EXERCISES[number].needs} <= {*path[: path.index(number)]}, number


@pytest.mark.slow
@each_path
def test_no_other_exercise_is_needed_even_in_other_chapters(
    path: list[str], tmp_path: Path
) -> None:
    assert lost(tmp_path, path, path) == {}


def test_the_hours_are_those_of_the_lessons() -> None:
    assert sum(MINUTES[number] for number in TEN_HOURS) <= 10 * 60
    for exercises, hours, *_ in WHOLE:
        assert abs(sum(MINUTES[n] for n in ids(exercises)) / 60 - int(hours)) <= 0.5, exercises


@pytest.mark.parametrize("chapter", CHAPTERS.values(), ids=lambda chapter: chapter.name)
def test_what_the_short_list_of_a_lesson_needs_is_in_the_list(chapter: Chapter) -> None:
    lesson = " ".join(lesson_of(chapter.name).split())
    found = re.search(r"If you have only [^.]+? do exercises (.+?)\.\s", lesson)
    short = exercises_of(found[1]) if found else set()
    for exercise in chapter.exercises:
        own = {need for need in exercise.needs if EXERCISES[need] in chapter.exercises}
        assert exercise.id not in short or own <= short, exercise.id
    if chapter.number == 9:
        assert short == {*ids(WHOLE[-1][0])}


GUIDE = (ROOT / "docs/study_guide.md").read_text(encoding="utf-8")
PLANS = {
    path.stem: read_course(path).assignments for path in sorted(ROOT.glob("docs/plans/*.toml"))
}
WEEKS = [(name, week) for name, works in PLANS.items() for week in range(1, len(works) + 1)]


def test_every_misconception_names_a_check_of_its_chapter() -> None:
    found = re.findall(r"(?m)^\| (\d) \| .+ \| `(test_\w+)` \|$", GUIDE)
    assert {int(number) for number, _ in found} == {*CHAPTERS}
    for number, check in found:
        files = ROOT.glob(f"tests/{CHAPTERS[int(number)].name}/test_*.py")
        assert any(f"def {check}(" in file.read_text(encoding="utf-8") for file in files), check


@pytest.mark.parametrize("name", PLANS)
def test_the_tables_of_the_plans_agree_with_their_course_files(name: str) -> None:
    title = name.replace("_", " ").capitalize()
    section = GUIDE.partition(f"## {title}")[2].partition("\n## ")[0]
    assert f"](plans/{name}.toml)" in section
    weeks = [re.split(r" *\| ?", line)[1:-1] for line in re.findall(r"(?m)^\| +\d.*", section)]
    assert [f"week{number}" for number, *_ in weeks] == [work.name for work in PLANS[name]]
    for (_, chapters, cell, *given, _), work in zip(weeks, PLANS[name], strict=True):
        assigned = {exercise.id for chapter in work.chapters for exercise in chapter.exercises}
        if cell == "all":
            assert work.chapters == [CHAPTERS[int(chapters)]]
        else:
            assert exercises_of(cell) == assigned, work.name
        numbers = [chapter.number for chapter in work.chapters]
        assert [int(number) for number in re.findall(r"\d", chapters)] == numbers
        assert re.findall(r"\d", "".join(given)) == [str(c.number) for c in work.given]
    assert sum(int(row[-1]) for row in weeks) <= {"twelve_weeks": 12 * 6, "four_weeks": 4 * 8}[name]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "week"), WEEKS)
def test_a_week_can_be_done_with_what_the_weeks_before_it_assign(
    name: str, week: int, tmp_path: Path
) -> None:
    works = PLANS[name][:week]
    assigned = [[e.id for chapter in work.chapters for e in chapter.exercises] for work in works]
    given = [chapter.number for chapter in works[-1].given]
    done = [number for numbers in assigned for number in numbers]
    assert lost(tmp_path, done, assigned[-1], given) == {}


def test_the_rubric_adds_up() -> None:
    rubric = GUIDE.partition("| criterion |")[2]
    assert sum(map(int, re.findall(r"(?m)^\| \w+ \| (\d+) \|", rubric))) == 20
