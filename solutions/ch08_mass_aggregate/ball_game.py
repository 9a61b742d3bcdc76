"""A game in which a ball bounces over the rope bridge, from row to row (project 8.1).

The ball jumps automatically whenever it lands on a row of planks, and the player steers it. The
player wins by landing on every row, and loses a life whenever the ball touches the ground.
"""

from __future__ import annotations

from ch02_vectors.arguments import positive, whole
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate.bridge import RADIUS, Deck, links_of
from ch08_mass_aggregate.bridge_plan import DAMPING, GRAVITY, HEIGHT, make_rows
from ch08_mass_aggregate.world import ParticleWorld

LIVES = 3
POINTS = 10  # for a row, the first time
BONUS = 50  # for each life that is left in the end
JUMP = 6.0  # m/s, upward, from a row
PUSH = 8.0  # m/s^2, sideways
DROP = 2.0  # m, from where the ball starts down to the bridge
BALL_MASS = 1.0  # kg
TOUCH = 1e-6  # m: a ball this close to the ground touches it, whatever the rounding


class Rules:
    """The rules of the bridge game, which keep the score and count the lives.

    ``rows`` is the number of rows of the bridge, which must be at least 1. ``visited`` is the set
    of rows on which the ball has landed. The game calls ``landed`` and ``fell``.
    """

    def __init__(self, rows: int) -> None:
        self.rows = whole("rows", rows)
        self.score = 0
        self.lives = LIVES
        self.visited: set[int] = set()

    @property
    def won(self) -> bool:
        """True if the ball has landed on every row of the bridge."""
        return len(self.visited) == self.rows

    @property
    def over(self) -> bool:
        """True if the game is won, or no lives are left. Then score and lives do not change."""
        return self.won or self.lives == 0

    def landed(self, row: int) -> None:
        """Count a landing of the ball on the row of planks with the index ``row``.

        The first landing on a row gives ``POINTS``. If it wins the game, it also gives ``BONUS``
        for each life that is left. Later landings on the same row change nothing, and neither does
        a landing after the game is over.
        """
        if self.over or row in self.visited:
            return
        self.visited.add(row)
        self.score += POINTS
        if self.won:
            self.score += BONUS * self.lives

    def fell(self) -> None:
        """Take away one life because the ball hit the ground. Do nothing if the game is over."""
        if not self.over:
            self.lives -= 1


class Landings:
    """A contact generator that returns the contacts of ``deck`` and records where the ball lands.

    The world calls ``contacts`` once per step. If the ball then touched the deck on its way down,
    ``row`` is the index of the row nearest to the ball. Otherwise ``row`` is None.
    """

    def __init__(self, deck: Deck) -> None:
        self.deck = deck
        self.row: int | None = None

    def contacts(self) -> list[Contact]:
        """Return the contacts between the ball and the planks, and record the row that was hit.

        ``row`` is set to None if the ball does not touch the planks or is not moving toward them.
        """
        found, nearest = self.deck.contacts(), self.deck.nearest()
        self.row = None
        if nearest and found and found[0].separating_velocity() < 0.0:
            self.row, _ = nearest
        return found


class BallGame:
    """The bridge game: ``rules``, and a ``world`` that moves the ``ball`` and the ``rows``.

    Set ``direction`` to steer the ball: -1 means left, 1 means right, and 0 means neither.
    """

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
        """Place the ball at rest above the first row of the bridge, at ``HEIGHT + DROP``."""
        self.ball.position = Vector3(self.rows[0][0].position.x, HEIGHT + DROP)
        self.ball.velocity = Vector3()

    def step(self, duration: float) -> None:
        """Advance the game by one time step of ``duration`` s, or do nothing if the game is over.

        First push the ball in the player's direction so that it gets an acceleration of ``PUSH``,
        and step the world. Then:

        - If the ball has landed on a row, report the landing to the rules. Make the ball jump by
          setting its vertical velocity to ``JUMP``, and leave its velocity along X as it is.
        - Otherwise, if its lowest point is at most ``TOUCH`` above the ground, report the fall to
          the rules. Then put the ball back at its start, unless the player has no lives left.
        """
        positive("duration", duration)
        if self.rules.over:
            return
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
