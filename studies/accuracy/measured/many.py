"""Measure scenes with many bodies, beside pymunk: free fall, stacks and a pile of spheres.

Each sphere just touches its neighbors and should not move. The error is how far it does, as a
fraction of the diameter. The work is the number of steps times the number of bodies.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import ParticlePairs
from scenes import spheres
from scenes.setup import Setup
from scenes.twin import InSpace, twin_of
from studies.accuracy.asleep import asleep, asleep_in_pymunk, put_to_sleep
from studies.accuracy.in_pymunk import BEST, EXAMPLES, at_best, by_pymunk, in_turn
from studies.accuracy.scene import STEPS, Made, Place, Scene, by_formula, by_steps, places_of
from studies.contacts.scenes import BOOK, IMPULSES, SMALL, SOLVERS
from studies.models.plain_numbers import Falling
from studies.models.pymunk_steps import Step

FRAMES = 60  # of the spheres at rest
BODIES, LONG = 1000, 300  # bodies that fall, and frames
UP, G = 5.0, 10.0  # m/s and m/s^2, of the bodies that fall
COUNTED = "steps of a body"


def falling() -> Scene:
    """Create the scene of a thousand bodies that are thrown upward and fall for 5 s.

    Half a step ahead, every step is exact. Only the times of the step and the reading then differ.
    """
    thrown = [(float(i % 40), 0.1 * (i % 7)) for i in range(BODIES)]  # m, and m/s to the right

    def setup() -> Setup:
        down = Vector3(0.0, -G)
        return Setup([Particle(Vector3(x), Vector3(v, UP), down) for x, v in thrown])

    def place_at(time: float) -> Place:
        height = UP * time - 0.5 * G * time * time
        return tuple([part for x, v in thrown for part in (x + v * time, height)])

    def by_particles(duration: float) -> Made:
        bodies = setup().particles
        for body in bodies:
            body.velocity.y = UP - G * (0.5 * duration)

        def step(duration: float) -> None:
            for body in bodies:
                body.integrate(duration)

        return step, partial(places_of, bodies)

    def by_lists(duration: float) -> Made:
        bodies = Falling([x for x, _ in thrown], [v for _, v in thrown], UP, G, duration)
        return bodies.step, bodies.place

    def read_in_turn(_: float) -> Made:
        space, bodies = twin_of(setup())
        return space.step, partial(in_turn, bodies)

    steps = STEPS[:4]
    ways = {
        "particles, half a step ahead": by_particles,
        "plain lists, half a step ahead": by_lists,
    }
    models = [
        by_formula(place_at, LONG, BODIES),
        *(by_steps(name, way, LONG, BODIES, steps) for name, way in ways.items()),
        by_steps(EXAMPLES, read_in_turn, LONG, BODIES, steps, by="pymunk"),
        by_pymunk(BEST, lambda h: twin_of(setup(), h), LONG, steps, units=BODIES),
    ]
    return Scene("a thousand bodies in free fall", LONG, 2.0, place_at, models, COUNTED)


def resting(name: str, make: Callable[[], Setup], first: Sequence[int], fixed: int = 0) -> Scene:
    """Create the scene of spheres at rest, of which the first ``fixed`` ones cannot move.

    ``first`` lists the numbers of iterations that pymunk makes in the first step.
    """
    moving = places_of(make().particles[fixed:])
    units = len(moving) // 2

    def ours(solver: str, _: float) -> Made:
        setup = make()
        step = SOLVERS[solver](setup.particles, setup.contacts)
        return step, partial(places_of, setup.particles[fixed:])

    def in_space(iterations: int, slop: float | None, _: float = 0.0) -> InSpace:
        space, bodies = twin_of(make(), iterations=iterations)
        if slop is not None:
            space.collision_slop = slop
        return space, bodies[fixed:]

    def touching(iterations: int, _: float) -> InSpace:
        """Create slightly larger spheres in pymunk, so that all of them touch at the start."""
        space, bodies = in_space(iterations, 1e-8)
        for shape in space.shapes:
            if shape.body is not space.static_body:  # a sphere, not the ground
                shape.unsafe_set_radius(spheres.RADIUS + 1e-9)
        return space, bodies

    def first_step(space: Any, _: Any) -> Step:
        """Return a step with few iterations after the first, whose impulses the solver reuses."""

        def step(duration: float) -> None:
            space.step(duration)
            space.iterations = 3

        return step

    models = [
        by_steps(BOOK, partial(ours, BOOK), FRAMES, units, STEPS[:6], by="the book"),
        *(by_steps(one, partial(ours, one), FRAMES, units, STEPS[:8]) for one in (IMPULSES, SMALL)),
        asleep(partial(put_to_sleep, make, fixed), FRAMES),
        by_pymunk(EXAMPLES, partial(in_space, 10, None), FRAMES, units=units),
        *(
            by_pymunk(at_best(count), partial(in_space, count, 0.0), FRAMES, units=units)
            for count in (3, 10, 30, 100)
        ),
        *(
            by_pymunk(
                f"{BEST}, {count:,} iterations in the first step",
                partial(touching, count),
                FRAMES,
                (1,),
                first_step,
                units,
            )
            for count in first
        ),
        asleep_in_pymunk(partial(in_space, 1, None), FRAMES),
    ]
    return Scene(name, FRAMES, spheres.DIAMETER, lambda _: moving, models, COUNTED)


def stack(ratio: float) -> Scene:
    """Create the scene of ten spheres of 1 kg, except for the top one with ``ratio`` kg."""

    def make() -> Setup:
        setup = spheres.stack(10, ratio)
        return replace(setup, contacts=setup.contacts[::-1])  # the ground is resolved last

    first = (1000,) if ratio == 1.0 else (100_000, 300_000)
    return resting(f"stack of ten spheres, mass ratio {ratio:g}", make, first)


def pile() -> Scene:
    """Create the scene of a pile of 45 spheres, in nine rows above ten fixed spheres."""

    def make() -> Setup:
        found = spheres.at(spheres.pyramid(10))
        for sphere in found[:10]:
            sphere.mass = math.inf
        return Setup(found, contacts=[ParticlePairs(found, spheres.RADIUS)])

    return resting("pile of 45 spheres", make, (1000,), fixed=10)


MANY_BODIES: list[Callable[[], Scene]] = [
    falling,
    partial(stack, 1.0),
    partial(stack, 1000.0),
    pile,
]
