"""Store the results of the last `make bench`, and update the READMEs that quote them.

A README quotes the median of a benchmark between two comments. The first comment identifies the
benchmark by the beginning of its description:

    takes <!-- bench: a cloth of 180 springs by connect -->1.8<!-- end --> times as long
"""

from __future__ import annotations

import json
import platform
import re
from collections.abc import Sequence
from datetime import date
from pathlib import Path
from typing import Any

from autograder.manifest import ROOT
from studies.timing import Line

FILE = Path(__file__).with_name("figures.json")
PAGES = ("README.md", "studies/README.md", "chapters/*/*.md")
QUOTATION = re.compile(r"(<!-- bench: ([^>]*?) -->)(.*?)(<!-- end -->)", re.DOTALL)


def keep(lines: Sequence[Line], versions: str, file: Path = FILE) -> None:
    """Save the results of `make bench`, from which the READMEs quote.

    The date, the Python version, the type of machine and the versions of the libraries are saved,
    too.
    """
    found: dict[str, Any] = {
        "measured": date.today().isoformat(),
        "python": platform.python_version(),
        "machine": f"{platform.system()} {platform.machine()}",
        "libraries": versions,
    }
    found["lines"] = {
        line.what: {
            "ratio": rounded(line.median),
            "quartiles": [rounded(line.low), rounded(line.high)],
            "target": str(line.target or ""),
            "verdict": line.verdict,
        }
        for line in lines
    }
    file.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


def rounded(figure: float) -> float:
    """Round a benchmark's result to three digits, since further digits differ in every run."""
    return float(f"{figure:.3g}")


def kept(file: Path = FILE) -> dict[str, float]:
    """Load the medians of the last `make bench`, as a dict from descriptions to medians.

    The dict is empty if no results are stored yet.
    """
    if not file.exists():
        return {}
    lines = json.loads(file.read_text(encoding="utf-8"))["lines"]
    return {what: line["ratio"] for what, line in lines.items()}


def with_quotations(page: str, ratios: dict[str, float]) -> str:
    """Return the text of a README with all quoted benchmark results updated.

    ``ratios`` maps the description of each benchmark to its median. The results are rounded to two
    digits.

    Raises:
        ValueError: A quotation matches the descriptions of several benchmarks, or of none.
    """

    def renewed(match: re.Match[str]) -> str:
        wanted = " ".join(match[2].split())
        found = [ratio for what, ratio in ratios.items() if what.startswith(wanted)]
        if len(found) != 1:
            raise ValueError(f"one line of make bench must begin with {wanted!r}, got {len(found)}")
        return f"{match[1]}{float(f'{found[0]:.2g}'):,g}{match[4]}"

    return QUOTATION.sub(renewed, page)


def pages() -> list[Path]:
    """List the READMEs and lessons in which results of `make bench` may be quoted."""
    return [path for pattern in PAGES for path in sorted(ROOT.glob(pattern))]


def write_quotations() -> None:
    """Update all results of `make bench` that are quoted in READMEs and lessons.

    Raises:
        ValueError: A quotation matches the descriptions of several benchmarks, or of none.
    """
    ratios = kept()
    for path in pages():
        old = path.read_text(encoding="utf-8")
        new = with_quotations(old, ratios)
        if new != old:
            path.write_text(new, encoding="utf-8", newline="\n")
