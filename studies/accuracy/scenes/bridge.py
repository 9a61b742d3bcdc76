"""Test how well our engine and pymunk keep the loaded rope bridge of chapter 8 at rest.

Every simulation starts slightly below the rest position, so that all cables are taut. Exactly at
the rest position, rounding errors would decide which cables are taut. The work of a simulation is
the number of contacts that it resolves. In pymunk, it is the number of joints times the number of
iterations.

Pymunk is two-dimensional, so both sides of its bridge lie in one plane, with no rods between them.
The length of each cable is that of its projection onto this plane. Only the x and y coordinates of
the positions are compared.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, explicit_euler, semi_implicit_euler
from ch07_constraints.contacts import ContactGenerator, ContactResolver
from ch07_constraints.links import AnchoredCable, Cable, Rod, TwoSidedRod
from ch08_mass_aggregate.bridge import ITERATIONS, links_of
from ch08_mass_aggregate.bridge_plan import (
    CABLE_LENGTH,
    DAMPING,
    GRAVITY,
    Row,
    make_rows,
)
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld
from studies.accuracy.in_pymunk import BEST, EXAMPLES, at_best, reading
from studies.accuracy.scene import STEPS, Model, Outcome, Place, Scene, in_frames
from studies.accuracy.scenes.hanging import HAIR, MASSES, cables, hanging, truth
from studies.models.direct_net import DirectNet
from studies.models.equilibrium import equilibrium
from studies.models.heap_resolver import HeapResolver

FRAMES = 60  # errors do not grow after this second
LONG = 600  # frames of sleep

Links = Callable[[list[Row]], list[ContactGenerator]]


def bridge() -> Scene:
    """Create the scene of a rope bridge that is at rest for 1 s, with 5 kg on its third plank.

    Errors are fractions of the length of a cable between two planks. In pymunk, slide joints act as
    the cables. The solver makes either 10 iterations per step, its default, or 50.
    """
    few, some = STEPS[:5], STEPS[:8]

    def ours(links: Links, iterations: int | None) -> Callable[[int], Outcome]:
        return partial(by_world, semi_implicit_euler, links, HeapResolver(iterations))

    models = [
        Model(
            "explicit Euler, cables",
            partial(by_world, explicit_euler, links_of, ContactResolver()),
            few,
            "the book",
        ),
        Model("semi-implicit Euler, cables", ours(links_of, None), few),
        Model(f"cables, {ITERATIONS} iterations", ours(links_of, ITERATIONS), few),
        Model("semi-implicit Euler, two-sided rods", ours(two_sided, None), few),
        Model("two-sided rods, 400 iterations", ours(two_sided, 400), few),
        Model("direct net", partial(by_net, whole), few),
        Model("direct net, seen from the side", partial(by_net, from_the_side), few),
        Model(EXAMPLES, partial(by_joints, 10), some, "pymunk"),
        Model("pymunk, 50 iterations", partial(by_joints, 50), some, "pymunk"),
        *(
            Model(at_best(number), partial(by_joints, number, is_best=True), some, "pymunk")
            for number in (3, 10, 50)
        ),
    ]
    return Scene("rope bridge at rest", FRAMES, CABLE_LENGTH, truth, models, "contacts resolved")


def sleeping() -> Scene:
    """Create the scene of a rope bridge that sleeps for 10 s, in our engine and in pymunk."""
    models = [
        Model("asleep", by_sleep, (1,), is_formula=True),
        Model("found by equilibrium, then asleep", by_equilibrium, (1,), is_formula=True),
        Model(BEST, partial(by_joints, 10, frames=LONG, sleeps=True), (1,), "pymunk"),
    ]
    return Scene("rope bridge asleep", LONG, CABLE_LENGTH, truth, models, "contacts resolved")


def two_sided(rows: list[Row]) -> list[ContactGenerator]:
    """Create two-sided rods that replace the cables and rods of the rope bridge.

    A two-sided rod can both push and pull, while a cable can only pull. This makes no difference as
    long as all cables are taut.
    """
    found: list[ContactGenerator] = []
    for link in links_of(rows):
        if isinstance(link, AnchoredCable):
            anchor = Particle(link.anchor, mass=math.inf)
            found.append(TwoSidedRod(anchor, link.particle, link.max_length))
        elif isinstance(link, Cable):
            found.append(TwoSidedRod(link.a, link.b, link.max_length))
        elif isinstance(link, Rod):
            found.append(TwoSidedRod(link.a, link.b, link.length))
    return found


def by_world(
    integrator: Integrator, links: Links, resolver: ContactResolver, steps: int
) -> Outcome:
    """Simulate the rope bridge as a ParticleWorld, which treats cables and rods as contacts.

    ``links`` is a function that creates the cables and rods. After each step, ``resolver`` resolves
    their contacts. The particles have the same damping as in chapter 8.
    """
    ends, _, held = hung(links)
    world, work = ParticleWorld(ends, held, integrator=integrator), 0
    world.resolver = resolver

    def step(duration: float) -> None:
        nonlocal work
        resolver.iterations_used = 0  # the resolver is not called without contacts
        world.step(duration)
        work += resolver.iterations_used

    return Outcome(in_frames(step, partial(place_of, ends), FRAMES, steps), work)


def hung(links: Links) -> tuple[list[Particle], list[Row], list[ContactGenerator]]:
    """Build the rope bridge slightly below its rest position, so that all cables are taut.

    Return lists of the planks' ends, first those of one side, of the planks as pairs of ends, and
    of the cables and rods.
    """
    rows = make_rows()
    held = links(rows)  # the links get their lengths from the positions before the shift
    for row, (x, y), mass in zip(rows, hanging(HAIR), MASSES, strict=True):
        for end in row:
            end.position.x, end.position.y, end.mass = x, y, mass
    return [end for side in zip(*rows, strict=True) for end in side], rows, held


def whole() -> tuple[list[Particle], list[Any]]:
    """Build chapter 8's rope bridge, and return the planks' ends and its cables and rods."""
    ends, _, held = hung(links_of)
    return ends, held


def from_the_side() -> tuple[list[Particle], list[Any]]:
    """Build the same flat rope bridge as in pymunk, but from our particles and cables.

    The ends of all planks lie in the plane z = 0, without rods. Return the ends and the cables.
    """
    ends, rows, _ = hung(links_of)
    links: list[Any] = []
    for side in zip(*rows, strict=True):
        for end in side:
            end.position.z = 0.0
        for start, end, length in cables():
            if isinstance(start, int):
                links.append(Cable(side[start], side[end], length))
            else:
                links.append(AnchoredCable(side[end], Vector3(*start), length))
    return ends, links


def by_net(make: Callable[[], tuple[list[Particle], list[Any]]], steps: int) -> Outcome:
    """Simulate the rope bridge with DirectNet, which computes all tensions at once.

    ``make`` builds the bridge. Since the bridge is at rest, the tensions stay the same, and
    DirectNet can reuse its solution in later steps.
    """
    ends, links = make()
    places = in_frames(DirectNet(links).step, partial(place_of, ends), FRAMES, steps)
    return Outcome(places, FRAMES * steps * len(links))


def by_equilibrium(steps: int) -> Outcome:
    """Compute the rest position of the rope bridge directly instead of simulating it.

    The bridge then sleeps without any computation, so the work is the number of cables and rods.
    """
    ends, links = whole()
    world = SleepingWorld(ends, links)
    equilibrium(world)
    place = kept_while(lambda: ends[0] in world.asleep, partial(place_of, ends))
    return Outcome(in_frames(world.step, place, LONG, steps), len(links))


def by_sleep(steps: int) -> Outcome:
    """Simulate the rope bridge for 10 s with all of its planks asleep from the start."""
    ends, links = whole()
    world = SleepingWorld(ends, links, sleep_frames=1)
    world.fall_asleep(world.contacts())
    place = kept_while(lambda: ends[0] in world.asleep, partial(place_of, ends))
    return Outcome(in_frames(world.step, place, LONG, steps), 0)


def kept_while(sleeps: Callable[[], bool], place: Callable[[], Place]) -> Callable[[], Place]:
    """Return a function that reads the positions of sleeping bodies only once."""
    kept: Place = ()

    def read() -> Place:
        nonlocal kept
        if not (kept and sleeps()):
            kept = place()
        return kept

    return read


def place_of(ends: list[Particle]) -> Place:
    """List the x and y coordinates of the planks' ends, as seen from the side of the bridge."""
    return tuple([part for end in ends for part in (end.position.x, end.position.y)])


def by_joints(
    iterations: int,
    steps: int,
    frames: int = FRAMES,
    *,
    sleeps: bool = False,
    is_best: bool = False,
) -> Outcome:
    """Simulate the rope bridge with pymunk, where slide joints act as the cables.

    Pymunk's solver makes ``iterations`` iterations per step. If ``sleeps`` is true, the bridge
    falls asleep after the first step.
    """
    import pymunk

    space = pymunk.Space()
    space.gravity, space.damping, space.iterations = (0.0, GRAVITY.y), DAMPING, iterations
    still = space.static_body
    sides = [[pymunk.Body(mass, math.inf) for mass in MASSES] for _ in range(2)]
    for side in sides:
        for body, (x, y) in zip(side, hanging(HAIR), strict=True):
            body.position = x, y
        space.add(*side)
        for start, end, length in cables():
            body, at = (side[start], (0.0, 0.0)) if isinstance(start, int) else (still, start)
            joint = pymunk.SlideJoint(body, side[end], at, (0.0, 0.0), 0.0, length)
            if is_best:
                joint.error_bias = 0.0
            space.add(joint)
    ends = [end for side in sides for end in side]
    place = reading(space, ends)
    if sleeps:
        space.sleep_time_threshold = 1e-3  # s: after the first step

        def in_turn() -> Place:
            return tuple([part for end in ends for part in end.position])

        place = kept_while(lambda: ends[0].is_sleeping, in_turn)
    work = 0 if sleeps else frames * steps * iterations * len(space.constraints)
    places = in_frames(space.step, place, frames, steps)
    for body in ends if sleeps else ():
        body.activate()  # pymunk 7.3 crashes when it deletes bodies that sleep
    return Outcome(places, work)


BRIDGES: list[Callable[[], Scene]] = [bridge, sleeping]
