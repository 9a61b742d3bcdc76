"""Going further: a net of rods and cables that solves for all pulls at once.

DirectNet does for any net what DirectChain does for a chain, but a net is harder in two respects.
First, the equations of a chain can be solved from one end to the other. A net has no such natural
order, so it needs an order of elimination. Second, a cable can only pull, so the step must also
find out which cables are taut.

A chain is also a net, and both solvers have the same error. But for 30 rods a step of the net takes
3.6 times as long (`make measure WHAT=bench`), because the net looks up which links meet at each
particle. This is why DirectChain has a solver of its own.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ch02_vectors.arguments import positive
from ch05_forces.particle import Particle
from studies.models.net import CHANGES, Net

Columns = tuple[list[float], list[float], list[float]]  # x, y and z of all ends
# The ends of a link, the vector along it, its length squared, by how much that may be wrong, kind.
Rows = list[tuple[int, int, float, float, float, float, float, int]]

EXACT = 2e-10  # relative error allowed in the square of a length after a step
FINER = 1e-3  # of EXACT, after a correction
MOST = 60  # corrections of the pulls in a step
TOO_FAR = "the links turn too far in one step; use shorter steps"


class DirectNet(Net):
    """A net of rods and cables that steps its own particles, with an error of order 2.

    ``links`` are the rods, cables and Limits of chapter 7. The net ignores their restitution, so
    nothing bounces. ``others`` are particles that no link holds. The order is 2 as long as no cable
    becomes taut. Each time a cable becomes taut, it causes an error of order 1.
    """

    def __init__(self, links: Iterable[Any], others: Iterable[Particle] = ()) -> None:
        super().__init__(links, others)
        self._pulls = [0.0] * len(self.rows)  # N/m: per m of each link, in the last step
        self._has_stepped = False

    @property
    def tensions(self) -> list[float]:
        """The pull of each link in the last step, in N. It is negative if the link pushed.

        Limits with a ``min_length`` count as two links, a cable and a strut. They have two pulls,
        in this order.
        """
        return [pull * length for pull, length in zip(self._pulls, self.lengths, strict=True)]

    def step(self, duration: float) -> None:
        """Move the particles by one time step under the forces in the accumulators.

        ``duration`` is in s. Velocities change before positions, as in DirectChain. The first step
        accelerates for half of its duration, and from then on the velocities belong to the middle
        of the previous step. Each link applies an impulse along its direction at the start of the
        step. At the end of the step, every link has the right length, with a relative error of at
        most 1e-10.

        The step tries the pulls of the last step first. In a net at rest they are already correct,
        so no equations have to be solved.

        Raises:
            ValueError: if the duration is not positive and finite. In that case nothing changes.
            ArithmeticError: if a link would rotate too far in the step, or the lengths contradict
                each other. The net is then in the middle of the step, and cannot be used any more.
        """
        positive("duration", duration)
        time = duration if self._has_stepped else 0.5 * duration
        self._has_stepped = True
        xs, ys, zs = self.places()
        us, vs, ws, gains = [], [], [], []
        for particle in self.particles:
            particle.kick(time)
            velocity, gain = particle.velocity, particle.inverse_mass * time
            gains.append(gain)
            us.append(velocity.x if gain else 0.0)
            vs.append(velocity.y if gain else 0.0)
            ws.append(velocity.z if gain else 0.0)
        still = [0.0] * len(self.anchors)
        gains += still
        us += still
        vs += still
        ws += still
        rows = [
            (a, b, xs[b] - xs[a], ys[b] - ys[a], zs[b] - zs[a], square, EXACT * square, kind)
            for a, b, square, kind in self.rows
        ]
        self._find_pulls(rows, (xs, ys, zs), (us, vs, ws), gains, duration)
        for particle, x, y, z, u, v, w, gain in zip(
            self.particles, xs, ys, zs, us, vs, ws, gains, strict=False
        ):
            if gain:
                position, velocity = particle.position, particle.velocity
                velocity.x, velocity.y, velocity.z = u, v, w
                position.x = x + u * duration
                position.y = y + v * duration
                position.z = z + w * duration

    def _find_pulls(
        self, rows: Rows, places: Columns, velocities: Columns, gains: list[float], duration: float
    ) -> None:
        """Adjust the pulls and velocities until all lengths are right at the end of the step.

        Each correction solves the equations for the active links, which are all rods and the taut
        cables. If a cable would have to push, it becomes slack. If a cable has become too long, it
        becomes taut. After several such changes, only one link changes at a time, which guarantees
        that the search ends (Murty, Linear Algebra and its Applications 7, 1974, 65).

        The method uses plain floats, because a step with vectors takes three times as long.
        """
        xs, ys, zs = places
        us, vs, ws = velocities
        pulls, active, half = self._pulls, self.is_active, 0.5 / duration
        changes, factors = pulls, None
        for correction in range(MOST):
            for (a, b, x, y, z, _, _, _), change in zip(rows, changes, strict=True):
                if change:
                    gain = gains[a] * change
                    us[a] += x * gain
                    vs[a] += y * gain
                    ws[a] += z * gain
                    gain = gains[b] * change
                    if gain:  # not an anchor
                        us[b] -= x * gain
                        vs[b] -= y * gain
                        ws[b] -= z * gain
            to_xs = [x + u * duration for x, u in zip(xs, us, strict=True)]
            to_ys = [y + v * duration for y, v in zip(ys, vs, strict=True)]
            to_zs = [z + w * duration for z, w in zip(zs, ws, strict=True)]
            excesses, taut, is_right = [], [], True
            for i, (a, b, _, _, _, square, allowed, kind) in enumerate(rows):
                x, y, z = to_xs[b] - to_xs[a], to_ys[b] - to_ys[a], to_zs[b] - to_zs[a]
                excess = x * x + y * y + z * z - square
                excesses.append(excess)
                if factors:  # once it solves, it solves well, so that the pulls last
                    allowed *= FINER
                if not -allowed <= excess <= allowed:  # NaN too
                    if active[i]:
                        is_right = False
                    elif excess * kind > 0.0:
                        taut.append(i)
            if is_right and not taut:
                return
            alone = correction >= CHANGES
            for i in taut[:1] if alone else taut:
                active[i], factors = True, None
            factors = factors or self.factor([row[2:5] for row in rows], gains, active)
            right = [e * half if on else 0.0 for e, on in zip(excesses, active, strict=True)]
            changes = self.solve(factors, right)
            released = 0
            for i, (row, pull, change) in enumerate(zip(rows, pulls, changes, strict=True)):
                if (pull + change) * row[7] < 0.0 and not (alone and released):
                    changes[i] = change = -pull
                    active[i], factors = False, None
                    released += 1
                pulls[i] = pull + change
        raise ArithmeticError(TOO_FAR)
