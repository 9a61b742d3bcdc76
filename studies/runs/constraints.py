"""Simulate a bouncing ball, a hanging chain or a pendulum, and record values over time.

Each simulation runs in equal time steps with an integrator of chapter 6, and resolves contacts
after each step unless it has a method of its own. Gravity is 10 m/s^2, downward. Lengths are in m,
and times are in s.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Protocol

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Gravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import ApplyForces, Integrator, explicit_euler, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactGenerator, ContactResolver
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.direct_chain import DirectChain
from ch07_constraints.links import AnchoredRod
from ch07_constraints.time_division import TooManyImpacts, time_division_step
from studies.readings import Numbers, numbers, stopped

FRAME = 1.0 / 60.0
GRAVITY = 10.0
LINK = 0.1
RADIUS = 0.5

STEPS: dict[str, Integrator] = {
    "explicit Euler": explicit_euler,
    "semi-implicit Euler": semi_implicit_euler,
}

Move = Callable[[float], object]
Resolve = Callable[[list[Contact], float], object]


class Link(Protocol):
    """A function that connects two particles, such as Rod or TwoSidedRod."""

    def __call__(self, a: Particle, b: Particle, length: float, /) -> ContactGenerator: ...


@dataclass(frozen=True)
class Track:
    """A value, such as the height of a ball, recorded at the start and after each time step.

    If an error in the student's engine ended the simulation early, ``message`` is its text.
    """

    times: list[float]
    values: list[float]
    message: str = ""

    @property
    def points(self) -> list[tuple[float, float]]:
        """The recorded values as pairs of a time and a value."""
        return [*zip(self.times, self.values, strict=True)]


def track(move: Move, measure: Callable[[], float], frames: int, duration: float = FRAME) -> Track:
    """Advance a simulation step by step, and record a value at the start and after each step.

    An error in the student's engine ends the recording early.
    """
    times, values = [0.0], [measure()]

    def run() -> None:
        for i in range(1, frames + 1):
            move(duration)
            values.append(measure())
            times.append(i * duration)

    message = stopped(run)
    return Track(times, values[: len(times)], message)


def no_forces(duration: float) -> None:
    """Apply no forces, for simulations in which gravity is each particle's own acceleration."""
    del duration


def resolving(
    step: Integrator,
    particles: Sequence[Particle],
    generators: Iterable[ContactGenerator],
    resolve: Resolve,
    apply_forces: ApplyForces = no_forces,
    substeps: int = 1,
) -> Move:
    """Build a function that moves particles by one frame and then resolves their contacts.

    The frame is divided into ``substeps`` equal steps. In each of them, ``step`` moves the
    particles, and ``resolve`` then resolves the contacts that the ``generators`` find.
    """
    every = [*generators]

    def move(duration: float) -> None:
        part = duration / substeps
        for _ in range(substeps):
            step(particles, apply_forces, part)
            resolve([contact for some in every for contact in some.contacts()], part)

    return move


def by_resolver(
    iterations: int | None = None, kind: type[ContactResolver] = ContactResolver
) -> Resolve:
    """Build a function that resolves contacts in at most ``iterations`` iterations per contact.

    If ``iterations`` is None, the resolver uses its default of 2.
    """

    def resolve(contacts: list[Contact], duration: float) -> None:
        if contacts:
            limit = None if iterations is None else iterations * len(contacts)
            kind(limit).resolve_contacts(contacts, duration)

    return resolve


def without_rule(contacts: list[Contact], duration: float) -> None:
    """Resolve contacts as impacts, without the rule for resting contacts.

    Without that rule, the speed that gravity adds during the time step bounces as well.
    """
    del duration
    for contact in contacts:
        contact.resolve_velocity()
        contact.resolve_penetration()


def no_bounce_below(speed: float) -> Resolve:
    """Build a contact rule that is deliberately too strict: below ``speed``, nothing bounces."""

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
    """Drop a ball above the ground, and record its height over time.

    If ``generated`` is true, gravity comes from a force generator rather than from the particle's
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
    """Drop a ball with time_division_step, which stops at each impact, and record its height.

    Once the ball comes to rest, time_division_step raises TooManyImpacts, and the recording ends at
    the time given in that exception.
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
    """Create the particles of a straight chain that hangs from an immovable first particle.

    ``angle`` is measured from straight down, in degrees.
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
    """Release a chain of links, and record how much too long the chain and its worst link get.

    The first of the two tracks is the excess length of the chain: the total length of its links
    minus what it should be. The second is the largest error in the length of a link, which counts
    links that are too short as well as those that are too long.
    """
    particles = chain_particles(count, angle)
    links = [link(a, b, LINK) for a, b in pairwise(particles)]
    move = resolving(semi_implicit_euler, particles[1:], links, resolve, substeps=substeps)
    return _lengths(move, particles, frames)


def chain_by_direct_solve(count: int, frames: int, angle: float = 0.0) -> tuple[Track, Track]:
    """Release a DirectChain, and record the same two lengths over time as ``chain``."""
    particles = chain_particles(count, angle)
    return _lengths(DirectChain(particles[1:], Vector3()).step, particles, frames)


def pendulum(step: Integrator | None, rate: int, seconds: float) -> Track:
    """Release a pendulum from horizontal, and record its energy in J over time.

    The pendulum has a bob of 1 kg and a length of 1 m. Its energy is relative to the lowest point,
    so it starts at 10 J. The rod is an AnchoredRod that is resolved after each step, or a
    DirectChain if ``step`` is None. A DirectChain's velocities are valid in the middle of a step,
    so the energy at a position is computed from the mean of the velocities before and after it.
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
    """Return the energy of 1 kg in J, relative to the lowest point of the pendulum."""
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
