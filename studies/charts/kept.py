"""Copy the results of a complete run of `make charts` into the repository."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence
from importlib import metadata
from pathlib import Path

from autograder.files import replace_bytes
from autograder.manifest import ROOT
from autograder.text.marked import with_text
from studies.accuracy.results import Row
from studies.charts.ratios import described, figures_of, table
from studies.stored import store

PICTURE, PAGE = "studies/accuracy/overview.png", "studies/accuracy/charts.html"
FIGURES = "studies/accuracy/figures.json"
READMES = ("README.md", "studies/README.md")
SHOWN = re.compile(r"!\[[^\]]*\](?=\([^)]*overview\.png\))")
BEGIN, END = "<!-- ratios: `make charts` writes this -->", "<!-- end of ratios -->"


def keep(rows: Sequence[Row], day: str, out: Path, root: Path = ROOT) -> None:
    """Copy the picture, the page and the ratios in ``out``, measured on ``day``, to the repository.

    The READMEs get a new description of the picture, and one of them a new table.
    """
    replace_bytes(root / PICTURE, (out / "overview.png").read_bytes())
    replace_bytes(root / PAGE, (out / "index.html").read_bytes())
    figures = figures_of(rows)
    store(root / FIGURES, measured=day, pymunk=metadata.version("pymunk"), rows=figures)
    alt = "\n".join(textwrap.wrap(f"![{described(rows)}]", 105, break_long_words=False))
    for name in READMES:
        path = root / name
        text = SHOWN.sub(lambda _: alt, path.read_text(encoding="utf-8"))
        if BEGIN in text:
            text = with_text(text, BEGIN, END, table(figures))
        replace_bytes(path, text.encode())
