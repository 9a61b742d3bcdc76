"""Plots for chapter 8: the energy of scenes at rest, and how scenes react to uneven frames.

The title of each plot reports a measured result, such as the largest error, which reveals bugs in
the student's engine. A curve is omitted if the student has not yet solved its exercise. For cables
and ropes, see ropes.py. For the projects, see projects.py.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from matplotlib import pyplot

from ch08_mass_aggregate.blob import Blob
from ch08_mass_aggregate.bridge import Bridge
from plots.drawing import BLACK, BLUE, GRAY, ORANGE, RED, SKY, Picture, tell
from scenes.clock import FRAME
from scenes.mass_aggregate import (
    SPIKE,
    MassAggregate,
    default_bridge,
    energy,
    in_frames,
    loaded_platform,
    longest,
    uneven_frames,
    variation,
)
from scenes.readings import Numbers, numbers, written
from scenes.track import Track

SETTLED = 5.0  # s, after which scenes should be at rest
STEADY = 0.1  # %, by which the energy of a scene at rest may vary
SECONDS = 7.5  # s, the length of each run; the energies vary no more in longer runs
COLORS = {30: RED, 60: BLUE}  # by frame rate in Hz

Way = tuple[Callable[[], MassAggregate], int, str]  # with the frame rate and the color


def energy_of_bridge() -> Picture:
    """Plot the energy of the rope bridge at two frame rates, as it comes to rest under a ball.

    A third curve shows a run at 30 Hz with the default number of iterations.
    """
    ways: dict[str, Way] = {f"{rate} Hz": (Bridge, rate, color) for rate, color in COLORS.items()}
    ways["30 Hz, default iterations"] = (default_bridge, 30, ORANGE)
    return _energies("The bridge with its ball", ways)


def energy_of_platform() -> Picture:
    """Plot the energy of a loaded, tilting platform that comes to rest, at two frame rates."""
    ways: dict[str, Way] = {
        f"{rate} Hz": (loaded_platform, rate, color) for rate, color in COLORS.items()
    }
    return _energies("The platform with 5 kg at 3 m", ways)


def variable_frames() -> Picture:
    """Plot how a blob and a rope bridge react to uneven frames, including two frames of 0.5 s.

    For comparison, each scene also runs in even frames. In further runs, ``FixedStep`` divides the
    uneven frames into steps of equal length.
    """
    figure, panels = pyplot.subplots(1, 2, figsize=(13, 5.4), layout="constrained")
    spikes, seconds = (0.75, 1.75), 3.0
    rows: list[Sequence[object]] = []
    notes: list[str] = []
    colors = {"even frames": BLACK, "uneven frames, run 1": RED, "uneven frames, run 2": ORANGE}
    colors |= {"FixedStep, run 1": SKY, "FixedStep, run 2": BLUE}
    blob_scene = ("the blob", "height of its highest particle, m", Blob, _top_of_blob, max)
    bridge_scene = ("the bridge", "height of the ball, m", Bridge, _height_of_ball, min)
    scenes = zip(panels, (blob_scene, bridge_scene), strict=True)
    for axes, (what, ylabel, make, measure, extreme) in scenes:
        runs = {"even frames": ([FRAME] * round(seconds / FRAME), False)}
        for seed in (1, 2):
            frames = uneven_frames(seed, seconds, spikes)
            runs[f"uneven frames, run {seed}"] = (frames, False)
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
        raw = [height for name, height in reach.items() if name.startswith("uneven frames")]
        most = f"{max(off):.2g} m" if off else "?"
        axes.set_title(
            f"{what.capitalize()}: {'up' if extreme is max else 'down'} to "
            f"{reach.get('even frames', math.nan):.3g} m in even frames, to "
            f"{extreme(raw, default=math.nan):.3g} m in uneven frames;\n"
            f"FixedStep repeats the run in even frames with an error of {most}",
            fontsize=10,
        )
        for i, spike in enumerate(spikes):
            label = f"a frame of {SPIKE:g} s, near here" if i == 0 else None
            axes.axvspan(spike, spike + SPIKE, color=GRAY, alpha=0.15, lw=0, label=label)
        axes.set(xlabel="time, s", ylabel=ylabel)
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    tell(figure, notes)
    return Picture(figure, ("scene", "frames", "time, s", "height, m"), rows)


def _energies(what: str, ways: dict[str, Way]) -> Picture:
    """Plot the energy in several runs of a scene, and how much it varies once the scene is at rest.

    The second panel starts when the scene should be at rest. It shows how far the energy is from
    the middle of its range, in percent.
    """
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.2), layout="constrained")
    found = written({name: _energy_of(make, rate) for name, (make, rate, _) in ways.items()})
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
        label = f"{name}: varies by {varies[name]:.2g} %{fails}"
        right.plot([time for time, _ in late], off, color=color, lw=1.0, label=label)
        rows += [(name, *row) for row in run.points]
    half = 0.5 * STEADY
    right.axhspan(-half, half, color=GRAY, alpha=0.12, lw=0, label=f"allowed: {STEADY:g} %")
    starts = [run.values[0] for run in found.values()]
    ends = [run.values[-1] for run in found.values()]
    left.set_title(
        f"{what}: {starts[0]:.4g} J at the start, {min(ends):.4g} to {max(ends):.4g} J at rest",
        fontsize=10,
    )
    left.set_xlim(0.0, 5.0)
    if 0.0 < reach < math.inf:
        right.set_ylim(-1.3 * reach, 2.2 * reach)
    steady = "all energies vary" if not bad else f"all energies but {', '.join(bad)} vary"
    right.set_title(
        f"From {SETTLED:g} to {SECONDS:g} s, {steady} by less than {STEADY:g} %", fontsize=10
    )
    left.set(xlabel="time, s", ylabel="mechanical energy relative to the ground, J")
    right.set(xlabel="time, s", ylabel="deviation from the middle of the range, %")
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    tell(figure, [f"{name}: {run.message}" for name, run in found.items() if run.message])
    return Picture(figure, ("run", "time, s", "energy, J"), rows)


def _energy_of(make: Callable[[], MassAggregate], rate: int) -> Callable[[], Track]:
    return lambda: energy(make(), rate, SECONDS)


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
