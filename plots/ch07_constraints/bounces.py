"""Plots for chapter 7: bounces, resting contacts, and the restitution of dropped balls."""

from __future__ import annotations

import math
import statistics
import textwrap
from functools import partial
from itertools import pairwise
from typing import Any

from matplotlib import pyplot
from matplotlib.figure import Figure

from ch05_forces.forces import Gravity
from ch07_constraints.contacts import Contact
from ch07_constraints.drops import find_drops, read_drops
from ch07_constraints.exercises import restitution_of_drop, table_of_drops
from ch07_constraints.time_division import TooManyImpacts, time_division_step
from plots.drawing import BLUE, GRAY, GREEN, ORANGE, PINK, RED, SKY, Picture, legends, tell
from scenes.clock import Track, track
from scenes.dropped_balls import DroppedBalls
from scenes.integrators import INTEGRATORS
from scenes.readings import number, numbers, written
from scenes.resolving import Resolve, by_resolver, no_forces, resolving

HEIGHT = 2.0  # m
GRAVITY = 10.0  # m/s^2
COLORS = {"explicit Euler": RED, "semi-implicit Euler": BLUE, "time division": GREEN}


def ball(
    method: str,
    height: float,
    restitution: float,
    frames: int,
    resolve: Resolve | None = None,
    gravity: str = "built-in",
) -> Track:
    """Drop a ball, and record its height above the ground in m.

    ``method`` is "time division", or an integrator, after which ``resolve`` or a ContactResolver
    acts. If ``gravity`` is "generated", it comes from a force generator.
    """
    balls = DroppedBalls([height], restitution)
    setup = balls.setup()
    (particle,), (ground,) = setup.particles, balls.detectors(setup.particles)
    apply_forces, ends = no_forces, []
    if gravity == "generated":
        generator = Gravity(particle.acceleration.copy())
        apply_forces = partial(generator.update_force, particle)
        particle.acceleration.clear()

    def divide(duration: float) -> None:
        try:
            time_division_step([particle], ground, duration)
        except TooManyImpacts as error:  # the ball has come to rest
            ends.append(error.time)
            raise

    if method == "time division":
        move = divide
    else:
        step, resolve = INTEGRATORS[method], resolve or by_resolver()
        move = resolving(step, [particle], [ground], resolve, apply_forces)
    run = track(move, lambda: numbers(particle.position)[1], frames)
    times = [run.times[-1] + end for end in ends]
    heights = [numbers(particle.position)[1] for _ in ends]
    return Track(run.times + times, run.values + heights, run.message)


def without_rule(contacts: list[Contact], duration: float) -> None:
    """Resolve contacts without the engine's rule, so that what gravity adds bounces, too."""
    del duration
    for contact in contacts:
        contact.resolve_velocity()
        contact.resolve_penetration()


def no_slow_bounce(contacts: list[Contact], duration: float) -> None:
    """Resolve contacts without a bounce if they close slower than 1 m/s, a stricter rule."""
    for contact in contacts:
        if contact.separating_velocity() > -1.0:
            contact.restitution = 0.0
        contact.resolve(duration)


def bounce_heights() -> Picture:
    """Plot the height of a ball dropped from 2 m over time, with restitution 1 and with 0.5."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.2), layout="constrained")
    runs = {(name, 1.0): partial(ball, name, HEIGHT, 1.0, 1200) for name in COLORS}
    runs |= {(name, 0.5): partial(ball, name, HEIGHT, 0.5, 150) for name in COLORS}
    found = written(runs)
    words, ends = [], []
    for (name, c), run in found.items():
        axes = left if c == 1.0 else right
        axes.plot(run.times, run.values, color=COLORS[name], lw=1.2, label=name)
        late = [height for time, height in run.points if time > (18.0 if c == 1.0 else 2.0)]
        if c == 1.0 and late:
            words.append(f"{name}: up to {max(late):.3f} m")
        elif c < 1.0 and name == "time division":
            ended = run.message.startswith("TooManyImpacts")
            end = f"the impacts end after {run.times[-1]:.7f} s" if ended else "no end is reported"
            ends.append(f"{name}: {end}")
        elif c < 1.0:
            ends.append(f"{name}: up to {1e3 * max(late, default=math.nan):.3g} mm after 2 s")
    end = DroppedBalls([HEIGHT], 0.5).end()
    right.axvline(end, color=GRAY, lw=1, ls=":", label=f"theory: ends at {end:.7f} s")
    left.axhline(HEIGHT, color=GRAY, lw=1, ls=":")
    left.set_title("\n".join(["Restitution 1, in the last two seconds", *words]), fontsize=10)
    right.set_title("\n".join(["Restitution 0.5", *ends]), fontsize=10)
    for axes in (left, right):
        axes.set(xlabel="time, s", ylabel="height, m (60 Hz, 10 m/s$^2$)")
    # A faulty engine may compute huge heights.
    drawable = [y for run in found.values() for y in run.values if abs(y) < 10.0 * HEIGHT]
    left.set_ylim(top=max([1.25 * HEIGHT, *drawable]) * 1.15)
    legends(left, ncols=3, loc="upper center")
    legends(right)
    # With restitution 0.5, time division should report that the impacts end.
    _notes(figure, {key: run for key, run in found.items() if key != ("time division", 0.5)})
    rows = [(*key, *row) for key, run in found.items() for row in run.points]
    return Picture(figure, ("method", "restitution", "time, s", "height, m"), rows)


def resting_jitter() -> Picture:
    """Plot the height of a ball at rest, with the engine's resting rule and with others.

    A small gap at the start keeps explicit Euler from finding a contact in its first step.
    """
    figure, (*panels, last) = pyplot.subplots(1, 3, figsize=(16, 5.4), layout="constrained")
    rules = {"resting rule": None, "no rule": without_rule}
    names, colors = [*COLORS][:2], {"resting rule": (RED, BLUE), "no rule": (ORANGE, SKY)}
    ways = {
        (c, name, rule, gravity): partial(ball, name, 1e-6, c, 120, rules[rule], gravity)
        for c in (0.5, 0.9)
        for rule in rules
        for name in names
        for gravity in ("built-in", "generated")
    }
    found = written(ways)
    for axes, c in zip(panels, (0.5, 0.9), strict=True):
        runs = {key[1:]: run for key, run in found.items() if key[0] == c}
        for (name, rule, gravity), run in runs.items():
            mm = [1e3 * height for height in run.values]
            style, every = ("-", 1) if gravity == "built-in" else ("o", 5)
            label = f"{name}, {rule}, {gravity} gravity: {max(mm[1:], default=math.nan):.3g} mm"
            looks = {"color": colors[rule][names.index(name)], "ms": 3, "lw": 1, "label": label}
            axes.plot(run.times[::every], mm[::every], style, **looks)
        most = {rule: [_highest(r) for key, r in runs.items() if key[1] == rule] for rule in rules}
        top = max(sum(most.values(), [1.0]))
        axes.set_ylim(-0.05 * top, 1.9 * top)
        words = [f"with {rule} {max(mm, default=math.nan):.3g} mm" for rule, mm in most.items()]
        axes.set_title(
            f"A ball at rest at 1 $\\mu$m, restitution {c:g}: largest height\n{', '.join(words)}",
            fontsize=10,
        )
        legends(axes, size=7.5, loc="upper left")
    fall, c = 0.04, 0.9
    resolves: dict[str, Resolve | None] = {
        "time division": None,
        **dict.fromkeys(f"{name}, resting rule" for name in names),
        "semi-implicit Euler, no bounce below 1 m/s": no_slow_bounce,
    }
    falls = written(
        {
            how: partial(ball, how.partition(", ")[0], fall, c, 60, resolve)
            for how, resolve in resolves.items()
        }
    )
    rises = {name: f"{1e3 * _rise(run):.3g}" for name, run in falls.items()}
    for (name, run), color in zip(falls.items(), (GREEN, RED, BLUE, PINK), strict=False):
        mm = [1e3 * height for height in run.values]
        last.plot(run.times, mm, color=color, lw=1.2, label=f"{name}: {rises[name]} mm")
    last.set_title(
        f"A fall of {1e3 * fall:g} mm, to {math.sqrt(2.0 * GRAVITY * fall):.2f} m/s, restitution "
        f"{c:g}: highest\nbounce {', '.join(rises.values())} mm (theory {1e3 * fall * c**2:.3g})",
        fontsize=10,
    )
    last.set_ylim(-3.0, 75.0)
    legends(last, loc="upper right")
    for axes in (*panels, last):
        axes.set(xlabel="time, s", ylabel="height, mm (60 Hz)")
    _notes(figure, {**found, **falls})
    rows = [(key[0], ", ".join(key[1:]), *row) for key, run in found.items() for row in run.points]
    for name, run in falls.items():
        rows += [(c, f"fall of {fall:g} m, {name}", *row) for row in run.points]
    return Picture(figure, ("restitution", "what", "time, s", "height, m"), rows)


def restitution_of_materials() -> Picture:
    """Plot the restitution of several balls, computed from measured bounce heights.

    It is the root of bounce height / drop height. Marks show the quotient as well, because our copy
    of the book omits the root in exercise 7.1.
    """
    path, drops = _drops()
    singles = [(material, number(restitution_of_drop(a, b))) for material, a, b in drops]
    figure, (axes, beside) = pyplot.subplots(
        1, 2, figsize=(12, 5.0), layout="constrained", width_ratios=(3, 2)
    )
    rows: list[tuple[Any, ...]] = []
    for i, (material, count, mean, error) in enumerate(table_of_drops(drops)):
        ratios = [b / a for name, a, b in drops if name == material and a]
        printed = statistics.fmean(ratios) if ratios else math.nan
        rows.append((material, count, number(mean), number(error), printed))
        dots = [value for name, value in singles if name == material]
        spread = [i + 0.05 * (j - 0.5 * (len(dots) - 1)) for j in range(len(dots))]
        axes.plot(spread, dots, "o", color=SKY, ms=4, label="" if i else "single drops")
    names, means, errors, quotients = ([row[k] for row in rows] for k in (0, 2, 3, 4))
    if rows:
        at = range(len(rows))
        looks: dict[str, Any] = {"fmt": "D", "color": BLUE, "ms": 5, "capsize": 4}
        looks["label"] = "mean, with its standard error"  # which is NaN for a single drop
        axes.errorbar([i - 0.2 for i in at], means, errors, **looks)
        looks = {"color": RED, "ms": 8, "mew": 2, "label": "without the square root"}
        axes.plot([i + 0.25 for i in at], quotients, "x", **looks)
        axes.set_xticks(at, [textwrap.fill(str(name), 14) for name in names], fontsize=8)
        axes.legend(fontsize=8, ncols=3, loc="upper center")
        table = beside.table(
            [[*map(str, row[:2]), *(f"{value:.3f}" for value in row[2:])] for row in rows],
            colLabels=["material", "drops", "mean", "error", "no root"],
            loc="center",
            colWidths=[0.5, 0.12, 0.14, 0.14, 0.16],
        )
        table.auto_set_font_size(False)
        table.set_fontsize(8)
        table.scale(1.0, 1.6)
    else:
        beside.text(0.5, 0.5, "the table has no rows", ha="center")
    axes.set(ylim=(0.0, 1.15), xlim=(-0.6, max(len(rows), 1) - 0.4), ylabel="restitution")
    axes.grid(alpha=0.3, axis="y")
    beside.axis("off")
    # A ball dropped from 1 m should bounce to the square of its restitution, in m.
    off, printed_off = (
        100.0
        * max((abs(c * c - b) for c, b in zip(found, quotients, strict=True)), default=math.nan)
        for found in (means, quotients)
    )
    figure.suptitle(
        f"{len(drops)} drops in {path}. The mean restitutions predict the bounces to within "
        f"{off:.2g} % of the fall,\nwithout the square root to within {printed_off:.2g} %",
        fontsize=11,
    )
    rows = [("mean", *row) for row in rows]
    rows += [("drop", material, 1, value, "", "") for material, value in singles]
    columns = ("row", "material", "drops", "restitution", "standard error", "without the root")
    return Picture(figure, columns, rows)


def _highest(run: Track) -> float:
    """Find the greatest height of a ball in mm, ignoring heights that are too large to plot."""
    return 1e3 * max((height for height in run.values[1:] if abs(height) < 1e3), default=math.nan)


def _rise(run: Track) -> float:
    """Find how high a ball rises after it first bounces, or 0 if it never rises."""
    for i, (a, b) in enumerate(pairwise(run.values)):
        if b > a:
            return max(run.values[i:])
    return 0.0


def _drops() -> tuple[str, list[tuple[str, float, float]]]:
    """Return the name of the file with the student's drops, or with the sample, and its drops."""
    for name in ("drops.csv", "drops_sample.csv"):
        try:
            drops = read_drops(find_drops(name))
        except FileNotFoundError:
            continue
        if drops:
            return name, drops
    raise ValueError("there are no drops in drops.csv or drops_sample.csv")


def _notes(figure: Figure, found: dict[Any, Track]) -> None:
    tell(figure, [f"{key}: {run.message}" for key, run in found.items() if run.message])
