"""Going further: Runge-Kutta of order 8, which takes long steps and reads the frames in between.

A step needs 12 evaluations, and three more if a frame ends in it. If the motion is smooth, it is
accurate even when it lasts for many frames, and a polynomial of degree 7 gives the positions within
it. The method estimates its error, and chooses the length of its steps accordingly. SciPy supplies
the coefficients.

The bodies move in the X-Y plane. A complex number x + iy holds a position or a velocity, so that
one operation of Python does the work of two.

Source: E. Hairer, S. P. Norsett and G. Wanner, Solving Ordinary Differential Equations I, II.5-6.
This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from operator import mul

from scipy.integrate import DOP853  # type: ignore[import-untyped]

from ch02_vectors.arguments import positive

MANY = 10**6  # steps
FIRST = 8  # the first step that is tried, as a multiple of the time between two results
SAFETY, LEAST, MOST = 0.9, 0.2, 6.0  # for the next step, as a multiple of this one
STAGES = [[*map(float, row[:i])] for i, row in enumerate(DOP853.A) if i]
END = [*map(float, DOP853.B)]
MORE = [[*map(float, row[: len(END) + 1 + i])] for i, row in enumerate(DOP853.A_EXTRA)]
CURVE = [[*map(float, row)] for row in DOP853.D]
FIFTH, THIRD = ([*map(float, row)] for row in (DOP853.E5, DOP853.E3))

Numbers = list[complex]  # one for each body
Acceleration = Callable[[complex, complex], complex]  # of one body, from position and velocity
Accelerations = Callable[[Numbers, Numbers], Numbers]  # from positions and velocities
State = tuple[Numbers, Numbers]  # positions and velocities, or their rates
Stages = tuple[list[Numbers], list[Numbers]]  # for each body, its rates at all stages of a step


class Order8:
    """Bodies that move in a plane under smooth forces.

    ``accelerations`` computes the accelerations of all bodies in m/s^2 from their positions in m
    and their velocities in m/s. ``evaluations`` counts its calls.
    """

    def __init__(
        self,
        positions: Sequence[complex],
        velocities: Sequence[complex],
        accelerations: Accelerations,
    ) -> None:
        self.accelerations, self.evaluations = accelerations, 0
        self.state: State = [*positions], [*velocities]
        self._first = self._rates(self.state)

    def positions_at(self, every: float, count: int, tolerance: float) -> list[Numbers]:
        """Return the positions after each ``every`` s, ``count`` times.

        ``tolerance`` is the error that each step may add, in m and m/s.

        Raises:
            ValueError: if a duration or the tolerance is not positive and finite.
            ArithmeticError: if the steps become too short.
        """
        return [positions for (positions,) in self._read(every, count, tolerance, (0,), MANY)]

    def states_at(self, every: float, count: int, tolerance: float, most: int) -> list[State]:
        """Return the positions and velocities instead, computed in at most ``most`` steps."""
        return [(x, v) for x, v in self._read(every, count, tolerance, (0, 1), most)]

    def _read(
        self, every: float, count: int, tolerance: float, kinds: tuple[int, ...], most: int
    ) -> list[list[Numbers]]:
        """Return the positions (kind 0) or velocities (kind 1), or both, at equal distances."""
        end = count * positive("every", every)
        time, step = 0.0, min(end, FIRST * every)
        positive("tolerance", tolerance)
        found: list[list[Numbers]] = []
        for _ in range(most):
            step = min(step, end - time)
            stages = self._stages(step)
            error = step * _error(stages) / tolerance
            share = SAFETY * error**-0.125 if 0.0 < error < math.inf else MOST * (not error)
            factor = min(max(share, LEAST), MOST)
            if not error < 1.0:
                step *= factor
                if not time + step > time:
                    raise ArithmeticError(f"the steps of order 8 become too short at {time:g} s")
                continue
            start = self.state
            self.state = _moved(start, END, stages, step)
            self._first = self._rates(self.state)
            last = math.floor((time + step) / every + 1e-9)
            if len(found) < last:
                _append(stages, self._first)
                for row in MORE:
                    _append(stages, self._rates(_moved(start, row, stages, step)))
                curves = [self._curves(start, stages, step, kind) for kind in kinds]
                while len(found) < min(last, count):
                    share = ((len(found) + 1) * every - time) / step
                    found.append([_read_at(each, share) for each in curves])
            time += step
            step *= factor
            if len(found) == count:
                return found
        raise ArithmeticError(f"order 8 has made {most} steps, and is at {time:g} of {end:g} s")

    def _rates(self, state: State) -> State:
        self.evaluations += 1
        return state[1], self.accelerations(*state)

    def _stages(self, step: float) -> Stages:
        """Return the rates at the twelve stages of a step."""
        velocities, accelerations = self._first
        stages = [[v] for v in velocities], [[a] for a in accelerations]
        for row in STAGES:
            _append(stages, self._rates(_moved(self.state, row, stages, step)))
        return stages

    def _curves(self, start: State, stages: Stages, step: float, kind: int) -> list[Numbers]:
        """Return, for each body, the coefficients of its curve during the step that has ended."""
        curves = []
        for old, new, rates in zip(start[kind], self.state[kind], stages[kind], strict=True):
            far, first, last = new - old, step * rates[0], step * rates[len(END)]
            bends = [step * sum(map(mul, row, rates)) for row in CURVE]
            curves.append([old, far, first - far, 2.0 * far - last - first, *bends])
        return curves


def _append(stages: Stages, rates: State) -> None:
    for kind, values in zip(stages, rates, strict=True):
        for each, value in zip(kind, values, strict=True):
            each.append(value)


def _moved(start: State, row: list[float], stages: Stages, step: float) -> State:
    """Return the state after a step whose rate is a weighted sum of the stages."""
    (x, v), (xs, vs) = start, stages
    return (
        [old + step * sum(map(mul, row, rates)) for old, rates in zip(x, xs, strict=True)],
        [old + step * sum(map(mul, row, rates)) for old, rates in zip(v, vs, strict=True)],
    )


def _read_at(curves: list[Numbers], s: float) -> Numbers:
    """Return the values of all curves after the share ``s`` of a step."""
    r = 1.0 - s
    return [
        a + s * (b + r * (c + s * (d + r * (e + s * (f + r * (g + s * h))))))
        for a, b, c, d, e, f, g, h in curves
    ]


def _error(stages: Stages) -> float:
    """Estimate the largest error of a position or velocity, divided by the duration of the step."""
    worst = 0.0
    for kind in stages:
        for rates in kind:
            fifth, third = abs(sum(map(mul, FIFTH, rates))), abs(sum(map(mul, THIRD, rates)))
            if fifth:
                worst = max(worst, fifth * fifth / math.hypot(fifth, 0.1 * third))
    return worst
