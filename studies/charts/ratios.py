"""Prepare the table that compares pymunk's time with ours, at the end of the page of charts.

It shows each ratio as a number and as a mark on an axis.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from studies.accuracy.chart import told, told_ratio
from studies.accuracy.results import Row
from studies.charts.axes import Axis, axis_for

COMPARED = {False: "steps", True: "better model"}


@dataclass(frozen=True)
class Ratio:
    """A row of the table that compares pymunk's time with ours, for one scene and one tolerance.

    ``compared`` says which of our models count, as in ``COMPARED``.
    ``at`` is the position of the row's mark on the axis in percent, or None if there is no mark.
    ``kind`` is "exact" or "extrapolated" if the ratio is known. It is "more" for a lower bound,
    "less" for an upper bound, and empty if nothing is known.
    """

    scene: str
    error: str
    compared: str
    ours: str
    pymunk: str
    told: str
    at: float | None
    kind: str


def ratios(rows: Sequence[Row]) -> tuple[Axis, list[Ratio]]:
    """Build the table of the ratios of pymunk's times to ours, and the axis that shows them.

    Return the axis, and a Ratio for each row.
    """
    marks = [_mark(row) for row in rows]
    axis = axis_for([1.0, *(value for value, _ in marks if value)], 0.0, 100.0)
    return axis, [
        Ratio(
            row.scene,
            f"{row.tolerance:g}",
            COMPARED[row.is_formula],
            told(row.ours),
            told(row.pymunk),
            told_ratio(row),
            axis.at(value) if value else None,
            kind,
        )
        for row, (value, kind) in zip(rows, marks, strict=True)
    ]


def _mark(row: Row) -> tuple[float | None, str]:
    """Return the value to mark on the axis for a row of the table, and the kind of the mark.

    The value is the ratio of pymunk's time to ours, or a bound on this ratio. If neither is known,
    the value is None. The kinds are listed in ``Ratio``.
    """
    if row.ratio:
        return row.ratio, "extrapolated" if row.is_extrapolated else "exact"
    low, high = row.bounds
    if low > 0.0 and not row.pymunk.never:
        return low, "more"
    if high < math.inf and not row.ours.never:
        return high, "less"
    return None, ""
