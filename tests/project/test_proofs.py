"""Right answers earn everything, stubs nothing, and wrong ones lose theirs, run in both ways."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

from autograder.checks.runner import run_checks
from autograder.checks.verdict import Verdict, with_needs
from autograder.commands import TUNED, find_engine
from autograder.definitions import functions
from autograder.manifest import ROOT, Chapter, Exercise, load_chapters
from autograder.scores import results_of, total
from autograder.student.failure import next_place
from copies import copy_tree
from made import made_stubs
from ready import ready
from walls import behind_walls
from wrong import Wrong, read_right, read_wrong, write_all, write_wrong

CHAPTERS = load_chapters()
EXERCISES = [(chapter, e.id) for chapter in CHAPTERS for e in chapter.exercises if e.edit]


def depth_of(chapter: Chapter, exercise: str) -> int:
    """Return the length of the longest chain of exercises that this one builds on."""
    (needs,) = (e.needs for e in chapter.exercises if e.id == exercise)
    return 1 + max((depth_of(chapter, need) for need in needs), default=-1)


def exercise_of(chapter: Chapter, wrong: Wrong) -> Exercise:
    (exercise,) = (e for e in chapter.exercises if wrong.edit in e.edit)
    return exercise


def wrong_submissions() -> Iterator[object]:
    """Yield each wrong submission. With CH=, all are quick, else the first three of an exercise."""
    for chapter in CHAPTERS:
        seen: Counter[str] = Counter()
        for wrong in read_wrong(chapter):
            exercise = exercise_of(chapter, wrong).id
            marks = [pytest.mark.slow(but_for="chapter")] if seen[exercise] >= 3 else []
            seen[exercise] += 1
            yield pytest.param(chapter, wrong, id=f"{wrong.edit}: {wrong.mistake}", marks=marks)


LEVELS = [
    (chapter, depth)
    for chapter in CHAPTERS
    for depth in sorted({depth_of(chapter, e.id) for e in chapter.exercises if e.edit})
]
SEED = "1"
REFUSALS = ("ValueError", "TypeError", "ArithmeticError")
OTHER_SEED = "a class of its own"
by_chapter = pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)


def engine_with(top: Path) -> list[Path]:
    return [top, ROOT / "solutions", ROOT / "chapters"]


def lost(verdicts: list[Verdict]) -> dict[str, str]:
    """Return the checks that do not pass, each with its status and message."""
    return {v.name: f"{v.status}: {v.message}" for v in verdicts if v.status != "passed"}


@pytest.mark.parametrize(
    ("solution", "in_workers"),
    [
        *(("reference", False), ("second", False), ("tuned", False)),
        pytest.param("reference", True, marks=pytest.mark.slow),
        pytest.param("second", True, marks=pytest.mark.slow),
    ],
)
@by_chapter
def test_a_solution_earns_every_point(
    chapter: Chapter, solution: str, in_workers: bool, tmp_path: Path
) -> None:
    """The second solution is in the reference's engine, one chapter at a time."""
    seed, behind = (OTHER_SEED, behind_walls()) if in_workers else (SEED, None)
    if solution == "second":
        copy_tree(ROOT / "sample_class/ada" / chapter.name, tmp_path / chapter.name)
    engine = find_engine(TUNED) if solution == "tuned" else engine_with(tmp_path)
    verdicts = run_checks(chapter, engine, seed=seed, sandbox=behind)
    assert verdicts
    assert lost(verdicts) == {}


@by_chapter
def test_the_second_solution_is_whole(chapter: Chapter) -> None:
    """Otherwise the reference would stand in for a file that it lacks."""
    second = ROOT / "sample_class/ada" / chapter.name
    assert {file.name for file in second.glob("*.py")} == {*chapter.edited_files}


@by_chapter
def test_the_stubs_earn_nothing(chapter: Chapter, tmp_path: Path) -> None:
    """Each exercise has checks, except the written ones, and its stub passes none of them."""
    for path, text in made_stubs().items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    engine = engine_with(tmp_path / "chapters")
    verdicts = run_checks(chapter, engine, seed=SEED)
    checked = {exercise.id for exercise in chapter.exercises if exercise.kind != "written"}
    assert {verdict.exercise for verdict in verdicts} == checked
    assert [v.name for v in verdicts if v.status not in ("failed", "blocked")] == []
    assert total(results_of(chapter, verdicts))[0] == 0.0


@pytest.mark.parametrize("body", ["pass", *(f"raise {e}('no')" for e in REFUSALS)])
@by_chapter
def test_doing_nothing_and_refusing_everything_earn_nothing(chapter: Chapter, body: str) -> None:
    waiting = ready(chapter)
    write_all(chapter, body, waiting.top)
    edits = [edit for exercise in chapter.exercises for edit in exercise.edit]
    verdicts = waiting.run(edits, [exercise.id for exercise in chapter.exercises])
    assert verdicts
    assert [verdict.name for verdict in verdicts if verdict.status == "passed"] == []


@by_chapter
def test_empty_modules_earn_nothing(chapter: Chapter, tmp_path: Path) -> None:
    write_all(chapter, None, tmp_path)
    verdicts = run_checks(chapter, engine_with(tmp_path), seed=SEED)
    assert verdicts
    assert [verdict.name for verdict in verdicts if verdict.status == "passed"] == []


@pytest.mark.parametrize(("chapter", "exercise"), EXERCISES, ids=[e for _, e in EXERCISES])
def test_an_exercise_needs_no_other_than_it_says(chapter: Chapter, exercise: str) -> None:
    """Its checks pass while all bodies that it does not need are unwritten."""
    needed = with_needs(chapter, [exercise])
    waiting = ready(chapter)
    write_all(chapter, "raise NotImplementedError('no')", waiting.top, but=needed)
    edits = [edit for e in chapter.exercises if e.id not in needed for edit in e.edit]
    assert lost(waiting.run(edits, [exercise])) == {}


@by_chapter
def test_the_other_right_bodies_earn_every_point(chapter: Chapter) -> None:
    """Some wrong submissions change a few words of such a body, so it must be right itself."""
    waiting = ready(chapter)
    rights = read_right(chapter)
    bodies = [Wrong(edit, "", "", body=body) for edit, body in rights.items()]
    write_wrong(chapter, bodies, waiting.top)
    ids = [e.id for e in chapter.exercises if not rights.keys().isdisjoint(e.edit)]
    assert lost(waiting.run([*rights], ids)) == {}


@pytest.mark.parametrize(("chapter", "wrong"), [*wrong_submissions()])
def test_a_wrong_submission_is_caught(
    chapter: Chapter, wrong: Wrong, pytestconfig: pytest.Config
) -> None:
    """Only its exercise is run, as test_an_exercise_needs_no_other_than_it_says allows."""
    waiting = ready(chapter, pytestconfig.getoption("seed"))
    write_wrong(chapter, [wrong], waiting.top)
    exercise = exercise_of(chapter, wrong)
    verdicts = waiting.run([wrong.edit], [exercise.id])
    if wrong.caught_by not in [verdict.name for verdict in verdicts]:
        # A later exercise adds to this function, and its check catches the mistake.
        everything = waiting.run([wrong.edit], [e.id for e in chapter.exercises])
        later = {v.name: v.exercise for v in everything}.get(wrong.caught_by)
        assert later, f"{chapter.name}/wrong.toml names an unknown check, {wrong.caught_by}"
        verdicts = waiting.run([wrong.edit], [later])
    failed = [verdict for verdict in verdicts if verdict.status != "passed"]
    assert wrong.caught_by in [verdict.name for verdict in failed]
    first = failed[0]
    assert first.message.likely
    assert first.message.read
    assert wrong.says in str(first.message), (
        f"{first.name} fails first, and says: {first.message.likely}"
    )
    file, _, line = next_place(waiting.engine, chapter, exercise, first).rpartition(":")
    module, _, name = (wrong.opens or wrong.edit).partition(".")
    assert Path(file) == waiting.top / chapter.name / f"{module}.py"
    body = functions(ast.parse(Path(file).read_text(encoding="utf-8")))[name]
    assert body.end_lineno is not None
    assert body.lineno <= int(line) <= body.end_lineno


@pytest.mark.slow
@pytest.mark.parametrize(("chapter", "depth"), LEVELS, ids=[f"{c.name}, {d}" for c, d in LEVELS])
def test_a_wrong_submission_is_told_the_same_both_ways(chapter: Chapter, depth: int) -> None:
    """All exercises of one depth are wrong at once, and those that they need are right."""
    ids = [e.id for e in chapter.exercises if e.edit and depth_of(chapter, e.id) == depth]
    wrongs = [w for w in read_wrong(chapter) if exercise_of(chapter, w).id in ids]
    firsts = {exercise_of(chapter, wrong).id: wrong for wrong in reversed(wrongs)}
    assert firsts.keys() == set(ids)
    waiting = ready(chapter)
    write_wrong(chapter, firsts.values(), waiting.top)
    beside = waiting.run([wrong.edit for wrong in firsts.values()], with_needs(chapter, ids))
    behind = behind_walls()
    assert beside == run_checks(chapter, waiting.engine, seed=SEED, exercises=ids, sandbox=behind)
    failed = {verdict.exercise for verdict in beside if verdict.status == "failed"}
    assert failed == set(ids)
