"""Copy the results of a complete run of `make charts` into the repository.

The results are the page with all charts, the overview picture with a description, all ratios, and a
table of them in studies/README.md.
"""

from __future__ import annotations

import json
import math
import platform
import re
import textwrap
from collections.abc import Sequence
from datetime import date
from importlib import metadata
from pathlib import Path
from typing import Any

from autograder.files import replace_bytes
from autograder.manifest import ROOT
from autograder.text.marked import with_text
from studies.accuracy.results import TOLERANCES, Row, power

PICTURE, PAGE = "studies/accuracy/overview.png", "studies/accuracy/charts.html"
FIGURES = "studies/accuracy/figures.json"
READMES = ("README.md", "studies/README.md")
SHOWN = re.compile(r"!\[[^\]]*\](?=\([^)]*overview\.png\))")
BEGIN, END = "<!-- ratios: `make charts` writes this -->", "<!-- end of ratios -->"
# How many times as long as ours pymunk should take at each tolerance, in a smooth scene.
GOALS = {False: (0.8, 2.0, 15.0), True: (3.0, 30.0, 300.0)}
ROUGH = ("ball", "net of", "at rest", "spheres")  # not smooth, or no motion
TIE = 1.4  # two times that differ by less are equal, because times vary from run to run

Figure = dict[str, Any]


def keep(rows: Sequence[Row], out: Path, root: Path = ROOT) -> None:
    """Copy the overview picture, the page with all charts and the ratios into the repository.

    ``out`` is the folder of the picture and the page. The READMEs get a new description of the
    picture, and one of them a new table.
    """
    replace_bytes(root / PICTURE, (out / "overview.png").read_bytes())
    replace_bytes(root / PAGE, (out / "index.html").read_bytes())
    figures = figures_of(rows)
    found = {
        "measured": date.today().isoformat(),
        "python": platform.python_version(),
        "pymunk": metadata.version("pymunk"),
        "rows": figures,
    }
    replace_bytes(root / FIGURES, (json.dumps(found, indent=1) + "\n").encode())
    for name in READMES:
        path = root / name
        text = SHOWN.sub(_wrapped(described(rows)), path.read_text(encoding="utf-8"))
        if BEGIN in text:
            text = with_text(text, BEGIN, END, table(figures))
        replace_bytes(path, text.encode())


def figures_of(rows: Sequence[Row]) -> list[Figure]:
    """Return what the READMEs quote of each comparison, with ratios to three digits."""
    return [
        {
            "scene": row.scene,
            "is_formula": row.is_formula,
            "tolerance": row.tolerance,
            "ours": row.ours.model,
            "pymunk": row.pymunk.model,
            "ratio": float(f"{row.ratio:.3g}") if row.ratio else None,
            "is_extrapolated": row.is_extrapolated,
            "low": float(f"{row.bounds[0]:.3g}"),
            "high": float(f"{row.bounds[1]:.3g}") if row.bounds[1] < math.inf else None,
            "never": "ours" * row.ours.never or "pymunk" * row.pymunk.never,
        }
        for row in rows
    ]


def table(figures: Sequence[Figure]) -> str:
    """Return the table of all ratios, in Markdown. A ratio that misses its goal is in italics."""
    cells = {(f["scene"], f["is_formula"], f["tolerance"]): told(f) for f in figures}
    kinds = ("our steps", "better model")
    heads = [f"{kind}, {power(tolerance)}" for kind in kinds for tolerance in TOLERANCES]
    lines = [["scene", *heads], ["---", *["---:"] * len(heads)]]
    for scene in dict.fromkeys(figure["scene"] for figure in figures):
        keys = [(scene, kind, tolerance) for kind in (False, True) for tolerance in TOLERANCES]
        lines.append([scene, *(cells.get(key, "") for key in keys)])
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def told(figure: Figure) -> str:
    """Return a ratio as it stands in the table."""
    if figure["ratio"]:
        text = "~" * figure["is_extrapolated"] + rounded(figure["ratio"])
    elif figure["never"] == "pymunk" and figure["ours"]:
        text = "pymunk never"
    elif figure["never"] == "ours" and figure["pymunk"]:
        text = "ours never"
    elif figure["low"]:
        text = f"> {rounded(figure['low'])}"
    else:
        text = f"< {rounded(figure['high'])}" if figure["high"] else "-"
    return f"*{text}*" if misses(figure) else text


def is_smooth(figure: Figure) -> bool:
    """Return True if something moves in a scene, and nothing collides or becomes slack."""
    return not any(part in figure["scene"] for part in ROUGH)


def misses(figure: Figure) -> bool:
    """Return True if a ratio in a smooth scene is below its goal."""
    if not is_smooth(figure):
        return False
    goal = GOALS[figure["is_formula"]][TOLERANCES.index(figure["tolerance"])]
    return not (figure["never"] == "pymunk" or (figure["ratio"] or figure["low"]) >= goal)


def _wrapped(alt: str) -> str:
    return "\n".join(textwrap.wrap(f"![{alt}]", 105, break_long_words=False))


def described(rows: Sequence[Row]) -> str:
    """Describe the overview picture in words, for readers who cannot see it.

    The picture compares pymunk's time with ours in many scenes. The READMEs use the description as
    its alternative text.
    """
    scenes = len({row.scene for row in rows})
    words = [
        f"For each of {scenes} scenes, the time of pymunk at its best as a multiple of ours, at "
        "errors of 1e-2, 1e-4 and 1e-6 of the scene's size."
    ]
    for is_formula, ours in ((False, "our steps"), (True, "our better models")):
        own = [row for row in rows if row.is_formula == is_formula]
        known = [(row.ratio, row) for row in own if row.ratio]
        slower = [pair for pair in known if pair[0] >= TIE]
        faster = [pair for pair in known if pair[0] <= 1.0 / TIE]
        words.append(f"Against {ours}, pymunk takes longer in {len(slower)} of {len(own)} cases")
        if slower:
            most, row = max(slower, key=lambda pair: pair[0])
            words[-1] += (
                f", up to {rounded(most)} times as long ({row.scene}"
                f"{', extrapolated' if row.is_extrapolated else ''})"
            )
        words[-1] += f", and less time in {len(faster)}"
        if faster:
            least, row = min(faster, key=lambda pair: pair[0])
            words[-1] += f", as little as 1/{rounded(1.0 / least)} ({row.scene})"
        ties = len(known) - len(slower) - len(faster)
        only_ours = sum(bool(row.ours.time) and not row.pymunk.time for row in own)
        only_theirs = sum(bool(row.pymunk.time) and not row.ours.time for row in own)
        neither = len(own) - len(known) - only_ours - only_theirs
        words[-1] += (
            f". In {ties} the times differ by a factor below {TIE:g}. In {only_ours} only we reach "
            f"the error, in {only_theirs} only pymunk, and in {neither} neither of us."
        )
    return " ".join(words)


def rounded(value: float) -> str:
    """Format a ratio to two significant digits, as in the overview picture."""
    digits = max(0, 1 - math.floor(math.log10(value)))
    return f"{float(f'{value:.2g}'):,.{digits}f}"
