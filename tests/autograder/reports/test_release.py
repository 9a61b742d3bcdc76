"""The reference is released, whole or in part, and not before the last due date."""

from __future__ import annotations

from pathlib import Path

import pytest

from autograder.handouts.release import chosen, release, released_module
from autograder.manifest import ROOT, load_chapters
from small import RIGHT
from typed import typed

CH02 = load_chapters()[0]


def test_exercises_alone_are_released_without_the_others() -> None:
    picked = chosen(load_chapters()[:2], ["2.5", "b2.3"])
    assert [exercise.id for chapter in picked for exercise in chapter.exercises] == ["B2.3", "2.5"]
    text = released_module(picked[0], CH02, "exercises.py")
    assert "math.acos(" in text
    assert 'NotImplementedError("Exercise 2.6' in text
    with pytest.raises(ValueError, match=r"there is no exercise '2\.99' in chapter 2"):
        chosen([CH02], ["2.99"])


def test_model_answers_come_without_their_rubrics(tmp_path: Path) -> None:
    release([CH02], ["2.2b"], tmp_path / "out")
    (file,) = (tmp_path / "out/reference/ch02_vectors").iterdir()
    text = file.read_text(encoding="utf-8")
    assert "A length is never negative." in text
    assert "squared_magnitude" not in text, "2.3 is not released"
    assert "0.5 points" not in text


def test_a_folder_that_would_lose_or_leak_something_is_refused(root: Path, tmp_path: Path) -> None:
    full, out, chapters = tmp_path / "full", tmp_path / "out", load_chapters(root)
    full.mkdir()
    (full / "reference").write_text("mine", encoding="utf-8")
    for place, complaint in (
        (full, "--out must be a new folder or an earlier release"),
        (root / "lab/scenes", "so that no handout contains it"),
    ):
        with pytest.raises(ValueError, match=complaint):
            release(chapters, [], place, root)
    assert (full / "reference").read_text(encoding="utf-8") == "mine"
    for _ in range(2):  # again into the folder of an earlier release
        release(chapters, [], out, root)
    assert (out / "reference/ch90_small/small.py").read_text(encoding="utf-8") == RIGHT


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--assignment", "lab2"], "lab2 is due 2999-01-01 12:00 UTC, counting extensions"),
        (["--assignment", "lab1", "--exercises", "B2.1,2.3"], "2.3 must wait"),
        (["2"], "lab2 is due"),  # without an assignment, the course file still counts
        (["2", "--exercises", "b2.3"], "lab3 is due"),
        (["--assignment", "lab1"], ""),
        (["2", "--exercises", "B2.1,B2.2"], ""),
    ],
)
def test_an_exercise_waits_for_every_assignment_that_contains_it(
    arguments: list[str], words: str, tmp_path: Path
) -> None:
    past, coming = "2020-01-01T12:00:00+00:00", "2999-01-01T12:00:00+00:00"
    labs = (
        ("lab1", ["B2.1"], past),
        ("lab2", ["2.3"], f"{past}\nextensions = {{ ann = {coming} }}"),
        ("lab0", ["B2.3"], past),
        ("lab3", ["B2.3"], coming),
    )
    course = [f'[[assignment]]\nname = "{n}"\nexercises = {i}\ndue = {due}\n' for n, i, due in labs]
    (tmp_path / "course.toml").write_text("\n".join(course), encoding="utf-8")
    command = ("autograder", "release", *arguments, "--out", "out")
    done = typed(*command, cwd=tmp_path, PYTHONPATH=str(ROOT))
    assert words in done.stderr
    assert (done.returncode, (tmp_path / "out").exists()) == ((2, False) if words else (0, True))
    if not words:
        module = (tmp_path / "out/reference/ch02_vectors/vector.py").read_text(encoding="utf-8")
        assert "return Vector3(self.x, self.y, self.z)" in module
        stub = "Exercise B2.2: Length" in module
        assert stub == ("lab1" in arguments), "what is not assigned stays a stub"
