"""The plan of the rope bridge: how many planks, of what, and where. It is complete.

The bridge runs along X, from the first row of planks to the last; up is Y. Its numbers are near the
book's demo: planks of 1 kg at each side, 2 m apart, and cables that are too short at first (8.2).
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

Row = tuple[Particle, Particle]  # the ends of a plank: at z < 0, and at z > 0

ROWS = 6
SPACING = 2.0  # m, between two rows at the start
WIDTH = 2.0  # m, of a plank
HEIGHT = 4.0  # m, of the planks at the start
PLANK_MASS = 1.0  # kg, of each end
CABLE_LENGTH = 1.9  # m, from row to row
ANCHOR_HEIGHT = 6.0  # m
DAMPING = 0.6
GRAVITY = Vector3(0.0, -9.81, 0.0)


def make_rows() -> list[Row]:
    """Return the rows of planks at their places at the start, along X, with 0 in the middle."""

    def end(row: int, z: float) -> Particle:
        place = Vector3(SPACING * (row - 0.5 * (ROWS - 1)), HEIGHT, z)
        return Particle(place, acceleration=GRAVITY, mass=PLANK_MASS, damping=DAMPING)

    return [(end(i, -0.5 * WIDTH), end(i, 0.5 * WIDTH)) for i in range(ROWS)]


def support_length(row: int) -> float:
    """Return how long in m the cables are on which a row hangs: 3 to 4, longest in the middle."""
    return 3.0 + 0.5 * min(row, ROWS - 1 - row)


def anchor_of(plank: Particle) -> Vector3:
    """Return the place that a plank's end, at its place at the start, hangs from.

    Along X it is 10 % further from the middle of the bridge, across it 20 % nearer.
    """
    return Vector3(1.1 * plank.position.x, ANCHOR_HEIGHT, 0.8 * plank.position.z)
