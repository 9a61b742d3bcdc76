"""A game: bounce a ball from plank to plank over the rope bridge (project 8.1).

The ball jumps by itself from every row that it lands on; the player steers it in the air. A row
counts once. To land on all of them wins; to reach the ground costs a life.
"""

from __future__ import annotations

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate.bridge import RADIUS, Deck, links_of
from ch08_mass_aggregate.bridge_plan import DAMPING, GRAVITY, HEIGHT, make_rows
from ch08_mass_aggregate.world import ParticleWorld

LIVES = 3
POINTS = 10  # for a row, the first time
BONUS = 50  # for each life that is left when the game is won
JUMP = 6.0  # m/s, upwards, from a row
PUSH = 8.0  # m/s^2, to the side
DROP = 2.0  # m above the first row, where the ball begins
BALL_MASS = 1.0  # kg
TOUCH = 1e-6  # m: what is no higher above the ground lies on it, however that was rounded


class Rules:
    """What counts: ``score``, ``lives`` and ``visited``, the rows that were landed on."""

    def __init__(self, rows: int) -> None:
        self.rows = rows
        self.score = 0
        self.lives = LIVES
        self.visited: set[int] = set()

    @property
    def won(self) -> bool:
        return all(row in self.visited for row in range(self.rows))

    @property
    def over(self) -> bool:
        return self.lives <= 0 or self.won

    def landed(self, row: int) -> None:
        if row not in range(self.rows):
            raise ValueError(f"row must be from 0 to {self.rows - 1}, got {row!r}")
        if not self.over and row not in self.visited:
            self.visited.add(row)
            self.score += POINTS
            if self.won:
                self.score += BONUS * self.lives

    def fell(self) -> None:
        if not self.over:
            self.lives -= 1


class Landings:
    """Passes on a deck's contacts, and notes on which row the ball lands."""

    def __init__(self, deck: Deck) -> None:
        self.deck = deck
        self.row: int | None = None

    def contacts(self) -> list[Contact]:
        found = self.deck.contacts()
        self.row = None
        if found and self.deck.ball.velocity.y < 0.0:
            below = self.deck.nearest()
            if below is not None:
                self.row = below[0]
        return found


class BallGame:
    """The game: ``rules``, ``rows`` of planks, the ``ball``, and the ``world`` they are in."""

    def __init__(self) -> None:
        self.rows = make_rows()
        self.rules = Rules(len(self.rows))
        self.ball = Particle(acceleration=GRAVITY, mass=BALL_MASS, damping=DAMPING)
        self.direction = 0
        self.landings = Landings(Deck(self.ball, RADIUS, self.rows))
        planks = [end for row in self.rows for end in row]
        grounds = [GroundPlane(planks), GroundPlane([self.ball], radius=RADIUS)]
        self.world = ParticleWorld(
            [*planks, self.ball], [*links_of(self.rows), self.landings, *grounds]
        )
        self.start_ball()

    def start_ball(self) -> None:
        self.ball.position = Vector3(self.rows[0][0].position.x, HEIGHT + DROP)
        self.ball.velocity = Vector3()

    def step(self, duration: float) -> None:
        if self.rules.over:
            return
        positive("duration", duration)
        self.world.start_frame()
        self.ball.add_force(Vector3(self.direction * PUSH * self.ball.mass))
        self.world.run_physics(duration)
        if self.landings.row is not None:
            self.rules.landed(self.landings.row)
            self.ball.velocity.y = JUMP
        elif self.ball.position.y <= RADIUS + TOUCH:
            self.rules.fell()
            if not self.rules.over:
                self.start_ball()
