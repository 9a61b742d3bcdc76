"""Define three scenes with nets of cables, in which our engine is compared with pymunk.

- A rope bridge swings.
- A ball moves across a rope bridge.
- A net catches a ball.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from itertools import pairwise
from typing import Any

import numpy

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch08_mass_aggregate.bridge_plan import CABLE_LENGTH, PLANK_MASS, ROWS
from ch08_mass_aggregate.world import ParticleWorld
from scenes.clock import RATE
from studies.accuracy.in_plane import LONG, ORDERS
from studies.accuracy.in_plane import LONG_STEPS as MULTISTEPS
from studies.accuracy.in_pymunk import EXAMPLES, at_best, from_two_runs
from studies.accuracy.scene import STEPS, Model, Outcome, Place, Scene
from studies.accuracy.scenes.hanging import MASSES, cables, hanging
from studies.accuracy.scenes.planes import (
    COUNTED,
    Plane,
    Walker,
    by_links,
    by_long_steps,
    by_net,
    in_pymunk,
)
from studies.accuracy.scenes.taut import Tie
from studies.models.direct_net import DirectNet
from studies.models.equilibrium import equilibrium
from studies.models.smooth_net import SmoothNet

LONG_STEPS = (1, 2, 3, 4, 6)  # per twelve frames
FINE = 8  # steps per frame of our own run, with which the truth is compared


def scene_of(
    name: str,
    frames: int,
    scale: float,
    make: Callable[[], Plane],
    solvers: Sequence[tuple[int, bool]],
    taut: Sequence[tuple[int, bool]] = (),
) -> Scene:
    """Create the scene of a net of cables, with its exact solution and a model for each solver.

    ``make`` is a function that builds the net. It is called only once, when the net is first
    needed. SciPy computes the exact solution. To check it, ``Scene.differs`` compares it with our
    own simulation in short steps. ``solvers`` lists the numbers of iterations that pymunk makes in
    each step, and whether its joints correct their whole error. If all cables stay taut, ``taut``
    lists the same for pin joints. Long steps and extrapolation make sense only then, because the
    motion is smooth.
    """
    plane = cache(make)

    @cache
    def exact() -> list[Place]:
        return [tuple(map(float, place)) for place in plane().exact()]

    def differs() -> float:
        own = by_net(plane(), SmoothNet, FINE).places
        return float(abs(numpy.array(own) - numpy.array(exact())).max()) / scale

    def run(by: Callable[..., Outcome], *chosen: Any) -> Callable[[int], Outcome]:
        return lambda steps: by(plane(), *chosen, steps)

    def multistep(i: int) -> Callable[[int], Outcome]:
        return lambda steps: linked()[i].run(steps)

    linked = cache(lambda: by_links(plane()))
    smooth = [
        Model("smooth net in long steps", run(by_long_steps), LONG_STEPS, per=LONG),
        *(
            Model(f"multistep, order {order}", multistep(i), MULTISTEPS, per=LONG)
            for i, order in enumerate(ORDERS)
        ),
    ]
    best = [
        (
            Model(
                at_best(number) + ", pin joints" * is_taut + ", default bias" * (not corrects),
                in_pymunk(plane, number, is_ahead=True, corrects=corrects, is_taut=is_taut),
                STEPS,
                "pymunk",
            ),
            corrects,
        )
        for chosen, is_taut in ((solvers, False), (taut, True))
        for number, corrects in chosen
    ]
    models = [
        Model("direct net", run(by_net, DirectNet), STEPS[:6]),
        Model("smooth net, order 4", run(by_net, SmoothNet), STEPS[:4]),
        *(smooth if taut else ()),
        Model(EXAMPLES, in_pymunk(plane, 10), STEPS, "pymunk"),
        *(model for model, _ in best),
        # With the default bias, the error does not fall with the square of the step.
        *(from_two_runs(model) for model, corrects in best if taut and corrects),
    ]
    return Scene(
        name, frames, scale, lambda t: exact()[round(t * RATE) - 1], models, COUNTED, differs
    )


def bridge_ties() -> list[Tie]:
    """List the cables on one side of the rope bridge, with the lengths that they have in pymunk.

    Pymunk is two-dimensional, so the length of each cable is that of its projection onto the X-Y
    plane.
    """
    return [(start, end, length, 1) for start, end, length in cables()]


def hung() -> list[tuple[float, float]]:
    """Compute the rest positions of the planks' ends on one side of the rope bridge.

    The third plank carries a load.
    """
    return [(x, y) for x, y in hanging()]


def settled(plane: Plane, wind: float = 0.0) -> Plane:
    """Let a net of cables come to rest, and return a copy that starts in that position.

    ``wind`` is an acceleration along X in m/s^2. It acts only until the net has come to rest.
    """
    knots = plane.particles()
    for knot in knots:
        knot.acceleration.x = wind
    world = ParticleWorld(knots, plane.links(knots))
    if plane.walker:
        start, _, weight = plane.walker
        world.registry.add(knots[0], Walker(knots, Particle(Vector3(start)), weight))
    equilibrium(world)
    return replace(plane, places=[(knot.position.x, knot.position.y) for knot in knots])


def swinging() -> Scene:
    """Create the scene of a rope bridge that swings for 2 s after a wind has stopped.

    Only one side of the bridge is simulated. It starts from the position in which a steady wind of
    3 m/s^2 held it. All cables stay taut, and there is no damping.
    """

    def make() -> Plane:
        return settled(Plane(MASSES, hung(), bridge_ties(), 120), wind=3.0)

    taut = ((5, False), (10, True), (15, True))
    return scene_of("rope bridge swinging", 120, CABLE_LENGTH, make, [(10, True)], taut)


def walked_over() -> Scene:
    """Create the scene of a ball that moves across a rope bridge for 3.6 s.

    The ball has a mass of 5 kg and a speed of 2 m/s. Only one side of the bridge is simulated, so
    it carries half of the ball's weight. At any time, the two planks next to the ball share this
    load. All cables stay taut.
    """

    def make() -> Plane:
        walker = (-3.6, 2.0, 0.5 * 5.0 * 9.81)
        return settled(Plane([PLANK_MASS] * ROWS, hung(), bridge_ties(), 216, walker))

    taut = ((3, False), (10, True), (15, True))
    return scene_of("rope bridge walked over", 216, CABLE_LENGTH, make, [(10, True)], taut)


def catching() -> Scene:
    """Create the scene of a net that catches a ball.

    The scene lasts 0.6 s. The net has 6 by 6 knots of 0.2 kg each, and hangs between two poles. The
    horizontal cables are 0.55 m long in the top row. They are 0.59 m long in the rows below, where
    they hang slack. Vertical cables of 0.45 m connect each knot to the one below it.

    The ball has a mass of 1 kg and a radius of 0.5 m. It falls 0.3 m, and lands slightly off
    center. It can collide with the knots of the upper two rows.
    """
    size, gap, radius = 6, 0.5, 0.5

    def make() -> Plane:
        ties: list[Tie] = []
        for row in range(size):
            y, length = -gap * row, 0.59 if row else 0.55
            knots = [size * row + column for column in range(size)]
            ties.append(((-3.5 * gap, y), knots[0], length, 1))
            ties += [(a, b, length, 1) for a, b in pairwise(knots)]
            ties.append(((3.5 * gap, y), knots[-1], length, 1))
            ties += [(knot - size, knot, 0.45, 1) for knot in knots if row]
        places = [
            (gap * (column - 2.5), -gap * row - 0.05)
            for row in range(size)
            for column in range(size)
        ]
        net = settled(Plane([0.2] * size**2, places, ties, 36))
        top = net.places[2][1] + math.sqrt(radius**2 - 0.04) + 0.3
        struts: list[Tie] = [(size**2, knot, radius, -1) for knot in range(2 * size)]
        return replace(
            net,
            masses=[*net.masses, 1.0],
            places=[*net.places, (0.07, top)],
            ties=[*ties, *struts],
        )

    solvers = [(20, False), (30, False), (100, True)]
    return scene_of("net of 6 by 6 cables", 36, gap, make, solvers)


NETS: list[Callable[[], Scene]] = [swinging, walked_over, catching]
