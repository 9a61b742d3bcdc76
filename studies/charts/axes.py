"""A logarithmic axis for charts in SVG, with labels at powers of ten."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

MOST = 5  # labels on an axis


@dataclass(frozen=True)
class Axis:
    """A logarithmic axis of a chart, for values from ``low`` to ``high``.

    It is drawn from the coordinate ``start`` to the coordinate ``end``. On a vertical axis,
    ``start`` is the larger one, because y points down in SVG.
    """

    low: float
    high: float
    start: float
    end: float

    def at(self, value: float) -> float:
        """Return the coordinate at which to draw ``value``, rounded to one decimal.

        A value beyond the end of the axis is drawn at the end.
        """
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return round(self.start + min(max(share, 0.0), 1.0) * (self.end - self.start), 1)

    def ticks(self) -> list[tuple[float, str]]:
        """Choose which powers of ten to label on the axis, at most MOST of them.

        Return a list of tuples, each with the coordinate and the text of a label.
        """
        first, last = math.ceil(math.log10(self.low)), math.floor(math.log10(self.high))
        stride = max(1, math.ceil((last - first + 1) / MOST))
        first = math.ceil(first / stride) * stride  # so that 1 gets a label
        return [(self.at(10.0**n), shown(n)) for n in range(first, last + 1, stride)]


def axis_for(values: Iterable[float], start: float, end: float) -> Axis:
    """Create a logarithmic axis that covers ``values``, which must be positive.

    The axis extends far enough beyond the values to include at least one power of ten as a label.
    """
    seen = [*values]
    low, high = min(seen) / 1.6, max(seen) * 1.6
    while math.ceil(math.log10(low)) > math.floor(math.log10(high)):
        low, high = low / 1.3, high * 1.3
    return Axis(low, high, start, end)


def shown(power: int) -> str:
    """Format a power of ten as a label of an axis, such as "0.01", "100" or "1e-6"."""
    return f"{10.0**power:g}" if -3 <= power <= 4 else f"1e{power}"
