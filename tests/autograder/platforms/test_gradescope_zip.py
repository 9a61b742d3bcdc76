"""The zip for Gradescope, run in a tree laid out as its container is."""

from __future__ import annotations

import json
import os
import re
import shutil
import stat
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from autograder.course.model import Work
from autograder.isolation import probe
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT, load_chapters
from autograder.platforms.grade_one import main
from autograder.platforms.gradescope import make_gradescope
from graded import points_of
from made import made_stubs
from typed import typed
from walls import behind_walls

SCHEMA = json.loads(Path(__file__).with_name("gradescope.schema.json").read_text(encoding="utf-8"))
CH02, CH03 = load_chapters()[:2]
WALLS = Level(**behind_walls().level).is_sandbox
NO_ZERO = "this is not the submission's fault and does not count as zero"

pytestmark = pytest.mark.skipif(
    shutil.which("timeout") is None, reason="the zip's script calls timeout"
)


def make(out: Path, *arguments: str) -> Path:
    """Make a zip by the command, for what the walls of this machine allow."""
    unsafe = [] if WALLS else ["--unsafe-no-sandbox"]
    done = typed("autograder", "gradescope", *arguments, "--out", out, *unsafe)
    assert str(out) in done.stdout, done.stderr
    return out


@pytest.fixture(scope="module")
def zipped(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make(tmp_path_factory.mktemp("zip") / "autograder.zip", "2-3")


def test_the_zip_has_the_lock_that_its_setup_installs(zipped: Path) -> None:
    """Grading needs more packages than a student's own checks."""
    with zipfile.ZipFile(zipped) as file:
        (group,) = re.findall(r"make_venv\.py (\w+)", file.read("setup.sh").decode())
        lock = file.read(f"autograder/locks/{group}.lock").decode()
    assert {"msgspec", "pytest", "rich"} <= {*re.findall(r"(?m)^([a-z0-9-]+)==", lock)}


@pytest.fixture
def tree(zipped: Path, tmp_path: Path) -> Path:
    """The container's folder, before anything is handed in."""
    root = tmp_path / "autograder"
    with zipfile.ZipFile(zipped) as file:
        for entry in file.infolist():
            path = Path(file.extract(entry, root / "source"))
            path.chmod(entry.external_attr >> 16)
    (root / "submission").mkdir()
    users = {"users": [{"id": 1, "name": "Ann Ax", "email": "ann@example.org"}]}
    (root / "submission_metadata.json").write_text(json.dumps(users), encoding="utf-8")
    return root


def hand_in(tree: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        path = tree / "submission" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def answers_of(folder: str) -> dict[str, str]:
    """Return the modules of both chapters in a folder of this repository."""
    return {
        f"{chapter.name}/{file.name}": file.read_text(encoding="utf-8")
        for chapter in (CH02, CH03)
        for file in (ROOT / folder / chapter.name).glob("*.py")
    }


def run(tree: Path, python: str = sys.executable) -> tuple[dict[str, Any], str]:
    """Run the submission as the harness does; return the results and what was printed."""
    environment = os.environ | {"AUTOGRADER_ROOT": str(tree), "AUTOGRADER_PYTHON": python}
    environment.pop("PYTHONPATH", None)
    done = subprocess.run(
        [str(tree / "source/run_autograder")],
        cwd=tree,
        env=environment,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert [path.name for path in (tree / "results").iterdir()] == ["results.json"]
    results = json.loads((tree / "results/results.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator(SCHEMA).validate(results)
    return results, done.stdout + done.stderr


def test_a_right_submission_gets_every_point_and_stubs_none(tree: Path) -> None:
    stubs = {path.removeprefix("chapters/"): text for path, text in made_stubs().items()}
    seeds = set()
    for files, score, status in (
        (answers_of("sample_class/ada"), points_of(CH02, CH03), "passed"),
        (stubs, 0, "failed"),
    ):
        hand_in(tree, files)
        results, printed = run(tree)
        assert results["score"] == score
        everything = sum(e.points for chapter in (CH02, CH03) for e in chapter.exercises)
        assert sum(test["max_score"] for test in results["tests"]) == everything
        assert {test["status"] for test in results["tests"] if "score" in test} == {status}
        assert "grading Ann Ax, seed" in printed
        seeds |= {*re.findall(r"(?m)^seed: ([0-9a-f]{8})$", results["output"])}
        shutil.rmtree(tree / "submission")
    assert len(seeds) == 2, "each run draws its own"


@pytest.mark.skipif(not WALLS, reason="without a sandbox the zip has no reference")
def test_a_mistake_of_an_earlier_chapter_is_told_from_one_of_this(tree: Path) -> None:
    """The zip has the reference that the second run needs."""
    answers = answers_of("solutions")
    vector = answers["ch02_vectors/vector.py"]
    answers["ch02_vectors/vector.py"] = vector.replace("return self.x * self.x +", "return")
    assert answers["ch02_vectors/vector.py"] != vector
    hand_in(tree, answers)
    results, _ = run(tree)
    assert 0 < results["score"] < points_of(CH02, CH03)
    statuses = {test["number"]: test["output"].partition(":")[0] for test in results["tests"]}
    assert statuses["B2.2"] == "failed"
    late = {status for number, status in statuses.items() if re.match(r"\D?3\.", number)}
    assert late == {"passed", "inherited"}


@pytest.mark.skipif(not WALLS, reason="without a sandbox the zip has no reference")
def test_student_code_cannot_read_the_reference_beside_it(tree: Path) -> None:
    secret = tree / "source/solutions/ch02_vectors/vector.py"
    assert "class Vector3" in secret.read_text(encoding="utf-8")
    spy = f"raise RuntimeError(open({str(secret)!r}).read())"
    hand_in(tree, {"ch03_laws_of_motion/particle.py": spy})
    results, printed = run(tree)
    assert results["score"] == 0, "the module that spies fails"
    assert "PermissionError" in json.dumps(results)
    assert "class Vector3" not in json.dumps(results) + printed


def test_nothing_of_the_chapters_is_a_zero_that_says_what_was_looked_for(tree: Path) -> None:
    hand_in(tree, {"notes/thoughts.txt": "?"})
    (tree / "submission_metadata.json").unlink()
    results, printed = run(tree)
    assert results["score"] == 0
    assert "nothing to grade: no folder of a chapter was found" in results["output"]
    assert "that contains folders of chapters: ch02_vectors/vector.py, " in results["output"]
    hand_in(tree, {"vector.py": ""})  # the file alone, without its folder
    results, printed = run(tree)
    assert results["score"] == 0
    assert "vector.py was found at the top of what was handed in, and not" in results["output"]
    assert "grading submission, seed" in printed


@pytest.mark.parametrize(
    ("missing", "script", "sentence"),
    [
        ("submission", "", "there is no folder"),
        ("source/assignment.json", "", "assignment.json"),
        ("source/tests/ch02_vectors", "", "isolation"),
        ("source/autograder", "", "the grader stopped with status 1"),
        ("the Python", "", "there is no Python to grade with"),
        ("", "echo '{\"score\": 81'; exit 3", "the grader stopped with status 3"),
        ("", "echo '{\"score\": 81}'; exit 124", "the run did not finish within 540 seconds"),
        ("", "echo '{\"score\": 81}'; kill -9 $$", "the run did not finish"),  # time, or memory
    ],
)
def test_where_the_grader_does_not_come_to_its_end_nothing_it_said_counts(
    tree: Path, missing: str, script: str, sentence: str
) -> None:
    hand_in(tree, {"ch02_vectors/vector.py": ""})
    (tree / "results").mkdir()
    (tree / "results/results.json").write_text('{"score": 81}', encoding="utf-8")
    python, broken = tree.parent / "python", tree / missing
    if script:
        python.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
        python.chmod(0o755)
    elif broken.exists():
        python = Path(sys.executable)
        shutil.rmtree(broken) if broken.is_dir() else broken.unlink()
    results, printed = run(tree, str(python))
    assert "score" not in results
    assert NO_ZERO in results["output"]
    assert sentence in results["output"]
    assert not script or f"not graded: {sentence}" in printed


def test_without_a_wall_nothing_is_graded_and_the_results_say_why(
    tree: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    settings = tree / "source/assignment.json"
    text = settings.read_text(encoding="utf-8").replace("true", "false")
    settings.write_text(text, encoding="utf-8")
    monkeypatch.setattr(probe, "best_level", Level)
    main(tree, tree / "source")
    results = json.loads(capsys.readouterr().out)
    jsonschema.Draft202012Validator(SCHEMA).validate(results)
    assert "score" not in results
    assert NO_ZERO in results["output"]
    assert "this machine has no sandbox" in results["output"]
    assert "--unsafe-no-sandbox" in results["output"]


def test_the_zip_is_of_the_documented_layout_and_the_same_each_time(
    zipped: Path, tmp_path: Path
) -> None:
    again = make(tmp_path / "again.zip", "2-3")
    assert again.read_bytes() == zipped.read_bytes()
    with zipfile.ZipFile(zipped) as file:
        modes = {entry.filename: entry.external_attr >> 16 for entry in file.infolist()}
        dates = {entry.date_time for entry in file.infolist()}
        contents = {name: file.read(name) for name in modes}
    assert len(dates) == 1, "not that of the files here, which differ from one clone to another"
    scripts = {"setup.sh", "run_autograder"}
    assert {name for name, mode in modes.items() if mode & stat.S_IXUSR} == scripts
    assert all(mode & stat.S_IROTH for mode in modes.values()), "a dropped root reads them"
    for name in scripts:
        assert contents[name].startswith(b"#!/")
    for name, content in contents.items():
        assert str(ROOT).encode() not in content, name
    parts = {part for name in modes for part in name.split("/")}
    assert parts.isdisjoint({"__pycache__", "second", "wrong.toml", ".venv", "sample_class"})


@pytest.mark.parametrize(
    ("chapters", "given", "unsafe", "reference", "checks"),
    [
        ([CH02], [], False, set(), {CH02.name}),
        ([CH02, CH03], [], False, {CH02.name}, {CH02.name, CH03.name}),
        ([CH03], [], False, {CH02.name}, {CH03.name}),
        ([CH03], [], True, set(), {CH03.name}),
        ([CH03], [CH02], True, {CH02.name}, {CH03.name}),
    ],
)
def test_only_the_reference_that_is_needed_goes_along(
    tmp_path: Path,
    chapters: list[Any],
    given: list[Any],
    unsafe: bool,
    reference: set[str],
    checks: set[str],
) -> None:
    make_gradescope(Work("", chapters, given), tmp_path / "a.zip", unsafe=unsafe)
    with zipfile.ZipFile(tmp_path / "a.zip") as file:
        names = {"/".join(name.split("/")[:2]) for name in file.namelist()}
    assert {name[10:] for name in names if name.startswith("solutions/")} == reference
    assert {name[6:] for name in names if re.match(r"tests/ch\d\d_\w+$", name)} == checks
    there = {chapter.name for chapter in chapters} | {CH02.name}
    assert {name[9:] for name in names if name.startswith("chapters/")} == there


def test_what_is_no_zip_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"--out must be a \.zip file, got"):
        make_gradescope(Work("", [CH02]), tmp_path / "out")
