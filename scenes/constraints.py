"""Simulate a bouncing ball, a hanging chain or a pendulum, and record values over time.

Most of these simulations use an integrator of chapter 6, and resolve contacts after each time step.
Gravity is 10 m/s^2, downward. Lengths are in m, and times are in s.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from typing import Protocol

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Gravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import ApplyForces, Integrator, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactGenerator, ContactResolver
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.links import AnchoredRod
from ch07_constraints.time_division import TooManyImpacts, time_division_step
from scenes.readings import Numbers, numbers
from scenes.track import Move, Track, track

GRAVITY = 10.0
LINK = 0.1
RADIUS = 0.5

Resolve = Callable[[list[Contact], float], object]


class Link(Protocol):
    """A class whose instances keep two particles at a given distance, such as TwoSidedRod."""

    def __call__(self, a: Particle, b: Particle, length: float, /) -> ContactGenerator: ...


def no_forces(duration: float) -> None:
    """Do nothing, because gravity is already included in the particles' own acceleration."""
    del duration


def resolving(
    step: Integrator,
    particles: Sequence[Particle],
    generators: Iterable[ContactGenerator],
    resolve: Resolve,
    apply_forces: ApplyForces = no_forces,
    substeps: int = 1,
) -> Move:
    """Build a function that simulates particles for one frame and resolves their contacts.

    A frame is divided into ``substeps`` equal time steps. In each time step, ``step`` moves the
    particles, the ``generators`` find the contacts, and ``resolve`` resolves them.
    """
    every = [*generators]

    def move(duration: float) -> None:
        part = duration / substeps
        for _ in range(substeps):
            step(particles, apply_forces, part)
            resolve([contact for some in every for contact in some.contacts()], part)

    return move


def by_resolver(iterations: int | None = None) -> Resolve:
    """Build a function that resolves contacts with a limited number of iterations.

    The limit is ``iterations`` per contact, or 2 by default.
    """

    def resolve(contacts: list[Contact], duration: float) -> None:
        if contacts:
            limit = None if iterations is None else iterations * len(contacts)
            ContactResolver(limit).resolve_contacts(contacts, duration)

    return resolve


def without_rule(contacts: list[Contact], duration: float) -> None:
    """Resolve contacts without the special rule for resting contacts.

    This rule keeps the restitution from being applied to the velocity that gravity adds in a time
    step. A plot shows what happens without it.
    """
    del duration
    for contact in contacts:
        contact.resolve_velocity()
        contact.resolve_penetration()


def no_bounce_below(speed: float) -> Resolve:
    """Build a function that resolves contacts without a bounce if they close slower than ``speed``.

    ``speed`` is in m/s. A plot compares this rule with the engine's less strict rule for resting
    contacts.
    """

    def resolve(contacts: list[Contact], duration: float) -> None:
        for contact in contacts:
            if contact.separating_velocity() > -speed:
                contact.restitution = 0.0
            contact.resolve(duration)

    return resolve


def ball(
    step: Integrator,
    height: float,
    restitution: float,
    frames: int,
    resolve: Resolve | None = None,
    generated: bool = False,
) -> Track:
    """Drop a ball, and record its height above the ground over time.

    If ``generated`` is true, a force generator applies gravity. Otherwise gravity is the particle's
    own acceleration. If ``resolve`` is None, a ContactResolver resolves the contacts.
    """
    down = Vector3(0.0, -GRAVITY)
    particle = Particle(Vector3(0.0, height), acceleration=None if generated else down)
    gravity = Gravity(down)

    def apply_forces(duration: float) -> None:
        if generated:
            gravity.update_force(particle, duration)

    ground = GroundPlane([particle], restitution=restitution)
    move = resolving(step, [particle], [ground], resolve or by_resolver(), apply_forces)
    return track(move, lambda: numbers(particle.position)[1], frames)


def ball_by_time_division(height: float, restitution: float, frames: int) -> Track:
    """Drop a ball, simulate it with time_division_step, and record its height over time.

    The function time_division_step stops a time step at each impact. When the ball comes to rest,
    the impacts follow too quickly, and the function raises TooManyImpacts. The recording ends at
    the time that is stored in this exception.
    """
    particle = Particle(Vector3(0.0, height), acceleration=Vector3(0.0, -GRAVITY))
    ground = GroundPlane([particle], restitution=restitution)
    last = []

    def move(duration: float) -> None:
        try:
            time_division_step([particle], ground, duration)
        except TooManyImpacts as error:
            last.append(error.time)
            raise

    run = track(move, lambda: numbers(particle.position)[1], frames)
    if not last:
        return run
    times = [*run.times, run.times[-1] + last[0]]
    return Track(times, [*run.values, numbers(particle.position)[1]], run.message)


def chain_particles(count: int, angle: float = 0.0) -> list[Particle]:
    """Create the particles of a straight chain, the first of which cannot move.

    ``angle`` is the angle between the chain and the vertical, in degrees.
    """
    x, y = LINK * math.sin(math.radians(angle)), -LINK * math.cos(math.radians(angle))
    down = Vector3(0.0, -GRAVITY)
    chain = [Particle(Vector3(i * x, i * y), acceleration=down) for i in range(1, count + 1)]
    return [Particle(mass=math.inf), *chain]


def chain(
    count: int,
    link: Link,
    resolve: Resolve,
    frames: int,
    angle: float = 0.0,
    substeps: int = 1,
) -> tuple[Track, Track]:
    """Release a chain of links, and record over time how much longer it is than it should be.

    Returns:
        Two values over time. The first one is the excess length of the whole chain. The second one
        is the largest error in the length of a single link, whether it is too long or too short.
    """
    particles = chain_particles(count, angle)
    links = [link(a, b, LINK) for a, b in pairwise(particles)]
    move = resolving(semi_implicit_euler, particles[1:], links, resolve, substeps=substeps)
    return _lengths(move, particles, frames)


def chain_by_direct_solve(count: int, frames: int, angle: float = 0.0) -> tuple[Track, Track]:
    """Release a chain that is simulated as a DirectChain, and record its errors in length.

    Returns:
        The excess length of the whole chain over time, and the largest error in the length of a
        single link over time.
    """
    particles = chain_particles(count, angle)
    return _lengths(DirectChain(particles[1:], Vector3()).step, particles, frames)


def pendulum(step: Integrator | None, rate: int, seconds: float) -> Track:
    """Release a pendulum from a horizontal position, and record its energy in J over time.

    The bob has a mass of 1 kg, and the rod is 1 m long. The energy is measured relative to the
    lowest point, so it starts at 10 J. The integrator ``step`` moves the bob, and its AnchoredRod
    is resolved after each step.

    If ``step`` is None, the pendulum is simulated as a DirectChain. A DirectChain stores the
    velocity halfway between two positions. The energy at a position is therefore computed from the
    mean of the velocities before and after it.
    """
    particle = Particle(Vector3(1.0), acceleration=Vector3(0.0, -GRAVITY))
    frames = round(seconds * rate)
    states: list[tuple[Numbers, Numbers]] = []

    def measure() -> float:
        states.append((numbers(particle.position), numbers(particle.velocity)))
        return _energy(*states[-1])

    if step is not None:
        rod = AnchoredRod(particle, Vector3(), 1.0)
        move = resolving(step, [particle], [rod], by_resolver())
        return track(move, measure, frames, 1.0 / rate)
    run = track(DirectChain([particle], Vector3()).step, measure, frames, 1.0 / rate)
    energies = run.values[:1]
    for (place, before), (_, after) in pairwise(states[1:]):
        middle = [0.5 * (v + w) for v, w in zip(before, after, strict=True)]
        energies.append(_energy(place, (middle[0], middle[1], middle[2])))
    return Track(run.times[: len(energies)], energies[: len(run.times)], run.message)


def _energy(place: Numbers, velocity: Numbers) -> float:
    """Compute the energy in J of a 1 kg pendulum bob, relative to its lowest point."""
    return GRAVITY * (1.0 + place[1]) + 0.5 * math.fsum(v * v for v in velocity)


def _lengths(move: Move, particles: list[Particle], frames: int) -> tuple[Track, Track]:
    worst = []

    def measure() -> float:
        places = [numbers(particle.position) for particle in particles]
        off = [math.dist(a, b) - LINK for a, b in pairwise(places)]
        worst.append(max(map(abs, off)))
        return math.fsum(off)

    run = track(move, measure, frames)
    return run, Track(run.times, worst[: len(run.times)], run.message)
