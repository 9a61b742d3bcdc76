"""Interactive scenes for chapter 8 with a rope bridge: a ball that crosses it, and a game."""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch08_mass_aggregate import ball_game, bridge
from ch08_mass_aggregate.fixed_step import FixedStep
from lab.drawing.camera import flat
from lab.drawing.pen import Pen
from lab.scene import Question, Scene
from lab.world_scene import WorldScene, draw_cables
from scenes.clock import FRAME
from scenes.links import over_length
from scenes.parameters import Choice, Slider

VIEW = (-8.0, 8.0, -1.0, 7.6)


class Bridge(WorldScene):
    """A rope bridge and a heavy ball, which the reader moves across. Some frames may be late."""

    title = "A rope bridge"
    question = "How many iterations do the cables need to carry the ball?"
    view = VIEW
    seconds = 12.0
    keys = {"left": "walk to the left", "right": "walk to the right", "s": "stand still"}
    predict = Question(
        "The ball stands on the bridge. Is any cable more than 2 % too long after three seconds?",
        ["No, the resolver holds all cables.", "Yes, at least one cable."],
        lambda scene: int(scene.too_long() > 2.0),
        "Each iteration shortens one cable and pulls on its neighbors. With too few iterations "
        "the step ends before the weight of the ball has reached the anchors.",
        3.0,
    )
    iterations = Choice(300, "most iterations per phase", [1, 3, 10, 30, 100, 300], live=True)
    mass = Slider(5.0, "mass of the ball", "kg", 1.0, 50.0, step=1.0)
    frames = Choice("all on time", "frames", ["all on time", "every 60th late"], live=True)
    PACES = {"left": -1.5, "right": 1.5, "s": 0.0}  # m/s
    EVERY, LATE = 60, 0.5  # one frame in this many is late, and lasts this long in s
    MAX_STEPS = 6  # per frame, if some frames are late

    def build(self) -> None:
        self.bridge = bridge.Bridge(self.mass)
        self.run(self.bridge.step, self.bridge.world)
        self.stepper: FixedStep | None = None
        self.count = 0

    def advance(self, duration: float = FRAME) -> None:
        if self.frames == "all on time":
            super().advance(duration)
            return
        # The student's own FixedStep has to cope with the late frames.
        self.clock.time += duration
        self.clock.simulated = self.time
        if self.stepper is None or self.stepper.duration != 1.0 / self.rate:
            self.stepper = FixedStep(self.step, 1.0 / self.rate, self.MAX_STEPS)
        self.count += 1
        self.stepper.advance(duration if self.count % self.EVERY else self.LATE)

    def draw(self, pen: Pen) -> None:
        pen.ground()
        draw_cables(pen, self.bridge.links)
        pen.segments([(flat(a.position), flat(b.position)) for a, b in self.bridge.rows], "wood", 5)
        pen.circle(self.bridge.ball.position, bridge.RADIUS, "orange")
        pen.arrow(self.bridge.ball.position, self.bridge.ball.velocity, "green", "velocity")
        self.contacts.draw(pen, 1.0)

    def too_long(self) -> float:
        """Return the largest excess length of a cable, in percent of its maximum length."""
        return over_length(self.bridge.links)

    def chart(self) -> dict[str, float]:
        return {"excess length of the worst cable, %": self.too_long(), **self.used()}

    def facts(self) -> str:
        dropped = f"; {self.stepper.dropped:.2f} s dropped so far" if self.stepper else ""
        return f"{len(self.bridge.links)} rods and cables{dropped}"

    def say(self) -> str:
        place, cable = self.bridge.ball.position, f"The worst cable is {self.too_long():.2f} %"
        return f"The ball is at x = {place.x:.1f} m, y = {place.y:.1f} m. {cable} too long."

    def press(self, key: str) -> None:
        self.bridge.pace = self.PACES.get(key, self.bridge.pace)

    def play(self, time: float) -> None:
        """Move the ball across the bridge, with late frames after 4 s, and finally off it."""
        frame = round(60.0 * time)
        if frame == 240:
            self.values["frames"] = "every 60th late"
        self.press({60: "left", 200: "s", 250: "right", 645: "s"}.get(frame, ""))


class BallGame(Scene):
    """A game of bouncing a ball from plank to plank of a rope bridge (project 8.1)."""

    title = "A game on the bridge"
    question = "Can you land on every plank before you lose three balls?"
    view = VIEW
    seconds = 12.0
    keys = {
        "left": "steer to the left",
        "right": "steer to the right",
        "down": "stop steering",
        "n": "begin a new game",
    }
    FORESIGHT = 0.4  # s that the scripted player looks ahead

    def build(self) -> None:
        self.game = ball_game.BallGame()

    def step(self, duration: float) -> None:
        self.game.step(duration)

    def draw(self, pen: Pen) -> None:
        game, rules = self.game, self.game.rules
        pen.ground()
        draw_cables(pen, game.world.contact_generators)
        for i, (a, b) in enumerate(game.rows):
            color = "green" if i in rules.visited else "wood"
            pen.segments([(flat(a.position), flat(b.position))], color, 5.0)
        pen.circle(game.ball.position, bridge.RADIUS, "orange")
        pen.arrow(game.ball.position, Vector3(game.direction), "green", "force")
        pen.dots([(-7.5 + 0.5 * i, 6.9) for i in range(rules.lives)], "orange", 12.0)
        if rules.over:
            words, color = ("won", "green") if rules.won else ("lost", "red")
            pen.text((0.0, 2.2), words, color, 28.0)

    def chart(self) -> dict[str, float]:
        return {"score": float(self.game.rules.score)}

    def facts(self) -> str:
        return f"{ball_game.POINTS} points per row, and {ball_game.BONUS} for each ball left"

    def say(self) -> str:
        return f"Score {self.game.rules.score}, {self.game.rules.lives} balls left."

    def press(self, key: str) -> None:
        if key == "n":
            self.build()
        elif key in ("left", "right", "down"):
            self.game.direction = {"left": -1, "down": 0, "right": 1}[key]

    def play(self, time: float) -> None:
        """Win one game, by always steering to the next row of planks, and lose another one."""
        ball, visited = self.game.ball, self.game.rules.visited
        left = [row for i, row in enumerate(self.game.rows) if i not in visited]
        frame = round(60.0 * time)
        if frame >= 424:
            self.press("n" if frame == 424 else "left" if frame > 474 else "down")
        elif not left:
            self.press("down")
        else:
            there = 0.5 * (left[0][0].position.x + left[0][1].position.x)
            seen = ball.position.x + self.FORESIGHT * ball.velocity.x
            self.press("right" if there > seen else "left")
