"""Write class.html, the page that shows an instructor how a whole class did.

It contains no students' names, so it is safe to show in a lecture.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from autograder.analysis.common_mistakes import Mistake, misconceptions, mistakes_of
from autograder.analysis.discrimination import FEWEST, LOW
from autograder.analysis.items import HIDDEN, STATES, items_of
from autograder.manifest import Chapter
from autograder.reports.pages import render
from autograder.reports.report import StudentReport, for_students
from autograder.reports.texts import clean_all, replace_file

TEMPLATES = Path(__file__).parent / "templates"


def write_class_page(out: Path, chapters: list[Chapter], reports: Sequence[StudentReport]) -> Path:
    """Write class.html, the overview of a class, into the folder ``out``, and return its path."""
    path = out / "class.html"
    clean = [clean_all(for_students(report)) for report in reports]
    mistakes, unexplained = mistakes_of(clean)
    page = render(
        "class.html",
        TEMPLATES,
        students=len(clean),
        chapters=chapters,
        items=[(chapter, items_of(chapter, clean)) for chapter in chapters],
        misconceptions=[(one, _where_to_read(one, chapters)) for one in misconceptions(mistakes)],
        mistakes=[(one, _where_to_read(one, chapters)) for one in mistakes],
        unexplained=unexplained,
        states=STATES,
        hidden=HIDDEN,
        fewest=FEWEST,
        low=LOW,
    )
    replace_file(path, page)
    return path


def _where_to_read(mistake: Mistake, chapters: list[Chapter]) -> list[str]:
    """List what explains the topic of a mistake, such as "glossary: scalar product"."""
    places, terms = [*mistake.read], []
    for chapter in chapters:
        if here := [e for e in chapter.exercises if e.id in mistake.exercises]:
            ids = ", ".join(exercise.id for exercise in here)
            places.append(f"lesson of chapter {chapter.number}, at {ids}")
            terms += [term for exercise in here for term in exercise.terms]
    return [*places, f"glossary: {', '.join(dict.fromkeys(terms))}"] if terms else places
