"""Change the mass and gravity of a bullet so that it flies slowly enough to be seen (book 4.1.1).

``factor`` is the real speed divided by the speed in the game (erratum E-19).
"""

from __future__ import annotations

from ch02_vectors.arguments import finite, not_negative, positive


def muzzle_energy(mass: float, speed: float) -> float:
    """Compute the kinetic energy of a shot, m v^2 / 2, in J.

    >>> muzzle_energy(0.005, 500.0)
    625.0
    """
    return positive("mass", mass) * not_negative("speed", speed) ** 2 / 2.0


def slowed_mass(mass: float, factor: float) -> float:
    """Compute the mass in kg that gives a slowed shot the kinetic energy of the real shot.

    >>> slowed_mass(0.005, 20.0)  # muzzle_energy(2.0, 25.0) is 625 J again
    2.0
    """
    return positive("mass", mass) * positive("factor", factor) ** 2


def slowed_gravity(gravity: float, factor: float) -> float:
    """Compute the gravity in m/s^2 that gives a slowed shot the trajectory of the real shot.

    The book divides gravity by the factor only once, which is not enough (erratum E-2).

    >>> slowed_gravity(10.0, 20.0)
    0.025
    """
    return finite("gravity", gravity) / positive("factor", factor) ** 2
