"""Cube."""

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import TwoSidedRod
from ch08_mass_aggregate.world import ParticleWorld

CORNERS = [(float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1)) for i in range(8)]
DAMPING = 0.9
GRAVITY = Vector3(0.0, -9.81, 0.0)
ITERATIONS = 200


def fewest_rods(count):
    if not isinstance(count, int) or isinstance(count, bool):
        raise TypeError(f"count must be a whole number, got {count!r}")
    if count < 1:
        raise ValueError(f"count must be 1 or more, got {count!r}")
    if count == 1:
        return 0
    if count == 2:
        return 1
    return 3 * count - 6


def cube_rods():
    # the 12 edges
    rods = []
    for i in range(8):
        for j in range(i + 1, 8):
            if i ^ j in (1, 2, 4):
                rods.append((i, j))
    return rods


class Cube:
    def __init__(self, height=1.0, rods=None):
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

    def step(self, duration):
        self.world.step(duration)


def _turned(x, y, z):
    c, s = 0.9238795325112867, 0.3826834323650898
    x, y = c * finite("x", x) - s * y, s * x + c * y
    return Vector3(x, c * y - s * z, s * y + c * z)
