"""The `similarity` command, which lists pairs of students with unusually similar code."""

from __future__ import annotations

from pathlib import Path

from rich.progress import track

from autograder.files import is_new
from autograder.grader.people import differences
from autograder.manifest import ROOT, Chapter
from autograder.reports.texts import replace_file
from autograder.similarity.collect import collect, ground_of
from autograder.similarity.compare import FEWEST, Comparison, Work
from autograder.similarity.pages import write_pages
from autograder.submissions.class_list import read_class
from autograder.text.wrapping import plain_console

RECORD = "compared.txt"  # names the class, and shows that the folder is of this command


def similarity(
    folder: Path, out: Path, chapters: list[Chapter], roster: Path | None = None, root: Path = ROOT
) -> int:
    """Compare the code of each pair of students in a class, and write pages about similar pairs."""
    record = out / RECORD
    if out.resolve().is_relative_to(folder.resolve()):
        raise ValueError(f"--out must not be in the folder of the class, got {str(out)!r}")
    if not record.is_file() and not is_new(out, record):
        raise ValueError(
            f"--out must be a new folder or one with pages of this command, got {str(out)!r}, but "
            "it has other files. Name another one (make: OUT=)"
        )
    people = read_class(folder, roster)
    submissions, notes = people.submissions, [*people.notes, *differences(people, [])]
    console = plain_console()
    ground = ground_of(chapters, root)
    works: list[Work] = []
    arriving = collect(submissions, ground, root)
    silent = not console.is_terminal
    for work, more in track(
        arriving, "reading", len(submissions), console=console, transient=True, disable=silent
    ):
        notes += [f"{work.student}: {note}" for note in more]
        if work.parts:
            works.append(work)
        else:
            notes.append(f"{work.student} was left out: there is no code to compare")
    comparison = Comparison(works)
    replace_file(record, f"{folder.resolve()}\n")
    index = write_pages(out, comparison, chapters, ground.small, notes)
    identical = [f"identical: {p.one.student} and {p.other.student}" for p in comparison.identical]
    read = f"Read the code of each pair yourself: {index}"
    for line in [*notes, *identical, _summary(comparison), read]:
        console.print(line, markup=False, soft_wrap=True)
    return 0


def _summary(comparison: Comparison) -> str:
    same = bool(comparison.identical)
    if comparison.line is None:
        words = "No other pair" if same else "No pair"
        return f"{words} can stand out without {FEWEST} students whose code differs."
    of_all = f"{comparison.outstanding} of {len(comparison.pairs)} pairs stand out"
    of_these = ", counting those that are identical" if same else ""
    return f"{of_all}{of_these}. Similarity alone proves nothing."
