"""Fill in the HTML templates of the web pages that the autograder writes."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from autograder.reports.texts import check_title, number
from autograder.text.clean import clean

SHARED = Path(__file__).parent / "templates"


def render(template: str, folder: Path = SHARED, **values: Any) -> str:
    """Fill in a template from ``folder`` or, if it is not there, from the folder of shared ones.

    All values are escaped, so text from students cannot add HTML or scripts to a page.
    """
    return _environment(folder).get_template(template).render(**values)


@cache
def _environment(folder: Path) -> Environment:
    environment = Environment(
        loader=FileSystemLoader([folder, SHARED]),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters.update(number=number, clean=clean, check_title=check_title)
    return environment
