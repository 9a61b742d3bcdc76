"""Find out how many rods make a cube rigid, and which ones (mini-project 8.2)."""

from __future__ import annotations

import math

from ch02_vectors.arguments import positive, whole
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import TwoSidedRod
from ch08_mass_aggregate.world import ParticleWorld

# The bits of a corner's index are its coordinates in m: bit 0 is x, bit 1 is y and bit 2 is z. So
# corner 6 is at (0, 1, 1).
CORNERS = [(float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1)) for i in range(8)]
DAMPING = 0.9
GRAVITY = Vector3(0.0, -9.81, 0.0)
ITERATIONS = 200  # per phase


def fewest_rods(count: int) -> int:
    """Compute the smallest number of rods that can make ``count`` particles rigid in space.

    Each particle can move in three independent directions, and each rod prevents at most one
    motion. A rigid body keeps six motions, along three axes and about them. But two particles keep
    only five, because a rotation about their rod changes nothing, and one particle keeps three.
    """
    whole("count", count)
    return 3 * count - 6 if count >= 3 else count - 1


def cube_rods() -> list[tuple[int, int]]:
    """Choose rods that make the cube rigid, and return them as pairs of indices into ``CORNERS``.

    You may return any set of rods that lets the cube move and rotate only as a whole.
    """
    edges = [(i, i | bit) for i in range(8) for bit in (1, 2, 4) if not i & bit]
    # One diagonal per face, here between corners 0, 3, 5 and 6, which form a tetrahedron.
    diagonals = [(0, 3), (0, 5), (0, 6), (3, 5), (3, 6), (5, 6)]
    return edges + diagonals


class Cube:
    """A cube of particles and rods that falls on one of its corners.

    ``world`` simulates the ``particles``, which are the corners. The cube starts at rest and
    slightly rotated, with its lowest corner ``height`` m above the ground. ``rods`` is a list of
    pairs of corners, or None to use ``cube_rods()``. Raises ValueError for a height that is not
    positive or a rod from a corner to itself, and IndexError for a corner that does not exist.
    """

    def __init__(self, height: float = 1.0, rods: list[tuple[int, int]] | None = None) -> None:
        places = [_turned(*corner) for corner in CORNERS]
        lift = Vector3(0.0, positive("height", height) - min(place.y for place in places), 0.0)
        self.particles = [
            Particle(place + lift, acceleration=GRAVITY, damping=DAMPING) for place in places
        ]
        self.rods = []
        for i, j in cube_rods() if rods is None else rods:
            if not (0 <= i < 8 and 0 <= j < 8):
                raise IndexError(f"rods must join corners from 0 to 7, got {(i, j)!r}")
            a, b = self.particles[i], self.particles[j]
            self.rods.append(TwoSidedRod(a, b, (b.position - a.position).magnitude()))
        ground = GroundPlane(self.particles, restitution=0.3)
        self.world = ParticleWorld(self.particles, [*self.rods, ground], iterations=ITERATIONS)

    def step(self, duration: float) -> None:
        """Move the cube forward by one time step of ``duration`` s."""
        self.world.step(duration)


def _turned(x: float, y: float, z: float) -> Vector3:
    """Rotate the point (x, y, z) by pi / 8 about Z and then about X, so that the cube tumbles."""
    c, s = math.cos(math.pi / 8.0), math.sin(math.pi / 8.0)
    x, y = c * x - s * y, s * x + c * y
    return Vector3(x, c * y - s * z, s * y + c * z)
