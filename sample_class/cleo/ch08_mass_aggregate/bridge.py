"""Rope bridge."""

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
    links = []
    for i in range(len(rows)):
        a, b = rows[i]
        links.append(Rod(a, b, WIDTH))
        links.append(AnchoredCable(a, anchor_of(a), support_length(i)))
        links.append(AnchoredCable(b, anchor_of(b), support_length(i)))
        if i > 0:
            links.append(Cable(rows[i - 1][0], a, CABLE_LENGTH))
            links.append(Cable(rows[i - 1][1], b, CABLE_LENGTH))
    return links


class Deck:
    def __init__(self, ball, radius, rows, restitution=0.0):
        self.ball = ball
        self.radius = positive("radius", radius)
        self.rows = rows
        self.restitution = restitution

    def nearest(self):
        x = self.ball.position.x
        middles = []
        for a, b in self.rows:
            middles.append((a.position + b.position) * 0.5)
        if x < middles[0].x - SPACING / 2 or x > middles[-1].x + SPACING / 2:
            return None
        best = 0
        for i in range(len(middles)):
            if abs(middles[i].x - x) < abs(middles[best].x - x):
                best = i
        # the planks are flat
        return best, middles[best].y

    def contacts(self):
        nearest = self.nearest()
        if nearest is None:
            return []
        row, height = nearest
        depth = height + self.radius - self.ball.position.y
        if depth < 0 or depth > 2 * self.radius:
            return []
        a, b = self.rows[row]
        up = Vector3(0, 1, 0)
        return [
            Contact(self.ball, a, up, self.restitution, depth),
            Contact(self.ball, b, up, self.restitution, depth),
        ]


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
