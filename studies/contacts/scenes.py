"""Define the stacks and ropes on which the contact solvers of chapter 7 are compared.

Each scene lasts 1 s and records an error, which would be 0 with an exact solver. The error is
measured after every frame, and the result is the largest error:

- For a stack, the error is the largest overlap of touching spheres, as a fraction of their
  diameter.
- For a rope at rest, it is the change in length, as a fraction of the length.
- For a swinging rope, it is the change in energy, as a fraction of the kinetic energy at the lowest
  point.

One body may be heavier than the others: the top sphere of a stack, or the weight at the end of a
rope. Every other body has a mass of 1 kg. The mass ratio is the mass of the heavy body divided by
1 kg. Gravity is 10 m/s^2. The work of a solver is its number of time steps.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import ContactGenerator
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.going_further.sequential_impulses import SequentialImpulses
from ch07_constraints.going_further.small_steps import SmallSteps
from ch07_constraints.links import Rod, TwoSidedRod
from ch08_mass_aggregate.world import ParticleWorld, mechanical_energy
from scenes.clock import RATE
from studies.accuracy.scene import STEPS, Model, Outcome, Place, Scene, in_frames
from studies.models.direct_net import DirectNet
from studies.models.heap_resolver import HeapResolver

FRAMES = 60
COUNT = 10  # spheres, or rods
RADIUS, LENGTH = 0.5, 0.1  # m, of a sphere and of a rod
ANGLE = math.radians(60.0)  # from which the rope swings
RATIOS = (1, 10, 100, 1000)
DOWN = Vector3(0.0, -10.0)

BOOK, IMPULSES, COLD = "the book's resolver", "sequential impulses", "without warm starting"
SMALL, NET = "soft constraints", "direct net"
STACK, ROPE, SWING = "stack", "rope", "swing"

Move = Callable[[float], object]


@dataclass(frozen=True)
class Bodies:
    """The particles and contacts of a stack or a rope, and a function that measures its error.

    ``error`` takes the duration of a time step in s, and returns the current error, which has no
    unit.
    """

    particles: list[Particle]
    generators: list[ContactGenerator]
    error: Callable[[float], float]


class ColdStart(SequentialImpulses):
    """A contact solver with sequential impulses but without warm starting, for comparison.

    Every time step starts with zero impulses rather than with the impulses of the previous step.
    """

    def step(self, duration: float) -> None:
        self.impulses.clear()
        super().step(duration)


def by_book(particles: list[Particle], generators: Iterable[ContactGenerator]) -> Move:
    """Return a function that simulates the particles with the book's contact resolver.

    To save time, a HeapResolver is used, which computes the same results.
    """
    world = ParticleWorld(particles, generators)
    world.resolver = HeapResolver()
    return world.step


SOLVERS: dict[str, Callable[[list[Particle], list[Any]], Move]] = {
    BOOK: by_book,
    COLD: lambda particles, generators: ColdStart(particles, generators).step,
    IMPULSES: lambda particles, generators: SequentialImpulses(particles, generators).step,
    SMALL: lambda particles, generators: SmallSteps(particles, generators).step,
    NET: lambda _, links: DirectNet(links).step,
}


def stack(ratio: float) -> Bodies:
    """Build a stack of ten spheres on the ground, each of which just touches the next.

    The top sphere has a mass of ``ratio`` kg, and the others have 1 kg. The error is the largest
    overlap of two spheres, or of a sphere and the ground.
    """
    spheres = [
        Particle(Vector3(0.0, (2 * i + 1) * RADIUS), acceleration=DOWN) for i in range(COUNT)
    ]
    spheres[-1].mass = ratio

    def overlap(_: float) -> float:
        heights = [-RADIUS, *(sphere.position.y for sphere in spheres)]
        return max(0.0, *(1.0 - (b - a) / (2.0 * RADIUS) for a, b in pairwise(heights)))

    ground, pairs = GroundPlane(spheres, radius=RADIUS), ParticlePairs(spheres, RADIUS)
    return Bodies(spheres, [ground, pairs], overlap)


def rope(ratio: float, angle: float = 0.0, two_sided: bool = True) -> Bodies:
    """Build a straight rope of ten rods that hangs from a fixed point.

    At its lower end is a weight of ``ratio`` kg. ``angle`` is the angle between the rope and the
    vertical, in radians. The error is the relative change in length.
    """
    along = Vector3(LENGTH * math.sin(angle), -LENGTH * math.cos(angle))
    joints = [Particle(along * i, acceleration=DOWN) for i in range(COUNT + 1)]
    joints[0].mass, joints[-1].mass = math.inf, ratio
    link = TwoSidedRod if two_sided else Rod
    rods: list[ContactGenerator] = [link(a, b, LENGTH) for a, b in pairwise(joints)]

    def stretch(_: float) -> float:
        lengths = [(b.position - a.position).magnitude() for a, b in pairwise(joints)]
        return abs(math.fsum(lengths) / (COUNT * LENGTH) - 1.0)

    return Bodies(joints, rods, stretch)


def swinging(two_sided: bool = True) -> Bodies:
    """Build a rope that starts at an angle and swings, with no extra weight at its end.

    The error is the change in mechanical energy, which an exact solver would conserve.
    """
    bodies = rope(1.0, ANGLE, two_sided)
    start = mechanical_energy(bodies.particles)
    lowest = mechanical_energy(rope(1.0).particles)

    def change(duration: float) -> float:
        # The velocity is the mean between two positions, so it is valid halfway between them.
        halfway = sum(
            0.5 * duration * particle.mass * particle.acceleration.dot(particle.velocity)
            for particle in bodies.particles[1:]
        )
        return abs(mechanical_energy(bodies.particles) + halfway - start) / (start - lowest)

    return Bodies(bodies.particles, bodies.generators, change)


def run(make: Callable[[], Bodies], solver: str, steps: int) -> Outcome:
    """Simulate a stack or a rope with one contact solver, and measure the error in each frame."""
    bodies, duration = make(), 1.0 / (RATE * steps)
    step = SOLVERS[solver](bodies.particles, bodies.generators)
    places = in_frames(step, lambda: (bodies.error(duration),), FRAMES, steps)
    return Outcome(places, FRAMES * steps)


def scene_of(name: str, make: Callable[..., Bodies], solvers: Sequence[str]) -> Scene:
    """Create a scene that compares several contact solvers on the same stack or rope.

    ``make`` builds the stack or the rope. The links of a rope are TwoSidedRods, except for
    SmallSteps, which works with ordinary ones.
    """
    models = []
    for solver in solvers:
        one_sided = solver == SMALL and NET in solvers
        built = partial(make, two_sided=False) if one_sided else make
        by = "the book" if solver == BOOK else "ours"
        models.append(Model(solver, partial(run, built, solver), STEPS[:8], by))
    return Scene(name, FRAMES, 1.0, exact, models, "steps")


def exact(_: float) -> Place:
    """Return 0 as the exact solution, because the recorded value is an error.

    A scene compares its recorded values with an exact solution. With an exact contact solver, the
    error would be 0 at any time.
    """
    return (0.0,)


def named(name: str, ratio: int) -> str:
    """Return a scene's name with its mass ratio, such as "stack, ratio 10"."""
    return f"{name}, ratio {ratio:,}"


def scenes() -> list[Scene]:
    """List all scenes on which contact solvers are compared, in the order of the table."""
    of_stacks = [BOOK, COLD, IMPULSES, SMALL]
    of_ropes = [BOOK, IMPULSES, SMALL, NET]
    return [
        *(scene_of(named(STACK, r), partial(stack, r), of_stacks) for r in RATIOS),
        *(scene_of(named(ROPE, r), partial(rope, r), of_ropes) for r in RATIOS),
        scene_of(f"{SWING}, stretch", partial(rope, 1.0, ANGLE), of_ropes),
        scene_of(f"{SWING}, energy", swinging, of_ropes),
    ]
