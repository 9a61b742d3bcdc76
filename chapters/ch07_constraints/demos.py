"""The demo of chapter 7: the same rope of rods by three methods, side by side."""

from __future__ import annotations

import math
from itertools import pairwise
from textwrap import shorten

from matplotlib.figure import Figure

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.direct_chain import DirectChain
from ch07_constraints.heap_resolver import HeapResolver
from ch07_constraints.links import Rod
from studies.constraints import LINK, Move, by_resolver, chain_particles, resolving
from studies.drawing import BLUE, GREEN, RED
from studies.readings import numbers, stopped

SUBSTEPS = 8


class Ropes:
    """A rope that should keep its length: one step per frame, substeps, and a direct solve."""

    seconds = 6.0
    keys = "The up and down arrow keys change the number of links, r starts again."
    COUNTS = (1, 2, 3, 5, 10, 15, 20)
    ANGLE = 60.0  # degrees from straight down

    def __init__(self, figure: Figure) -> None:
        self.panels = figure.subplots(1, 3, sharey=True)
        self.lines = []
        for axes, color in zip(self.panels, (RED, BLUE, GREEN), strict=True):
            axes.set(xlim=(-1.3, 1.3), ylim=(-3.2, 0.4), aspect="equal", xlabel="x, m")
            axes.plot([0.0], [0.0], "ks", ms=6)
            self.lines.append(axes.plot([], [], "o-", color=color, ms=4, lw=1.5)[0])
        self.panels[0].set_ylabel("y, m")
        self.title = figure.suptitle("", fontsize=10)
        self.count = 5
        self.start()

    def start(self) -> None:
        """Release the ropes again, straight and at rest."""
        self.time = 0.0
        self.ropes = [chain_particles(self.count, self.ANGLE) for _ in self.panels]
        one, many, solved = self.ropes
        resolve = by_resolver(None, HeapResolver)
        self.ways: dict[str, Move] = {
            "Rod, a step a frame": resolving(semi_implicit_euler, one[1:], _rods(one), resolve),
            f"Rod, {SUBSTEPS} substeps": resolving(
                semi_implicit_euler, many[1:], _rods(many), resolve, substeps=SUBSTEPS
            ),
            "DirectChain": DirectChain(solved[1:], Vector3()).step,
        }
        self.messages = dict.fromkeys(self.ways, "")

    def update(self, duration: float) -> None:
        self.time += duration
        for name, move in self.ways.items():
            if not self.messages[name]:
                self.messages[name] = stopped(lambda move=move: move(duration))

    def too_long(self) -> list[float]:
        """Return the excess length of each rope in m."""
        return [
            math.fsum(
                math.dist(numbers(a.position), numbers(b.position)) - LINK
                for a, b in pairwise(rope)
            )
            for rope in self.ropes
        ]

    def draw(self) -> None:
        off = self.too_long()
        for axes, line, rope, name, long in zip(
            self.panels, self.lines, self.ropes, self.ways, off, strict=True
        ):
            places = [numbers(particle.position) for particle in rope]
            line.set_data([x for x, _, _ in places], [y for _, y, _ in places])
            words = shorten(self.messages[name], 36) or f"too long by {100.0 * long:.1f} cm"
            axes.set_title(f"{name}:\n{words}", fontsize=10)
        self.title.set_text(
            f"{self.count} rods of {LINK:g} m, let go at {self.ANGLE:g}$\\degree$, "
            f"60 frames a second, after {self.time:.1f} s"
        )

    def press(self, key: str) -> None:
        if key in ("up", "down"):
            place = self.COUNTS.index(self.count) + (1 if key == "up" else -1)
            self.count = self.COUNTS[max(0, min(len(self.COUNTS) - 1, place))]
            self.start()
        elif key == "r":
            self.start()

    def click(self, axes: object, x: float, y: float) -> None:
        """Ignore clicks."""

    def play(self, time: float) -> None:
        """Show five links first, and then ten."""
        if round(60.0 * time) == 180:
            self.press("up")


DEMOS = (Ropes,)


def _rods(rope: list[Particle]) -> list[Rod]:
    return [Rod(a, b, LINK) for a, b in pairwise(rope)]
