"""Manage the folder of reports on a class, with a record of which class was graded, and how."""

from __future__ import annotations

import fcntl
import json
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from autograder.manifest import ROOT
from autograder.submissions.find import RECORD, Submission, file_name

SAMPLE = (ROOT / "sample_class").resolve()


def recorded(out: Path) -> dict[str, Any]:
    """Return what the last run into a folder has recorded, or an empty dict."""
    try:
        record = json.loads((out / RECORD).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return record if isinstance(record, dict) else {}


def graded_folder(out: Path) -> Path | None:
    """Return the folder of the class whose grades are in ``out``, or None if there are none."""
    return _folder_in(recorded(out))


def _folder_in(record: dict[str, Any]) -> Path | None:
    folder = record.get("folder")
    return Path(folder) if isinstance(folder, str) else None


def earlier_choice(out: Path) -> tuple[str, str]:
    """Return the graded and the given chapters of the last run, as on the command line."""
    record = recorded(out)
    if "chapters" not in record:
        raise ValueError(f"{str(out)!r} has no results. It must be a folder of make grade OUT=...")
    return ",".join(map(str, record["chapters"])), ",".join(map(str, record["given"]))


def refuse_place(out: Path, folder: Path, submissions: Sequence[Submission]) -> None:
    """Raise ValueError if reports would be among submissions or among files of another kind."""
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


def refuse_other_grades(out: Path, old: dict[str, Any], new: dict[str, Any]) -> None:
    """Raise ValueError if ``out`` has the grades of another class or of another assignment."""
    before, folder = _folder_in(old), Path(new["folder"])
    if before is None or before == SAMPLE:
        return
    what = advice = ""
    if before != folder:
        what = f"the grades of the class in {before}, and not in {folder}"
        advice = (  # otherwise, marks.csv and times.csv would silently stay behind
            "If this is a newer download of the same work, give it the name of the older one, "
            f"{before.name}, so that marks.csv and times.csv still count. "
        )
    elif "chapters" in old and _described(old) != _described(new):
        what = f"the grades of {_described(old)}, and not of {_described(new)}"
    if what:
        raise ValueError(
            f"{out} has {what}. {advice}To keep them, add another --out (make: OUT=build/other). "
            f"To replace them, rename or delete {out} first"
        )


def _described(record: dict[str, Any]) -> str:
    """Describe what was graded. The chapters of an assignment may change in the course file."""
    if record["assignment"]:
        return str(record["assignment"])
    chapters = f"chapters {', '.join(map(str, record['chapters']))}"
    given = f" on given chapters {', '.join(map(str, record['given']))}" if record["given"] else ""
    return f"{chapters}{given}"


def refuse_dropped(old: dict[str, Any], new: dict[str, Any], *, is_regrade: bool) -> None:
    """Raise ValueError if a run drops the roster or hidden checks, or a regrade has new ones."""
    for key, what in (("roster", "a roster"), ("checks", "hidden checks")):
        option = f"--{key} (make: {key.upper()}=)"
        if old.get(key) and not new[key]:
            raise ValueError(
                f"the class was graded with {what}: add {option} or the --assignment (make: "
                "ASSIGNMENT=) that names it. To grade without, add another --out (make: OUT=)"
            )
        if is_regrade and new[key] and not old.get(key):
            raise ValueError(f"the class was graded without {what}: leave out {option}")


@contextmanager
def only_run(out: Path) -> Iterator[None]:
    """Create the folder of reports, and lock it so that no other run of the grader writes to it."""
    if (out.exists() or out.is_symlink()) and not out.is_dir():
        raise ValueError(f"--out must be a folder, got {str(out)!r}")
    out.mkdir(parents=True, exist_ok=True)
    with (out / ".lock").open("w", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise ValueError(f"another run is grading into {str(out)!r}") from None
        yield


@contextmanager
def temporary_files_in(out: Path) -> Iterator[None]:
    """Keep the temporary files of a run inside ``out``, where the next run deletes leftovers."""
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
    """Move the reports on students who are not in this class to ``earlier/``, and count them."""
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
