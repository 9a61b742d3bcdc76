"""Every command of students takes GIVEN: the reference's chapters, under the student's own."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import pytest

from autograder.manifest import ROOT
from copies import copy_tree
from typed import typed

run = partial(typed, MPLBACKEND="Agg")


@pytest.fixture
def engine(tmp_path: Path) -> str:
    """A student's chapters 3 to 5, on a chapter 2 that cannot be used."""
    for name in ("ch03_laws_of_motion", "ch04_particle_engine", "ch05_forces"):
        copy_tree(ROOT / "solutions" / name, tmp_path / "engine" / name)
    vector = tmp_path / "engine/ch02_vectors/vector.py"
    vector.parent.mkdir()
    vector.write_text("class Vector3:\n    pass\n", encoding="utf-8")
    return str(tmp_path / "engine")


def test_plots_are_drawn_on_what_is_given(engine: str, tmp_path: Path) -> None:
    own = ("plots", "draw", "--engine", engine, "--out", str(tmp_path / "out"), "--chapter", "3")
    before = run(*own)
    assert before.returncode == 1
    assert "not drawn" in before.stdout
    after = run(*own, "--given", "2")
    assert after.returncode == 0, after.stdout + after.stderr
    assert (tmp_path / "out/ch03_laws_of_motion/trajectories.png").exists()


def test_scenes_are_played_on_what_is_given(engine: str, tmp_path: Path) -> None:
    own = ("lab", "record", "ballistics", "--engine", engine, "--seconds", "0.1")
    out = ("--out", str(tmp_path / "out"))
    before = run(*own, *out)
    assert before.returncode != 0
    after = run(*own, *out, "--given", "2-3")
    assert after.returncode == 0, after.stdout + after.stderr
    assert (tmp_path / "out/ballistics.gif").exists()


@pytest.mark.parametrize("command", ["hint", "reset"])
def test_an_exercise_of_a_given_chapter_has_nothing_to_write(command: str) -> None:
    refused = run("autograder", command, "2.5", "--given", "2-3")
    assert refused.returncode == 2
    assert "exercise 2.5 is in chapter 2, which is given" in refused.stderr
    assert refused.stdout == ""


def test_an_exercise_above_what_is_given_has_its_hints() -> None:
    assert (
        run("autograder", "hint", "3.1", "--given", "2").stdout
        == run("autograder", "hint", "3.1").stdout
    )


@pytest.mark.parametrize("command", [("plots", "draw"), ("lab", "record", "ballistics")])
def test_what_cannot_be_given_is_one_sentence(command: tuple[str, ...]) -> None:
    refused = run(*command, "--given", "19")
    assert refused.returncode == 2
    assert "no chapter 19" in refused.stderr
    assert "Traceback" not in refused.stderr
