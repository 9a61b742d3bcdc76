"""Simulate a swinging chain of rods with our engine and with pymunk, and compute its exact motion.

The work of a simulation is counted rather than timed, so it does not depend on the computer's
speed. Most methods count the contacts that they resolve. A method that solves for all rods at once
counts every rod once per evaluation. In pymunk, pin joints act as the rods, and each joint counts
once per iteration.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
from typing import Any

import numpy

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import (
    Integrator,
    explicit_euler,
    runge_kutta_4,
    semi_implicit_euler,
)
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.links import AnchoredRod, Rod
from scenes.constraints import resolving
from studies.accuracy.in_plane import in_plane
from studies.accuracy.in_pymunk import EXAMPLES, InSpace, at_best, by_pymunk, from_two_runs
from studies.accuracy.scene import (
    STEPS,
    Model,
    Outcome,
    Place,
    flat,
    in_frames,
    places_of,
    solved,
)
from studies.models.angle_chain import AngleChain
from studies.models.angle_rope import AngleRope
from studies.models.order_8 import Numbers
from studies.models.plane_rods import accelerations_on_rods
from studies.models.rod_tensions import RodTensions

COUNTED = "contacts resolved, or rods solved for"


@dataclass(frozen=True)
class Chain:
    """A straight chain of rods that hangs from the origin and is released from rest.

    Each rod has a particle at its lower end.

    - ``masses``: the masses of the particles in kg, from the top to the tip.
    - ``length``: the length of every rod in m.
    - ``angle``: the initial angle between the chain and the vertical, in radians.
    - ``gravity``: the gravitational acceleration in m/s^2, as a positive number.
    """

    length: float
    masses: Sequence[float]
    angle: float
    gravity: float
    frames: int

    def particles(self) -> list[Particle]:
        """Create the particles of the chain at their initial positions, from the top to the tip."""
        x, y = self.length * math.sin(self.angle), -self.length * math.cos(self.angle)
        down = Vector3(0.0, -self.gravity)
        return [
            Particle(Vector3(i * x, i * y), acceleration=down, mass=mass)
            for i, mass in enumerate(self.masses, 1)
        ]

    def rods(self, particles: Sequence[Particle]) -> list[Any]:
        """Create the rods between neighboring particles, and from the origin to the first one."""
        first = AnchoredRod(particles[0], Vector3(), self.length)
        return [first, *(Rod(a, b, self.length) for a, b in pairwise(particles))]

    def angles(self) -> tuple[list[float], Sequence[float], list[float]]:
        """Return the lengths, masses and initial angles of the rods as arguments for AngleChain."""
        count = len(self.masses)
        return [self.length] * count, self.masses, [self.angle] * count

    def by_its_angles(self) -> AngleChain:
        """Create an AngleChain, which describes the chain by the angles of its rods.

        If all masses are equal, create an AngleRope instead, which is faster.
        """
        _, masses, angles = self.angles()
        if len(set(masses)) == 1:
            return AngleRope(self.length, masses[0], angles, gravity=self.gravity)
        return AngleChain(*self.angles(), gravity=self.gravity)

    def rates(self, _: float, state: Any) -> Any:
        """Return the rates of all angles and angular velocities, by Lagrange's equations.

        Rod i is at the angle a_i from the vertical, and its angular velocity is w_i. Every rod has
        length l, and g is the gravitational acceleration. The equation for rod i is

            sum_j M_ij l (w_j' cos(a_i - a_j) + w_j^2 sin(a_i - a_j)) = -M_i g sin a_i

        M_i is the total mass from rod i out to the tip. M_ij is M_i or M_j, whichever belongs to
        the rod farther from the anchor.
        """
        count = len(self.masses)
        below = numpy.cumsum(self.masses[::-1])[::-1]
        hung = self.length * below[numpy.maximum.outer(range(count), range(count))]
        a, w = state[:count], state[count:]
        apart = a[:, None] - a
        pull = (hung * numpy.sin(apart)) @ w**2 + below * self.gravity * numpy.sin(a)
        return numpy.append(w, numpy.linalg.solve(hung * numpy.cos(apart), -pull))

    def truth(self) -> Callable[[float], Place]:
        """Return the exact motion of the chain of rods as a function of time, computed by SciPy."""
        count = len(self.masses)

        def place(state: Any) -> Place:
            x = numpy.cumsum(self.length * numpy.sin(state[:count]))
            y = numpy.cumsum(-self.length * numpy.cos(state[:count]))
            return tuple(map(float, numpy.stack([x, y], axis=1).ravel()))

        start = [*[self.angle] * count, *[0.0] * count]
        return solved(self.rates, start, place, self.frames)


def models_of(chain: Chain, steps: Sequence[int] = STEPS, *iterations: int) -> list[Model]:
    """Create all models of a chain of rods, ours first and then pymunk's.

    A model is one way to simulate the chain, for example with a certain integrator. ``steps`` lists
    the numbers of steps per frame with which most of our models are run. ``iterations`` lists how
    often pymunk's solver runs in each step when it is at its best.
    """
    start = [complex(body.position.x, body.position.y) for body in chain.particles()]
    rods = accelerations_on_rods(chain.masses, [chain.length] * len(start), chain.gravity)
    best = [by_pymunk(at_best(n), ahead(chain, n), chain.frames) for n in iterations]
    return [
        Model("by its angles, Runge-Kutta 4", partial(by_angles, chain), steps, is_formula=True),
        *by_angles_of_high_order(chain),
        *in_plane(start, [0j] * len(start), rods, chain.frames, is_damped=True),
        Model("rods as forces, Runge-Kutta 4", partial(by_tensions, chain), steps),
        Model("direct chain", partial(by_direct_chain, chain), steps),
        *(
            Model(f"{name}, rods", partial(by_resolver, chain, integrator, chain.rods), steps, by)
            for name, integrator, by in (
                ("explicit Euler", explicit_euler, "the book"),
                ("semi-implicit Euler", semi_implicit_euler, "ours"),
            )
        ),
        by_pymunk(EXAMPLES, partial(in_space, chain, 10), chain.frames),  # its default
        *best,
        *map(from_two_runs, best),
    ]


def by_angles(chain: Chain, steps: int) -> Outcome:
    """Simulate a chain of rods with Runge-Kutta 4, using the angles of the rods as variables.

    There are four evaluations per time step. Each one counts every rod as one unit of work.
    """
    angles = chain.by_its_angles()
    places = in_frames(angles.step, lambda: flat(angles.positions), chain.frames, steps)
    return Outcome(places, 4 * chain.frames * steps * len(chain.masses))


def by_angles_of_high_order(chain: Chain) -> list[Model]:
    """Create the models that step the angles of the rods with methods of high order."""
    angles = chain.by_its_angles()

    def accelerations(turned: Numbers, turning: Numbers) -> Numbers:
        angles.angles, angles.angular_velocities = turned, turning  # type: ignore[assignment]
        return [*angles.accelerations()]

    def place(turned: Sequence[Any]) -> Place:
        parts, x, y = [], 0.0, 0.0
        for angle in turned:
            x += chain.length * math.sin(angle)
            y -= chain.length * math.cos(angle)
            parts.append(x)
            parts.append(y)
        return tuple(parts)

    start = [chain.angle] * len(chain.masses)
    models = in_plane(
        start,
        [0.0] * len(start),
        accelerations,
        chain.frames,
        is_damped=len(start) > 1,
        place=place,
    )
    return [
        replace(model, name=f"by its angles, {model.name}", is_formula=True) for model in models
    ]


def by_tensions(chain: Chain, steps: int) -> Outcome:
    """Simulate a chain of rods with Runge-Kutta 4, treating the rods' tensions as forces."""
    particles = chain.particles()
    rods = RodTensions(particles, Vector3())
    places = in_frames(
        lambda duration: runge_kutta_4(particles, rods.update_forces, duration),
        lambda: places_of(particles),
        chain.frames,
        steps,
    )
    return Outcome(places, 4 * chain.frames * steps * len(particles))


def by_direct_chain(chain: Chain, steps: int) -> Outcome:
    """Simulate a chain of rods with DirectChain, which computes all tensions at once."""
    particles = chain.particles()
    solver = DirectChain(particles, Vector3())
    places = in_frames(solver.step, lambda: places_of(particles), chain.frames, steps)
    return Outcome(places, chain.frames * steps * len(particles))


def by_resolver(
    chain: Chain,
    integrator: Integrator,
    rods: Callable[[Sequence[Particle]], list[Any]],
    steps: int,
) -> Outcome:
    """Simulate a chain of rods with an integrator, and resolve its contacts after each step."""
    particles = chain.particles()
    resolver, work = ContactResolver(), 0

    def resolve(contacts: list[Contact], duration: float) -> None:
        nonlocal work
        resolver.resolve_contacts(contacts, duration)
        work += resolver.iterations_used

    step = resolving(integrator, particles, rods(particles), resolve)
    places = in_frames(step, lambda: places_of(particles), chain.frames, steps)
    return Outcome(places, work)


def in_space(chain: Chain, iterations: int, _: float) -> InSpace:
    """Create the chain in pymunk, where pin joints act as the rods.

    Pymunk's solver makes ``iterations`` iterations per step.
    """
    import pymunk

    space = pymunk.Space()
    space.gravity, space.iterations = (0.0, -chain.gravity), iterations
    before, bodies = space.static_body, []
    x, y = chain.length * math.sin(chain.angle), -chain.length * math.cos(chain.angle)
    for i, mass in enumerate(chain.masses, 1):
        body = pymunk.Body(mass, math.inf)
        body.position = (i * x, i * y)
        space.add(body, pymunk.PinJoint(before, body))
        bodies.append(body)
        before = body
    return space, bodies


def ahead(chain: Chain, iterations: int) -> Callable[[float], InSpace]:
    """Return a function that creates the chain in pymunk at its best.

    It starts half a step ahead, and its joints have no bias.
    """
    count = len(chain.masses)
    turning = chain.rates(0.0, numpy.array([chain.angle] * count + [0.0] * count))[count:]
    along, up = math.cos(chain.angle), math.sin(chain.angle)
    first = [
        (float(gain * along), float(gain * up)) for gain in numpy.cumsum(turning * chain.length)
    ]

    def make(duration: float) -> InSpace:
        space, bodies = in_space(chain, iterations, duration)
        half = 0.5 * duration
        for body, joint, (x, y) in zip(bodies, space.constraints, first, strict=True):
            body.velocity, joint.error_bias = (half * x, half * y), 0.0
        return space, bodies

    return make
