"""What the measured points say: how long each model takes to a tolerance, and which are best."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from studies.accuracy.measure import EXACT, Point

TOLERANCES = (1e-2, 1e-4, 1e-6)


@dataclass(frozen=True)
class Side:
    """Which model of ours, or of pymunk's, reaches a tolerance first, and its time in s.

    Both are None where none does: then every model that might get there has been tried for
    ``longest`` s, or longer; and ``never`` says that none of them might.
    """

    model: str | None
    time: float | None
    longest: float
    never: bool


@dataclass(frozen=True)
class Row:
    """A scene and a tolerance, and the two sides of it."""

    scene: str
    tolerance: float
    ours: Side
    pymunk: Side

    @property
    def ratio(self) -> float | None:
        """How many times as long pymunk takes."""
        if self.ours.time is None or self.pymunk.time is None:
            return None
        return self.pymunk.time / self.ours.time

    @property
    def bounds(self) -> tuple[float, float]:
        """Between what the ratio lies where a side is not there in the time that was tried."""
        low = 0.0 if self.ours.time is None else self._of(self.pymunk) / self.ours.time
        high = math.inf if self.pymunk.time is None else self.pymunk.time / self._of(self.ours)
        return low, high

    @staticmethod
    def _of(side: Side) -> float:
        return side.longest if side.time is None else side.time


def first_within(ordered: Sequence[Point], tolerance: float) -> int | None:
    """Return from which of a model's points on it is within a tolerance; None where it never is.

    ``ordered`` are by their steps. More steps must not lead out of it again: one lucky number of
    them is not enough.
    """
    outside = [i for i, point in enumerate(ordered) if not point.error <= tolerance]
    first = outside[-1] + 1 if outside else 0
    return first if first < len(ordered) else None


def time_to(points: Sequence[Point], tolerance: float) -> float | None:
    """Return how long one model takes to a tolerance in s; None where it never gets there.

    Between two measured numbers of steps the time is interpolated, on logarithmic scales.
    """
    ordered = sorted(points, key=lambda point: point.steps)
    first = first_within(ordered, tolerance)
    if first is None:
        return None
    inside = ordered[first]
    if first == 0 or not math.isfinite(ordered[first - 1].error) or inside.error <= 0.0:
        return inside.time
    before = ordered[first - 1]
    share = math.log(before.error / tolerance) / math.log(before.error / inside.error)
    return before.time * math.exp(share * math.log(inside.time / before.time))


def stalls(points: Sequence[Point]) -> bool:
    """Say whether a model's error has not even halved over the last eightfold of its steps.

    Of any order it would fall to an eighth: as a judgement, it then never gets where it is not.
    While it is off by a tenth of the scale or more, nobody can tell.
    """
    ordered = sorted(points, key=lambda point: point.steps)
    before = [point for point in ordered if 8 * point.steps <= ordered[-1].steps]
    return bool(before) and 0.5 * before[-1].error <= ordered[-1].error < 0.1


def models_of(points: Sequence[Point]) -> dict[str, list[Point]]:
    """Return the points of each model, by its name, in the order in which they come."""
    found: dict[str, list[Point]] = {}
    for point in points:
        found.setdefault(point.model, []).append(point)
    return found


def side_of(points: Sequence[Point], tolerance: float) -> Side:
    """Return which model reaches a tolerance in the least time."""
    models = models_of(points)
    open_ones = [own for own in models.values() if not stalls(own)]
    times = {name: time for name, own in models.items() if (time := time_to(own, tolerance))}
    name = min(times, key=lambda name: times[name], default=None)
    tried = (max(point.time for point in own) for own in open_ones or models.values())
    return Side(name, times[name] if name else None, min(tried), not times and not open_ones)


def cheapest(points: Sequence[Point], tolerance: float) -> tuple[Point | None, Point | None]:
    """Return the cheapest point of all models within a tolerance, and the next cheaper outside it.

    None where there is none.
    """
    within = []
    for own in models_of(points).values():
        ordered = sorted(own, key=lambda point: point.steps)
        first = first_within(ordered, tolerance)
        within += [] if first is None else ordered[first:]
    found = min(within, key=lambda point: point.time, default=None)
    cheaper = [point for point in points if found and point.time < found.time]
    return found, max(cheaper, key=lambda point: point.time, default=None)


def split(points: Sequence[Point]) -> tuple[list[Point], list[Point]]:
    """Return our points, the book's among them, and pymunk's."""
    ours = [point for point in points if point.by != "pymunk"]
    return ours, [point for point in points if point.by == "pymunk"]


def row(points: Sequence[Point], tolerance: float) -> Row:
    """Return what the points of one scene say of a tolerance."""
    ours, theirs = (side_of(own, tolerance) for own in split(points))
    return Row(points[0].scene, tolerance, ours, theirs)


def table(points: Sequence[Point]) -> list[Row]:
    """Return a row for each scene and tolerance, in the order of the scenes."""
    scenes: dict[str, list[Point]] = {}
    for point in points:
        scenes.setdefault(point.scene, []).append(point)
    return [row(own, tolerance) for own in scenes.values() for tolerance in TOLERANCES]


def front(points: Sequence[Point]) -> list[Point]:
    """Return the points than which no other is both faster and nearer to the truth, by time.

    What is off by rounding alone is as near as can be.
    """
    kept: list[Point] = []
    nearest = math.inf
    for point in sorted(points, key=lambda point: (point.time, point.error)):
        error = max(point.error, EXACT)
        if error < nearest:
            kept.append(point)
            nearest = error
    return kept
