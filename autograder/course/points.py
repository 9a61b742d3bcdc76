"""Scale the points of the exercises, so that an assignment adds up to the total it should have."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction


def rescaled(points: Mapping[str, float], out_of: float, unit: str = "0.01") -> dict[str, float]:
    """Scale the points of all exercises by the same factor, so that they add up to ``out_of``.

    Each result is a multiple of ``unit``. To make the sum come out exactly, we first round
    everything down. We then hand out the units that are left, one each, to the exercises that have
    lost most by rounding.
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
    """Scale the points for extra credit by the same factor as all the other points.

    ``value`` is the extra credit. The other points added up to ``total`` before, and to ``out_of``
    now.
    """
    return _plain(Fraction(round(value * out_of / total, 2)).limit_denominator(100))


def _plain(value: Fraction) -> float:
    """Turn a fraction into a number.

    A whole number becomes an int, so that it is shown as 3, not 3.0.
    """
    return int(value) if value.denominator == 1 else float(value)
