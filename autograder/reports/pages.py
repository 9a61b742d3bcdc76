"""Render the templates of all pages. Content that comes from students is inserted only as text."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from autograder.clean import clean
from autograder.reports.texts import number

SHARED = Path(__file__).parent / "templates"


def render(template: str, folder: Path = SHARED, **values: Any) -> str:
    """Render ``template`` with ``values``, and return the page.

    The template is in ``folder`` or in the folder of shared templates.
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
