"""The workflow for GitHub Classroom: each exercise once, and what the documented form wants."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.platforms.classroom import WORKFLOW, make_classroom, workflow
from graded import points_of
from typed import typed

CHAPTERS = load_chapters()
CH02 = CHAPTERS[0]


@pytest.fixture(scope="module")
def handout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("classroom") / "out"
    make_classroom([CH02], [], out)
    return out


@pytest.fixture(scope="module")
def job(handout: Path) -> dict[str, Any]:
    text = (handout / WORKFLOW).read_text(encoding="utf-8")
    found: dict[str, Any] = yaml.safe_load(text)
    assert found["on"] == ["push", "repository_dispatch"], "and no yes, which YAML takes on for"
    assert found["permissions"] == {"checks": "write", "actions": "read", "contents": "read"}
    assert list(found["jobs"]) == ["autograding"]
    return dict(found["jobs"]["autograding"])


def graded(steps: list[dict[str, Any]]) -> list[dict[str, Any]]:
    wanted = "classroom-resources/autograding-command-grader@v1"
    return [step for step in steps if step.get("uses") == wanted]


def test_the_job_is_of_the_documented_form_with_each_exercise_once(job: dict[str, Any]) -> None:
    assert job["if"] == "github.actor != 'github-classroom[bot]'"
    first, *_, last = job["steps"]
    assert first["uses"].startswith("actions/checkout@")
    assert last["uses"] == "classroom-resources/autograding-grading-reporter@v1"
    steps = graded(job["steps"])
    for step in steps:
        wanted = {"test-name", "setup-command", "command", "timeout", "max-score"}
        assert step["with"].keys() == wanted
        assert step["with"]["timeout"] > 0
    names = [step["with"]["test-name"].split()[0] for step in steps]
    assert names == [e.id for e in CH02.exercises if e.id not in {"2.2b", "2.3"}]  # written
    assert sum(step["with"]["max-score"] for step in steps) == points_of(CH02)


@pytest.mark.parametrize("chapters", [[CH02], CHAPTERS], ids=["one", "all"])
def test_the_reporter_is_told_of_every_step_by_an_id_that_it_takes(chapters: list[Chapter]) -> None:
    steps = workflow(chapters)["jobs"]["autograding"]["steps"]
    ids = [step["id"] for step in graded(steps)]
    report = steps[-1]
    runners = report["with"]["runners"]
    assert re.fullmatch(r"([a-zA-Z0-9]+,)*[a-zA-Z0-9]+", runners), "the reporter's own pattern"
    assert runners.split(",") == ids
    assert all(re.match("[a-zA-Z]", name) for name in ids)
    variables = [f"{name.upper()}_RESULTS" for name in ids]
    assert len(set(variables)) == len(variables)
    results = [f"${{{{steps.{name}.outputs.result}}}}" for name in ids]
    assert report["env"] == dict(zip(variables, results, strict=True))


def run(handout: Path, step: dict[str, Any]) -> subprocess.CompletedProcess[str]:
    """Run a step's command in the handout, with this Python in place of its own."""
    python, *arguments = shlex.split(step["with"]["command"])
    assert python == ".venv/bin/python"
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    return subprocess.run(
        [sys.executable, *arguments],
        cwd=handout,
        env=environment | {"PYTHONUTF8": "1"},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )


def test_an_exercise_gets_its_points_for_its_own_checks_alone(
    handout: Path, job: dict[str, Any], tmp_path: Path
) -> None:
    """B2.10 needs B2.9, and a right one earns its points beside a wrong cross_update."""
    out = tmp_path / "out"
    shutil.copytree(handout, out)
    steps = {step["with"]["test-name"].split()[0]: step for step in graded(job["steps"])}
    assert "B2.9" in CH02.exercise("B2.10").needs
    assert run(out, steps["B2.10"]).returncode == 1, "a stub"
    solved = (ROOT / "solutions/ch02_vectors/vector.py").read_text(encoding="utf-8")
    head, name, body = solved.partition("def cross_update")
    assert name
    wrong = f"{head}{name}{body.replace('self.x', 'self.y', 1)}"
    assert wrong != solved
    (out / "chapters/ch02_vectors/vector.py").write_text(wrong, encoding="utf-8")
    passed = run(out, steps["B2.10"])
    assert passed.returncode == 0, passed.stdout
    assert " B2.9 " not in passed.stdout, "what does not decide is not shown"
    assert run(out, steps["B2.9"]).returncode == 1
    with_needs = typed("autograder", "check", "--exercise", "B2.10", cwd=out)
    assert with_needs.returncode == 1, "without --only, what it builds on must pass too"
