"""Measure the steps of integrators with one spring, and three versions of a cloth of springs."""

from __future__ import annotations

from collections.abc import Callable

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.going_further.cloth import REST_LENGTH, STIFFNESS, make_cloth, neighbors
from ch06_springs.integrators import Integrator
from ch06_springs.springs import AnchoredSpring, Spring, spring_force
from scenes.integrators import INTEGRATORS
from scenes.timing import Measurement, Target, timer, versus
from studies.models.plain_numbers import cloth_in_numbers, spring_in_numbers

DAMPING = 0.2  # N s/m, of all springs
FRAME = 1.0 / 2400.0  # s, short enough for the book's step to be stable with this cloth
FRAMES = 120
ROUNDS = 21

SPRING = 100.0, 1.0  # stiffness in N/m and rest length in m, of one spring
STEP = 1.0 / 60.0  # s
STEPS = 2000
LONE_ROUNDS = 51


def lines() -> list[Measurement]:
    """Set up the benchmarks of springs. The cloths are built once, and fall on in every round."""
    whole, ends = make_cloth(DAMPING), make_cloth_of_ends()
    connected, apart = timer(lambda: steps(*whole)), timer(lambda: steps(*ends))
    once = timer(stepping(INTEGRATORS["semi-implicit Euler"]))
    others = {
        "leapfrog": Target("at most", 1.1),
        "velocity Verlet": None,
        "Runge-Kutta 4": Target("at most", 4.0),
    }
    return [
        Measurement(
            "a cloth of 180 springs with connect / the same arithmetic in one loop",
            versus(connected, timer(lambda: cloth_in_numbers(DAMPING, FRAME, FRAMES))),
            ROUNDS,
            Target("at most", 1.75),
        ),
        Measurement(
            "a cloth with two Spring objects per spring, in vectors / with connect, in floats",
            versus(apart, connected),
            ROUNDS,
            Target("at least", 4),
        ),
        Measurement(
            "one particle on a spring: a semi-implicit Euler step / the same arithmetic",
            versus(once, timer(lambda: spring_in_numbers(*SPRING, DAMPING, STEP, STEPS))),
            LONE_ROUNDS,
            Target("at most", 6.6),  # nine tenths of the cost before kick and drift existed
        ),
        *(
            Measurement(
                f"one particle on a spring: a {name} step / a semi-implicit Euler step",
                versus(timer(stepping(INTEGRATORS[name])), once),
                LONE_ROUNDS,
                target,
            )
            for name, target in others.items()
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
    """Build a cloth with two force generators per spring, so that each force is computed twice."""
    knots, _ = make_cloth(DAMPING)
    registry = ForceRegistry()
    for i, j in neighbors():
        a, b = knots[i], knots[j]
        registry.add(a, VectorSpring(b, STIFFNESS, REST_LENGTH, DAMPING))
        registry.add(b, VectorSpring(a, STIFFNESS, REST_LENGTH, DAMPING))
    return knots, registry


def steps(knots: list[Particle], registry: ForceRegistry) -> float:
    """Simulate a cloth with explicit Euler, and return the height of its lowest knot."""
    for _ in range(FRAMES):
        registry.update_forces(FRAME)
        for knot in knots:
            knot.integrate(FRAME)
    return min(knot.position.y for knot in knots)


def stepping(integrator: Integrator) -> Callable[[], None]:
    """Return a function that moves a particle on a spring by STEPS further time steps."""
    particle = Particle(Vector3(1.0, 2.0, 3.0), Vector3(1.0, 2.0, 3.0))
    registry = ForceRegistry()
    registry.add(particle, AnchoredSpring(Vector3(), *SPRING, DAMPING))
    particles = [particle]

    def run() -> None:
        for _ in range(STEPS):
            integrator(particles, registry.update_forces, STEP)

    return run
