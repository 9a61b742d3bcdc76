"""A body that moves along a line, on a damped spring that is fixed to a wall.

Its position is 0 where the spring is relaxed.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.integrators import ApplyForces, Integrator
from ch06_springs.springs import AnchoredSpring
from scenes.integrators import INTEGRATORS, SOLVERS, Solver
from scenes.parameters import Slider
from scenes.readings import number
from scenes.setup import Setup, alone

STIFFNESS = Slider(100.0, "stiffness k", "N/m", 1.0, 20_000.0, log=True)
MASS = Slider(1.0, "mass m", "kg", 0.1, 10.0, log=True)
DAMPING = Slider(0.0, "damping c", "N s/m", 0.0, 20.0, step=0.1)
START = 1.0  # m, where the body is released; errors are given as fractions of it


@dataclass(frozen=True)
class SpringOnAWall:
    """The scene with a stiffness in N/m, a damping in N s/m and a mass in kg."""

    stiffness: float
    damping: float = 0.0
    mass: float = 1.0

    def setup(self) -> Setup:
        """Create the body at rest, and its spring."""
        body = Particle(Vector3(START), mass=self.mass)
        return alone(body, AnchoredSpring(Vector3(), self.stiffness, 0.0, self.damping))

    def state(self, time: float, x: float = START, v: float = 0.0) -> tuple[float, float]:
        """Compute the exact position in m and velocity in m/s at ``time`` s, as in chapter 6."""
        return damped_spring_state(x, v, self.stiffness, self.damping, self.mass, time)

    def solved_by(self, solver: Solver) -> Integrator:
        """Return an integrator that takes its steps with a solver for this spring.

        It ignores all forces. If the solver does not return two values, it raises ValueError.
        """

        def step(particles: Sequence[Particle], _: ApplyForces, duration: float) -> None:
            for body in particles:
                start = body.position.x, body.velocity.x
                end = solver(*start, self.stiffness, self.damping, body.mass, duration)
                if not (isinstance(end, tuple) and len(end) == 2):
                    raise ValueError(f"a solver must return the new x and v, got {end!r}")
                body.position.x, body.velocity.x = map(number, end)

        return step

    def methods(self) -> dict[str, Integrator]:
        """Return all integrators by name, including the solvers."""
        return INTEGRATORS | {name: self.solved_by(solver) for name, solver in SOLVERS.items()}

    @property
    def period(self) -> float:
        """The time of one oscillation without damping, in s."""
        return 2.0 * math.pi * math.sqrt(self.mass / self.stiffness)

    def per_step(self, duration: float) -> tuple[float, float]:
        """Return k h^2 / m and c h / m for a step of h s, which decide whether it is stable."""
        kappa = self.stiffness * duration * duration / self.mass
        return kappa, self.damping * duration / self.mass
