"""Define scenes with many bodies, in which our engine is compared with pymunk.

- A thousand bodies fall freely.
- Ten spheres rest on one another, once with equal masses and once with a heavy one on top.
- A pile of 45 spheres rests on a row of fixed ones.

Nothing moves in the stacks and in the pile, and each sphere just touches its neighbors. The error
is how far a solver lets the spheres move, as a fraction of their diameter. A model that knows that
nothing moves lets the spheres sleep. The work is the number of steps times the number of bodies.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from operator import add
from typing import TYPE_CHECKING

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import ContactGenerator
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch08_mass_aggregate.sleeping import SleepingWorld
from scenes.clock import RATE
from scenes.twin import InSpace
from studies.accuracy.asleep import asleep, asleep_in_pymunk
from studies.accuracy.in_pymunk import BEST, EXAMPLES, Step, at_best, by_pymunk, in_turn
from studies.accuracy.scene import STEPS, Model, Outcome, Place, Scene, in_frames, places_of
from studies.contacts.scenes import BOOK, IMPULSES, SMALL, SOLVERS

if TYPE_CHECKING:
    import pymunk

G = 10.0  # m/s^2
RADIUS = 0.5  # m
FRAMES = 60  # of the spheres at rest
BODIES, LONG = 1000, 300  # bodies that fall, and frames
COUNTED = "steps of a body"


def falling() -> Scene:
    """Create the scene of a thousand bodies that are thrown upward and fall for 5 s.

    The exact positions are parabolas. If the velocities start half a step ahead, each step computes
    them exactly. The scene therefore compares only how long a step and the reading take.
    """
    starts = [float(i % 40) for i in range(BODIES)]
    speeds = [0.1 * (i % 7) for i in range(BODIES)]

    def place_at(time: float) -> Place:
        height = 5.0 * time - 0.5 * G * time * time
        return tuple(
            [part for x, v in zip(starts, speeds, strict=True) for part in (x + v * time, height)]
        )

    def by_particles(steps: int) -> Outcome:
        half = 0.5 / (RATE * steps)
        bodies = [
            Particle(Vector3(x), Vector3(v, 5.0 - G * half), Vector3(0.0, -G))
            for x, v in zip(starts, speeds, strict=True)
        ]

        def step(duration: float) -> None:
            for body in bodies:
                body.integrate(duration)

        return Outcome(
            in_frames(step, partial(places_of, bodies), LONG, steps), LONG * steps * BODIES
        )

    def by_lists(steps: int) -> Outcome:
        """Add lists of numbers, which is about the least that plain Python can do."""
        duration = 1.0 / (RATE * steps)
        change = [-G * duration * duration] * BODIES
        xs, across = starts, [v * duration for v in speeds]
        ys, up = [0.0] * BODIES, [5.0 * duration + 0.5 * change[0]] * BODIES
        found: list[Place] = []
        for _ in range(LONG):
            for _ in range(steps):
                xs = [*map(add, xs, across)]
                ys = [*map(add, ys, up)]
                up = [*map(add, up, change)]
            place = xs * 2
            place[::2], place[1::2] = xs, ys
            found.append(place)
        return Outcome(found, LONG * steps * BODIES)

    def in_space(duration: float) -> InSpace:
        import pymunk

        space = pymunk.Space()
        space.gravity = (0.0, -G)
        bodies = []
        for x, v in zip(starts, speeds, strict=True):
            body = pymunk.Body(1.0, 1.0)
            body.position, body.velocity = (x, 0.0), (v, 5.0 - 0.5 * G * duration)
            bodies.append(body)
        space.add(*bodies)
        return space, bodies

    def read_in_turn(steps: int) -> Outcome:
        space, bodies = in_space(0.0)
        places = in_frames(space.step, partial(in_turn, bodies), LONG, steps)
        return Outcome(places, LONG * steps * BODIES)

    def by_formula(_: int) -> Outcome:
        places = [place_at(frame / RATE) for frame in range(1, LONG + 1)]
        return Outcome(places, LONG * BODIES)

    steps = STEPS[:4]
    models = [
        Model("closed form", by_formula, (1,), is_formula=True),
        Model("particles, half a step ahead", by_particles, steps),
        Model("plain lists, half a step ahead", by_lists, steps),
        Model(EXAMPLES, read_in_turn, steps, "pymunk"),
        by_pymunk(BEST, in_space, LONG, steps, units=BODIES),
    ]
    return Scene("a thousand bodies in free fall", LONG, 2.0, place_at, models, COUNTED)


def resting(
    name: str, places: list[Place], fixed: int, masses: list[float], first: Sequence[int]
) -> Scene:
    """Create the scene of spheres at rest, of which the first ``fixed`` ones cannot move.

    Without fixed spheres, the lowest one stands on the ground. ``first`` lists the numbers of
    iterations that pymunk makes in the first step.
    """
    moving = tuple([part for place in places[fixed:] for part in place])
    units = len(places) - fixed

    def made() -> tuple[list[Particle], list[ContactGenerator]]:
        spheres = [
            Particle(Vector3(x, y), acceleration=Vector3(0.0, -G), mass=mass)
            for (x, y), mass in zip(places, masses, strict=True)
        ]
        contacts: list[ContactGenerator] = [ParticlePairs(spheres, RADIUS)]
        if not fixed:
            contacts.append(GroundPlane(spheres, radius=RADIUS))
        return spheres, contacts

    def ours(solver: str, steps: int) -> Outcome:
        spheres, contacts = made()
        place = partial(places_of, spheres[fixed:])
        found = in_frames(SOLVERS[solver](spheres, contacts), place, FRAMES, steps)
        return Outcome(found, FRAMES * steps * units)

    def sleeping() -> tuple[SleepingWorld, list[Particle]]:
        spheres, contacts = made()
        world = SleepingWorld(spheres, contacts, sleep_frames=1)
        world.fall_asleep(world.contacts())
        return world, spheres[fixed:]

    def in_space(iterations: int, slop: float | None, larger: float, _: float) -> InSpace:
        """Create the spheres in pymunk, with radii that are larger by ``larger`` m."""
        import pymunk

        space = pymunk.Space()
        space.gravity, space.iterations = (0.0, -G), iterations
        if slop is not None:
            space.collision_slop = slop
        bodies = []
        for i, ((x, y), mass) in enumerate(zip(places, masses, strict=True)):
            if i < fixed:
                space.add(pymunk.Circle(space.static_body, RADIUS + larger, (x, y)))
                continue
            body = pymunk.Body(mass, math.inf)
            body.position = (x, y)
            space.add(body, pymunk.Circle(body, RADIUS + larger))
            bodies.append(body)
        if not fixed:
            space.add(pymunk.Segment(space.static_body, (-9.0, 0.0), (9.0, 0.0), 0.0))
        return space, bodies

    def first_step(space: pymunk.Space, _: list[pymunk.Body]) -> Step:
        """Return a step that makes few iterations, except for the first time.

        Pymunk's solver starts from the impulses of the last step, which stay the same here.
        """

        def step(duration: float) -> None:
            space.step(duration)
            space.iterations = 3

        return step

    models = [
        Model(BOOK, partial(ours, BOOK), STEPS[:6], "the book"),
        Model(IMPULSES, partial(ours, IMPULSES), STEPS[:8]),
        Model(SMALL, partial(ours, SMALL), STEPS[:8]),
        asleep(sleeping, FRAMES),
        by_pymunk(EXAMPLES, partial(in_space, 10, None, 0.0), FRAMES, units=units),
        *(
            by_pymunk(at_best(number), partial(in_space, number, 0.0, 0.0), FRAMES, units=units)
            for number in (3, 10, 30, 100)
        ),
        *(
            by_pymunk(
                f"{BEST}, {number:,} iterations in the first step",
                partial(in_space, number, 1e-8, 1e-9),  # so that all spheres touch at the start
                FRAMES,
                (1,),
                first_step,
                units,
            )
            for number in first
        ),
        asleep_in_pymunk(partial(in_space, 1, None, 0.0, 0.0), FRAMES),
    ]
    return Scene(name, FRAMES, 2.0 * RADIUS, lambda _: moving, models, COUNTED)


def stack(ratio: float) -> Scene:
    """Create the scene of ten spheres that rest on one another.

    The top sphere has a mass of ``ratio`` kg, and the others have 1 kg.
    """
    places: list[Place] = [(0.0, (2 * i + 1) * RADIUS) for i in range(10)]
    name = f"stack of ten spheres, mass ratio {ratio:g}"
    first = (1000,) if ratio == 1.0 else (100_000, 300_000)
    return resting(name, places, 0, [*[1.0] * 9, ratio], first)


def pile() -> Scene:
    """Create the scene of a pile of 45 spheres, in nine rows above ten fixed spheres."""
    rise = math.sqrt(3.0) * RADIUS
    places: list[Place] = [
        (2.0 * RADIUS * i + RADIUS * row, row * rise) for row in range(10) for i in range(10 - row)
    ]
    return resting("pile of 45 spheres", places, 10, [*[math.inf] * 10, *[1.0] * 45], (1000,))


MANY_BODIES: list[Callable[[], Scene]] = [
    falling,
    partial(stack, 1.0),
    partial(stack, 1000.0),
    pile,
]
