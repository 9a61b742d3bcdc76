"""Ada's rope bridge."""

from itertools import pairwise

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import AnchoredCable, Cable, Rod
from ch08_mass_aggregate.bridge_plan import (
    CABLE_LENGTH,
    DAMPING,
    GRAVITY,
    HEIGHT,
    SPACING,
    WIDTH,
    anchor_of,
    make_rows,
    support_length,
)
from ch08_mass_aggregate.world import ParticleWorld

RADIUS = 0.5
ITERATIONS = 200


def links_of(rows):
    planks = [Rod(*row, WIDTH) for row in rows]
    sides = [*zip(*rows)]  # the ends at z < 0, and those at z > 0
    ropes = [Cable(*ends, CABLE_LENGTH) for side in sides for ends in pairwise(side)]
    hangers = [
        AnchoredCable(end, anchor_of(end), support_length(i))
        for side in sides
        for i, end in enumerate(side)
    ]
    return planks + ropes + hangers


class Deck:
    def __init__(self, ball, radius, rows, restitution=0.0):
        self.ball = ball
        self.radius = positive("radius", radius)
        self.rows = rows
        self.restitution = restitution

    def nearest(self):
        x = self.ball.position.x
        middles = [(a.position + b.position) / 2 for a, b in self.rows]
        away = [abs(m.x - x) for m in middles]
        beyond = max(middles[0].x - x, x - middles[-1].x)
        if beyond > SPACING / 2:
            return None
        return away.index(min(away)), height_at(x, middles)

    def contacts(self):
        found = self.nearest()
        if found is None:
            return []
        row, height = found
        depth = height - (self.ball.position.y - self.radius)
        if not 0 <= depth <= 2 * self.radius:
            return []
        return [
            Contact(self.ball, end, Vector3(0, 1, 0), self.restitution, depth)
            for end in self.rows[row]
        ]


def height_at(x, middles):
    if x <= middles[0].x:
        return middles[0].y
    for a, b in pairwise(middles):
        if x <= b.x:
            s = (x - a.x) / (b.x - a.x)
            return a.y * (1 - s) + b.y * s
    return middles[-1].y


class Bridge:
    def __init__(self, ball_mass=5.0, x=0.0):
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

    def step(self, duration):
        self.ball.velocity.x = self.pace
        self.world.step(duration)
