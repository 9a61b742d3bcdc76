"""Going further: a net of rods and cables, stepped with Runge-Kutta 4 at order 4.

DirectNet finds the pulls that give the links the right lengths at the end of a step. SmoothNet
instead finds the pulls whose accelerations keep the lengths of rods and taut cables constant. It
does so at each of the four stages of a step, as RodTensions does for a chain. A small error
remains. To correct it, the step ends with a projection: it moves positions and velocities to values
that the links allow. This projection does not lower the order (Hairer, Lubich and Wanner, Geometric
Numerical Integration, IV.4).

A cable that becomes taut stops its ends at once. A method of order 4 loses its order if it steps
across such an impact, so the step stops at the impact, as in time division.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from ch02_vectors.arguments import positive
from ch05_forces.particle import Particle
from studies.models.forces import take_forces
from studies.models.net import Net, Way

EXACT = 1e-11  # relative error allowed in the square of a length after a step
NEAR = 1e-9  # relative distance from its limit within which a link is tried as active
CORRECTIONS = 4  # of the positions after a step
MOST = 5000  # impacts in a step
LEAST = 1e-9  # the fraction of a step that is not worth a step

Force = tuple[float, float, float]
Forces = Callable[[float], object]
Solved = tuple[list[Way], list[float]]  # the directions of the links, and the factors with them


class SmoothNet(Net):
    """A net of rods and cables that steps its own particles with Runge-Kutta 4.

    ``links`` are links of chapter 7. The net ignores their restitution, so nothing bounces.
    ``others`` are particles that no link holds. A particle's damping d acts as a continuous drag,
    which adds the acceleration ln(d) v.

    Raises:
        ValueError: if there are no links, or a damping is 0.
        TypeError: if one of the links is not a link of chapter 7.
    """

    def __init__(self, links: Iterable[Any], others: Iterable[Particle] = ()) -> None:
        super().__init__(links, others)
        self.pulls = [0.0] * len(self.rows)  # N/m: per m of each link, at the start of the step
        for i, particle in enumerate(self.particles):
            positive(f"the damping of particle {i}", particle.damping)

    def step(self, duration: float, apply_forces: Forces | None = None) -> None:
        """Move the particles by one time step. ``duration`` is in s.

        Forces in the accumulators act during the whole step. ``apply_forces`` adds all other forces
        at each stage, as ``ForceRegistry.update_forces`` does.

        Raises:
            ValueError: if the duration is not positive and finite. In that case nothing changes.
            ArithmeticError: if the links contradict each other, or the impacts do not end.
        """
        left = positive("duration", duration)
        constant = [take_forces(particle) for particle in self.particles]
        self.gains = self.inverse_masses()
        self.drags = [math.log(particle.damping) for particle in self.particles]
        for _ in range(MOST):
            left -= self._advance(left, constant, apply_forces)
            if left <= LEAST * duration:
                return
        raise ArithmeticError("cables become taut again and again in one step")

    def _advance(self, duration: float, constant: Sequence[Force], forces: Forces | None) -> float:
        """Step until the first impact, for at most ``duration`` s, and return the elapsed time."""
        start, speed = self.state()
        first, _ = self._rates(start, speed, constant, forces, duration, chooses=True)
        taken, hit = duration, None
        while True:
            half = 0.5 * taken
            v2 = _moved(speed, first, half)
            second, _ = self._rates(_moved(start, speed, half), v2, constant, forces, duration)
            v3 = _moved(speed, second, half)
            third, _ = self._rates(_moved(start, v2, half), v3, constant, forces, duration)
            v4 = _moved(speed, third, taken)
            fourth, solved = self._rates(_moved(start, v3, taken), v4, constant, forces, duration)
            places = _mean(start, taken / 6.0, speed, v2, v3, v4)
            speeds = _mean(speed, taken / 6.0, first, second, third, fourth)
            if hit is not None:
                break
            share, hit = self._first_impact(start, speed, places, speeds, duration)
            if share > 1.0 - LEAST:
                break
            taken = max(share, LEAST) * duration
        self._project(places, speeds, solved, hit)
        self.write(places, speeds)
        return taken

    def _rates(
        self,
        places: Sequence[float],
        speeds: Sequence[float],
        constant: Sequence[Force],
        forces: Forces | None,
        duration: float,
        chooses: bool = False,
    ) -> tuple[list[float], Solved]:
        """Return the accelerations, the directions of the links, and the factors of the equations.

        The pulls accelerate the ends of each active link so that it keeps its length. If
        ``chooses`` is True, as in the first stage, first choose the active links: the links that
        are at their limit and pull.
        """
        count, rows = self.count, self.rows
        rates = self._free_rates(places, speeds, constant, forces, duration)
        directions, right, near = [], [], []
        for i, (a, b, square, kind) in enumerate(rows):
            ay, by, az, bz = a + count, b + count, a + 2 * count, b + 2 * count
            x, y, z = places[b] - places[a], places[by] - places[ay], places[bz] - places[az]
            u, v, w = speeds[b] - speeds[a], speeds[by] - speeds[ay], speeds[bz] - speeds[az]
            directions.append((x, y, z))
            right.append(
                (rates[b] - rates[a]) * x
                + (rates[by] - rates[ay]) * y
                + (rates[bz] - rates[az]) * z
                + u * u
                + v * v
                + w * w
            )
            if chooses and kind and not self.is_active[i]:
                is_long = (x * x + y * y + z * z - square) * kind > -NEAR * square
                if is_long and (x * u + y * v + z * w) * kind * duration > -NEAR * square:
                    near.append(i)
        if chooses:
            self.pulls, factors = self.balance(directions, self.gains, right, near)
            pulls = self.pulls
        else:
            factors = self.factor(directions, self.gains, self.is_active)
            pulls = self.solve(factors, self.of_active(right))
        self.pull(rates, directions, self.gains, pulls)
        return rates, (directions, factors)

    def _free_rates(
        self,
        places: Sequence[float],
        speeds: Sequence[float],
        constant: Sequence[Force],
        forces: Forces | None,
        duration: float,
    ) -> list[float]:
        """Return the accelerations from all forces except the pulls, and 0 for immovable ends."""
        if forces:
            self.write(places, speeds)
            forces(duration)
        still = [0.0] * (self.count - len(self.particles))
        count = self.count
        us, vs, ws = [], [], []
        for i, (particle, (fx, fy, fz)) in enumerate(zip(self.particles, constant, strict=True)):
            mass, own, drag = self.gains[i], particle.acceleration, self.drags[i]
            if not mass:
                us.append(0.0)
                vs.append(0.0)
                ws.append(0.0)
                continue
            if forces:
                x, y, z = take_forces(particle)
                fx, fy, fz = fx + x, fy + y, fz + z
            us.append(own.x + fx * mass + drag * speeds[i])
            vs.append(own.y + fy * mass + drag * speeds[i + count])
            ws.append(own.z + fz * mass + drag * speeds[i + 2 * count])
        return [*us, *still, *vs, *still, *ws, *still]

    def _first_impact(
        self,
        start: Sequence[float],
        speed: Sequence[float],
        places: Sequence[float],
        speeds: Sequence[float],
        duration: float,
    ) -> tuple[float, list[int]]:
        """Find the first links that reach their limit.

        Return the fraction of the step at which this happens, and the indices of the links. During
        the step, the positions follow the cubic curve that has the given positions and velocities
        at both ends of the step.
        """
        share, hit = 1.0, []
        for i, (a, b, square, kind) in enumerate(self.rows):
            if self.is_active[i]:
                continue
            old, new, fast, later = (
                [of[b + n] - of[a + n] for n in (0, self.count, 2 * self.count)]
                for of in (start, places, speed, speeds)
            )
            if (sum(x * x for x in new) - square) * kind <= EXACT * square:
                continue

            def is_beyond(s: float) -> bool:
                between = hermite(old, fast, new, later, duration, s)  # noqa: B023
                return (sum(x * x for x in between) - square) * kind > 0.0  # noqa: B023

            low, high = 0.0, 1.0
            for _ in range(45):
                middle = 0.5 * (low + high)
                low, high = (low, middle) if is_beyond(middle) else (middle, high)
            if high < share - LEAST:
                share, hit = high, [i]
            elif high < share + LEAST:
                share, hit = min(share, high), [*hit, i]
        return share, hit

    def _project(
        self, places: list[float], speeds: list[float], solved: Solved, hit: Sequence[int] | None
    ) -> None:
        """Restore the lengths of the active links, and stop motion that would change them.

        The links in ``hit`` have just become taut. This impact stops the ends of the links without
        a bounce, and may release other cables.
        """
        _, factors = solved
        for _ in range(CORRECTIONS):
            ways = self.directions(places)
            right = [
                0.5 * (x * x + y * y + z * z - square)
                for (x, y, z), (_, _, square, _) in zip(ways, self.rows, strict=True)
            ]
            off = zip(right, self.rows, self.is_active, strict=True)
            if all(not on or abs(e) <= EXACT * row[2] for e, row, on in off):
                break
            self.pull(places, ways, self.gains, self.solve(factors, self.of_active(right)))
        right = [
            x * u + y * v + z * w
            for (x, y, z), (u, v, w) in zip(ways, self.directions(speeds), strict=True)
        ]
        if hit:
            pulls, _ = self.balance(ways, self.gains, right, hit)
        else:
            pulls = self.solve(factors, self.of_active(right))
        self.pull(speeds, ways, self.gains, pulls)


def hermite(
    old: Sequence[float],
    fast: Sequence[float],
    new: Sequence[float],
    later: Sequence[float],
    duration: float,
    share: float,
) -> list[float]:
    """Return positions within a step, from the positions and velocities at its two ends.

    ``share`` is the elapsed fraction of the step, and ``duration`` is its length in s. ``old`` and
    ``new`` are the positions at the start and the end. ``fast`` and ``later`` are the velocities at
    the start and the end.
    """
    a, b, c, d = hermite_weights(duration, share)
    ends = zip(old, fast, new, later, strict=True)
    return [a * x0 + b * v0 + c * x1 + d * v1 for x0, v0, x1, v1 in ends]


def hermite_weights(duration: float, share: float) -> tuple[float, float, float, float]:
    """Return the weights of the cubic curve through a step's ends, after a share of the step.

    They belong to the position and the velocity at the start, and to those at the end. ``duration``
    is that of the step in s. The curve has an error of order 4, like the step itself.
    """
    s, left = share, 1.0 - share
    return (
        left * left * (1.0 + 2.0 * s),
        duration * s * left * left,
        s * s * (3.0 - 2.0 * s),
        -duration * s * s * left,
    )


def _moved(places: Sequence[float], speeds: Sequence[float], time: float) -> list[float]:
    return [x + u * time for x, u in zip(places, speeds, strict=True)]


def _mean(start: Sequence[float], sixth: float, *rates: Sequence[float]) -> list[float]:
    """Return ``start`` plus the weighted mean of four ``rates``, multiplied by the duration.

    ``sixth`` is a sixth of the duration in s.
    """
    return [
        x + sixth * (a + 2.0 * (b + c) + d) for x, a, b, c, d in zip(start, *rates, strict=True)
    ]
