"""What drag does to a particle, without steps; and the frames that are too long for the steps.

Everything here moves along one line, and its numbers are in SI units. k1 and k2 are Eq. 5.1's, in
N s/m and N s^2/m^2. What is no number is a TypeError everywhere.
"""

from __future__ import annotations


def terminal_speed(weight: float, k1: float, k2: float) -> float:
    """Return the speed in m/s of a fall at which the drag is as large as the weight in N.

    It solves k1 v + k2 v^2 = weight.

    Raises ValueError where the weight is not positive, a coefficient is negative, one of them is
    not finite, or both coefficients are 0: such a fall gains speed for ever.
    """
    raise NotImplementedError("Exercise B5.6: Terminal speed")


def quadratic_fall(mass: float, gravity: float, k2: float, time: float) -> tuple[float, float]:
    """Return the speed in m/s and the distance in m of a fall from rest, with quadratic drag alone.

    They are u tanh x and u^2 / g times ln cosh x, where x is g t / u, with the terminal speed u and
    the time t in s.

    Raises ValueError where mass, gravity or k2 is not positive, the time is negative, or one of
    them is not finite.
    """
    raise NotImplementedError("Exercise B5.7: Falling and coasting without steps")


def coasting_speed(speed: float, k1: float, k2: float, mass: float, time: float) -> float:
    """Return what is left of a speed in m/s after a time in s in which nothing but drag acts.

    With s = k1 t / m it is v e^-s / (1 + k2 v (1 - e^-s) / k1), where (1 - e^-s) / k1 goes to t / m
    for k1 = 0.

    Raises ValueError where the mass is not positive, another of them is negative, or one of them is
    not finite.
    """
    raise NotImplementedError("Exercise B5.7: Falling and coasting without steps")


def drag_limits(k1: float, k2: float, mass: float, speed: float) -> tuple[float, float]:
    """Return two lengths of a frame in s, beyond which a step with drag alone goes wrong.

    In a frame longer than the first, the drag turns the motion round; in one longer than the
    second, the particle is faster afterwards than it was. The step is v' = v + (f / m) h, with the
    f of Eq. 5.1 at the speed at which the frame begins. Without drag both are math.inf.

    Raises ValueError where the mass is not positive, another of them is negative, or one of them is
    not finite.
    """
    raise NotImplementedError("Exercise B5.8: Frames that are too long for drag")
