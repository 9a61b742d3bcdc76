"""Plots for chapter 8: the energy of scenes at rest, and how scenes react to uneven frames."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from matplotlib import pyplot

from ch08_mass_aggregate.blob import Blob
from ch08_mass_aggregate.bridge import Bridge
from ch08_mass_aggregate.fixed_step import FixedStep
from ch08_mass_aggregate.tilting_platform import TiltingPlatform
from ch08_mass_aggregate.world import mechanical_energy
from plots.drawing import BLACK, BLUE, GRAY, ORANGE, RED, SKY, Picture, legends, tell
from scenes.clock import FRAME, RATE, Track, track
from scenes.links import over_length
from scenes.readings import Numbers, number, numbers, stopped, written

SETTLED = 5.0  # s, after which scenes should be at rest
STEADY = 0.1  # %, how much the energy of a scene at rest may vary
SECONDS = 7.5  # s, the length of each run; the energies vary no more in longer runs
COLORS = {30: RED, 60: BLUE}  # by frame rate in Hz
FRAMED = 3.0  # s, the length of a run in uneven frames
SPIKES, SPIKE = (0.75, 1.75), 0.5  # s; at these times a frame takes that long

Make = Callable[[], Any]  # creates a mass aggregate of chapter 8, such as the rope bridge
Measure = Callable[[Any], float]
Framed = tuple[Track, dict[int, list[Numbers]]]


def recorded(make: Make, measure: Measure, rate: float, seconds: float) -> Track:
    """Simulate a mass aggregate, and record a value after each step."""
    made = make()
    return track(made.step, lambda: measure(made), round(rate * seconds), 1.0 / rate)


def load_on_bridge(
    mass: float, iterations: int | None, substeps: int, seconds: float
) -> tuple[Track, int]:
    """Record the excess length of a loaded bridge's worst cable in percent.

    It is infinite once the ball has fallen through. Also return the number of contacts resolved.
    """
    bridge = Bridge(mass)
    bridge.world.resolver.iterations = iterations
    work = 0

    def move(duration: float) -> None:
        nonlocal work
        for _ in range(substeps):
            bridge.step(duration / substeps)
            work += bridge.world.resolver.iterations_used

    def excess() -> float:
        lowest = min(numbers(end.position)[1] for row in bridge.rows for end in row)
        return over_length(bridge.links) if height_of_ball(bridge) > lowest else math.inf

    return track(move, excess, round(seconds / FRAME)), work


def energy_of_bridge() -> Picture:
    """Plot the energy of the rope bridge as it comes to rest, also with fewer iterations."""

    def default_bridge() -> Bridge:
        bridge = Bridge()
        bridge.world.resolver.iterations = None
        return bridge

    default = {"30 Hz, default iterations": (default_bridge, 30, ORANGE)}
    return _energies("The bridge with its ball", Bridge, default)


def energy_of_platform() -> Picture:
    """Plot the energy of a loaded, tilting platform that comes to rest, at two frame rates."""

    def loaded_platform() -> TiltingPlatform:
        platform = TiltingPlatform()
        platform.put_weight(5.0, 3.0)
        return platform

    return _energies("The platform with 5 kg at 3 m", loaded_platform, {})


def _energies(what: str, make: Make, more: dict[str, tuple[Make, int, str]]) -> Picture:
    """Plot the energy of a scene by frame rate, and how much it varies once at rest."""
    ways = {f"{rate} Hz": (make, rate, color) for rate, color in COLORS.items()} | more
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.2), layout="constrained")

    def energy(made: Any) -> float:
        return mechanical_energy(made.world.particles)

    runs = {name: partial(recorded, way[0], energy, way[1], SECONDS) for name, way in ways.items()}
    found = written(runs)
    rows: list[Sequence[object]] = []
    bad, reach = [], 0.0
    for name, run in found.items():
        times = [time for time in run.times if time >= SETTLED]
        energies = run.values[len(run.times) - len(times) :]
        lowest, highest = min(energies, default=0.0), max(energies, default=0.0)
        middle = 0.5 * (highest + lowest)
        off = [100.0 * (e / middle - 1.0) if middle else math.nan for e in energies]
        reach = max([reach, *map(abs, off)])
        varies = math.nan  # if the engine failed
        if not run.message and energies and energies[-1]:
            varies = 100.0 * ((highest - lowest) / abs(energies[-1]))
        if not varies <= STEADY:
            bad.append(name)
        color = ways[name][-1]
        left.plot(run.times, run.values, color=color, lw=1.2, label=name)
        label = f"{name}: varies by {varies:.2g} %{': fails' if name in bad else ''}"
        right.plot(times, off, color=color, lw=1.0, label=label)
        rows += [(name, *row) for row in run.points]
    half = 0.5 * STEADY
    right.axhspan(-half, half, color=GRAY, alpha=0.12, lw=0, label=f"allowed: {STEADY:g} %")
    start = next(iter(found.values())).values[0]
    ends = [run.values[-1] for run in found.values()]
    left.set_title(
        f"{what}: {start:.4g} J at the start, {min(ends):.4g} to {max(ends):.4g} J at rest",
        fontsize=10,
    )
    left.set_xlim(0.0, 5.0)
    if 0.0 < reach < math.inf:
        right.set_ylim(-1.3 * reach, 2.2 * reach)
    steady = "all energies vary" if not bad else f"all energies but {', '.join(bad)} vary"
    right.set_title(
        f"From {SETTLED:g} to {SECONDS:g} s,\n{steady} by less than {STEADY:g} %", fontsize=10
    )
    left.set(xlabel="time, s", ylabel="mechanical energy relative to the ground, J")
    right.set(xlabel="time, s", ylabel="deviation from the middle of the range, %")
    legends(left, right)
    tell(figure, [f"{name}: {run.message}" for name, run in found.items() if run.message])
    return Picture(figure, ("run", "time, s", "energy, J"), rows)


def variable_frames() -> Picture:
    """Plot how a blob and a rope bridge react to even and uneven frames, and with ``FixedStep``."""
    figure, panels = pyplot.subplots(1, 2, figsize=(13, 5.4), layout="constrained")
    rows: list[Sequence[object]] = []
    notes: list[str] = []
    colors = {"even frames": BLACK, "uneven frames, run 1": RED, "uneven frames, run 2": ORANGE}
    colors |= {"FixedStep, run 1": SKY, "FixedStep, run 2": BLUE}
    scenes = (
        ("the blob", "height of its highest particle, m", Blob, top_of_blob, max),
        ("the bridge", "height of the ball, m", Bridge, height_of_ball, min),
    )
    for axes, (what, ylabel, make, measure, extreme) in zip(panels, scenes, strict=True):
        runs = {"even frames": partial(_framed, make, measure, [FRAME] * round(RATE * FRAMED))}
        for seed in (1, 2):
            frames = _uneven_frames(seed)
            runs[f"uneven frames, run {seed}"] = partial(_framed, make, measure, frames)
            runs[f"FixedStep, run {seed}"] = partial(_framed, make, measure, frames, fixed=True)
        found = written(runs)
        even = found["even frames"][1] if "even frames" in found else {}
        off = []
        for name, (run, states) in found.items():
            fixed = name.startswith("FixedStep")
            style = "." if fixed else "-"
            axes.plot(run.times, run.values, style, color=colors[name], ms=4, lw=1.3, label=name)
            rows += [(what, name, *row) for row in run.points]
            if run.message:
                notes.append(f"{what}, {name}: {run.message}")
            if fixed:
                off += [max(map(math.dist, now, even[n])) for n, now in states.items() if n in even]
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
        for i, spike in enumerate(SPIKES):
            label = f"a frame of {SPIKE:g} s, near here" if i == 0 else None
            axes.axvspan(spike, spike + SPIKE, color=GRAY, alpha=0.15, lw=0, label=label)
        axes.set(xlabel="time, s", ylabel=ylabel)
    legends(*panels)
    tell(figure, notes)
    return Picture(figure, ("scene", "frames", "time, s", "height, m"), rows)


def _uneven_frames(seed: int) -> list[float]:
    """Create random frame durations from 5 to 30 ms, with a longer one at each of the SPIKES."""
    rng = random.Random(seed)
    frames, time, left = [], 0.0, [*SPIKES]
    while time < FRAMED:
        if left and time >= left[0]:
            frames.append(SPIKE)
            left.pop(0)
        else:
            frames.append(rng.uniform(0.005, 0.03))
        time += frames[-1]
    return frames


def _framed(make: Make, measure: Measure, frames: list[float], *, fixed: bool = False) -> Framed:
    """Record a value, and all positions by the number of steps, in uneven frames."""
    made = make()
    times, values, states = [0.0], [], {}

    def one_step(elapsed: float) -> int:
        made.step(elapsed)
        return 1

    advance = FixedStep(made.step, FRAME).advance if fixed else one_step

    def look(steps: int) -> None:
        values.append(number(measure(made)))
        states[steps] = [numbers(particle.position) for particle in made.world.particles]

    def run() -> None:
        steps = 0
        for elapsed in frames:
            steps += advance(elapsed)
            look(steps)
            times.append(times[-1] + elapsed)

    look(0)
    message = stopped(run)
    return Track(times, values[: len(times)], message), states


def top_of_blob(blob: Blob) -> float:
    return max(numbers(particle.position)[1] for particle in blob.particles)


def height_of_ball(bridge: Bridge) -> float:
    return numbers(bridge.ball.position)[1]
