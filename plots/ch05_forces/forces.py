"""Plots for chapter 5: terminal speeds, a fall with drag, and an orbit that drifts.

The title of each plot reports a measured result, such as the largest error, which reveals bugs in
the student's engine. For the computing time of each force generator, see cost.py.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from matplotlib import pyplot

from ch02_vectors.vector import Vector3
from ch05_forces.closed_form import quadratic_fall, terminal_speed
from ch05_forces.forces import Drag, InverseSquareGravity
from ch05_forces.particle import Particle
from plots.drawing import BLACK, BLUE, GRAY, ORANGE, RED, SKY, Picture, slope
from scenes.readings import Numbers, cross, numbers

FRAME = 1.0 / 60.0
MASS = 2.0
G = 9.81
DOWN = (0.0, -G, 0.0)

# The planet's smallest distance is half of its semi-major axis, and its period is 2 pi s.
ECCENTRICITY = 0.5
TURNS = 20
PERIOD = 2.0 * math.pi


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
    left.set(xlabel="time, s", ylabel="speed of a fall of 2 kg, m/s")
    left.grid(alpha=0.3)
    left.legend(fontsize=8)
    left.set_title(
        "After a minute every fall is at its terminal speed (dotted),\n"
        f"with a relative error of at most {worst:.1g}"
    )
    masses = [0.01 * 10.0 ** (i / 4.0) for i in range(17)]
    slopes = []
    for (k1, k2), color, mark in (
        ((1.0, 0.0), BLUE, "o"),
        ((0.0, 0.1), RED, "s"),
        ((1.0, 0.1), BLACK, "^"),
    ):
        exact = [terminal_speed(mass * G, k1, k2) for mass in masses]
        label = f"k1 = {k1:g}, k2 = {k2:g}"
        right.loglog([m * G for m in masses], exact, color=color, lw=1)
        # 600 frames, each a tenth of the time m / (k1 + k2 v) at the terminal speed v.
        found = [
            _fall(mass, k1, k2, 0.1 * mass / (k1 + k2 * end), 600)[-1][1]
            for mass, end in zip(masses, exact, strict=True)
        ]
        right.loglog([m * G for m in masses], found, mark, color=color, ms=5, label=label)
        slopes.append(slope(masses, found))
        rows += [
            ("end", k1, k2, mass, 0.0, *pair)
            for mass, pair in zip(masses, zip(found, exact, strict=True), strict=True)
        ]
    right.set(xlabel="weight, N", ylabel="final speed, m/s (lines: formula)")
    right.grid(alpha=0.3, which="both")
    right.legend(fontsize=8)
    right.set_title(
        "The terminal speed grows as the weight to the power\n"
        f"{slopes[0]:.2f} with k1 alone and {slopes[1]:.2f} with k2 alone"
    )
    columns = ("part", "k1", "k2", "mass, kg", "time, s", "speed, m/s", "terminal speed, m/s")
    return Picture(figure, columns, rows)


def fall_with_drag() -> Picture:
    """Plot a fall with quadratic drag, as simulated in long frames and as computed exactly.

    A second panel shows how the error shrinks with the frame length.
    """
    k2, seconds, frame = 0.05, 4.0, 0.2
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.6), layout="constrained")
    count = round(seconds / frame)
    stepped = _fall(MASS, 0.0, k2, frame, count)
    times = [i * frame for i in range(count + 1)]
    fine = [i * seconds / 200.0 for i in range(201)]
    exact = [quadratic_fall(MASS, G, k2, time) for time in fine]
    for part, color, label in ((1, BLUE, "speed, m/s"), (0, ORANGE, "distance, m")):
        left.plot(fine, [pair[1 - part] for pair in exact], color=color, label=label)
        words = f"{label}, in steps of {frame} s"
        left.plot(times, [pair[part] for pair in stepped], "o", color=color, ms=4, label=words)
    left.set(xlabel="time, s", ylabel="fall of 2 kg with k2 = 0.05")
    left.grid(alpha=0.3)
    left.legend(fontsize=8)
    ends = quadratic_fall(MASS, G, k2, seconds)
    rows, lengths = [], []
    errors: tuple[list[float], list[float]] = ([], [])
    for frames in (10, 20, 40, 80, 160, 320, 640, 1280):
        distance, speed = _fall(MASS, 0.0, k2, seconds / frames, frames)[-1]
        lengths.append(seconds / frames)
        errors[0].append(abs(speed - ends[0]))
        errors[1].append(abs(distance - ends[1]))
        rows.append((seconds / frames, speed, ends[0], distance, ends[1]))
    for found, color, label in zip(
        errors, (BLUE, ORANGE), ("speed, m/s", "distance, m"), strict=True
    ):
        right.loglog(lengths, found, "o-", color=color, ms=5, label=f"error of the {label}")
    right.loglog(lengths, lengths, color=GRAY, lw=5, alpha=0.4, label="first order: h")
    right.set(xlabel="length of a frame h, s", ylabel=f"error after {seconds:g} s")
    right.grid(alpha=0.3, which="both")
    right.legend(fontsize=8)
    orders = [slope(lengths[3:], found[3:]) for found in errors]
    right.set_title("Errors shrink as h to the power {:.3f} and {:.3f}".format(*orders))
    most = max(
        abs(a[0] - quadratic_fall(MASS, G, k2, t)[1]) for a, t in zip(stepped, times, strict=True)
    )
    left.set_title(f"In steps of {frame} s the distance is off by up to {most:.2f} m")
    columns = ("h, s", "speed, m/s", "exact speed, m/s", "distance, m", "exact distance, m")
    return Picture(figure, columns, rows)


def orbit() -> Picture:
    """Plot how a planet gains energy and angular momentum in 20 orbits.

    The orbits are simulated by the book's integrator. An exact orbit would gain neither.
    """
    figure, (path, energies, momenta) = pyplot.subplots(
        1, 3, figsize=(14, 4.6), layout="constrained"
    )
    rows = []
    words = []
    for frames, color in ((5_000, BLUE), (10_000, ORANGE)):
        h = PERIOD / frames
        seen = _orbit(h, frames * TURNS, frames // 40)
        turns = [i / 40.0 for i in range(len(seen))]
        energy = [0.5 * math.hypot(*v) ** 2 - 1.0 / math.hypot(*p) for p, v in seen]
        momentum = [cross(p, v)[2] for p, v in seen]
        label = f"{frames} frames per turn"
        path.plot([p[0] for p, _ in seen], [p[1] for p, _ in seen], color=color, lw=0.4)
        drifts = (_energy_drift(h), _momentum_drift(h))
        for axes, values, drift in ((energies, energy, drifts[0]), (momenta, momentum, drifts[1])):
            axes.plot(turns, values, color=color, lw=1.2, label=label)
            theory = [values[0] + drift * turn for turn in turns]
            axes.plot(turns, theory, color=color, lw=5, alpha=0.3)
        # Compare only the first turn, between farthest points, because the orbit changes later.
        words.append(([values[40] - values[0] for values in (energy, momentum)], drifts))
        rows += [(frames, *row) for row in zip(turns, energy, momentum, strict=True)]
    path.plot([0], [0], "o", color=BLACK, ms=6)
    path.set(xlabel="x, m", ylabel="y, m", aspect="equal")
    path.set_title(f"{TURNS} turns around the attracting center")
    (found, drifts), (half, _) = words
    energies.set(xlabel="turns", ylabel="energy, J/kg")
    energies.set_title(
        f"The first turn adds {found[0]:.3g} J/kg (theory {drifts[0]:.3g}),\n"
        f"{half[0]:.3g} with frames of half the length",
        fontsize=10,
    )
    momenta.set(xlabel="turns", ylabel="angular momentum, m$^2$/s")
    momenta.set_title(
        f"The first turn adds {found[1]:.3g} m$^2$/s (theory {drifts[1]:.3g}),\n"
        f"{half[1]:.3g} with frames of half the length",
        fontsize=10,
    )
    for axes in (path, energies, momenta):
        axes.grid(alpha=0.3)
    energies.plot([], [], color=GRAY, lw=5, alpha=0.5, label="theory for the first turn")
    energies.legend(fontsize=8)
    columns = ("frames per turn", "turns", "energy, J/kg", "angular momentum, m^2/s")
    return Picture(figure, columns, rows)


def _fall(
    mass: float, k1: float, k2: float, frame: float, frames: int
) -> list[tuple[float, float]]:
    """Simulate a particle with drag that falls from rest, in frames that last ``frame`` s.

    Return the distance in m and the speed in m/s, at the start and after each frame.
    """
    particle = Particle(acceleration=Vector3(*DOWN), mass=mass)
    drag = Drag(k1, k2)
    seen = [(0.0, 0.0)]
    for _ in range(frames):
        drag.update_force(particle, frame)
        particle.integrate(frame)
        seen.append((-numbers(particle.position)[1], -numbers(particle.velocity)[1]))
    return seen


def _orbit(frame: float, frames: int, every: int) -> list[tuple[Numbers, Numbers]]:
    """Simulate an orbit that starts at the point farthest from the center.

    The gravitational parameter mu is 1. Return the position and velocity at the start, and then at
    intervals of ``every`` frames.
    """
    farthest = 1.0 + ECCENTRICITY
    slowest = math.sqrt((1.0 - ECCENTRICITY) / farthest)
    particle = Particle(Vector3(-farthest, 0.0, 0.0), Vector3(0.0, -slowest, 0.0))
    gravity = InverseSquareGravity(Vector3(), 1.0)
    seen = [(numbers(particle.position), numbers(particle.velocity))]
    for i in range(1, frames + 1):
        gravity.update_force(particle, frame)
        particle.integrate(frame)
        if i % every == 0:
            seen.append((numbers(particle.position), numbers(particle.velocity)))
    return seen


def _momentum_drift(h: float) -> float:
    """Predict how much angular momentum the book's integrator adds per orbit.

    A step of length h changes the angular momentum r x v by h^2 (v x a), because r x a is 0. On an
    exact orbit, v x a is L / r^3. Here L = (1 - e^2)^(1/2) is the angular momentum, and the mean of
    1 / r^3 is (1 - e^2)^(-3/2).
    """
    return h * PERIOD / (1.0 - ECCENTRICITY**2)


def _energy_drift(h: float) -> float:
    """Predict how much energy the book's integrator adds per orbit.

    A step of length h adds (h^2 / 2) (a^2 + v . H v), where H is the Hessian of the potential -1 /
    r. On an exact orbit, a^2 + v . H v is 1 / r^4 + (v^2 - 3 v_r^2) / r^3. This function integrates
    that expression over one orbit.
    """
    p = 1.0 - ECCENTRICITY**2
    count = 2000
    total = 0.0
    for i in range(count):
        angle = PERIOD * (i + 0.5) / count
        r = p / (1.0 + ECCENTRICITY * math.cos(angle))
        radial = ECCENTRICITY * math.sin(angle) / math.sqrt(p)
        square = radial**2 + p / r**2
        time = r * r / math.sqrt(p) * PERIOD / count
        total += (1.0 / r**4 + (square - 3.0 * radial**2) / r**3) * time
    return h / 2.0 * total
