"""Compare the fastest simulation of a scene by our engine with the fastest one by pymunk.

A model is one way to simulate a scene, for example with a certain integrator. Both our engine and
pymunk have several models of each scene. To be fair, the comparison uses the fastest models that
meet the same error tolerance.
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
    """The fastest model of our engine, or of pymunk, that meets a given error tolerance.

    - ``model``, ``time``: its name, and how long it takes in s, or None if no model meets it.
    - ``longest``: a lower bound on the time in s, for the case that no model meets the tolerance.
      Every model that could still meet it with more steps has already run for at least this long.
    - ``never``: True if no model would meet the tolerance with any number of steps.
    - ``order``: the order of convergence from which ``time`` was extrapolated, or None if it was
      measured.
    """

    model: str | None
    time: float | None
    longest: float
    never: bool
    order: float | None = None


@dataclass(frozen=True)
class Row:
    """A comparison of our fastest model with pymunk's in one scene, at one error tolerance.

    ``tolerance`` is the largest error allowed, as a fraction of the scene's size. Only models of
    one kind count as ours: those that know more than the equations of motion if ``is_formula`` is
    true, and those that step the equations if it is false. All of pymunk's models count in the
    first case, and those that step the equations in the second.
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
    """Group measured points by model. The points of each model stay in the same order."""
    found: dict[str, list[Point]] = {}
    for point in points:
        found.setdefault(point.model, []).append(point)
    return found


def first_within(ordered: Sequence[Point], tolerance: float) -> int | None:
    """Find the run with the fewest steps that reliably meets an error tolerance.

    ``ordered`` holds the runs of one model, sorted by number of steps. A single small error may be
    a coincidence, so a run counts only if all runs with more steps meet the tolerance, too. Return
    the index of the run, or None if there is none.
    """
    outside = [i for i, point in enumerate(ordered) if not point.error <= tolerance]
    first = outside[-1] + 1 if outside else 0
    return first if first < len(ordered) else None


def time_to(points: Sequence[Point], tolerance: float) -> float | None:
    """Return how long a model takes, in s, to meet an error tolerance, or None if it never does.

    ``points`` are the runs of the model. The time is that of its fastest run that is accurate
    enough. It is shorter if the time at the tolerance itself is, interpolated on logarithmic scales
    between the two runs on either side.
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

    This is the case if eight times as many steps reduce the error by no more than half. For
    comparison, a method of order 1 would reduce it to an eighth. The result is False if the error
    is at least a tenth of the scene's size, because such an error may still start to shrink.
    """
    ordered = by_steps(points)
    before = [point for point in ordered if EIGHTFOLD * point.steps <= ordered[-1].steps]
    return bool(before) and 0.5 * before[-1].error <= ordered[-1].error < 0.1


def order_of(points: Sequence[Point]) -> float | None:
    """Measure a model's order of convergence while its number of steps grows eightfold at the end.

    If the error is proportional to 1 / steps^p, the order is p. Return None if the error does not
    fall steadily, if it is a tenth of the scene's size or more, if it is so small that it is only
    rounding, or if there are fewer than four such runs.
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
    """Estimate how long a model would take, in s, to meet a tolerance that it has not met so far.

    The number of steps follows from the model's order of convergence. Each step is assumed to take
    as long as in the finest run. Return None if the model has no steady order, or if the error of
    the finest run is more than FARTHEST times the tolerance.
    """
    finest, order = by_steps(points)[-1], order_of(points)
    if order is None or finest.error > FARTHEST * tolerance:
        return None
    return finest.time * math.pow(finest.error / tolerance, 1.0 / order)


def side_of(points: Sequence[Point], tolerance: float, *, extrapolates: bool = False) -> Side:
    """Find the fastest model of one engine, ours or pymunk, that meets ``tolerance``.

    ``points`` contains all runs of this engine in one scene. If none of them meets the tolerance
    and ``extrapolates`` is true, the time is extrapolated where that is possible.
    """
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
    """Find the fastest run that is accurate enough, and the next faster run of any accuracy.

    A run is accurate enough only if ``first_within`` finds that the model's runs with more steps
    are accurate enough, too.

    Returns:
        The fastest accurate run, and the slowest of all runs that take less time. Either of them is
        None if there is no such run.
    """
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
    """Compare our fastest model of one kind with pymunk's fastest in one scene, at one tolerance.

    ``points`` are all runs in that scene. Return None if there is no model of this kind.
    """
    ours, theirs = split(points)
    own = [point for point in ours if point.is_formula == is_formula]
    if not own:
        return None
    theirs = [point for point in theirs if is_formula or not point.is_formula]
    side = side_of(theirs, tolerance, extrapolates=True)
    return Row(points[0].scene, is_formula, tolerance, side_of(own, tolerance), side)


def table(points: Sequence[Point]) -> list[Row]:
    """Compare our fastest models with pymunk's in every scene, at every error tolerance.

    The models that step the equations come first.
    """
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
    """Find the runs with the best trade-offs between speed and accuracy, sorted by time.

    A run is included if every faster run has a larger error. Errors that are only rounding errors
    count as equal.
    """
    kept: list[Point] = []
    nearest = math.inf
    for point in sorted(points, key=lambda point: (point.time, point.error)):
        error = max(point.error, EXACT)
        if error < nearest:
            kept.append(point)
            nearest = error
    return kept
