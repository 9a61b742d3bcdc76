"""Going further: multistep methods, which evaluate the forces once per step at any order.

Leapfrog evaluates the forces once per step, and has order 2. So does a multistep method, but it
also keeps the last k accelerations, from 3 up, and so reaches order k. Stoermer's formula gives the
positions,

    x(t + h) = 2 x(t) - x(t - h) + h^2 sum_j b_j a(t - j h)

and the formula of Adams and Bashforth the velocities, which only forces such as drag need:

    v(t + h) = v(t) + h sum_j c_j a(t - j h)

In return, all steps must be equally long, and a spring may be less stiff. The accelerations
before the start come from ``Order8``, which follows the motion backward.

The bodies move in the X-Y plane. A complex number x + iy holds a position or a velocity.
Source: E. Hairer, S. P. Norsett and G. Wanner, Solving Ordinary Differential Equations I, III.1 and
III.10. This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from math import comb
from operator import mul

from ch02_vectors.arguments import positive
from studies.models.order_8 import Accelerations, Numbers, Order8

# For each order, the error in m that a step before the start may have.
START = {4: 1e-6, 6: 1e-8, 8: 1e-12}
MOST = 50  # steps before the start; if more are needed, the steps of the method are too long


class Multistep:
    """Bodies that move in a plane under smooth forces, in steps of ``duration`` s.

    ``accelerations`` computes the accelerations of all bodies in m/s^2 from their positions in m
    and their velocities in m/s. ``order`` is the number of accelerations that are kept. If
    ``is_damped`` is false, the accelerations must not depend on the velocities, which are then not
    computed. ``evaluations`` counts the calls of ``accelerations``.

    Raises ArithmeticError if the motion changes too fast for the duration of a step.
    """

    def __init__(
        self,
        positions: Sequence[complex],
        velocities: Sequence[complex],
        accelerations: Accelerations,
        duration: float,
        order: int,
        *,
        is_damped: bool,
    ) -> None:
        h = positive("duration", duration)
        self.positions, self.velocities = [*positions], [*velocities]
        self.accelerations, self.is_damped = accelerations, is_damped
        if order not in START:
            raise ValueError(f"order must be one of {[*START]}, got {order!r}")
        self.move = [h * h * b for b in weights(order, 2)]
        self.change = [h * c for c in weights(order, 1)]
        back = Order8(
            positions, [-v for v in velocities], lambda x, v: accelerations(x, [-w for w in v])
        )
        states = [back.state, *back.states_at(h, order - 1, START[order], MOST)]
        past = [back.accelerations(*state) for state in states]
        self.evaluations = back.evaluations + len(past)
        self.past = [deque(each, order) for each in zip(*past, strict=True)]
        self.ways = [x - y for x, y in zip(positions, states[1][0], strict=True)]

    def run(self, steps: int, times: int) -> list[Numbers]:
        """Make ``steps`` steps, ``times`` times, and return the positions after each time."""
        bodies = range(len(self.positions))
        positions, velocities, ways = self.positions, self.velocities, self.ways
        move, change, past = self.move, self.change, self.past
        found = []
        for _ in range(times):
            for _ in range(steps):
                for i in bodies:
                    ways[i] += sum(map(mul, move, past[i]))
                    positions[i] += ways[i]
                    if self.is_damped:
                        velocities[i] += sum(map(mul, change, past[i]))
                for each, a in zip(past, self.accelerations(positions, velocities), strict=True):
                    each.appendleft(a)
            found.append([*positions])
        self.evaluations += steps * times
        return found


class LoneMultistep(Multistep):
    """A faster form for a single body, without loops over the bodies."""

    def run(self, steps: int, times: int) -> list[Numbers]:
        """Make ``steps`` steps, ``times`` times, and return the positions after each time."""
        (x,), (v,), (way,), (past,) = self.positions, self.velocities, self.ways, self.past
        move, change, accelerations = self.move, self.change, self.accelerations
        found = []
        for _ in range(times):
            for _ in range(steps):
                way += sum(map(mul, move, past))
                x += way
                if self.is_damped:
                    v += sum(map(mul, change, past))
                past.appendleft(accelerations([x], [v])[0])
            found.append([x])
        self.positions, self.velocities, self.ways = [x], [v], [way]
        self.evaluations += steps * times
        return found


@cache
def weights(order: int, power: int) -> list[float]:
    """Return the weights of the last accelerations, the newest first.

    ``power`` is 1 for the formula of Adams and Bashforth, and 2 for Stoermer's. With D as the
    backward difference, the weighted sum is the series of (-D / ln(1 - D))^power / (1 - D), cut
    off after ``order`` terms.
    """
    log = [Fraction(1, j + 1) for j in range(order)]  # -ln(1 - D) / D
    divisor = log if power == 1 else [_product(log, log, j) for j in range(order)]
    inverse: list[Fraction] = []
    for j in range(order):
        inverse.append(Fraction(j == 0) - sum(divisor[i] * inverse[j - i] for i in range(1, j + 1)))
    series = [sum(inverse[: j + 1]) for j in range(order)]  # divided by 1 - D
    return [
        float((-1) ** i * sum(series[j] * comb(j, i) for j in range(i, order)))
        for i in range(order)
    ]


def _product(a: list[Fraction], b: list[Fraction], j: int) -> Fraction:
    """Return coefficient ``j`` of the product of two power series."""
    return sum((a[i] * b[j - i] for i in range(j + 1)), Fraction())
