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
from scenes.twin import InSpace
from studies.accuracy.asleep import asleep, asleep_in_pymunk
from studies.accuracy.in_pymunk import EXAMPLES, at_best, by_pymunk
from studies.accuracy.scene import STEPS, Model, Outcome, Scene, in_frames, places_of
from studies.accuracy.scenes.hanging import HAIR, MASSES, cables, hanging, truth
from studies.models.direct_net import DirectNet
from studies.models.equilibrium import equilibrium
from studies.models.heap_resolver import HeapResolver

FRAMES = 60  # errors do not grow after this second

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
        asleep(sleeping, FRAMES),
        asleep(found_by_equilibrium, FRAMES, "found by equilibrium, then asleep"),
        by_pymunk(EXAMPLES, partial(in_space, 10), FRAMES, some),
        by_pymunk("pymunk, 50 iterations", partial(in_space, 50), FRAMES, some),
        *(
            by_pymunk(at_best(number), partial(in_space, number, is_best=True), FRAMES, some)
            for number in (3, 10, 50)
        ),
        asleep_in_pymunk(partial(in_space, 1, 0.0), FRAMES),
    ]
    return Scene("rope bridge at rest", FRAMES, CABLE_LENGTH, truth, models, "contacts resolved")


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

    return Outcome(in_frames(step, partial(places_of, ends), FRAMES, steps), work)


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
    places = in_frames(DirectNet(links).step, partial(places_of, ends), FRAMES, steps)
    return Outcome(places, FRAMES * steps * len(links))


def sleeping() -> tuple[SleepingWorld, list[Particle]]:
    """Build the rope bridge with all of its planks asleep.

    Return the world and the planks' ends.
    """
    ends, links = whole()
    world = SleepingWorld(ends, links, sleep_frames=1)
    world.fall_asleep(world.contacts())
    return world, ends


def found_by_equilibrium() -> tuple[SleepingWorld, list[Particle]]:
    """Compute where the rope bridge rests instead of simulating it. Its planks then sleep."""
    ends, links = whole()
    world = SleepingWorld(ends, links)
    equilibrium(world)
    return world, ends


def in_space(iterations: int, _: float, *, is_best: bool = False) -> InSpace:
    """Create the rope bridge in pymunk, where slide joints act as the cables.

    Pymunk's solver makes ``iterations`` iterations per step. With ``is_best``, the joints correct
    their whole error in each step.
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
    return space, [end for side in sides for end in side]


BRIDGES: list[Callable[[], Scene]] = [bridge]
