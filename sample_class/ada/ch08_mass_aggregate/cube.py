"""A cube of rods: how many does it take to be rigid, and which? (mini-project 8.2)."""

from __future__ import annotations

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import TwoSidedRod
from ch08_mass_aggregate.world import ParticleWorld

# Corner 0 is at the origin; bit 0 of a corner's number says whether it is 1 m along X from there,
# bit 1 along Y, bit 2 along Z: corner 6 is at (0, 1, 1).
CORNERS = [(float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1)) for i in range(8)]
DAMPING = 0.9
GRAVITY = Vector3(0.0, -9.81, 0.0)
ITERATIONS = 200  # a phase


def fewest_rods(count: int) -> int:
    if not isinstance(count, int) or isinstance(count, bool):
        raise TypeError(f"count must be a whole number, got {count!r}")
    if count < 1:
        raise ValueError(f"count must be 1 or more, got {count!r}")
    return sum(min(i, 3) for i in range(count))  # each that joins needs three, but the first three


def cube_rods() -> list[tuple[int, int]]:
    rods = []
    for i in range(8):
        for bit in (1, 2, 4):
            if not i & bit:
                rods.append((i, i | bit))  # an edge
    # Each face has a diagonal: three of them from corner 0, three from the opposite one.
    for i in (1, 2, 4):
        rods.append((0, 7 - i))
        rods.append((i, 7))
    return rods


class Cube:
    """A cube that falls on one of its corners: ``particles``, ``rods`` and ``world``."""

    def __init__(self, height: float = 1.0, rods: list[tuple[int, int]] | None = None) -> None:
        places = [_turned(*corner) for corner in CORNERS]
        lift = Vector3(0.0, positive("height", height) - min(place.y for place in places), 0.0)
        self.particles = [
            Particle(place + lift, acceleration=GRAVITY, damping=DAMPING) for place in places
        ]
        self.rods = []
        for i, j in cube_rods() if rods is None else rods:
            a, b = self.particles[i], self.particles[j]
            self.rods.append(TwoSidedRod(a, b, (b.position - a.position).magnitude()))
        ground = GroundPlane(self.particles, restitution=0.3)
        self.world = ParticleWorld(self.particles, [*self.rods, ground], iterations=ITERATIONS)

    def step(self, duration: float) -> None:
        self.world.step(duration)


def _turned(x: float, y: float, z: float) -> Vector3:
    c, s = 0.9238795325112867, 0.3826834323650898  # of pi / 8
    x, y = c * finite("x", x) - s * y, s * x + c * y
    return Vector3(x, c * y - s * z, s * y + c * z)
