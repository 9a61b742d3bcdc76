"""Exact motion with drag along one line, and the longest safe time steps (book 5.3).

k1 and k2 are the coefficients of Eq. 5.1. The results must be correct to about 12 digits, even if
one coefficient is 0 or tiny, even for a very short or very long time. The time may be 0.
"""

from __future__ import annotations


def terminal_speed(weight: float, k1: float, k2: float) -> float:
    """Compute the speed at which the drag balances the weight: k1 v + k2 v^2 = ``weight``.

    Raises ValueError if both coefficients are 0, because then the speed grows without limit.
    """
    raise NotImplementedError("Exercise B5.6: Terminal speed")


def quadratic_fall(mass: float, gravity: float, k2: float, time: float) -> tuple[float, float]:
    """Compute the speed and the distance of a fall from rest for ``time`` s, with drag k2 v^2.

    They are u tanh x and (u^2 / g) ln cosh x, where u is the terminal speed, g the ``gravity``, and
    x = g t / u.
    """
    raise NotImplementedError("Exercise B5.7: Falling and coasting without steps")


def coasting_speed(speed: float, k1: float, k2: float, mass: float, time: float) -> float:
    """Compute the speed of a body after drag alone has acted on it for ``time`` s.

    It is v e^-s / (1 + k2 v (1 - e^-s) / k1), where v is the ``speed`` at the start and s is k1 t /
    m. If k1 is 0, replace (1 - e^-s) / k1 by its limit, t / m.
    """
    raise NotImplementedError("Exercise B5.7: Falling and coasting without steps")


def drag_limits(k1: float, k2: float, mass: float, speed: float) -> tuple[float, float]:
    """Return the durations in s above which a step reverses the motion, and speeds it up.

    Only drag acts: v' = v + (f / m) h, with the f of ``speed``. Both are ``math.inf`` without drag.
    """
    raise NotImplementedError("Exercise B5.8: Time steps that are too long for drag")
