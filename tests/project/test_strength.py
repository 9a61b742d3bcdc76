"""The checks are as strong as tests/README.md says, and what measures them does so rightly."""

from __future__ import annotations

import ast
import re
import sys
import tomllib
from collections import Counter

import pytest

from autograder.definitions import functions
from autograder.manifest import ROOT, Chapter, load_chapters
from wrong import read_wrong

CHAPTERS = load_chapters()


def by_name(chapter: Chapter) -> str:
    return chapter.name


@pytest.mark.parametrize("chapter", CHAPTERS, ids=by_name)
def test_every_exercise_has_three_wrong_submissions(chapter: Chapter) -> None:
    wrongs = Counter(wrong.edit for wrong in read_wrong(chapter))
    for exercise in chapter.exercises:
        if exercise.edit:
            assert sum(wrongs[edit] for edit in exercise.edit) >= 3, exercise.id


@pytest.mark.parametrize("chapter", CHAPTERS, ids=by_name)
def test_a_survivor_is_a_line_of_the_reference_and_has_a_reason(chapter: Chapter) -> None:
    path = ROOT / "tests" / chapter.name / "survivors.toml"
    edits = {edit for exercise in chapter.exercises for edit in exercise.edit}
    seen = set()
    for survivor in tomllib.loads(path.read_text(encoding="utf-8"))["survivor"]:
        assert survivor.keys() == {"edit", "line", "became", "reason"}
        assert survivor["edit"] in edits
        module, _, name = survivor["edit"].partition(".")
        source = (ROOT / "solutions" / chapter.name / f"{module}.py").read_text(encoding="utf-8")
        body = functions(ast.parse(source))[name]
        lines = source.splitlines()[body.lineno : body.end_lineno]
        assert survivor["line"] in [line.strip() for line in lines]
        for became in survivor["became"]:
            assert became != survivor["line"]
            assert (survivor["edit"], survivor["line"], became) not in seen
            seen.add((survivor["edit"], survivor["line"], became))
        assert len(survivor["reason"].split()) >= 4


def test_the_table_has_every_chapter_as_it_is_now_and_strong_enough() -> None:
    page = (ROOT / "tests/README.md").read_text(encoding="utf-8")
    rows = [
        [cell.strip() for cell in line.split("|")[1:-1]]
        for line in page.splitlines()
        if re.match(r"\| \d ", line)
    ]
    assert [row[0] for row in rows] == [f"{c.number} {c.title}" for c in CHAPTERS]
    for chapter, row in zip(CHAPTERS, rows, strict=True):
        checked = [exercise for exercise in chapter.exercises if exercise.kind != "written"]
        points = sum(exercise.points for exercise in checked)
        assert (row[1], row[3]) == (str(len(checked)), str(points))
        assert row[6] == str(len(read_wrong(chapter)))
        assert float(re.search(r"([\d.]+) %", row[4])[1]) >= 97.0
        for cell in row[7:]:  # the reference, and the second solution
            seeds, _, pythons = cell.partition(" on ")
            assert int(seeds) >= 1000
            assert pythons == "3.11, 3.12, 3.13"


@pytest.fixture
def mutants(monkeypatch: pytest.MonkeyPatch) -> object:
    pytest.importorskip("cosmic_ray")
    monkeypatch.setattr(sys, "path", [str(ROOT / "tests/strength"), *sys.path])
    import mutants

    return mutants


def test_a_mutant_differs_in_one_line_of_a_body_that_students_write(mutants: object) -> None:
    made = list(mutants.mutants_of(CHAPTERS[0]))
    edits = {edit for exercise in CHAPTERS[0].exercises for edit in exercise.edit}
    assert len(made) > 300
    for mutant in made:
        source = (ROOT / "solutions/ch02_vectors" / mutant.file).read_text(encoding="utf-8")
        pairs = zip(source.splitlines(), mutant.code.splitlines(), strict=True)
        changed = [number for number, (old, new) in enumerate(pairs, 1) if old != new]
        assert len(changed) == 1, mutant
        assert mutant.edit in edits
        body = functions(ast.parse(source))[mutant.edit.partition(".")[2]]
        assert body.lineno < changed[0] <= body.end_lineno
        ast.parse(mutant.code)


def test_a_mistake_is_killed_and_what_is_the_same_survives(mutants: object) -> None:
    line = "if length == 0.0:"
    made = [m for m in mutants.mutants_of(CHAPTERS[0]) if m.edit == "vector.Vector3.normalized"]
    same, other = (
        next(m for m in made if (m.line, m.became) == (line, became))
        for became in ("if length <= 0.0:", "if length == 1.0:")
    )
    assert mutants.killer_of(CHAPTERS[0], same) == ""
    assert mutants.killer_of(CHAPTERS[0], other).startswith("test_")
