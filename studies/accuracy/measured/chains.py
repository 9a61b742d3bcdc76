"""Measure swinging chains of rods beside pymunk: two pendulums, five rods and a rope.

The work is the number of contacts resolved. Where all rods are solved for at once, each of them
counts once per evaluation. In pymunk, each pin joint counts once per iteration.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

import numpy

from ch02_vectors.vector import Vector3
from ch06_springs.integrators import (
    Integrator,
    explicit_euler,
    runge_kutta_4,
    semi_implicit_euler,
)
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.going_further.angle_pendulum import AnglePendulum, DoublePendulum
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.links import TwoSidedRod
from scenes.chain import Chain
from scenes.resolving import resolving
from scenes.setup import Setup
from scenes.twin import InSpace, twin_of
from studies.accuracy.in_plane import in_plane
from studies.accuracy.in_pymunk import EXAMPLES, at_best, by_pymunk, from_two_runs
from studies.accuracy.scene import (
    STEPS,
    Made,
    Model,
    Outcome,
    Place,
    Scene,
    by_steps,
    flat,
    in_frames,
    places_of,
    solved,
)
from studies.models.angle_chain import AngleChain
from studies.models.angle_rope import AngleRope
from studies.models.chain_motion import pendulum_at, rates
from studies.models.order_8 import Numbers
from studies.models.plane_rods import accelerations_on_rods
from studies.models.rod_tensions import RodTensions

G = 9.81  # m/s^2
ROUND_G = 10.0  # m/s^2, in the scenes of the pendulum and of the rope
COUNTED = "contacts resolved, or rods solved for"


def pendulum() -> Scene:
    """Create the scene of a 1 m pendulum that is released from horizontal and swings for 5 s."""
    chain, frames = Chain([1.0], 1.0, 0.5 * math.pi), 300

    def by_angle(_: float) -> Made:
        bob = AnglePendulum(1.0, chain.angle, gravity=ROUND_G)
        return bob.step, lambda: flat([bob.position])

    _, *others = models_of(chain, frames, STEPS, 1)  # by_angle replaces the first one
    first = by_steps("by its angle, Runge-Kutta 4", by_angle, frames, 4, is_formula=True)
    truth = partial(pendulum_at, chain)
    return Scene("pendulum from horizontal", frames, 1.0, truth, [first, *others], COUNTED)


def double_pendulum() -> Scene:
    """Create the scene of two bobs of 1 kg on two rods of 1 m, which swing for 2 s."""
    chain, frames = Chain([1.0, 1.0], 1.0, math.radians(60.0), G), 120

    def by_two_angles(_: float) -> Made:
        bobs = DoublePendulum([1.0, 1.0], chain.masses, [chain.angle] * 2, gravity=G)
        return bobs.step, lambda: flat(bobs.positions)

    first = by_steps("by its two angles, Runge-Kutta 4", by_two_angles, frames, 4, is_formula=True)
    models = [first, *models_of(chain, frames, STEPS, 2, 10)]
    return Scene("double pendulum", frames, 1.0, exact(chain, frames), models, COUNTED)


def heavy_tip() -> Scene:
    """Create the scene of five rods of 1 m, with 10 kg at the tip, which swing for 2 s."""
    chain, frames = Chain([1.0, 1.0, 1.0, 1.0, 10.0], 1.0, math.radians(60.0), G), 120
    models = models_of(chain, frames, STEPS, 35, 50)
    return Scene("five rods, heavy tip", frames, 1.0, exact(chain, frames), models, COUNTED)


def rope() -> Scene:
    """Create the scene of a rope of thirty rods of 0.1 m and 0.1 kg, which swings for 1 s."""
    chain, frames, steps = Chain([0.1] * 30, 0.1, math.radians(30.0)), 60, STEPS[:6]
    run = partial(by_resolver, partial(chain.setup, TwoSidedRod), frames, semi_implicit_euler)
    models = models_of(chain, frames, steps, 100, 300)
    models.append(Model("semi-implicit Euler, two-sided rods", run, steps))
    return Scene("rope of 30 links", frames, 3.0, exact(chain, frames), models, COUNTED)


def exact(chain: Chain, frames: int) -> Callable[[float], Place]:
    """Return the exact motion as a function of time, which SciPy computes from the angles."""
    count = len(chain.masses)
    start = [*[chain.angle] * count, *[0.0] * count]
    return solved(partial(rates, chain), start, lambda state: chain.place(state[:count]), frames)


def models_of(chain: Chain, frames: int, steps: Sequence[int], *iterations: int) -> list[Model]:
    """Create our models of a chain, and pymunk's, at best with each number of ``iterations``."""
    count = len(chain.masses)
    lengths, angles, still = [chain.length] * count, [chain.angle] * count, [0.0] * count

    def make_angles() -> AngleChain:
        if len(set(chain.masses)) == 1:  # the faster one
            return AngleRope(chain.length, chain.masses[0], angles, gravity=chain.gravity)
        return AngleChain(lengths, chain.masses, angles, gravity=chain.gravity)

    def angled(_: float) -> Made:
        made = make_angles()
        return made.step, lambda: flat(made.positions)

    def tense(_: float) -> Made:
        particles = chain.particles()
        rods = RodTensions(particles, Vector3())
        return partial(runge_kutta_4, particles, rods.update_forces), partial(places_of, particles)

    def direct(_: float) -> Made:
        particles = chain.particles()
        return DirectChain(particles, Vector3()).step, partial(places_of, particles)

    kept = make_angles()

    def accelerations(turned: Numbers, turning: Numbers) -> Numbers:
        kept.angles, kept.angular_velocities = turned, turning  # type: ignore[assignment]
        return [*kept.accelerations()]

    high = in_plane(angles, still, accelerations, frames, is_damped=count > 1, place=chain.place)
    start = [complex(body.position.x, body.position.y) for body in chain.particles()]
    rods = accelerations_on_rods(chain.masses, lengths, chain.gravity)
    resolved = partial(by_resolver, chain.setup, frames)
    best = [by_pymunk(at_best(n), ahead(chain, n), frames) for n in iterations]
    return [
        by_steps("by its angles, Runge-Kutta 4", angled, frames, 4 * count, steps, is_formula=True),
        *(replace(one, name=f"by its angles, {one.name}", is_formula=True) for one in high),
        *in_plane(start, [0j] * count, rods, frames, is_damped=True),
        by_steps("rods as forces, Runge-Kutta 4", tense, frames, 4 * count, steps),
        by_steps("direct chain", direct, frames, count, steps),
        Model("explicit Euler, rods", partial(resolved, explicit_euler), steps, "the book"),
        Model("semi-implicit Euler, rods", partial(resolved, semi_implicit_euler), steps),
        by_pymunk(EXAMPLES, lambda _: twin_of(chain.setup()), frames),
        *best,
        *map(from_two_runs, best),
    ]


def by_resolver(
    make: Callable[[], Setup], frames: int, integrator: Integrator, steps: int
) -> Outcome:
    """Simulate a chain with an integrator, and resolve its contacts after each step."""
    setup, resolver, work = make(), ContactResolver(), 0

    def resolve(contacts: list[Contact], duration: float) -> None:
        nonlocal work
        resolver.resolve_contacts(contacts, duration)
        work += resolver.iterations_used

    step = resolving(integrator, setup.particles, setup.contacts, resolve)
    return Outcome(in_frames(step, lambda: places_of(setup.particles), frames, steps), work)


def ahead(chain: Chain, iterations: int) -> Callable[[float], InSpace]:
    """Return a function that creates the chain in pymunk, half a step ahead and without bias."""
    count = len(chain.masses)
    turning = rates(chain, 0.0, numpy.array([chain.angle] * count + [0.0] * count))[count:]
    along, up = math.cos(chain.angle), math.sin(chain.angle)
    first = [(float(v * along), float(v * up)) for v in numpy.cumsum(turning * chain.length)]

    def make(duration: float) -> InSpace:
        space, bodies = twin_of(chain.setup(), iterations=iterations)
        half = 0.5 * duration
        for body, joint, (x, y) in zip(bodies, space.constraints, first, strict=True):
            body.velocity, joint.error_bias = (half * x, half * y), 0.0
        return space, bodies

    return make


CHAINS: list[Callable[[], Scene]] = [pendulum, double_pendulum, heavy_tip, rope]
