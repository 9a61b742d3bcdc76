"""Nets of cables in a plane, and the models that simulate them in our engine and in pymunk.

The work is the number of links that were solved for. A link counts once per step in DirectNet, of
order 2, four times in SmoothNet, of order 4, and once per iteration in pymunk.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from typing import TYPE_CHECKING, Any

import numpy

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import AnchoredCable, AnchoredRod, Cable, Rod
from scenes.clock import RATE
from scenes.links import Strut
from scenes.setup import Setup
from scenes.twin import InSpace, twin_of
from studies.accuracy.in_plane import LONG, ORDERS, flat, in_plane
from studies.accuracy.in_pymunk import by_pymunk
from studies.accuracy.scene import Model, Outcome, Place, in_frames, places_of
from studies.models.direct_net import DirectNet
from studies.models.long_steps import in_long_steps
from studies.models.moving_load import Walker, borne, loading
from studies.models.order_8 import Numbers
from studies.models.plane_links import Link, accelerations_on_links
from studies.models.pymunk_steps import Step
from studies.models.smooth_net import SmoothNet
from studies.models.taut import TautMotion, Tie

if TYPE_CHECKING:
    import pymunk

G = 9.81  # m/s^2
Solver = type[DirectNet] | type[SmoothNet]


@dataclass(frozen=True)
class Plane:
    """A net in the X-Y plane: knots of given masses in kg, connected by cables and struts."""

    masses: Sequence[float]
    places: Sequence[Sequence[float]]
    ties: Sequence[Tie]
    frames: int
    walker: tuple[float, float, float] | None = None  # load's x in m, speed in m/s, weight in N

    def load(self, time: float, places: Any) -> Any:
        """Return the force on each knot in N: its weight, plus its part of the moving load."""
        forces = numpy.outer(self.masses, (0.0, -G))
        if self.walker:
            start, pace, weight = self.walker
            knot, share = borne([place[0] for place in places.reshape(-1, 2)], start + pace * time)
            forces[knot, 1] -= (1.0 - share) * weight
            forces[knot + 1, 1] -= share * weight
        return forces.ravel()

    def motion(self) -> TautMotion:
        """Return the exact motion of the net, which SciPy computes."""
        return TautMotion(self.masses, self.ties, self.load, self.places)

    def exact(self) -> Sequence[Place]:
        """Compute the exact positions of the net's knots at the end of each frame."""
        return self.motion().run([frame / RATE for frame in range(1, self.frames + 1)])

    def setup(self, is_taut: bool = False) -> Setup:
        """Create the knots, the load, and the ties: cables, or rods if ``is_taut``, and struts."""
        down = Vector3(0.0, -G)
        knots = [
            Particle(Vector3(x, y), acceleration=down, mass=mass)
            for mass, (x, y) in zip(self.masses, self.places, strict=True)
        ]
        cable, anchored = (Rod, AnchoredRod) if is_taut else (Cable, AnchoredCable)
        links: list[Any] = [
            anchored(knots[end], Vector3(*start), length)
            if not isinstance(start, int)
            else (cable if kind > 0 else Strut)(knots[start], knots[end], length)
            for start, end, length, kind in self.ties
        ]
        loads = [(knots[0], Walker(knots, *self.walker))] if self.walker else []
        return Setup(knots, loads, links)


def stepping(setup: Setup, kind: Solver) -> Step:
    """Return a function that advances a net, and its moving load if it has one, by one step."""
    forces = setup.registry().update_forces if setup.forces else None
    net = kind(setup.contacts, [load.ball for _, load in setup.forces if isinstance(load, Walker)])

    def step(duration: float) -> None:
        if isinstance(net, SmoothNet):
            net.step(duration, forces)
        else:
            if forces:
                forces(duration)
            net.step(duration)

    return step


def by_net(make: Callable[[], Setup], kind: Solver, frames: int, steps: int) -> Outcome:
    """Simulate a net with a solver that computes all tensions at once."""
    setup = make()
    places = partial(places_of, setup.particles)
    work = (4 if kind is SmoothNet else 1) * frames * steps * len(setup.contacts)
    return Outcome(in_frames(stepping(setup, kind), places, frames, steps), work)


def by_long_steps(make: Callable[[], Plane], steps: int) -> Outcome:
    """Simulate a net in ``steps`` time steps per twelve frames, and interpolate the frames."""
    plane = make()
    setup = plane.setup()
    step, every = stepping(setup, SmoothNet), LONG // steps

    def state() -> tuple[Numbers, Numbers]:
        vectors = [(knot.position, knot.velocity) for knot in setup.particles]
        return [complex(p.x, p.y) for p, _ in vectors], [complex(v.x, v.y) for _, v in vectors]

    places = in_long_steps(lambda: step(every / RATE), state, flat, every, plane.frames)
    return Outcome(places, 4 * plane.frames // every * len(plane.ties))


def by_links(plane: Plane) -> list[Model]:
    """Create the multistep models of a net, which work while all cables are taut."""
    count = len(plane.masses)
    # If a load moves across the net, the last body is its clock, which moves by 1 m per s.
    still, moves = ([0j], [1.0]) if plane.walker else ([], [])

    def free(positions: Numbers) -> Numbers:
        found = [complex(0.0, -G)] * count + still
        if plane.walker:
            start, pace, load = plane.walker
            xs = [position.real for position in positions[:-1]]
            knot, share = borne(xs, start + pace * positions[-1].real)
            found[knot] -= 1j * (1.0 - share) * load / plane.masses[knot]
            found[knot + 1] -= 1j * share * load / plane.masses[knot + 1]
        return found

    links: list[Link] = [
        (start if isinstance(start, int) else complex(*start), end, length)
        for start, end, length, _ in plane.ties
    ]
    models = in_plane(
        [*(complex(*place) for place in plane.places), *still],
        [*[0j] * count, *moves],
        accelerations_on_links([*plane.masses, *moves], links, free),
        plane.frames,
        is_damped=True,
        place=lambda positions: flat(positions[:count]),
        units=len(links),
    )
    return models[: len(ORDERS)]


def in_pymunk(
    plane: Callable[[], Plane],
    iterations: int,
    *,
    is_ahead: bool = False,
    corrects: bool = False,
    is_taut: bool = False,
) -> Callable[[int], Outcome]:
    """Return a simulation of a net in pymunk, half a step ahead if ``is_ahead``.

    With ``corrects``, the joints correct their whole error in each step. With ``is_taut``, pin
    joints act as the cables, which must not become slack.
    """
    first = cache(lambda: plane().motion().first_accelerations())

    def make(duration: float) -> InSpace:
        setup = replace(plane().setup(is_taut), forces=())
        half = 0.5 * duration * is_ahead
        for knot, (x, y) in zip(setup.particles, first(), strict=True):
            knot.velocity = Vector3(half * x, half * y)
        return twin_of(setup, iterations=iterations, corrects=corrects)

    def walking(space: pymunk.Space, bodies: list[pymunk.Body]) -> Step:
        walker = plane().walker
        return loading(space, bodies, *walker, is_ahead=is_ahead) if walker else space.step

    return lambda steps: by_pymunk("", make, plane().frames, stepping=walking).run(steps)
