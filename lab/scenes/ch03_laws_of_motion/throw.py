"""A game for chapter 3 in which the student's own Particle.integrate throws a ball at a hoop."""

from __future__ import annotations

import math
from itertools import pairwise

from ch03_laws_of_motion.particle import Particle
from lab.drawing.pen import Pen
from lab.scene import Pair, Scene
from scenes.flight import thrown
from scenes.parameters import Choice, Slider

Point = tuple[float, float]


class Throw(Scene):
    """A game of throwing a ball, whose exact path shows the integrator's part in a miss."""

    title = "Throw a ball at the hoop"
    question = "Does a perfectly aimed ball go in at 10 steps per second?"
    view = (-0.5, 20.0, -1.0, 11.0)
    seconds = 16.5
    exact_from = "the closed form of dv/dt = a - k v"
    keys = {
        "up": "aim higher",
        "down": "aim lower",
        "right": "throw harder",
        "left": "throw more gently",
        "t": "throw",
    }
    rate = Choice(60, "steps per second", [60, 30, 15, 10, 5], "Hz", live=True)
    damping = Choice(1.0, "damping d", [1.0, 0.7], live=True)
    angle = Slider(55.0, "angle", "degrees", 0.0, 88.0, step=2.0, live=True)
    speed = Slider(9.0, "speed", "m/s", 4.0, 20.0, step=0.25, live=True)

    HAND = (1.0, 2.0)  # m
    HOOPS = ((9.0, 3.0), (14.0, 4.0), (11.0, 5.0), (16.0, 2.5))  # m, the center of each rim
    RIM, BALL = 0.5, 0.25  # m, half the width of the rim and the radius of the ball
    # What the keys change: the angle in degrees and the speed in m/s.
    AIMS = {"up": (2.0, 0.0), "down": (-2.0, 0.0), "right": (0.0, 0.25), "left": (0.0, -0.25)}
    PULL = 2.0  # 1/s, throwing speed per meter between the hand and the click
    REST = 1.0  # s, how long the hoop stays in place after a throw
    LONGEST = 6.0  # s, after which a throw ends even if the ball has not landed
    # The scripted throws: time in s, steps per second, damping, angle in degrees and speed in m/s.
    # At 10 steps per second the script uses the exact aim first, and then a lower speed.
    ORDERS = (
        (0.5, 60, 1.0, 55.0, 9.57),
        (3.2, 10, 1.0, 55.0, 12.33),
        (6.6, 10, 1.0, 55.0, 12.0),
        (10.2, 60, 0.7, 55.0, 11.5),
        (13.2, 60, 0.7, 55.0, 13.88),
    )

    def build(self) -> None:
        self.throws = self.score = self.passed = 0
        self.start = self.end = 0.0  # s, when the last throw began and ended
        self.flies, self.rest, self.message = False, 0.0, "Aim and throw."
        self.old: list[Point] = []
        self.path: list[Point] = []
        self.truth: list[Point] = []
        self.orders = [*self.ORDERS]
        self.prepare()

    @property
    def hoop(self) -> Point:
        """The position of the hoop's center, in m. The hoop moves whenever a ball goes in."""
        return self.HOOPS[self.passed % len(self.HOOPS)]

    def prepare(self) -> None:
        """Take a ball to throw it as the player is aiming."""
        self.flight = thrown(self.HAND, self.speed, self.angle, self.damping)
        self.ball = self.flight.particle(Particle)

    def throw(self) -> None:
        if self.flies:
            return
        self.prepare()
        self.passed = self.score
        self.start = self.clock.simulated = self.time
        self.end = math.inf
        self.old = [*self.old, *self.path][-400:]
        self.path, self.truth = [self.HAND], [self.HAND]
        while self.truth[-1][1] >= 0.0 and len(self.truth) < 60.0 * self.LONGEST:
            self.truth.append(self.flight.exact(len(self.truth) / 60.0).position[:2])
        self.throws += 1
        self.message, self.flies = "", True

    def step(self, duration: float) -> None:
        if not self.flies:
            self.rest -= duration
            if self.rest < 0.0:
                self.passed = self.score
            return
        self.ball.integrate(duration)
        self.path.append((self.ball.position.x, self.ball.position.y))
        if self.path[-1][1] <= self.BALL or self.simulated - self.start > self.LONGEST:
            self.land()

    def land(self) -> None:
        """End the throw, and report how far the ball and the exact path missed the hoop."""
        yours, exact = self.outcome(self.path), self.outcome(self.truth)
        self.message = f"Your ball: {yours}. The exact path: {exact}."
        self.score += yours == "in"
        self.flies, self.rest, self.end = False, self.REST, self.simulated

    def outcome(self, path: list[Point]) -> str:
        """Describe where a path comes down to the hoop's height, such as "0.25 m too short"."""
        x, y = self.hoop
        for (x1, y1), (x2, y2) in pairwise(path):
            if y1 > y >= y2:
                beyond = x1 + (x2 - x1) * (y1 - y) / (y1 - y2) - x
                if abs(beyond) < self.RIM:
                    return "in"
                return f"{abs(beyond):.2f} m too {'far' if beyond > 0.0 else 'short'}"
        return "too low"

    def draw(self, pen: Pen) -> None:
        x, y = self.hoop
        left, right = x - self.RIM, x + self.RIM
        hand_x, hand_y = self.HAND
        neck, hip = (hand_x - 0.6, hand_y - 0.45), (hand_x - 0.6, hand_y - 1.2)
        pen.ground()
        pen.segments([(neck, hip), (neck, self.HAND)], "black", 2.5)
        pen.segments([(hip, (hip[0] + side, 0.0)) for side in (-0.25, 0.25)], "black", 2.5)
        pen.circle((hand_x - 0.6, hand_y - 0.2), 0.25, "black")
        pen.segments([((right + 0.45, 0.0), (right + 0.45, y + 0.9))], "gray", 3.0)
        pen.segments([((right + 0.3, y - 0.3), (right + 0.3, y + 1.2))], "black", 4.0)
        net = [(left, y), (left + 0.2, y - 0.7), (right - 0.2, y - 0.7), (right, y)]
        pen.line(net, "gray", 1.0)
        pen.segments([((left, y), (right, y))], "red", 4.0)
        pen.dots(self.old, "gray", 2.0)
        pen.line(self.truth, "gray", 1.5, dashed=True)
        pen.dots(self.path, "blue")
        if self.flies:
            _, (x_exact, y_exact) = self.beside_exact()
            pen.circle((x_exact, y_exact), self.BALL, "gray", fill=False)
            pen.segments([(self.path[-1], (x_exact, y_exact))], "red", 1.5)
        else:
            a, reach = math.radians(self.angle), 0.2 * self.speed
            pen.arrow(self.HAND, (reach * math.cos(a), reach * math.sin(a)), "red")
        ball_x, ball_y = self.place()
        pen.circle((ball_x, max(self.BALL, ball_y)), self.BALL, "orange")
        pen.text((9.0, 10.2), self.message or f"error {self.error() or 0.0:.2f} m", "black", 15.0)
        if self.score > self.passed:
            pen.text((x, y + 1.5), "In!", "green", 18.0)

    def chart(self) -> dict[str, float]:
        return {"height, m": self.place()[1]}

    def place(self) -> Point:
        return self.path[-1] if self.path else self.HAND

    def beside_exact(self) -> Pair:
        exact = self.flight.exact(min(self.simulated, self.end) - self.start)
        return self.place(), exact.position[:2]

    def facts(self) -> str:
        return f"{self.score} of {self.throws} went in; {self.rate} steps per second"

    def say(self) -> str:
        return self.message or f"The ball is {self.path[-1][1]:.1f} m high."

    def press(self, key: str) -> None:
        if key in self.AIMS:
            angle, speed = self.AIMS[key]
            self.aim(self.angle + angle, self.speed + speed)
        elif key == "t":
            self.throw()

    def aim(self, angle: float, speed: float) -> None:
        """Aim the throw, within the ranges of the sliders."""
        self.values["angle"] = max(0.0, min(88.0, angle))
        self.values["speed"] = max(4.0, min(20.0, speed))

    def click(self, x: float, y: float) -> None:
        if not self.flies:
            dx, dy = x - self.HAND[0], y - self.HAND[1]
            self.aim(math.degrees(math.atan2(dy, dx)), self.PULL * math.hypot(dx, dy))
            self.throw()

    def play(self, time: float) -> None:
        if self.orders and self.orders[0][0] <= time:
            _, self.values["rate"], self.values["damping"], angle, speed = self.orders.pop(0)
            self.aim(angle, speed)
            self.throw()
