"""Plots for chapter 4: shots, all types of fireworks, and the error of the book's integrator."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from matplotlib import pyplot
from matplotlib.axes import Axes

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.ballistics import MUZZLE, SHOT_TYPES, BallisticRange, Shot
from ch04_particle_engine.closed_form import state_after
from ch04_particle_engine.firework_types import FIREWORK_TYPES, own_types
from ch04_particle_engine.fireworks import FireworksShow
from lab.scenes.ch04_particle_engine.ballistics import can_throw
from lab.scenes.ch04_particle_engine.fireworks import WHEEL_SPARK, can_turn, make_wheel
from plots.drawing import BLACK, BLUE, GRAY, GREEN, ORANGE, PINK, RED, SKY, YELLOW, Picture, slope
from scenes.drag_flight import flight_of, make_particle
from scenes.readings import Numbers, is_written, numbers

SHOT_COLORS = {  # pink for a shot type that the student has added
    **dict.fromkeys(SHOT_TYPES, PINK),
    "pistol": BLACK,
    "artillery": GREEN,
    "fireball": ORANGE,
    "laser": RED,
    "grenade": BLUE,
    "fragment": BLUE,
}
# One color for each of the eleven types, and one for the sparks of the wheel.
SPARK_COLORS = (YELLOW, ORANGE, SKY, PINK, YELLOW, RED, SKY, GREEN, "white", PINK, GREEN, ORANGE)
FRAME = 1.0 / 60.0
LONGEST = 600  # frames, enough for every shot to land and every firework to burn out


def shots() -> Picture:
    """Draw the path of each type of shot, and plot how much of its energy each shot keeps."""
    figure, (paths, energies) = pyplot.subplots(
        2, 1, figsize=(9, 7), height_ratios=(2, 1), layout="constrained"
    )
    rows = []
    kept = {}
    for name, type in SHOT_TYPES.items():
        color = SHOT_COLORS[name]
        if name == "grenade" and not can_throw():
            continue
        flown = [*_flight(name)]
        speed = math.hypot(*type.velocity)
        start = 0.5 * type.mass * speed * speed
        label = f"{name}: {type.mass:g} kg, {speed:.3g} m/s, {start:,.0f} J"
        for i, pieces in enumerate(flown):
            for kind, p, v in pieces:
                energy = _energy(name, v, p[1]) / _energy(name, type.velocity, MUZZLE[1])
                rows.append((name, kind, (i + 1) * FRAME, *p, energy))
        whole = [row for row in rows if row[0] == name and row[1] == name]
        parts = [row for row in rows if row[0] == name and row[1] != name]
        paths.plot([r[5] for r in whole], [r[4] for r in whole], color=color, label=label)
        paths.plot([r[5] for r in parts], [r[4] for r in parts], ".", ms=1.5, color=color)
        energies.plot([r[2] for r in whole], [100.0 * r[6] for r in whole], color=color)
        kept[name] = 100.0 * whole[-1][6] if whole else math.nan
    k = -math.log(SHOT_TYPES["laser"].damping)
    times = [i * 0.1 for i in range(21)]
    # For a shot without gravity, drag leaves the fraction d^2t of the kinetic energy.
    exact = [100.0 * math.exp(-2.0 * k * t) for t in times]
    energies.plot(times, exact, color=GRAY, lw=5, alpha=0.4, label="theory without gravity, d^2t")
    paths.axhline(0.0, color=GREEN, lw=1)
    paths.set(xlabel="z, m", ylabel="y, m", xlim=(0, 205))
    paths.grid(alpha=0.3)
    paths.legend(fontsize=8)
    energies.set(xlabel="time, s", ylabel="kinetic + potential\nenergy kept, %", ylim=(0, 105))
    energies.grid(alpha=0.3)
    energies.legend(fontsize=8)
    found = f"the pistol {kept['pistol']:.0f} %, the fireball {kept['fireball']:.0f} %"
    if "grenade" in kept:
        found += f"; the grenade has {kept['grenade']:.0f} % before it bursts"
    paths.set_title(
        f"In its last frame the laser has {kept['laser']:.0f} % of its energy, the artillery shell "
        f"{kept['artillery']:.0f} %,\n{found}"
    )
    columns = ("fired", "shot", "time, s", "x, m", "y, m", "z, m", "energy / initial energy")
    return Picture(figure, columns, rows)


def fireworks() -> Picture:
    """Draw each type of firework and the Catherine wheel until the last spark goes out."""
    rules = [*FIREWORK_TYPES, *(own_types() if is_written(own_types) else [])]
    figure, panels = pyplot.subplots(3, 4, figsize=(12, 7.4), layout="constrained")
    rows = []
    most = 0
    for rule, axes in zip(rules, panels.flat, strict=False):
        show = FireworksShow(rules, capacity=400, seed=4)
        rises = rule.min_velocity[1] >= 10.0  # the other types start in the air
        place = Particle(Vector3(0, 0 if rises else 12, 0))
        lit = 1 if rule.payloads else 12
        show.light([(rule.type, lit, place)])
        counts = _streaks(axes, show, lambda: None)
        most = max(most, *counts)
        name = f"type {rule.type}" if lit == 1 else f"{lit} of type {rule.type}"
        axes.set_title(
            f"{name}: at most {max(counts)} burning, {len(counts) * FRAME:.1f} s", fontsize=9
        )
        rows += [(rule.type, (i + 1) * FRAME, count) for i, count in enumerate(counts)]
    show = FireworksShow([WHEEL_SPARK], capacity=400, seed=4)
    wheel = make_wheel(show, Vector3(0, 12, 0))
    if can_turn():
        counts = _streaks(panels.flat[11], show, lambda: wheel.update(FRAME), frames=60)
        panels.flat[11].set_title(f"Catherine wheel: {wheel.thrown} sparks in 1 s", fontsize=9)
        rows += [("wheel", (i + 1) * FRAME, count) for i, count in enumerate(counts)]
    for axes in panels.flat[len(rules) : 11]:
        axes.set_visible(False)
    figure.suptitle(f"{len(rules)} types and a wheel: at most {most} burn at a time after a launch")
    return Picture(figure, ("type", "time, s", "burning"), rows)


def step_error() -> Picture:
    """Plot the position error of the book's integrator against the frame length.

    The error is the distance between the simulated and the exact position of a shot after 2 s.
    """
    counts = (15, 30, 60, 120, 240, 480, 960, 1920)
    seconds = 2.0
    figure, axes = pyplot.subplots(figsize=(6.4, 5), layout="constrained")
    rows = []
    orders = []
    for name, color, mark in (("artillery", GREEN, "o"), ("fireball", ORANGE, "s")):
        flight = flight_of(SHOT_TYPES[name], seconds)
        exact = numbers(state_after(make_particle(flight), seconds)[0])
        errors = []
        for frames in counts:
            particle = make_particle(flight)
            for _ in range(frames):
                particle.integrate(seconds / frames)
            errors.append(math.dist(numbers(particle.position), exact))
        lengths = [seconds / frames for frames in counts]
        orders.append(slope(lengths, errors))
        axes.loglog(lengths, errors, mark + "-", color=color, ms=5, label=name)
        rows += [(name, *pair) for pair in zip(lengths, errors, strict=True)]
    gravity = abs(SHOT_TYPES["artillery"].acceleration[1])
    theory = [gravity * seconds * h / 2.0 for h in lengths]
    label = "theory without damping, artillery: a t h / 2"
    axes.loglog(lengths, theory, color=GRAY, lw=5, alpha=0.4, label=label)
    axes.set(
        xlabel="length of a frame h, s", ylabel=f"error of the position after {seconds:g} s, m"
    )
    axes.grid(alpha=0.3, which="both")
    axes.legend()
    axes.set_title(
        "The error of the step shrinks as h to the power\n"
        "{:.3f} (artillery) and {:.3f} (fireball)".format(*orders)
    )
    return Picture(figure, ("shot", "h, s", "error, m"), rows)


PLOTS = (shots, fireworks, step_error)


def _flight(name: str) -> Iterator[list[tuple[str, Numbers, Numbers]]]:
    """Fire a shot of the type ``name``, and follow all of its pieces until the last one is gone.

    Yields:
        For each frame, a list with the type, position and velocity of every piece. Most shots stay
        in one piece, but a grenade bursts into fragments.
    """
    at = BallisticRange()
    at.fire(name)
    for _ in range(LONGEST):
        at.update(FRAME)
        if not at.shots:
            return
        yield [_seen(shot) for shot in at.shots]


def _seen(shot: Shot) -> tuple[str, Numbers, Numbers]:
    return shot.type, numbers(shot.particle.position), numbers(shot.particle.velocity)


def _energy(name: str, velocity: Numbers, height: float) -> float:
    """Compute the kinetic plus potential energy of a shot per kilogram, in J/kg."""
    return 0.5 * math.hypot(*velocity) ** 2 - SHOT_TYPES[name].acceleration[1] * height


def _streaks(
    axes: Axes, show: FireworksShow, before: Callable[[], None], frames: int = LONGEST
) -> list[int]:
    """Draw every frame of a fireworks show into a single picture, like a long exposure.

    Return the number of fireworks burning in each frame.
    """
    seen: dict[int, tuple[list[float], list[float]]] = {}
    counts = []
    for _ in range(frames):
        before()
        show.update(FRAME)
        if not show.fireworks and counts:
            break
        counts.append(len(show.fireworks))
        for firework in show.fireworks:
            x, y, _ = numbers(firework.particle.position)
            xs, ys = seen.setdefault(firework.type, ([], []))
            xs.append(x)
            ys.append(y)
    for type, (xs, ys) in seen.items():
        color = SPARK_COLORS[(type - 1) % len(SPARK_COLORS)]
        bursts = bool(show.rules[type].payloads)  # drawn in gray, so that its sparks stand out
        axes.plot(xs, ys, ".", ms=1.2, color=GRAY if bursts else color)
    axes.set(facecolor="black", xlim=(-16, 16), ylim=(0, 24), aspect="equal")
    axes.tick_params(labelsize=7)
    axes.set(xlabel="x, m", ylabel="y, m")
    return counts
