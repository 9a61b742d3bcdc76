"""Going further: the links of a net as plain numbers, and the equations for their pulls.

DirectNet and SmoothNet solve for the pulls of all links at once. Both inherit from the class Net in
this module. Net stores the links as plain numbers and sets up the equations.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import combinations
from typing import Any

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import AnchoredCable, AnchoredRod, Cable, Limits, Rod
from scenes.links import Strut
from studies.models.elimination import Elimination

ROD, CABLE, STRUT = 0, 1, -1  # keeps its length; must not be longer; must not be shorter
# Where cables are redundant, for example four in a row along one line, the equations for their
# pulls have many solutions. This fraction more on the diagonal chooses one of them.
REGULARIZED = 1.0 + 1e-10
SLIGHT = 1e-9  # the fraction of what is balanced that rounding leaves
MOST = 1000  # sets of active links that are tried
CHANGES = 30  # sets of taut cables that are tried at once; after that, one cable changes at a time

Limit = tuple[Particle, Particle | Vector3, float, int]
Way = tuple[float, float, float]
Row = tuple[int, int, float, int]  # the two ends, the length squared in m^2, and the kind


def limits_of(link: Any) -> list[Limit]:
    """Return the limits of ``link`` as tuples (one end, other end, length, kind).

    The length is in m. A Limits object has two entries: a cable and, unless ``min_length`` is 0, a
    strut.

    Raises:
        TypeError: for a link of any other kind.
    """
    if isinstance(link, Rod):  # also a TwoSidedRod
        return [(link.a, link.b, link.length, ROD)]
    if isinstance(link, AnchoredRod):
        return [(link.particle, link.anchor, link.length, ROD)]
    if isinstance(link, Cable):
        return [(link.a, link.b, link.max_length, CABLE)]
    if isinstance(link, AnchoredCable):
        return [(link.particle, link.anchor, link.max_length, CABLE)]
    if isinstance(link, Strut):
        return [(link.a, link.b, link.min_length, STRUT)]
    if isinstance(link, Limits):
        longest: list[Limit] = [(link.a, link.b, link.max_length, CABLE)]
        shortest: list[Limit] = [(link.a, link.b, link.min_length, STRUT)]
        return longest + (shortest if link.min_length else [])
    raise TypeError(f"a link must be a rod, a cable, Limits or a Strut, got {link!r}")


LINKS = (Rod, AnchoredRod, Cable, AnchoredCable, Limits, Strut)


class Net:
    """Rods and cables between particles and anchors, and the equations for their pulls.

    ``links`` are rods, cables and Limits of chapter 7, and Struts. ``others`` are particles that no
    link holds, but that move together with the net. ``particles`` lists every particle once. The
    particles of the links come first, in the order of the links. The net reads the lengths of the
    links only once, when it is created.

    Raises:
        ValueError: if there are no links.
        TypeError: if one of the links is of another kind.
    """

    def __init__(self, links: Iterable[Any], others: Iterable[Particle] = ()) -> None:
        self.links = [*links]
        if not self.links:
            raise ValueError("links must have at least one link, got none")
        limits = [limit for link in self.links for limit in limits_of(link)]
        ends: dict[Any, int] = {}  # their numbers; particles first
        for a, b, _, _ in limits:
            ends.setdefault(a, len(ends))
            if isinstance(b, Particle):
                ends.setdefault(b, len(ends))
        self.particles: list[Particle] = list(dict.fromkeys([*ends, *others]))
        self.anchors: list[Vector3] = []
        self.rows: list[Row] = []
        for a, b, length, kind in limits:
            if isinstance(b, Particle):
                end = ends[b]
            else:
                end = len(self.particles) + len(self.anchors)
                self.anchors.append(b)
            square = positive("the length of a link", length) ** 2
            self.rows.append((ends[a], end, square, kind))
        self.count = len(self.particles) + len(self.anchors)
        self.lengths = [length for _, _, length, _ in limits]
        self.is_active = [kind == ROD for *_, kind in self.rows]
        self._equations: Elimination | None = None
        self._products: list[tuple[int, int, int, int, float]] = []

    def inverse_masses(self) -> list[float]:
        """Return the inverse masses of all ends in 1/kg. An anchor has an inverse mass of 0."""
        return [p.inverse_mass for p in self.particles] + [0.0] * len(self.anchors)

    def places(self) -> tuple[list[float], list[float], list[float]]:
        """Return three lists with the x, y and z of all particles and then of the anchors."""
        points = [particle.position for particle in self.particles] + self.anchors
        return [p.x for p in points], [p.y for p in points], [p.z for p in points]

    def state(self) -> tuple[list[float], list[float]]:
        """Return positions and velocities as two lists: first all x, then all y, then all z."""
        xs, ys, zs = self.places()
        moving = [p.velocity if p.inverse_mass else Vector3() for p in self.particles]
        still = [0.0] * len(self.anchors)
        us, vs, ws = ([getattr(v, axis) for v in moving] + still for axis in "xyz")
        return xs + ys + zs, us + vs + ws

    def write(self, places: Sequence[float], speeds: Sequence[float]) -> None:
        """Set the positions and velocities of the particles, in the order of ``state``."""
        count = self.count
        for i, particle in enumerate(self.particles):
            if particle.inverse_mass:
                position, velocity = particle.position, particle.velocity
                position.x, velocity.x = places[i], speeds[i]
                position.y, velocity.y = places[i + count], speeds[i + count]
                position.z, velocity.z = places[i + 2 * count], speeds[i + 2 * count]

    def directions(self, values: Sequence[float]) -> list[Way]:
        """Return the difference of ``values`` between the two ends of each link.

        ``values`` are in the order of ``state``.
        """
        xs, ys, zs = (
            values[: self.count],
            values[self.count : 2 * self.count],
            values[-self.count :],
        )
        return [(xs[b] - xs[a], ys[b] - ys[a], zs[b] - zs[a]) for a, b, _, _ in self.rows]

    def pull(
        self,
        values: list[float],
        directions: Sequence[Way],
        gains: Sequence[float],
        pulls: Sequence[float],
    ) -> None:
        """Add the effect of the pulls on the ends of each link to ``values``.

        ``values`` are in the order of ``state``.
        """
        count = self.count
        for (a, b, _, _), (x, y, z), pull in zip(self.rows, directions, pulls, strict=True):
            if pull:
                gain = gains[a] * pull
                values[a] += x * gain
                values[a + count] += y * gain
                values[a + 2 * count] += z * gain
                gain = gains[b] * pull
                if gain:
                    values[b] -= x * gain
                    values[b + count] -= y * gain
                    values[b + 2 * count] -= z * gain

    def of_active(self, right: Sequence[float]) -> list[float]:
        """Return the right side of the equations, with 0 for links that are not active."""
        return [r if on else 0.0 for r, on in zip(right, self.is_active, strict=True)]

    def balance(
        self,
        directions: Sequence[Way],
        gains: Sequence[float],
        right: Sequence[float],
        near: Iterable[int],
    ) -> tuple[list[float], list[float]]:
        """Return the pulls that bring ``right`` to 0, and the factors of the equations for them.

        Cables may only pull. The search for the active links begins with those that are active now,
        and with the links in ``near``, which are close to their limit. If a link would have to
        push, it is released. If a released link would then get too long, it is tried again. After
        several such changes, only one link changes at a time, which guarantees that the search ends
        (Murty, Linear Algebra and its Applications 7, 1974, 65).
        """
        tried = {*near, *(i for i, on in enumerate(self.is_active) if on)}
        for i in tried:
            self.is_active[i] = True
        for attempt in range(MOST):
            factors = self.factor(directions, gains, self.is_active)
            pulls = self.solve(factors, self.of_active(right))
            changed = [i for i in tried if self.is_active[i] and pulls[i] * self.rows[i][3] < 0.0]
            if len(changed) < len(tried) and not all(self.is_active[i] for i in tried):
                moved = [0.0] * (3 * self.count)
                self.pull(moved, directions, gains, pulls)
                for i in tried:
                    if not self.is_active[i]:
                        x, y, z = directions[i]
                        a, b, _, kind = self.rows[i]
                        u = moved[b] - moved[a]
                        v = moved[b + self.count] - moved[a + self.count]
                        w = moved[b + 2 * self.count] - moved[a + 2 * self.count]
                        left = right[i] + x * u + y * v + z * w
                        if left * kind > SLIGHT * (abs(right[i]) + abs(left)):
                            changed.append(i)
            if not changed:
                return pulls, factors
            for i in changed if attempt < CHANGES else [min(changed)]:
                self.is_active[i] = not self.is_active[i]
        raise ArithmeticError("no set of taut cables balances the net")

    def factor(
        self,
        directions: Sequence[Way],
        gains: Sequence[float],
        is_active: Sequence[bool],
    ) -> list[float]:
        """Return the factors of the equations for the pulls of the active links.

        Row i describes how fast the pulls shorten link i. ``directions`` are the vectors r along
        the links. Each pull changes the velocities of the ends of its link, and the row contains
        the components of these changes along r_i. ``gains`` are the changes of velocity that one
        unit of pull causes at each end. They are 0 for an immovable end. The row of an inactive
        link has a 1 on the diagonal and zeros elsewhere.
        """
        if self._equations is None:
            self._analyze()
        assert self._equations is not None
        values = [0.0] * self._equations.size
        for i, ((a, b, _, _), (x, y, z)) in enumerate(zip(self.rows, directions, strict=True)):
            values[i] = (gains[a] + gains[b]) * (x * x + y * y + z * z) * REGULARIZED
        for slot, i, j, end, sign in self._products:
            if is_active[i] and is_active[j]:
                ax, ay, az = directions[i]
                bx, by, bz = directions[j]
                values[slot] += sign * gains[end] * (ax * bx + ay * by + az * bz)
        for i, active in enumerate(is_active):
            if not (active and values[i]):
                values[i] = 1.0
        self._equations.factor(values)
        return values

    def solve(self, factors: Sequence[float], right: Sequence[float]) -> list[float]:
        """Return the pulls for the right side of the equations."""
        assert self._equations is not None
        return self._equations.solve(factors, right)

    def _analyze(self) -> None:
        """Find which links share a particle, because their pulls appear in the same equation."""
        at: list[list[tuple[int, float]]] = [[] for _ in self.particles]
        for i, (a, b, _, _) in enumerate(self.rows):
            at[a].append((i, 1.0))
            if b < len(self.particles):
                at[b].append((i, -1.0))
        shared = [
            (i, j, end, s * t)
            for end, links in enumerate(at)
            for (i, s), (j, t) in combinations(links, 2)
        ]
        self._equations = Elimination(len(self.rows), [(i, j) for i, j, _, _ in shared])
        self._products = [(self._equations.slot_of(i, j), i, j, e, s) for i, j, e, s in shared]
