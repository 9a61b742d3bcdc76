"""Test how well our engine and pymunk keep the loaded rope bridge of chapter 8 at rest.

Every simulation starts slightly too low, because at rest rounding errors would decide which cables
are taut. The work is the number of contacts resolved, or of pymunk's joints times its iterations.
Pymunk is two-dimensional, so its bridge is flat: no rods, and cables as long as their projections.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, explicit_euler, semi_implicit_euler
from ch07_constraints.contacts import ContactGenerator, ContactResolver
from ch07_constraints.links import AnchoredCable, Cable, TwoSidedRod
from ch08_mass_aggregate.bridge import ITERATIONS, links_of
from ch08_mass_aggregate.bridge_plan import CABLE_LENGTH, ROWS, Row, make_rows
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld
from scenes.setup import Setup
from scenes.twin import InSpace, twin_of
from studies.accuracy.asleep import asleep, asleep_in_pymunk, put_to_sleep
from studies.accuracy.in_pymunk import EXAMPLES, at_best, by_pymunk
from studies.accuracy.measured.planes import by_net
from studies.accuracy.scene import STEPS, Model, Outcome, Place, Scene, in_frames, places_of
from studies.models.direct_net import DirectNet
from studies.models.equilibrium import equilibrium
from studies.models.hanging_bridge import MASSES, cables, hanging
from studies.models.heap_resolver import HeapResolver
from studies.models.net import limits_of

FRAMES = 60  # errors do not grow after this second
HAIR = 1e-8  # m; lowers the ends by 3e-8 m, so smaller errors have no meaning

Links = Callable[[list[Row]], list[ContactGenerator]]


def bridge() -> Scene:
    """Create the scene of a rope bridge that is at rest for 1 s, with 5 kg on its third plank."""
    few, some = STEPS[:5], STEPS[:8]
    ours: dict[str, tuple[Links, int | None]] = {
        "semi-implicit Euler, cables": (links_of, None),
        f"cables, {ITERATIONS} iterations": (links_of, ITERATIONS),
        "semi-implicit Euler, two-sided rods": (two_sided, None),
        "two-sided rods, 400 iterations": (two_sided, 400),
    }
    book = partial(by_world, explicit_euler, links_of, ContactResolver())
    nets = {"direct net": whole, "direct net, seen from the side": from_the_side}
    models = [
        Model("explicit Euler, cables", book, few, "the book"),
        *(
            Model(name, partial(by_world, semi_implicit_euler, links, HeapResolver(most)), few)
            for name, (links, most) in ours.items()
        ),
        *(Model(name, partial(by_net, net, DirectNet, FRAMES), few) for name, net in nets.items()),
        asleep(partial(put_to_sleep, whole), FRAMES),
        asleep(found_by_equilibrium, FRAMES, "found by equilibrium, then asleep"),
        by_pymunk(EXAMPLES, partial(in_space, 10), FRAMES, some),
        by_pymunk("pymunk, 50 iterations", partial(in_space, 50), FRAMES, some),
        *(
            by_pymunk(at_best(number), partial(in_space, number, corrects=True), FRAMES, some)
            for number in (3, 10, 50)
        ),
        asleep_in_pymunk(partial(in_space, 1), FRAMES),
    ]
    return Scene("rope bridge at rest", FRAMES, CABLE_LENGTH, truth, models, "contacts resolved")


def truth(_: float) -> Place:
    """Return the exact positions of all ends, seen from the side. They do not depend on time."""
    return tuple(part for place in hanging() for part in place) * 2


def two_sided(rows: list[Row]) -> list[ContactGenerator]:
    """Create two-sided rods, which can also push, in place of the bridge's cables and rods."""
    found: list[ContactGenerator] = []
    for a, b, length, _ in (limit for link in links_of(rows) for limit in limits_of(link)):
        ends = (a, b) if isinstance(b, Particle) else (Particle(b, mass=math.inf), a)
        found.append(TwoSidedRod(*ends, length))
    return found


def whole(links: Links = links_of) -> Setup:
    """Build the bridge with all cables taut. The ends of the planks on one side come first."""
    rows = make_rows()
    held = links(rows)  # the links get their lengths from the positions before the shift
    for row, (x, y), mass in zip(rows, hanging(HAIR), MASSES, strict=True):
        for end in row:
            end.position.x, end.position.y, end.mass = x, y, mass
    return Setup([end for side in zip(*rows, strict=True) for end in side], contacts=held)


def from_the_side() -> Setup:
    """Build a flat rope bridge, with the ends of all planks in the plane z = 0, without rods."""
    ends = whole().particles
    links: list[ContactGenerator] = []
    for side in (ends[:ROWS], ends[ROWS:]):
        for particle in side:
            particle.position.z = 0.0
        for start, end, length in cables():
            if isinstance(start, int):
                links.append(Cable(side[start], side[end], length))
            else:
                links.append(AnchoredCable(side[end], Vector3(*start), length))
    return Setup(ends, contacts=links)


def by_world(
    integrator: Integrator, links: Links, resolver: ContactResolver, steps: int
) -> Outcome:
    """Simulate the rope bridge as a ParticleWorld, which treats cables and rods as contacts."""
    setup = whole(links)
    world, work = ParticleWorld(setup.particles, setup.contacts, integrator=integrator), 0
    world.resolver = resolver

    def step(duration: float) -> None:
        nonlocal work
        resolver.iterations_used = 0  # the resolver is not called without contacts
        world.step(duration)
        work += resolver.iterations_used

    return Outcome(in_frames(step, partial(places_of, setup.particles), FRAMES, steps), work)


def found_by_equilibrium() -> tuple[SleepingWorld, Sequence[Particle]]:
    """Compute where the rope bridge rests instead of simulating it. Its planks then sleep."""
    setup = whole()
    world = SleepingWorld(setup.particles, setup.contacts)
    equilibrium(world)
    return world, setup.particles


def in_space(iterations: int, _: float = 0.0, *, corrects: bool = False) -> InSpace:
    """Create the flat bridge in pymunk, whose solver makes ``iterations`` iterations per step."""
    return twin_of(from_the_side(), iterations=iterations, corrects=corrects)


BRIDGES: list[Callable[[], Scene]] = [bridge]
