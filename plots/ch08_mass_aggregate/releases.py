"""A plot for chapter 8: how far a trebuchet throws at every angle of release (project 8.2)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import NamedTuple

from matplotlib import pyplot

from ch08_mass_aggregate.trebuchet import (
    PIVOT_HEIGHT,
    PROJECTILE_MASS,
    STEP,
    TIME_LIMIT,
    Design,
    G,
    Trebuchet,
    my_design,
)
from plots.drawing import BLACK, BLUE, GRAY, GREEN, RED, SKY, Picture, legends
from scenes.readings import is_written, number, numbers, stopped, written

PLAIN = Design(400.0, 1.0, 4.0, 3.0, 45.0)  # drawn until my_design is written
JUMP = 5.0  # degrees; a curve has a gap between releases whose angles differ by more


class Release(NamedTuple):
    """A possible release of the projectile, and the throw that follows."""

    angle: float  # degrees, of the direction of flight
    range: float  # m, from the pivot
    share: float  # the energy of the projectile, divided by that which the counterweight has lost


def trebuchet_range() -> Picture:
    """Plot the range of the student's trebuchet against its release angle, by counterweight."""
    figure, (left, right) = pyplot.subplots(
        1, 2, figsize=(13, 5.4), layout="constrained", width_ratios=(3, 2)
    )
    named = {"my_design": my_design, "a plain design": lambda: PLAIN}
    name, design = next(iter(written(named).items()))
    own = design.counterweight
    weights = sorted({100.0, 200.0, 300.0, 400.0, own})
    designs = {weight: replace(design, counterweight=weight) for weight in weights}
    found = written({weight: partial(releases, made) for weight, made in designs.items()})
    rows: list[Sequence[object]] = []
    best: dict[float, Release] = {}
    for (weight, seen), color in zip(found.items(), (GRAY, SKY, GREEN, BLUE, RED), strict=False):
        rows += [(weight, *release) for release in seen]
        upwards = [release for release in seen if release.angle >= 0.0]
        ends = "never flies forward and up"
        if upwards:
            best[weight] = max(upwards, key=lambda release: release.range)
            ends = f"at best {best[weight].range:.3g} m at {best[weight].angle:.0f}$\\degree$"
        points = [(release.angle, release.range) for release in upwards[:1]]
        for before, release in pairwise(upwards):
            points += [(math.nan, math.nan)] * (before.angle - release.angle > JUMP)
            points.append((release.angle, release.range))
        size = 9 if len(points) < 5 else 4  # so that a single release is visible
        curve = [angle for angle, _ in points], [reach for _, reach in points]
        left.plot(*curve, ".-", color=color, ms=size, lw=1.3, label=f"{weight:g} kg: {ends}")
    title = f"{name} ({own:g} kg) never releases the projectile"
    if thrown := throw_of(design):
        share = 100.0 * thrown.share
        title = f"{name} throws {thrown.range:.3g} m with {share:.2g} % of the energy"
        rows.append((own, *thrown))
        left.plot(thrown.angle, thrown.range, "*", color=BLACK, ms=15, label=name)
        right.plot(own, share, "*", color=BLACK, ms=15, label=name)
    if own in best:
        title += f";\nat its best angle it would throw {best[own].range:.3g} m"
    left.set_title(title, fontsize=10)
    shares = {weight: 100.0 * release.share for weight, release in best.items()}
    right.plot([*shares], [*shares.values()], "o-", color=BLUE, label="best angle")
    for weight, share in shares.items():
        words, place = f"{best[weight].range:.0f} m", (weight, share)
        right.annotate(words, place, (5, 6), textcoords="offset points", fontsize=8)
    most = ", ".join(f"{weight:g} kg {share:.0f} %" for weight, share in shares.items())
    right.set_title(f"Fraction of the energy at the best angle:\n{most}", fontsize=9)
    left.set(xlabel="release angle, degrees above the horizon", ylabel="range, m")
    left.set(xlim=(0.0, 90.0), ylim=(0.0, None))
    right.set(xlabel="counterweight, kg", ylabel="energy that reaches the projectile, %")
    right.set(xlim=(0.0, 1.25 * max(weights)), ylim=(0.0, 105.0))
    legends(left, right, size=8.5)
    columns = ("counterweight, kg", "release angle, degrees", "range, m", "fraction of the energy")
    return Picture(figure, columns, rows)


def releases(design: Design) -> list[Release]:
    """Simulate a trebuchet that never releases its projectile, and list all possible throws.

    A sling lets go as soon as the direction of flight has dropped to the release angle. So a step
    is listed only if this direction is lower than in all earlier steps.
    """
    machine = Trebuchet(design)
    start, high = numbers(machine.projectile.position)[1], numbers(machine.weight.position)[1]
    found: list[Release] = []

    def run() -> None:
        for _ in range(round(TIME_LIMIT / STEP)):
            machine.world.step(STEP)
            x, y, _ = numbers(machine.projectile.position)
            vx, vy, vz = numbers(machine.projectile.velocity)
            if y <= 0.0:  # it touched the ground in the sling
                return
            if vx <= 0.0 or y <= PIVOT_HEIGHT:
                continue
            angle = math.degrees(math.atan2(vy, vx))
            if found and angle >= found[-1].angle:
                continue
            time = (vy + math.sqrt(vy * vy + 2.0 * G * y)) / G
            kinetic = 0.5 * (vx * vx + vy * vy + vz * vz)
            gained = PROJECTILE_MASS * (G * (y - start) + kinetic)
            lost = design.counterweight * G * (high - numbers(machine.weight.position)[1])
            found.append(Release(angle, x + vx * time, gained / lost if lost else math.nan))
            if angle <= 0.0:
                return

    stopped(run)
    return found


def throw_of(design: Design) -> Release | None:
    """Return the throw of the student's engine, or None if it fails or is not written yet."""
    found: list[Release] = []

    def run() -> None:
        throw = Trebuchet(design).throw()
        far, share = (number(getattr(throw, name, None)) for name in ("range", "share"))
        if far > 0.0:
            found.append(Release(design.release_angle, far, share))

    is_written(lambda: stopped(run))
    return found[0] if found else None
