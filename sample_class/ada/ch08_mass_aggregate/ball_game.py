"""Ada's ball game."""

from ch02_vectors.arguments import positive
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
        return self.visited.issuperset(range(self.rows))

    @property
    def over(self):
        return not self.lives or self.won

    def landed(self, row):
        if row not in range(self.rows):
            raise ValueError(f"row {row!r} of {self.rows} rows")
        if not self.over and row not in self.visited:
            self.visited.add(row)
            self.score += POINTS + self.won * self.lives * BONUS

    def fell(self):
        self.lives -= not self.over


class Landings:
    def __init__(self, deck):
        self.deck = deck
        self.row = None

    def contacts(self):
        found = self.deck.contacts()
        falls = self.deck.ball.velocity.y < 0
        self.row = self.deck.nearest()[0] if found and falls else None
        return found


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
        h = positive("duration", duration)
        if self.rules.over:
            return
        self.world.start_frame()
        self.ball.add_force(Vector3(self.direction * PUSH * self.ball.mass, 0, 0))
        self.world.run_physics(h)
        if self.landings.row is not None:
            self.rules.landed(self.landings.row)
            self.ball.velocity.y = JUMP
        elif self.ball.position.y - RADIUS <= TOUCH:
            self.rules.fell()
            if not self.rules.over:
                self.start_ball()
