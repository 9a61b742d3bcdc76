"""Measure one and two bouncing balls beside pymunk.

The work is the number of searches for contacts, or of the heights that a formula computes.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from ch06_springs.integrators import Integrator, explicit_euler, semi_implicit_euler
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.detectors import Detectors, Impact
from ch07_constraints.going_further.bouncing_ball import heights_in_frames
from ch07_constraints.time_division import time_division_step
from scenes.clock import RATE
from scenes.dropped_balls import DroppedBalls
from scenes.resolving import resolving
from scenes.twin import InSpace, twin_of
from studies.accuracy.in_pymunk import BEST, EXAMPLES, by_pymunk
from studies.accuracy.scene import (
    MANY,
    Made,
    Model,
    Outcome,
    Scene,
    by_steps,
    framed,
    in_frames,
    places_of,
)

RADIUS = 0.1  # m


class Counted(Detectors):
    """Detectors that count the searches for the next impact."""

    searches = 0

    def next_impact(self, duration: float) -> Impact | None:
        self.searches += 1
        return super().next_impact(duration)


def by_time_division(balls: DroppedBalls, frames: int, steps: int) -> Outcome:
    """Simulate bouncing balls with time division, which advances from one impact to the next."""
    particles = balls.setup().particles
    detectors = Counted(*balls.detectors(particles))
    step = partial(time_division_step, particles, detectors)
    places = in_frames(step, partial(places_of, particles), frames, steps)
    return Outcome(places, detectors.searches)


def by_its_impacts(balls: DroppedBalls, frames: int, _: int) -> Outcome:
    """Compute the height of a ball in every frame from the times of its impacts, without steps."""
    start = balls.heights[0] - RADIUS
    heights = heights_in_frames(start, 0.0, balls.restitution, 1.0 / RATE, frames, balls.gravity)
    return Outcome([(0.0, RADIUS + height) for height in heights], frames)


def by_resolver(balls: DroppedBalls, integrator: Integrator, _: float) -> Made:
    """Return what moves balls with an integrator, and then resolves their contacts."""
    setup = balls.setup()
    resolve = ContactResolver().resolve_contacts
    step = resolving(integrator, setup.particles, setup.contacts, resolve)
    return step, partial(places_of, setup.particles)


def in_space(balls: DroppedBalls, ahead: float) -> InSpace:
    """Create the balls and the ground in pymunk, with ``ahead`` without an allowed overlap."""
    space, bodies = twin_of(balls.setup(), ahead)
    if ahead:
        space.collision_slop = 0.0
    for body in bodies[1:]:  # the ball below has the restitution of the ground
        (shape,) = body.shapes
        shape.elasticity = balls.between / balls.restitution
    return space, bodies


def scene_of(name: str, balls: DroppedBalls, frames: int, scale: float) -> Scene:
    """Create the scene of balls that bounce, with errors as fractions of ``scale`` m."""
    heights = balls.heights_at([frame / RATE for frame in range(1, frames + 1)])
    exact = [tuple(part for y in ys for part in (0.0, y)) for ys in heights]
    euler, better = (
        partial(by_resolver, balls, way) for way in (explicit_euler, semi_implicit_euler)
    )
    then = "Euler, then contacts"
    models = [
        Model("time division", partial(by_time_division, balls, frames), (1,), is_formula=True),
        Model("its impacts alone", partial(by_its_impacts, balls, frames), (1,), is_formula=True),
        by_steps(f"explicit {then}", euler, frames, steps=MANY, by="the book"),
        by_steps(f"semi-implicit {then}", better, frames, steps=MANY),
        by_pymunk(EXAMPLES, lambda _: in_space(balls, 0.0), frames),
        by_pymunk(BEST, partial(in_space, balls), frames),
    ]
    if len(balls.heights) > 1:
        del models[1]  # the formula for the impacts is that of a single ball
    counted = "searches for contacts"
    return Scene(name, frames, scale, framed(lambda: exact), models, counted)


def bouncing_ball(restitution: float) -> Scene:
    """Create the scene of a ball that is dropped from 2 m and bounces for 3 s."""
    balls = DroppedBalls((2.0 + RADIUS,), restitution, radius=RADIUS)
    return scene_of(f"bouncing ball, restitution {restitution:g}", balls, 180, 2.0)


def two_balls() -> Scene:
    """Create the scene of a light ball 1 mm above a heavy one, dropped from 1 m (exercise 7.3)."""
    heights = (1.0 + RADIUS, 1.0 + 3.0 * RADIUS + 1e-3)
    balls = DroppedBalls(heights, 0.9, (1.0, 0.1), 0.8, RADIUS)
    return scene_of("a light ball dropped on a heavy one", balls, 90, 1.0)


IMPACTS: list[Callable[[], Scene]] = [
    partial(bouncing_ball, 1.0),
    partial(bouncing_ball, 0.8),
    two_balls,
]
