"""Ball game."""

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate.bridge import RADIUS, Deck, links_of
from ch08_mass_aggregate.bridge_plan import DAMPING, GRAVITY, HEIGHT, make_rows
from ch08_mass_aggregate.world import ParticleWorld

LIVES = 3
POINTS = 10
BONUS = 50
JUMP = 6.0
PUSH = 8.0
DROP = 2.0
BALL_MASS = 1.0
TOUCH = 1e-6


class Rules:
    def __init__(self, rows):
        self.rows = rows
        self.score = 0
        self.lives = LIVES
        self.visited = set()

    @property
    def won(self):
        return len(self.visited) == self.rows

    @property
    def over(self):
        return self.won or self.lives == 0

    def landed(self, row):
        if row < 0 or row >= self.rows:
            raise ValueError(f"row must be from 0 to {self.rows - 1}, got {row!r}")
        if self.over:
            return
        if row in self.visited:
            return
        self.visited.add(row)
        self.score += POINTS
        if self.won:
            self.score += BONUS * self.lives

    def fell(self):
        if not self.over:
            self.lives -= 1


class Landings:
    def __init__(self, deck):
        self.deck = deck
        self.row = None

    def contacts(self):
        raise NotImplementedError("Exercise P8.1b: A ball game: the play")


class BallGame:
    def __init__(self):
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

    def start_ball(self):
        self.ball.position = Vector3(self.rows[0][0].position.x, HEIGHT + DROP)
        self.ball.velocity = Vector3()

    def step(self, duration):
        raise NotImplementedError("Exercise P8.1b: A ball game: the play")
