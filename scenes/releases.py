"""Find how far a trebuchet throws at every angle at which its sling can release the projectile.

Lengths are in m, and energies are in J.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from ch08_mass_aggregate.trebuchet import (
    PIVOT_HEIGHT,
    PROJECTILE_MASS,
    STEP,
    TIME_LIMIT,
    Design,
    G,
    Trebuchet,
)
from scenes.readings import numbers, stopped


@dataclass(frozen=True)
class Release:
    """A possible release of the projectile from a trebuchet's sling, and the throw that follows.

    - ``angle``: the projectile's direction of flight at the release, in degrees.
    - ``range``: the distance from the pivot to the point where the projectile lands, in m.
    - ``share``: the energy of the projectile, as a fraction of the energy that the counterweight
      has lost.
    """

    angle: float
    range: float
    share: float


def releases(design: Design) -> list[Release]:
    """Simulate a trebuchet that never releases its projectile, and list all possible throws.

    A real sling releases the projectile as soon as its direction of flight has dropped to the
    release angle. A time step is therefore listed only if this direction is lower than in all
    earlier steps. The list ends when the projectile flies horizontally.

    Ranges and energies are computed as in Trebuchet.throw, but with plain numbers.
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


def jumps(found: Sequence[Release], degrees: float = 5.0) -> list[Release]:
    """Insert placeholders into a list of releases, so that a plot of them has gaps.

    A placeholder is a Release of NaNs. It is inserted wherever the angle drops by more than
    ``degrees`` from one release to the next.
    """
    shown = list(found[:1])
    for before, release in pairwise(found):
        if before.angle - release.angle > degrees:
            shown.append(Release(math.nan, math.nan, math.nan))
        shown.append(release)
    return shown
