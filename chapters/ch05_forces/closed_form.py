"""Exact solutions for motion with drag, and the longest safe time steps (book 5.3).

An exact solution gives a speed or a distance at any time, without time steps, so you can use it to
check a simulation. All motion here is along one line, and all numbers are in SI units. The
coefficients of Eq. 5.1 are k1 in N s/m and k2 in N s^2/m^2.
"""

from __future__ import annotations


def terminal_speed(weight: float, k1: float, k2: float) -> float:
    """Compute the terminal speed in m/s, at which the drag on a falling body balances its weight.

    As a body falls faster, its drag grows, so its speed approaches a limit. This terminal speed is
    the positive solution v of k1 v + k2 v^2 = weight, where ``weight`` is in N.

    The result must be correct to about 12 digits for any combination of the two kinds of drag, even
    if one coefficient is 0 or tiny.

    Raises:
        ValueError: if both coefficients are 0, because without drag the speed grows without limit.
    """
    raise NotImplementedError("Exercise B5.6: Terminal speed")


def quadratic_fall(mass: float, gravity: float, k2: float, time: float) -> tuple[float, float]:
    """Compute how fast and how far a body falls from rest in a given time, with quadratic drag.

    The drag is k2 v^2, with no linear term. Let u be the terminal speed, g the ``gravity`` in
    m/s^2, t the ``time`` in s, which may be 0, and x = g t / u. Return the speed in m/s, which is
    u tanh x, and the distance in m, which is (u^2 / g) ln cosh x. Both must be correct to about 12
    digits, even if x is very small or very large.
    """
    raise NotImplementedError("Exercise B5.7: Falling and coasting without steps")


def coasting_speed(speed: float, k1: float, k2: float, mass: float, time: float) -> float:
    """Compute the speed in m/s of a body after drag alone has acted on it for ``time`` s.

    Let v be the ``speed`` at the start, and s = k1 t / m. The result is

        v e^-s / (1 + k2 v (1 - e^-s) / k1)

    If k1 is 0, this formula divides by 0, so replace (1 - e^-s) / k1 by its limit, which is t / m.
    The result must be correct to about 12 digits, even if k1 is tiny or the time is very long.
    """
    raise NotImplementedError("Exercise B5.7: Falling and coasting without steps")


def drag_limits(k1: float, k2: float, mass: float, speed: float) -> tuple[float, float]:
    """Compute how long a time step may be before drag reverses the motion or even speeds it up.

    A time step computes the drag f only once, from the ``speed`` before the step. It then applies
    this force for the whole duration h: v' = v + (f / m) h. Return two limits in s for a step in
    which only drag acts. In a step longer than the first limit, the drag reverses the motion
    instead of only slowing it down. In a step longer than the second limit, the particle moves
    backward even faster than it moved forward. Without drag, both limits are ``math.inf``. If only
    the speed is 0, return the limits for a very low speed, which are finite if ``k1`` is not 0.
    """
    raise NotImplementedError("Exercise B5.8: Time steps that are too long for drag")
