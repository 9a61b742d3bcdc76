"""Pictures of chapter 8: rest, loads, a hanging rope and uneven frames, measured on the engine.

Titles give what is measured: a wrong engine cannot hide. What is not written yet is left out where
there is something else to see. The scenes of the projects are in plots_of_scenes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from matplotlib import pyplot
from matplotlib.axes import Axes

from ch08_mass_aggregate.blob import Blob
from ch08_mass_aggregate.bridge import Bridge
from ch08_mass_aggregate.plots_of_scenes import (
    blob_bonds,
    sleeping_balls,
    trebuchet_range,
    wheel_deformation,
)
from studies.constraints import Track
from studies.drawing import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    PINK,
    RED,
    SKY,
    Numbers,
    Picture,
    numbers,
    stopped,
    tell,
    written,
)
from studies.mass_aggregate import (
    FRAME,
    SPIKE,
    MassAggregate,
    default_bridge,
    energy,
    in_frames,
    load_on_bridge,
    loaded_platform,
    longest,
    uneven_frames,
    variation,
)
from studies.ropes import (
    LENGTH,
    SPAN,
    Hanging,
    catenary_radius,
    catenary_sag,
    hang_by_direct_chain,
    hang_by_rods,
    polygon_sag,
)

SETTLED = 10.0  # s: from when on scenes are to rest
STEADY = 0.1  # %: by how much the energy of what rests may vary
BOUND = 2.0  # %: by how much a cable may be too long
THROUGH = 1e3  # %, where a picture has what is infinitely too long
# How each rate is drawn, and for how many seconds: 120 Hz take longest, and are stillest.
RATES = {30: (RED, 30.0), 60: (BLUE, 30.0), 120: (GREEN, 15.0)}

Way = tuple[Callable[[], MassAggregate], int, float, str]  # with Hz, seconds, color


def energy_of_bridge() -> Picture:
    """The energy of the bridge, at three frame rates, and with the resolver's own iterations."""
    ways: dict[str, Way] = {
        f"{rate} Hz": (Bridge, rate, seconds, color) for rate, (color, seconds) in RATES.items()
    }
    ways["30 Hz, default iterations"] = (default_bridge, 30, 30.0, ORANGE)
    return _energies("The bridge with its ball", ways)


def energy_of_platform() -> Picture:
    """The energy of the tilting platform under a weight, at three frame rates."""
    ways: dict[str, Way] = {
        f"{rate} Hz": (loaded_platform, rate, seconds, color)
        for rate, (color, seconds) in RATES.items()
    }
    return _energies("The platform with 5 kg at 3 m", ways)


def mass_ratios() -> Picture:
    """How much too long the bridge's cables are under balls of 1 kg to 1 t, by what is spent."""
    figure, axes = pyplot.subplots(figsize=(10, 5.8), layout="constrained")
    ratios = (1, 10, 30, 100, 300, 1000)
    # Left out is what takes longest and is good enough anyway.
    ways: dict[str, tuple[int | None, int, tuple[int, ...], str]] = {
        "default iterations": (None, 1, ratios, RED),
        "200 iterations a phase": (200, 1, ratios, ORANGE),
        "default, 4 substeps": (None, 4, ratios, SKY),
        "default, 16 substeps": (None, 16, (1000,), BLUE),
    }
    found = written(
        {
            (way, ratio): partial(load_on_bridge, float(ratio), iterations, substeps, 4.0)
            for way, (iterations, substeps, some, _) in ways.items()
            for ratio in some
        }
    )
    rows: list[Sequence[object]] = []
    words = []
    for way, (*_, some, color) in ways.items():
        seen = {ratio: found[way, ratio] for ratio in some if (way, ratio) in found}
        worst = {ratio: _late(run, 3.0) for ratio, (run, _) in seen.items()}
        rows += [(way, ratio, seen[ratio][1], value) for ratio, value in worst.items()]
        bad = [ratio for ratio, value in worst.items() if not value <= BOUND]
        ends = f"fails at {bad[0]}:1" if bad else f"holds at {max(worst, default=0)}:1"
        most = max((work for _, work in seen.values()), default=0)
        # What is right to the last digit has its place at the lower edge.
        shown = {ratio: min(max(value, 1e-3), THROUGH) for ratio, value in worst.items()}
        label = f"{way}: {ends} (up to {most:,} resolutions)"
        axes.loglog(*zip(*shown.items(), strict=True), "o-", color=color, label=label)
        axes.plot(bad, [shown[ratio] for ratio in bad], "x", color=BLACK, ms=11, mew=2)
        if 300 in worst:
            words.append(f"{way} {worst[300]:.2g} %")
    axes.plot([], [], "x", color=BLACK, ms=9, mew=2, label="fails")
    axes.axhline(THROUGH, color=GREY, lw=1, ls=":", label="the ball has fallen through")
    axes.axhspan(BOUND, 1e6, color=GREY, alpha=0.12, lw=0)
    axes.axhline(BOUND, color=GREY, lw=1, ls="--", label=f"{BOUND:g} %: more is a fail")
    axes.set_ylim(8e-4, 2e5)
    axes.set_xticks(ratios, [f"{ratio}:1" for ratio in ratios])
    axes.set_xticks([], minor=True)
    axes.set_title(
        "The heavier the load on light planks, the worse the cables hold it; too long at 300:1:\n"
        f"{'; '.join(words)}",
        fontsize=11,
    )
    axes.set(xlabel="mass of the ball to that of a plank's end")
    axes.set_ylabel("worst cable too long by, %, from 3 to 4 s (60 Hz)")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8.5, loc="upper left")
    notes = [f"{key}: {run.message}" for key, (run, _) in found.items() if run.message]
    tell(figure, notes)
    return Picture(
        figure, ("way", "ball to plank's end", "resolutions", "worst cable too long by, %"), rows
    )


def hanging_rope() -> Picture:
    """A rope between two nails: how far it sinks below where it should hang, and the work."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.8), layout="constrained")
    # From rest, where a rope should stay; DirectChain also from a V, as it stays at rest to 1e-8 m.
    scenes: dict[tuple[int, str], Callable[[], Hanging]] = {
        (links, f"rods, {substeps} substep{'s' * (substeps > 1)}"): partial(
            hang_by_rods, links, 60, substeps, 1.0
        )
        for links in (10, 100)
        for substeps in (1, 4, 16)
    }
    for links, rate in ((10, 60), (100, 60), (100, 240)):
        scenes[links, f"DirectChain, {rate} Hz"] = partial(hang_by_direct_chain, links, rate, 1.0)
    for links in (10, 100):
        name = "DirectChain, 240 Hz, from a V for 8 s"
        scenes[links, name] = partial(hang_by_direct_chain, links, 240, 8.0, True)
    notes: list[str] = []
    hung = written({key: _ended(scene, key, notes) for key, scene in scenes.items()})
    found = {key: hanging for key, hanging in hung.items() if hanging is not None}
    a = catenary_radius()
    xs = [SPAN * i / 100 for i in range(101)]
    ys = [a * (math.cosh((x - 0.5 * SPAN) / a) - math.cosh(0.5 * SPAN / a)) for x in xs]
    left.plot(xs, ys, color=GREY, lw=5, alpha=0.5, label=f"catenary: sag {catenary_sag():.5f} m")
    for color, substeps in ((RED, "1 substep"), (ORANGE, "4 substeps"), (PINK, "16 substeps")):
        _shape(left, found.get((100, f"rods, {substeps}")), f"rods, {substeps}", color)
    direct = found.get((100, "DirectChain, 240 Hz"))
    _shape(left, direct, "DirectChain, 240 Hz", BLACK)
    rows: list[Sequence[object]] = []
    looks = (("rods", 10, SKY), ("rods", 100, RED), ("DirectChain", 10, BLUE))
    for kind, links, color in (*looks, ("DirectChain", 100, BLACK)):
        points = []
        for (count, name), hanging in found.items():
            if count == links and name.startswith(kind):
                error = hanging.sag - polygon_sag(links)
                rows.append((links, name, hanging.work, hanging.sag, error, hanging.stretch))
                points.append((hanging.work, max(abs(error), 1e-10), name))
        if points:
            work, errors, _ = zip(*points, strict=True)
            style = "o-" if kind == "rods" else "D"
            label = f"{kind}, {links} links: {min(errors):.1g} to {max(errors):.1g} m"
            right.loglog(work, errors, style, color=color, label=label)
            for spent, error, name in points:
                words = name.removeprefix(f"{kind}, ").replace(", from", "\nfrom")
                offset = (6, 4) if kind == "rods" else (-2, -24 if "\n" in words else -16)
                right.annotate(
                    words, (spent, error), offset, textcoords="offset points", fontsize=7.5
                )
    sinks = [_sinks(found, 10, s) for s in (1, 16)]
    deep = [_sinks(found, 100, s) for s in (1, 16)]
    stays = "?" if direct is None else f"{direct.sag - polygon_sag(100):.1g}"
    right.set_title(
        f"With 1 and 16 substeps 10 links sink by {sinks[0]} and {sinks[1]} m,\n"
        f"100 links by {deep[0]} and {deep[1]} m; by DirectChain by {stays} m",
        fontsize=10,
    )
    left.set_title(
        f"100 links of {LENGTH / 100:g} m, 1 s after they hung at rest:\n"
        f"rods with 16 substeps are too long by {_stretch(found, 100, 16)} m",
        fontsize=10,
    )
    left.set(xlabel="place along the span, m", ylabel="height, m, from the nails")
    right.set(xlabel="work: contacts resolved, or rods solved for")
    right.set_ylabel("sag off that of the links at rest, m (1e-10 or less at the edge)")
    left.set(xlim=(-0.6, 2.6), ylim=(-4.0, 1.5))
    right.set(xlim=(3e2, 4e6), ylim=(1e-11, 1e4))
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    tell(figure, notes)
    columns = ("links", "way", "work", "sag, m", "sag less that at rest, m", "too long by, m")
    return Picture(figure, columns, rows)


def variable_frames() -> Picture:
    """A blob and a bridge in frames of any time, two of them of half a second, and in even ones."""
    figure, panels = pyplot.subplots(1, 2, figsize=(13, 5.4), layout="constrained")
    spikes, seconds = (1.0, 2.5), 4.0
    rows: list[Sequence[object]] = []
    notes: list[str] = []
    colors = {"even frames": BLACK, "as they come, run 1": RED, "as they come, run 2": ORANGE}
    colors |= {"FixedStep, run 1": SKY, "FixedStep, run 2": BLUE}
    blob_scene = ("the blob", "height of its highest particle, m", Blob, _top_of_blob, max)
    bridge_scene = ("the bridge", "height of the ball, m", Bridge, _height_of_ball, min)
    scenes = zip(panels, (blob_scene, bridge_scene), strict=True)
    for axes, (what, ylabel, make, measure, extreme) in scenes:
        runs = {"even frames": ([FRAME] * round(seconds / FRAME), False)}
        for seed in (1, 2):
            frames = uneven_frames(seed, seconds, spikes)
            runs[f"as they come, run {seed}"] = (frames, False)
            runs[f"FixedStep, run {seed}"] = (frames, True)
        found = written({name: _framed(make, *run, measure) for name, run in runs.items()})
        even = dict(found["even frames"][1]) if "even frames" in found else {}
        off = []
        for name, (run, states) in found.items():
            fixed = name.startswith("FixedStep")
            style = "." if fixed else "-"
            axes.plot(run.times, run.values, style, color=colors[name], ms=4, lw=1.3, label=name)
            rows += [(what, name, *row) for row in run.points]
            if run.message:
                notes.append(f"{what}, {name}: {run.message}")
            if fixed:
                off += [longest(now, even[steps]) for steps, now in states if steps in even]
        reach = {name: extreme(run.values) for name, (run, _) in found.items()}
        raw = [height for name, height in reach.items() if name.startswith("as they come")]
        most = f"{max(off):.2g} m" if off else "?"
        axes.set_title(
            f"{what.capitalize()}: {'up' if extreme is max else 'down'} to "
            f"{reach.get('even frames', math.nan):.3g} m in even frames, to "
            f"{extreme(raw, default=math.nan):.3g} m as they come;\n"
            f"by FixedStep the run in even frames, off by {most}",
            fontsize=10,
        )
        for i, spike in enumerate(spikes):
            label = f"frames of {SPIKE:g} s, about here" if i == 0 else None
            axes.axvspan(spike, spike + SPIKE, color=GREY, alpha=0.15, lw=0, label=label)
        axes.set(xlabel="time, s", ylabel=ylabel)
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    tell(figure, notes)
    return Picture(figure, ("scene", "frames", "time, s", "height, m"), rows)


PLOTS: tuple[Callable[[], Picture], ...] = (
    energy_of_bridge,
    energy_of_platform,
    mass_ratios,
    hanging_rope,
    variable_frames,
    trebuchet_range,
    wheel_deformation,
    blob_bonds,
    sleeping_balls,
)


def _energies(what: str, ways: dict[str, Way]) -> Picture:
    """Draw energies over time, and by how many percent they differ from the last when at rest."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.2), layout="constrained")
    found = written(
        {name: _energy_of(make, rate, time) for name, (make, rate, time, _) in ways.items()},
    )
    varies = {name: 100.0 * variation(run, SETTLED) for name, run in found.items()}
    bad = [name for name, percent in varies.items() if not percent <= STEADY]
    rows: list[Sequence[object]] = []
    reach = 0.0
    for name, run in found.items():
        color = ways[name][-1]
        fails = ": fails" if name in bad else ""
        left.plot(run.times, run.values, color=color, lw=1.2, label=name)
        late = [(t, e) for t, e in run.points if t >= SETTLED]
        energies = [e for _, e in late]
        middle = 0.5 * (max(energies, default=0.0) + min(energies, default=0.0))
        off = [100.0 * (e / middle - 1.0) if middle else math.nan for e in energies]
        reach = max([reach, *map(abs, off)])
        label = f"{name}, to {run.times[-1]:.0f} s: varies by {varies[name]:.2g} %{fails}"
        right.plot([time for time, _ in late], off, color=color, lw=1.0, label=label)
        rows += [(name, *row) for row in run.points]
    half = 0.5 * STEADY
    right.axhspan(-half, half, color=GREY, alpha=0.12, lw=0, label=f"grey: {STEADY:g} %")
    starts = [run.values[0] for run in found.values()]
    ends = [run.values[-1] for run in found.values()]
    left.set_title(
        f"{what}: from {starts[0]:.4g} J to rest at {min(ends):.4g} to {max(ends):.4g} J",
        fontsize=10,
    )
    left.set_xlim(0.0, 5.0)
    if 0.0 < reach < math.inf:
        right.set_ylim(-1.3 * reach, 2.2 * reach)
    steady = "all vary" if not bad else f"all but {', '.join(bad)} vary"
    right.set_title(f"From {SETTLED:g} s on {steady} by less than {STEADY:g} %", fontsize=10)
    left.set(xlabel="time, s", ylabel="mechanical energy, J, from the ground")
    right.set(xlabel="time, s", ylabel="energy off the middle of its range, %")
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    tell(figure, [f"{name}: {run.message}" for name, run in found.items() if run.message])
    return Picture(figure, ("way", "time, s", "energy, J"), rows)


def _energy_of(make: Callable[[], MassAggregate], rate: int, seconds: float) -> Callable[[], Track]:
    return lambda: energy(make(), rate, seconds)


def _late(run: Track, since: float) -> float:
    """Return the largest value from a time on, infinite where the engine failed before."""
    late = [value for time, value in run.points if time >= since]
    return max(late, default=math.inf) if not run.message else math.inf


def _ended(
    scene: Callable[[], Hanging], key: tuple[int, str], notes: list[str]
) -> Callable[[], Hanging | None]:
    """Return a scene that gives None, and a note, where the engine says that it failed."""

    def run() -> Hanging | None:
        hung: list[Hanging] = []
        message = stopped(lambda: hung.append(scene()))
        if message:
            notes.append(f"{key[0]} links, {key[1]}: {message}")
        return hung[0] if hung else None

    return run


def _shape(axes: Axes, hanging: Hanging | None, name: str, color: str) -> None:
    if hanging is not None:
        label = f"{name}: sag {hanging.sag:.5g} m, too long by {abs(hanging.stretch):.2g} m"
        axes.plot(*zip(*hanging.places, strict=True), color=color, lw=1.3, label=label)


def _sinks(found: dict[tuple[int, str], Hanging], links: int, substeps: int) -> str:
    name = f"rods, {substeps} substep{'s' * (substeps > 1)}"
    hanging = found.get((links, name))
    return "?" if hanging is None else f"{hanging.sag - polygon_sag(links):.2g}"


def _stretch(found: dict[tuple[int, str], Hanging], links: int, substeps: int) -> str:
    hanging = found.get((links, f"rods, {substeps} substeps"))
    return "?" if hanging is None else f"{hanging.stretch:.2g}"


def _framed(
    make: Callable[[], Any], frames: list[float], fixed: bool, measure: Callable[[Any], float]
) -> Callable[[], tuple[Track, list[tuple[int, list[Numbers]]]]]:
    def scene() -> tuple[Track, list[tuple[int, list[Numbers]]]]:
        made = make()
        return in_frames(made, frames, lambda: measure(made), fixed)

    return scene


def _top_of_blob(blob: Blob) -> float:
    return max(numbers(particle.position)[1] for particle in blob.particles)


def _height_of_ball(bridge: Bridge) -> float:
    return numbers(bridge.ball.position)[1]
