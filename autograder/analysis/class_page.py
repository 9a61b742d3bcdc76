"""Write class.html, the page that shows an instructor how a whole class did.

The page shows the distribution of scores, the most common mistakes, and statistics for every
exercise. It contains no students' names, so it is safe to show in a lecture.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from autograder.analysis.discrimination import FEWEST, LOW
from autograder.analysis.items import HIDDEN, STATES, items_of
from autograder.analysis.mistakes import Mistake, mistakes_of
from autograder.manifest import Chapter
from autograder.reports.pages import render
from autograder.reports.report import StudentReport, for_students
from autograder.reports.texts import check_title, clean_all, replace_file

TEMPLATES = Path(__file__).parent / "templates"


@dataclass(frozen=True)
class ShownMistake:
    """A common mistake listed on class.html, with the number of students who made it.

    ``places`` lists the sources that explain the topic, such as "glossary: scalar product".
    """

    mistake: Mistake
    count: int
    places: list[str]


def write_class_page(out: Path, chapters: list[Chapter], reports: Sequence[StudentReport]) -> Path:
    """Write class.html, the overview of a class, into the folder ``out``, and return its path."""
    path = out / "class.html"
    clean = [clean_all(for_students(report)) for report in reports]
    mistakes = mistakes_of(clean)
    page = render(
        "class.html",
        TEMPLATES,
        students=len(clean),
        chapters=chapters,
        items=[(chapter, items_of(chapter, clean)) for chapter in chapters],
        misconceptions=[_shown(one, chapters) for one in mistakes.misconceptions],
        mistakes=[_shown(one, chapters) for one in mistakes.found],
        unexplained=mistakes.unexplained,
        states=STATES,
        hidden=HIDDEN,
        title_of=check_title,
        fewest=FEWEST,
        low=LOW,
    )
    replace_file(path, page)
    return path


def _shown(mistake: Mistake, chapters: list[Chapter]) -> ShownMistake:
    lessons, terms = [], []
    for chapter in chapters:
        here = [e for e in chapter.exercises if e.id in mistake.exercises]
        if here:
            ids = ", ".join(exercise.id for exercise in here)
            lessons.append(f"lesson of chapter {chapter.number}, at {ids}")
        terms += [term for exercise in here for term in exercise.terms]
    glossary = [f"glossary: {', '.join(dict.fromkeys(terms))}"] if terms else []
    return ShownMistake(mistake, len(mistake.students), [*mistake.read, *lessons, *glossary])
