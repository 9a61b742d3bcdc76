"""A plot of the computing time of each force generator in chapter 5."""

from __future__ import annotations

from functools import partial

from matplotlib import pyplot

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import particle as chapter_3
from ch05_forces.forces import (
    Airbrake,
    Drag,
    ForceGenerator,
    Gravity,
    InverseSquareGravity,
    PointGravity,
    Uplift,
)
from ch05_forces.particle import Particle
from plots.drawing import BLACK, BLUE, GRAY, GREEN, Picture
from scenes.clock import FRAME
from scenes.fall_in_air import G
from scenes.readings import is_written
from scenes.setup import alone
from scenes.timing import Measurement, Timer, measure, timer, versus
from scenes.track import Move

DOWN = Vector3(0.0, -G, 0.0)


def cost_of_a_generator() -> Picture:
    """Plot the computing time per frame for a particle with each type of force generator.

    Each time is divided by the time for chapter 3's particle, whose gravity is a constant
    acceleration.
    """
    place, motion = Vector3(3.0, 1.0, 0.0), Vector3(0.0, 0.0, 5.0)
    brake = Airbrake(0.5)
    brake.on = True
    generators: dict[str, ForceGenerator] = {
        "Gravity": Gravity(DOWN),
        "Drag": Drag(0.3, 0.05),
        "Uplift, inside": Uplift(Vector3(), 1e9, Vector3(0.0, 20.0, 0.0)),
        "Airbrake, on": brake,
        "PointGravity": PointGravity(Vector3(), G),
        "InverseSquareGravity": InverseSquareGravity(Vector3(), 80.0),
    }
    base = _frames(chapter_3.Particle(place, motion, DOWN).integrate)
    shown = {
        "gravity as acceleration, chapter 5's step": Particle(place, motion, DOWN).integrate,
    }
    for name, generator in generators.items():
        particle = Particle(place, motion)
        if is_written(partial(generator.update_force, particle, FRAME)):
            shown[f"{name}, via the registry"] = _registered(particle, generator)
    lines = measure(
        [Measurement(name, versus(_frames(frame), base), 21) for name, frame in shown.items()]
    )
    rows = [(line.what, line.median, line.low, line.high) for line in lines]
    figure, axes = pyplot.subplots(figsize=(9, 4.2), layout="constrained")
    names, ratios, lows, highs = zip(*rows, strict=True)
    spread = [
        [r - low for r, low in zip(ratios, lows, strict=True)],
        [high - r for r, high in zip(ratios, highs, strict=True)],
    ]
    colors = [GREEN if "acceleration" in name else BLUE for name in names]
    axes.barh(names, ratios, xerr=spread, color=colors, ecolor=GRAY)
    axes.invert_yaxis()
    axes.axvline(1.0, color=BLACK, lw=1)
    axes.set(xlabel="time per frame / time of chapter 3's step with gravity as acceleration")
    axes.grid(alpha=0.3, axis="x")
    if gravity := dict(zip(names, ratios, strict=True)).get("Gravity, via the registry"):
        axes.set_title(
            f"Gravity as a generator takes {gravity:.1f} times as long for the same path.\n"
            "Use it only if g varies with position or time"
        )
    return Picture(figure, ("what", "ratio", "lower quartile", "upper quartile"), rows)


def _frames(frame: Move) -> Timer:
    def run() -> None:
        for _ in range(500):
            frame(FRAME)

    return timer(run)


def _registered(particle: Particle, generator: ForceGenerator) -> Move:
    """Return a function that moves a particle by one frame under the force of a generator."""
    registry = alone(particle, generator).registry()

    def frame(duration: float) -> None:
        registry.update_forces(duration)
        particle.integrate(duration)

    return frame
