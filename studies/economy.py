"""Measure how much optional features cost in a simulation of falling particles.

The scene consists of two hundred falling particles, which need none of these features. Each bar of
the chart is for one feature, such as a search for collisions. It shows the time per frame with the
feature, divided by the time per frame without it. The two times are measured one right after the
other.
"""

from __future__ import annotations

import argparse
import csv
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

from matplotlib import pyplot

from autograder.commands import find_engine
from autograder.manifest import ROOT
from autograder.text.wrapping import plain_console, print_wrapped
from plots.drawing import BLUE, GRAY
from scenes.reason import shown
from scenes.timing import Line, Measurement, measure, timer, versus

COUNT, ROUNDS, FRAME = 200, 41, 1.0 / 60.0
FRAMES = 20  # per measurement
Move = Callable[[], object]


def main(arguments: list[str]) -> int:
    """Measure the cost of optional features for falling particles, and draw it as a bar chart.

    The chart is saved as a PNG file, and a CSV file next to it contains the numbers. Return 0.
    """
    parser = argparse.ArgumentParser(prog="python -m studies economy", description=__doc__)
    parser.add_argument(
        "--out",
        type=Path,
        default=ROOT / "build" / "economy.png",
        help="the file for the picture; the numbers are written next to it",
    )
    options = parser.parse_args(arguments)
    sys.path[:0] = map(str, find_engine("solutions"))
    console = plain_console()
    lines = measure(
        [
            Measurement(what, versus(timer(with_it, FRAMES), timer(without, FRAMES)), ROUNDS)
            for what, with_it, without in parts()
        ]
    )
    console.print("Time per frame with a part / without it (quartiles):")
    for line in lines:
        told = f"{line.median:6.2f} ({line.low:.2f}-{line.high:.2f})  {line.what}"
        print_wrapped(console, told, hanging=21)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    draw(lines, options.out)
    with options.out.with_suffix(".csv").open("w", encoding="utf-8", newline="") as file:
        rows = [(line.what, line.median, line.low, line.high) for line in lines]
        csv.writer(file).writerows([("part", "ratio", "lower", "upper"), *rows])
    console.print(
        f"{shown(options.out)} and {shown(options.out.with_suffix('.csv'))}", soft_wrap=True
    )
    return 0


def draw(lines: list[Line], png: Path) -> None:
    """Draw the cost of each feature as a bar, with the most expensive feature on top.

    The cost is the time per frame with the feature divided by the time without it. Whiskers show
    the quartiles. A dashed line at 1 marks the cost of a feature that takes no extra time.
    """
    pyplot.switch_backend("agg")
    figure, axes = pyplot.subplots(figsize=(11, 5), layout="constrained")
    ordered = sorted(lines, key=lambda line: line.median)
    ratios = [line.median for line in ordered]
    around = [
        [line.median - line.low for line in ordered],
        [line.high - line.median for line in ordered],
    ]
    axes.barh([line.what for line in ordered], ratios, xerr=around, color=BLUE, capsize=3)
    for i, line in enumerate(ordered):  # beside the whisker, which would cross the number
        axes.text(1.05 * line.high, i, f"{line.median:.2f}", va="center")
    axes.axvline(1.0, color=GRAY, ls="--")
    axes.set(xscale="log", xlim=(0.9, 2.0 * max(ratios)))
    axes.set(xlabel="time per frame with it / without it (whiskers: quartiles; dashed: no cost)")
    axes.set_title("The cost of parts that a falling particle does not need")
    figure.savefig(png, dpi=110)
    pyplot.close(figure)


def parts() -> list[tuple[str, Move, Move]]:
    """List the optional features whose cost is measured, such as gravity as a force generator.

    Each feature is a tuple of its name and two functions. The first function simulates a frame with
    the feature, and the second one simulates the same frame without it.
    """
    # These modules import chapters.
    from ch02_vectors.vector import Vector3
    from ch05_forces.forces import ForceRegistry, Gravity
    from ch05_forces.particle import Particle
    from ch06_springs.integrators import explicit_euler, leapfrog, runge_kutta_4, velocity_verlet
    from ch07_constraints.detectors import GroundPlane, ParticlePairs
    from ch08_mass_aggregate.sleeping import SleepingWorld
    from ch08_mass_aggregate.world import ParticleWorld
    from studies.benchmarks.worlds import (
        DOWN,
        integrate,
        on_the_ground,
        stepping,
        stepping_bare,
    )

    def falling(acceleration: bool = True) -> list[Particle]:
        """Create two hundred falling particles, far from the ground and from each other.

        If ``acceleration`` is false, they have no acceleration of their own, and a force generator
        must supply gravity.
        """
        return [
            Particle(Vector3(10.0 * i, 1e7), acceleration=DOWN if acceleration else None)
            for i in range(COUNT)
        ]

    def bare() -> Move:
        return partial(integrate, falling())

    def by_generator(particles: list[Particle], gravity: Gravity) -> Move:
        def move() -> None:
            for particle in particles:
                gravity.update_force(particle, FRAME)
                particle.integrate(FRAME)

        return move

    def by_registry(particles: list[Particle], gravity: Gravity) -> Move:
        registry = ForceRegistry()
        for particle in particles:
            registry.add(particle, gravity)

        def move() -> None:
            registry.update_forces(FRAME)
            integrate(particles)

        return move

    def in_world(*detectors: Callable[[list[Particle]], object]) -> Move:
        particles = falling()
        world = ParticleWorld(particles, integrator=explicit_euler)
        world.contact_generators += [make(particles) for make in detectors]  # type: ignore[misc]
        return stepping(world)

    gravity = Gravity(DOWN)
    direct = by_generator(falling(acceleration=False), gravity)
    return [
        ("gravity as a force generator", direct, bare()),
        ("a registry for it", by_registry(falling(acceleration=False), gravity), direct),
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
    """Return a function that advances two hundred falling particles without using the engine.

    Each call simulates one frame with plain floats. ``dimensions`` is 2 or 3, so that the cost of
    the third dimension can be measured.
    """
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
