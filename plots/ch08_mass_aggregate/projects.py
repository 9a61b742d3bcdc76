"""Plots for chapter 8: a trebuchet, a wheel, a blob that breaks apart, and sleeping balls."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from matplotlib import pyplot
from matplotlib.axes import Axes

from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.trebuchet import Design, Trebuchet, my_design
from ch08_mass_aggregate.wheel import COUNT, MASS, RADIUS
from ch08_mass_aggregate.world import ParticleWorld
from plots.drawing import BLACK, BLUE, GRAY, GREEN, ORANGE, RED, SKY, Picture, tell
from scenes.mass_aggregate import (
    bonds_of_blob,
    deformation_of_wheel,
    sleepers,
    spin_of_wheel,
    spread_of_blob,
)
from scenes.readings import is_written, number, stopped, written
from scenes.releases import Release, jumps, releases

PLAIN = Design(400.0, 1.0, 4.0, 3.0, 45.0)  # drawn until my_design is written
FORCES = (1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0)


def trebuchet_range() -> Picture:
    """Plot the range of the student's trebuchet against its release angle.

    Each curve is for a different counterweight.
    """
    figure, (left, right) = pyplot.subplots(
        1, 2, figsize=(13, 5.4), layout="constrained", width_ratios=(3, 2)
    )
    named = {"my_design": my_design, "a plain design": lambda: PLAIN}
    name, design = next(iter(written(named).items()))
    own = design.counterweight
    weights = sorted({100.0, 200.0, 300.0, 400.0, own})
    found = written(
        {weight: partial(releases, replace(design, counterweight=weight)) for weight in weights}
    )
    rows: list[Sequence[object]] = []
    best: dict[float, Release] = {}
    for (weight, seen), color in zip(found.items(), (GRAY, SKY, GREEN, BLUE, RED), strict=False):
        rows += [(weight, r.angle, r.range, r.share) for r in seen]
        upwards = [release for release in seen if release.angle >= 0.0]
        ends = "never flies forward and up"
        if upwards:
            best[weight] = max(upwards, key=lambda release: release.range)
            ends = f"at best {best[weight].range:.3g} m at {best[weight].angle:.0f}$\\degree$"
        shown = jumps(upwards)
        angles, ranges = [r.angle for r in shown], [r.range for r in shown]
        size = 9 if len(shown) < 5 else 4  # so that a single release is visible
        label = f"{weight:g} kg: {ends}"
        left.plot(angles, ranges, ".-", color=color, ms=size, lw=1.3, label=label)
    thrown = _thrown(design)
    words = f"{name} ({own:g} kg) never releases the projectile"
    if thrown is not None:
        words = (
            f"{name} throws {thrown.range:.3g} m with {100.0 * thrown.share:.2g} % of the energy"
        )
        rows.append((own, design.release_angle, thrown.range, thrown.share))
        left.plot(design.release_angle, thrown.range, "*", color=BLACK, ms=15, label=name)
        right.plot(own, 100.0 * thrown.share, "*", color=BLACK, ms=15, label=name)
    left.set_title(
        f"{words};\nat its best angle it would throw {best[own].range:.3g} m"
        if own in best
        else words,
        fontsize=10,
    )
    right.plot(
        [*best], [100.0 * r.share for r in best.values()], "o-", color=BLUE, label="best angle"
    )
    for weight, release in best.items():
        right.annotate(
            f"{release.range:.0f} m",
            (weight, 100.0 * release.share),
            (5, 6),
            textcoords="offset points",
            fontsize=8,
        )
    most = [f"{kg:g} kg {100.0 * r.share:.0f} %" for kg, r in best.items()]
    right.set_title(f"Fraction of the energy at the best angle:\n{', '.join(most)}", fontsize=9)
    left.set(xlabel="release angle, degrees above the horizon", ylabel="range, m")
    left.set(xlim=(0.0, 90.0), ylim=(0.0, None))
    right.set(xlabel="counterweight, kg", ylabel="energy that reaches the projectile, %")
    right.set(xlim=(0.0, 1.25 * max(weights)), ylim=(0.0, 105.0))
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8.5)
    columns = ("counterweight, kg", "release angle, degrees", "range, m", "fraction of the energy")
    return Picture(figure, columns, rows)


def wheel_deformation() -> Picture:
    """Plot how far a driven wheel of rods deforms, and how far its spin lags behind theory."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.4), layout="constrained")
    deformations = {
        (driven, force): partial(deformation_of_wheel, force, driven, 60, 1.0)
        for driven in (1, 2, COUNT)
        for force in FORCES
    }
    spins = {rate: partial(spin_of_wheel, 10.0, COUNT, rate, 2.0) for rate in (60, 240, 960)}
    both = written({**deformations, **spins})
    rows: list[Sequence[object]] = []
    notes, gives = [], []
    for driven, color in ((1, RED), (2, ORANGE), (COUNT, BLUE)):
        worst = {
            force: max(both[driven, force].values) for force in FORCES if (driven, force) in both
        }
        rows += [("deformation", driven, 60, force, 1.0, value) for force, value in worst.items()]
        notes += [both[driven, force].message for force in worst if both[driven, force].message]
        if worst:
            label = f"{driven} driven"
            gives.append(f"{label} {100.0 * worst[FORCES[-1]]:.2g} %")
            shown = [max(100.0 * value, 1e-13) for value in worst.values()]
            left.loglog([*worst], shown, "o-", color=color, label=label)
    alpha = 10.0 * COUNT / (COUNT * MASS * RADIUS)
    times = [2.0 * i / 100 for i in range(101)]
    right.plot(times, [alpha * t for t in times], color=BLACK, lw=1.2, label="F n t / (N m r)")
    lags = []
    for rate, color in ((60, RED), (240, ORANGE), (960, GREEN)):
        if (run := both.get(rate)) is None:
            continue
        lag = 100.0 * (
            1.0 - run.values[-1] / (alpha * run.times[-1]) if run.times[-1] else math.nan
        )
        lags.append(f"{lag:.2g} % at {rate} Hz")
        right.plot(run.times, run.values, color=color, lw=1.5, label=f"{rate} Hz")
        # At this spin w, each frame loses as much spin as the drive adds. It loses the fraction
        # (w h)^2 / 2.
        limit = (2.0 * alpha * rate) ** (1.0 / 3.0)
        label = f"$\\sqrt[3]{{2 \\alpha / h}}$ = {limit:.3g} rad/s at {rate} Hz"
        right.axhline(limit, color=color, lw=1, ls=":", label=label)
        rows += [("spin", COUNT, rate, 10.0, *row) for row in run.points]
        notes += [run.message] * bool(run.message)
    left.set_title(
        f"Worst rod in the first second, at {FORCES[-1]:g} N and 60 Hz:\n{', '.join(gives) or '?'}",
        fontsize=10,
    )
    right.set_title(
        f"{COUNT} particles driven by 10 N each: after 2 s the spin lags by\n"
        f"{', '.join(lags) or '?'}, because turning a rod costs speed",
        fontsize=10,
    )
    left.set(xlabel="force on each driven particle, N", ylabel="deformation, % of a rod")
    right.set(xlabel="time, s", ylabel="spin, rad/s", ylim=(0.0, 1.05 * alpha * 2.0))
    for axes in (left, right):
        axes.grid(alpha=0.3)
        _legend(axes)
    tell(figure, notes)
    columns = ("what", "driven", "frame rate, Hz", "force, N", "time, s", "deformation or rad/s")
    return Picture(figure, columns, rows)


def blob_bonds() -> Picture:
    """Plot how far a blob of particles spreads on the ground, and how many of its bonds survive.

    The blob is dropped or thrown down at up to 25 m/s, with and without cables.
    """
    figure, panels = pyplot.subplots(1, 2, figsize=(13, 5.4), layout="constrained")
    ways = {(0.0, False): BLACK, (18.0, False): SKY, (18.0, True): BLUE}
    ways |= {(25.0, False): ORANGE, (25.0, True): RED}
    scenes = {("spread", *way): partial(spread_of_blob, *way, 5.0) for way in ways}
    scenes |= {("bonds", *way): partial(bonds_of_blob, *way, 5.0) for way in ways}
    found = written(scenes)
    rows: list[Sequence[object]] = []
    for axes, what in zip(panels, ("spread", "bonds"), strict=True):
        for (speed, cables), color in ways.items():
            if (run := found.get((what, speed, cables))) is None:
                continue
            throw = f"at {speed:g} m/s" if speed else "dropped"
            with_cables = "with cables" if cables else "without cables"
            if what == "spread":
                ended = f"at most {max(run.values):.2f} m, finally {run.values[-1]:.2f} m"
            else:
                ended = f"at least {min(run.values):g}, finally {run.values[-1]:g}"
            style = "--" if cables else "-"
            label = f"{throw}, {with_cables}: {ended}"
            axes.plot(run.times, run.values, style, color=color, lw=1.4, label=label)
            rows += [(what, speed, cables, *row) for row in run.points]
    for axes, what, unit in ((panels[0], "spread", " m"), (panels[1], "bonds", " bonds")):
        torn, held = (found.get((what, 25.0, cables)) for cables in (False, True))
        words = [f"{run.values[-1]:.2g}{unit}" if run else "?" for run in (torn, held)]
        axes.set_title(
            f"Thrown down at 25 m/s from 2 m: finally {words[0]}, with cables {words[1]}",
            fontsize=10,
        )
    panels[0].set(xlabel="time, s", ylabel="spread, m")
    panels[1].set(xlabel="time, s", ylabel="intact bonds, of 45")
    panels[0].set_ylim(top=1.25 * panels[0].get_ylim()[1])  # room for the legend
    for axes in panels:
        axes.grid(alpha=0.3)
        _legend(axes)
    tell(figure, [f"{key}: {run.message}" for key, run in found.items() if run.message])
    return Picture(figure, ("what", "speed, m/s", "cables", "time, s", "spread, m or bonds"), rows)


def sleeping_balls() -> Picture:
    """Plot how much work the engine saves by letting balls at rest sleep.

    The last ball arrives late and wakes all the others. The work in a frame is measured as the
    number of balls moved and the number of contacts resolved.
    """
    figure, panels = pyplot.subplots(2, 1, figsize=(11, 6.4), layout="constrained", sharex=True)
    kinds: dict[type[ParticleWorld], tuple[str, str]] = {
        ParticleWorld: ("ParticleWorld", RED),
        SleepingWorld: ("SleepingWorld", BLUE),
    }
    found = {kind: sleepers(kind, 12.0) for kind in kinds}
    rows: list[Sequence[object]] = []
    costs = []
    for kind, (awake, used, energy) in found.items():
        name, color = kinds[kind]
        steps, resolved = math.fsum(awake.values[1:]), math.fsum(used.values[1:])
        costs.append(f"{name} {steps:,.0f} and {resolved:,.0f}")
        panels[0].plot(awake.times, awake.values, color=color, lw=1.6, label=f"{name}: balls awake")
        panels[0].plot(
            used.times, used.values, ":", color=color, lw=1.2, label=f"{name}: contacts resolved"
        )
        joules = [value if value > 1e-9 else math.nan for value in energy.values]
        panels[1].semilogy(energy.times, joules, color=color, lw=1.2, label=name)
        columns = zip(awake.times, awake.values, used.values, energy.values, strict=True)
        rows += [(name, *row) for row in columns]
    figure.suptitle(
        f"Sleeping balls cost nothing. Particles moved and contacts resolved: {'; '.join(costs)}",
        fontsize=11,
    )
    panels[0].set(ylabel="number per frame of 1/60 s")
    panels[1].set(xlabel="time, s", ylabel="kinetic energy of the awake balls, J")
    for axes in panels:
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    tell(
        figure,
        [f"{kinds[kind][0]}: {runs[0].message}" for kind, runs in found.items() if runs[0].message],
    )
    columns_of = ("world", "time, s", "balls awake", "contacts resolved", "kinetic energy, J")
    return Picture(figure, columns_of, rows)


def _thrown(design: Design) -> Release | None:
    """Let a trebuchet of the student's engine throw, and return the result.

    The result is None if the trebuchet never releases the projectile, or if a part of it is not
    written yet.
    """
    found: list[Release] = []

    def run() -> None:
        throw = Trebuchet(design).throw()
        far, share = (number(getattr(throw, name, None)) for name in ("range", "share"))
        found.append(Release(design.release_angle, far, share))

    if not is_written(lambda: stopped(run)) or not found or not found[0].range > 0.0:
        return None
    return found[0]


def _legend(axes: Axes) -> None:
    if axes.get_legend_handles_labels()[0]:
        axes.legend(fontsize=8)
    else:
        axes.text(0.5, 0.5, "not written yet", transform=axes.transAxes, ha="center")
