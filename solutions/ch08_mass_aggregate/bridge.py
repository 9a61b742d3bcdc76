"""A rope bridge: planks on cables, and a heavy ball that walks over them (book 8.2).

bridge_plan.py has the numbers and places of what it is made of.
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
ITERATIONS = 200  # a phase; with twice the contacts a bridge at 30 frames a second never lies still


def links_of(rows: Sequence[Row]) -> list[ContactGenerator]:
    """Return what holds the rows, which are at their places at the start.

    A Rod of WIDTH joins both ends of each row; a Cable of CABLE_LENGTH each end to that of the next
    row on its side; and each end hangs on an AnchoredCable of support_length(row) from
    anchor_of(it). No cable bounces.
    """
    links: list[ContactGenerator] = [Rod(a, b, WIDTH) for a, b in rows]
    for row, following in pairwise(rows):
        for a, b in zip(row, following, strict=True):
            links.append(Cable(a, b, CABLE_LENGTH))
    for i, row in enumerate(rows):
        for plank in row:
            links.append(AnchoredCable(plank, anchor_of(plank), support_length(i)))
    return links


class Deck:
    """Generates the contacts of a ball with the rows of planks, which are in order along X.

    ValueError where the radius is not positive and finite, the restitution is not from 0 to 1, or
    there are no rows.
    """

    def __init__(
        self, ball: Particle, radius: float, rows: Sequence[Row], restitution: float = 0.0
    ) -> None:
        self.ball = ball
        self.radius = positive("radius", radius)
        if not rows:
            raise ValueError("rows must be one or more, got none")
        self.rows = rows
        self.restitution = a_restitution("restitution", restitution)

    def nearest(self) -> tuple[int, float] | None:
        """Return the number of the row that is nearest to the ball along X, and the deck's height.

        A row is where the middle of its ends is. The height in m is that below the ball, on the
        straight line from row to row; before the first row and after the last it is that row's. Of
        two rows that are equally near it is the first. None where the ball is further than half a
        SPACING beyond the rows.
        """
        x = self.ball.position.x
        places = [(a.position + b.position) * 0.5 for a, b in self.rows]
        if not places[0].x - 0.5 * SPACING <= x <= places[-1].x + 0.5 * SPACING:
            return None
        height = places[0].y if x < places[0].x else places[-1].y
        for a, b in pairwise(places):
            if a.x <= x < b.x:
                height = a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)
        row = min(range(len(places)), key=lambda i: abs(places[i].x - x))
        return row, height

    def contacts(self) -> list[Contact]:
        """Return a contact of the ball with each end of the nearest row, where it touches the deck.

        The ball is the particle, the normal is +Y, and the penetration is how far the ball's lowest
        point is below the deck. There is none where it is above, beyond the bridge, or deeper than
        it is high: then it is below.
        """
        found = self.nearest()
        if found is None:
            return []
        row, height = found
        depth = height + self.radius - self.ball.position.y
        if not 0.0 <= depth <= 2.0 * self.radius:
            return []
        up = Vector3(0.0, 1.0, 0.0)
        return [Contact(self.ball, end, up, self.restitution, depth) for end in self.rows[row]]


class Bridge:
    """The bridge with its ball over the ground: ``rows`` of planks, ``ball`` and ``world``.

    ``pace`` is how fast in m/s the ball walks along X. Raises ValueError where the ball's mass is
    not positive and finite, or its place is not finite.
    """

    def __init__(self, ball_mass: float = 5.0, x: float = 0.0) -> None:
        place = Vector3(finite("x", x), HEIGHT + RADIUS)
        mass = positive("ball_mass", ball_mass)
        self.ball = Particle(place, acceleration=GRAVITY, mass=mass, damping=DAMPING)
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
        """Let a frame of a duration in s pass, with the ball at its pace.

        Raises ValueError where the duration is not positive and finite, or the pace not finite; all
        is then as it was.
        """
        positive("duration", duration)
        pace = finite("pace", self.pace)
        self.world.start_frame()
        self.ball.velocity.x = pace
        self.world.run_physics(duration)
