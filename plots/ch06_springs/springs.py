"""Plots for chapter 6: the forces of springs, and the energy and error of oscillations.

The title of each plot reports a measured result, such as the largest error, which reveals bugs in
the student's engine. A curve is omitted if the student has not yet written the function that it
needs. For the stability limits, see stability.py.
"""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence

from matplotlib import pyplot
from matplotlib.axes import Axes

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch06_springs.own_step import my_step
from ch06_springs.springs import (
    AnchoredSpring,
    Bungee,
    Buoyancy,
    ElasticLimitSpring,
    LighterThanAir,
    Spring,
)
from plots.drawing import BLACK, BLUE, COLORS, GRAY, GREEN, ORANGE, RED, Picture, slope
from scenes.integrators import INTEGRATORS
from scenes.readings import is_written, numbers
from scenes.stability import Pull, largest_error, methods, swing, true_place

FRAME = 1.0 / 60.0


def force_against_length() -> Picture:
    """Plot the forces of chapter 6: springs and bungees, buoyancy, and the lift of a balloon.

    Spring forces are plotted against the length of the spring, and the other two against height.
    """
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.8), layout="constrained")
    k, rest = 10.0, 2.0
    other = Particle()
    limited = ElasticLimitSpring(other, k, rest, 3.0, 0.3)
    shown: tuple[tuple[Axes, ForceGenerator, str, str, float, str], ...] = (
        (left, limited, "ElasticLimitSpring, limit 3 m, share 0.3", GREEN, 5.0, "-"),
        (left, Spring(other, k, rest), "Spring", BLUE, 2.0, "-"),
        (left, Bungee(other, k, rest), "Bungee", ORANGE, 2.5, "--"),
        (right, Buoyancy(1.0, 0.001, 0.0), "Buoyancy, max_depth 1 m", BLUE, 2.0, "-"),
        (right, LighterThanAir(8.0, 2.0), "LighterThanAir, scale_height 2 m", ORANGE, 2.0, "-"),
    )
    rows: list[tuple[str, float, float]] = []
    for axes, generator, label, color, width, style in shown:
        axis, first, last = (0, 1, 80) if axes is left else (1, -40, 80)
        if not is_written(lambda g=generator: g.update_force(Particle(Vector3(1.0)), FRAME)):  # type: ignore[misc]
            continue
        places = [i / 20.0 for i in range(first, last + 1)]
        forces = [_force(generator, place, axis) for place in places]
        axes.plot(places, forces, style, color=color, lw=width, label=label)
        rows += [(type(generator).__name__, *pair) for pair in zip(places, forces, strict=True)]
    if not rows:
        _force(Spring(other, k, rest), 1.0, 0)  # reports what is not written
    lengths = [0.05, rest, 4.0]
    printed = [-k * abs(length - rest) for length in lengths]
    left.plot(lengths, printed, "--", color=GRAY, lw=1, label="printed, with abs (E-3)")
    for axes in (left, right):
        axes.axhline(0.0, color=BLACK, lw=0.8)
        axes.grid(alpha=0.3)
        if axes.lines[1:]:
            axes.legend(fontsize=8, loc="upper right")
        else:
            axes.text(0.5, 0.5, "not written yet", transform=axes.transAxes, ha="center")
    left.set(xlabel=f"length, m (rest length {rest:g} m, {k:g} N/m)")
    left.set(ylabel="force, N (positive: push)")
    right.set(xlabel="height above the water or the ground, m", ylabel="upward force, N")
    at = {row[:2]: row[2] for row in rows}
    if ("Spring", 1.0) in at:
        left.set_title(
            f"At 1 m a spring gives {at['Spring', 1.0]:+.4g} N, the printed formula {-k:+.4g} N",
            fontsize=10,
        )
    words = []
    if ("Buoyancy", 0.0) in at:
        words.append(f"Half submerged: {at['Buoyancy', 0.0]:.4g} of {at['Buoyancy', -2.0]:.4g} N")
    if ("LighterThanAir", 2.0) in at:
        low, high = at["LighterThanAir", 0.0], at["LighterThanAir", 2.0]
        words.append(f"The balloon's lift at 2 m: {high:.4g} of {low:.4g} N")
    right.set_title("\n".join(words), fontsize=10)
    return Picture(figure, ("generator", "length or height, m", "force, N"), rows)


def three_regimes() -> Picture:
    """Plot the motion of under-damped, critically damped and over-damped springs.

    Each motion is drawn twice: as simulated, and as the exact curve.
    """
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.8), layout="constrained")
    k, frames = 100.0, 90
    times = [i * FRAME for i in range(frames + 1)]
    rows: list[Sequence[object]] = []
    words = []
    for c, name, color in (
        (2.0, "under-damped", BLUE),
        (20.0, "critical", GREEN),
        (40.0, "over-damped", RED),
    ):
        exact = [true_place(k, c, time) for time in times]
        label = f"c = {c:g} N s/m: {name}"
        left.plot(times, exact, color=color, label=label)
        spring = AnchoredSpring(Vector3(), k, 0.0, c)
        stepped = [math.nan] * len(times)
        if is_written(lambda g=spring: swing(semi_implicit_euler, g, FRAME, 1, 1e3)):  # type: ignore[misc]
            run = swing(semi_implicit_euler, spring, FRAME, frames, 1e3)
            stepped[: len(run.places)] = run.places
            left.plot(times[::2], stepped[::2], "o", color=color, ms=3)
            off = [a - b for a, b in zip(stepped, exact, strict=True)]
            right.plot(times, off, color=color, label=label)
            words.append(f"{max(map(abs, off)):.3f}")
        rows += [(c, *row) for row in zip(times, exact, stepped, strict=True)]
    left.set(xlabel="time, s", ylabel="x, m (lines: formula, dots: steps)")
    left.set_title("1 kg on a spring of 100 N/m, released from rest at x = 1 m", fontsize=10)
    right.set(xlabel="time, s", ylabel="x of the steps minus x of the formula, m")
    if words:
        right.set_title(
            f"Semi-implicit Euler at 60 Hz has errors of up to {', '.join(words)} m", fontsize=10
        )
        left.legend(fontsize=8)
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.axhline(0.0, color=BLACK, lw=0.8)
    return Picture(figure, ("c, N s/m", "time, s", "formula, m", "semi-implicit Euler, m"), rows)


def energy_over_time() -> Picture:
    """Plot the energy of an undamped spring over ten seconds, for each integration method."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(12, 5.2), layout="constrained")
    k, frames = 100.0, 600
    rows: list[Sequence[object]] = []
    words, notes = [], []
    for name, method in methods(k).items():
        if not is_written(lambda m=method: swing(m, Pull(k), FRAME, 1, 1e4)):  # type: ignore[misc]
            continue
        run = swing(method, Pull(k), FRAME, frames, 1e4)
        times = [i * FRAME for i in range(len(run.places))]
        energies = [
            (k * x * x + v * v) / k for x, v in zip(run.places, run.velocities, strict=True)
        ]
        left.semilogy(times, energies, color=COLORS[name], label=name)
        rows += [(name, *row) for row in zip(times, energies, strict=True)]
        if run.message:
            notes.append(f"{name} stopped with {run.message}")
        off = [max(abs(energy - 1.0), 1e-17) for energy in energies[1:]]
        if off and max(off) < 0.5:
            label = f"{name}: at most {max(off):.1g}"
            # Leapfrog's error is almost the same with the opposite sign, so the line of velocity
            # Verlet is drawn wider, to be visible behind leapfrog's line.
            wide, order = (4.0, 1.9) if name == "velocity Verlet" else (1.0, 2.0)
            right.semilogy(times[1:], off, color=COLORS[name], lw=wide, label=label, zorder=order)
        elif energies[-1] > 0.0:
            rate = energies[-1] ** (1.0 / (len(energies) - 1))
            words.append(
                f"{name}: energy x {rate:.4f} per step, which is x {rate**600:.3g} in 10 s"
            )
    if not rows:
        swing(INTEGRATORS["explicit Euler"], Pull(k), FRAME, 1, 1e4)  # reports what is not written
    left.set_title("\n".join(words), fontsize=9)
    left.set(xlabel="time, s", ylabel="energy / initial energy (100 N/m, 1 kg, 60 Hz)")
    right.set(xlabel="time, s", ylabel="relative error of the energy")
    right.set_title("Methods that nearly conserve the energy", fontsize=9)
    for axes in (left, right):
        axes.grid(alpha=0.3)
        if axes.lines:
            axes.legend(fontsize=8, loc="best")
    if notes:
        figure.supxlabel("\n".join(notes), fontsize=8)
    return Picture(figure, ("method", "time, s", "energy / initial energy"), rows)


def error_against_work() -> Picture:
    """Plot how accurately each integration method simulates a spring, and how much work it takes.

    The plot shows the largest error within 1 s against the work, which is the number of force
    evaluations.
    """
    figure, panels = pyplot.subplots(1, 4, figsize=(16, 5.6), layout="constrained", sharey=True)
    rows: list[Sequence[object]] = []
    words = []
    for axes, k in zip(panels, (1.0, 1e2, 1e4, 1e6), strict=True):
        chi = math.sqrt(k)
        ways = methods(k) | {"your own step": my_step}
        for height, (name, method) in enumerate(ways.items()):
            if not is_written(lambda m=method, k=k: swing(m, Pull(k), 1e-6, 1, 1e9)):  # type: ignore[misc]
                continue
            color, cost = (
                COLORS.get(name, BLACK),
                {"velocity Verlet": 2, "Runge-Kutta 4": 4}.get(name, 1),
            )
            fine = []
            for steps in (2**power // cost for power in range(3, 14)):
                pull = Pull(k)
                run = swing(method, pull, 1.0 / steps, steps, 10.0 * chi)
                work = pull.count or len(run.places) - 1  # one solution of a solver counts as one
                error = math.inf if run.message else largest_error(run.places, chi, steps)
                rows.append((k, name, steps, work, error))
                # An exploded run may have such an error as long as watched is not written.
                if not error < 1e6:
                    axes.plot(steps * cost, 10.0 * 3.0**height, "x", color=color, ms=4)
                else:
                    fine.append((work, error))
            axes.plot(*zip(*fine, strict=True), "o-", ms=3, lw=1, color=color, label=name)
            fine = [pair for pair in fine if 1e-11 < pair[1] < 0.02]
            if k == 100.0 and len(fine) > 1:
                order = -slope(*zip(*fine[-4:], strict=True))
                words.append(f"{name} {order:.3f}")
        if is_written(lambda k=k: true_place(k, 0.0, 1.0)):  # type: ignore[misc]
            exact = [true_place(k, 0.0, i / 64.0) for i in range(65)]
            error = max(largest_error(exact, chi, 64), 1e-17)
            rows.append((k, "closed form", 1, 1, error))
            axes.plot(1, error, "*", color=BLACK, ms=9, label="closed form (no error, at 1e-17)")
        swings = chi / 2.0 / math.pi
        axes.set(xscale="log", yscale="log", title=f"{k:,.0f} N/m: {swings:.3g} oscillations")
        axes.set(xlabel="evaluations of the force, or solutions")
        axes.grid(alpha=0.3)
    if all(name == "closed form" for _, name, *_ in rows):
        swing(INTEGRATORS["explicit Euler"], Pull(1.0), FRAME, 1, 1e4)  # reports a stub
    panels[0].set_ylabel("largest error within 1 s, m (crosses: exploded)")
    if panels[0].lines:
        figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=9)
    if words:
        title = f"Orders measured at 100 N/m: {', '.join(words)}"
        figure.suptitle("\n".join(textwrap.wrap(title, 120)), fontsize=11)
    return Picture(figure, ("k, N/m", "method", "steps", "evaluations", "largest error, m"), rows)


def _force(generator: ForceGenerator, place: float, axis: int) -> float:
    """Compute the component of a generator's force along one coordinate axis.

    ``axis`` is 0 for x, 1 for y or 2 for z. The particle on which the force acts lies on the same
    axis, at ``place``.
    """
    particle = Particle(Vector3(*(place if i == axis else 0.0 for i in range(3))))
    generator.update_force(particle, FRAME)
    return numbers(particle.force_accumulator)[axis]
