"""Three ways to let pymunk take a time step of a body on a damped spring.

They have the form of the solvers of chapter 6, so that their limits can be found in the same way.
"""

from __future__ import annotations

import math
from functools import partial

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring
from scenes.integrators import Solver
from scenes.setup import alone
from scenes.twin import twin_of

ON_SPRING = ("pymunk's spring", "pymunk, by hand")


def pymunk_step(
    name: str, x: float, v: float, k: float, c: float, mass: float, duration: float
) -> tuple[float, float]:
    """Take a time step with one of pymunk's springs, a force by hand, or the space's damping."""
    damping = math.exp(-c / mass) if name == "pymunk's space.damping" else 1.0
    body = Particle(Vector3(x), Vector3(v), mass=mass, damping=damping)
    springs = [AnchoredSpring(Vector3(), k, 0.0, c)] if name == "pymunk's spring" else []
    space, (twin,) = twin_of(alone(body, *springs))
    if name == "pymunk, by hand":
        twin.force = -k * x - c * v, 0.0
    space.step(duration)
    return twin.position.x, twin.velocity.x


PYMUNK: dict[str, Solver] = {
    name: partial(pymunk_step, name) for name in (*ON_SPRING, "pymunk's space.damping")
}
