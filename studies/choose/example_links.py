"""A scene file for `make choose` in which two balls hang from rods.

The light ball hangs from a fixed point, and the heavy one hangs from the light one. A scene can
also have collisions. To detect them, add a `GroundPlane(particles, height, radius, restitution)` or
a `ParticlePairs(particles, radius, restitution)` to the `contact_generators` of its world.
"""

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import AnchoredRod, Rod
from ch08_mass_aggregate.world import ParticleWorld

DURATION = 1.0  # s


def build() -> ParticleWorld:
    """Create two balls that hang from rods and have been moved to the side, ready to swing."""
    gravity = Vector3(0.0, -9.81, 0.0)
    light = Particle(Vector3(0.6, -0.8, 0.0), acceleration=gravity, mass=1.0)
    heavy = Particle(Vector3(0.6, -1.8, 0.0), acceleration=gravity, mass=20.0)
    world = ParticleWorld([light, heavy])
    world.contact_generators.append(AnchoredRod(light, Vector3(), 1.0))
    world.contact_generators.append(Rod(light, heavy, 1.0))
    return world


def measure(world: ParticleWorld) -> Vector3:
    """Return the position of the heavy ball, which `make choose` compares between runs."""
    return world.particles[1].position
