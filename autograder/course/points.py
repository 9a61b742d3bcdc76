"""Scale the points of exercises so that an assignment adds up to the intended total."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction


def rescaled(points: Mapping[str, float], out_of: float, unit: str = "0.01") -> dict[str, float]:
    """Scale the points of all exercises by the same factor, so that they add up to ``out_of``.

    Each result is a multiple of ``unit``. All points are first rounded down, which may make their
    sum too small. To correct the sum, one ``unit`` is added to each of the exercises that lost the
    most by rounding.
    """
    step = Fraction(unit)
    total = sum(map(Fraction, points.values()))
    exact = {name: Fraction(value) * Fraction(out_of) / total for name, value in points.items()}
    units = {name: value // step for name, value in exact.items()}
    left = round(Fraction(out_of) / step) - sum(units.values())
    by_loss = sorted(exact, key=lambda name: units[name] * step - exact[name])
    for name in by_loss[:left]:
        units[name] += 1
    return {name: _plain(count * step) for name, count in units.items()}


def scaled_alike(value: float, out_of: float, total: float) -> float:
    """Scale the points of an extra-credit exercise by the same factor as the regular points.

    ``value`` is the number of points that this exercise is worth before scaling. ``total`` is the
    sum of the regular points before scaling, and ``out_of`` is their sum afterwards.
    """
    return _plain(Fraction(round(value * out_of / total, 2)).limit_denominator(100))


def _plain(value: Fraction) -> float:
    """Convert a fraction to an int if it is a whole number, and to a float otherwise.

    A whole number of points is therefore printed as 3 instead of 3.0.
    """
    return int(value) if value.denominator == 1 else float(value)
