"""Find out when each student of a class handed in the work.

The times come from files that accompany the submissions. The modification times of a student's
files are not reliable, because copying or unpacking the files changes them.
"""

from __future__ import annotations

import csv
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime, tzinfo
from pathlib import Path
from typing import Any

from autograder.course.dates import parse_time
from autograder.course.late import HandedIn
from autograder.submissions.find import Submission

TIMES = "times.csv"
OF_GRADESCOPE = "submission_metadata.yml"
OF_GITHUB = "grades.csv"  # instructors save the grades of GitHub Classroom under this name
REPOSITORY, SUBMITTED = "student_repository_name", "submission_timestamp"


def times_of(folder: Path, submissions: list[Submission], zone: tzinfo) -> dict[str, HandedIn]:
    """Find out when each student handed in the work.

    Students whose time is unknown are left out of the result. If several files contain a time for
    the same student, times.csv takes precedence, because the instructor writes it. A time in
    times.csv without a time zone is taken to be in ``zone``.

    Raises:
        ValueError: A file is not valid. The message says which lines are wrong.
    """
    known: dict[str, HandedIn] = {}
    for name, said in [
        *_of_canvas(submissions),
        *_of_github(folder),
        *_of_gradescope(folder),
        *_of_instructor(folder / TIMES, zone),
    ]:
        known[_key(name)] = said
    found = {}
    for submission in submissions:
        for name in (submission.path.name, submission.path.stem, *submission.names):
            if _key(name) in known:
                found[submission.student] = known[_key(name)]
    return found


def _of_instructor(path: Path, zone: tzinfo) -> Iterator[tuple[str, HandedIn]]:
    """Yield the students and submission times that the instructor has listed in times.csv.

    The file has two columns, student and submitted.
    """
    if not path.exists():
        return
    try:
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        raise ValueError(f"{path} is not UTF-8. Save it as CSV UTF-8") from error
    lines = text.splitlines() or [""]
    separator = ";" if ";" in lines[0] else ","
    with _readable(path):
        header, *rows = csv.reader(lines, delimiter=separator)
    if [cell.strip().lower() for cell in header] != ["student", "submitted"]:
        raise ValueError(f"{path}, line 1: the header must be student,submitted, got {lines[0]!r}")
    wrong, seen = [], set()
    for line, row in enumerate(rows, start=2):
        cells = [cell.strip() for cell in row]
        if not any(cells):
            continue
        if len(cells) != 2:
            wrong.append(f"  line {line}: there must be 2 cells, got {len(cells)}")
        elif cells[0] in seen:
            wrong.append(f"  line {line}: a second time for {cells[0]!r}. Give only one")
        else:
            seen.add(cells[0])
            try:
                yield cells[0], HandedIn(TIMES, parse_time(cells[1], zone))
            except ValueError:
                example = "2026-10-23 20:15 or 2026-10-23T20:15:00+02:00"
                wrong.append(f"  line {line}: a time looks like {example}, got {cells[1]!r}")
    if wrong:
        raise ValueError("\n".join([f"{path}:", *wrong]))


def _of_gradescope(folder: Path) -> Iterator[tuple[str, HandedIn]]:
    """Yield the folder and the time of each submission, as recorded by Gradescope."""
    path = folder / OF_GRADESCOPE
    if not path.is_file():
        return
    import yaml  # type: ignore[import-untyped] # only here, since Gradescope's own machine lacks it

    with _readable(path):
        try:
            data = yaml.safe_load(path.read_text(encoding="utf-8"))
        except yaml.YAMLError as error:
            raise ValueError(str(error)) from error
    for name, about in data.items() if isinstance(data, dict) else ():
        if time := _time(about.get(":created_at") if isinstance(about, dict) else None):
            yield str(name), HandedIn("Gradescope", time)


def _of_github(folder: Path) -> Iterator[tuple[str, HandedIn]]:
    """Yield each student's repository and submission time, as recorded by GitHub Classroom."""
    path = folder / OF_GITHUB
    if not path.is_file():
        return
    with path.open(encoding="utf-8-sig", errors="replace", newline="") as file:
        with _readable(path):
            rows = [*csv.DictReader(file)]
        for row in rows:
            if row.get(REPOSITORY) and (time := _time(row.get(SUBMITTED))):
                yield row[REPOSITORY], HandedIn("GitHub Classroom", time)


def _of_canvas(submissions: list[Submission]) -> Iterator[tuple[str, HandedIn]]:
    """Yield the file of each submission from Canvas, and whether it was late.

    Canvas marks late submissions in the file name, but does not say when they were handed in.
    """
    for submission in submissions:
        if submission.export and submission.export.platform == "canvas":
            yield submission.path.name, HandedIn("Canvas", late=submission.late)


def _time(value: Any) -> datetime | None:
    """Parse a submission time from a platform, or return None if the value is not a time.

    A time without a time zone is taken to be in UTC, which is what platforms use.
    """
    try:
        return parse_time(value.isoformat() if isinstance(value, datetime) else str(value), UTC)
    except ValueError:
        return None


@contextmanager
def _readable(path: Path) -> Iterator[None]:
    """Return a context manager that adds the path of a file to errors about invalid CSV or YAML."""
    try:
        yield
    except (csv.Error, ValueError, RecursionError) as error:
        kind = "YAML" if path.suffix == ".yml" else "CSV"
        raise ValueError(f"{path} is not valid {kind}: {error}") from error


def _key(name: str) -> str:
    """Normalize a student's name, so that it can be compared with the names in other files.

    Unicode can represent most accented letters in two ways. This function converts both to the same
    form.
    """
    return unicodedata.normalize("NFC", name.strip())
