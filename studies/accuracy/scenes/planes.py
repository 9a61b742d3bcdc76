"""Simulate a net of cables with our engine and with pymunk, and compute its exact motion.

The net moves in a plane, because pymunk is two-dimensional. Our engine has two solvers for nets:
DirectNet, which has order 2, and SmoothNet, which has order 4.

The work of a simulation is counted rather than timed, so it does not depend on the computer's
speed. In DirectNet, every link counts once per step. SmoothNet computes all tensions four times per
step, so every link counts four times. In pymunk, slide joints act as the links, and each joint
counts once per iteration.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from typing import TYPE_CHECKING, Any

import numpy

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch07_constraints.links import AnchoredCable, Cable
from scenes.clock import RATE
from scenes.twin import InSpace
from studies.accuracy.in_plane import LONG, ORDERS, flat, in_long_steps, in_plane
from studies.accuracy.in_pymunk import Step, by_pymunk
from studies.accuracy.scene import Model, Outcome, in_frames, places_of
from studies.accuracy.scenes.taut import TautMotion, Tie
from studies.models.direct_net import DirectNet
from studies.models.net import Strut
from studies.models.order_8 import Numbers
from studies.models.plane_links import Link, accelerations_on_links
from studies.models.smooth_net import SmoothNet

if TYPE_CHECKING:
    import pymunk

COUNTED = "links solved for"
FAR = 1e3  # m, more than the length that any slide joint reaches


@dataclass(frozen=True)
class Plane:
    """A net in the X-Y plane: knots that are connected by cables and struts.

    - ``masses``: the masses of the knots in kg.
    - ``places``: the initial positions of the knots.
    - ``ties``: the cables and struts, in the form that TautMotion takes.
    - ``walker``: a load that moves across the net, or None. It is a tuple of its initial x in m,
      its speed in m/s and its weight in N. The two knots next to the load share its weight, and the
      nearer one carries more.
    """

    masses: Sequence[float]
    places: Sequence[tuple[float, float]]
    ties: Sequence[Tie]
    frames: int
    walker: tuple[float, float, float] | None = None
    gravity: float = 9.81

    def load(self, time: float, places: Any) -> Any:
        """Return the force on each knot in N: its weight, plus its part of the moving load."""
        forces = numpy.outer(self.masses, (0.0, -self.gravity))
        if self.walker:
            start, pace, weight = self.walker
            knot, share = borne([place[0] for place in places.reshape(-1, 2)], start + pace * time)
            forces[knot, 1] -= (1.0 - share) * weight
            forces[knot + 1, 1] -= share * weight
        return forces.ravel()

    def exact(self) -> Any:
        """Compute the exact positions of the net's knots at the end of each frame, using SciPy."""
        motion = TautMotion(self.masses, self.ties, self.load)
        times = [frame / RATE for frame in range(1, self.frames + 1)]
        still = numpy.zeros((len(self.masses), 2))
        return motion.run(numpy.array(self.places), still, times)

    def first_accelerations(self) -> Any:
        """Compute the accelerations of all knots at the start, with those of the taut cables."""
        motion = TautMotion(self.masses, self.ties, self.load)
        places = numpy.ravel(numpy.array(self.places, float))
        state, taut = motion.choose(0.0, numpy.concatenate([places, 0.0 * places]))
        return motion.accelerations(0.0, state, taut)[0]

    def particles(self) -> list[Particle]:
        """Create a new particle for each knot of the net, at the knot's initial position."""
        down = Vector3(0.0, -self.gravity)
        return [
            Particle(Vector3(x, y), acceleration=down, mass=mass)
            for mass, (x, y) in zip(self.masses, self.places, strict=True)
        ]

    def links(self, knots: Sequence[Particle]) -> list[Any]:
        """Create the cables and struts that connect the knots, as Cable and Strut objects.

        ``knots`` are the particles at the knots. A link to a fixed point is an AnchoredCable.
        """
        found: list[Any] = []
        for start, end, length, kind in self.ties:
            if not isinstance(start, int):
                found.append(AnchoredCable(knots[end], Vector3(*start), length))
            elif kind > 0:
                found.append(Cable(knots[start], knots[end], length))
            else:
                found.append(Strut(knots[start], knots[end], length))
        return found


def borne(xs: Sequence[float], x: float) -> tuple[int, float]:
    """Find the two knots of a net that carry a load at ``x``, and how they share its weight.

    ``xs`` lists the x coordinates of the knots. Return the index of the knot behind the load, and
    the fraction of the weight that the knot ahead carries. This fraction grows linearly from 0 to 1
    as the load moves from one knot to the next.
    """
    knot = sum(x >= other for other in xs[1:-1])
    return knot, min(max((x - xs[knot]) / (xs[knot + 1] - xs[knot]), 0.0), 1.0)


class Walker:
    """A force generator for a load that moves across a net, such as a ball.

    It divides the weight of the load between the two knots next to it. Register the generator for
    only one knot, since it adds forces to both knots itself.
    """

    def __init__(self, knots: Sequence[Particle], walker: Particle, weight: float) -> None:
        self.knots, self.walker, self.weight = knots, walker, weight

    def update_force(self, _: Particle, __: float) -> None:
        """Divide the weight between the two knots next to the load. The nearer knot gets more."""
        xs = [knot.position.x for knot in self.knots]
        knot, share = borne(xs, self.walker.position.x)
        self.knots[knot].add_force(Vector3(0.0, (share - 1.0) * self.weight))
        self.knots[knot + 1].add_force(Vector3(0.0, -share * self.weight))


def made(plane: Plane, kind: type[DirectNet] | type[SmoothNet]) -> tuple[list[Particle], Any]:
    """Create the particles of a net, and a function that advances them by one time step.

    ``kind`` is the solver, DirectNet or SmoothNet. If a load moves across the net, each step also
    moves the load and applies its weight.
    """
    knots = plane.particles()
    registry, walkers = ForceRegistry(), []
    if plane.walker:
        start, pace, weight = plane.walker
        walkers.append(Particle(Vector3(start), Vector3(pace)))
        registry.add(knots[0], Walker(knots, walkers[0], weight))
    net = kind(plane.links(knots), walkers)
    forces = registry.update_forces if walkers else None

    def step(duration: float) -> None:
        if isinstance(net, SmoothNet):
            net.step(duration, forces)
        else:
            if forces:
                forces(duration)
            net.step(duration)

    return knots, step


def by_net(plane: Plane, kind: type[DirectNet] | type[SmoothNet], steps: int) -> Outcome:
    """Simulate a net with a solver that computes all tensions at once, DirectNet or SmoothNet."""
    knots, step = made(plane, kind)
    stages = 4 if kind is SmoothNet else 1
    work = stages * plane.frames * steps * len(plane.ties)
    return Outcome(in_frames(step, partial(places_of, knots), plane.frames, steps), work)


def by_long_steps(plane: Plane, steps: int) -> Outcome:
    """Simulate a net in time steps longer than a frame, and interpolate the frames in between.

    There are ``steps`` time steps in every twelve frames.
    """
    knots, step = made(plane, SmoothNet)
    every = LONG // steps

    def state() -> tuple[list[float], list[float]]:
        points, moves = [k.position for k in knots], [k.velocity for k in knots]
        return [c for p in points for c in (p.x, p.y)], [c for v in moves for c in (v.x, v.y)]

    places = in_long_steps(lambda: step(every / RATE), state, tuple, every, plane.frames)
    return Outcome(places, 4 * plane.frames // every * len(plane.ties))


def by_links(plane: Plane) -> list[Model]:
    """Create the multistep models of a net, which work while all cables are taut.

    If a load moves across the net, the last body is its clock, which moves by 1 m per s.
    """
    weight = complex(0.0, -plane.gravity)
    clock = [0j] if plane.walker else []

    def free(positions: Numbers) -> Numbers:
        found = [weight] * len(plane.masses) + clock
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
    count = len(plane.masses)
    models = in_plane(
        [*(complex(*place) for place in plane.places), *clock],
        [*[0j] * count, *(1.0 for _ in clock)],
        accelerations_on_links([*plane.masses, *(1.0 for _ in clock)], links, free),
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
    """Return a simulation of a net in pymunk, where slide joints act as the cables and struts.

    Pymunk's solver makes ``iterations`` iterations per step. ``is_ahead`` starts half a step ahead.
    With ``corrects``, the joints correct their whole error in each step. With ``is_taut``, pin
    joints act as the cables, which is correct only if no cable becomes slack.
    """

    @cache
    def first() -> list[tuple[float, float]]:
        return [(float(x), float(y)) for x, y in plane().first_accelerations().reshape(-1, 2)]

    def make(duration: float) -> InSpace:
        import pymunk

        net = plane()
        space = pymunk.Space()
        space.gravity, space.iterations = (0.0, -net.gravity), iterations
        bodies = [pymunk.Body(mass, math.inf) for mass in net.masses]
        still = space.static_body
        half = 0.5 * duration * is_ahead
        for body, point, (x, y) in zip(bodies, net.places, first(), strict=True):
            body.position, body.velocity = point, (half * x, half * y)
        space.add(*bodies)
        for start, end, length, kind in net.ties:
            held, at = (bodies[start], (0.0, 0.0)) if isinstance(start, int) else (still, start)
            if is_taut:
                joint: pymunk.Constraint = pymunk.PinJoint(held, bodies[end], at)
            else:
                limits = (0.0, length) if kind > 0 else (length, FAR)
                joint = pymunk.SlideJoint(held, bodies[end], at, (0.0, 0.0), *limits)
            if corrects:
                joint.error_bias = 0.0
            space.add(joint)
        return space, bodies

    def stepping(space: pymunk.Space, bodies: list[pymunk.Body]) -> Step:
        """Return a step that first applies the moving load, where it is at the end of the step."""
        net = plane()
        if not net.walker:
            return space.step
        start, pace, weight = net.walker
        x, knot = start, 0

        def place_of(body: pymunk.Body, duration: float) -> float:
            return body.position.x + (body.velocity.x * duration if is_ahead else 0.0)

        def step(duration: float) -> None:
            nonlocal x, knot
            x += pace * duration * is_ahead
            ahead = place_of(bodies[knot + 1], duration)
            while x >= ahead and knot < len(bodies) - 2:
                knot += 1
                ahead = place_of(bodies[knot + 1], duration)
            behind = place_of(bodies[knot], duration)
            share = min(max((x - behind) / (ahead - behind), 0.0), 1.0)
            bodies[knot].apply_force_at_local_point((0.0, (share - 1.0) * weight))
            bodies[knot + 1].apply_force_at_local_point((0.0, -share * weight))
            space.step(duration)
            x += pace * duration * (not is_ahead)

        return step

    return lambda steps: by_pymunk("", make, plane().frames, stepping=stepping).run(steps)
