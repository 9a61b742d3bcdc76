"""A scene file for `make choose`: a 2 kg lamp that swings on a springy cord, with drag.

The motion of the lamp has no closed form. To study a scene of your own, copy this file and change
its three definitions. Then run `make choose SCENE=my_scene.py TOLERANCE=1e-3`.
"""

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring
from ch08_mass_aggregate.world import ParticleWorld

DURATION = 2.0  # s


def build() -> ParticleWorld:
    """Create the lamp and its cord in their initial state.

    `make choose` simulates the scene many times, and calls this function before each run.
    """
    lamp = Particle(Vector3(1.2, 0.0, 0.0), acceleration=Vector3(0.0, -9.81, 0.0), mass=2.0)
    world = ParticleWorld([lamp])
    world.registry.add(lamp, AnchoredSpring(Vector3(), 400.0, 1.0))
    world.registry.add(lamp, Drag(0.1, 0.05))
    return world


def measure(world: ParticleWorld) -> Vector3:
    """Return the position of the lamp, which `make choose` compares between runs.

    This function is called after every frame. If a scene file does not define it, `make choose`
    compares the positions of all particles that can move.
    """
    return world.particles[0].position
