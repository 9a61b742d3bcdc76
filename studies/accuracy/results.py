"""Compare the fastest simulation of a scene by our engine with the fastest one by pymunk.

Both have several models of each scene, so the fastest ones that meet the same tolerance count.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from studies.accuracy.measure import EXACT, Point

TOLERANCES = (1e-2, 1e-4, 1e-6)
EIGHTFOLD = 8  # an order is measured over the last three doublings of the steps
STEADY = 0.1  # how much the order may vary between one doubling of the steps and another
FARTHEST = 1000.0  # an error is extrapolated at most to a thousandth of the smallest one


@dataclass(frozen=True)
class Side:
    """The fastest model of our engine, or of pymunk, that meets a given error tolerance."""

    model: str | None
    time: float | None  # s
    longest: float  # s; models that more steps could still help ran at least this long
    never: bool  # no number of steps would help any model
    order: float | None = None  # from which the time was extrapolated


@dataclass(frozen=True)
class Row:
    """A comparison of our fastest model with pymunk's in one scene, at one error tolerance.

    If ``is_formula``, only models that know more than the equations of motion count as ours, and
    all of pymunk's count. Otherwise only those that step the equations count, on both sides.
    """

    scene: str
    is_formula: bool
    tolerance: float
    ours: Side
    pymunk: Side

    @property
    def ratio(self) -> float | None:
        """The ratio of pymunk's time to ours, or None if one of the two times is unknown."""
        if self.ours.time is None or self.pymunk.time is None:
            return None
        return self.pymunk.time / self.ours.time

    @property
    def is_extrapolated(self) -> bool:
        """True if pymunk's time is extrapolated, because none of its runs was accurate enough."""
        return self.pymunk.order is not None

    @property
    def bounds(self) -> tuple[float, float]:
        """The lower and upper bounds on the ratio of pymunk's time to ours.

        A side that missed the tolerance takes at least ``Side.longest``, and perhaps forever.
        """
        ours, theirs = self.ours, self.pymunk
        low = 0.0 if ours.time is None else (theirs.time or theirs.longest) / ours.time
        high = math.inf if theirs.time is None else theirs.time / (ours.time or ours.longest)
        return low, high


def by_steps(points: Sequence[Point]) -> list[Point]:
    """Sort the runs of one model by their number of steps."""
    return sorted(points, key=lambda point: point.steps)


def models_of(points: Sequence[Point]) -> dict[str, list[Point]]:
    """Group measured points by model, in the same order."""
    found: dict[str, list[Point]] = {}
    for point in points:
        found.setdefault(point.model, []).append(point)
    return found


def first_within(ordered: Sequence[Point], tolerance: float) -> int | None:
    """Return the index of the run with the fewest steps that meets a tolerance, or None.

    A single small error may be a coincidence, so all runs with more steps must meet it, too.
    """
    outside = [i for i, point in enumerate(ordered) if not point.error <= tolerance]
    first = outside[-1] + 1 if outside else 0
    return first if first < len(ordered) else None


def time_to(points: Sequence[Point], tolerance: float) -> float | None:
    """Return the time in s in which a model meets a tolerance, or None.

    It is that of the fastest accurate run or, if shorter, the time at the tolerance itself,
    interpolated on logarithmic scales between the two runs on either side.
    """
    ordered = by_steps(points)
    first = first_within(ordered, tolerance)
    if first is None:
        return None
    inside = ordered[first]
    fastest = min(point.time for point in ordered[first:])
    if first == 0 or not math.isfinite(ordered[first - 1].error) or inside.error <= 0.0:
        return fastest
    before = ordered[first - 1]
    share = math.log(before.error / tolerance) / math.log(before.error / inside.error)
    return min(fastest, before.time * math.exp(share * math.log(inside.time / before.time)))


def stalls(points: Sequence[Point]) -> bool:
    """Return True if a model's error has stopped shrinking, so that more steps would not help.

    Then eight times as many steps at most halve the error. An error of at least a tenth of the
    scene's size may still start to shrink.
    """
    ordered = by_steps(points)
    before = [point for point in ordered if EIGHTFOLD * point.steps <= ordered[-1].steps]
    return bool(before) and 0.5 * before[-1].error <= ordered[-1].error < 0.1


def order_of(points: Sequence[Point]) -> float | None:
    """Measure a model's order of convergence over the last three doublings of its steps.

    Return None if the error does not fall steadily, is a tenth of the scene's size or more, or is
    only rounding.
    """
    ordered = by_steps(points)
    last = [point for point in ordered if EIGHTFOLD * point.steps >= ordered[-1].steps]
    if len(last) < 4 or not all(EXACT < point.error < 0.1 for point in last):
        return None
    orders = [_order(a, b) for a, b in pairwise(last)]
    mean = _order(last[0], last[-1])
    return mean if mean > 0.5 and max(orders) - min(orders) <= STEADY else None


def _order(a: Point, b: Point) -> float:
    return math.log(a.error / b.error) / math.log(b.steps / a.steps)


def extrapolated_time(points: Sequence[Point], tolerance: float) -> float | None:
    """Estimate the time in s in which a model would meet a tolerance, or return None.

    Each step is assumed to take as long as in the finest run. The order must be steady.
    """
    finest, order = by_steps(points)[-1], order_of(points)
    if order is None or finest.error > FARTHEST * tolerance:
        return None
    return finest.time * math.pow(finest.error / tolerance, 1.0 / order)


def side_of(points: Sequence[Point], tolerance: float, *, extrapolates: bool = False) -> Side:
    """Find the fastest model among all runs of one engine in one scene that meets ``tolerance``."""
    models = models_of(points)
    open_ones = [own for own in models.values() if not stalls(own)]
    tried = (max(point.time for point in own) for own in open_ones or models.values())
    longest, order = min(tried), None
    times = {name: time for name, own in models.items() if (time := time_to(own, tolerance))}
    never = not times and not open_ones
    if not times and extrapolates:
        estimates = {name: extrapolated_time(own, tolerance) for name, own in models.items()}
        times = {name: time for name, time in estimates.items() if time is not None}
        order = order_of(models[min(times, key=times.__getitem__)]) if times else None
    name = min(times, key=times.__getitem__, default=None)
    return Side(name, times[name] if name else None, longest, never, order)


def cheapest(points: Sequence[Point], tolerance: float) -> tuple[Point | None, Point | None]:
    """Find the fastest accurate run, as in ``first_within``, and the slowest of all faster runs."""
    within = []
    for own in models_of(points).values():
        ordered = by_steps(own)
        first = first_within(ordered, tolerance)
        within += [] if first is None else ordered[first:]
    found = min(within, key=lambda point: point.time, default=None)
    cheaper = [point for point in points if found and point.time < found.time]
    return found, max(cheaper, key=lambda point: point.time, default=None)


def split(points: Sequence[Point]) -> tuple[list[Point], list[Point]]:
    """Separate our runs, which include those of the textbook's own integrator, from pymunk's."""
    ours = [point for point in points if point.by != "pymunk"]
    return ours, [point for point in points if point.by == "pymunk"]


def row(points: Sequence[Point], tolerance: float, *, is_formula: bool) -> Row | None:
    """Compare our fastest model of one kind in a scene with pymunk's. Return None without one."""
    ours, theirs = split(points)
    own = [point for point in ours if point.is_formula == is_formula]
    if not own:
        return None
    theirs = [point for point in theirs if is_formula or not point.is_formula]
    side = side_of(theirs, tolerance, extrapolates=True)
    return Row(points[0].scene, is_formula, tolerance, side_of(own, tolerance), side)


def table(points: Sequence[Point]) -> list[Row]:
    """Compare our fastest models with pymunk's, those that step the equations first."""
    scenes: dict[str, list[Point]] = {}
    for point in points:
        scenes.setdefault(point.scene, []).append(point)
    rows = [
        row(own, tolerance, is_formula=is_formula)
        for is_formula in (False, True)
        for own in scenes.values()
        for tolerance in TOLERANCES
    ]
    return [found for found in rows if found]


def front(points: Sequence[Point]) -> list[Point]:
    """Find the runs that are more accurate than all faster runs, sorted by time.

    Errors that are only rounding errors count as equal.
    """
    kept: list[Point] = []
    nearest = math.inf
    for point in sorted(points, key=lambda point: (point.time, point.error)):
        error = max(point.error, EXACT)
        if error < nearest:
            kept.append(point)
            nearest = error
    return kept
