"""Plots for chapter 7: what the resolver leaves in a pile, sinking stacks, and contact solvers."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from functools import partial
from itertools import cycle
from pathlib import Path
from typing import Any

from matplotlib import pyplot
from matplotlib.axes import Axes

from autograder.manifest import ROOT
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.contacts import DEPTH_TOLERANCE, VELOCITY_TOLERANCE, Contact, ContactResolver
from plots.drawing import BLUE, GRAY, GREEN, ORANGE, RED, SKY, Picture, legends, tell
from scenes.clock import FRAME, Track, tracks
from scenes.readings import number, numbers, written
from scenes.resolving import by_resolver, resolving
from scenes.spheres import DIAMETER, RADIUS, at, overlap, pyramid, stack, touching

Error = Callable[[Contact], float]
Act = Callable[[Contact], object]
FIGURES = ROOT / "studies" / "contacts" / "figures.json"
STYLES = {
    "the book's resolver": (RED, "s"),
    "without warm starting": (SKY, "v"),
    "sequential impulses": (BLUE, "o"),
    "soft constraints": (ORANGE, "D"),
    "direct net": (GREEN, "^"),
}
RATIOS = (1, 10, 100, 1000)
FLOOR, CEILING = 1e-6, 10.0  # errors outside are not drawn


def resolver_convergence() -> Picture:
    """Plot the errors left in a pile of spheres against the number of contacts resolved."""
    figure, panels = pyplot.subplots(1, 2, figsize=(12, 5.0), layout="constrained")
    counts = [*range(31), *range(32, 100, 4), *range(100, 401, 20)]
    found = written(
        {
            "worst first": lambda: [residuals(count, False) for count in counts],
            "in list order": lambda: [residuals(count, True) for count in counts],
        }
    )
    contacts = len(falling_pile()[1])
    shown = ("closing velocity", "m/s", 1e-8), ("depth", "m", 1e-10)
    for i, (axes, (what, unit, least)) in enumerate(zip(panels, shown, strict=True)):
        words = []
        for name, seen in found.items():
            color, style = (BLUE, "o-") if name == "worst first" else (ORANGE, "s-")
            # Zeros and rounding errors are drawn at the lower edge of the picture.
            left = [max(number(pair[i]), least) for pair in seen]
            axes.semilogy(counts, left, style, color=color, ms=3, lw=1, label=name)
            words.append(f"{name} {seen[counts.index(100)][i]:.2g} {unit}")
        axes.set_title(
            f"Largest {what} of {contacts} contacts, after 100 resolutions:\n{', '.join(words)}",
            fontsize=10,
        )
        axes.axvline(2 * contacts, color=GRAY, lw=1, ls=":", label=f"default: {2 * contacts}")
        axes.set(xlabel="resolutions", ylabel=f"largest {what}, {unit}")
        legends(axes)
    rows = [
        (name, count, *pair)
        for name, seen in found.items()
        for count, pair in zip(counts, seen, strict=True)
    ]
    columns = ("order", "resolutions", "largest closing velocity, m/s", "largest depth, m")
    return Picture(figure, columns, rows)


def stack_height() -> Picture:
    """Plot how far stacks of 3 and 10 spheres sink and overlap, by iterations per contact."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(12, 5.0), layout="constrained")
    limits, titles = (1, 2, 5, 10, 20, 50), ([], [])
    runs = {(n, limit): partial(sinking, n, limit) for n in (3, 10) for limit in (None, *limits)}
    found = written(runs)
    for count, color in ((3, BLUE), (10, RED)):
        sunk, overlaps = [], []
        for limit, how, style in ((None, "default", "-"), (50, "50 per contact", "--")):
            if (count, limit) in found:
                height, depth = found[count, limit]
                label = f"{count} spheres, {how}"
                left.plot(height.times, height.values, style, color=color, label=label)
                sunk.append(f"{height.values[0] - height.values[-1]:.3g} m ({how})")
                overlaps.append(f"{100.0 * max(depth.values):.2g} % ({how})")
        titles[0].append(f"{count} spheres sink by {', '.join(sunk)}")
        titles[1].append(f"{count} spheres overlap by up to {', '.join(overlaps)}")
        done = [limit for limit in limits if (count, limit) in found]
        most = [max(100.0 * max(found[count, limit][1].values), 1e-6) for limit in done]
        right.loglog(done, most, "o-", color=color, label=f"{count} spheres")
    for axes, lines in zip((left, right), titles, strict=True):
        axes.set_title("\n".join(lines), fontsize=10)
        legends(axes)
    left.set(xlabel="time, s", ylabel="height of the center of the top sphere, m")
    right.set(xlabel="iterations per contact", ylabel="largest overlap in 2 s, % of a diameter")
    right.set_xticks(limits, [str(limit) for limit in limits])
    right.set_xticks([], minor=True)
    left.set_ylim(0.0, 14.0)
    tell(figure, [f"{key}: {run.message}" for key, (run, _) in found.items() if run.message])
    rows = [
        (count, limit or "default", *row)
        for (count, limit), (height, depth) in found.items()
        for row in zip(height.times, height.values, depth.values, strict=True)
    ]
    columns = ("spheres", "iterations per contact", "time, s", "height, m", "overlap / diameter")
    return Picture(figure, columns, rows)


def sinking(count: int, iterations: int | None) -> list[Track]:
    """Record the height of a stack's top sphere in m and the overlap / diameter, for 2 s.

    The limit of ``iterations`` per contact is 2 by default.
    """
    setup = stack(count)
    spheres = setup.particles
    move = resolving(semi_implicit_euler, spheres, setup.contacts, by_resolver(iterations))

    def heights() -> list[float]:
        return [numbers(sphere.position)[1] for sphere in spheres]

    return tracks(move, [lambda: max(heights()), lambda: overlap(heights())], 120)


def falling_pile() -> tuple[list[Particle], list[Contact]]:
    """Create a pyramid of four rows of spheres that hits the ground at 1 m/s, and its contacts.

    Neighbors overlap by 1 % of the diameter, and the lowest spheres and the ground by half of it.
    """
    spheres = at(pyramid(4, 0.99 * DIAMETER), 0.0)
    for sphere in spheres:
        sphere.position.y += 0.99 * RADIUS
        sphere.velocity.y = -1.0
    return spheres, [contact for detector in touching(spheres) for contact in detector.contacts()]


def residuals(iterations: int, in_order: bool) -> tuple[float, float]:
    """Resolve a pile's contacts, in list order or with a ContactResolver, worst first.

    Return the largest closing velocity in m/s, and the largest depth in m.
    """
    spheres, contacts = falling_pile()
    if iterations and in_order:
        _sweep(
            contacts, iterations, _closing, VELOCITY_TOLERANCE, lambda c: c.resolve_velocity(FRAME)
        )
        _sweep(contacts, iterations, _depth, DEPTH_TOLERANCE, _separate)
    elif iterations:
        ContactResolver(iterations).resolve_contacts(contacts, FRAME)
    places = [numbers(sphere.position) for sphere in spheres]
    # Use positions only, because the contacts' own depths may be outdated (E-8).
    depths = [RADIUS - place[1] for place in places]
    depths += [DIAMETER - math.dist(a, b) for i, a in enumerate(places) for b in places[:i]]
    closing = max(map(_closing, contacts), default=math.nan)
    return max(closing, 0.0), max(0.0, *depths)


def _sweep(contacts: list[Contact], limit: int, error: Error, least: float, resolve: Act) -> None:
    """Resolve contacts whose error exceeds ``least``, in repeated passes, ``limit`` times."""
    used = idle = 0
    for contact in cycle(contacts):
        if used == limit or idle == len(contacts):
            return
        idle += 1
        if error(contact) > least:
            resolve(contact)
            used, idle = used + 1, 0


def _closing(contact: Contact) -> float:
    return -contact.separating_velocity()


def _depth(contact: Contact) -> float:
    """Compute how far a sphere overlaps another sphere or the ground at its current position."""
    place = contact.particle.position
    if contact.other is None:
        return RADIUS - place.y
    return DIAMETER - (place - contact.other.position).dot(contact.normal)


def _separate(contact: Contact) -> None:
    contact.penetration = _depth(contact)
    contact.resolve_penetration()


def contact_solvers(file: Path = FIGURES) -> Picture:
    """Draw the error against the computing time, and the time to keep it below 1 %.

    The table has the time in ms per frame to meet a tolerance, or a dash if it is never met.
    """
    data = json.loads(file.read_text(encoding="utf-8"))
    figure, panels = pyplot.subplots(2, 2, figsize=(11, 8.4), layout="constrained")
    scenes = ("stack, ratio 1", "swing, energy")
    names = ("overlap in a stack", "change in energy of a swinging rope")
    units = ("overlap / diameter", "change / energy")
    for axes, scene, name, unit in zip(panels[0], scenes, names, units, strict=True):
        points = [
            (solver, ms, error)
            for own, solver, _, _, error, ms in data["points"]
            if own == scene and FLOOR <= error <= CEILING
        ]
        title, x = f"largest {name} in 1 s", "time, ms per frame"
        _curves(axes, points, title, x, f"largest {unit}")
        axes.axhline(1e-2, color=GRAY, lw=1, ls=":")
    within = {scene: ms for scene, error, ms in data["within"] if error == 1e-2}
    names = ("overlap of a stack", "stretch of a rope")
    for axes, scene, name in zip(panels[1], ("stack", "rope"), names, strict=True):
        times = {ratio: within.get(f"{scene}, ratio {ratio:,}", {}) for ratio in RATIOS}
        points = [(solver, ratio, ms) for ratio in times for solver, ms in times[ratio].items()]
        x = "mass ratio (no mark: not reached by the longest run)"
        _curves(axes, points, f"time to keep the {name} below 1 %", x, "time, ms per frame")
        axes.set_xticks(RATIOS, [f"{ratio:,}" for ratio in RATIOS])
        axes.set_xticks([], minor=True)
    shown = {}
    for axes in panels.flat:
        axes.grid(alpha=0.3)
        handles, labels = axes.get_legend_handles_labels()
        shown = dict(zip(labels, handles, strict=True)) | shown
    solvers = [solver for solver in STYLES if solver in shown]
    figure.legend([shown[s] for s in solvers], solvers, loc="outside lower center", ncols=3)
    rows = [
        (scene, f"{error:g}", *(f"{ms[s]:.2g}" if s in ms else "-" for s in STYLES))
        for scene, error, ms in data["within"]
    ]
    return Picture(figure, ("scene", "error", *STYLES), rows)


def _curves(axes: Axes, points: Any, title: str, x: str, y: str) -> None:
    """Plot a curve through the points of each contact solver."""
    for solver, (color, marker) in STYLES.items():
        seen = [pair for own, *pair in points if own == solver]
        if seen:
            axes.loglog(*zip(*seen, strict=True), color=color, marker=marker, ms=5, label=solver)
    axes.set(title=title, xlabel=x, ylabel=y)
