"""A bullet that is slow enough to be seen (book 4.1.1): how its mass and gravity must change.

A real bullet is too fast to be seen, so a game slows it down. ``factor`` is the real speed divided
by the speed in the game. For a bullet of 500 m/s that is shown at 25 m/s, the factor is 20. The
book's text and its footnote divide in opposite directions (E-19).

Every function of this chapter raises TypeError if an argument that must be a number is something
else.
"""

from __future__ import annotations


def muzzle_energy(mass: float, speed: float) -> float:
    """Return the kinetic energy m v^2 / 2 of a shot in J.

    The mass is in kg and the speed in m/s.

    Raises ValueError if the mass is not positive and finite, or if the speed is negative or not
    finite.

    >>> muzzle_energy(0.005, 500.0)
    625.0
    """
    raise NotImplementedError("Exercise B4.1: A bullet slow enough to be seen")


def slowed_mass(mass: float, factor: float) -> float:
    """Return the mass in kg that gives a slowed shot the kinetic energy of the real shot.

    The shot is slower by ``factor``, so it needs a larger mass for the same energy. With the same
    energy, it does as much work on a target.

    Raises ValueError if the mass or the factor is not positive and finite.

    >>> slowed_mass(0.005, 20.0)  # muzzle_energy(2.0, 25.0) is 625 J again
    2.0
    """
    raise NotImplementedError("Exercise B4.1: A bullet slow enough to be seen")


def slowed_gravity(gravity: float, factor: float) -> float:
    """Return the gravity in m/s^2 that gives a slowed shot the trajectory of the real shot.

    The slower shot needs more time for the same distance, so it falls for longer. With this weaker
    gravity it still drops no farther than the fast shot. The book divides by the factor only once
    (E-2).

    Raises ValueError if the gravity is not finite, or if the factor is not positive and finite.

    >>> slowed_gravity(10.0, 20.0)
    0.025
    """
    raise NotImplementedError("Exercise B4.1: A bullet slow enough to be seen")
