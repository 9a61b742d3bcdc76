"""Plots for chapter 5: terminal speeds, a fall with drag, an orbit, and the cost of generators."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial

from matplotlib import pyplot

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import particle as chapter_3
from ch05_forces import forces
from ch05_forces.closed_form import quadratic_fall, terminal_speed
from ch05_forces.particle import Particle
from plots.drawing import BLACK, BLUE, GRAY, GREEN, ORANGE, RED, SKY, THEORY, Picture, finish, slope
from scenes.clock import FRAME
from scenes.fall_in_air import G, falling
from scenes.orbit import KeplerOrbit
from scenes.readings import Numbers, cross, is_written, numbers
from scenes.setup import Setup, alone
from scenes.timing import Measurement, measure, timer, versus

MASS = 2.0
ECCENTRICITY = 0.5
TURNS = 20


def terminal_speeds() -> Picture:
    """Plot the speed of bodies that fall with linear or quadratic drag, and the terminal speed."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.6), layout="constrained")
    rows: list[Sequence[object]] = []
    worst = 0.0
    falls = ((1.0, 0.0), (3.0, 0.0), (0.0, 0.02), (0.0, 0.1), (1.0, 0.1))
    for (k1, k2), color in zip(falls, (BLUE, SKY, ORANGE, RED, BLACK), strict=True):
        minute = [speed for _, speed in _fall(MASS, k1, k2, FRAME, 3600)]
        speeds = minute[:601]
        times = [i * FRAME for i in range(len(speeds))]
        end = terminal_speed(MASS * G, k1, k2)
        left.plot(times, speeds, color=color, label=f"k1 = {k1:g}, k2 = {k2:g}")
        left.axhline(end, color=color, lw=1, ls=":")
        worst = max(worst, abs(minute[-1] / end - 1.0))
        rows += [("fall", k1, k2, MASS, *pair, end) for pair in zip(times, speeds, strict=True)]
    title = (
        "After a minute every fall is at its terminal speed (dotted),\n"
        f"with a relative error of at most {worst:.1g}"
    )
    finish(left, title, "time, s", "speed of a fall of 2 kg, m/s", 8)
    masses = [0.01 * 10.0 ** (i / 4.0) for i in range(17)]
    weights = [mass * G for mass in masses]
    slopes = []
    for k1, k2, color, mark in (
        (1.0, 0.0, BLUE, "o"),
        (0.0, 0.1, RED, "s"),
        (1.0, 0.1, BLACK, "^"),
    ):
        exact = [terminal_speed(weight, k1, k2) for weight in weights]
        # 600 frames, each a tenth of the time m / (k1 + k2 v) at the terminal speed v.
        found = [
            _fall(mass, k1, k2, 0.1 * mass / (k1 + k2 * end), 600)[-1][1]
            for mass, end in zip(masses, exact, strict=True)
        ]
        right.loglog(weights, exact, color=color, lw=1)
        label = f"k1 = {k1:g}, k2 = {k2:g}"
        right.loglog(weights, found, mark, color=color, ms=5, label=label)
        slopes.append(slope(masses, found))
        ends = zip(masses, found, exact, strict=True)
        rows += [("end", k1, k2, mass, 0.0, *pair) for mass, *pair in ends]
    title = (
        "The terminal speed grows as the weight to the power\n"
        f"{slopes[0]:.2f} with k1 alone and {slopes[1]:.2f} with k2 alone"
    )
    finish(right, title, "weight, N", "final speed, m/s (lines: formula)", 8)
    columns = ("part", "k1", "k2", "mass, kg", "time, s", "speed, m/s", "terminal speed, m/s")
    return Picture(figure, columns, rows)


def fall_with_drag() -> Picture:
    """Plot a fall with quadratic drag in long frames, and how its error shrinks with the frame."""
    k2, seconds, frame = 0.05, 4.0, 0.2
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.6), layout="constrained")
    parts = ((1, BLUE, "speed, m/s"), (0, ORANGE, "distance, m"))
    stepped = _fall(MASS, 0.0, k2, frame, round(seconds / frame))
    times = [i * frame for i in range(len(stepped))]
    fine = [i * seconds / 200.0 for i in range(201)]
    exact = [quadratic_fall(MASS, G, k2, time) for time in fine]
    for part, color, label in parts:
        left.plot(fine, [pair[1 - part] for pair in exact], color=color, label=label)
        words = f"{label}, in steps of {frame} s"
        left.plot(times, [pair[part] for pair in stepped], "o", color=color, ms=4, label=words)
    most = max(
        abs(distance - quadratic_fall(MASS, G, k2, time)[1])
        for (distance, _), time in zip(stepped, times, strict=True)
    )
    title = f"In steps of {frame} s the distance is off by up to {most:.2f} m"
    finish(left, title, "time, s", "fall of 2 kg with k2 = 0.05", 8)
    end_speed, end_distance = quadratic_fall(MASS, G, k2, seconds)
    rows = []
    for frames in (10, 20, 40, 80, 160, 320, 640, 1280):
        distance, speed = _fall(MASS, 0.0, k2, seconds / frames, frames)[-1]
        rows.append((seconds / frames, speed, end_speed, distance, end_distance))
    lengths = [row[0] for row in rows]
    orders = []
    for column, (_, color, label) in zip((1, 3), parts, strict=True):
        errors = [abs(row[column] - row[column + 1]) for row in rows]
        right.loglog(lengths, errors, "o-", color=color, ms=5, label=f"error of the {label}")
        orders.append(slope(lengths[3:], errors[3:]))
    right.loglog(lengths, lengths, **THEORY, label="first order: h")
    title = "Errors shrink as h to the power {:.3f} and {:.3f}".format(*orders)
    finish(right, title, "length of a frame h, s", f"error after {seconds:g} s", 8)
    columns = ("h, s", "speed, m/s", "exact speed, m/s", "distance, m", "exact distance, m")
    return Picture(figure, columns, rows)


def orbit() -> Picture:
    """Plot how a planet gains energy and angular momentum in 20 orbits, which it should not."""
    figure, panels = pyplot.subplots(1, 3, figsize=(14, 4.6), layout="constrained")
    path, *others = panels
    kepler = KeplerOrbit(ECCENTRICITY)
    rows = []
    gains, drifts = [], []
    for frames, color in ((5_000, BLUE), (10_000, ORANGE)):
        h = kepler.period / frames
        seen = _states(kepler.setup(from_farthest=True), h, frames * TURNS, frames // 40)
        turns = [i / 40.0 for i in range(len(seen))]
        energy = [0.5 * math.hypot(*v) ** 2 - 1.0 / math.hypot(*p) for p, v in seen]
        momentum = [cross(p, v)[2] for p, v in seen]
        path.plot([p[0] for p, _ in seen], [p[1] for p, _ in seen], color=color, lw=0.4)
        # A step adds h^2 (v x a) to the angular momentum, as r x a is 0. On an exact orbit, v x a
        # is L / r^3, where L is (1 - e^2)^(1/2), and the mean of 1 / r^3 is (1 - e^2)^(-3/2).
        drifts.append((_energy_drift(h), h * math.tau / (1.0 - ECCENTRICITY**2)))
        for axes, values, drift in zip(others, (energy, momentum), drifts[-1], strict=True):
            axes.plot(turns, values, color=color, lw=1.2, label=f"{frames} frames per turn")
            theory = [values[0] + drift * turn for turn in turns]
            axes.plot(turns, theory, color=color, lw=5, alpha=0.3)
        # Compare only the first turn, between farthest points, because the orbit changes later.
        gains.append([values[40] - values[0] for values in (energy, momentum)])
        rows += [(frames, *row) for row in zip(turns, energy, momentum, strict=True)]
    path.plot([0], [0], "o", color=BLACK, ms=6)
    title = f"{TURNS} turns around the attracting center"
    finish(path, title, "x, m", "y, m", aspect="equal")
    others[0].plot([], [], **THEORY, label="theory for the first turn")
    for axes, quantity, unit, gain, half, drift in zip(
        others, ("energy", "angular momentum"), ("J/kg", "m$^2$/s"), *gains, drifts[0], strict=True
    ):
        title = (
            f"The first turn adds {gain:.3g} {unit} (theory {drift:.3g}),\n"
            f"{half:.3g} with frames of half the length"
        )
        finish(axes, title, "turns", f"{quantity}, {unit}")
        axes.title.set_fontsize(10)
    others[0].legend(fontsize=8)
    columns = ("frames per turn", "turns", "energy, J/kg", "angular momentum, m^2/s")
    return Picture(figure, columns, rows)


def cost_of_a_generator() -> Picture:
    """Plot the computing time of each type of generator, relative to chapter 3's step."""
    down = Vector3(0.0, -G, 0.0)
    place, motion = Vector3(3.0, 1.0, 0.0), Vector3(0.0, 0.0, 5.0)
    brake = forces.Airbrake(0.5)
    brake.on = True
    generators: dict[str, forces.ForceGenerator] = {
        "Gravity": forces.Gravity(down),
        "Drag": forces.Drag(0.3, 0.05),
        "Uplift, inside": forces.Uplift(Vector3(), 1e9, Vector3(0.0, 20.0, 0.0)),
        "Airbrake, on": brake,
        "PointGravity": forces.PointGravity(Vector3(), G),
        "InverseSquareGravity": forces.InverseSquareGravity(Vector3(), 80.0),
    }
    moves = {"gravity as acceleration, chapter 5's step": Particle(place, motion, down).integrate}
    for name, generator in generators.items():
        particle = Particle(place, motion)
        if is_written(partial(generator.update_force, particle, FRAME)):
            registry = alone(particle, generator).registry()
            moves[f"{name}, via the registry"] = partial(_registered, registry, particle)
    base, *timers = (
        timer(partial(move, FRAME), 500)
        for move in (chapter_3.Particle(place, motion, down).integrate, *moves.values())
    )
    figures = zip(moves, timers, strict=True)
    lines = measure([Measurement(name, versus(timed, base), 21) for name, timed in figures])
    rows = [(line.what, line.median, line.low, line.high) for line in lines]
    figure, axes = pyplot.subplots(figsize=(9, 4.2), layout="constrained")
    names, ratios, *quartiles = zip(*rows, strict=True)
    spread = [[abs(r - end) for r, end in zip(ratios, ends, strict=True)] for ends in quartiles]
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


PLOTS = (terminal_speeds, fall_with_drag, orbit, cost_of_a_generator)


def _states(
    setup: Setup, frame: float, frames: int, every: int = 1
) -> list[tuple[Numbers, Numbers]]:
    """Simulate a body, and return its position and velocity at the start and ``every`` frames."""
    ((particle, generator),) = setup.forces
    states = []
    for i in range(frames + 1):
        if i:
            generator.update_force(particle, frame)
            particle.integrate(frame)
        if i % every == 0:
            states.append((numbers(particle.position), numbers(particle.velocity)))
    return states


def _fall(
    mass: float, k1: float, k2: float, frame: float, frames: int
) -> list[tuple[float, float]]:
    """Simulate a fall, and return the distance and the speed at the start and after each frame."""
    states = _states(falling([(mass, k1, k2)]), frame, frames)
    return [(0.0 - p[1], 0.0 - v[1]) for p, v in states]  # 0 is not to become -0


def _energy_drift(h: float) -> float:
    """Predict how much energy the book's integrator adds per orbit.

    A step adds (h^2 / 2) (a^2 + v . H v), where H is the Hessian of the potential -1 / r. On an
    exact orbit, the last factor is 1 / r^4 + (v^2 - 3 v_r^2) / r^3, which is integrated here.
    """
    p = 1.0 - ECCENTRICITY**2
    count = 2000
    total = 0.0
    for i in range(count):
        angle = math.tau * (i + 0.5) / count
        r = p / (1.0 + ECCENTRICITY * math.cos(angle))
        radial = ECCENTRICITY * math.sin(angle) / math.sqrt(p)
        square = radial**2 + p / r**2
        time = r * r / math.sqrt(p) * math.tau / count
        total += (1.0 / r**4 + (square - 3.0 * radial**2) / r**3) * time
    return h / 2.0 * total


def _registered(registry: forces.ForceRegistry, particle: Particle, duration: float) -> None:
    """Move a particle by one frame under the forces of a registry."""
    registry.update_forces(duration)
    particle.integrate(duration)
