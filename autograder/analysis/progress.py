"""Write progress.html, which shows how a class progresses from one graded assignment to the next.

The page compares the scores, lists every student, and shows which mistakes keep coming back.
"""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from autograder.analysis.mistakes import NUMBER, mistakes_of
from autograder.reports.pages import render
from autograder.reports.report import StudentReport
from autograder.reports.results import read_results
from autograder.reports.texts import clean_all, replace_file

TEMPLATES = Path(__file__).parent / "templates"
FEWEST = 2  # assignments


@dataclass(frozen=True)
class Run:
    """The results of a class on one graded assignment.

    ``percent`` maps each student to the percentage of points earned, not counting written answers.
    A student's percentage is None if the grader failed on the submission.
    """

    name: str
    reports: list[StudentReport]
    percent: dict[str, float | None]

    @property
    def known(self) -> list[float]:
        """The percentages of the students whose submissions could be graded."""
        return [value for value in self.percent.values() if value is not None]

    @property
    def five(self) -> list[float]:
        """The five numbers for a box plot of the students' percentages.

        These are the minimum, the three quartiles and the maximum. If there are no percentages, the
        list is empty.
        """
        values = self.known
        if len(values) < 2:
            return values * 5
        middle = statistics.quantiles(values, n=4, method="inclusive")
        return [min(values), *middle, max(values)]


@dataclass(frozen=True)
class Returning:
    """A mistake that students of a class made in more than one assignment.

    Attributes:
        counts: For each assignment, the number of students who made the mistake.
        again: The number of students who made it in more than one assignment.
    """

    words: str
    counts: list[int]
    again: int


def write_progress(folders: Sequence[Path], out: Path) -> Path:
    """Write progress.html, which compares the graded assignments of a class, and return its path.

    Each of the ``folders`` contains the results of one assignment. The page shows the assignments
    in the same order.

    Raises:
        ValueError: There are fewer than two folders, or one of them has no results.
    """
    if len(folders) < FEWEST:
        raise ValueError(f"progress needs at least {FEWEST} graded folders, got {len(folders)}")
    if len({folder.resolve() for folder in folders}) < len(folders):
        raise ValueError("progress needs different folders, but one of them is given twice")
    runs = [_run(folder, folders) for folder in folders]
    everyone = sorted({student for run in runs for student in run.percent})
    page = render(
        "progress.html",
        TEMPLATES,
        runs=runs,
        rows=[(student, [run.percent.get(student) for run in runs]) for student in everyone],
        returning=returning(runs),
    )
    replace_file(out / "progress.html", page)
    return out / "progress.html"


def _run(folder: Path, folders: Sequence[Path]) -> Run:
    """Read the students' results on one assignment from the folder that contains its reports.

    The assignment is named after the folder. If two folders have the same name, their paths are
    used instead.
    """
    reports = [clean_all(report) for report in read_results(folder)]
    same = [other for other in folders if other.resolve().name == folder.resolve().name]
    percent = {
        report.student: None if report.score is None else 100.0 * report.score / report.points
        for report in reports
        if report.points
    }
    return Run(folder.resolve().name if len(same) == 1 else str(folder), reports, percent)


def returning(runs: Sequence[Run]) -> list[Returning]:
    """Find the mistakes that a class made in more than one assignment.

    The mistakes that the most students have repeated come first.
    """
    words: dict[str, str] = {}
    students: dict[str, list[list[str]]] = {}
    for number, run in enumerate(runs):
        for one in mistakes_of(run.reports).found:
            key = NUMBER.sub("#", one.words)
            words.setdefault(key, one.words)
            students.setdefault(key, [[] for _ in runs])[number] = one.students
    found = []
    for key, by_run in students.items():
        if sum(map(bool, by_run)) > 1:
            times = Counter(student for names in by_run for student in names)
            again = sum(count > 1 for count in times.values())
            found.append(Returning(words[key], [len(names) for names in by_run], again))
    return sorted(found, key=lambda one: (-one.again, -sum(one.counts), one.words))
