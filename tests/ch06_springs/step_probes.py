"""What must run beside the student's code: steps, in fields of force that keep a record.

Each function takes and returns plain numbers.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs import exercises, integrators, own_step

Components = tuple[float, float, float]
# position, velocity, acceleration, mass, damping, and a force that is added by hand
Body = tuple[Components, Components, Components, float, float, Components]
Numbers = dict[str, list[Any]]
Call = Callable[[float], None]
ZERO = (0.0, 0.0, 0.0)


def xyz(v: Vector3) -> Components:
    return v.x, v.y, v.z


class Field:
    """Forces -(k + q r^2) x - c v on every particle, and a spring s between each and the next.

    It writes down how it was asked: the duration, what was in the accumulators, and the places.
    """

    def __init__(
        self, particles: Sequence[Particle], k: float, c: float, q: float = 0.0, s: float = 0.0
    ) -> None:
        self.particles = particles
        self.k, self.c, self.q, self.s = k, c, q, s
        self.asked: list[tuple[float, list[Components], list[Components]]] = []

    def __call__(self, duration: float) -> None:
        sums = [xyz(particle.force_accumulator) for particle in self.particles]
        places = [xyz(particle.position) for particle in self.particles]
        self.asked.append((duration, sums, places))
        for particle in self.particles:
            p, v = particle.position, particle.velocity
            pull = self.k + self.q * p.squared_magnitude()
            particle.add_force(p * -pull - v * self.c)
        for a, b in pairwise(self.particles):
            offset = a.position - b.position
            a.add_force(offset * -self.s)
            b.add_force(offset * self.s)


def stepped(
    method: str, bodies: Sequence[Body], forces: tuple[float, ...], duration: float, frames: int
) -> Numbers:
    """Make steps by an integrator of the chapter, in a Field of these coefficients.

    Return the places, velocities, accumulators, last accelerations and dampings in the end, and how
    the field was asked. The forces by hand are added before every step.
    """
    particles = [
        Particle(Vector3(*p), Vector3(*v), Vector3(*a), mass=m, damping=d)
        for p, v, a, m, d, _ in bodies
    ]
    field = Field(particles, *forces)
    step = getattr(integrators, method)
    for _ in range(frames):
        for particle, body in zip(particles, bodies, strict=True):
            if any(body[5]):
                particle.add_force(Vector3(*body[5]))
        step(particles, field, duration)
    return {
        "positions": [xyz(particle.position) for particle in particles],
        "velocities": [xyz(particle.velocity) for particle in particles],
        "forces": [xyz(particle.force_accumulator) for particle in particles],
        "accelerations": [xyz(particle.last_acceleration) for particle in particles],
        "dampings": [particle.damping for particle in particles],
        "asked": field.asked,
    }


def growth(
    method: str, stiffness: float, damping: float, duration: float, frames: int, since: int = 0
) -> float:
    """Return how many times as far as at the start a linear spring of 1 kg takes its end.

    Frames before ``since`` do not count.
    """
    particle = Particle(Vector3(1.0, 0.0, 0.0), damping=damping)
    field = Field([particle], stiffness, 0.0)
    step = getattr(integrators, method)
    farthest = 0.0
    for frame in range(frames):
        step([particle], field, duration)
        field.asked.clear()
        if frame >= since:
            farthest = max(farthest, abs(particle.position.x))
    return farthest


def energy_left(method: str, stiffness: float, duration: float, frames: int) -> float:
    """Return the energy of an undamped spring of 1 kg in the end, as a share of the start's."""
    body = ((1.0, 0.0, 0.0), ZERO, ZERO, 1.0, 1.0, ZERO)
    ends = stepped(method, [body], (stiffness, 0.0), duration, frames)
    x, v = ends["positions"][0][0], ends["velocities"][0][0]
    return (stiffness * x * x + v * v) / stiffness


def implicit_steps(
    method: str, x: float, v: float, numbers: tuple[float, float, float, float], frames: int
) -> tuple[float, float]:
    """Make steps by an implicit method, with (stiffness, damping, mass, duration).

    Return position and velocity in the end.
    """
    step = getattr(integrators, method)
    for _ in range(frames):
        x, v = step(x, v, *numbers)
    return x, v


def watching(
    speed_limit: float, speeds: Sequence[Sequence[float]]
) -> tuple[list[tuple[int, float]], tuple[int, int, float, float] | None]:
    """Watch a step that gives each particle the next of its speeds.

    Return what the step was called with, how many particles and which duration, and of the error
    that ended it: particle, step, speed and limit, or None.
    """
    particles = [Particle() for _ in speeds[0]]
    calls: list[tuple[int, float]] = []

    def step(these: Sequence[Particle], apply_forces: Call, h: float) -> None:
        apply_forces(h)
        calls[-1] = (len(these), calls[-1][1])
        frame = speeds[min(len(calls), len(speeds)) - 1]
        for i, (particle, speed) in enumerate(zip(these, frame, strict=False)):
            # NaN and infinity along one axis; other speeds in three, as 2, 3 and 6 parts of 7.
            parts = [speed * part / 7.0 for part in (2.0, 3.0, 6.0)]
            if not math.isfinite(speed):
                parts = [speed, 0.0, 0.0]
            v = particle.velocity
            v.x, v.y, v.z = (parts[(n + i) % 3] for n in range(3))

    watched = integrators.watched(step, speed_limit)
    for i in range(len(speeds)):
        try:
            watched(particles, lambda h: calls.append((len(particles), h)), 0.25 + i)
        except integrators.SimulationDiverged as error:
            return calls, (error.particle, error.step, error.speed, error.limit)
    return calls, None


def watching_on(limit: float) -> list[int]:
    """Watch a step that is refused, calm, too fast, calm, and too fast; return the steps told."""
    particle = Particle()
    speeds = iter([math.nan, 0.5 * limit, 2.0 * limit, 0.5 * limit, 2.0 * limit])

    def step(_particles: Sequence[Particle], _apply: Callable[[float], None], _h: float) -> None:
        speed = next(speeds, 0.0)
        if math.isnan(speed):
            raise ValueError("the force is not finite")
        particle.velocity = Vector3(speed)

    watched = integrators.watched(step, limit)
    told = []
    for _ in range(5):
        try:
            watched([particle], print, 0.5)
        except integrators.SimulationDiverged as error:
            told.append(error.step)
        except ValueError:
            told.append(-1)
    return told


def exploding(limit: float) -> tuple[int, float, float]:
    """Watch explicit Euler with too stiff a spring; return step, speed and limit of its end."""
    particle = Particle(Vector3(1.0, 0.0, 0.0))
    field = Field([particle], 3600.0, 0.0)
    step = integrators.watched(weakened(1.0, True), limit)
    for _ in range(1000):
        try:
            step([particle], field, 1.0 / 60.0)
        except integrators.SimulationDiverged as error:
            return error.step, error.speed, error.limit
    return 0, 0.0, 0.0


def weakened(share: float, explicit: bool) -> Callable[..., None]:
    """Return a step whose forces count with a share only: what it bears, no book can tell."""

    def step(these: Sequence[Particle], apply_forces: Call, h: float) -> None:
        apply_forces(h)
        for one in these:
            one.add_force(one.force_accumulator * (share - 1.0))
            if explicit:
                one.integrate(h)
            else:
                start = one.position.copy()
                one.integrate(h)
                start.add_scaled(one.velocity, h)
                one.position = start

    return step


def asked_about(function: str, share: float, explicit: bool, *numbers: float) -> Any:
    """Call a function of exercise 6.5 with such a step."""
    return getattr(exercises, function)(weakened(share, explicit), *numbers)


def wider_by(amplitudes: Sequence[float], last: float) -> Any:
    """Ask swings_wider about a step that swings from side to side, by these lengths in turn.

    Each lasts for a quarter of the steps. After the last step, the particle is at ``last``.
    Lengths are in units of the distance at the start.
    """
    places = [exercises.START * size * (-1) ** i for size in amplitudes for i in range(200)]
    places[-1] = exercises.START * last
    ahead = iter(places)

    def step(these: Sequence[Particle], _apply: Call, _h: float) -> None:
        these[0].position = Vector3(next(ahead, 0.0))

    return exercises.swings_wider(step, 1.0, 1.0, 0.25)


def never_safe(duration: float) -> Any:
    """Measure an integrator that makes every swing wider."""

    def step(these: Sequence[Particle], _apply: Callable[[float], None], h: float) -> None:
        place = these[0].position * -1.05
        these[0].velocity = (place - these[0].position) * (1.0 / h)
        these[0].position = place

    return exercises.largest_stable_stiffness(step, 0.5, duration)


def released() -> list[tuple[Any, ...]]:
    """Ask swings_wider with a step that writes down what it gets first, and moves nothing.

    How many particles, the first one's place, velocity, acceleration, mass, damping, the force on
    it that was there before, the force by apply_forces, and the duration; nothing where the step
    was not called.
    """
    seen: list[tuple[Any, ...]] = []

    def step(these: Sequence[Particle], apply_forces: Call, h: float) -> None:
        one = these[0]
        before = xyz(one.force_accumulator)
        one.clear_forces()
        apply_forces(h)
        force = xyz(one.force_accumulator)
        one.clear_forces()
        if not seen:
            vectors = [xyz(v) for v in (one.position, one.velocity, one.acceleration)]
            seen.append((len(these), *vectors, one.mass, one.damping, before, force, h))

    exercises.swings_wider(step, 7.0, 0.25, 0.125)
    return seen


def step_matrix(
    stiffness: float, damping: float, duration: float, mass: float
) -> tuple[float, float, float, float]:
    """Return (a, b, c, d) of Particle.integrate with a spring: x' = a x + b v, v' = c x + d v."""
    columns = []
    for x, v in ((1.0, 0.0), (0.0, 1.0)):
        particle = Particle(Vector3(x), Vector3(v), mass=mass, damping=damping)
        particle.add_force(Vector3(-stiffness * x))
        particle.integrate(duration)
        columns.append((particle.position.x, particle.velocity.x))
    (a, c), (b, d) = columns
    return a, b, c, d


def own_steps(
    bodies: Sequence[tuple[Components, Components, Components, float]],
    forces_at: Callable[[list[Components]], list[Components]],
    duration: float,
    frames: int,
) -> tuple[list[list[Components]], list[list[Components]], list[Components]]:
    """Move bodies (position, velocity, acceleration, mass) by the step of one's own.

    Return the places and the velocities after each frame, and the accumulators in the end.
    ``forces_at`` tells the forces at places: whoever calls this counts them.
    """
    particles = [Particle(Vector3(*p), Vector3(*v), Vector3(*a), mass=m) for p, v, a, m in bodies]

    def apply_forces(_duration: float) -> None:
        forces = forces_at([xyz(particle.position) for particle in particles])
        for particle, force in zip(particles, forces, strict=True):
            particle.add_force(Vector3(*force))

    places, velocities = [], []
    for _ in range(frames):
        own_step.my_step(particles, apply_forces, duration)
        places.append([xyz(particle.position) for particle in particles])
        velocities.append([xyz(particle.velocity) for particle in particles])
    return places, velocities, [xyz(particle.force_accumulator) for particle in particles]
