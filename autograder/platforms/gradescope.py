"""Make the zip for Gradescope, with the grader, the checks and the reference that they need."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Iterator
from pathlib import Path

from autograder.checks.arrange import shared_by_checks
from autograder.course.dates import deadline_to_json
from autograder.course.lateness import for_gradescope
from autograder.course.model import Work
from autograder.files import replace_bytes
from autograder.manifest import ROOT, Chapter, chapters_below
from autograder.platforms.zipped import zipped
from autograder.scores import possible, shown

HIDDEN = "hidden"  # the folder of the hidden checks in the zip
SETTINGS = "assignment.json"
SCRIPTS = ("setup.sh", "run_autograder")


def make_gradescope(work: Work, out: Path, *, unsafe: bool = False) -> None:
    """Write the zip file that an instructor uploads to Gradescope, and print what it contains.

    ``unsafe`` permits grading on a machine that has no sandbox.
    """
    if out.suffix != ".zip" or out.is_dir():
        raise ValueError(f"--out must be a .zip file, got {str(out)!r}")
    if out.exists() and not _is_ours(out):
        raise ValueError(
            f"{out} is another file, such as a download of submissions: give --out a new name "
            "(make: OUT=)"
        )
    if unsafe and work.hidden:
        raise ValueError("without a sandbox, students' code could read the hidden checks")
    chapters, given = work.chapters, work.given
    below = {other.name: other for graded in chapters for other in chapters_below(graded)}
    own = [other for other in below.values() if other not in given]
    # To grade a chapter we do not need its own reference, but the second run needs that of earlier
    # chapters. Without a sandbox the student's code could read it, so then we leave it out.
    reference = [*given] if unsafe else [*given, *own]
    there = {chapter.name: chapter for chapter in [*chapters, *given, *own]}
    files = [*_files(chapters, reference, list(there.values()))]
    exercises = [exercise for chapter in chapters for exercise in chapter.exercises]
    deadline = for_gradescope(work.deadline, work.roster) if work.deadline else None
    settings = {
        "chapters": [chapter.number for chapter in chapters],
        "given": [chapter.number for chapter in given],
        "points": {exercise.id: exercise.points for exercise in exercises},
        "extra": [exercise.id for exercise in exercises if exercise.extra],
        "earlier": dict(work.earlier),
        "deadline": deadline_to_json(deadline) if deadline else None,
        "unsafe": unsafe,
    }
    contents = {file.relative_to(ROOT).as_posix(): file.read_bytes() for file in files}
    if work.hidden:
        for chapter in chapters:
            for file in (work.hidden / chapter.name).glob("*.py"):
                contents[f"{HIDDEN}/{chapter.name}/{file.name}"] = file.read_bytes()
    contents |= {name: (Path(__file__).parent / name).read_bytes() for name in SCRIPTS}
    contents[SETTINGS] = (json.dumps(settings) + "\n").encode()
    replace_bytes(out, zipped(contents, SCRIPTS))
    print(f"graded: {_names(chapters)}")
    if given:
        print(f"given complete: {_names(given)}")
    if reference:
        print(f"with the reference of: {_names(reference)}")
    print(f"points of the assignment, including written answers: {shown(possible(exercises))}")
    print(f"autograder: {out}, {len(contents)} files, {out.stat().st_size:,} bytes")


def _is_ours(out: Path) -> bool:
    try:
        with zipfile.ZipFile(out) as file:
            return {*SCRIPTS, SETTINGS} <= {*file.namelist()}
    except zipfile.BadZipFile:
        return False


def _files(
    chapters: list[Chapter], reference: list[Chapter], there: list[Chapter]
) -> Iterator[Path]:
    """Find the files of this repository that grading needs, with solutions of ``reference``."""
    for name in ("pyproject.toml", "LICENSE"):
        yield ROOT / name
    for name in ("requirements", "teaching"):
        yield ROOT / f"autograder/locks/{name}.lock"
    yield from (ROOT / "autograder").rglob("*.py")
    yield ROOT / "autograder" / "commands.toml"  # to name the next command
    yield from (ROOT / "autograder/reports/templates").iterdir()
    yield from shared_by_checks(ROOT)
    for chapter in chapters:
        yield from (ROOT / "tests" / chapter.name).glob("test_*.py")
        yield from (ROOT / "tests" / chapter.name).glob("*probes.py")
    for chapter in there:
        for name in ("chapter.toml", *chapter.complete):
            yield ROOT / "chapters" / chapter.name / name
    for chapter in reference:
        yield from (ROOT / "solutions" / chapter.name).glob("*.py")


def _names(chapters: list[Chapter]) -> str:
    return ", ".join(chapter.name for chapter in chapters) or "none"
