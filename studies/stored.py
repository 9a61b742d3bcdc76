"""Store the figures of a study, from which pages and pictures are made."""

from __future__ import annotations

import json
import platform
from collections.abc import Callable
from datetime import date
from pathlib import Path
from typing import Any

from autograder.files import replace_bytes


def store(file: Path, form: Callable[[Any], str] | None = None, **found: Any) -> None:
    """Write figures to a JSON file, with the date and the version of Python."""
    found = {"measured": date.today().isoformat(), "python": platform.python_version()} | found
    text = form(found) if form else json.dumps(found, indent=1)
    replace_bytes(file, f"{text}\n".encode())
