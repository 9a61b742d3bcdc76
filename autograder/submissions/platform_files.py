"""Read who handed in and when from a platform's files that accompany the submissions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from autograder.course.dates import parse_time
from autograder.submissions.csv_rows import read_csv
from autograder.submissions.exports import OF_MOODLE, read_export, without_suffix
from autograder.submissions.names import letters, some

OF_GRADESCOPE = "submission_metadata.yml"
OF_GITHUB = "grades.csv"  # instructors save the grades of GitHub Classroom under this name
REPOSITORY, SUBMITTED = "student_repository_name", "submission_timestamp"
IDENTIFIER = "roster_identifier"


@dataclass(frozen=True)
class Upload:
    """What a platform's file says about one submission."""

    source: str  # the platform
    people: tuple[tuple[str, ...], ...] = ()  # all names of each student, the surest first
    at: datetime | None = None  # when it was handed in; Moodle names no time zone

    @property
    def together(self) -> str:
        """The names of all students, such as "Ann Lee, Bo Chen"."""
        return ", ".join(names[-1] for names in self.people)


class Uploads:
    """What the platforms' files in the folder of a class say about its submissions."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._by_name = _of_github(folder / OF_GITHUB) | _of_gradescope(folder / OF_GRADESCOPE)
        self._by_number = _of_moodle(folder / OF_MOODLE)

    def of(self, path: Path) -> Upload | None:
        """Return what is known about the submission at this path."""
        export = read_export(path.name)
        if export and export.platform == "moodle":
            return self._by_number.get(export.number)
        return self._by_name.get(path.name) or self._by_name.get(without_suffix(path))

    def name_of(self, path: Path) -> str:
        """Return the students' names on the platform, or "", with the submission if not unique."""
        upload = self._by_name.get(path.name) or self._by_name.get(without_suffix(path))
        if not upload or not upload.people:
            return ""
        together = [letters(other.together) for other in self._by_name.values()]
        is_shared = together.count(letters(upload.together)) > 1
        return f"{upload.together} ({path.stem})" if is_shared else upload.together

    def notes(self, paths: Sequence[Path]) -> list[str]:
        """Say which rows of the files are about no submission at one of these paths."""
        there = {name for path in paths for name in (path.name, without_suffix(path))}
        exports = [read_export(path.name) for path in paths]
        numbers = {one.number for one in exports if one and one.platform == "moodle"}
        unknown = [name for name in self._by_name if name not in there]
        absent = [
            f"{upload.together or 'participant'} ({number})"
            for number, upload in self._by_number.items()
            if numbers and upload.at and number not in numbers
        ]
        said = (
            (unknown, "submissions of the platform's files are not"),
            (absent, f"participants in {OF_MOODLE} have handed in, but not"),
        )
        return [f"{len(n)} {words} in {self._folder}: {some(n)}" for n, words in said if n]


def _of_moodle(path: Path) -> dict[str, Upload]:
    """Read the participants of Moodle's worksheet. The keys are their numbers."""
    if not path.is_file():
        return {}
    # Only here, since Gradescope's own machine lacks the library that reads the times.
    from autograder.submissions.moodle_worksheet import read_worksheet

    found = {}
    for row in read_worksheet(path).rows:
        names = tuple(filter(None, [row.id_number, row.email, row.name]))
        found[row.number] = Upload("Moodle", (names,) if names else (), row.submitted)
    return found


def _of_gradescope(path: Path) -> dict[str, Upload]:
    if not path.is_file():
        return {}
    import yaml  # type: ignore[import-untyped] # only here, since Gradescope's own machine lacks it

    try:
        data = yaml.safe_load(path.read_text(encoding="utf-8"))
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        raise ValueError(f"{path} is not valid YAML: {error}") from error
    if not isinstance(data, dict) or not all(isinstance(about, dict) for about in data.values()):
        raise ValueError(f"{path} is not the file of this name in an export from Gradescope")
    found = {}
    for name, about in data.items():
        said = about.get(":submitters")
        known = [one for one in said if isinstance(one, dict)] if isinstance(said, list) else []
        people = [
            tuple(str(one[part]) for part in (":sid", ":email", ":name") if one.get(part))
            for one in known
        ]
        at = _time(about.get(":created_at"))
        found[str(name)] = Upload("Gradescope", tuple(filter(None, people)), at)
    return found


def _of_github(path: Path) -> dict[str, Upload]:
    """Read the grades of GitHub Classroom, which has a row for each student of a group."""
    if not path.is_file():
        return {}
    table = read_csv(path)
    if REPOSITORY not in table.header:
        words = f"the grades of GitHub Classroom have a column {REPOSITORY}, got"
        problem = f"{words} {table.first_line!r}. Rename the file if it is another one"
        raise table.mistake(1, problem)
    found: dict[str, Upload] = {}
    for _, cells in table.rows():
        row = dict(zip(table.header, cells, strict=True))
        if name := row[REPOSITORY]:
            before = found.get(name, Upload(""))
            at = max(filter(None, (before.at, _time(row.get(SUBMITTED)))), default=None)
            people = [*before.people, *([(who,)] if (who := row.get(IDENTIFIER)) else [])]
            found[name] = Upload("GitHub Classroom", tuple(dict.fromkeys(people)), at)
    return found


def _time(value: Any) -> datetime | None:
    """Parse a time, in UTC if it names no time zone, or return None if it is not a time."""
    try:
        return parse_time(value.isoformat() if isinstance(value, datetime) else str(value), UTC)
    except ValueError:
        return None
