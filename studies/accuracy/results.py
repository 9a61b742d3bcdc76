"""Find the fastest model that simulates a scene accurately enough, among ours and pymunk's.

A model is one way to simulate a scene, such as an integrator. Each side of the comparison, ours or
pymunk's, has several models. The fastest model of one side is compared with the fastest of the
other, at the same error tolerance.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from studies.accuracy.measure import EXACT, Point

TOLERANCES = (1e-2, 1e-4, 1e-6)
EIGHTFOLD = 8  # an order is measured over the last three doublings of the steps
STEADY = 0.1  # how much the order may vary between one doubling of the steps and another
FARTHEST = 1000.0  # an error is extrapolated at most to a thousandth of the smallest one


@dataclass(frozen=True)
class Side:
    """The fastest model that meets an error tolerance in a scene, among ours or among pymunk's.

    ``time`` is in s. ``model`` and ``time`` are None if no model meets the tolerance. In that case,
    every model that might have met it with more steps has been run for at least ``longest``
    seconds. ``never`` is true if no number of steps would have been enough for any model.

    If ``order`` is not None, no run met the tolerance, and ``time`` is extrapolated with that order
    of convergence.
    """

    model: str | None
    time: float | None
    longest: float
    never: bool
    order: float | None = None


@dataclass(frozen=True)
class Row:
    """A comparison of our fastest model with pymunk's in one scene, at one error tolerance.

    The tolerance is a fraction of the scene's scale.
    """

    scene: str
    tolerance: float
    ours: Side
    pymunk: Side

    @property
    def ratio(self) -> float | None:
        """How many times as long as our model pymunk takes, or None if either time is unknown."""
        if self.ours.time is None or self.pymunk.time is None:
            return None
        return self.pymunk.time / self.ours.time

    @property
    def is_extrapolated(self) -> bool:
        """Whether pymunk's time is an estimate, since none of its runs was accurate enough."""
        return self.pymunk.order is not None

    @property
    def bounds(self) -> tuple[float, float]:
        """The lower and upper bounds on the ratio of pymunk's time to ours.

        They are needed when pymunk or our models missed the tolerance. All that is known then is
        that meeting it takes longer than the longest run did, so only one of the two bounds is
        useful.
        """
        low = 0.0 if self.ours.time is None else self._of(self.pymunk) / self.ours.time
        high = math.inf if self.pymunk.time is None else self.pymunk.time / self._of(self.ours)
        return low, high

    @staticmethod
    def _of(side: Side) -> float:
        return side.longest if side.time is None else side.time


def first_within(ordered: Sequence[Point], tolerance: float) -> int | None:
    """Find the run with the fewest steps that reliably meets an error tolerance.

    ``ordered`` holds a model's runs, sorted by number of steps. Return the index of the first run
    that meets the tolerance along with all runs after it, since a single error may be small by
    chance. If even the last run misses the tolerance, return None.
    """
    outside = [i for i, point in enumerate(ordered) if not point.error <= tolerance]
    first = outside[-1] + 1 if outside else 0
    return first if first < len(ordered) else None


def time_to(points: Sequence[Point], tolerance: float) -> float | None:
    """Return the time in s that a model takes to meet an error tolerance, or None if it never does.

    The time is interpolated between two measured runs, on logarithmic scales.
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
    """Return whether taking more steps no longer reduces a model's error.

    A model stalls if eight times as many steps do not even halve its error, when at order 1 they
    would cut it to an eighth. We assume that its error never gets any smaller. While the error is
    still a tenth of the scene's scale or more, it is too early to tell.
    """
    ordered = sorted(points, key=lambda point: point.steps)
    before = [point for point in ordered if EIGHTFOLD * point.steps <= ordered[-1].steps]
    return bool(before) and 0.5 * before[-1].error <= ordered[-1].error < 0.1


def order_of(points: Sequence[Point]) -> float | None:
    """Measure a model's order of convergence from its runs with the most steps.

    The order is the exponent p of an error proportional to 1 / steps^p, measured over an eightfold
    increase in the number of steps. Return None if the error does not fall steadily, if it is a
    tenth of the scene's scale or more, or if there are fewer than four runs.
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
    """Estimate how long a model would take to meet ``tolerance`` with enough steps, in s.

    The number of steps follows from the model's order of convergence, and each step is assumed to
    take as long as in the run with the most steps. Return None if the model has no steady order, or
    if that run's error is more than FARTHEST times the tolerance.
    """
    finest = max(points, key=lambda point: point.steps)
    order = order_of(points)
    if order is None or finest.error > FARTHEST * tolerance:
        return None
    return finest.time * math.pow(finest.error / tolerance, 1.0 / order)


def models_of(points: Sequence[Point]) -> dict[str, list[Point]]:
    """Group measured points by model, without changing the order of each model's points.

    A chart shows each group as a line.
    """
    found: dict[str, list[Point]] = {}
    for point in points:
        found.setdefault(point.model, []).append(point)
    return found


def side_of(points: Sequence[Point], tolerance: float) -> Side:
    """Find the fastest model that meets ``tolerance``, among ours or among pymunk's.

    ``points`` are the measured runs of all of our models in a scene, or of all of pymunk's.
    """
    models = models_of(points)
    open_ones = [own for own in models.values() if not stalls(own)]
    times = {name: time for name, own in models.items() if (time := time_to(own, tolerance))}
    name = min(times, key=lambda name: times[name], default=None)
    tried = (max(point.time for point in own) for own in open_ones or models.values())
    return Side(name, times[name] if name else None, min(tried), not times and not open_ones)


def cheapest(points: Sequence[Point], tolerance: float) -> tuple[Point | None, Point | None]:
    """Find the cheapest run that reliably meets an error tolerance, and the next cheaper run.

    The cheapest run is the one that takes the least time. A run is reliable if its model also meets
    the tolerance at every larger number of steps. The next cheaper run is for comparison, and is
    not reliable. Either result is None if there is no such run.
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
    """Separate the measured points of our models from those of pymunk's.

    The textbook's own integrator counts as one of ours.
    """
    ours = [point for point in points if point.by != "pymunk"]
    return ours, [point for point in points if point.by == "pymunk"]


def row(points: Sequence[Point], tolerance: float) -> Row:
    """Compare our fastest model with pymunk's fastest in one scene, at one error tolerance.

    If pymunk missed the tolerance in all of its runs, its time is extrapolated if possible.
    """
    ours, theirs = split(points)
    side = side_of(theirs, tolerance)
    if side.time is None:
        side = extrapolated(side, theirs, tolerance)
    return Row(points[0].scene, tolerance, side_of(ours, tolerance), side)


def extrapolated(side: Side, points: Sequence[Point], tolerance: float) -> Side:
    """Estimate how long pymunk would take to meet a tolerance that none of its runs met.

    The estimate is that of its fastest model, extrapolated from the model's order of convergence.
    If no model has a steady order, return ``side`` unchanged.
    """
    models = models_of(points)
    times = {name: extrapolated_time(own, tolerance) for name, own in models.items()}
    found = {name: time for name, time in times.items() if time is not None}
    if not found:
        return side
    name = min(found, key=lambda name: found[name])
    return replace(side, model=name, time=found[name], order=order_of(models[name]))


def table(points: Sequence[Point]) -> list[Row]:
    """Compare our fastest model with pymunk's in every scene, at every error tolerance.

    `make charts` prints the result as a table, and draws it as the overview picture.
    """
    scenes: dict[str, list[Point]] = {}
    for point in points:
        scenes.setdefault(point.scene, []).append(point)
    return [row(own, tolerance) for own in scenes.values() for tolerance in TOLERANCES]


def front(points: Sequence[Point]) -> list[Point]:
    """Find the runs with the best trade-offs between speed and accuracy, sorted by time.

    No other run is both faster and more accurate than one of these. Errors that come only from
    rounding count as equal.
    """
    kept: list[Point] = []
    nearest = math.inf
    for point in sorted(points, key=lambda point: (point.time, point.error)):
        error = max(point.error, EXACT)
        if error < nearest:
            kept.append(point)
            nearest = error
    return kept
