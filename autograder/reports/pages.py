"""Fill in the HTML templates of the web pages that the autograder writes.

All text from students is escaped, so it cannot add HTML or scripts to a page.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from autograder.reports.texts import number
from autograder.text.clean import clean

SHARED = Path(__file__).parent / "templates"


def render(template: str, folder: Path = SHARED, **values: Any) -> str:
    """Fill in the template of a web page, such as student.html, and return the finished page.

    ``values`` are the variables for the template. The template is read from ``folder`` or, if it is
    not there, from the folder of shared templates.
    """
    environment = Environment(
        loader=FileSystemLoader([folder, SHARED]),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters.update(number=number, clean=clean)
    return environment.get_template(template).render(**values)
