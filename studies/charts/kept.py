"""Copy the results of a complete run of `make charts` into the repository.

The results are the page with all charts, the overview picture, and a description of the picture.
"""

from __future__ import annotations

import math
import re
import textwrap
from collections.abc import Sequence
from pathlib import Path

from autograder.files import replace_bytes
from autograder.manifest import ROOT
from studies.accuracy.results import Row

PICTURE, PAGE = "studies/accuracy/overview.png", "studies/accuracy/charts.html"
READMES = ("README.md", "studies/README.md")
SHOWN = re.compile(r"!\[[^\]]*\](?=\([^)]*overview\.png\))")


def keep(rows: Sequence[Row], out: Path, root: Path = ROOT) -> None:
    """Copy the overview picture and the page with all charts from ``out`` into the repository.

    The description of the picture in the READMEs is updated, too.
    """
    replace_bytes(root / PICTURE, (out / "overview.png").read_bytes())
    replace_bytes(root / PAGE, (out / "index.html").read_bytes())
    for name in READMES:
        path = root / name
        text = path.read_text(encoding="utf-8")
        new = SHOWN.sub(_wrapped(described(rows)), text)
        replace_bytes(path, new.encode())


def _wrapped(alt: str) -> str:
    return "\n".join(textwrap.wrap(f"![{alt}]", 105, break_long_words=False))


def described(rows: Sequence[Row]) -> str:
    """Describe the overview picture in words, for readers who cannot see it.

    The picture compares pymunk's time with ours in many scenes. The READMEs use the description as
    its alternative text.
    """
    scenes = len({row.scene for row in rows})
    told = [
        f"For each of {scenes} scenes, the time of pymunk at its best as a multiple of ours, at "
        "errors of 1e-2, 1e-4 and 1e-6 of the scene's size."
    ]
    for is_formula, ours in ((False, "our steps"), (True, "our better models")):
        own = [row for row in rows if row.is_formula == is_formula]
        ratios = {row.ratio: row for row in own if row.ratio}
        if slower := [ratio for ratio in ratios if ratio > 1.0]:
            most = max(slower)
            told.append(
                f"Against {ours}, pymunk takes longer in {len(slower)} of {len(ratios)} "
                f"comparisons, up to {_rounded(most)} times as long ({ratios[most].scene}"
                f"{', extrapolated' if ratios[most].is_extrapolated else ''})."
            )
        if faster := [ratio for ratio in ratios if ratio < 1.0]:
            least = min(faster)
            told.append(
                f"It is faster in {len(faster)}, and takes as little as 1/{_rounded(1.0 / least)} "
                f"of our time ({ratios[least].scene})."
            )
        missed = sum(row.ours.time is not None and row.pymunk.time is None for row in own)
        told.append(f"In {missed} more, only ours reach the error.")
    return " ".join(told)


def _rounded(value: float) -> str:
    """Format a ratio to two significant digits, as in the overview picture."""
    digits = max(0, 1 - math.floor(math.log10(value)))
    return f"{float(f'{value:.2g}'):,.{digits}f}"
