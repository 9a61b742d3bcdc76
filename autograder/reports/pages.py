"""Render the templates of all pages. Whatever comes from a student is inserted as text only."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from autograder.clean import clean
from autograder.reports.texts import number

SHARED = Path(__file__).parent / "templates"


def render(template: str, folder: Path = SHARED, **values: Any) -> str:
    """Render a template with some values, and return the page.

    We look for the template in ``folder`` first, and then among the templates that all pages share.
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
