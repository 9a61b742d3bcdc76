"""The stuck student: what an earlier chapter breaks is told from what this one does wrong."""

from __future__ import annotations

import re
from functools import partial
from pathlib import Path
from subprocess import CompletedProcess
from typing import Any

import pytest

from autograder.checks.runner import GraderError, run_checks
from autograder.checks.verdict import Verdict
from autograder.diagnosis.earlier_chapters import (
    explained_on_given,
    mark_inherited,
    run_on_given,
)
from autograder.grader.conditions import Conditions
from autograder.grader.grading import grade_submission
from autograder.handouts.handout import make_handout
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT, Chapter, select_chapters
from autograder.message import Kind, Message
from autograder.student.screen import check as check_chapters
from autograder.submissions.find import Submission
from copies import copy_tree, edit
from graded import points_of
from typed import typed

CH02, CH03 = select_chapters("2-3")
WHOLE = f"{points_of(CH03)} of {points_of(CH03)}"
REFERENCE = [ROOT / "solutions", ROOT / "chapters"]


SCALE = ("self.z * scale)", "self.z)")  # z is not scaled
MOMENTUM = "test_momentum_is_mass_times_velocity"


def check(engine: Path | str, *arguments: str, root: Path = ROOT) -> CompletedProcess[str]:
    return typed("autograder", "check", "--engine", engine, *arguments, cwd=root)


@pytest.fixture
def engine(tmp_path: Path) -> Path:
    """The reference's chapters 2 and 3 in a folder to be edited."""
    for chapter in (CH02, CH03):
        copy_tree(ROOT / "solutions" / chapter.name, tmp_path / chapter.name)
    return tmp_path


@pytest.fixture
def vector(engine: Path) -> Path:
    return engine / CH02.name / "vector.py"


@pytest.fixture
def particle(engine: Path) -> Path:
    return engine / CH03.name / "particle.py"


def verdicts(engine: Path, exercises: list[str] | None = None) -> dict[str, Verdict]:
    folders = [engine, ROOT / "chapters"]
    run = partial(run_checks, seed="1", exercises=exercises)
    before = run(CH03, folders)
    again = run_on_given(CH03, before, folders, [CH02], run)
    marked = explained_on_given(mark_inherited(before, again), again)
    return {verdict.name: verdict for verdict in marked}


def test_a_right_chapter_on_a_broken_one_has_inherited_failures_alone() -> None:
    done = check("sample_class/hana", "--chapter", "3")
    assert done.returncode == 1
    rows = [line.split() for line in done.stdout.splitlines()]
    assert ["B3.4", "The", "step", "**", "inherited"] in [row[:5] for row in rows]
    assert not [row for row in rows if "failed" in row or "blocked" in row]
    sentence = (
        r"\n\d+ checks fail here because of mistakes in chapter 2\. On the reference's chapter 2 "
    )
    assert re.search(sentence + rf"you have {WHOLE} points\.\n", done.stdout)
    assert "make check CH=3 GIVEN=2 ENGINE=sample_class/hana\n" in done.stdout
    assert "Inherited, for example: B3.4 The step" in done.stdout
    assert "likely" not in done.stdout, "chapter 3 does not know the cause"
    assert done.stdout.endswith("Next: make check CH=2 ENGINE=sample_class/hana\n")
    only = check("sample_class/hana", "--exercise", "3.4b")
    assert "chapter 2 you have 14 of 14 points.\n" in only.stdout
    assert "make check EX=3.4b GIVEN=2 ENGINE=sample_class/hana\n" in only.stdout


def test_given_takes_the_earlier_chapter_from_the_reference() -> None:
    done = check("sample_class/hana", "--chapter", "3", "--given", "2")
    assert done.returncode == 0
    assert f"{WHOLE} points" in done.stdout
    assert "All checks pass on the reference's chapter 2." in done.stdout
    everything = check("sample_class/hana", "--chapter", "2-3", "--given", "2")
    assert everything.returncode == 0, "what is given is not checked"
    assert "Chapter 2:" not in everything.stdout


def test_own_failures_stay_failures_and_come_first(engine: Path, vector: Path) -> None:
    edit(vector, *SCALE)
    edit(engine / CH03.name / "exercises.py", "** 2", "** 3")
    marked = verdicts(engine)
    assert marked[MOMENTUM].status == "inherited"
    assert marked["test_the_force_falls_with_the_square_of_the_distance"].status == "failed"
    done = check(engine, "--chapter", "3")
    assert "Fix this first: 3.2 Gravity between two people" in done.stdout
    assert "make check CH=3 GIVEN=2" in done.stdout


def test_a_failure_in_both_is_told_as_it_is_on_the_reference(
    engine: Path, vector: Path, particle: Path
) -> None:
    edit(vector, *SCALE)
    edit(particle, "self.velocity * self.mass", "self.velocity * 2")
    verdict = verdicts(engine)[MOMENTUM]
    assert verdict.status == "failed"
    velocity = re.findall(r"Vector3\(.*?, .*?, (.*?)\)", verdict.message.called)
    got = verdict.message.got.strip(" ()").split(", ")
    assert float(got[2]) == 2.0 * float(velocity[0]), "z is scaled too"


def test_points_on_the_reference_are_those_of_a_run_on_it(
    engine: Path, vector: Path, particle: Path
) -> None:
    """Two mistakes that make up for each other: on the reference the second one shows."""
    edit(vector, "return math.hypot(self.x, self.y, self.z)", "return self @ self", *SCALE)
    edit(particle, "velocity.squared_magnitude()", "velocity.magnitude()")
    done = check(engine, "--chapter", "3")
    left = points_of(CH03) - CH03.exercise("3.3").points
    assert f"On the reference's chapter 2 you have {left}." in done.stdout  # a check of 3.3 passes


@pytest.mark.slow
def test_an_endless_loop_of_its_own_is_told_at_once_and_not_run_again(
    engine: Path, vector: Path, particle: Path
) -> None:
    loop = "while True:\n            pass"
    edit(particle, "if not self.has_finite_mass:\n            return Vector3()", loop)
    edit(vector, *SCALE)
    marked = verdicts(engine, ["B3.2"])
    hung = [verdict for verdict in marked.values() if verdict.message.kind is Kind.HUNG]
    assert "3 seconds" in hung[0].message.title
    assert len(hung) == 1, "the other checks of the exercise are not waited for"
    assert not [verdict for verdict in marked.values() if verdict.status == "inherited"]
    done = check(engine, "--exercise", "B3.2")
    assert "Chapter 2 fails some of its own checks, which may explain some of the" in done.stdout


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("class Vector3:", "class Vector3(:", "ch02_vectors/vector.py cannot be read"),
        ("return Vector3(self.x + v.x", "raise NotImplementedError('Exercise B2.5')  # ", "B2.5"),
        ("self.x + v.x, self.y", "self.x + v.x, self.x", ""),
    ],
)
def test_whatever_is_wrong_below_is_inherited(
    engine: Path, vector: Path, old: str, new: str, words: str
) -> None:
    edit(vector, old, new)
    lost = [verdict for verdict in verdicts(engine).values() if verdict.status != "passed"]
    assert lost
    assert {verdict.status for verdict in lost} == {"inherited"}
    assert words in str(lost[0].message)


def test_a_chapter_that_is_not_written_yet_is_not_run_a_second_time() -> None:
    never = lambda *_: pytest.fail("ran again")  # noqa: E731
    unwritten, wrong = Message(kind=Kind.UNWRITTEN, exercise="B3.1"), Message("wrong")
    for message, chapters in ((unwritten, [CH02]), (wrong, [])):  # or all below is given
        before = [Verdict("a", "B3.1", 1, "failed", message)]
        assert run_on_given(CH03, before, REFERENCE, chapters, never) == []


def test_a_fault_of_the_second_run_leaves_the_first_as_it_is(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """At home, and in grading, where it is no score on given chapters."""

    def fails(*_: Any, **__: Any) -> list[Verdict]:
        raise GraderError("the disk is full")

    def fails_on_given(chapter: Chapter, engine: list[Path], **options: Any) -> list[Verdict]:
        return (fails if "given" in engine[0].name else run_checks)(chapter, engine, **options)

    monkeypatch.setattr("autograder.student.screen.run_checks", fails_on_given)
    engine = [ROOT / "sample_class/hana", ROOT / "chapters"]
    assert not check_chapters([CH03], None, engine, "1", [])
    assert "inherited" not in capsys.readouterr().out
    monkeypatch.setattr("autograder.grader.grading.run_on_given", fails)
    report = grade_submission(Conditions([CH03], "1", Level()), Submission("hana", engine[0]))
    assert report.status == "error, retry"
    assert (report.score or 0.0) > 0
    assert report.score_on_given is None


def test_without_the_reference_nothing_is_offered(tmp_path: Path) -> None:
    make_handout([CH02, CH03], [], tmp_path / "out")
    for chapter in ("ch02_vectors", "ch03_laws_of_motion"):
        source = ROOT / "sample_class/hana" / chapter
        copy_tree(source, tmp_path / "out/chapters" / chapter)
    done = check("chapters", "--chapter", "3", root=tmp_path / "out")
    assert done.returncode == 1
    assert "GIVEN" not in done.stdout
    assert "Chapter 2 fails" in done.stdout
    refused = check("chapters", "--chapter", "3", "--given", "2", root=tmp_path / "out")
    assert refused.returncode == 2
    assert "check: chapter 2 cannot be given: its reference is not in this folder" in refused.stderr


def test_a_hand_out_without_the_earlier_chapter_says_what_to_bring(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    make_handout([CH03], [], tmp_path / "out")
    assert "each student must add: ch02_vectors" in capsys.readouterr().out
    done = check("chapters", "--chapter", "3", root=tmp_path / "out")
    assert done.returncode == 2
    wanted = "ch02_vectors is missing: put your own folder of that name beside ch03_laws_of_motion"
    assert done.stderr == f"check: {wanted}\n"


def test_a_helper_that_is_not_handed_in_is_named(engine: Path) -> None:
    (engine / "ch03_laws_of_motion/my_helper.py").touch()
    done = check(engine, "--exercise", "B3.1")
    assert "Not handed in, so nothing may import it: my_helper.py" in done.stdout


@pytest.mark.parametrize(
    ("command", "given", "made"),
    [
        ("plots draw --chapter 3", "2", "ch03_laws_of_motion/trajectories.png"),
        ("lab record ballistics --seconds 0.1", "2-3", "ballistics.gif"),
    ],
)
def test_plots_and_scenes_are_made_on_what_is_given(
    command: str, given: str, made: str, engine: Path, vector: Path, tmp_path: Path
) -> None:
    vector.write_text("class Vector3:\n    pass\n", encoding="utf-8")
    for name in ("ch04_particle_engine", "ch05_forces"):
        copy_tree(ROOT / "solutions" / name, engine / name)
    words = [*command.split(), "--engine", engine, "--out", tmp_path / "out"]
    after = typed(*words, "--given", given, MPLBACKEND="Agg")
    assert after.returncode == 0, after.stdout + after.stderr
    assert (tmp_path / "out" / made).exists()
