"""The checks are as strong as tests/README.md says, and the measurements are correct."""

from __future__ import annotations

import ast
import sys
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

from autograder.definitions import functions
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.text.marked import between
from ready import ready
from wrong import read_wrong

CHAPTERS = load_chapters()
by_chapter = pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)


@pytest.fixture(autouse=True)
def strength(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let tests import the modules of tests/strength."""
    monkeypatch.setattr(sys, "path", [str(ROOT / "tests/strength"), *sys.path])


@by_chapter
def test_every_exercise_has_three_wrong_submissions(chapter: Chapter) -> None:
    wrongs = Counter(wrong.edit for wrong in read_wrong(chapter))
    for exercise in chapter.exercises:
        assert not exercise.edit or sum(wrongs[e] for e in exercise.edit) >= 3, exercise.id


@by_chapter
def test_a_survivor_changes_a_body_that_students_write_and_has_a_reason(chapter: Chapter) -> None:
    pytest.importorskip("cosmic_ray")
    from mutants import read_survivors

    reasons, changes = zip(*read_survivors(chapter), strict=True)
    assert len({*changes}) == len(changes)
    assert {edit for edit, *_ in changes} <= {edit for e in chapter.exercises for edit in e.edit}
    assert min(len(reason.split()) for reason in reasons) >= 4


@by_chapter
def test_make_table_would_write_the_row_that_is_there(chapter: Chapter) -> None:
    """In a fresh copy, make update changes nothing."""
    import table

    page = table.PAGE.read_text(encoding="utf-8")
    rows = between(page, table.BEGIN, table.END).splitlines()[2:]
    row = table.table_of([table.row(chapter)]).splitlines()[2]
    assert row == rows[CHAPTERS.index(chapter)], f"run make update, which writes {row}"
    assert len(rows) == len(CHAPTERS)


@by_chapter
def test_the_checks_of_a_chapter_are_strong_and_fair_enough(chapter: Chapter) -> None:
    """A figure from before a change counts as not measured."""
    from kept import SOLUTIONS, mutants_of, seeds_of

    mutants, again = mutants_of(chapter), "has changed: run make measure WHAT="
    assert mutants, f"a check or the reference {again}mutants CH={chapter.number}"
    assert mutants["killed"] / mutants["of"] >= 0.97
    for solution in SOLUTIONS:
        for file, pythons in seeds_of(solution, chapter).items():
            assert pythons, f"{file} or the {solution} {again}seeds CH={chapter.number}"
            assert min(pythons.values()) >= 1000


BEFORE = (
    '@exercise("B1.1", asks="the sum")\ndef f():\n    """Add both."""\n    g(f"a {x} b", "k")\n'
)


@pytest.mark.parametrize(
    ("change", "kept"),
    [
        (("    g(", "\n    # A check.\n    g("), {True, False}),
        (("Add both.", "Add two."), {True, False}),
        (('asks="the sum"', 'asks="a sum"'), {True, False}),
        (('f"a {x} b"', '"c d"'), {False}),
        (('f"a {x} b"', '"c d" + y'), set()),
        (('"k"', '"l"'), set()),
    ],
)
def test_a_figure_is_old_once_the_code_that_it_was_measured_on_changes(
    change: tuple[str, str], kept: set[bool], tmp_path: Path
) -> None:
    """Sentences count for mutants, and not for seeds."""
    from fingerprint import fingerprint

    def of(text: str, sentences: bool) -> str:
        (tmp_path / "check.py").write_text(text, encoding="utf-8")
        return fingerprint([tmp_path / "check.py"], sentences=sentences)

    after = BEFORE.replace(*change)
    assert after != BEFORE
    assert {which for which in (True, False) if of(BEFORE, which) == of(after, which)} == kept


def test_an_old_figure_is_dropped_and_a_new_one_does_not_keep_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    import kept

    chapter, changed = CHAPTERS[0], set[str]()
    one, other = kept.files_of_checks(chapter)[:2]
    monkeypatch.setattr(kept, "FILE", tmp_path / "figures.json")
    monkeypatch.setattr(kept, "of_checks", lambda *_: str(changed))
    monkeypatch.setattr(kept, "of_check_file", lambda check, *_: str(check.name in changed))

    def seeds() -> dict[str, dict[str, int]]:
        found = kept.seeds_of("reference", chapter)
        return {name: pythons for name, pythons in found.items() if pythons}

    kept.keep_mutants(chapter, killed=1, of=1)
    for check, python in ((one, "3.11"), (other, "3.11"), (one, "3.12")):
        kept.keep_seeds("reference", chapter, check, python, 1000)
    assert kept.mutants_of(chapter) == {"killed": 1, "of": 1}
    assert seeds() == {one.name: {"3.11": 1000, "3.12": 1000}, other.name: {"3.11": 1000}}
    changed.add(one.name)
    assert kept.mutants_of(chapter) == {}
    assert seeds() == {other.name: {"3.11": 1000}}
    kept.keep_mutants(chapter, killed=2)
    kept.keep_seeds("reference", chapter, one, "3.12", 1000)
    assert kept.mutants_of(chapter) == {"killed": 2}
    assert seeds()[one.name] == {"3.12": 1000}


def test_a_file_of_checks_changes_with_what_it_imports(tmp_path: Path) -> None:
    """The check imports a module of the solution, which imports another one."""
    from fingerprint import of_check_file

    chapter, check = CHAPTERS[0], tmp_path / "test_it.py"
    check.write_text("from ch02_vectors.one import f\n", encoding="utf-8")
    folder = tmp_path / chapter.name
    folder.mkdir()
    for name, text in (("one", "from ch02_vectors import two"), ("two", ""), ("three", "")):
        (folder / f"{name}.py").write_text(text, encoding="utf-8")
    before = of_check_file(check, chapter, tmp_path)
    (folder / "three.py").write_text("f = 3", encoding="utf-8")
    assert of_check_file(check, chapter, tmp_path) == before
    (folder / "two.py").write_text("f = 2", encoding="utf-8")
    assert of_check_file(check, chapter, tmp_path) != before


def test_mutants_differ_in_a_line_of_a_body_and_a_mistake_is_killed() -> None:
    """What means the same survives."""
    pytest.importorskip("cosmic_ray")
    import mutants

    edit = "vector.Vector3.normalized"
    few = replace(CHAPTERS[0], exercises=[e for e in CHAPTERS[0].exercises if edit in e.edit])
    made = [mutant for mutant in mutants.mutants_of(few) if mutant.edit == edit]
    source = (ROOT / "solutions/ch02_vectors/vector.py").read_text(encoding="utf-8")
    body = functions(ast.parse(source))["Vector3.normalized"]
    assert len(made) >= 10
    for mutant in made:
        ast.parse(mutant.code)
        pairs = zip(source.splitlines(), mutant.code.splitlines(), strict=True)
        (changed,) = [number for number, (old, new) in enumerate(pairs, 1) if old != new]
        assert body.lineno < changed <= body.end_lineno
    same, other = (
        next(m for m in made if (m.line, m.became) == ("if length == 0.0:", became))
        for became in ("if length <= 0.0:", "if length == 1.0:")
    )
    waiting = ready(CHAPTERS[0])
    assert mutants.killer_of(waiting, same) == ""
    assert mutants.killer_of(waiting, other).startswith("test_")
