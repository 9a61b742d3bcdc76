"""Compute the exact motion of a net of cables in a plane, with SciPy.

The computation shares no code with the engine. As long as the same cables are taut, their tensions
keep them at full length, and the motion follows from ordinary differential equations. This phase
ends when a tension drops to zero, or when a slack cable reaches its full length. After that,
different cables are taut, and the velocities may have jumped.

To find the taut cables and the new velocities, SciPy solves a least-squares problem for the
tensions, which must not be negative. This works because an impact without bounce removes as little
kinetic energy as possible (Moreau, in Nonsmooth Mechanics and Applications, 1988).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy
from scipy.integrate import solve_ivp  # type: ignore[import-untyped]
from scipy.optimize import nnls  # type: ignore[import-untyped]

# A tie leads from a knot or an anchor to a knot. Its length is in m. Its kind is 1 for a cable and
# -1 for a strut.
Tie = tuple[int | tuple[float, float], int, float, int]
Load = Callable[[float, Any], Any]  # the forces in N on all knots, at a time and at their positions
NEAR, SLOW = 1e-9, 1e-9  # m and m/s; a tie this close to its limit is at its limit
EVENTS = 2000


class TautMotion:
    """The exact motion of a net, whose knots with ``masses`` in kg are connected by ``ties``.

    The net starts at rest, at the given ``places``. The state is an array of all positions,
    followed by all velocities.
    """

    def __init__(
        self,
        masses: Sequence[float],
        ties: Sequence[Tie],
        load: Load,
        places: Sequence[Sequence[float]],
    ) -> None:
        self.places = numpy.ravel(numpy.array(places, float))
        self.inverse = 1.0 / numpy.repeat(numpy.asarray(masses, float), 2)
        self.load = load
        self.lengths = numpy.array([length for _, _, length, _ in ties])
        self.kinds = numpy.array([float(kind) for *_, kind in ties])
        self.ends = numpy.zeros((len(ties), len(masses)))
        self.anchors = numpy.zeros((len(ties), 2))
        for row, (start, end, _, _) in enumerate(ties):
            self.ends[row, end] = 1.0
            if isinstance(start, int):
                self.ends[row, start] = -1.0
            else:
                self.anchors[row] = start

    def gaps(self, places: Any) -> Any:
        """Compute how much longer each cable can get, or how much shorter each strut, in m."""
        ways = self.ends @ places.reshape(-1, 2) - self.anchors
        return self.kinds * (self.lengths - numpy.linalg.norm(ways, axis=1))

    def rows(self, places: Any, speeds: Any) -> tuple[Any, Any]:
        """Compute the Jacobian matrix of the lengths, with one row per tie.

        The second array has the part of each length's second derivative that is due to rotation.
        Both have the opposite sign for struts.
        """
        ways = self.ends @ places.reshape(-1, 2) - self.anchors
        rates = self.ends @ speeds.reshape(-1, 2)
        now = numpy.linalg.norm(ways, axis=1)
        unit = ways / now[:, None]
        matrix = (self.ends[:, :, None] * unit[:, None, :]).reshape(len(now), -1)
        along = (unit * rates).sum(axis=1)
        bent = ((rates**2).sum(axis=1) - along**2) / now
        return self.kinds[:, None] * matrix, self.kinds * bent

    def least(self, matrix: Any, wanted: Any) -> Any:
        """Find the forces p that keep all ties within their limits.

        ``wanted`` lists the accelerations toward the limits that the forces have to cancel. With
        the Jacobian J, the ``matrix``, and A = J M^-1 J^T, they satisfy p >= 0, A p >= wanted and
        p (A p - wanted) = 0. For an impact, use velocities to get impulses.
        """
        weighted = (matrix * numpy.sqrt(self.inverse)).T
        target, *_ = numpy.linalg.lstsq(weighted.T, wanted, rcond=None)
        pulls, _ = nnls(weighted, target, maxiter=100 * len(wanted) + 100)
        return pulls

    def accelerations(self, time: float, state: Any, taut: Any) -> tuple[Any, Any]:
        """Compute the accelerations of all knots, and the forces of the taut ties."""
        places, speeds = numpy.split(state, 2)
        matrix, bent = self.rows(places, speeds)
        free = self.inverse * self.load(time, places)
        held = matrix[taut]
        wanted = held @ free + bent[taut]
        pulls = numpy.linalg.lstsq((held * self.inverse) @ held.T, wanted, rcond=None)[0]
        return free - self.inverse * (held.T @ pulls), pulls

    def choose(self, time: float, state: Any) -> tuple[Any, Any]:
        """Resolve any impacts at ``time``. Return the new state, and the indices of taut ties."""
        places, speeds = numpy.split(state, 2)
        matrix, bent = self.rows(places, speeds)
        near = numpy.flatnonzero(self.gaps(places) < NEAR)
        closing = matrix[near] @ speeds
        if (closing > SLOW).any():
            speeds = speeds - self.inverse * (matrix[near].T @ self.least(matrix[near], closing))
            matrix, bent = self.rows(places, speeds)
        still = near[matrix[near] @ speeds > -SLOW]
        free = self.inverse * self.load(time, places)
        pulls = self.least(matrix[still], matrix[still] @ free + bent[still])
        taut = still[pulls > 1e-9 * max(1.0, pulls.max(initial=0.0))]
        return numpy.concatenate([places, speeds]), taut

    def begun(self) -> tuple[Any, Any]:
        """Return the state of the net at the start, and the indices of its taut ties."""
        return self.choose(0.0, numpy.concatenate([self.places, 0.0 * self.places]))

    def first_accelerations(self) -> list[list[float]]:
        """Compute the accelerations of all knots at the start, in m/s^2."""
        found = self.accelerations(0.0, *self.begun())[0]
        return [[float(x), float(y)] for x, y in found.reshape(-1, 2)]

    def run(self, times: Sequence[float]) -> list[tuple[float, ...]]:
        """Compute the motion from time 0. Return all coordinates for each time."""
        time, found = 0.0, []
        state, taut = self.begun()
        for _ in range(EVENTS):
            slack = numpy.setdiff1d(numpy.arange(len(self.lengths)), taut)
            gaps = self.gaps(state[: len(self.inverse)])[slack]
            spare = numpy.where(gaps < 2.0 * NEAR, 4.0 * NEAR - gaps, 0.0)

            def rates(t: float, s: Any, taut: Any = taut) -> Any:
                return numpy.append(s[len(self.inverse) :], self.accelerations(t, s, taut)[0])

            def event(
                t: float, s: Any, taut: Any = taut, slack: Any = slack, spare: Any = spare
            ) -> float:
                _, pulls = self.accelerations(t, s, taut)
                gaps = self.gaps(s[: len(self.inverse)])[slack] + spare
                return float(min(pulls.min(initial=1.0), gaps.min(initial=1.0)))

            event.terminal, event.direction = True, -1.0  # type: ignore[attr-defined]
            after = [t for t in times if t > time]
            limits = {"rtol": 1e-12, "atol": 1e-12}
            got = solve_ivp(
                rates, (time, times[-1]), state, "DOP853", after, events=event, **limits
            )
            found += [*got.y.T] if len(got.t) else []
            if got.status != 1:
                return [tuple(map(float, row[: len(self.inverse)])) for row in found]
            time = float(got.t_events[0][0])
            state, taut = self.choose(time, got.y_events[0][0])
        raise ArithmeticError("the impacts do not come to an end")
