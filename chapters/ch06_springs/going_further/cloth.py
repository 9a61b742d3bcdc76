"""A cloth of knots joined by springs, which is the most demanding scene in this chapter.

This file is complete. The plots, the demo and the benchmarks use it.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.springs import connect

KNOTS = 10  # along each side
STIFFNESS = 200.0  # N/m
REST_LENGTH = 0.1  # m
MASS = 0.05  # kg, of a knot
G = 9.81  # m/s^2


def neighbors() -> list[tuple[int, int]]:
    """Return the pairs of knots that a spring joins. There are 180 pairs for 10 by 10 knots."""
    along = [(i, i + 1) for i in range(KNOTS * KNOTS) if (i + 1) % KNOTS]
    across = [(i, i + KNOTS) for i in range(KNOTS * (KNOTS - 1))]
    return along + across


def make_cloth(damping: float) -> tuple[list[Particle], ForceRegistry]:
    """Return the knots of a horizontal cloth, row by row, and the registry with its springs.

    ``damping`` is the damping of each spring in N s/m. The two corners at the ends of the first row
    are immovable, and the rest of the cloth falls.
    """
    knots = [
        Particle(
            Vector3(REST_LENGTH * (i % KNOTS), 0.0, REST_LENGTH * (i // KNOTS)),
            acceleration=Vector3(0.0, -G, 0.0),
            mass=MASS,
        )
        for i in range(KNOTS * KNOTS)
    ]
    knots[0].inverse_mass = knots[KNOTS - 1].inverse_mass = 0.0
    registry = ForceRegistry()
    for a, b in neighbors():
        connect(registry, knots[a], knots[b], STIFFNESS, REST_LENGTH, damping)
    return knots, registry
