"""Plots for chapter 8: a wheel of rods, a blob that breaks apart, and sleeping balls."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial

from matplotlib import pyplot

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import Detectors, GroundPlane, ParticlePairs
from ch08_mass_aggregate.blob import Blob, spread
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.wheel import COUNT, MASS, RADIUS, Wheel, deformation, spin
from ch08_mass_aggregate.world import ParticleWorld
from plots.ch08_mass_aggregate.energy import recorded
from plots.drawing import BLACK, BLUE, GREEN, ORANGE, RED, SKY, Picture, legends, tell
from scenes.clock import RATE, Track, tracks
from scenes.readings import written

FORCES = (1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0)  # N
DRIVE, SPINNING = 10.0, 2.0  # N and s, of the wheel whose spin is drawn
BALL_RADIUS, BALLS = 0.5, 8  # m, and the number of balls that fall asleep
LATE_HEIGHT = 40.0  # m, initial height of the ball that wakes them


def wheel_deformation() -> Picture:
    """Plot how far a driven wheel of rods deforms, and how far its spin lags behind theory."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.4), layout="constrained")

    def deformed(driven: int, force: float) -> Track:
        return recorded(partial(Wheel, force, driven), lambda w: deformation(w.rods), RATE, 1.0)

    def spun(rate: int) -> Track:
        return recorded(partial(Wheel, DRIVE), lambda w: spin(w.hub, w.rim), rate, SPINNING)

    ways = [(driven, force) for driven in (1, 2, COUNT) for force in FORCES]
    scenes = {rate: partial(spun, rate) for rate in (60, 240, 960)}
    scenes |= {way: partial(deformed, *way) for way in ways}
    both = written(scenes)
    rows: list[Sequence[object]] = []
    gives, lags = [], []
    for driven, color in ((1, RED), (2, ORANGE), (COUNT, BLUE)):
        forces = [force for force in FORCES if (driven, force) in both]
        worst = {force: max(both[driven, force].values) for force in forces}
        rows += [("deformation", driven, 60, force, 1.0, value) for force, value in worst.items()]
        if worst:
            label = f"{driven} driven"
            gives.append(f"{label} {100.0 * worst[FORCES[-1]]:.2g} %")
            shown = [max(100.0 * value, 1e-13) for value in worst.values()]
            left.loglog([*worst], shown, "o-", color=color, label=label)
    alpha = DRIVE * COUNT / (COUNT * MASS * RADIUS)
    times = [SPINNING * i / 100 for i in range(101)]
    right.plot(times, [alpha * t for t in times], color=BLACK, lw=1.2, label="F n t / (N m r)")
    for rate, color in ((60, RED), (240, ORANGE), (960, GREEN)):
        if (run := both.get(rate)) is None:
            continue
        ideal = alpha * run.times[-1]
        lag = 100.0 * (1.0 - run.values[-1] / ideal if ideal else math.nan)
        lags.append(f"{lag:.2g} % at {rate} Hz")
        right.plot(run.times, run.values, color=color, lw=1.5, label=f"{rate} Hz")
        # At this spin w, each frame loses as much spin as the drive adds. It loses the fraction
        # (w h)^2 / 2.
        limit = (2.0 * alpha * rate) ** (1.0 / 3.0)
        label = f"$\\sqrt[3]{{2 \\alpha / h}}$ = {limit:.3g} rad/s at {rate} Hz"
        right.axhline(limit, color=color, lw=1, ls=":", label=label)
        rows += [("spin", COUNT, rate, DRIVE, *row) for row in run.points]
    left.set_title(
        f"Worst rod in the first second, at {FORCES[-1]:g} N and 60 Hz:\n{', '.join(gives) or '?'}",
        fontsize=10,
    )
    right.set_title(
        f"{COUNT} particles driven by {DRIVE:g} N each: after {SPINNING:g} s\nthe spin lags by "
        f"{', '.join(lags) or '?'},\nbecause turning a rod costs speed",
        fontsize=10,
    )
    left.set(xlabel="force on each driven particle, N", ylabel="deformation, % of a rod")
    right.set(xlabel="time, s", ylabel="spin, rad/s", ylim=(0.0, 1.05 * alpha * SPINNING))
    legends(left, right)
    tell(figure, [run.message for run in both.values() if run.message])
    columns = ("what", "driven", "frame rate, Hz", "force, N", "time, s", "deformation or rad/s")
    return Picture(figure, columns, rows)


def blob_bonds() -> Picture:
    """Plot how far a blob that is thrown down spreads, and how many of its bonds survive."""
    figure, panels = pyplot.subplots(1, 2, figsize=(13, 5.4), layout="constrained")
    ways = {(0.0, False): BLACK, (18.0, False): SKY, (18.0, True): BLUE}
    ways |= {(25.0, False): ORANGE, (25.0, True): RED}

    def thrown(speed: float, cables: bool) -> Blob:
        blob = Blob(2.0, cables)
        for particle in blob.particles:
            particle.velocity = Vector3(0.0, -speed)
        return blob

    measures = {
        "spread": lambda blob: spread(blob.particles),
        "bonds": lambda blob: sum(bond.holds for bond in blob.bonds),
    }
    runs = {
        (what, *way): partial(recorded, partial(thrown, *way), measure, RATE, 5.0)
        for what, measure in measures.items()
        for way in ways
    }
    found = written(runs)
    rows: list[Sequence[object]] = []
    for axes, what, unit in zip(panels, measures, (" m", " bonds"), strict=True):
        for (speed, cables), color in ways.items():
            if (run := found.get((what, speed, cables))) is None:
                continue
            ended = f"at least {min(run.values):g}, finally {run.values[-1]:g}"
            if what == "spread":
                ended = f"at most {max(run.values):.2f} m, finally {run.values[-1]:.2f} m"
            throw = f"at {speed:g} m/s" if speed else "dropped"
            label = f"{throw}, {'with' if cables else 'without'} cables: {ended}"
            style = "--" if cables else "-"
            axes.plot(run.times, run.values, style, color=color, lw=1.4, label=label)
            rows += [(what, speed, cables, *row) for row in run.points]
        torn, held = (found.get((what, 25.0, cables)) for cables in (False, True))
        words = [f"{run.values[-1]:.2g}{unit}" if run else "?" for run in (torn, held)]
        axes.set_title(
            f"Thrown down at 25 m/s from 2 m: finally {words[0]}, with cables {words[1]}",
            fontsize=10,
        )
    panels[0].set(xlabel="time, s", ylabel="spread, m")
    panels[1].set(xlabel="time, s", ylabel="intact bonds, of 45")
    panels[0].set_ylim(top=1.25 * panels[0].get_ylim()[1])  # room for the legend
    legends(*panels)
    tell(figure, [f"{key}: {run.message}" for key, run in found.items() if run.message])
    return Picture(figure, ("what", "speed, m/s", "cables", "time, s", "spread, m or bonds"), rows)


def sleeping_balls() -> Picture:
    """Plot how many balls are moved, and contacts resolved, if balls at rest sleep or not."""
    figure, panels = pyplot.subplots(2, 1, figsize=(11, 6.4), layout="constrained", sharex=True)
    rows: list[Sequence[object]] = []
    costs, notes = [], []
    for kind, color in ((ParticleWorld, RED), (SleepingWorld, BLUE)):
        name = kind.__name__
        awake, used, energy = _sleepers(kind, 12.0)
        steps, resolved = math.fsum(awake.values[1:]), math.fsum(used.values[1:])
        costs.append(f"{name} {steps:,.0f} and {resolved:,.0f}")
        panels[0].plot(awake.times, awake.values, color=color, lw=1.6, label=f"{name}: balls awake")
        label = f"{name}: contacts resolved"
        panels[0].plot(used.times, used.values, ":", color=color, lw=1.2, label=label)
        joules = [value if value > 1e-9 else math.nan for value in energy.values]
        panels[1].semilogy(energy.times, joules, color=color, lw=1.2, label=name)
        columns = zip(awake.times, awake.values, used.values, energy.values, strict=True)
        rows += [(name, *row) for row in columns]
        notes += [f"{name}: {awake.message}"] * bool(awake.message)
    figure.suptitle(
        f"Sleeping balls cost nothing. Particles moved and contacts resolved:\n{'; '.join(costs)}",
        fontsize=11,
    )
    panels[0].set(ylabel="number per frame of 1/60 s")
    panels[1].set(xlabel="time, s", ylabel="kinetic energy of the awake balls, J")
    legends(*panels)
    tell(figure, notes)
    columns_of = ("world", "time, s", "balls awake", "contacts resolved", "kinetic energy, J")
    return Picture(figure, columns_of, rows)


def _sleepers(kind: type[ParticleWorld], seconds: float) -> list[Track]:
    """Record the balls awake, contacts resolved and energy in J; a late ball wakes two others."""
    down = Vector3(0.0, -9.81)
    places = [Vector3(1.2 * i, 2.0 * BALL_RADIUS + 0.6 * i) for i in range(BALLS)]
    places.append(Vector3(0.6 * (BALLS - 1) + 0.3, LATE_HEIGHT))
    balls = [Particle(place, acceleration=down, damping=0.5) for place in places]
    balls[-1].damping = 0.9
    detector = Detectors(GroundPlane(balls, radius=BALL_RADIUS), ParticlePairs(balls, BALL_RADIUS))
    world = kind(balls, [detector])

    def move(duration: float) -> None:
        world.resolver.iterations_used = 0  # the resolver is not called without contacts
        world.step(duration)

    measures = [
        lambda: len(balls) - (len(world.asleep) if isinstance(world, SleepingWorld) else 0),
        lambda: world.resolver.iterations_used,
        lambda: math.fsum(ball.kinetic_energy() for ball in balls if ball.inverse_mass),
    ]
    return tracks(move, measures, round(RATE * seconds))
