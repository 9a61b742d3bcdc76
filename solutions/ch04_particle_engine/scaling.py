"""Change the mass and gravity of a bullet so that it flies slowly enough to be seen (book 4.1.1).

A slow bullet should still hit as hard as a real one and follow the same path. ``factor`` is the
real speed divided by the speed in the game. For example, if a bullet of 500 m/s flies at 25 m/s in
the game, the factor is 20. The book defines this ratio in two opposite ways (erratum E-19).
"""

from __future__ import annotations

from ch02_vectors.arguments import finite, not_negative, positive


def muzzle_energy(mass: float, speed: float) -> float:
    """Compute the kinetic energy of a shot, m v^2 / 2, in J.

    The energy determines how much work the shot can do on a target. The mass is in kg and the speed
    in m/s.

    >>> muzzle_energy(0.005, 500.0)
    625.0
    """
    return positive("mass", mass) * not_negative("speed", speed) ** 2 / 2.0


def slowed_mass(mass: float, factor: float) -> float:
    """Compute the mass in kg that gives a slowed shot the kinetic energy of the real shot.

    The slowed shot flies at the real speed divided by ``factor``. It needs a larger mass to have
    the same energy, so that it does the same work on a target as the real shot.

    >>> slowed_mass(0.005, 20.0)  # muzzle_energy(2.0, 25.0) is 625 J again
    2.0
    """
    return positive("mass", mass) * positive("factor", factor) ** 2


def slowed_gravity(gravity: float, factor: float) -> float:
    """Compute the gravity in m/s^2 that gives a slowed shot the trajectory of the real shot.

    The slowed shot needs more time for the same distance, so gravity acts on it for longer. Without
    weaker gravity, it would drop farther than the real shot. The book divides gravity by the factor
    only once, which is not enough (erratum E-2).

    >>> slowed_gravity(10.0, 20.0)
    0.025
    """
    return finite("gravity", gravity) / positive("factor", factor) ** 2
