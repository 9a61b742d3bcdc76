"""A rope bridge made of planks and cables, and a heavy ball that rolls over it (book 8.2.1).

The dimensions of the bridge are in bridge_plan.py.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, ContactGenerator, a_restitution
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate.bridge_plan import DAMPING, GRAVITY, HEIGHT, Row, make_rows
from ch08_mass_aggregate.world import ParticleWorld

RADIUS = 0.5  # m, of the ball
# Per phase. With the default, a bridge at 30 steps per second never comes to rest.
ITERATIONS = 200


def links_of(rows: Sequence[Row]) -> list[ContactGenerator]:
    """Create the rods and cables that hold the ``rows`` of planks of a rope bridge together.

    The planks must be at their start positions, because the positions of the anchors depend on
    them. The result is a list of these links:

    - A Rod of length ``WIDTH`` joins the two ends of each row.
    - A Cable of ``CABLE_LENGTH`` joins each end to the end on the same side of the next row.
    - An AnchoredCable joins each end to its anchor, ``anchor_of(end)``. Its length is
      ``support_length(row)``, where ``row`` is the index of the row.

    All cables have a restitution of 0. Import the classes from ``ch07_constraints.links``, and
    ``WIDTH``, ``CABLE_LENGTH``, ``anchor_of`` and ``support_length`` from
    ``ch08_mass_aggregate.bridge_plan``.
    """
    raise NotImplementedError("Exercise B8.4: The links of a rope bridge")


class Deck:
    """A contact generator for a ball that rolls over rows of planks.

    A row has particles only at its two ends, so a ball would fall through between them. The deck is
    a surface that connects the rows and carries the ball. ``radius`` is the radius of the ball in
    m, and ``rows`` must be in order along X.

    Raises:
        ValueError: if the radius is not positive and finite, the restitution is not between 0 and
            1, or there are no rows.
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

        The result is the index of the row, and the height in m directly below the ball. Treat each
        row as a point, the midpoint of its two ends. The nearest row is the one whose midpoint is
        nearest along X. The deck is a line of straight segments that connect these midpoints. It
        continues at the same height before the first row and after the last one.

        If two rows are equally near, return the first one. Return None if the ball is more than
        half a ``SPACING`` beyond the first or last row.
        """
        raise NotImplementedError("Exercise B8.5: A ball on planks")

    def contacts(self) -> list[Contact]:
        """Return the ball's contacts with both ends of the nearest row, if it touches the deck.

        In each contact, ``particle`` is the ball, ``other`` is one end of the row, and the normal
        is +Y. The penetration is the depth of the ball's lowest point below the deck.

        Return an empty list if the ball is above the deck or beyond the ends of the bridge. Also
        return an empty list if the penetration is more than the ball's diameter, because the ball
        has then already fallen through the deck.
        """
        raise NotImplementedError("Exercise B8.5: A ball on planks")


class Bridge:
    """A rope bridge above the ground, with a heavy ball that rolls over it.

    ``world`` simulates the ``rows`` of planks and the ``ball``. ``ball_mass`` is in kg, and ``x``
    is the start position of the ball along X in m. The bridge moves the ball along X at the speed
    ``pace`` in m/s, which is 0 at first.

    Raises:
        ValueError: if the ball's mass is not positive and finite, or x is not finite.
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
        """Advance the bridge by a time step of ``duration`` s. The ball moves along X at ``pace``.

        Raises:
            ValueError: if the duration is not positive and finite, or the pace is not finite. In
                that case nothing changes.
        """
        positive("duration", duration)
        pace = finite("pace", self.pace)
        self.world.start_frame()
        self.ball.velocity.x = pace
        self.world.run_physics(duration)
