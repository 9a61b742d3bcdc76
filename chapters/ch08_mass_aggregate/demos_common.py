"""What the demos of chapter 8 share: steps of one length, a title, and how links are drawn."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterable

from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from ch02_vectors.vector import Vector3
from ch07_constraints.links import AnchoredCable, Cable
from ch08_mass_aggregate.fixed_step import FixedStep
from ch08_mass_aggregate.world import ParticleWorld
from studies.drawing import BLACK, GREY, RED
from studies.links import ends_of
from studies.readings import is_written
from studies.stability import stopped, watching

SPEED_LIMIT = 200.0  # m/s, far more than anything here has while it is well
SLACK = "#BBBBBB"
EARTH = "#E4E0D8"
WOOD = "#A0622D"

Point = tuple[float, float]


class WholeSteps(FixedStep):
    """Stands in for a FixedStep that is a stub: what is left of a step is forgotten."""

    def advance(self, elapsed: float) -> int:
        """Make as many whole steps as are nearest to the time that has passed."""
        steps = max(1, round(elapsed / self.duration))
        if self.max_steps is not None:
            steps = min(steps, self.max_steps)
        for _ in range(steps):
            self.step(self.duration)
        return steps


class WorldDemo:
    """The base of the demos that step a world. It stops where the engine explodes."""

    LINES = 2  # of the title
    clock: FixedStep

    def __init__(self, figure: Figure) -> None:
        self.title = figure.suptitle("", fontsize=10)
        self.message = ""

    def run(
        self,
        step: Callable[[float], object],
        world: ParticleWorld,
        rate: float,
        max_steps: int | None = None,
    ) -> None:
        """Make steps of a world from now on, at a rate in Hz."""
        world.integrator = watching(world.integrator, SPEED_LIMIT)
        fixed = FixedStep(step, 1.0 / rate, max_steps)
        if not is_written(lambda: fixed.advance(0.0)):
            fixed = WholeSteps(step, 1.0 / rate, max_steps)
        self.clock = fixed
        self.message = ""

    def update(self, duration: float) -> None:
        """Let a frame pass."""
        if not self.message:
            self.message = stopped(lambda: self.advance(duration))

    def advance(self, duration: float) -> None:
        """Make the steps that are due by now."""
        self.clock.advance(duration)

    def say(self, state: str) -> None:
        """Write the state above the picture, or what stopped it."""
        words = f"stopped; r starts anew. {self.message}" if self.message else state
        lines = [line for part in words.split("\n") for line in textwrap.wrap(part, 105)]
        lines += [""] * (self.LINES - len(lines))  # the picture is laid out once, for all of them
        self.title.set(text="\n".join(lines[: self.LINES]), color=RED if self.message else BLACK)

    def click(self, axes: object, x: float, y: float) -> None:
        """Nothing here is clicked."""


def seen(place: Vector3) -> Point:
    """Return where a place is seen, from the side and a little from above."""
    return place.x + place.z / 3.0, place.y + place.z / 3.0


def lines(axes: Axes, color: str, width: float = 1.0) -> LineCollection:
    """Return lines that are to be drawn, none of them yet."""
    found = LineCollection([], colors=color, linewidths=width, capstyle="round")
    axes.add_collection(found)
    return found


def draw_ground(axes: Axes, depth: float) -> None:
    """Draw earth from that far in m below 0 up to 0, all along the axes."""
    axes.axhspan(-depth, 0.0, color=EARTH, zorder=0)
    axes.locator_params(nbins=6)  # numbers take most of the time for a picture


def draw_anchors(axes: Axes, generators: Iterable[object]) -> None:
    """Draw what a world's generators hang things from."""
    places = [seen(link.anchor) for link in generators if isinstance(link, AnchoredCable)]
    axes.plot([x for x, _ in places], [y for _, y in places], "s", color=GREY, ms=5)


def draw_cables(cables: LineCollection, generators: Iterable[object]) -> None:
    """Draw the cables of a world's generators: black where they are taut, light where slack."""
    segments, colors = [], []
    for link in generators:
        if isinstance(link, Cable | AnchoredCable):
            a, b = ends_of(link)
            segments.append([seen(a), seen(b)])
            colors.append(BLACK if (b - a).magnitude() >= link.max_length else SLACK)
    cables.set_segments(segments)
    cables.set(colors=colors)
