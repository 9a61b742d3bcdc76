"""Scenes of nets: the rope bridge that swings, is walked over and sleeps, and a net that catches.

All are in a plane, as pymunk's are. What is counted is links solved for: four times a step for a
net of order 4. Pymunk goes through its joints in each step as often as it has iterations.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from typing import Any

import numpy

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch07_constraints.direct_net import DirectNet
from ch07_constraints.links import AnchoredCable, Cable
from ch07_constraints.net import Strut
from ch07_constraints.smooth_net import SmoothNet, hermite
from ch08_mass_aggregate.bridge_plan import CABLE_LENGTH, PLANK_MASS, ROWS
from ch08_mass_aggregate.equilibrium import equilibrium
from ch08_mass_aggregate.world import ParticleWorld
from studies.accuracy.bridge import MASSES, cables, hanging
from studies.accuracy.scene import RATE, STEPS, Model, Outcome, Place, Scene, in_frames
from studies.accuracy.taut import TautMotion, Tie

COUNTED = "links solved for"
LONG = 12  # frames, in which a net of order 4 makes few steps
FINE = 8  # steps a frame, of our own run that the truth is compared with
FAR = 1e3  # m: no slide joint gets as long


@dataclass(frozen=True)
class Plane:
    """Knots with masses in kg at their start positions, and the ties between them; see TautMotion.

    ``walker`` is what walks over the knots in their order: its x at the start in m, its speed in
    m/s, and its weight in N, which the two knots beside it bear in proportion.
    """

    masses: Sequence[float]
    places: Sequence[tuple[float, float]]
    ties: Sequence[Tie]
    frames: int
    walker: tuple[float, float, float] | None = None
    gravity: float = 9.81

    def load(self, time: float, places: Any) -> Any:
        """Return the weights on all knots, and that of the walker."""
        forces = numpy.outer(self.masses, (0.0, -self.gravity))
        if self.walker:
            start, pace, weight = self.walker
            knot, share = borne([place[0] for place in places.reshape(-1, 2)], start + pace * time)
            forces[knot, 1] -= (1.0 - share) * weight
            forces[knot + 1, 1] -= share * weight
        return forces.ravel()

    def exact(self) -> Any:
        """Return the positions at the end of each frame, by SciPy."""
        motion = TautMotion(self.masses, self.ties, self.load)
        times = [frame / RATE for frame in range(1, self.frames + 1)]
        still = numpy.zeros((len(self.masses), 2))
        return motion.run(numpy.array(self.places), still, times)

    def particles(self) -> list[Particle]:
        """Return the knots of one copy."""
        down = Vector3(0.0, -self.gravity)
        return [
            Particle(Vector3(x, y), acceleration=down, mass=mass)
            for mass, (x, y) in zip(self.masses, self.places, strict=True)
        ]

    def links(self, knots: Sequence[Particle]) -> list[Any]:
        """Return the links of chapter 7 that are these ties."""
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
    """Return after which knot a walker is, and which fraction of the way to the next one."""
    knot = sum(x >= other for other in xs[1:-1])
    return knot, min(max((x - xs[knot]) / (xs[knot + 1] - xs[knot]), 0.0), 1.0)


class Walker:
    """Generates the weight of a walker; it is registered for one knot, and pulls at two."""

    def __init__(self, knots: Sequence[Particle], walker: Particle, weight: float) -> None:
        self.knots, self.walker, self.weight = knots, walker, weight

    def update_force(self, particle: Particle, duration: float) -> None:
        xs = [knot.position.x for knot in self.knots]
        knot, share = borne(xs, self.walker.position.x)
        self.knots[knot].add_force(Vector3(0.0, (share - 1.0) * self.weight))
        self.knots[knot + 1].add_force(Vector3(0.0, -share * self.weight))


def made(plane: Plane, kind: type[DirectNet] | type[SmoothNet]) -> tuple[list[Particle], Any]:
    """Return the knots, and what makes a step of their net."""
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
    """Step the net, and read the positions of the knots in every frame."""
    knots, step = made(plane, kind)

    def place() -> Place:
        return tuple([part for knot in knots for part in (knot.position.x, knot.position.y)])

    stages = 4 if kind is SmoothNet else 1
    work = stages * plane.frames * steps * len(plane.ties)
    return Outcome(in_frames(step, place, plane.frames, steps), work)


def by_long_steps(plane: Plane, steps: int) -> Outcome:
    """Make so many steps of order 4 in LONG frames, and read cubics between their ends.

    That is good for smooth motion: there is no cubic through an impact.
    """
    knots, step = made(plane, SmoothNet)

    def state() -> tuple[list[float], list[float]]:
        points, moves = [k.position for k in knots], [k.velocity for k in knots]
        return [c for p in points for c in (p.x, p.y)], [c for v in moves for c in (v.x, v.y)]

    every, places = LONG // steps, []
    duration = every / RATE
    old, fast = state()
    for _ in range(plane.frames // every):
        step(duration)
        new, later = state()
        for frame in range(1, every):
            places.append(tuple(hermite(old, fast, new, later, duration, frame / every)))
        places.append(tuple(new))
        old, fast = new, later
    return Outcome(places, 4 * plane.frames // every * len(plane.ties))


def by_slide_joints(plane: Plane, iterations: int, steps: int) -> Outcome:
    """Let pymunk hold the knots by slide joints, with so many iterations of its solver a step."""
    import pymunk

    space = pymunk.Space()
    space.gravity, space.iterations = (0.0, -plane.gravity), iterations
    bodies = [pymunk.Body(mass, math.inf) for mass in plane.masses]
    for body, place in zip(bodies, plane.places, strict=True):
        body.position = place
    space.add(*bodies)
    for start, end, length, kind in plane.ties:
        body, at = (bodies[start], (0.0, 0.0)) if isinstance(start, int) else (None, start)
        limits = (0.0, length) if kind > 0 else (length, FAR)
        space.add(pymunk.SlideJoint(body or space.static_body, bodies[end], at, (0.0, 0.0), *limits))
    start, pace, weight = plane.walker or (0.0, 0.0, 0.0)
    time = 0.0

    def step(duration: float) -> None:
        nonlocal time
        if weight:
            knot, share = borne([body.position.x for body in bodies], start + pace * time)
            bodies[knot].apply_force_at_local_point((0.0, (share - 1.0) * weight))
            bodies[knot + 1].apply_force_at_local_point((0.0, -share * weight))
            time += duration
        space.step(duration)

    def place() -> Place:
        return tuple([part for body in bodies for part in body.position])

    places = in_frames(step, place, plane.frames, steps)
    return Outcome(places, plane.frames * steps * iterations * len(plane.ties))


def scene_of(name: str, frames: int, scale: float, make: Callable[[], Plane]) -> Scene:
    """Return the scene of a plane, which is made when it is first run.

    The truth is SciPy's, and ``differs`` compares it with our own run in short steps.
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

    models = [
        Model("direct net", run(by_net, DirectNet), STEPS[:6]),
        Model("smooth net, order 4", run(by_net, SmoothNet), STEPS[:4]),
        Model("smooth net in long steps", run(by_long_steps), (1, 2, 3, 4, 6)),
        Model("pymunk, slide joints", run(by_slide_joints, 10), STEPS, "pymunk"),
        Model("pymunk, slide joints, 3 iterations", run(by_slide_joints, 3), STEPS, "pymunk"),
    ]
    return Scene(name, frames, scale, lambda t: exact()[round(t * RATE) - 1], models, COUNTED, differs)


def bridge_ties() -> list[Tie]:
    """Return the cables of one side of the rope bridge, as they are seen from that side."""
    return [(start, end, length, 1) for start, end, length in cables()]


def settled(plane: Plane, wind: float = 0.0) -> Plane:
    """Return a plane whose knots are where they stay at rest, in a wind along X in m/s^2."""
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
    """A side of the bridge that hangs aside in a wind of 3 m/s^2, which stops: then 2 s of swing.

    All its cables stay taut. There is no damping.
    """

    def make() -> Plane:
        return settled(Plane(MASSES, hanging(), bridge_ties(), 120), wind=3.0)

    return scene_of("rope bridge swinging", 120, CABLE_LENGTH, make)


def walked_over() -> Scene:
    """A side of the bridge, over which half of a ball of 5 kg walks at 2 m/s, for 3.6 s.

    The weight of the ball is on the two rows beside it. All cables stay taut.
    """

    def make() -> Plane:
        walker = (-3.6, 2.0, 0.5 * 5.0 * 9.81)
        return settled(Plane([PLANK_MASS] * ROWS, hanging(), bridge_ties(), 216, walker))

    return scene_of("rope bridge walked over", 216, CABLE_LENGTH, make)


def catching() -> Scene:
    """A net of 6 by 6 cables between two poles, and a ball of 1 kg that falls in, for 0.6 s.

    Cables across have knots of 0.2 kg every 0.55 m in the top row, and every 0.59 m below it, so
    that they hang slack there. Cables of 0.45 m hang down from knot to knot. The ball falls 0.3 m,
    a bit beside the middle. It touches what comes within its radius of 0.5 m in the upper two rows.
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
            (gap * (column - 2.5), -gap * row - 0.05) for row in range(size) for column in range(size)
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

    return scene_of("net of 6 by 6 cables", 36, gap, make)


NETS: list[Callable[[], Scene]] = [swinging, walked_over, catching]
