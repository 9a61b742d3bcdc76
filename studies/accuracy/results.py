"""Find the time in which each model meets a tolerance, and the fastest model of each side.

One side consists of our models, and the other side consists of pymunk's models.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from studies.accuracy.measure import EXACT, Point

TOLERANCES = (1e-2, 1e-4, 1e-6)
EIGHTFOLD = 8  # an order is measured over the last three doublings of the steps
STEADY = 0.1  # largest difference in order from doubling to doubling
FARTHEST = 1000.0  # an error is extrapolated to a thousandth of the smallest error at most


@dataclass(frozen=True)
class Side:
    """The fastest model of one side that meets a tolerance, and its time in s.

    If no model meets the tolerance, both are None. Every model that might meet the tolerance with
    more steps has then been run for at least ``longest`` seconds. ``never`` is true if no model
    could ever meet the tolerance.

    If ``order`` is not None, the model has not been run with enough steps. Its time is then
    extrapolated, and ``order`` is the order of convergence.
    """

    model: str | None
    time: float | None
    longest: float
    never: bool
    order: float | None = None


@dataclass(frozen=True)
class Row:
    """The results of both sides for one scene and one tolerance."""

    scene: str
    tolerance: float
    ours: Side
    pymunk: Side

    @property
    def ratio(self) -> float | None:
        """Pymunk's time as a multiple of ours, or None if a time is unknown."""
        if self.ours.time is None or self.pymunk.time is None:
            return None
        return self.pymunk.time / self.ours.time

    @property
    def is_extrapolated(self) -> bool:
        """Whether pymunk's time is extrapolated from its order of convergence."""
        return self.pymunk.order is not None

    @property
    def bounds(self) -> tuple[float, float]:
        """The smallest and the largest possible ratio, if one side did not meet the tolerance."""
        low = 0.0 if self.ours.time is None else self._of(self.pymunk) / self.ours.time
        high = math.inf if self.pymunk.time is None else self.pymunk.time / self._of(self.ours)
        return low, high

    @staticmethod
    def _of(side: Side) -> float:
        return side.longest if side.time is None else side.time


def first_within(ordered: Sequence[Point], tolerance: float) -> int | None:
    """Return the index of the first point that meets ``tolerance`` with all points after it.

    ``ordered`` is sorted by steps. All points with more steps must also meet the tolerance, because
    a single point may meet it by chance. If there is no such point, return None.
    """
    outside = [i for i, point in enumerate(ordered) if not point.error <= tolerance]
    first = outside[-1] + 1 if outside else 0
    return first if first < len(ordered) else None


def time_to(points: Sequence[Point], tolerance: float) -> float | None:
    """Return the time in s in which a model meets ``tolerance``, or None if it never does.

    The time is interpolated between two measured numbers of steps, on logarithmic scales.
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
    """Return whether a model's error no longer decreases when it makes more steps.

    A model stalls if its error is not even halved when its number of steps grows eightfold. At
    order 1, the error would fall to an eighth. A model that stalls is assumed to never reach
    smaller errors. An error of a tenth of the scale or more is too large for this conclusion.
    """
    ordered = sorted(points, key=lambda point: point.steps)
    before = [point for point in ordered if EIGHTFOLD * point.steps <= ordered[-1].steps]
    return bool(before) and 0.5 * before[-1].error <= ordered[-1].error < 0.1


def order_of(points: Sequence[Point]) -> float | None:
    """Measure a model's order of convergence over its last eightfold increase of steps.

    The order is the exponent p in an error that is proportional to 1 / steps^p. It is None if the
    error does not fall steadily, if the error is a tenth of the scale or more, or if there are
    fewer than four points.
    """
    ordered = sorted(points, key=lambda point: point.steps)
    last = [point for point in ordered if EIGHTFOLD * point.steps >= ordered[-1].steps]
    if len(last) < 4 or not all(EXACT < point.error < 0.1 for point in last):
        return None
    orders = [math.log(a.error / b.error) / math.log(b.steps / a.steps) for a, b in pairwise(last)]
    mean: float = math.log(last[0].error / last[-1].error) / math.log(
        last[-1].steps / last[0].steps
    )
    is_steady = mean > 0.5 and max(orders) - min(orders) <= STEADY
    return mean if is_steady else None


def extrapolated_time(points: Sequence[Point], tolerance: float) -> float | None:
    """Estimate the time in s in which a model would meet ``tolerance`` with enough steps.

    The number of steps follows from the model's order of convergence. Each step is assumed to take
    as long as in the run with the most steps. The result is None if the model has no steady order,
    or if it is too far from the tolerance.
    """
    finest = max(points, key=lambda point: point.steps)
    order = order_of(points)
    if order is None or finest.error > FARTHEST * tolerance:
        return None
    return finest.time * math.pow(finest.error / tolerance, 1.0 / order)


def models_of(points: Sequence[Point]) -> dict[str, list[Point]]:
    """Group points by the name of their model, and keep their order."""
    found: dict[str, list[Point]] = {}
    for point in points:
        found.setdefault(point.model, []).append(point)
    return found


def side_of(points: Sequence[Point], tolerance: float) -> Side:
    """Return a ``Side`` with the fastest of these models that meets ``tolerance``."""
    models = models_of(points)
    open_ones = [own for own in models.values() if not stalls(own)]
    times = {name: time for name, own in models.items() if (time := time_to(own, tolerance))}
    name = min(times, key=lambda name: times[name], default=None)
    tried = (max(point.time for point in own) for own in open_ones or models.values())
    return Side(name, times[name] if name else None, min(tried), not times and not open_ones)


def cheapest(points: Sequence[Point], tolerance: float) -> tuple[Point | None, Point | None]:
    """Return the cheapest point that reliably meets a tolerance, and the next cheaper point.

    A point is reliable if its model still meets the tolerance with more steps. If there is no such
    point, the result for it is None.
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
    """Split the points into our points, which include the book's, and pymunk's points."""
    ours = [point for point in points if point.by != "pymunk"]
    return ours, [point for point in points if point.by == "pymunk"]


def row(points: Sequence[Point], tolerance: float) -> Row:
    """Return the results of one scene for one tolerance."""
    ours, theirs = split(points)
    side = side_of(theirs, tolerance)
    if side.time is None:
        side = extrapolated(side, theirs, tolerance)
    return Row(points[0].scene, tolerance, side_of(ours, tolerance), side)


def extrapolated(side: Side, points: Sequence[Point], tolerance: float) -> Side:
    """Extrapolate the time of each model, and return the side with the shortest of these times.

    If no model has a steady order, the side is returned unchanged.
    """
    models = models_of(points)
    times = {name: extrapolated_time(own, tolerance) for name, own in models.items()}
    found = {name: time for name, time in times.items() if time is not None}
    if not found:
        return side
    name = min(found, key=lambda name: found[name])
    return replace(side, model=name, time=found[name], order=order_of(models[name]))


def table(points: Sequence[Point]) -> list[Row]:
    """Return a row for each scene and tolerance, in the order of the scenes."""
    scenes: dict[str, list[Point]] = {}
    for point in points:
        scenes.setdefault(point.scene, []).append(point)
    return [row(own, tolerance) for own in scenes.values() for tolerance in TOLERANCES]


def front(points: Sequence[Point]) -> list[Point]:
    """Return the points that no other point beats in both time and error, sorted by time.

    Errors that come only from rounding all count as equal.
    """
    kept: list[Point] = []
    nearest = math.inf
    for point in sorted(points, key=lambda point: (point.time, point.error)):
        error = max(point.error, EXACT)
        if error < nearest:
            kept.append(point)
            nearest = error
    return kept
