"""Plots for chapter 6: the forces of springs, and the energy and error of oscillations."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from functools import partial

from matplotlib import pyplot
from matplotlib.axes import Axes

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, semi_implicit_euler
from ch06_springs.own_step import my_step
from ch06_springs.springs import (
    AnchoredSpring,
    Bungee,
    Buoyancy,
    ElasticLimitSpring,
    LighterThanAir,
    Spring,
)
from plots.drawing import BLACK, BLUE, COLORS, GRAY, GREEN, ORANGE, RED, Picture, legends, slope
from scenes.clock import FRAME
from scenes.readings import is_written, number, numbers, written
from scenes.spring_on_a_wall import SpringOnAWall
from scenes.stability import Pull, swing

EVALUATIONS = {"velocity Verlet": 2, "Runge-Kutta 4": 4}  # of the force in a step; others need 1


def force_against_length() -> Picture:
    """Plot the forces of springs by length, and of buoyancy and a balloon by height."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.8), layout="constrained")
    k, rest = 10.0, 2.0
    other = Particle()
    limited = ElasticLimitSpring(other, k, rest, 3.0, 0.3)
    shown: dict[str, tuple[Axes, ForceGenerator, str, float, str]] = {
        "ElasticLimitSpring, limit 3 m, share 0.3": (left, limited, GREEN, 5.0, "-"),
        "Spring": (left, Spring(other, k, rest), BLUE, 2.0, "-"),
        "Bungee": (left, Bungee(other, k, rest), ORANGE, 2.5, "--"),
        "Buoyancy, max_depth 1 m": (right, Buoyancy(1.0, 0.001, 0.0), BLUE, 2.0, "-"),
        "LighterThanAir, scale_height 2 m": (right, LighterThanAir(8.0, 2.0), ORANGE, 2.0, "-"),
    }
    runs = {label: partial(_forces, row[1], row[0] is right) for label, row in shown.items()}
    rows = []
    for label, pairs in written(runs).items():
        axes, generator, color, width, style = shown[label]
        axes.plot(*zip(*pairs, strict=True), style, color=color, lw=width, label=label)
        rows += [(type(generator).__name__, *pair) for pair in pairs]
    lengths = [0.05, rest, 4.0]
    printed = [-k * abs(length - rest) for length in lengths]
    left.plot(lengths, printed, "--", color=GRAY, lw=1, label="printed, with abs (E-3)")
    for axes in (left, right):
        axes.axhline(0.0, color=BLACK, lw=0.8)
    legends(left, right, loc="upper right")
    left.set_xlabel(f"length, m (rest length {rest:g} m, {k:g} N/m)")
    left.set_ylabel("force, N (positive: push)")
    right.set(xlabel="height above the water or the ground, m", ylabel="upward force, N")
    at = {row[:2]: row[2] for row in rows}
    words = []
    if ("Spring", 1.0) in at:
        title = f"At 1 m a spring gives {at['Spring', 1.0]:+.4g} N, the printed formula {-k:+.4g} N"
        left.set_title(title, fontsize=10)
    if ("Buoyancy", 0.0) in at:
        words.append(f"Half submerged: {at['Buoyancy', 0.0]:.4g} of {at['Buoyancy', -2.0]:.4g} N")
    if ("LighterThanAir", 2.0) in at:
        low, high = at["LighterThanAir", 0.0], at["LighterThanAir", 2.0]
        words.append(f"The balloon's lift at 2 m: {high:.4g} of {low:.4g} N")
    right.set_title("\n".join(words), fontsize=10)
    return Picture(figure, ("generator", "length or height, m", "force, N"), rows)


def three_regimes() -> Picture:
    """Plot the simulated and the exact motion of under-, critically and over-damped springs."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.8), layout="constrained")
    k, frames = 100.0, 90
    times = [i * FRAME for i in range(frames + 1)]
    rows: list[Sequence[object]] = []
    words = []
    regimes = ((2.0, "under-damped", BLUE), (20.0, "critical", GREEN), (40.0, "over-damped", RED))
    for c, name, color in regimes:
        exact = true_places(k, c, times)
        label = f"c = {c:g} N s/m: {name}"
        left.plot(times, exact, color=color, label=label)
        stepped = [math.nan] * len(times)
        run = partial(swing, semi_implicit_euler, AnchoredSpring(Vector3(), k, 0.0, c), limit=1e3)
        if is_written(partial(run, steps=1)):
            places = run(steps=frames)[0].values
            stepped[: len(places)] = places
            left.plot(times[::2], stepped[::2], "o", color=color, ms=3)
            off = [a - b for a, b in zip(stepped, exact, strict=True)]
            right.plot(times, off, color=color, label=label)
            words.append(f"{max(map(abs, off)):.3f}")
        rows += [(c, *row) for row in zip(times, exact, stepped, strict=True)]
    left.set(xlabel="time, s", ylabel="x, m (lines: formula, dots: steps)")
    left.set_title("1 kg on a spring of 100 N/m, released from rest at x = 1 m", fontsize=10)
    right.set(xlabel="time, s", ylabel="x of the steps minus x of the formula, m")
    if words:
        title = f"Semi-implicit Euler at 60 Hz has errors\nof up to {', '.join(words)} m"
        right.set_title(title, fontsize=10)
        left.legend(fontsize=8)
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.axhline(0.0, color=BLACK, lw=0.8)
    return Picture(figure, ("c, N s/m", "time, s", "formula, m", "semi-implicit Euler, m"), rows)


def energy_over_time() -> Picture:
    """Plot the energy of an undamped spring over ten seconds, for each integration method."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(12, 5.2), layout="constrained")
    k = 100.0
    rows: list[Sequence[object]] = []
    words, notes = [], []
    methods, run = SpringOnAWall(k).methods(), partial(swing, generator=Pull(k), limit=1e4)
    runs = written({name: partial(run, methods[name], steps=600) for name in methods})
    for name, (places, velocities) in runs.items():
        pairs = zip(places.values, velocities.values, strict=True)
        energies = [(k * x * x + v * v) / k for x, v in pairs]
        left.semilogy(places.times, energies, color=COLORS[name], label=name)
        rows += [(name, *row) for row in zip(places.times, energies, strict=True)]
        if places.message:
            notes.append(f"{name} stopped with {places.message}")
        off = [max(abs(energy - 1.0), 1e-17) for energy in energies[1:]]
        if off and max(off) < 0.5:
            label = f"{name}: at most {max(off):.1g}"
            # Leapfrog's error is almost the same with the opposite sign, so the line of velocity
            # Verlet is drawn wider, to be visible behind leapfrog's line.
            look = {"lw": 4.0, "zorder": 1.9} if name == "velocity Verlet" else {"lw": 1.0}
            right.semilogy(places.times[1:], off, color=COLORS[name], label=label, **look)
        elif off and energies[-1] > 0.0:
            rate = energies[-1] ** (1.0 / len(off))
            grown = f"x {rate:.4f} per step, which is x {rate**600:.3g} in 10 s"
            words.append(f"{name}: energy {grown}")
    left.set_title("\n".join(words), fontsize=9)
    left.set(xlabel="time, s", ylabel="energy / initial energy (100 N/m, 1 kg, 60 Hz)")
    right.set(xlabel="time, s", ylabel="relative error of the energy")
    right.set_title("Methods that nearly conserve the energy", fontsize=9)
    for axes in (left, right):
        axes.grid(alpha=0.3)
        if axes.lines:
            axes.legend(fontsize=8, loc="best")
    figure.supxlabel("\n".join(notes), fontsize=8)
    return Picture(figure, ("method", "time, s", "energy / initial energy"), rows)


def error_against_work() -> Picture:
    """Plot the largest error of each method within 1 s against its force evaluations."""
    figure, panels = pyplot.subplots(1, 4, figsize=(16, 5.6), layout="constrained", sharey=True)
    rows: list[Sequence[object]] = []
    words = []
    for axes, k in zip(panels, (1.0, 1e2, 1e4, 1e6), strict=True):
        ways = SpringOnAWall(k).methods() | {"your own step": my_step}
        found = written({name: partial(_errors, name, ways[name], k) for name in ways})
        for name, runs in found.items():
            rows += [(k, name, *run) for run in runs]
            # An exploded run may have a finite error as long as watched is not written.
            fine = [(work, error) for _, work, error in runs if error < 1e6]
            lost = [EVALUATIONS.get(name, 1) * steps for steps, _, error in runs if not error < 1e6]
            height = [10.0 * 3.0 ** [*ways].index(name)] * len(lost)
            color = COLORS.get(name, BLACK)
            axes.plot(lost, height, "x", color=color, ms=4)
            axes.plot(*zip(*fine, strict=True), "o-", ms=3, lw=1, color=color, label=name)
            fine = [pair for pair in fine if 1e-11 < pair[1] < 0.02]
            if k == 100.0 and len(fine) > 1:
                order = -slope(*zip(*fine[-4:], strict=True))
                words.append(f"{name} {order:.3f}")
        if is_written(partial(true_places, k, 0.0, [1.0])):
            exact = true_places(k, 0.0, [i / 64.0 for i in range(65)])
            error = max(_largest_error(exact, k), 1e-17)
            rows.append((k, "closed form", 1, 1, error))
            axes.plot(1, error, "*", color=BLACK, ms=9, label="closed form (no error, at 1e-17)")
        swings = math.sqrt(k) / 2.0 / math.pi
        axes.set(xscale="log", yscale="log", title=f"{k:,.0f} N/m: {swings:.3g} oscillations")
        axes.set_xlabel("evaluations of the force, or solutions")
        axes.grid(alpha=0.3)
    panels[0].set_ylabel("largest error within 1 s, m (crosses: exploded)")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=9)
    if words:
        title = f"Orders measured at 100 N/m: {', '.join(words)}"
        figure.suptitle("\n".join(textwrap.wrap(title, 120)), fontsize=11)
    return Picture(figure, ("k, N/m", "method", "steps", "evaluations", "largest error, m"), rows)


def true_places(k: float, c: float, times: Sequence[float]) -> list[float]:
    """Compute the exact positions at several times of 1 kg on a spring, released at 1 m."""
    states = [SpringOnAWall(k, c).state(time) for time in times]
    return [number(state[0]) if isinstance(state, tuple) else math.nan for state in states]


def _forces(generator: ForceGenerator, is_upward: bool) -> list[tuple[float, float]]:
    """Return pairs of a height or length in m and the generator's force along it in N."""
    found = []
    for i in range(-40 if is_upward else 1, 81):
        place = i / 20.0
        particle = Particle(Vector3(0.0, place) if is_upward else Vector3(place))
        generator.update_force(particle, FRAME)
        found.append((place, numbers(particle.force_accumulator)[is_upward]))
    return found


def _errors(name: str, method: Integrator, k: float) -> list[tuple[int, int, float]]:
    """Return the numbers of steps within 1 s, with the work and the largest error of each run."""
    found = []
    for steps in (2**power // EVALUATIONS.get(name, 1) for power in range(3, 14)):
        pull = Pull(k)
        run = partial(swing, method, pull, limit=10.0 * math.sqrt(k), duration=1.0 / steps)
        places, _ = run(steps=steps)
        work = pull.count or len(places.values) - 1  # one solution of a solver counts as one
        error = math.inf if places.message else _largest_error(places.values, k)
        found.append((steps, work, error))
    return found


def _largest_error(places: Sequence[float], k: float) -> float:
    """Return the largest deviation from the exact motion in 1 s, sampled at most 64 times."""
    steps = len(places) - 1
    every, chi = max(1, steps // 64), math.sqrt(k)
    found = [abs(places[i] - math.cos(chi * i / steps)) for i in range(every, len(places), every)]
    return max(found, default=math.nan)
