"""Draw the stability limits of integrators, and how soon simulations diverge beyond them.

Curves are predictions from the eigenvalues of one time step. Marks come from simulations.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from matplotlib import pyplot
from matplotlib.axes import Axes

from plots.drawing import BLACK, COLORS, GRAY, growth_bar, growth_map
from scenes.integrators import INTEGRATORS, SOLVERS
from scenes.stability import stepping, swing
from studies.limits.search import ALL_SOLVERS, HUGE, KAPPA, first, growth_at, theory_at

SHADES = COLORS | {"pymunk's spring": BLACK, "pymunk, by hand": GRAY}
# Pymunk's results lie on the curves of equal methods, so their marks must show on top of others.
MARKS = dict(zip(SHADES, "oo^vsoox+", strict=True))
KAPPAS = [0.01 * 10.0 ** (i / 16.0) for i in range(56)]
DOTS = (0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0, 1.5, 2.0)  # dampings at which limits are measured
# For each method, a damping at which its limit is above 0. The damping is d^h, or c h / m.
LOST = dict.fromkeys(INTEGRATORS, 1.0) | {"explicit Euler": 0.5}
LOST |= {"pymunk's spring": 0.0, "pymunk, by hand": 0.5}
BEYOND = (0.001, 0.003, 0.01, 0.02, 0.03, 0.1, 0.3, 1.0)  # k / limit - 1
LOSS_COLUMNS = (
    "method",
    "damping",
    "k / limit - 1",
    "steps to x 1e6 by the eigenvalue",
    "steps of a simulation from release",
    "steps of a simulation from x 1e3 to x 1e9",
)
Loss = tuple[str, float, float, float, int, int]


def draw_maps(png: Path) -> None:
    """Draw the growth per time step against stiffness and damping, with the limits, per method."""
    figure, panels = pyplot.subplots(3, 3, figsize=(14, 12), layout="constrained")
    off = []
    for axes, name in zip(panels.flat, SHADES, strict=True):
        is_ours = name in INTEGRATORS
        full, undamped, words = (1.0, 1.0, "d$^h$") if is_ours else (2.0, 0.0, "c h / m")
        dampings = [full * i / 40.0 for i in range(4 if is_ours else 0, 41)]
        grown = [[growth_at(name, d, kappa) for kappa in KAPPAS] for d in dampings]
        colored = growth_map(axes, KAPPAS, dampings, grown, in_spring=not is_ours)
        if name in SOLVERS:
            most = max(map(max, grown))
            axes.set_title(f"{name}\nalways stable: at most x {most:.4f}", fontsize=10)
            continue
        fine = [dampings[0] + (full - dampings[0]) * i / 999.0 for i in range(1000)]
        curve = [(true, d) for d in fine if (true := theory_at(name, d))]
        axes.plot(*zip(*curve, strict=True), color=BLACK, label="theory")
        found = {d: first(partial(growth_at, name, d)) for d in dampings if d in DOTS}
        off += [found[d] / true - 1.0 for d in found if (true := theory_at(name, d))]
        axes.plot([*found.values()], [*found], "o", color="white", mec=BLACK, label="bisection")
        axes.legend(fontsize=8, loc="lower left" if is_ours else "upper left")
        limits = f"limit {found[undamped]:.3g} undamped, {found[0.5]:.3g} at {words} = 0.5"
        axes.set_title(f"{name}\n{limits}", fontsize=10)
    growth_bar(figure, panels, colored)
    worst = 100.0 * max(map(abs, off))
    figure.suptitle(
        f"Limits of k h$^2$ / m: bisection differs from theory by at most {worst:.1g} %"
    )
    figure.savefig(png, dpi=110)
    pyplot.close(figure)


def divergence() -> list[Loss]:
    """Predict and measure in how many steps unstable oscillations grow by a factor of 1e6."""
    rows: list[Loss] = []
    for name, damping in LOST.items():
        for beyond in BEYOND:
            kappa = theory_at(name, damping) * (1.0 + beyond)
            predicted = math.log(HUGE) / math.log(growth_at(name, damping, kappa))
            counted = steps_to_loss(name, damping, kappa, predicted)
            rows.append((name, damping, beyond, predicted, *counted))
    return rows


def steps_to_loss(name: str, damping: float, kappa: float, predicted: float) -> tuple[int, int]:
    """Count the steps in which an oscillation, |(x, v / sqrt(k / m))|, grows by 1e6.

    They are counted from the release, and from a growth by 1e3, when the initial state no longer
    matters. The ``predicted`` number limits the simulation.
    """
    integrator, pull, d = stepping(name, damping, kappa, ALL_SOLVERS)
    chi = math.sqrt(pull.stiffness)
    places, speeds = swing(integrator, pull, d, steps=round(1.6 * predicted) + 50, limit=1e20)
    sizes = [math.hypot(x, v / chi) for x, v in zip(places.values, speeds.values, strict=True)]

    def when(size: float) -> int:
        return next(i for i, each in enumerate(sizes) if each >= size)

    return when(HUGE), when(1e3 * HUGE) - when(1e3)


def draw_divergence(
    losses: Sequence[Loss], drifts: dict[str, list[float]], swings: Sequence[int], png: Path
) -> None:
    """Plot how soon simulations of springs diverge, and how the energy of stable ones drifts."""
    figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(17, 5.4), layout="constrained")
    _draw_steps(left, middle, losses)
    _draw_energies(right, drifts, swings)
    for axes in (left, middle, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    figure.savefig(png, dpi=110)
    pyplot.close(figure)


def _draw_steps(left: Axes, right: Axes, losses: Sequence[Loss]) -> None:
    """Plot in how many steps an oscillation grows by 1e6, and how that differs from theory."""
    # From rest (marks), it is the sum of two eigenvectors, of which one grows. Near a limit they
    # are almost parallel, so the growing one may be much larger than the sum, or half as large.
    # Far beyond the limit, the difference comes from rounding to whole steps.
    for name, damping in LOST.items():
        own = [loss[2:] for loss in losses if loss[0] == name]
        beyond, predicted, rest, evenly = zip(*own, strict=True)
        color, mark = SHADES[name], MARKS[name]
        label = f"{name}, {'d$^h$' if name in INTEGRATORS else 'c h / m'} = {damping:g}"
        left.plot(beyond, predicted, color=color, lw=1)
        left.plot(beyond, rest, mark, color=color, mfc="none", label=label)
        off = [*map(_percent, rest, predicted)]
        right.plot(beyond, off, f"{mark}:", color=color, mfc="none", lw=0.8, label=name)
        right.plot(beyond, [*map(_percent, evenly, predicted)], "-", color=color, lw=1.5)
    left.set(xscale="log", yscale="log", xlabel="k / limit - 1")
    left.set_ylabel("steps until an oscillation is 1e6 times as large")
    near = [rest for _, _, beyond, _, rest, _ in losses if beyond == 0.02]
    left.set_title(
        f"2 % outside the limit, an oscillation diverges in {min(near)} to {max(near)} steps\n"
        "(lines: ln 1e6 / ln |eigenvalue|; marks: simulated from rest)",
        fontsize=10,
    )
    clear = [(found, wanted) for *_, wanted, _, found in losses if abs(found - wanted) > 1.0]
    most = max((abs(_percent(*pair)) for pair in clear), default=0.0)
    worst = max(abs(_percent(found, wanted)) for *_, wanted, found, _ in losses)
    right.axhline(0.0, color=BLACK, lw=0.8)
    right.set(xscale="log", xlabel="k / limit - 1", ylabel="steps simulated / predicted - 1, %")
    right.set_title(
        f"In steady growth (lines) the error is within a step, or at most {most:.1g} %;\n"
        f"from rest (marks) the size of the growing eigenvector adds up to {worst:.2g} %",
        fontsize=10,
    )


def _percent(found: float, predicted: float) -> float:
    return 100.0 * (found / predicted - 1.0)


def _draw_energies(axes: Axes, drifts: dict[str, list[float]], swings: Sequence[int]) -> None:
    for name, ratios in drifts.items():
        color, mark = SHADES[name], MARKS[name]
        axes.semilogx(swings, ratios, f"{mark}-", color=color, mfc="none", lw=1, ms=5, label=name)
    # The fourth-order series of e^(i a) has the squared magnitude 1 - a^6 / 72 + a^8 / 576.
    step = math.log1p(-(KAPPA**3) / 72.0 + KAPPA**4 / 576.0)
    each = 2.0 * math.pi / math.sqrt(KAPPA)
    by_theory = [math.exp(count * each * step) for count in swings]
    axes.plot(swings, by_theory, "--", color=BLACK, lw=1, label="Runge-Kutta 4, theory")
    leaking = ("Runge-Kutta 4", "backward Euler")
    most = max(abs(own[-1] - 1.0) for name, own in drifts.items() if name not in leaking)
    axes.set(xlabel="oscillations", ylabel="energy / initial energy, mean over an oscillation")
    axes.set_title(
        f"After {swings[-1]:,} oscillations at k h$^2$ / m = {KAPPA:.3g}, Runge-Kutta 4 keeps "
        f"{drifts['Runge-Kutta 4'][-1]:.3g}\nof its energy and backward Euler "
        f"{drifts['backward Euler'][-1]:.1g}. The others are within {100.0 * most:.1g} %",
        fontsize=10,
    )
