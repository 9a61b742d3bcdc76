"""Plots for chapter 8: how accurate simulated ropes and bridge cables are, and at what cost."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial

from matplotlib import pyplot

from plots.ch08_mass_aggregate.energy import load_on_bridge
from plots.drawing import BLACK, BLUE, GRAY, ORANGE, PINK, RED, SKY, Picture, legends, tell
from scenes.clock import Track
from scenes.hanging_rope import (
    LENGTH,
    SPAN,
    Hanging,
    catenary,
    hang_by_direct_chain,
    hang_by_rods,
    polygon_sag,
)
from scenes.readings import tried, written

BOUND = 2.0  # %, allowed excess length of a cable
MANY, SECONDS = 30, 0.5  # links and s; a resolver takes far longer for more of either
THROUGH = 1e3  # %, where an infinite excess length is drawn


def mass_ratios() -> Picture:
    """Plot how far the cables of the rope bridge stretch under balls of 1 kg to 1 t."""
    figure, axes = pyplot.subplots(figsize=(10, 5.8), layout="constrained")
    ratios = (1, 10, 30, 100, 300, 1000)
    # Cases that take the longest and are accurate enough anyway are left out.
    ways: dict[str, tuple[int | None, int, tuple[int, ...], str]] = {
        "default iterations": (None, 1, ratios, RED),
        "200 iterations per phase": (200, 1, ratios, ORANGE),
        "default, 4 substeps": (None, 4, ratios, SKY),
        "default, 16 substeps": (None, 16, (1000,), BLUE),
    }
    runs = {
        (way, ratio): partial(load_on_bridge, float(ratio), iterations, substeps, 4.0)
        for way, (iterations, substeps, some, _) in ways.items()
        for ratio in some
    }
    found = written(runs)
    rows: list[Sequence[object]] = []
    words = []
    for way, (*_, some, color) in ways.items():
        seen = {ratio: found[way, ratio] for ratio in some if (way, ratio) in found}
        worst = {ratio: _late(run, 3.0) for ratio, (run, _) in seen.items()}
        rows += [(way, ratio, seen[ratio][1], value) for ratio, value in worst.items()]
        bad = [ratio for ratio, value in worst.items() if not value <= BOUND]
        ends = f"fails at {bad[0]}:1" if bad else f"holds at {max(worst, default=0)}:1"
        most = max((work for _, work in seen.values()), default=0)
        # Values without an error are drawn at the lower edge.
        shown = {ratio: min(max(value, 1e-3), THROUGH) for ratio, value in worst.items()}
        label = f"{way}: {ends} (up to {most:,} resolutions)"
        axes.loglog([*shown], [*shown.values()], "o-", color=color, label=label)
        axes.plot(bad, [shown[ratio] for ratio in bad], "x", color=BLACK, ms=11, mew=2)
        if 300 in worst:
            words.append(f"{way} {worst[300]:.2g} %")
    axes.plot([], [], "x", color=BLACK, ms=9, mew=2, label="fails")
    axes.axhline(THROUGH, color=GRAY, lw=1, ls=":", label="the ball has fallen through")
    axes.axhspan(BOUND, 1e6, color=GRAY, alpha=0.12, lw=0)
    axes.axhline(BOUND, color=GRAY, lw=1, ls="--", label=f"limit: {BOUND:g} %")
    axes.set_xticks(ratios, [f"{ratio}:1" for ratio in ratios])
    axes.set_xticks([], minor=True)
    axes.set_title(
        "The heavier the load on light planks, the longer the cables; excess length at 300:1:\n"
        f"{'; '.join(words)}",
        fontsize=11,
    )
    axes.set(xlabel="mass of the ball : mass of the end of a plank")
    axes.set(ylabel="excess length of the worst cable from 3 to 4 s, % (60 Hz)", ylim=(8e-4, 2e5))
    legends(axes, size=8.5, loc="upper left")
    tell(figure, [f"{key}: {run.message}" for key, (run, _) in found.items() if run.message])
    columns = ("method", "ball : plank's end", "resolutions", "excess length of the worst cable, %")
    return Picture(figure, columns, rows)


def hanging_rope() -> Picture:
    """Plot the error in the sag of a rope between two nails against the work of each method."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.8), layout="constrained")
    rods = {substeps: f"rods, {substeps} substep{'s' * (substeps > 1)}" for substeps in (1, 4, 16)}
    # A rope that starts at rest should stay there, and DirectChain keeps it there to 1e-8 m. So
    # DirectChain is also shown with a rope that starts in the shape of a V.
    direct, from_v = "DirectChain, 240 Hz", "DirectChain, 240 Hz, from a V for 8 s"
    scenes: dict[tuple[int, str], Callable[[], Hanging]] = {
        (links, name): partial(hang_by_rods, links, substeps, SECONDS)
        for links in (10, MANY)
        for substeps, name in rods.items()
    }
    scenes |= {
        (links, f"DirectChain, {rate} Hz"): partial(hang_by_direct_chain, links, rate, SECONDS)
        for links, rate in ((10, 60), (MANY, 60), (MANY, 240))
    }
    for links in (10, MANY):
        scenes[links, from_v] = partial(hang_by_direct_chain, links, 240, 8.0, True)
    tries = written({key: partial(tried, scene, None) for key, scene in scenes.items()})
    found = {key: hanging for key, (hanging, _) in tries.items() if hanging}
    errors = {key: hanging.sag - polygon_sag(key[0]) for key, hanging in found.items()}
    exact, xs = catenary(), [SPAN * i / 100 for i in range(101)]
    label = f"catenary: sag {-exact(0.5 * SPAN):.5f} m"
    left.plot(xs, [*map(exact, xs)], color=GRAY, lw=5, alpha=0.5, label=label)
    for color, name in zip((RED, ORANGE, PINK, BLACK), (*rods.values(), direct), strict=True):
        if rope := found.get((MANY, name)):
            label = f"{name}: sag {rope.sag:.5g} m, {abs(rope.stretch):.2g} m too long"
            left.plot(*zip(*rope.places, strict=True), color=color, lw=1.3, label=label)
    rows: list[Sequence[object]] = []
    looks = {("rods", 10): SKY, ("rods", MANY): RED}
    looks |= {("DirectChain", 10): BLUE, ("DirectChain", MANY): BLACK}
    for (kind, links), color in looks.items():
        keys = [key for key in found if key[0] == links and key[1].startswith(kind)]
        rows += [
            (*key, found[key].work, found[key].sag, errors[key], found[key].stretch) for key in keys
        ]
        if not keys:
            continue
        work = [found[key].work for key in keys]
        off = [max(abs(errors[key]), 1e-10) for key in keys]
        style = "o-" if kind == "rods" else "D"
        label = f"{kind}, {links} links: {min(off):.1g} to {max(off):.1g} m"
        right.loglog(work, off, style, color=color, label=label)
        for (_, name), spent, error in zip(keys, work, off, strict=True):
            words = name.removeprefix(f"{kind}, ").replace(", from", "\nfrom")
            above = kind == "rods" or ("\n" in words and links == MANY)
            offset = (6, 4) if above else (-2, -24 if "\n" in words else -16)
            right.annotate(words, (spent, error), offset, textcoords="offset points", fontsize=7.5)

    def sinks(links: int, name: str, digits: str = ".2g") -> str:
        return f"{errors[links, name]:{digits}}" if (links, name) in errors else "?"

    right.set_title(
        f"With 1 and 16 substeps, 10 links sink by {sinks(10, rods[1])} and {sinks(10, rods[16])} "
        f"m,\n{MANY} links by {sinks(MANY, rods[1])} and {sinks(MANY, rods[16])} m, "
        f"with DirectChain by {sinks(MANY, direct, '.1g')} m",
        fontsize=10,
    )
    longer = f"{found[MANY, rods[16]].stretch:.2g}" if (MANY, rods[16]) in found else "?"
    left.set_title(
        f"{MANY} links of {LENGTH / MANY:g} m, {SECONDS:g} s after a start at rest:\n"
        f"rods with 16 substeps are {longer} m too long",
        fontsize=10,
    )
    left.set(xlabel="position along the span, m", xlim=(-0.6, 2.6))
    left.set(ylabel="height relative to the nails, m", ylim=(-4.0, 1.5))
    right.set(xlabel="work: contacts resolved, or rods solved", xlim=(1.5e2, 1e6))
    right.set(ylabel="error of the sag, m (1e-10 or less at the edge)", ylim=(1e-11, 1e3))
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    tell(figure, [f"{key[0]} links, {key[1]}: {why}" for key, (_, why) in tries.items() if why])
    columns = ("links", "method", "work", "sag, m", "error of the sag, m", "excess length, m")
    return Picture(figure, columns, rows)


def _late(run: Track, since: float) -> float:
    """Find the largest value after ``since`` s, or infinity if the engine raised an exception."""
    late = [value for time, value in run.points if time >= since]
    return max(late, default=math.inf) if not run.message else math.inf
