"""Make steps of scenes for `make measure WHAT=clarity`, in a process for one engine.

    python studies/clarity/steps.py FOLDER ...

For each line with the name of a scene, it prints how long some steps of the scene took, in s.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

FRAME = 1.0 / 60.0
CLOTH_STEP = 1.0 / 480.0  # s, with which the stiff springs of the cloth are stable
Step = Callable[[], object]
SPRING = ("ch06_springs/springs.py", "AnchoredSpring.update_force")
KICK = ("ch05_forces/particle.py", "Particle.kick")


@dataclass(frozen=True)
class Scene:
    """A scene: how to build its step, how often to make it, and the code that differs."""

    build: Callable[[], Step]
    times: int
    parts: tuple[tuple[str, str], ...]  # file and definition


def falling() -> Step:
    from ch02_vectors.vector import Vector3
    from ch03_laws_of_motion.particle import Particle

    particle = Particle(velocity=Vector3(1.0, 2.0), acceleration=Vector3(0.0, -9.81), damping=0.9)
    return lambda: particle.integrate(FRAME)


def on_a_spring(name: str) -> Step:
    from ch02_vectors.vector import Vector3
    from ch05_forces.forces import ForceRegistry
    from ch05_forces.particle import Particle
    from ch06_springs import integrators
    from ch06_springs.springs import AnchoredSpring

    particles = [Particle(Vector3(1.0, 2.0, 3.0), Vector3(1.0, 2.0, 3.0))]
    registry = ForceRegistry()
    # With this damping, k h < c, so explicit Euler is stable, too.
    registry.add(particles[0], AnchoredSpring(Vector3(), 100.0, 1.0, 2.0))
    step = getattr(integrators, name)
    return lambda: step(particles, registry.update_forces, FRAME)


def cloth() -> Step:
    from ch06_springs.going_further.cloth import make_cloth
    from ch06_springs.integrators import semi_implicit_euler

    knots, registry = make_cloth(0.2)
    return lambda: semi_implicit_euler(knots, registry.update_forces, CLOTH_STEP)


def bridge() -> Step:
    from ch08_mass_aggregate.bridge import Bridge

    rope_bridge = Bridge(x=2.0)
    return lambda: rope_bridge.step(FRAME)


def stack() -> Step:
    from ch02_vectors.vector import Vector3
    from ch05_forces.particle import Particle
    from ch07_constraints.detectors import GroundPlane, ParticlePairs
    from ch08_mass_aggregate.world import ParticleWorld

    down = Vector3(0.0, -9.81)
    balls = [Particle(Vector3(0.0, 0.5 + i), acceleration=down) for i in range(5)]
    world = ParticleWorld(balls, [GroundPlane(balls, radius=0.5), ParticlePairs(balls, 0.5)])
    return lambda: world.step(FRAME)


def integrator(name: str) -> Scene:
    """Return the scene of one particle on a spring."""
    parts = (("ch06_springs/integrators.py", name), SPRING, KICK)
    return Scene(partial(on_a_spring, name), 500, parts)


CONTACTS = (
    ("ch07_constraints/contacts.py", "Contact"),
    ("ch07_constraints/contacts.py", "ContactResolver"),
)
SCENES = {
    "a falling particle, `integrate`": Scene(
        falling, 2000, (("ch03_laws_of_motion/particle.py", "Particle.integrate"),)
    ),
    "a spring, explicit Euler": integrator("explicit_euler"),
    "a spring, semi-implicit Euler": integrator("semi_implicit_euler"),
    "a spring, leapfrog": integrator("leapfrog"),
    "a spring, velocity Verlet": integrator("velocity_verlet"),
    "a spring, Runge-Kutta 4": integrator("runge_kutta_4"),
    "a cloth of 180 springs": Scene(
        cloth, 10, (("ch06_springs/springs.py", "Connection.update_force"), KICK)
    ),
    "the rope bridge of chapter 8": Scene(bridge, 5, CONTACTS),
    "a stack of five balls": Scene(stack, 30, CONTACTS),
}


def main(folders: list[str]) -> None:
    """Make steps of the scenes that are asked for on standard input."""
    sys.path[:0] = folders
    steps = {name: (scene.build(), scene.times) for name, scene in SCENES.items()}
    for line in sys.stdin:
        step, times = steps[line.strip()]
        start = time.perf_counter()
        for _ in range(times):
            step()
        print(time.perf_counter() - start, flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
