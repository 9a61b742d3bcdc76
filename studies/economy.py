"""Measure how much features cost that a scene does not need.

The scene consists of two hundred falling particles. Each line of the table is for one feature, such
as a search for collisions. It shows the time per frame with the feature, divided by the time per
frame without it. The two times are measured one right after the other, in the engine of solutions/.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from functools import partial

from autograder.commands import find_engine
from autograder.text.wrapping import plain_console, print_wrapped
from scenes.clock import FRAME
from scenes.timing import Measurement, measure, timer, versus
from studies.bench import told

COUNT, ROUNDS = 200, 41
FRAMES = 20  # per measurement
Move = Callable[[], object]


def main(arguments: list[str]) -> int:
    """Measure the cost of features that falling particles do not need, and print it. Return 0."""
    argparse.ArgumentParser(prog="python -m studies economy", description=__doc__).parse_args(
        arguments
    )
    sys.path[:0] = map(str, find_engine("solutions"))
    console = plain_console()
    lines = measure(
        [
            Measurement(what, versus(timer(with_it, FRAMES), timer(without, FRAMES)), ROUNDS)
            for what, with_it, without in parts()
        ]
    )
    console.print("Time per frame with a feature / without it (quartiles):")
    for line in sorted(lines, key=lambda line: -line.median):
        print_wrapped(console, f"{told(line):24} {line.what}", hanging=25)
    return 0


def parts() -> list[tuple[str, Move, Move]]:
    """List the optional features: a name, a frame with the feature, and the same one without it."""
    # These modules import chapters.
    from ch02_vectors.vector import Vector3
    from ch05_forces.forces import Gravity
    from ch05_forces.particle import Particle
    from ch06_springs.integrators import explicit_euler, leapfrog, runge_kutta_4, velocity_verlet
    from ch07_constraints.detectors import GroundPlane, ParticlePairs
    from ch08_mass_aggregate.sleeping import SleepingWorld
    from ch08_mass_aggregate.world import ParticleWorld
    from scenes.setup import Setup
    from studies.benchmarks.worlds import DOWN, integrate, on_the_ground, stepping, stepping_bare

    def falling(has_gravity: bool = True) -> list[Particle]:
        """Create particles far from the ground and each other, with or without gravity."""
        return [
            Particle(Vector3(10.0 * i, 1e7), acceleration=DOWN if has_gravity else None)
            for i in range(COUNT)
        ]

    def bare() -> Move:
        return partial(integrate, falling())

    def direct() -> None:
        for particle in pulled:
            gravity.update_force(particle, FRAME)
            particle.integrate(FRAME)

    def by_registry() -> None:
        registry.update_forces(FRAME)
        integrate(registered)

    def in_world(*detectors: Callable[[list[Particle]], object]) -> Move:
        particles = falling()
        world = ParticleWorld(particles, integrator=explicit_euler)
        world.contact_generators += [make(particles) for make in detectors]  # type: ignore[misc]
        return stepping(world)

    gravity, pulled, registered = Gravity(DOWN), falling(False), falling(False)
    registry = Setup(registered, [(particle, gravity) for particle in registered]).registry()
    return [
        ("gravity as a force generator", direct, bare()),
        ("a registry for it", by_registry, direct),
        ("a world around the particles", in_world(), bare()),
        ("a search for the ground, which is far below", in_world(GroundPlane), in_world()),
        (
            "a search for pairs, with none close together",
            in_world(lambda particles: ParticlePairs(particles, 0.5)),
            in_world(),
        ),
        (
            "four evaluations per step where one is accurate enough",
            stepping_bare(runge_kutta_4, falling()),
            bare(),
        ),
        (
            "two evaluations (Verlet) where one is as accurate (leapfrog)",
            stepping_bare(velocity_verlet, falling()),
            stepping_bare(leapfrog, falling()),
        ),
        ("a third dimension, in plain numbers", plain(3), plain(2)),
        (
            "keeping all balls awake, with nine in ten at rest",
            stepping(on_the_ground(ParticleWorld)),
            stepping(on_the_ground(SleepingWorld)),
        ),
    ]


def plain(dimensions: int) -> Move:
    """Return a function that simulates a frame in two or three dimensions, in plain floats."""
    x, y, z, vx, vy, vz = ([1.0] * COUNT for _ in range(6))

    def two() -> None:
        for i in range(COUNT):
            x[i] += vx[i] * FRAME
            y[i] += vy[i] * FRAME
            vy[i] -= 9.81 * FRAME

    def three() -> None:
        for i in range(COUNT):
            x[i] += vx[i] * FRAME
            y[i] += vy[i] * FRAME
            z[i] += vz[i] * FRAME
            vy[i] -= 9.81 * FRAME

    return {2: two, 3: three}[dimensions]
