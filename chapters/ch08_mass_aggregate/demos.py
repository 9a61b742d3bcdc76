"""The demos of chapter 8. Here are the rope bridge and the game on it; the others are imported."""

from __future__ import annotations

from matplotlib.figure import Figure
from matplotlib.patches import Circle

from ch08_mass_aggregate import ball_game, bridge
from ch08_mass_aggregate.demos_common import (
    WOOD,
    WorldDemo,
    draw_anchors,
    draw_cables,
    draw_ground,
    lines,
    seen,
)
from ch08_mass_aggregate.demos_of_bodies import Blob, Platform
from ch08_mass_aggregate.demos_of_rods import Cube, Wheel
from ch08_mass_aggregate.demos_of_trebuchet import Trebuchet
from studies.drawing import BLACK, GREEN, ORANGE, RED
from studies.links import over_length


class Bridge(WorldDemo):
    """A heavy ball walks over a rope bridge, in frames of one length or in some that are late."""

    seconds = 12.0
    keys = (
        "The left and right arrow keys walk, up, down or the space bar stop, v switches late "
        "frames on and off, r starts anew."
    )
    RATE = 60.0  # Hz
    PACE = 1.5  # m/s
    MAX_STEPS = 6  # a frame
    LATE = 0.5  # s, what a late frame takes
    EVERY = 60  # frames, one of them is late

    def __init__(self, figure: Figure) -> None:
        super().__init__(figure)
        axes = figure.subplots()
        axes.set(xlim=(-8.0, 8.0), ylim=(-1.0, 7.6), aspect="equal", xlabel="x, m", ylabel="y, m")
        draw_ground(axes, 1.0)
        self.cables = lines(axes, BLACK)
        self.planks = lines(axes, WOOD, 5.0)
        self.ball = axes.add_patch(Circle((0, 0), bridge.RADIUS, color=ORANGE, zorder=3))
        self.varies = False
        self.start()
        draw_anchors(axes, self.bridge.world.contact_generators)

    def start(self) -> None:
        """Build the bridge anew, with the ball in its middle."""
        self.bridge = bridge.Bridge()
        self.frames = 0
        self.run(self.bridge.step, self.bridge.world, self.RATE, self.MAX_STEPS)

    def advance(self, duration: float) -> None:
        self.frames += 1
        if self.varies and self.frames % self.EVERY == 0:
            duration = self.LATE
        super().advance(duration)

    def draw(self) -> None:
        generators = self.bridge.world.contact_generators
        draw_cables(self.cables, generators)
        self.planks.set_segments(
            [[seen(a.position), seen(b.position)] for a, b in self.bridge.rows]
        )
        x, y = self.bridge.ball.position.x, self.bridge.ball.position.y
        self.ball.set(center=(x, y))
        frames = "every frame takes 17 ms (v: late frames)"
        if self.varies:
            frames = (
                f"every {self.EVERY}th frame takes {1000.0 * self.LATE:.0f} ms; at most "
                f"{self.MAX_STEPS} steps a frame: {self.clock.dropped:.2f} s were dropped so far"
            )
        self.say(
            f"the ball is at x = {x:.1f} m, y = {y:.1f} m; the worst cable is "
            f"{over_length(generators):.3f} % too long\n{frames}"
        )

    def press(self, key: str) -> None:
        if key in ("left", "right"):
            self.bridge.pace = self.PACE if key == "right" else -self.PACE
        elif key in ("up", "down", " "):
            self.bridge.pace = 0.0
        elif key == "v":
            self.varies = not self.varies
            self.frames = 0
            self.clock.dropped = 0.0
        elif key == "r":
            self.start()

    def play(self, time: float) -> None:
        """Walk to the left, then with late frames to the right and off the bridge."""
        orders = {60: "left", 200: " ", 240: "v", 250: "right", 645: " "}
        if key := orders.get(round(60.0 * time)):
            self.press(key)


class Ball(WorldDemo):
    """A game: bounce from plank to plank, and do not fall (project 8.1)."""

    seconds = 12.0
    keys = "The left and right arrow keys steer, down steers neither way, r begins a new game."
    RATE = 60.0  # Hz
    FORESIGHT = 0.4  # s, by which the invented player looks ahead

    def __init__(self, figure: Figure) -> None:
        super().__init__(figure)
        axes = figure.subplots()
        axes.set(xlim=(-8.0, 8.0), ylim=(-1.0, 7.6), aspect="equal", xlabel="x, m", ylabel="y, m")
        draw_ground(axes, 1.0)
        self.cables = lines(axes, BLACK, 0.7)
        self.planks = lines(axes, WOOD, 5.0)
        self.ball = axes.add_patch(Circle((0, 0), bridge.RADIUS, color=ORANGE, zorder=3))
        self.left = axes.plot([], [], "o", color=ORANGE, ms=9)[0]
        self.end = axes.text(
            0.0, 0.8, "", fontsize=22, ha="center", va="center", weight="bold", zorder=4
        )
        self.start()
        draw_anchors(axes, self.game.world.contact_generators)

    def start(self) -> None:
        """Begin a game."""
        self.game = ball_game.BallGame()
        self.run(self.game.step, self.game.world, self.RATE)

    def draw(self) -> None:
        game, rules = self.game, self.game.rules
        draw_cables(self.cables, game.world.contact_generators)
        self.planks.set_segments([[seen(a.position), seen(b.position)] for a, b in game.rows])
        self.planks.set(colors=[GREEN if i in rules.visited else WOOD for i in range(rules.rows)])
        self.ball.set(center=(game.ball.position.x, game.ball.position.y))
        self.left.set_data([-7.5 + 0.5 * i for i in range(rules.lives)], [6.7] * rules.lives)
        words = "won: r begins anew" if rules.won else "lost: r begins anew"
        self.end.set(text=words if rules.over else "", color=GREEN if rules.won else RED)
        steers = {-1: "to the left", 0: "neither way", 1: "to the right"}[game.direction]
        self.say(
            f"score {rules.score}, lives {rules.lives}, rows {len(rules.visited)} of {rules.rows}"
            f"\nsteers {steers}"
        )

    def press(self, key: str) -> None:
        if key == "r":
            self.start()
        elif key in ("left", "right", "down"):
            self.game.direction = {"left": -1, "down": 0, "right": 1}[key]

    def play(self, time: float) -> None:
        """Win a game, by steering to the next row that was not visited; then lose another one."""
        frame = round(60.0 * time)
        if frame == 424:
            self.press("r")
        elif frame > 424:
            self.press("left" if frame > 474 else "down")
        else:
            self.press(self.next_key())

    def next_key(self) -> str:
        """Return the key that steers to the first row that was not visited."""
        game = self.game
        for row, (a, b) in enumerate(game.rows):
            if row not in game.rules.visited:
                there = 0.5 * (a.position.x + b.position.x)
                foreseen = game.ball.position.x + self.FORESIGHT * game.ball.velocity.x
                return "right" if there > foreseen else "left"
        return "down"


DEMOS = (Bridge, Platform, Blob, Wheel, Cube, Trebuchet, Ball)
