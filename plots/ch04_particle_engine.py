"""Plots for chapter 4: shots, all types of fireworks, and the error of the book's integrator."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from matplotlib import pyplot
from matplotlib.axes import Axes

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.ballistics import MUZZLE, SHOT_TYPES, BallisticRange
from ch04_particle_engine.closed_form import state_after
from ch04_particle_engine.fireworks import FireworksShow
from plots import drawing
from plots.drawing import BLACK, BLUE, GRAY, GREEN, ORANGE, PINK, RED, Picture, finish, slope
from scenes.clock import FRAME
from scenes.flight import flown
from scenes.readings import Numbers, numbers
from scenes.shots_and_sparks import WHEEL_SPARK, firework_rules, flight_of, make_wheel, shot_names

SHOT_COLORS = {  # pink for a shot type that the student has added
    **dict.fromkeys(SHOT_TYPES, PINK),
    **{"pistol": BLACK, "artillery": GREEN, "fireball": ORANGE, "laser": RED, "grenade": BLUE},
}
# One color for each of the eleven types, and one for the sparks of the wheel.
SPARK_COLORS = (
    *(drawing.YELLOW, ORANGE, drawing.SKY, PINK, drawing.YELLOW, RED),
    *(drawing.SKY, GREEN, "white", PINK, GREEN, ORANGE),
)
LONGEST = 600  # frames, enough for every shot to land and every firework to burn out


def shots() -> Picture:
    """Draw the path of each type of shot, and plot how much of its energy each shot keeps."""
    figure, (paths, energies) = pyplot.subplots(
        2, 1, figsize=(9, 7), height_ratios=(2, 1), layout="constrained"
    )
    rows = []
    kept = {}
    for name in shot_names():
        type, color = SHOT_TYPES[name], SHOT_COLORS[name]
        first = _energy(name, type.velocity, MUZZLE[1])
        found = [
            (name, kind, (i + 1) * FRAME, *p, _energy(name, v, p[1]) / first)
            for i, pieces in enumerate(_flight(name))
            for kind, p, v in pieces
        ]
        rows += found
        whole = [row for row in found if row[1] == name]
        parts = [row for row in found if row[1] != name]
        speed = math.hypot(*type.velocity)
        label = f"{name}: {type.mass:g} kg, {speed:.3g} m/s, {0.5 * type.mass * speed**2:,.0f} J"
        paths.plot([r[5] for r in whole], [r[4] for r in whole], color=color, label=label)
        paths.plot([r[5] for r in parts], [r[4] for r in parts], ".", ms=1.5, color=color)
        energies.plot([r[2] for r in whole], [100.0 * r[6] for r in whole], color=color)
        kept[name] = 100.0 * whole[-1][6] if whole else math.nan
    k = -math.log(SHOT_TYPES["laser"].damping)
    times = [i * 0.1 for i in range(21)]
    # For a shot without gravity, drag leaves the fraction d^2t of the kinetic energy.
    exact = [100.0 * math.exp(-2.0 * k * t) for t in times]
    energies.plot(times, exact, **drawing.THEORY, label="theory without gravity, d^2t")
    paths.axhline(0.0, color=GREEN, lw=1)
    title = (
        f"In its last frame the laser has {kept['laser']:.0f} % of its energy, the artillery shell "
        f"{kept['artillery']:.0f} %,\n"
        f"the pistol {kept['pistol']:.0f} %, the fireball {kept['fireball']:.0f} %"
    )
    if "grenade" in kept:
        title += f"; the grenade has {kept['grenade']:.0f} % before it bursts"
    finish(paths, title, "z, m", "y, m", 8, xlim=(0, 205))
    finish(energies, "", "time, s", "kinetic + potential\nenergy kept, %", 8, ylim=(0, 105))
    columns = ("fired", "shot", "time, s", "x, m", "y, m", "z, m", "energy / initial energy")
    return Picture(figure, columns, rows)


def fireworks() -> Picture:
    """Draw each type of firework and the Catherine wheel until the last spark goes out."""
    rules = firework_rules()
    figure, panels = pyplot.subplots(3, 4, figsize=(12, 7.4), layout="constrained")
    rows: list[tuple[object, ...]] = []
    most = 0
    for rule, axes in zip(rules, panels.flat, strict=False):
        show = FireworksShow(rules, capacity=400, seed=4)
        rises = rule.min_velocity[1] >= 10.0  # the other types start in the air
        lit = 1 if rule.payloads else 12
        show.light([(rule.type, lit, Particle(Vector3(0, 0 if rises else 12, 0)))])
        counts = _streaks(axes, show, lambda: None)
        most = max(most, *counts)
        name = f"type {rule.type}" if lit == 1 else f"{lit} of type {rule.type}"
        title = f"{name}: at most {max(counts)} burning, {len(counts) * FRAME:.1f} s"
        axes.set_title(title, fontsize=9)
        rows += [(rule.type, (i + 1) * FRAME, count) for i, count in enumerate(counts)]
    show = FireworksShow([WHEEL_SPARK], capacity=400, seed=4)
    if wheel := make_wheel(show, Vector3(0, 12, 0)):
        counts = _streaks(panels.flat[11], show, lambda: wheel.update(FRAME), frames=60)
        panels.flat[11].set_title(f"Catherine wheel: {wheel.thrown} sparks in 1 s", fontsize=9)
        rows += [("wheel", (i + 1) * FRAME, count) for i, count in enumerate(counts)]
    for axes in panels.flat[len(rules) : 11]:
        axes.set_visible(False)
    figure.suptitle(f"{len(rules)} types and a wheel: at most {most} burn at a time after a launch")
    return Picture(figure, ("type", "time, s", "burning"), rows)


def step_error() -> Picture:
    """Plot the error of the book's integrator in the position of two shots after 2 s."""
    seconds = 2.0
    counts = (15, 30, 60, 120, 240, 480, 960, 1920)
    lengths = [seconds / frames for frames in counts]
    figure, axes = pyplot.subplots(figsize=(6.4, 5), layout="constrained")
    rows = []
    orders = []
    for name, color, mark in (("artillery", GREEN, "o"), ("fireball", ORANGE, "s")):
        flight = flight_of(SHOT_TYPES[name])
        exact = numbers(state_after(flight.particle(Particle), seconds)[0])
        errors = [
            math.dist(flown(flight, seconds / frames, frames)[-1].position, exact)
            for frames in counts
        ]
        orders.append(slope(lengths, errors))
        axes.loglog(lengths, errors, mark + "-", color=color, ms=5, label=name)
        rows += [(name, *pair) for pair in zip(lengths, errors, strict=True)]
    gravity = abs(SHOT_TYPES["artillery"].acceleration[1])
    theory = [gravity * seconds * h / 2.0 for h in lengths]
    label = "theory without damping, artillery: a t h / 2"
    axes.loglog(lengths, theory, **drawing.THEORY, label=label)
    title = (
        "The error of the step shrinks as h to the power\n"
        "{:.3f} (artillery) and {:.3f} (fireball)".format(*orders)
    )
    x, y = "length of a frame h, s", f"error of the position after {seconds:g} s, m"
    finish(axes, title, x, y, 10)
    return Picture(figure, ("shot", "h, s", "error, m"), rows)


PLOTS = (shots, fireworks, step_error)


def _flight(name: str) -> Iterator[list[tuple[str, Numbers, Numbers]]]:
    """Fire a shot, and yield the type, position and velocity of its pieces in each frame."""
    at = BallisticRange()
    at.fire(name)
    for _ in range(LONGEST):
        at.update(FRAME)
        if not at.shots:
            return
        bodies = [(shot.type, shot.particle) for shot in at.shots]
        yield [(type, numbers(body.position), numbers(body.velocity)) for type, body in bodies]


def _energy(name: str, velocity: Numbers, height: float) -> float:
    """Compute the kinetic plus potential energy of a shot per kilogram, in J/kg."""
    return 0.5 * math.hypot(*velocity) ** 2 - SHOT_TYPES[name].acceleration[1] * height


def _streaks(
    axes: Axes, show: FireworksShow, before: Callable[[], None], frames: int = LONGEST
) -> list[int]:
    """Draw all frames of a show into one picture, and return how many fireworks burn in each."""
    seen: dict[int, tuple[list[float], list[float]]] = {}
    counts = []
    for _ in range(frames):
        before()
        show.update(FRAME)
        if not show.fireworks and counts:
            break
        counts.append(len(show.fireworks))
        for firework in show.fireworks:
            xs, ys = seen.setdefault(firework.type, ([], []))
            x, y, _ = numbers(firework.particle.position)
            xs.append(x)
            ys.append(y)
    for type, (xs, ys) in seen.items():
        color = SPARK_COLORS[(type - 1) % len(SPARK_COLORS)]
        bursts = bool(show.rules[type].payloads)  # drawn in gray, so that its sparks stand out
        axes.plot(xs, ys, ".", ms=1.2, color=GRAY if bursts else color)
    axes.set(facecolor="black", xlim=(-16, 16), ylim=(0, 24), aspect="equal")
    axes.set(xlabel="x, m", ylabel="y, m")
    axes.tick_params(labelsize=7)
    return counts
