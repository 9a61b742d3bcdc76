"""Ada's cube."""

from itertools import combinations, product

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
    if type(count) is not int:
        raise TypeError(f"count is no whole number: {count!r}")
    if count < 1:
        raise ValueError(f"count is below 1: {count}")
    as_one_body = {1: 3, 2: 5}.get(count, 6)
    return 3 * count - as_one_body


def cube_rods():
    # A corner with its three neighbours is a tetrahedron, which is rigid. The four corners that are
    # left hold on to the same three neighbours, and none of them is in the plane of those.
    origin, neighbours, others = 0, (1, 2, 4), (3, 5, 6, 7)
    return [*combinations((origin, *neighbours), 2), *product(neighbours, others)]


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
