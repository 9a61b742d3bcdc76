"""What the measured points say: how long each model takes to a tolerance, and which are best."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from studies.accuracy.measure import EXACT, Point

TOLERANCES = (1e-2, 1e-4, 1e-6)
EIGHTFOLD = 8  # an order is measured over the last three doublings of the steps
STEADY = 0.1  # by how much the order may differ from doubling to doubling
FARTHEST = 1000.0  # an error is extrapolated to a thousandth of the smallest one at the most


@dataclass(frozen=True)
class Side:
    """Which model of ours, or of pymunk's, reaches a tolerance first, and its time in s.

    Both are None where none does: then every model that might get there has been tried for
    ``longest`` s, or longer; and ``never`` says that none of them might.

    Where ``order`` is not None, the model has not been run for that long. Its time is extrapolated
    from this order of convergence.
    """

    model: str | None
    time: float | None
    longest: float
    never: bool
    order: float | None = None


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
    def is_extrapolated(self) -> bool:
        """Whether pymunk's time is extrapolated from its order of convergence."""
        return self.pymunk.order is not None

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

    Of any order it would fall to an eighth: as a judgment, it then never gets where it is not.
    While it is off by a tenth of the scale or more, nobody can tell.
    """
    ordered = sorted(points, key=lambda point: point.steps)
    before = [point for point in ordered if EIGHTFOLD * point.steps <= ordered[-1].steps]
    return bool(before) and 0.5 * before[-1].error <= ordered[-1].error < 0.1


def order_of(points: Sequence[Point]) -> float | None:
    """Return a model's order of convergence, from the last eightfold of its steps.

    That is the exponent p for errors in proportion to 1 / steps^p. None where the error does not
    fall steadily: the order then differs from doubling to doubling, or nobody can tell because the
    error is a tenth of the scale or more, or there are less than four points.
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
    """Return how long a model would take to a tolerance in s, by its order of convergence.

    Each step is taken to last as long as those of the most steps that were tried. None where the
    model has no steady order, or is still too far from the tolerance.
    """
    finest = max(points, key=lambda point: point.steps)
    order = order_of(points)
    if order is None or finest.error > FARTHEST * tolerance:
        return None
    return finest.time * math.pow(finest.error / tolerance, 1.0 / order)


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
    ours, theirs = split(points)
    side = side_of(theirs, tolerance)
    if side.time is None:
        side = extrapolated(side, theirs, tolerance)
    return Row(points[0].scene, tolerance, side_of(ours, tolerance), side)


def extrapolated(side: Side, points: Sequence[Point], tolerance: float) -> Side:
    """Return a side with the least time that one of its models would take, by its order.

    It is as it was where no model has a steady order.
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
