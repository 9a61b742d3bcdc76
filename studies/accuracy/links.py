"""Scenes of rods: a pendulum, and a rope of thirty links.

What is counted is contacts resolved; a direct solve counts each of its rods once a step, and pymunk
goes through its joints ten times a step.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cache, partial
from itertools import pairwise
from typing import Any

from scipy.special import ellipj  # type: ignore[import-untyped]

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, explicit_euler, semi_implicit_euler
from ch07_constraints.angle_pendulum import AnglePendulum
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.direct_chain import DirectChain
from ch07_constraints.links import AnchoredRod, Rod, TwoSidedRod
from studies.accuracy.scene import MANY, RATE, STEPS, Model, Outcome, Place, Scene, in_frames
from studies.constraints import resolving

G = 10.0  # m/s^2
RESOLVED = "contacts resolved, or formulas"
LINKS, LENGTH = 30, 3.0  # of the rope, whose links are of 0.1 m and 0.1 kg
ANGLE = math.radians(30.0)  # from straight down, at the start


def pendulum() -> Scene:
    """A pendulum of 1 m that is let go where it is horizontal, for 5 s."""
    frames = 300

    def truth(time: float) -> Place:
        """By Jacobi's functions: sin(angle / 2) is sin(start / 2) cn / dn of t root g / l."""
        m = math.sin(0.25 * math.pi) ** 2
        _, cn, dn, _ = ellipj(math.sqrt(G) * time, m)
        half = math.asin(math.sqrt(m) * cn / dn)
        return math.sin(2.0 * half), -math.cos(2.0 * half)

    def particle() -> list[Particle]:
        return [Particle(Vector3(1.0), acceleration=Vector3(0.0, -G))]

    def by_angle(steps: int) -> Outcome:
        bob = AnglePendulum(1.0, 0.5 * math.pi, gravity=G)
        places = in_frames(bob.step, lambda: (bob.position.x, bob.position.y), frames, steps)
        return Outcome(places, 4 * frames * steps)

    def rod(chain: list[Particle]) -> list[Any]:
        return [AnchoredRod(chain[0], Vector3(), 1.0)]

    models = [
        Model("by its angle, Runge-Kutta 4", by_angle),
        Model("direct chain", partial(by_direct_chain, particle, frames)),
        *by_rods(particle, rod, frames),
        Model("pymunk, pin joint", partial(by_pin_joints, particle, frames), MANY, "pymunk"),
    ]
    return Scene("pendulum from horizontal", frames, 1.0, truth, models, RESOLVED)


def rope() -> Scene:
    """A rope of thirty rods, let go where it hangs 30 degrees askew, for a second.

    Its truth is the direct chain with 128 steps a frame, whose own error is a 16th of that with 32.
    """
    frames = 60

    @cache
    def fine() -> list[Place]:
        return by_direct_chain(rope_particles, frames, 128).places

    def truth(time: float) -> Place:
        return fine()[round(time * RATE) - 1]

    def rods(chain: list[Particle]) -> list[Any]:
        link = LENGTH / LINKS
        first = AnchoredRod(chain[0], Vector3(), link)
        return [first, *(Rod(a, b, link) for a, b in pairwise(chain))]

    def two_sided(chain: list[Particle]) -> list[Any]:
        link = LENGTH / LINKS
        still = Particle(mass=math.inf)
        return [TwoSidedRod(a, b, link) for a, b in pairwise([still, *chain])]

    steps = STEPS[:6]
    models = [
        Model("direct chain", partial(by_direct_chain, rope_particles, frames), steps),
        *by_rods(rope_particles, rods, frames, steps),
        Model(
            "semi-implicit Euler, two-sided rods",
            partial(by_resolver, semi_implicit_euler, rope_particles, two_sided, frames),
            steps,
        ),
        Model(
            "pymunk, pin joints",
            partial(by_pin_joints, rope_particles, frames),
            MANY,
            "pymunk",
        ),
    ]
    return Scene("rope of 30 links", frames, LENGTH, truth, models, RESOLVED)


def rope_particles() -> list[Particle]:
    """Return the rope at its start, from the top."""
    x, y = math.sin(ANGLE) * LENGTH / LINKS, -math.cos(ANGLE) * LENGTH / LINKS
    down = Vector3(0.0, -G)
    return [
        Particle(Vector3(i * x, i * y), acceleration=down, mass=0.1) for i in range(1, LINKS + 1)
    ]


def by_rods(
    make: Callable[[], list[Particle]],
    rods: Callable[[list[Particle]], list[Any]],
    frames: int,
    steps: Sequence[int] = STEPS,
) -> list[Model]:
    """Return the models of the book's rods, after its own step and after the other Euler step."""
    return [
        Model(f"{name}, rods", partial(by_resolver, integrator, make, rods, frames), steps, by)
        for name, integrator, by in (
            ("explicit Euler", explicit_euler, "the book"),
            ("semi-implicit Euler", semi_implicit_euler, "ours"),
        )
    ]


def by_resolver(
    integrator: Integrator,
    make: Callable[[], list[Particle]],
    rods: Callable[[list[Particle]], list[Any]],
    frames: int,
    steps: int,
) -> Outcome:
    """Step the particles, and resolve the contacts of their rods."""
    particles = make()
    links, resolver, work = rods(particles), ContactResolver(), 0

    def resolve(contacts: list[Contact], duration: float) -> None:
        nonlocal work
        resolver.resolve_contacts(contacts, duration)
        work += resolver.iterations_used

    step = resolving(integrator, particles, links, resolve)
    places = in_frames(step, lambda: _places(particles), frames, steps)
    return Outcome(places, work)


def by_direct_chain(make: Callable[[], list[Particle]], frames: int, steps: int) -> Outcome:
    """Solve for all rods at once."""
    particles = make()
    chain = DirectChain(particles, Vector3())
    places = in_frames(chain.step, lambda: _places(particles), frames, steps)
    return Outcome(places, frames * steps * len(particles))


def by_pin_joints(make: Callable[[], list[Particle]], frames: int, steps: int) -> Outcome:
    """Let pymunk hold the particles together."""
    import pymunk

    space = pymunk.Space()
    space.gravity = (0.0, -G)
    before, bodies = space.static_body, []
    for particle in make():
        body = pymunk.Body(particle.mass, math.inf)
        body.position = (particle.position.x, particle.position.y)
        space.add(body, pymunk.PinJoint(before, body))
        bodies.append(body)
        before = body
    places = in_frames(
        space.step, lambda: tuple(part for body in bodies for part in body.position), frames, steps
    )
    return Outcome(places, frames * steps * space.iterations * len(bodies))


def _places(particles: list[Particle]) -> Place:
    return tuple(part for p in particles for part in (p.position.x, p.position.y))


LINKED: list[Callable[[], Scene]] = [pendulum, rope]
