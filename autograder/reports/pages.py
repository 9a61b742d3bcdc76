"""Render the templates of all pages. Whatever comes from a student is inserted as plain text."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from autograder.clean import clean
from autograder.reports.texts import number

SHARED = Path(__file__).parent / "templates"


def render(template: str, folder: Path = SHARED, **values: Any) -> str:
    """Fill in a template with these values, and return the resulting page.

    The template is looked up in ``folder`` first, and then among those that all pages share.
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
