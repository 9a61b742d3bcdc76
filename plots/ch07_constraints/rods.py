"""Plots for chapter 7: how well chains of rods keep their length, and the energy of a pendulum."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial
from itertools import pairwise

from matplotlib import pyplot

from ch02_vectors.vector import Vector3
from ch06_springs.integrators import Integrator, semi_implicit_euler
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.links import Rod, TwoSidedRod
from plots.drawing import BLACK, BLUE, GRAY, GREEN, ORANGE, PINK, RED, SKY, Picture, legends, tell
from scenes.chain import Chain, Link
from scenes.clock import FRAME, Move, Track, tracks
from scenes.integrators import INTEGRATORS
from scenes.readings import numbers, written
from scenes.resolving import by_resolver, resolving
from scenes.setup import Setup

LINKS, LINK = 25, 0.1  # rods of a rope, and their length in m
KINDS: dict[str, Link] = {"Rod": Rod, "TwoSidedRod": TwoSidedRod}


def rope_by_method() -> Picture:
    """Plot the length error of a swinging rope of rods over time, for each simulation method."""
    figure, axes = pyplot.subplots(figsize=(10, 5.6), layout="constrained")
    rope, frames = Chain([1.0] * LINKS, LINK, math.radians(30.0)), 120
    methods: dict[str, tuple[Link | None, int | None, int, str]] = {
        "Rod": (Rod, None, 1, RED),
        "Rod, 10 times the iterations": (Rod, 20, 1, ORANGE),
        "Rod, 8 substeps": (Rod, None, 8, PINK),
        "TwoSidedRod": (TwoSidedRod, None, 1, SKY),
        "TwoSidedRod, 8 substeps": (TwoSidedRod, None, 8, BLUE),
        "DirectChain": (None, None, 1, GREEN),
    }
    runs = {
        name: partial(stretch, rope, link, frames, iterations, substeps)
        for name, (link, iterations, substeps, _) in methods.items()
    }
    found = written(runs)
    rows: list[Sequence[object]] = []
    for name, (run, worst) in found.items():
        # A rope whose length is exact except for rounding is drawn at the lower edge.
        off = [max(abs(value), 1e-10) for value in run.values]
        label = f"{name}: at most {max(off):.2g} m"
        color, width = methods[name][-1], 3.0 if name == "Rod" else 1.3
        axes.semilogy(run.times, off, color=color, lw=width, label=label)
        rows += [(name, *row) for row in zip(run.times, run.values, worst.values, strict=True)]
    label = f"length of the rope: {LINKS * LINK:g} m"
    axes.axhline(LINKS * LINK, color=GRAY, lw=1, ls=":", label=label)
    last = {name: run.values[-1] for name, (run, _) in found.items()}
    words = [f"{name} {last[name]:.2g}" for name in ("Rod", "DirectChain") if name in last]
    axes.set_title(
        f"{LINKS} links of {LINK:g} m, released at 30$\\degree$: "
        f"error in length after {frames * FRAME:g} s, in m: {', '.join(words)}",
        fontsize=11,
    )
    axes.set(xlabel="time, s", ylabel="error in the length of the rope, m (60 Hz)")
    axes.grid(alpha=0.3)
    figure.legend(fontsize=8, ncols=3, loc="outside lower center")
    tell(figure, [f"{name}: {run.message}" for name, (run, _) in found.items() if run.message])
    columns = ("method", "time, s", "error of the rope, m", "largest error of a rod, m")
    return Picture(figure, columns, rows)


def rods_hold() -> Picture:
    """Plot the largest length error of a rod in a hanging chain against the number of rods."""
    figure, panels = pyplot.subplots(1, 2, figsize=(12, 5.4), layout="constrained", sharey=True)
    panels[0].set(yscale="log", ylim=(5e-11, 10.0))  # a wrong engine may have no finite error
    # Cases that take longer than all other cases together are left out.
    ways = {
        "default iterations": (None, 1, 30, RED),
        "x 10": (20, 1, 10, ORANGE),
        "x 100": (200, 1, 3, GREEN),
        "4 substeps": (None, 4, 10, SKY),
        "16 substeps": (None, 16, 10, BLUE),
    }
    chains = {count: Chain([1.0] * count, LINK) for count in (1, 3, 10, 30)}
    runs = {
        (kind, way, count): partial(stretch, chain, KINDS[kind], 120, iterations, substeps)
        for kind in KINDS
        for way, (iterations, substeps, most, _) in ways.items()
        for count, chain in chains.items()
        if count <= most
    }
    found = written(runs)
    worst = {key: max(run.values[90:], default=math.inf) for key, (_, run) in found.items()}
    for axes, kind in zip(panels, KINDS, strict=True):
        for way, (*_, color) in ways.items():
            seen = {n: off for (k, w, n), off in worst.items() if (k, w) == (kind, way)}
            if seen:
                shown = [max(off, 1e-10) for off in seen.values()]
                style = "s--" if "substeps" in way else "o-"
                label = f"{way}: {shown[-1]:.2g} m for {[*seen][-1]} rods"
                axes.loglog([*seen], shown, style, color=color, ms=5, label=label)
        at = [value for (k, _, n), value in worst.items() if (k, n) == (kind, 10)]
        words = f"{min(at):.2g} to {max(at):.2g}" if at else "?"
        axes.set_title(f"{kind}: the largest error of 10 rods is {words} m", fontsize=10)
        axes.axhline(LINK, color=GRAY, lw=1, ls=":")
        axes.set_xticks((1, 3, 10, 30), ("1", "3", "10", "30"))
        axes.set_xticks([], minor=True)
        axes.set_xlabel("number of rods in the chain, 0.1 m each (dotted)")
        legends(axes)
    panels[0].set_ylabel("largest error of a rod from 1.5 to 2 s, m (60 Hz; 1e-10 or less at edge)")
    tell(figure, [f"{key}: {run.message}" for key, (_, run) in found.items() if run.message])
    rows = [(*key, value) for key, value in worst.items()]
    return Picture(figure, ("link", "method", "rods", "largest error of a rod, m"), rows)


def pendulum_energy() -> Picture:
    """Plot the energy of a pendulum on a rod for 10 s, starting with the rod horizontal."""
    figure, axes = pyplot.subplots(figsize=(10, 5.6), layout="constrained")
    colors = {("explicit Euler", 60): RED, ("semi-implicit Euler", 60): SKY}
    colors |= {("semi-implicit Euler", 240): PINK, ("semi-implicit Euler", 960): BLACK}
    colors |= {("DirectChain", 60): GREEN}
    runs = {(name, rate): partial(energy, INTEGRATORS.get(name), rate) for name, rate in colors}
    found = written(runs)
    rows: list[Sequence[object]] = []
    words = []
    for (name, rate), run in found.items():
        label = f"{name}, {rate} Hz: {run.values[-1]:.4g} J at the end"
        axes.plot(run.times, run.values, color=colors[name, rate], lw=1.2, label=label)
        rows += [(name, rate, *row) for row in run.points]
        words.append(f"{100.0 * (run.values[-1] / run.values[0] - 1.0):+.3g} %")
    axes.set_title(
        "A pendulum of 1 m and 1 kg, released from horizontal: change in energy in 10 s, in the "
        f"order of the legend:\n{', '.join(words)}",
        fontsize=11,
    )
    axes.set(xlabel="time, s", ylabel="energy relative to the lowest point, J", ylim=(0.0, None))
    legends(axes)
    stopped = {f"{name}, {rate} Hz": run.message for (name, rate), run in found.items()}
    tell(figure, [f"{key}: {message}" for key, message in stopped.items() if message])
    return Picture(figure, ("method", "frame rate, Hz", "time, s", "energy, J"), rows)


def stretch(
    chain: Chain, link: Link | None, frames: int, iterations: int | None = None, substeps: int = 1
) -> tuple[Track, Track]:
    """Release a chain of rods, or a DirectChain if ``link`` is None.

    Return the excess length of the chain in m, and the largest error in the length of a rod.
    """
    setup = chain.setup(link)
    move = moving(setup, link and semi_implicit_euler, iterations, substeps)

    def off() -> list[float]:
        return chain.excess(setup.particles)

    whole, worst = tracks(move, [lambda: math.fsum(off()), lambda: max(map(abs, off()))], frames)
    return whole, worst


def energy(step: Integrator | None, rate: int) -> Track:
    """Record a pendulum's energy in J relative to the lowest point, for 10 s from horizontal.

    If ``step`` is None, the pendulum of 1 kg and 1 m is a DirectChain.
    """
    pendulum = Chain([1.0], 1.0, 0.5 * math.pi)
    setup = pendulum.setup()
    (bob,) = setup.particles
    speeds = [lambda: numbers(bob.velocity)[0], lambda: numbers(bob.velocity)[1]]
    measures = [lambda: numbers(bob.position)[1], *speeds]
    y, *parts = tracks(moving(setup, step), measures, 10 * rate, 1.0 / rate)
    velocities = [complex(*pair) for pair in zip(*(part.values for part in parts), strict=True)]
    if not step:  # a DirectChain has velocities halfway between two positions
        velocities[1:] = [0.5 * (v + w) for v, w in pairwise(velocities[1:])]
    pairs = zip(y.values, velocities, strict=False)
    energies = [pendulum.gravity * (1.0 + height) + 0.5 * abs(v) ** 2 for height, v in pairs]
    return Track(y.times[: len(energies)], energies, y.message)


def moving(
    setup: Setup, step: Integrator | None, iterations: int | None = None, substeps: int = 1
) -> Move:
    """Return what moves a chain: an integrator and a resolver, or DirectChain if there is none."""
    if not step:
        return DirectChain(setup.particles, Vector3()).step
    resolve = by_resolver(iterations)
    return resolving(step, setup.particles, setup.contacts, resolve, substeps=substeps)
