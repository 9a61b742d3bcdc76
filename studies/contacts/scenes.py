"""The stacks and ropes on which the contact solvers of chapter 7 are compared, and the results.

A model records an error after every frame, which would be 0 with an exact solution. The mass ratio
is that of the top sphere, or the weight at the end of a rope, to the other bodies.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from ch05_forces.particle import Particle
from ch07_constraints.contacts import ContactGenerator
from ch07_constraints.going_further.sequential_impulses import SequentialImpulses
from ch07_constraints.going_further.small_steps import SmallSteps
from ch07_constraints.links import Rod, TwoSidedRod
from ch08_mass_aggregate.world import ParticleWorld, mechanical_energy
from scenes import spheres
from scenes.chain import Chain
from scenes.clock import Move
from scenes.setup import Setup
from scenes.timing import significant
from studies.accuracy.measure import Point
from studies.accuracy.results import models_of, time_to
from studies.accuracy.scene import STEPS, Made, Scene, by_steps
from studies.models.direct_net import DirectNet
from studies.models.heap_resolver import HeapResolver
from studies.stored import store

FRAMES = 60
COUNT = 10  # spheres, or rods
ANGLE = math.radians(60.0)  # from which the rope swings
RATIOS = (1, 10, 100, 1000)
FILE = Path(__file__).with_name("figures.json")  # from which the lesson's picture is drawn
TOLERANCES = (1e-1, 1e-2, 1e-3)

BOOK, IMPULSES, COLD = "the book's resolver", "sequential impulses", "without warm starting"
SMALL, NET = "soft constraints", "direct net"
STACK, ROPE, SWING = "stack", "rope", "swing"

Measured = tuple[Setup, Callable[[float], float]]  # what measures the error takes the step in s


class ColdStart(SequentialImpulses):
    """Sequential impulses that start from zero in every step, rather than from the last step's."""

    def step(self, duration: float) -> None:
        self.impulses.clear()
        super().step(duration)


def by_book(particles: list[Particle], generators: Iterable[ContactGenerator]) -> Move:
    """Return the step of the book's contact resolver, with a heap, which saves time."""
    world = ParticleWorld(particles, generators)
    world.resolver = HeapResolver()
    return world.step


SOLVERS: dict[str, Callable[[Any, Any], Move]] = {
    BOOK: by_book,
    COLD: lambda particles, generators: ColdStart(particles, generators).step,
    IMPULSES: lambda particles, generators: SequentialImpulses(particles, generators).step,
    SMALL: lambda particles, generators: SmallSteps(particles, generators).step,
    NET: lambda _, links: DirectNet(links).step,
}


def stack(ratio: float) -> Measured:
    """Create a stack, whose error is the largest overlap, as a fraction of the diameter."""
    setup = spheres.stack(COUNT, ratio)
    return setup, lambda _: max(0.0, spheres.overlap(ball.position.y for ball in setup.particles))


def hung(ratio: float, angle: float) -> Chain:
    """Describe a straight rope of ten rods of 0.1 m with a weight at its end."""
    return Chain([1.0] * (COUNT - 1) + [ratio], 0.1, angle)


def rope(ratio: float, angle: float = 0.0, link: type[Rod] = TwoSidedRod) -> Measured:
    """Create a rope, at an angle in radians, whose error is the relative change in length."""
    chain = hung(ratio, angle)
    setup = chain.setup(link)
    length = COUNT * chain.length
    return setup, lambda _: abs(math.fsum(chain.excess(setup.particles))) / length


def swinging(link: type[Rod] = TwoSidedRod) -> Measured:
    """Create a rope, whose error is its change in energy over its largest kinetic energy."""
    setup = hung(1.0, ANGLE).setup(link)
    start = mechanical_energy(setup.particles)
    lowest = mechanical_energy(hung(1.0, 0.0).particles())

    def change(duration: float) -> float:
        # The velocity is the mean between two positions, so it is valid halfway between them.
        halfway = sum(
            0.5 * duration * particle.mass * particle.acceleration.dot(particle.velocity)
            for particle in setup.particles
        )
        return abs(mechanical_energy(setup.particles) + halfway - start) / (start - lowest)

    return setup, change


def solving(make: Callable[[], Measured], solver: str, duration: float) -> Made:
    """Return what simulates a stack or a rope with a contact solver, and measures the error."""
    setup, error = make()
    return SOLVERS[solver](setup.particles, setup.contacts), lambda: (error(duration),)


def scene_of(name: str, make: Callable[..., Measured], solvers: Sequence[str]) -> Scene:
    """Create a scene that compares contact solvers. SmallSteps works with one-sided links."""
    models = []
    for solver in solvers:
        one_sided = solver == SMALL and NET in solvers
        built = partial(make, link=Rod) if one_sided else make
        by = "the book" if solver == BOOK else "ours"
        made = partial(solving, built, solver)
        models.append(by_steps(solver, made, FRAMES, steps=STEPS[:8], by=by))
    return Scene(name, FRAMES, 1.0, lambda _: (0.0,), models, "steps")


def named(name: str, ratio: int) -> str:
    """Return a scene's name, such as "stack, ratio 10"."""
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


def within(points: Sequence[Point]) -> list[tuple[str, float, dict[str, float]]]:
    """Find the times in ms per frame of all solvers that meet each tolerance in each scene."""
    found = []
    for scene in dict.fromkeys(point.scene for point in points):
        models = models_of([point for point in points if point.scene == scene])
        for tolerance in TOLERANCES:
            times = {name: time_to(own, tolerance) for name, own in models.items()}
            ms = {name: significant(1e3 * time / FRAMES, 4) for name, time in times.items() if time}
            found.append((scene, tolerance, ms))
    return found


def keep(points: Sequence[Point], file: Path) -> None:
    """Write the date, the version of Python, all points and the table to a JSON file.

    A point is (scene, model, by, steps, error, ms per frame).
    """
    rows = [
        (p.scene, p.model, p.by, p.steps, significant(p.error), significant(1e3 * p.time / FRAMES))
        for p in points
    ]
    store(file, a_row_a_line, points=rows, within=within(points))


def a_row_a_line(found: Any) -> str:
    """Format figures as JSON."""
    return json.dumps(found).replace(": [[", ": [\n  [").replace("], [", "],\n  [")
