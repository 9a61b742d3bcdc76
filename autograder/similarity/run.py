"""The `similarity` command, which lists pairs of students with unusually similar code."""

from __future__ import annotations

from pathlib import Path

from rich.progress import track

from autograder.manifest import ROOT, Chapter
from autograder.similarity.collect import collect, ground_of
from autograder.similarity.compare import FEWEST, Work, compare
from autograder.similarity.pages import write_pages
from autograder.submissions.class_list import read_class
from autograder.text.wrapping import plain_console


def similarity(folder: Path, out: Path, chapters: list[Chapter], root: Path = ROOT) -> int:
    """Compare the code of each pair of students in a class, and write pages about similar pairs.

    The submissions are in ``folder``, and the pages go into ``out``.

    Raises:
        ValueError: There are no submissions to compare, or ``out`` is inside ``folder``.
        OSError: A file of the repository cannot be read, or a page cannot be written.
    """
    if out.resolve().is_relative_to(folder.resolve()):
        raise ValueError(f"--out must not be in the folder of the class, got {str(out)!r}")
    people = read_class(folder)
    submissions, notes = people.submissions, [*people.notes]
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
    comparison = compare(works)
    index = write_pages(out, comparison, chapters, ground.small, notes)
    for note in notes:
        console.print(note, markup=False, soft_wrap=True)
    if comparison.line is None:
        console.print(f"No pair can stand out without {FEWEST} students whose code differs.")
    else:
        of_all = f"{comparison.outstanding} of {len(comparison.pairs)}"
        console.print(f"{of_all} pairs stand out. Similarity alone proves nothing.")
    console.print(f"Read the code of each pair yourself: {index}", markup=False, soft_wrap=True)
    return 0
