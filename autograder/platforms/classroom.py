"""Make a handout for GitHub Classroom, which grades a student's work on every push."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import yaml  # type: ignore[import-untyped]

from autograder.course.points import rescaled
from autograder.handouts.handout import make_handout
from autograder.manifest import Chapter, Exercise
from autograder.scores import extra_possible, possible, shown

WORKFLOW = ".github/workflows/classroom.yml"  # where GitHub Classroom looks for it
GRADER = "classroom-resources/autograding-command-grader@v1"
REPORTER = "classroom-resources/autograding-grading-reporter@v1"
MINUTES = 10  # a generous limit, since the set-up takes a minute and each exercise only seconds


def make_classroom(
    chapters: list[Chapter], given: list[Chapter], out: Path, about: str = ""
) -> None:
    """Write a handout, with a workflow that grades every push, to the new folder ``out``."""
    make_handout(chapters, given, out, about=about)
    chapters = in_whole_points(chapters)
    path = out / WORKFLOW
    path.parent.mkdir(parents=True)
    text = yaml.safe_dump(workflow(chapters), sort_keys=False, width=100)
    path.write_text(text, encoding="utf-8", newline="\n")
    exercises = _checked(chapters)
    points = sum(exercise.points for exercise in exercises)
    extra = extra_possible(exercises)
    of_these = f", {shown(extra)} of them as extra credit" if extra else ""
    print(f"workflow: {path}, {len(exercises)} exercises, {points} points{of_these}")


def workflow(chapters: list[Chapter]) -> dict[str, Any]:
    """Create the workflow, with a step for each exercise, and one that reports the points."""
    python = {"python-version": "3.14", "cache": "pip"}
    python["cache-dependency-path"] = "autograder/locks/requirements.lock"
    steps: list[dict[str, Any]] = [
        {"uses": "actions/checkout@v4"},
        {"uses": "actions/setup-python@v5", "with": python},
        # The set-up inside the grader is silent, so errors must appear here.
        {"name": "Set up", "run": "make setup"},
    ]
    ids = []
    for exercise in _checked(chapters):
        title = f"{exercise.id} {exercise.title}"
        ids.append(f"exercise{exercise.id.replace('.', 'dot')}")
        graded = {
            "test-name": title,
            "setup-command": "make setup",
            "command": f".venv/bin/python -m autograder check --exercise {exercise.id} --only",
            "timeout": MINUTES,
            "max-score": exercise.points,
        }
        steps.append({"name": title, "id": ids[-1], "uses": GRADER, "with": graded})
    points = {f"{name.upper()}_RESULTS": f"${{{{steps.{name}.outputs.result}}}}" for name in ids}
    reported = {"runners": ",".join(ids)}
    steps.append({"name": "Report", "uses": REPORTER, "env": points, "with": reported})
    unless = "github.actor != 'github-classroom[bot]'"
    return {
        "name": "Autograding Tests",
        "on": ["push", "repository_dispatch"],
        "permissions": {"checks": "write", "actions": "read", "contents": "read"},
        "jobs": {"autograding": {"runs-on": "ubuntu-latest", "if": unless, "steps": steps}},
    }


def in_whole_points(chapters: list[Chapter]) -> list[Chapter]:
    """Round the points of all exercises to whole numbers of at least 1, as GitHub wants them."""
    exercises = [exercise for chapter in chapters for exercise in chapter.exercises]
    counted = {e.id: e.points for e in exercises if not e.extra}
    whole = rescaled(counted, round(possible(exercises)), unit="1")
    whole |= {e.id: round(e.points) for e in exercises if e.extra}
    return [
        replace(c, exercises=[replace(e, points=max(1, whole[e.id])) for e in c.exercises])
        for c in chapters
    ]


def rounded_points(chapters: list[Chapter]) -> dict[str, float]:
    """Return the whole points of the exercises that GitHub grades, if any points were rounded."""
    before = {exercise.id: exercise.points for exercise in _checked(chapters)}
    after = {exercise.id: exercise.points for exercise in _checked(in_whole_points(chapters))}
    return {} if before == after else after


def _checked(chapters: list[Chapter]) -> list[Exercise]:
    """List the exercises that GitHub can grade, which are all but the written ones."""
    return [e for chapter in chapters for e in chapter.exercises if e.kind != "written"]
