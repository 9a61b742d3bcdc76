"""Grade a folder of submissions, one after the other, and print the class as a table."""

from __future__ import annotations

import secrets
import tempfile
from collections.abc import Sequence
from pathlib import Path

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.markup import escape
from rich.progress import Progress
from rich.table import Table

from autograder.given import with_given
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.reports import overall_status, write_gradebook, write_result
from autograder.runner import GraderError, Verdict, run_checks
from autograder.scores import Result, results_of, shown, total
from autograder.stage import stage

ISOLATION = (
    "none: the submission ran in an ordinary process with a time limit, which hostile code can "
    "leave; grade only classes that you trust"
)


def grade(
    folder: Path,
    out: Path,
    chapters: list[Chapter],
    seed: str | None,
    given: Sequence[Chapter] = (),
) -> int:
    """Grade every submission in the folder; write the reports into out; return 1 for errors.

    The ``given`` chapters are the reference's, whatever is handed in. A submission is a folder
    named after the student; hidden ones and caches are none. Raises ValueError without any.
    """
    if not folder.is_dir():
        raise ValueError(f"the submissions must be a folder of folders, got {str(folder)!r}")
    if out.exists() and not out.is_dir():
        raise ValueError(f"--out must be a folder, got {str(out)!r}")
    folders = sorted(path for path in folder.iterdir() if path.is_dir())
    submissions = [path for path in folders if not path.name.startswith((".", "__"))]
    if not submissions:
        raise ValueError(f"{folder} has no submissions: a folder named after each student")
    seed = seed or secrets.token_hex(4)
    console = Console(highlight=False)
    grades: dict[str, list[Result]] = {}
    with Progress(console=console, transient=True) as progress:
        task = progress.add_task("", total=len(submissions))
        for submission in submissions:
            progress.update(task, description=f"grading {escape(submission.name)}")
            try:
                grades[submission.name] = grade_submission(submission, chapters, seed, given)
            except Exception as error:  # ours, whatever it is: the class goes on
                grades[submission.name] = [
                    result for chapter in chapters for result in _errors(chapter, repr(error))
                ]
            write_result(out, submission.name, seed, ISOLATION, grades[submission.name])
            progress.advance(task)
    gradebook = write_gradebook(out, chapters, grades)
    _print_class(console, grades)
    console.print(f"Seed {seed}. Isolation: {ISOLATION}.", markup=False)
    places = f"Gradebook: {gradebook}\nResults:   {out / 'results'}"
    console.print(places, markup=False, soft_wrap=True)
    return int(any(overall_status(results) != "graded" for results in grades.values()))


def grade_submission(
    submission: Path,
    chapters: list[Chapter],
    seed: str,
    given: Sequence[Chapter] = (),
    root: Path = ROOT,
) -> list[Result]:
    """Return the results of one submission in these chapters, on top of the given ones."""
    results: list[Result] = []
    with tempfile.TemporaryDirectory(prefix="submission-") as folder:
        box = Path(folder)
        stage(submission, load_chapters(root), box, root)
        with with_given(given, [box], root) as engine:
            for chapter in chapters:
                try:
                    verdicts = run_checks(chapter, engine, seed=seed, root=root)
                    results += results_of(chapter, verdicts)
                except GraderError as error:
                    results += _errors(chapter, str(error))
    return results


def _errors(chapter: Chapter, reason: str) -> list[Result]:
    """Return results for checks that could not be run: our error, and not a zero."""
    ours = [Verdict("every check", e.id, 1, "error", reason) for e in chapter.exercises]
    return results_of(chapter, ours)


def _print_class(console: Console, grades: dict[str, list[Result]]) -> None:
    table = Table("student", box=SIMPLE_HEAD, pad_edge=False)
    table.add_column("points", justify="right")
    table.add_column("checks", justify="right")
    table.add_column("status")
    table.add_column("first trouble")
    for student, results in grades.items():
        checks = [check for result in results for check in result.checks]
        passed = sum(check.status == "passed" for check in checks)
        trouble = next((check for check in checks if check.status in ("failed", "error")), None)
        score, points = total(results)
        table.add_row(
            escape(student),
            f"{shown(score)}/{points}",
            f"{passed}/{len(checks)}",
            overall_status(results),
            escape(f"{trouble.exercise}: {_in_short(trouble.message)}") if trouble else "",
        )
    console.print(table)


def _in_short(message: str) -> str:
    """Return the line of a message that says most on its own: the cause, or the exception."""
    lines = message.splitlines() or [""]
    labelled = dict(line.split(maxsplit=1) for line in reversed(lines) if " " in line.strip())
    return labelled.get("likely" if "wanted" in labelled else "got", lines[0])
