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
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from autograder.manifest import ROOT
from autograder.submissions.class_list import ClassList
from autograder.submissions.find import RECORD, file_name

SAMPLE = (ROOT / "sample_class").resolve()


def seed_of(state: Path, seed: str | None) -> str:
    """Choose the seed for the random numbers in the checks of a class.

    A seed that the instructor has requested takes precedence. Otherwise, an interrupted run keeps
    its seed when it is resumed, and a new run draws one at random.
    """
    if seed:
        return seed
    try:
        last = json.loads(state.read_text(encoding="utf-8"))
        if last["finished"] is False and isinstance(last["seed"], str):
            return last["seed"]
    except (OSError, ValueError, KeyError, TypeError):
        pass  # no run was stopped here
    return secrets.token_hex(4)


def refuse_other_roster(state: Path, *, has_roster: bool) -> None:
    """Check that a regrade uses a roster if and only if the class was graded with one.

    With a roster, the reports use its names for the students. Without one, they use the names of
    the submissions. If only one of the two runs had a roster, the same student could be listed
    twice.

    Raises:
        ValueError: Only one of the two runs uses a roster.
    """
    try:
        before = json.loads(state.read_text(encoding="utf-8"))["roster"]
    except (OSError, ValueError, KeyError, TypeError):
        return  # no run, or one that did not record it
    if before and not has_roster:
        raise ValueError(
            "the class was graded with a roster: add --roster (make: ROSTER=), or --assignment "
            "(make: ASSIGNMENT=) if the course file names the roster"
        )
    if has_roster and not before:
        raise ValueError("the class was graded without a roster: leave out --roster")


def graded_folder(out: Path) -> Path | None:
    """Return the folder of the class whose grades are in ``out``, or None if there are none."""
    folder = _recorded(out, "folder")
    return Path(folder) if folder else None


def refuse_other_class(out: Path, people: ClassList, folder: Path, assignment: str) -> None:
    """Check that a run does not replace the grades of another class or of another assignment.

    The grades of the sample class may be replaced. If the folder of the class is no longer where it
    was, the same students must have handed in.

    Raises:
        ValueError: The folder has other grades.
    """
    before, earlier = graded_folder(out), _recorded(out, "assignment")
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
    elif assignment != earlier:
        what = f"the grades of {earlier or 'whole chapters'}, and not of {assignment or 'these'}"
    if what:
        raise ValueError(
            f"{out} has {what}. {advice}To keep them, add another --out (make: OUT=build/other). "
            f"To replace them, rename or delete {out} first"
        )


def _recorded(out: Path, name: str) -> str:
    """Return what the last run into this folder has recorded, or "" if there is nothing."""
    try:
        value = json.loads((out / RECORD).read_text(encoding="utf-8"))[name]
    except (OSError, ValueError, KeyError, TypeError):
        return ""
    return value if isinstance(value, str) else ""


@contextmanager
def only_run(out: Path) -> Iterator[Path]:
    """Lock the folder of reports, so that no other run of the grader writes to it.

    This context manager creates the folder if necessary. It yields the path of the file that
    records the seed and whether the run has finished.

    Raises:
        ValueError: The path is not a folder, or another run is using it.
    """
    if out.exists() and not out.is_dir():
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
