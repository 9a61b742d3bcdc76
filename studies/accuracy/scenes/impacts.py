"""Define three scenes with bouncing balls, in which our engine is compared with pymunk.

- A ball bounces without losing energy.
- A ball loses energy at every bounce.
- A light ball is dropped on top of a heavy one.

The work of a simulation is counted rather than timed, so it does not depend on the computer's
speed. It is the number of searches for contacts. Most methods search once per step, but time
division searches once per impact and once per frame. A method that computes the height of a ball
directly from its impacts counts these computations instead.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, explicit_euler, semi_implicit_euler
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.detectors import Detectors, GroundPlane, Impact, ParticlePairs
from ch07_constraints.going_further.bouncing_ball import heights_in_frames
from ch07_constraints.time_division import time_division_step
from scenes.clock import RATE
from scenes.resolving import resolving
from scenes.twin import InSpace
from studies.accuracy.in_pymunk import BEST, EXAMPLES, by_pymunk
from studies.accuracy.scene import MANY, Model, Outcome, Place, Scene, in_frames

G = 10.0  # m/s^2
RADIUS = 0.1  # m


class Balls:
    """One or more balls, one above the other, that are dropped from rest.

    - ``heights``: the initial heights of the balls' centers in m, from the lowest ball up.
    - ``ground``: the restitution between a ball and the ground.
    - ``pair``: the restitution between two balls.
    """

    def __init__(
        self, heights: Sequence[float], masses: Sequence[float], ground: float, pair: float
    ) -> None:
        self.heights, self.masses = heights, masses
        self.ground, self.pair = ground, pair  # restitutions

    def particles(self) -> list[Particle]:
        """Create a particle for each ball, at rest at the ball's initial height."""
        return [
            Particle(Vector3(0.0, y), acceleration=Vector3(0.0, -G), mass=mass)
            for y, mass in zip(self.heights, self.masses, strict=True)
        ]

    def detectors(self, particles: list[Particle]) -> Detectors:
        """Create detectors for the contacts of the balls with the ground and with each other."""
        ground = GroundPlane(particles, radius=RADIUS, restitution=self.ground)
        if len(particles) == 1:
            return Detectors(ground)
        return Detectors(ground, ParticlePairs(particles, RADIUS, self.pair))

    def places_at(self, times: Sequence[float]) -> list[Place]:
        """Compute the exact heights of the balls at the given times, which must be ascending.

        The heights are computed from one impact to the next. No code of the engine is used, so a
        bug in the engine cannot affect the result.
        """
        heights, speeds, now = [*self.heights], [0.0] * len(self.heights), 0.0
        found: list[Place] = []
        for time in times:
            while (impact := self._next(heights, speeds))[0] <= time - now:
                after, i = impact
                heights, speeds = _fall(heights, speeds, after)
                self._collide(speeds, i)
                now += after
            heights, speeds = _fall(heights, speeds, time - now)
            now = time
            found.append(tuple(heights))
        return found

    def _next(self, heights: list[float], speeds: list[float]) -> tuple[float, int]:
        """Find the next impact of a ball with the ground or with the ball below it.

        Return the time until the impact in s, and the index of the ball. If two balls collide, it
        is the index of the upper one, and for an impact with the ground it is 0.
        """
        first, v = heights[0] - RADIUS, speeds[0]
        impacts = [((v + math.sqrt(max(v * v + 2.0 * G * first, 0.0))) / G, 0)]
        for i in range(1, len(heights)):
            gap, closing = heights[i] - heights[i - 1] - 2.0 * RADIUS, speeds[i - 1] - speeds[i]
            if closing > 0.0:
                impacts.append((max(gap, 0.0) / closing, i))
        return min(impacts)

    def _collide(self, speeds: list[float], i: int) -> None:
        if i == 0:
            speeds[0] *= -self.ground
            return
        m, n = self.masses[i - 1], self.masses[i]
        change = (1.0 + self.pair) * (speeds[i - 1] - speeds[i]) / (m + n)
        speeds[i - 1] -= n * change
        speeds[i] += m * change


def _fall(
    heights: list[float], speeds: list[float], time: float
) -> tuple[list[float], list[float]]:
    pairs = zip(heights, speeds, strict=True)
    return [y + v * time - 0.5 * G * time * time for y, v in pairs], [v - G * time for v in speeds]


def by_time_division(balls: Balls, frames: int, steps: int) -> Outcome:
    """Simulate bouncing balls with time division, which advances from one impact to the next.

    The work is the number of searches for the next impact.
    """
    particles = balls.particles()
    detectors, work = balls.detectors(particles), 0

    class Counted:
        contacts = detectors.contacts

        def next_impact(self, duration: float) -> Impact | None:
            nonlocal work
            work += 1
            return detectors.next_impact(duration)

    places = in_frames(
        lambda duration: time_division_step(particles, Counted(), duration),
        lambda: _heights(particles),
        frames,
        steps,
    )
    return Outcome(places, work)


def by_its_impacts(balls: Balls, frames: int, _: int) -> Outcome:
    """Compute the height of a bouncing ball in every frame from the times of its impacts.

    No time steps are needed, because the height has a closed form between two impacts.
    """
    (height,) = balls.heights
    heights = heights_in_frames(height - RADIUS, 0.0, balls.ground, 1.0 / RATE, frames, G)
    return Outcome([(RADIUS + height,) for height in heights], frames)


def by_resolver(integrator: Integrator, balls: Balls, frames: int, steps: int) -> Outcome:
    """Simulate bouncing balls with an integrator, and resolve their contacts after each step."""
    particles = balls.particles()
    detectors, resolver = balls.detectors(particles), ContactResolver()
    step = resolving(integrator, particles, [detectors], resolver.resolve_contacts)
    return Outcome(in_frames(step, lambda: _heights(particles), frames, steps), frames * steps)


def _heights(particles: list[Particle]) -> Place:
    return tuple(particle.position.y for particle in particles)


def in_space(balls: Balls, _: float) -> InSpace:
    """Create the balls and the ground in pymunk.

    Pymunk multiplies the elasticities of two bodies to get their restitution. The elasticities are
    chosen so that the products are the restitutions of this scene.
    """
    import pymunk

    space = pymunk.Space()
    space.gravity = (0.0, -G)
    bodies: list[Any] = []
    # The ground has 1, the lowest ball has the ground's restitution, and the next ball has the
    # value that gives the pair's restitution.
    elasticity = [balls.ground, balls.pair / balls.ground]
    for i, (y, mass) in enumerate(zip(balls.heights, balls.masses, strict=True)):
        body = pymunk.Body(mass, math.inf)
        body.position = (0.0, y)
        shape = pymunk.Circle(body, RADIUS)
        shape.elasticity = elasticity[i]
        space.add(body, shape)
        bodies.append(body)
    floor = pymunk.Segment(space.static_body, (-9.0, 0.0), (9.0, 0.0), 0.0)
    floor.elasticity = 1.0
    space.add(floor)
    return space, bodies


def ahead(balls: Balls, duration: float) -> InSpace:
    """Create the same, half a step ahead and without an allowed overlap."""
    space, bodies = in_space(balls, duration)
    space.collision_slop = 0.0
    for body in bodies:
        body.velocity = (0.0, -0.5 * G * duration)
    return space, bodies


def heights_of(model: Model) -> Model:
    """Return the same model, whose result is only the heights of the balls."""

    def run(steps: int) -> Outcome:
        outcome = model.run(steps)
        return Outcome([place[1::2] for place in outcome.places], outcome.work)

    return replace(model, run=run)


def scene_of(name: str, balls: Balls, frames: int, scale: float) -> Scene:
    """Create a scene in which ``balls`` fall and bounce, with a model for each way to simulate it.

    ``scale`` is the size of the scene in m. Errors are given as fractions of it.
    """
    exact = balls.places_at([frame / RATE for frame in range(1, frames + 1)])

    def truth(time: float) -> Place:
        return exact[round(time * RATE) - 1]

    impacts: dict[str, Callable[[Balls, int, int], Outcome]] = {"time division": by_time_division}
    if len(balls.heights) == 1:
        impacts["its impacts alone"] = by_its_impacts
    models = [
        *(
            Model(name, partial(by, balls, frames), (1,), is_formula=True)
            for name, by in impacts.items()
        ),
        Model(
            "explicit Euler, then contacts",
            partial(by_resolver, explicit_euler, balls, frames),
            MANY,
            "the book",
        ),
        Model(
            "semi-implicit Euler, then contacts",
            partial(by_resolver, semi_implicit_euler, balls, frames),
            MANY,
        ),
        heights_of(by_pymunk(EXAMPLES, partial(in_space, balls), frames)),
        heights_of(by_pymunk(BEST, partial(ahead, balls), frames)),
    ]
    return Scene(name, frames, scale, truth, models, "searches for contacts")


def bouncing_ball(restitution: float) -> Scene:
    """Create the scene of a ball that is dropped from 2 m and bounces for 3 s.

    With a ``restitution`` of 1, the ball loses no energy at the ground.
    """
    balls = Balls((2.0 + RADIUS,), (1.0,), restitution, 1.0)
    return scene_of(f"bouncing ball, restitution {restitution:g}", balls, 180, 2.0)


def two_balls() -> Scene:
    """Create the scene of a light ball on a heavy ball, both dropped from 1 m (exercise 7.3).

    The scene lasts 1.5 s.
    """
    gap = 1e-3
    balls = Balls((1.0 + RADIUS, 1.0 + 3.0 * RADIUS + gap), (1.0, 0.1), 0.9, 0.8)
    return scene_of("a light ball dropped on a heavy one", balls, 90, 1.0)


IMPACTS: list[Callable[[], Scene]] = [
    partial(bouncing_ball, 1.0),
    partial(bouncing_ball, 0.8),
    two_balls,
]
