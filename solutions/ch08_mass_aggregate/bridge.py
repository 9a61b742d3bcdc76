"""A rope bridge made of planks and cables, and a heavy ball that rolls over it (book 8.2.1).

The dimensions of the bridge are in bridge_plan.py. Lengths are in m. Constructors raise ValueError
for a number that is out of range.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, ContactGenerator, a_restitution
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import AnchoredCable, Cable, Rod
from ch08_mass_aggregate.bridge_plan import (
    CABLE_LENGTH,
    DAMPING,
    GRAVITY,
    HEIGHT,
    SPACING,
    WIDTH,
    Row,
    anchor_of,
    make_rows,
    support_length,
)
from ch08_mass_aggregate.world import ParticleWorld

RADIUS = 0.5  # m, of the ball
# Per phase. With the default, a bridge at 30 steps per second never comes to rest.
ITERATIONS = 200
UP = Vector3(0.0, 1.0, 0.0)


def links_of(rows: Sequence[Row]) -> list[ContactGenerator]:
    """Create the rods and cables that hold the ``rows`` of planks of a rope bridge together.

    The planks must be at their start positions, which determine the anchors. The links are:

    - A Rod of length ``WIDTH`` joins the two ends of each row.
    - A Cable of ``CABLE_LENGTH`` joins each end to the end on the same side of the next row.
    - An AnchoredCable joins each end to its anchor, ``anchor_of(end)``. Its length is
      ``support_length(row)``, where ``row`` is the index of the row.

    All cables have a restitution of 0. Import the three classes from ``ch07_constraints.links``,
    and the names from the plan from ``ch08_mass_aggregate.bridge_plan``.
    """
    rods = [Rod(a, b, WIDTH) for a, b in rows]
    cables = [
        Cable(end, following_end, CABLE_LENGTH)
        for row, following in pairwise(rows)
        for end, following_end in zip(row, following, strict=True)
    ]
    supports = [
        AnchoredCable(end, anchor_of(end), support_length(i))
        for i, row in enumerate(rows)
        for end in row
    ]
    return [*rods, *cables, *supports]


class Deck:
    """A contact generator for a ball of a given ``radius`` that rolls over rows of planks.

    A row has particles only at its two ends, so a ball would fall through between them. The deck is
    a surface that connects the rows and carries the ball. ``rows`` must be in order along X, and
    there must be at least one.
    """

    def __init__(
        self, ball: Particle, radius: float, rows: Sequence[Row], restitution: float = 0.0
    ) -> None:
        self.ball = ball
        self.radius = positive("radius", radius)
        if not rows:
            raise ValueError("rows must have at least one row, got none")
        self.rows = rows
        self.restitution = a_restitution("restitution", restitution)

    def nearest(self) -> tuple[int, float] | None:
        """Find the row of planks nearest to the ball, and the height of the deck below the ball.

        Return the index of the row, and the height in m. Treat each row as a point, the midpoint of
        its two ends. The nearest row is the one whose midpoint is nearest along X. If two rows are
        equally near, return the first one. The deck is a line of straight segments that connect
        these midpoints, and continues at the same height before the first row and after the last.
        Return None if the ball is more than half a ``SPACING`` beyond the first or last row.
        """
        x = self.ball.position.x
        middles = [(a.position + b.position) / 2.0 for a, b in self.rows]
        first, last = middles[0], middles[-1]
        if not first.x - 0.5 * SPACING <= x <= last.x + 0.5 * SPACING:
            return None
        height = first.y if x < first.x else last.y
        for a, b in pairwise(middles):
            if a.x <= x < b.x:
                height = a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)
        row = min(range(len(middles)), key=lambda i: abs(middles[i].x - x))
        return row, height

    def contacts(self) -> list[Contact]:
        """Return the ball's contacts with both ends of the nearest row, if it touches the deck.

        In each contact, ``particle`` is the ball, ``other`` is one end of the row, and the normal
        is +Y. The penetration is the depth of the ball's lowest point below the deck. Return an
        empty list if the ball is above the deck or beyond the ends of the bridge. Do the same if
        the penetration is more than the ball's diameter, because it has then fallen through.
        """
        found = self.nearest()
        if found is None:
            return []
        row, height = found
        depth = height + self.radius - self.ball.position.y
        if not 0.0 <= depth <= 2.0 * self.radius:
            return []
        return [Contact(self.ball, end, UP, self.restitution, depth) for end in self.rows[row]]


class Bridge:
    """A rope bridge above the ground, with a heavy ball that rolls over it.

    ``world`` simulates the ``rows`` of planks and the ``ball``. ``ball_mass`` is in kg, and ``x``
    is where the ball starts along X in m. It moves along X at the speed ``pace`` in m/s, which is 0
    at first.
    """

    def __init__(self, ball_mass: float = 5.0, x: float = 0.0) -> None:
        start = Vector3(finite("x", x), HEIGHT + RADIUS)
        mass = positive("ball_mass", ball_mass)
        self.ball = Particle(start, acceleration=GRAVITY, mass=mass, damping=DAMPING)
        self.rows = make_rows()
        self.pace = 0.0
        planks = [end for row in self.rows for end in row]
        self.links = links_of(self.rows)
        grounds = [GroundPlane(planks), GroundPlane([self.ball], radius=RADIUS)]
        self.world = ParticleWorld(
            [*planks, self.ball],
            [*self.links, Deck(self.ball, RADIUS, self.rows), *grounds],
            iterations=ITERATIONS,
        )

    def step(self, duration: float) -> None:
        """Advance the bridge by a time step of ``duration`` s. The ball moves along X at ``pace``.

        Raises ValueError, and changes nothing, if the duration or the pace is invalid.
        """
        positive("duration", duration)
        pace = finite("pace", self.pace)
        self.world.start_frame()
        self.ball.velocity.x = pace
        self.world.run_physics(duration)
