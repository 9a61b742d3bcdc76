"""Write the web page that shows a student's code next to the reference solution."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from autograder.release.compare import Compared
from autograder.reports.pages import render
from autograder.reports.texts import replace_file
from autograder.submissions.find import file_name
from autograder.text.clean import clean

TEMPLATES = Path(__file__).parent / "templates"


def write_page(
    out: Path, student: str, compared: Sequence[Compared], not_compared: Sequence[str]
) -> Path:
    """Write a page that shows a student's code next to the reference solution.

    The page is written to students/<student>.html. It also lists the exercises in ``not_compared``,
    which are released but not solved by the student.

    Returns:
        The path of the page.
    """
    path = out / "students" / f"{file_name(student)}.html"
    page = render(
        "release.html",
        TEMPLATES,
        student=clean(student),
        compared=compared,
        not_compared=not_compared,
    )
    replace_file(path, page)
    return path
