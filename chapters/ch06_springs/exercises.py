"""Exercise 6.5: how stiff may a spring be? This module measures it."""

from __future__ import annotations

from ch06_springs.integrators import Integrator

START = 10.0  # m, how far from its anchor the particle is released
FRAMES = 2000
STIFFEST = 16.0  # times m / h^2: twice what runge_kutta_4 can bear at d = 1
SOFTEST = 1e-7  # times m / h^2: softer springs need not be told from none


def swings_wider(integrator: Integrator, stiffness: float, damping: float, duration: float) -> bool:
    """Exercise 6.5: say whether a spring of a stiffness in N/m makes a particle swing ever wider.

    The particle has 1 kg and this damping, and is released at rest START m away from the anchor of
    a spring whose rest length is 0. There is no gravity. It makes FRAMES steps by the integrator,
    each of a duration in s. A swing whose size stays is not wider. Asked for is a stiffness that is
    1 % off the limit or more, and whose swings take FRAMES / 6 frames or less: others are not told
    for sure. Nor are swings of nearly 3 or nearly 4 frames, where the damping is 1: their ends are
    missed for long.

    >>> from ch06_springs.integrators import semi_implicit_euler
    >>> swings_wider(semi_implicit_euler, 14_000.0, 1.0, 1.0 / 60.0)
    False
    >>> swings_wider(semi_implicit_euler, 15_000.0, 1.0, 1.0 / 60.0)
    True

    Raises ValueError where stiffness or damping is negative, the duration is not positive, or one
    of them is not finite.
    """
    raise NotImplementedError("Exercise 6.5: How stiff may a spring be? Measured")


def largest_stable_stiffness(integrator: Integrator, damping: float, duration: float) -> float:
    """Exercise 6.5: measure the stiffness in N/m above which the particle swings ever wider.

    What is measured is 1 % off at most where the damping is between 0.3 and 0.95 and the duration
    between 1/120 and 1/20 s; nearer to 1 the book's step grows so slowly that FRAMES are too few.
    Where no spring is safe it is 0, or next to it: nothing below SOFTEST / h^2 is looked at. Where
    STIFFEST / h^2 is safe, it is that.

    Raises ValueError where the damping is negative, the duration is not positive, or one of them is
    not finite.
    """
    raise NotImplementedError("Exercise 6.5: How stiff may a spring be? Measured")
