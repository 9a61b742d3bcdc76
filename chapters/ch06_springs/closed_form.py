"""Where a damped spring takes its end, at any time and without steps (book 6.3)."""

from __future__ import annotations


def damped_spring_state(
    x0: float, v0: float, stiffness: float, damping: float, mass: float, time: float
) -> tuple[float, float]:
    """Return position in m and velocity in m/s after a time in s: m x'' = -k x - c x' (6.3.2).

    The spring starts at x0 with the velocity v0, and rests at 0; ``stiffness`` k is in N/m,
    ``damping`` c in N s/m, ``mass`` m in kg. Its end swings through 0 while c^2 < 4 k m
    (under-damped); it comes to rest the soonest where they are equal (critical); beyond that it
    creeps (over-damped). The book has the first of these alone (E-23). Without stiffness it is a
    body that coasts.

    Raises ValueError where the mass is not positive, stiffness, damping or time is negative, or one
    of the arguments, k / m, c / m, the angle through which it swings, or the result, is not finite.
    What is no number is a TypeError.
    """
    raise NotImplementedError("Exercise B6.5: Harmonic motion without steps")
