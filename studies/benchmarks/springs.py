"""Compare the speed of three ways to simulate the springs of a cloth.

The first way calls ``connect`` for each spring, and the second creates two ``Spring`` objects, one
for each end. The third way is a loop that does the same arithmetic without any objects.
"""

from __future__ import annotations

import math

from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.going_further.cloth import (
    KNOTS,
    MASS,
    REST_LENGTH,
    STIFFNESS,
    G,
    make_cloth,
    neighbors,
)
from ch06_springs.springs import Spring, spring_force
from scenes.timing import Measurement, Target, timer, versus

DAMPING = 0.2  # N s/m
FRAME = 1.0 / 2400.0  # s, short enough for the book's step to be stable with this cloth
FRAMES = 120
ROUNDS = 21


def lines() -> list[Measurement]:
    """Set up the benchmarks that compare three ways to simulate the springs of a cloth.

    They are ``connect``, two Spring objects per spring, and a loop with plain arithmetic. The
    engine's cloths are built only once, so they keep falling from one round to the next.
    """
    whole, ends = make_cloth(DAMPING), make_cloth_of_ends()
    connected, apart = timer(lambda: steps(*whole)), timer(lambda: steps(*ends))
    return [
        Measurement(
            "a cloth of 180 springs with connect / the same arithmetic in one loop",
            versus(connected, timer(cloth_arithmetic)),
            ROUNDS,
            Target("at most", 1.75),
        ),
        Measurement(
            "a cloth with two Spring objects per spring, in vectors / with connect, in floats",
            versus(apart, connected),
            ROUNDS,
            Target("at least", 4),
        ),
    ]


class VectorSpring(Spring):
    """A spring written with vector operators, as most students write it at first."""

    def update_force(self, particle: Particle, duration: float) -> None:  # noqa: ARG002
        offset = particle.position - self.other.position
        velocity = particle.velocity - self.other.velocity
        force = spring_force(offset, velocity, self.stiffness, self.rest_length, self.damping)
        particle.add_force(force)


def make_cloth_of_ends() -> tuple[list[Particle], ForceRegistry]:
    """Build a cloth of springs with two force generators per spring, one for each end.

    The force of each spring is therefore computed twice in every step.
    """
    knots, _ = make_cloth(DAMPING)
    registry = ForceRegistry()
    for i, j in neighbors():
        a, b = knots[i], knots[j]
        registry.add(a, VectorSpring(b, STIFFNESS, REST_LENGTH, DAMPING))
        registry.add(b, VectorSpring(a, STIFFNESS, REST_LENGTH, DAMPING))
    return knots, registry


def steps(knots: list[Particle], registry: ForceRegistry) -> float:
    """Simulate a cloth of springs with explicit Euler, and return the height of its lowest knot."""
    for _ in range(FRAMES):
        registry.update_forces(FRAME)
        for knot in knots:
            knot.integrate(FRAME)
    return min(knot.position.y for knot in knots)


def cloth_arithmetic() -> float:
    """Simulate a cloth of springs with plain arithmetic, and return the height of the lowest knot.

    As in the engine, each step computes the forces of all springs before it moves the knots. The
    extra time that the engine takes is therefore the cost of its objects.
    """
    count = KNOTS * KNOTS
    x = [REST_LENGTH * (i % KNOTS) for i in range(count)]
    y = [0.0] * count
    z = [REST_LENGTH * (i // KNOTS) for i in range(count)]
    u, v, w = [0.0] * count, [0.0] * count, [0.0] * count
    inverse_mass = [1.0 / MASS] * count
    inverse_mass[0] = inverse_mass[KNOTS - 1] = 0.0
    springs = [(i, j, STIFFNESS, REST_LENGTH, DAMPING) for i, j in neighbors()]
    for _ in range(FRAMES):
        fx, fy, fz = [0.0] * count, [0.0] * count, [0.0] * count
        for i, j, stiffness, rest, damping in springs:
            dx = x[i] - x[j]
            dy = y[i] - y[j]
            dz = z[i] - z[j]
            length = math.hypot(dx, dy, dz)
            if length == 0.0:
                continue
            rate = ((u[i] - u[j]) * dx + (v[i] - v[j]) * dy + (w[i] - w[j]) * dz) / length
            pull = (stiffness * (rest - length) - damping * rate) / length
            dx *= pull
            dy *= pull
            dz *= pull
            fx[i] += dx
            fy[i] += dy
            fz[i] += dz
            fx[j] -= dx
            fy[j] -= dy
            fz[j] -= dz
        for i in range(count):
            inverse = inverse_mass[i]
            if inverse:
                x[i] += u[i] * FRAME
                y[i] += v[i] * FRAME
                z[i] += w[i] * FRAME
                u[i] += fx[i] * inverse * FRAME
                v[i] += (fy[i] * inverse - G) * FRAME
                w[i] += fz[i] * inverse * FRAME
    return min(y)
