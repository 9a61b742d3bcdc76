"""A bullet slow enough to be seen (book 4.1.1): what becomes of its mass and of gravity.

``factor`` is how many times slower the shot of the game is: the real speed divided by the speed in
the game, so 20 for 500 m/s shown as 25. The book divides one way in its text and the other way in
its footnote (E-19).

What is no number where one is wanted is a TypeError, in every function of this chapter.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite, not_negative, positive


def muzzle_energy(mass: float, speed: float) -> float:
    """Return the kinetic energy of a shot in J, m v^2 / 2; mass in kg, speed in m/s.

    The book's text leaves out the half (E-18).

    Raises ValueError where the mass is not positive and finite, or the speed is negative or not
    finite.

    >>> muzzle_energy(0.005, 500.0)
    625.0
    """
    return positive("mass", mass) * not_negative("speed", speed) ** 2 / 2.0


def slowed_mass(mass: float, factor: float) -> float:
    """Return the mass in kg that keeps the energy of a shot which is slower by a factor.

    Raises ValueError where the mass or the factor is not positive and finite.

    >>> slowed_mass(0.005, 20.0)  # muzzle_energy(2.0, 25.0) is 625 J again
    2.0
    """
    return positive("mass", mass) * positive("factor", factor) ** 2


def slowed_gravity(gravity: float, factor: float) -> float:
    """Return the gravity in m/s^2 that keeps the arc of a shot which is slower by a factor.

    The slower shot takes longer over the same ground, and falls for longer: only with this gravity
    it drops no more than the fast one. The book divides by the factor once (E-2).

    Raises ValueError where the gravity is not finite, or the factor not positive and finite.

    >>> slowed_gravity(10.0, 20.0)
    0.025
    """
    return finite("gravity", gravity) / positive("factor", factor) ** 2
