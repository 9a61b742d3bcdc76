"""Plots for chapter 3: three forms of damping, and the error of the integrator."""

from __future__ import annotations

import math

from matplotlib import pyplot
from matplotlib.axes import Axes

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.damping import damp_per_frame, damp_per_second
from ch03_laws_of_motion.exercises import random_frames
from ch03_laws_of_motion.particle import Particle
from plots.drawing import BLACK, BLUE, GREEN, ORANGE, THEORY, Picture, finish, slope
from scenes.flight import FLIGHT_TIME, FREE_FALL, GRAVITY, PROJECTILE, Flight, flown
from scenes.readings import numbers

G = -GRAVITY[1]
KEPT = 0.5  # damping per second
TUNED_AT = 60.0  # frames per second at which damping per frame loses as much as per second
RATES = (15, 20, 30, 45, 60, 90, 120, 180, 240)
JITTER = 0.3
RUNS = 20
FORMS = (
    ("Eq. 3.5, v d + a h, set for 60 Hz", ORANGE, "s-"),
    ("Eq. 3.6, v d^h + a h", BLUE, "^-"),
    ("the engine, (v + a h) d^h", BLACK, "o--"),
)


def damping_comparison() -> Picture:
    """Plot the velocity lost to three forms of damping by frame rate (exercise 3.5)."""
    exact = 1.0 + Flight(damping=KEPT).exact(1.0).velocity[1] / G
    rows = [(rate, *_losses(rate), exact) for rate in RATES]
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.6), layout="constrained")
    for column, (label, color, style) in enumerate(FORMS, 1):
        lost = [100.0 * row[column] for row in rows]
        left.plot(RATES, lost, style, color=color, ms=5, label=label)
        if column > 1:
            off = [100.0 * (row[column] - exact) for row in rows]
            right.plot(RATES, off, style, color=color, ms=5, label=label)
    left.axhline(100.0 * exact, **THEORY, label="exact, dv/dt = a + v ln d")
    title = (
        "The loss by Eq. 3.5 depends on the frame rate:\n"
        f"{100.0 * rows[0][1]:.0f} % at 15 Hz, {100.0 * rows[-1][1]:.0f} % at 240 Hz"
    )
    _frame_rates(left, title, "velocity lost in one second of fall, %", (0, 100))
    for sign in (1.0, -1.0):
        # To first order in h, each form has an error of k h / 2 of the remaining velocity.
        theory = [sign * 50.0 * (1.0 - exact) * -math.log(KEPT) / rate for rate in RATES]
        label = "" if sign < 0.0 else "theory, ±(1 - loss) h ln d / 2"
        right.plot(RATES, theory, **THEORY, label=label)
    orders = [-slope(RATES, [abs(row[column] - exact) for row in rows]) for column in (2, 3)]
    sides = {row[column] > exact for row in rows for column in (2, 3)}
    title = (
        f"Eq. 3.6 and the engine err on {'opposite sides' if len(sides) == 2 else 'one side'};\n"
        "the error grows as h to the power {:.2f} and {:.2f}".format(*orders)
    )
    _frame_rates(right, title, "loss minus exact loss, percentage points", (-3.5, 3.5))
    columns = ("frame rate, Hz", *(f"loss: {form[0]}" for form in FORMS), "exact loss")
    return Picture(figure, columns, rows)


def integration_error() -> Picture:
    """Plot the position error in free fall against the length of the time step (exercise 3.4)."""
    time = 5.0

    def error(frames: int) -> float:
        end = flown(FREE_FALL, time / frames, frames)[-1]
        return math.dist(end.position, FREE_FALL.exact(time).position)

    counts = (10, 20, 50, 100, 200, 500, 1000, 3000)
    rows = [(time / n, error(n), G * time * (time / n) / 2.0) for n in counts]
    lengths, errors, theory = zip(*rows, strict=True)
    figure, axes = pyplot.subplots(figsize=(6.4, 5), layout="constrained")
    axes.loglog(lengths, theory, **THEORY, label="theory, g t h / 2")
    axes.loglog(lengths, errors, "o-", color=BLACK, ms=5, label="Particle.integrate")
    title = (
        f"The error grows as h to the power {slope(lengths, errors):.3f}\n"
        f"and is {error(300):.3f} m at 60 steps per second"
    )
    finish(axes, title, "time step h, s", f"error of the position after {time:g} s, m", 10)
    return Picture(figure, ("h, s", "error, m", "g t h / 2, m"), rows)


def trajectories() -> Picture:
    """Draw the simulated and the exact path of a ball that is thrown with and without damping."""
    frame = 0.1
    times = [i * frame for i in range(round(FLIGHT_TIME / frame) + 1)]
    undamped = Flight(PROJECTILE.position, PROJECTILE.velocity)
    figure, axes = pyplot.subplots(figsize=(8, 4), layout="constrained")
    rows, gaps = [], []
    for flight, color, mark in ((undamped, BLUE, "o"), (PROJECTILE, ORANGE, "s")):
        stepped = [state.position for state in flown(flight, frame, len(times) - 1)]
        exact = [flight.exact(time).position for time in times]
        label = f"d = {flight.damping:g}"
        axes.plot([x for x, _, _ in exact], [y for _, y, _ in exact], color=color, label=label)
        points = ([x for x, _, _ in stepped], [y for _, y, _ in stepped])
        axes.plot(*points, mark, color=color, ms=4, label=f"{label}, in steps of {frame} s")
        gaps.append(max(math.dist(p, q) for p, q in zip(stepped, exact, strict=True)))
        pairs = zip(times, stepped, exact, strict=True)
        rows += [(flight.damping, time, *p[:2], *q[:2]) for time, p, q in pairs]
    axes.axhline(0.0, color=GREEN, lw=1, label="ground")
    title = (
        f"In steps of {frame} s the position of a throw is wrong\n"
        f"by up to {gaps[0]:.2f} m without damping and {gaps[1]:.2f} m with it"
    )
    finish(axes, title, "x, m", "y, m", 9, aspect="equal")
    columns = ("damping", "time, s", "x, m", "y, m", "exact x, m", "exact y, m")
    return Picture(figure, columns, rows)


PLOTS = (damping_comparison, integration_error, trajectories)


def _losses(rate: float) -> list[float]:
    """Measure the fraction of velocity lost to each form in 1 s, as a mean of random runs."""
    gravity = Vector3(*GRAVITY)
    per_frame = KEPT ** (1.0 / TUNED_AT)
    sums = [0.0, 0.0, 0.0]
    for seed in range(RUNS):
        by_frame = by_second = Vector3()
        particle = Particle(acceleration=gravity, damping=KEPT)
        for h in random_frames(1.0 / rate, JITTER, 1.0, seed):
            by_frame = damp_per_frame(by_frame, gravity, per_frame, h)
            by_second = damp_per_second(by_second, gravity, KEPT, h)
            particle.integrate(h)
        for i, v in enumerate((by_frame, by_second, particle.velocity)):
            sums[i] += 1.0 + numbers(v)[1] / G
    return [total / RUNS for total in sums]


def _frame_rates(axes: Axes, title: str, label: str, limits: tuple[float, float]) -> None:
    x = "frames per second (each frame up to 30 % shorter or longer)"
    finish(axes, title, x, label, 9, xscale="log", ylim=limits)
    axes.set_xticks(RATES, [str(rate) for rate in RATES])
    axes.minorticks_off()
