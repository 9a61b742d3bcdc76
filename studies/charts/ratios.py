"""The ratios of pymunk's times to ours, in words and in tables."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from scenes.timing import significant
from studies.accuracy.measure import Point
from studies.accuracy.results import TOLERANCES, Row, Side, row

# How many times as long as ours pymunk should take at each tolerance, in a smooth scene.
GOALS = {False: (0.8, 2.0, 15.0), True: (3.0, 30.0, 300.0)}
ROUGH = ("ball", "net of", "at rest", "spheres")  # not smooth, or no motion
TIE = 1.4  # two times that differ by less are equal, because times vary from run to run

Figure = dict[str, Any]


def power(tolerance: float) -> str:
    """Format one of TOLERANCES, as in 1e-2."""
    return f"1e{round(math.log10(tolerance))}"


def rounded(value: float) -> str:
    """Format a ratio to two significant digits, as in 0.50, 5.5 or 11,000."""
    digits = max(0, 1 - math.floor(math.log10(value)))
    return f"{float(f'{value:.2g}'):,.{digits}f}"


def precise(value: float) -> str:
    """Format ``value`` to three significant digits, as in 0.0277, 5.51 or 4,190."""
    return f"{value:.3g}" if value < 1000.0 else f"{float(f'{value:.3g}'):,.0f}"


def told(side: Side) -> str:
    """Describe a side's fastest model, as in "leapfrog, 3.2 ms", "never" or "not within 600 ms"."""
    if side.time is not None:
        time = f"{side.model}, {precise(1e3 * side.time)} ms"
        return time if side.order is None else f"{time} (extrapolated, order {side.order:.2f})"
    return "never" if side.never else f"not within {precise(1e3 * side.longest)} ms"


def said(points: Sequence[Point], tolerance: float) -> list[str]:
    """Compare our fastest models of both kinds with pymunk's in one scene, in a line each."""
    rows = [row(points, tolerance, is_formula=is_formula) for is_formula in (False, True)]
    return [_said(found) for found in rows if found]


def _said(found: Row) -> str:
    ours, theirs = found.ours, found.pymunk
    kind = "better model" if found.is_formula else "steps"
    start = f"{kind}, at an error of {power(found.tolerance)}: "
    if ours.time is None or theirs.time is None:
        return f"{start}ours: {told(ours)}; pymunk: {told(theirs)}"
    many = theirs.time / ours.time
    end = f"{precise(many)} times as long" if many >= 1.0 else f"1/{precise(1.0 / many)} of that"
    end += ", extrapolated" * found.is_extrapolated
    return f"{start}{precise(1e3 * ours.time)} ms ({ours.model}); pymunk {end} ({theirs.model})"


def figures_of(rows: Sequence[Row]) -> list[Figure]:
    """Return what the pages quote of each comparison, with ratios to three digits."""
    return [
        {
            "scene": row.scene,
            "is_formula": row.is_formula,
            "tolerance": row.tolerance,
            "ours": row.ours.model,
            "pymunk": row.pymunk.model,
            "ratio": significant(row.ratio) if row.ratio else None,
            "is_extrapolated": row.is_extrapolated,
            "low": significant(row.bounds[0]),
            "high": significant(row.bounds[1]) if row.bounds[1] < math.inf else None,
            "never": "ours" * row.ours.never or "pymunk" * row.pymunk.never,
        }
        for row in rows
    ]


def told_ratio(figure: Figure, form: Callable[[float], str] = rounded) -> str:
    """Return a ratio, as in "5.5", "~5.5" (extrapolated), "> 120", "ours never" or "-"."""
    if figure["ratio"]:
        return f"{'~' if figure['is_extrapolated'] else ''}{form(figure['ratio'])}"
    never = figure["never"]
    if never and figure["ours" if never == "pymunk" else "pymunk"]:
        return f"{never} never"
    if figure["low"]:
        return f"> {form(figure['low'])}"
    return f"< {form(figure['high'])}" if figure["high"] else "-"


def table(figures: Sequence[Figure]) -> str:
    """Return the table of all ratios, in Markdown. A ratio that misses its goal is in italics."""
    cells = {}
    for figure in figures:
        text = told_ratio(figure)
        key = figure["scene"], figure["is_formula"], figure["tolerance"]
        cells[key] = f"*{text}*" if misses(figure) else text
    kinds = ("our steps", "better model")
    heads = [f"{kind}, {power(tolerance)}" for kind in kinds for tolerance in TOLERANCES]
    lines = [["scene", *heads], ["---", *["---:"] * len(heads)]]
    for scene in dict.fromkeys(figure["scene"] for figure in figures):
        keys = [(scene, kind, tolerance) for kind in (False, True) for tolerance in TOLERANCES]
        lines.append([scene, *(cells.get(key, "") for key in keys)])
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def is_smooth(figure: Figure) -> bool:
    """Return True if something moves in a scene, and nothing collides or becomes slack."""
    return not any(part in figure["scene"] for part in ROUGH)


def misses(figure: Figure) -> bool:
    """Return True if a ratio in a smooth scene is below its goal."""
    if not is_smooth(figure):
        return False
    goal = GOALS[figure["is_formula"]][TOLERANCES.index(figure["tolerance"])]
    return not (figure["never"] == "pymunk" or (figure["ratio"] or figure["low"]) >= goal)


def described(rows: Sequence[Row]) -> str:
    """Describe the overview picture in words, for readers who cannot see it."""
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
        text = f"Against {ours}, pymunk takes longer in {len(slower)} of {len(own)} cases"
        if slower:
            ratio, found = max(slower, key=lambda pair: pair[0])
            end = ", extrapolated" * found.is_extrapolated
            text += f", up to {rounded(ratio)} times as long ({found.scene}{end})"
            low, scene = max((row.bounds[0], row.scene) for row in own)
            if low > ratio:
                text += f" or, without reaching the error, at least {rounded(low)} ({scene})"
        text += f", and less time in {len(faster)}"
        if faster:
            ratio, found = min(faster, key=lambda pair: pair[0])
            text += f", as little as 1/{rounded(1.0 / ratio)} ({found.scene})"
            high, scene = min((row.bounds[1], row.scene) for row in own)
            if high < ratio:
                text += f" or, where we miss the error, at most 1/{rounded(1.0 / high)} ({scene})"
        ties = len(known) - len(slower) - len(faster)
        only_ours = sum(bool(row.ours.time) and not row.pymunk.time for row in own)
        only_theirs = sum(bool(row.pymunk.time) and not row.ours.time for row in own)
        neither = len(own) - len(known) - only_ours - only_theirs
        words.append(
            f"{text}. In {ties} the times differ by a factor below {TIE:g}. In {only_ours} only we "
            f"reach the error, in {only_theirs} only pymunk, and in {neither} neither of us."
        )
    return " ".join(words)
