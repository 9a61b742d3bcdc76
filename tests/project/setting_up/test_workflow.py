"""The workflow runs commands that exist, on the systems and Pythons that the README promises."""

from __future__ import annotations

import re
import tomllib

import yaml

from autograder.manifest import ROOT

JOBS = yaml.safe_load((ROOT / ".github/workflows/ci.yml").read_text(encoding="utf-8"))["jobs"]
STEPS = [step for job in JOBS.values() for step in job["steps"]]
LINES = [line for step in STEPS for line in step.get("run", "").splitlines()]
PAGES = yaml.safe_load((ROOT / ".github/workflows/pages.yml").read_text(encoding="utf-8"))["jobs"]
COMMANDS = re.findall(r"-m (autograder|plots|lab) (\w+)(.*)", "\n".join(LINES))


def test_it_runs_on_three_systems_with_the_pythons_of_the_readme() -> None:
    linux, students = JOBS["everything"], JOBS["student"]
    systems = [linux["runs-on"], *(s["name"] for s in students["strategy"]["matrix"]["system"])]
    assert [re.sub(r"-[\d.]+$", "", name) for name in systems] == ["ubuntu", "macos", "windows"]
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    promised = re.findall(r"3\.\d+", re.search(r"Python (3\..+?)\. ", readme)[1])
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["requires-python"] == f">={promised[0]}"
    for job in (linux, students):
        assert job["strategy"]["matrix"]["python"] == promised


def test_every_action_is_pinned() -> None:
    steps = [*STEPS, *PAGES["publish"]["steps"]]
    actions = [step["uses"] for step in steps if "uses" in step]
    assert actions
    assert all(re.fullmatch(r"[\w/-]+@v\d+\.\d+\.\d+", action) for action in actions), actions


def test_linux_runs_the_test_command_of_the_readme() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    *_, line = [step["run"] for step in JOBS["everything"]["steps"] if "run" in step]
    assert re.search(rf"(?m)^{line}\b", readme)


def test_the_site_is_published_as_the_make_command_builds_it() -> None:
    steps = PAGES["publish"]["steps"]
    assert {"run": "make site"} in steps
    uploads = [step["with"]["path"] for step in steps if "artifact" in step.get("uses", "")]
    assert uploads == ["build/site"]


def test_students_systems_run_each_of_their_commands_without_make() -> None:
    assert {name for _, name, _ in COMMANDS} == {"check", "hint", "reset", "draw", "record"}
    assert "python autograder/make_venv.py" in LINES
    lines = [step.get("run", "") for step in JOBS["student"]["steps"]]
    assert not re.search(r"(?m)^make", "\n".join(lines))
