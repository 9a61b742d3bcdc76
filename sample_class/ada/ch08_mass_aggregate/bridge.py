"""A rope bridge: planks on cables, and a heavy ball that walks over them (book 8.2.1).

bridge_plan.py has the numbers and places of what it is made of.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, ContactGenerator
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
    links: list[ContactGenerator] = []
    before: Row | None = None
    for number, row in enumerate(rows):
        for side, end in enumerate(row):
            links.append(AnchoredCable(end, anchor_of(end), support_length(number)))
            if before is not None:
                links.append(Cable(before[side], end, CABLE_LENGTH))
        links.append(Rod(*row, WIDTH))
        before = row
    return links


class Deck:
    """Generates the contacts of a ball with the rows of planks, which are in order along X."""

    def __init__(
        self, ball: Particle, radius: float, rows: Sequence[Row], restitution: float = 0.0
    ) -> None:
        self.ball = ball
        self.radius = positive("radius", radius)
        self.rows = rows
        self.restitution = restitution

    def nearest(self) -> tuple[int, float] | None:
        middles = [(front.position + back.position) * 0.5 for front, back in self.rows]
        if not middles:
            return None
        x = self.ball.position.x
        first, last = middles[0], middles[-1]
        if x < first.x - 0.5 * SPACING or x > last.x + 0.5 * SPACING:
            return None
        number, best = 0, abs(first.x - x)
        for i, middle in enumerate(middles):
            if abs(middle.x - x) < best:
                number, best = i, abs(middle.x - x)
        if x <= first.x:
            return number, first.y
        for left, right in pairwise(middles):
            if left.x < x <= right.x:
                share = (x - left.x) / (right.x - left.x)
                return number, left.y * (1.0 - share) + right.y * share
        return number, last.y

    def contacts(self) -> list[Contact]:
        below = self.nearest()
        if below is None:
            return []
        number, height = below
        depth = height - (self.ball.position.y - self.radius)
        if depth < 0.0 or depth > 2.0 * self.radius:
            return []
        up = Vector3(0.0, 1.0, 0.0)
        near, far = self.rows[number]
        return [
            Contact(self.ball, near, up, self.restitution, depth),
            Contact(self.ball, far, up, self.restitution, depth),
        ]


class Bridge:
    """The bridge with its ball over the ground: ``rows`` of planks, ``ball`` and ``world``."""

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
        self.ball.velocity.x = self.pace
        self.world.step(duration)
