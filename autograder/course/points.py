"""Compute the points of an assignment's exercises by rescaling the points in the manifest."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction


def rescaled(points: Mapping[str, float], out_of: float, unit: str = "0.01") -> dict[str, float]:
    """Rescale ``points`` in proportion, so that they add up to ``out_of``.

    The results are multiples of ``unit``. All points are first rounded down. The remaining units
    then go to the exercises that lost the most by rounding.
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
    """Rescale extra credit by the same factor as the regular points.

    ``value`` is the extra credit. The regular points were rescaled from ``total`` to ``out_of``.
    """
    return _plain(Fraction(round(value * out_of / total, 2)).limit_denominator(100))


def _plain(value: Fraction) -> float:
    """Convert a whole number to an int, so that it is shown without a decimal point."""
    return int(value) if value.denominator == 1 else float(value)
