"""Manage the folder that holds the grading reports on a class.

Only one run of the grader at a time may write to this folder. A file in it records whether the last
run has finished, so that an interrupted run can be resumed.
"""

from __future__ import annotations

import fcntl
import json
import secrets
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from autograder.manifest import ROOT
from autograder.submissions.class_list import ClassList
from autograder.submissions.find import RECORD, Submission, file_name

SAMPLE = (ROOT / "sample_class").resolve()


def seed_of(state: Path, seed: str | None) -> str:
    """Choose the seed for the random numbers in the checks of a class.

    A seed that the instructor has requested takes precedence. Otherwise, an interrupted run keeps
    its seed when it is resumed, and a new run draws one at random.
    """
    if seed:
        return seed
    last = _recorded(state)
    stopped = last.get("seed") if last.get("finished") is False else None
    return stopped if isinstance(stopped, str) else secrets.token_hex(4)


def refuse_dropped(state: Path, *, has_roster: bool, has_checks: bool, is_regrade: bool) -> None:
    """Check that no run drops the roster or the hidden checks with which the class was graded.

    With a roster, the reports use its names for the students. Without one, they use the names of
    the submissions. The first run with a roster therefore has to be one of the whole class.

    Raises:
        ValueError: The roster or the hidden checks are missing, or a regrade has a new roster.
    """
    record = _recorded(state)
    if "roster" not in record:
        return
    had_roster, had_checks = record["roster"], record.get("checks", False)
    if had_roster and not has_roster:
        raise ValueError(
            "the class was graded with a roster: add --roster (make: ROSTER=), or --assignment "
            "(make: ASSIGNMENT=) if the course file names the roster. To grade it without one, add "
            "another --out (make: OUT=)"
        )
    if had_checks and not has_checks:
        raise ValueError(
            "the class was graded with hidden checks: add --checks (make: CHECKS=), or grade it "
            "without them into another --out (make: OUT=)"
        )
    if is_regrade and has_roster and not had_roster:
        raise ValueError("the class was graded without a roster: leave out --roster")


def graded_folder(out: Path) -> Path | None:
    """Return the folder of the class whose grades are in ``out``, or None if there are none."""
    folder = _recorded(out / RECORD).get("folder")
    return Path(folder) if isinstance(folder, str) else None


def refuse_place(out: Path, folder: Path, submissions: Sequence[Submission]) -> None:
    """Check that reports are written neither among submissions nor among files of another kind.

    Raises:
        ValueError: The folder ``out`` is that of the class, in a submission, or neither new nor one
            with grades.
    """
    if out.resolve() == folder.resolve():
        raise ValueError(f"--out must not be the folder of the class, got {str(out)!r}")
    for one in submissions:
        if out.resolve().is_relative_to(one.path.resolve()):
            raise ValueError(
                f"--out must not be inside the submission {one.student!r}, got {str(out)!r}"
            )
    if out.is_dir() and not (out / RECORD).is_file():
        own = sorted(path.name for path in out.iterdir() if not path.name.startswith("."))
        if own:
            raise ValueError(
                f"--out must be a new folder or one with grades, but {out} has other files, such "
                f"as {own[0]}. Name another one (make: OUT=build/other)"
            )


def refuse_other_class(out: Path, people: ClassList, folder: Path, work: dict[str, Any]) -> None:
    """Check that a run does not replace the grades of another class or of another assignment.

    ``work`` has the name of the assignment and the numbers of the graded and of the given chapters.
    The grades of the sample class may be replaced. If the folder of the class is no longer where it
    was, the same students must have handed in.

    Raises:
        ValueError: The folder has other grades.
    """
    before = graded_folder(out)
    if before is None or before == SAMPLE:
        return
    what = advice = ""
    if before != folder.resolve():
        names = {file_name(one.student) for one in people.submissions}
        there = [path.stem for path in (out / "results").glob("*.json")]
        same = sum(name in names for name in there)
        if before.exists() or 2 * same < len(there):
            what = f"the grades of the class in {before}, and not in {folder}"
        if 2 * same > len(there):  # else, marks.csv and times.csv would silently stay behind
            advice = (
                "If this is a newer download of the same work, give it the name of the older one, "
                f"{before.name}, so that marks.csv and times.csv still count. "
            )
    if not what and (earlier := _work_in(out)) and _described(earlier) != _described(work):
        what = f"the grades of {_described(earlier)}, and not of {_described(work)}"
    if what:
        raise ValueError(
            f"{out} has {what}. {advice}To keep them, add another --out (make: OUT=build/other). "
            f"To replace them, rename or delete {out} first"
        )


def _described(work: dict[str, Any]) -> str:
    """Describe what was graded. The chapters of an assignment may change in the course file."""
    coded = " with codes for names" if work["anonymous"] else ""
    if work["assignment"]:
        return f"{work['assignment']}{coded}"
    chapters = f"chapters {', '.join(map(str, work['chapters']))}"
    given = f" on given chapters {', '.join(map(str, work['given']))}" if work["given"] else ""
    return f"{chapters}{given}{coded}"


def _work_in(out: Path) -> dict[str, Any] | None:
    """Return what the last run into this folder has graded, or None if it is not recorded."""
    names = ("assignment", "chapters", "given", "anonymous")
    record = _recorded(out / RECORD)
    return {name: record[name] for name in names} if record.keys() >= {*names} else None


def _recorded(state: Path) -> dict[str, Any]:
    """Read what the last run has recorded, or return an empty dict if there is no valid record."""
    try:
        record = json.loads(state.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return record if isinstance(record, dict) else {}


@contextmanager
def only_run(out: Path) -> Iterator[Path]:
    """Lock the folder of reports, so that no other run of the grader writes to it.

    This context manager creates the folder if necessary. It yields the path of the file that
    records the seed and whether the run has finished.

    Raises:
        ValueError: The path is not a folder, or another run is using it.
    """
    if (out.exists() or out.is_symlink()) and not out.is_dir():
        raise ValueError(f"--out must be a folder, got {str(out)!r}")
    out.mkdir(parents=True, exist_ok=True)
    with (out / ".lock").open("w", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise ValueError(f"another run is grading into {str(out)!r}") from None
        yield out / RECORD


@contextmanager
def temporary_files_in(out: Path) -> Iterator[None]:
    """Keep the temporary files of a grading run inside ``out``, the folder for its reports.

    If a run is killed, it cannot delete its temporary files. The next run finds them there and
    deletes them.
    """
    own, before = out / ".temporary", tempfile.tempdir
    shutil.rmtree(own, ignore_errors=True)
    own.mkdir(mode=0o700, exist_ok=True)
    tempfile.tempdir = str(own.resolve())
    try:
        yield
    finally:
        tempfile.tempdir = before
        shutil.rmtree(own, ignore_errors=True)


def put_others_aside(out: Path, students: list[str]) -> int:
    """Move the reports on students who are not in this class to ``earlier/``.

    Return the number of these students. They may belong to another class, or have left this one.
    """
    names = {file_name(student) for student in students}
    others = set()
    for kind in ("results", "feedback", "gradescope"):
        for path in (out / kind).glob("*"):
            name = path.name if path.is_dir() else path.stem
            if name not in names:
                others.add(name)
                target = out / "earlier" / kind / path.name
                target.parent.mkdir(parents=True, exist_ok=True)
                if target.is_dir():
                    shutil.rmtree(target)
                path.replace(target)
    return len(others)
