"""Models that simulate a scene in pymunk: as its examples do, and at its best.

A step of pymunk moves all bodies before it changes their velocities, so as in most of its examples
the error falls in proportion to the step. The changes that README.md describes, with public
functions only, make it fall with the square of the step: a start half a step ahead, our own forces
before the step, and joints without bias.

A ``DampedSpring`` damps after it has changed the velocity, and the damping of a space comes before
gravity. A spring that is stiffer by half a step's damping, or a gravity that is weaker by it, makes
the step symmetric, which keeps the order at 2.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from scenes.clock import RATE
from scenes.setup import Setup, alone
from scenes.twin import InSpace, twin_of
from studies.accuracy.scene import MANY, Model, Outcome, Place, in_frames
from studies.models.order_8 import Acceleration
from studies.models.pymunk_steps import Step, calling_back, changing, pushing

if TYPE_CHECKING:
    import pymunk

EXAMPLES, BEST = "pymunk, as in its examples", "pymunk at its best"
BATCH = 4  # bodies from which it is faster to read all positions in one call


def by_pymunk(
    name: str,
    make: Callable[[float], InSpace],
    frames: int,
    steps: Sequence[int] = MANY,
    stepping: Callable[[pymunk.Space, list[pymunk.Body]], Step] = lambda space, _: space.step,
    units: int = 1,
) -> Model:
    """Create a model from ``make``, which takes the duration of a step in s.

    A step counts as one unit of work for each iteration of each joint or, without joints, as
    ``units``.
    """

    def run(count: int) -> Outcome:
        space, bodies = make(1.0 / (RATE * count))
        places = in_frames(stepping(space, bodies), reading(space, bodies), frames, count)
        work = len(space.constraints) * space.iterations or units
        return Outcome(places, frames * count * work)

    return Model(name, run, steps, "pymunk")


def from_two_runs(model: Model) -> Model:
    """Return a model that combines two runs of ``model``, with n and with 2n steps per frame.

    If the error falls with the square of the step, this cancels most of it (Richardson). What is
    left has order 4, or 3 if forces depend on the velocity.
    """

    def run(count: int) -> Outcome:
        one, two = model.run(count), model.run(2 * count)
        places = [
            tuple([(4.0 * fine - coarse) / 3.0 for coarse, fine in zip(a, b, strict=True)])
            for a, b in zip(one.places, two.places, strict=True)
        ]
        return Outcome(places, one.work + two.work)

    return replace(model, name=f"{model.name}, from two runs", run=run)


def lone(make: Callable[[], Setup], acceleration: Acceleration, frames: int) -> list[Model]:
    """Create the models of a single body in pymunk under a force of our own.

    At its best, pymunk starts half a step behind.
    """
    (start,) = make().particles
    place, velocity = (complex(v.x, v.y) for v in (start.position, start.velocity))
    first = acceleration(place, velocity)

    def begun(_: float, behind: float = 0.0) -> InSpace:
        past = velocity - behind * first
        return twin_of(alone(Particle(start.position, Vector3(past.real, past.imag))), iterations=1)

    by_hand, called = partial(pushing, acceleration), partial(calling_back, acceleration)
    ahead = partial(changing, acceleration, first)
    return [
        by_pymunk("pymunk, force by hand", begun, frames, stepping=by_hand),
        by_pymunk(EXAMPLES, begun, frames, stepping=called),
        by_pymunk(BEST, lambda h: begun(h, 0.5 * h), frames, stepping=ahead),
    ]


def at_best(iterations: int) -> str:
    """Return the name of pymunk at its best in a scene with joints."""
    return f"{BEST}, {iterations} iteration{'s' * (iterations > 1)}"


def in_turn(bodies: Sequence[pymunk.Body]) -> Place:
    """Read the coordinates of the bodies, one body after the other."""
    return tuple([part for body in bodies for part in body.position])


def reading(space: pymunk.Space, bodies: list[pymunk.Body]) -> Callable[[], Sequence[float]]:
    """Return the fastest function that reads the coordinates of all bodies of a space."""
    if len(bodies) == 1:
        (body,) = bodies
        return lambda: body.position  # a tuple of x and y
    if len(bodies) < BATCH:
        return lambda: in_turn(bodies)

    import pymunk.batch

    field, data = pymunk.batch.BodyFields.POSITION, pymunk.batch.Buffer()
    count = 2 * len(bodies)  # the static body follows, if a joint holds it

    def place() -> Place:
        data.clear()
        pymunk.batch.get_space_bodies(space, field, data)
        return memoryview(bytes(data.float_buf())).cast("d")[:count]

    return place
