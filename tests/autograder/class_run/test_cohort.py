"""A run over a class of the small chapter, and the next run into the same folder."""

from __future__ import annotations

import json
import os
import shutil
import zipfile
from pathlib import Path
from typing import Any

import pytest

from autograder.grader import cohort, grading
from autograder.grader.reports_folder import SAMPLE, only_run
from autograder.isolation import probe
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT
from killed import MARK, survivors
from small import RIGHT
from small_class import HALF, SmallClass, everything_in, grade, interrupt, results


def test_a_finished_run_is_followed_by_one_with_a_new_seed(small: SmallClass) -> None:
    seeds = []
    for _ in range(2):
        small.grade(None)
        seeds.append({report["seed"] for report in small.results().values()})
    (first,), (second,) = seeds
    assert first != second
    assert json.loads(small.text("run.json")) == {
        **{"seed": second, "finished": True, "roster": False, "checks": False},
        **{"folder": str(small.folder), "assignment": "", "chapters": [90], "given": []},
    }


def test_an_interrupted_run_keeps_its_seed_and_grades_only_what_is_new(
    small: SmallClass, monkeypatch: pytest.MonkeyPatch
) -> None:
    def killed(*_: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as context:
        context.setattr(cohort, "write_class", killed)
        with pytest.raises(KeyboardInterrupt):
            small.grade(None)
    first = small.results()
    seed = first["ann"]["seed"]
    small.write("bob/ch90_small/small.py", RIGHT)
    small.hand_in("dee", HALF)
    small.printed()
    small.grade(None)
    printed = small.printed()
    assert printed.startswith("Grading 4 students ... ")
    assert "2 of 4 reports were kept from an earlier run." in printed
    second = small.results()
    assert first["ann"] == second["ann"], "down to the seconds that it took"
    assert small.scores() == {"ann": 6.0, "bob": 6.0, "cem": 6.0, "dee": 5.0}
    assert {report["seed"] for report in second.values()} == {seed}
    other = small.place / "other"
    other.mkdir()
    record = {"folder": str(SAMPLE), "seed": seed, "finished": False}
    (other / "run.json").write_text(json.dumps(record), encoding="utf-8")
    grade(small.folder, other, small.root, None)
    assert results(other)["ann"]["seed"] != seed, "that of the sample class is no secret"


@pytest.mark.parametrize("change", ["seed", "checks", "complete module", "error", "cut off"])
def test_what_no_longer_holds_is_graded_again(small: SmallClass, change: str) -> None:
    small.grade()
    path = small.out / "results/bob.json"
    report = small.results()["bob"] | {"seconds": -1}
    seed = "1"
    match change:
        case "seed":
            seed = "2"
        case "checks":
            checks = small.root / "tests/ch90_small/test_small.py"
            checks.write_text(checks.read_text(encoding="utf-8") + "\n# new\n", encoding="utf-8")
        case "complete module":
            (small.root / "chapters/ch90_small/given.py").write_text("x = 1\n", encoding="utf-8")
        case "error":
            report["status"] = "error, retry"
    text = json.dumps(report)
    path.write_text(text[:-20] if change == "cut off" else text, encoding="utf-8")
    small.grade(seed)
    assert small.results()["bob"]["seconds"] > 0
    assert small.results()["bob"]["seed"] == seed


def test_a_run_that_is_interrupted_stops_at_once_and_leaves_what_is_complete(
    tmp_path: Path,
) -> None:
    (tmp_path / "tmp").mkdir()
    mark = os.urandom(8).hex()
    interrupt(tmp_path / "out", "--jobs", "2", TMPDIR=str(tmp_path / "tmp"), **{MARK: mark})
    assert survivors(mark) == []
    assert list((tmp_path / "tmp").iterdir()) == []


def test_reports_of_others_are_moved_aside_and_not_lost(small: SmallClass) -> None:
    small.grade()
    shutil.rmtree(small.folder / "bob")
    small.grade()
    assert sorted(small.scores()) == ["ann", "cem"]
    assert "bob" not in everything_in(small.out / "feedback")
    assert "bob" not in small.text("index.html")
    for name in ("results/bob.json", "feedback/bob.html", "gradescope/bob/results.json"):
        assert not (small.out / name).exists()
        assert (small.out / "earlier" / name).exists()
    assert "Reports of students outside this class: 1, moved to " in small.printed()


def test_what_has_nothing_to_grade_is_explained_to_everybody_and_no_zero(small: SmallClass) -> None:
    (small.folder / "eve/chapter 90").mkdir(parents=True)
    with zipfile.ZipFile(small.folder / "dee.zip", "w") as zipped:
        zipped.writestr("small.py", RIGHT)
    small.grade()
    of_dee = (
        "'dee.zip': small.py was found at the top of what was handed in, and not in a folder "
        "ch90_small. Put it into a folder ch90_small and hand in again"
    )
    of_eve = "no folder of a chapter was found, at most three levels down"
    screen = small.printed()
    for student, why in (("dee", of_dee), ("eve", of_eve)):
        report = small.results()[student]
        assert (report["status"], report["nothing"]) == ("nothing to grade", why)
        assert small.scores()[student] is None, "which is no zero"
        for name in (f"feedback/{student}.html", f"gradescope/{student}/results.json"):
            text = small.text(name)
            assert why.partition(": ")[2] in text
            assert "ch90_small/" in text, "what to hand in"
        assert f"{student}: {why}" in screen
    how = "Hand in a folder or a zip file that contains folders of chapters: ch90_small/small.py"
    assert small.results()["eve"]["notes"] == [how]


def test_two_runs_do_not_share_a_folder(small: SmallClass) -> None:
    with only_run(small.out), pytest.raises(ValueError, match="another run is grading into"):
        small.grade()
    assert small.grade() == 0


def test_after_an_error_the_same_command_grades_that_student_alone(
    small: SmallClass, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = grading.stage

    def fails(path: Path, *arguments: Any) -> Any:
        if path.name == "bob":
            raise OSError("the disk is full")
        return real(path, *arguments)

    with monkeypatch.context() as context:
        context.setattr(grading, "stage", fails)
        assert small.grade(None) == 1
    before = small.results()
    assert before["bob"]["status"] == "error, retry"
    assert small.grade(None) == 0
    after = small.results()
    assert (after["ann"], after["cem"]) == (before["ann"], before["cem"])
    assert after["bob"]["score"] == 5.0
    assert small.grade(None) == 0
    assert small.results()["bob"]["seed"] != before["bob"]["seed"], "now the run is finished"


def test_without_a_wall_only_the_sample_class_is_graded(
    small: SmallClass, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(probe, "best_level", Level)
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    with pytest.raises(ValueError, match=r"no sandbox for submissions .* add --unsafe-no-sandbox"):
        probe.choose_level(small.folder, unsafe=False)
    assert not probe.choose_level(ROOT / "sample_class", unsafe=False).is_sandbox
    assert not probe.choose_level(small.folder, unsafe=True).is_sandbox
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    with pytest.raises(ValueError, match="without one, student code never runs as root"):
        probe.choose_level(small.folder, unsafe=True)
    wall = Level(landlock=True, seccomp=True)
    monkeypatch.setattr(probe, "best_level", lambda: wall)
    assert probe.choose_level(small.folder, unsafe=False) == wall
