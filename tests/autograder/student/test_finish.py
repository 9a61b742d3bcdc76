"""The screen at the end of a chapter, and what is said of scenes by then."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from autograder.checks.verdict import Verdict
from autograder.manifest import ROOT, Chapter, Exercise, load_chapters
from autograder.scores import result_of
from autograder.student.chapter_results import ChapterResults
from autograder.student.finish import end_of, finish_lines, is_finished

CHAPTERS = {chapter.number: chapter for chapter in load_chapters()}
CH03 = CHAPTERS[3]
SOLUTIONS = [ROOT / "solutions", ROOT / "chapters"]


def report_of(chapter: Chapter, *fail: str, robust: Sequence[str] = ()) -> ChapterResults:
    """Return a chapter with a check of both tiers in each exercise; those in ``fail`` fail both."""
    results = []
    for exercise in chapter.exercises:
        tiers = {False: exercise.id in fail, True: exercise.id in {*fail, *robust}}
        checks = [
            Verdict("test", exercise.id, 1.0, "failed" if fails else "passed", "", robust=tier)
            for tier, fails in tiers.items()
        ]
        results.append(result_of(exercise, checks))
    return ChapterResults(chapter, results, [], [])


def ids(chapter: Chapter, *but: str) -> list[str]:
    return [exercise.id for exercise in chapter.exercises if exercise.id not in but]


def shown(
    reports: list[ChapterResults], exercise: Exercise | None = None, engine: list[Path] = SOLUTIONS
) -> str:
    return "".join(f"\n{line}" for line, _ in end_of(reports, exercise, engine, []))


@pytest.mark.parametrize("number", CHAPTERS)
def test_the_screen_fits_whatever_is_open(number: int) -> None:
    """The blank answers are open here, and so is all else without which a chapter is finished."""
    chapter = CHAPTERS[number]
    extra = [name for name in ids(chapter) if is_finished(report_of(chapter, name))]
    report = report_of(chapter, *extra, robust=ids(chapter))
    assert is_finished(report)
    lines = finish_lines(report, [ROOT / "chapters"], [])
    assert len(lines) <= 20
    assert max(map(len, lines)) <= 80


def test_a_chapter_is_finished_when_its_physics_works() -> None:
    assert is_finished(report_of(CH03))
    assert is_finished(report_of(CH03, robust=ids(CH03)))
    assert not is_finished(report_of(CH03, "3.5b"))
    assert is_finished(report_of(CHAPTERS[4], "P4.1", "G4.1"))
    some = ChapterResults(CH03, report_of(CH03).results[:4], [], [])
    assert not is_finished(some), "the rest was not checked"


def test_it_says_what_one_can_do_what_to_play_what_is_open_and_what_comes_next() -> None:
    text = shown([report_of(CH03, robust=["B3.3"])])
    words = " ".join(text.split())
    assert all(sentence in words for sentence in CH03.you_can)
    assert "make plot CH=3 ENGINE=solutions draws it with your own functions" in words
    assert "make lab SCENE=damping-forms ENGINE=solutions (or frame-rates or throw)" in words
    assert "1 robust check; the first: make check EX=B3.3 ENGINE=solutions" in words
    assert f"chapter 4, The particle engine. {CHAPTERS[4].summary}" in words
    assert "Open nothing" in " ".join(shown([report_of(CH03)]).split())
    assert "\nNext" not in shown([report_of(CHAPTERS[9])]), "it is the last chapter"


def test_questions_and_projects_that_are_open_are_named() -> None:
    two = shown([report_of(CHAPTERS[2])], engine=[ROOT / "chapters"])
    assert "2.2b and 2.3" in two
    five = shown([report_of(CHAPTERS[5], "P4.2a", "P4.2b")])
    assert "P4.2a" in five
    assert "P4.2b" in five
    assert "SCENE=sniper" not in five


def test_of_several_chapters_the_last_finished_one_until_the_next_is_begun() -> None:
    two, three = report_of(CHAPTERS[2]), report_of(CH03)
    untouched = report_of(CHAPTERS[4], *ids(CHAPTERS[4]))
    begun = report_of(CHAPTERS[4], *ids(CHAPTERS[4], "B4.1"))
    assert "Chapter 3" in shown([two, three, untouched])
    assert shown([two, three, begun]) == ""
    assert shown([untouched]) == ""


def test_a_scene_is_offered_by_the_exercise_that_unlocks_it() -> None:
    for_demo = CH03.exercise("B3.4")
    report = report_of(CH03, *ids(CH03, "B3.1", "B3.2", "B3.3", "B3.4"))
    told = "B3.4 works. Try it: make lab SCENE=frame-rates ENGINE=solutions and make lab"
    assert told in shown([report], for_demo)
    assert told in shown([report])
    assert shown([report], CH03.exercise("B3.1")) == ""
    broken = report_of(CH03, "B3.1", "3.1")
    assert shown([broken], for_demo) == ""
    robust = report_of(CH03, "3.5b", robust=ids(CH03))
    assert told in shown([robust], for_demo)
