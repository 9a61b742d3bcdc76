"""Three scenes with nets of cables: a swinging rope bridge, one with a load, and a net."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache, partial
from itertools import pairwise
from typing import Any

from ch08_mass_aggregate.bridge_plan import CABLE_LENGTH, PLANK_MASS, ROWS
from ch08_mass_aggregate.world import ParticleWorld
from scenes.clock import deviation
from studies.accuracy.in_plane import LONG, ORDERS
from studies.accuracy.in_plane import LONG_STEPS as MULTISTEPS
from studies.accuracy.in_pymunk import EXAMPLES, at_best, from_two_runs
from studies.accuracy.measured.planes import G, Plane, by_links, by_long_steps, by_net, in_pymunk
from studies.accuracy.scene import STEPS, Model, Outcome, Scene, framed
from studies.models.direct_net import DirectNet
from studies.models.equilibrium import equilibrium
from studies.models.hanging_bridge import MASSES, cables, hanging
from studies.models.smooth_net import SmoothNet
from studies.models.taut import Tie

LONG_STEPS = (1, 2, 3, 4, 6)  # per twelve frames
FINE = 8  # steps per frame of our own run, with which the truth is compared


def scene_of(
    name: str,
    scale: float,
    frames: int,
    make: Callable[[int], Plane],
    solvers: Sequence[tuple[int, bool]],
    taut: Sequence[tuple[int, bool]] = (),
) -> Scene:
    """Create the scene of a net of cables, which ``make`` builds when it is first needed.

    ``solvers`` lists pymunk's iterations, each with whether joints correct their whole error. If no
    cable becomes slack, ``taut`` lists those with pin joints. Only then are long steps possible.
    """
    plane = cache(lambda: make(frames))
    exact = cache(lambda: plane().exact())

    def differs() -> float:
        own = by_net(plane().setup, SmoothNet, frames, FINE).places
        return max(map(deviation, own, exact())) / scale

    def multistep(i: int, steps: int) -> Outcome:
        return linked()[i].run(steps)

    linked = cache(lambda: by_links(plane()))
    net = partial(by_net, lambda: plane().setup())
    models = [
        Model("direct net", partial(net, DirectNet, frames), STEPS[:6]),
        Model("smooth net, order 4", partial(net, SmoothNet, frames), STEPS[:4]),
    ]
    if taut:
        long = partial(by_long_steps, plane)
        models.append(Model("smooth net in long steps", long, LONG_STEPS, per=LONG))
        models += [
            Model(f"multistep, order {order}", partial(multistep, i), MULTISTEPS, per=LONG)
            for i, order in enumerate(ORDERS)
        ]
    models.append(Model(EXAMPLES, in_pymunk(plane, 10), STEPS, "pymunk"))
    smooth = []
    for chosen, is_taut in ((solvers, False), (taut, True)):
        for number, corrects in chosen:
            best = at_best(number) + ", pin joints" * is_taut + ", default bias" * (not corrects)
            by = in_pymunk(plane, number, is_ahead=True, corrects=corrects, is_taut=is_taut)
            models.append(Model(best, by, STEPS, "pymunk"))
            # With the default bias, the error does not fall with the square of the step.
            smooth += [models[-1]] * bool(taut and corrects)
    models += map(from_two_runs, smooth)

    return Scene(name, frames, scale, framed(exact), models, "links solved for", differs)


def settled(plane: Plane, wind: float = 0.0) -> Plane:
    """Return a copy of a net that starts where it is at rest in a ``wind``, in m/s^2 along X."""
    setup = plane.setup()
    for knot in setup.particles:
        knot.acceleration.x = wind
    world = ParticleWorld(setup.particles, setup.contacts)
    for knot, walker in setup.forces:
        world.registry.add(knot, walker)
    equilibrium(world)
    return replace(plane, places=[(knot.position.x, knot.position.y) for knot in setup.particles])


def bridge(masses: Sequence[float], frames: int, walker: Any = None, wind: float = 0.0) -> Plane:
    """Build one side of the rope bridge of chapter 8, at rest."""
    ties: list[Tie] = [(*cable, 1) for cable in cables()]
    return settled(Plane(masses, hanging(), ties, frames, walker), wind)


def swinging() -> Scene:
    """Create the scene of a rope bridge that swings for 2 s after a wind, with taut cables."""
    taut = ((5, False), (10, True), (15, True))
    make = partial(bridge, MASSES, wind=3.0)
    return scene_of("rope bridge swinging", CABLE_LENGTH, 120, make, [(10, True)], taut)


def walked_over() -> Scene:
    """Create the scene of a ball of 5 kg that crosses a rope bridge at 2 m/s, with taut cables."""
    taut = ((3, False), (10, True), (15, True))
    walker = (-3.6, 2.0, 0.5 * 5.0 * G)  # one side carries half of the weight
    make = partial(bridge, [PLANK_MASS] * ROWS, walker=walker)
    return scene_of("rope bridge walked over", CABLE_LENGTH, 216, make, [(10, True)], taut)


def catching() -> Scene:
    """Create the scene of a net between two poles that catches a ball, slightly off center.

    The horizontal cables below the top row hang slack. The ball can hit only the upper two rows.
    """
    size, gap, radius = 6, 0.5, 0.5

    def make(frames: int) -> Plane:
        ties: list[Tie] = []
        for row in range(size):
            y, length = -gap * row, 0.59 if row else 0.55  # m, of the horizontal cables
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
        net = settled(Plane([0.2] * size**2, places, ties, frames))
        top = net.places[2][1] + math.sqrt(radius**2 - 0.04) + 0.3  # the ball falls 0.3 m
        ties += [(size**2, knot, radius, -1) for knot in range(2 * size)]
        return Plane([*net.masses, 1.0], [*net.places, (0.07, top)], ties, frames)

    solvers = [(20, False), (30, False), (100, True)]
    return scene_of("net of 6 by 6 cables", gap, 36, make, solvers)


NETS: list[Callable[[], Scene]] = [swinging, walked_over, catching]
