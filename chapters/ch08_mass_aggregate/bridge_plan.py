"""The plan of the rope bridge: the number, size and position of its planks. This file is complete.

The bridge runs along X, and Y points up. Its dimensions are close to those in the book's demo. Each
plank has a particle of 1 kg at both of its ends, which are 2 m apart. The cables between
neighboring rows are 10 cm shorter than the initial distance between these rows, so they pull at
once (8.2.1).
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

Row = tuple[Particle, Particle]  # the ends of a plank at z < 0 and z > 0

ROWS = 6
SPACING = 2.0  # m, between neighboring rows at the start
WIDTH = 2.0  # m, of a plank
HEIGHT = 4.0  # m, of the planks at the start
PLANK_MASS = 1.0  # kg, of each end
CABLE_LENGTH = 1.9  # m, from row to row
ANCHOR_HEIGHT = 6.0  # m
DAMPING = 0.6
GRAVITY = Vector3(0.0, -9.81, 0.0)


def make_rows() -> list[Row]:
    """Return the rows of planks at their start positions along X, centered at 0."""

    def end(row: int, z: float) -> Particle:
        place = Vector3(SPACING * (row - 0.5 * (ROWS - 1)), HEIGHT, z)
        return Particle(place, acceleration=GRAVITY, mass=PLANK_MASS, damping=DAMPING)

    return [(end(i, -0.5 * WIDTH), end(i, 0.5 * WIDTH)) for i in range(ROWS)]


def support_length(row: int) -> float:
    """Return the length in m of the two cables that hold the row with the index ``row``.

    The lengths are from 3 to 4 m, and the cables in the middle of the bridge are the longest.
    """
    return 3.0 + 0.5 * min(row, ROWS - 1 - row)


def anchor_of(plank: Particle) -> Vector3:
    """Return the anchor of the cable that holds ``plank``, which is one end of a plank.

    The plank must be at its start position. Measured from the middle of the bridge, the anchor is
    10 % farther away along X than the plank, and 20 % nearer along Z.
    """
    return Vector3(1.1 * plank.position.x, ANCHOR_HEIGHT, 0.8 * plank.position.z)
