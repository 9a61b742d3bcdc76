"""The demo of chapter 3: throw a ball at a hoop with your own Particle.integrate."""

from __future__ import annotations

import math
from itertools import pairwise

from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from studies.drag_flight import GRAVITY, DragFlight, State
from studies.drawing import BLACK, BLUE, GREEN, GREY, ORANGE, RED
from studies.readings import Numbers, is_drawable, numbers

Point = tuple[float, float]


class Throw:
    """A ball that your particle moves step by step, next to the exact path."""

    seconds = 16.5
    keys = (
        "Up and down change the angle, left and right change the speed, and the space bar throws. "
        "A click aims at that point and throws: the farther away, the faster. 1 to 5 choose 60, "
        "30, 15, 10 or 5 steps per second, a switches the air on and off, and r starts again."
    )
    HAND = (1.0, 2.0)  # m
    HOOPS = ((9.0, 3.0), (14.0, 4.0), (11.0, 5.0), (16.0, 2.5))  # m, the center of each rim
    RIM = 0.5  # m, half of its width
    BALL = 0.25  # m, its radius
    RATES = (60, 30, 15, 10, 5)  # steps per second
    AIR = 0.7  # the fraction of the velocity that is kept per second
    TURN, PUSH = math.radians(2.0), 0.25  # rad and m/s, the change made by one key press
    WEAKEST, STRONGEST = 4.0, 20.0  # m/s
    PULL = 2.0  # 1/s, the speed of a throw per meter of distance to the click
    REST = 1.0  # s, how long the hoop stays in place after a throw
    LONGEST = 6.0  # s, after which a ball that has not come down is given up
    # The throws of the automatic player: time in s, steps per second, damping, angle in degrees and
    # speed in m/s. At 10 steps per second it first uses the exact aim, and then a lower speed.
    ORDERS = (
        (0.5, 60, 1.0, 55.0, 9.57),
        (3.2, 10, 1.0, 55.0, 12.33),
        (6.6, 10, 1.0, 55.0, 12.0),
        (10.2, 60, AIR, 55.0, 11.5),
        (13.2, 60, AIR, 55.0, 13.88),
    )

    def __init__(self, figure: Figure) -> None:
        axes = figure.add_subplot()
        axes.set(xlim=(-0.5, 20.0), ylim=(0.0, 11.0), aspect="equal", xlabel="x, m", ylabel="y, m")
        axes.axhline(0.0, color=GREEN, lw=4)
        _draw_thrower(axes, self.HAND)
        self.axes = axes
        self.pole = axes.plot([], [], color=GREY, lw=3)[0]
        self.board = axes.plot([], [], color=BLACK, lw=4)[0]
        self.net = axes.add_collection(LineCollection([], colors=GREY, linewidths=0.8))
        self.rim = axes.plot([], [], color=RED, lw=4, solid_capstyle="round")[0]
        self.earlier = axes.plot([], [], ".", color="#CCCCCC", ms=3)[0]
        self.exact = axes.plot([], [], color=GREY, lw=1.5, alpha=0.6, label="exact path")[0]
        self.dots = axes.plot([], [], ".", color=BLUE, ms=5, label="your steps")[0]
        self.gap = axes.plot([], [], ":", color=RED, lw=1.5, label="error")[0]
        self.arrow = axes.annotate(
            "", (0, 0), self.HAND, arrowprops={"arrowstyle": "-|>", "color": RED, "lw": 2.5}
        )
        self.ghost = axes.add_patch(Circle((0, 0), self.BALL, fill=False, edgecolor=GREY, lw=1.5))
        self.ball = axes.add_patch(Circle((0, 0), self.BALL, facecolor=ORANGE, edgecolor=BLACK))
        self.ball.set_zorder(5)
        axes.legend(fontsize=8, loc="upper right", ncols=3)
        self.cheer = axes.text(0, 0, "In!", color=GREEN, fontsize=16, weight="bold", ha="center")
        self.title = figure.suptitle("", fontsize=10)
        self.rate, self.damping = self.RATES[0], 1.0
        self.angle, self.speed = math.radians(55.0), 9.0
        self.orders = [*self.ORDERS]
        self.start()
        self.new_ball().integrate(1.0 / self.rate)  # reports at once if a body is not written yet

    def start(self) -> None:
        """Start a new game at the first hoop. The hoop moves on after each ball that goes in."""
        self.throws = self.score = self.steps = self.passed = 0
        self.rest = 0.0
        self.old: list[Point] = []
        self.way: list[Point] = []
        self.truth: list[Point] = []
        self.end("Aim and throw.")

    def end(self, message: str) -> None:
        """End the throw with a message. The path stays visible."""
        self.message, self.flies = message, False
        self.rest = self.REST

    @property
    def hoop(self) -> Point:
        """The center of the rim, in m."""
        return self.HOOPS[self.passed % len(self.HOOPS)]

    def flight(self) -> DragFlight:
        """Return the throw as plain numbers that have an exact solution."""
        vx, vy = self.speed * math.cos(self.angle), self.speed * math.sin(self.angle)
        start = State((*self.HAND, 0.0), (vx, vy, 0.0))
        return DragFlight("throw", start, GRAVITY, self.damping, self.LONGEST)

    def new_ball(self) -> Particle:
        """Return a particle that leaves the hand with the current aim."""
        start = self.flight().start
        return Particle(
            Vector3(*start.position),
            Vector3(*start.velocity),
            Vector3(*GRAVITY),
            damping=self.damping,
        )

    def throw(self) -> None:
        """Throw the ball, unless it is still in the air."""
        if self.flies:
            return
        self.thrown, self.particle = self.flight(), self.new_ball()
        self.passed = self.score
        self.step = 1.0 / self.rate
        self.due, self.steps = 0.0, 0
        self.old = [*self.old, *self.way][-400:]
        self.way = [self.HAND]
        self.truth = self.exact_path()
        self.throws += 1
        self.message, self.flies = "", True

    def exact_path(self) -> list[Point]:
        """Return the exact path of the throw, down to the ground."""
        path = []
        for i in range(round(60.0 * self.LONGEST)):
            x, y, _ = self.thrown.exact(i / 60.0).position
            path.append((x, y))
            if y < 0.0:
                break
        return path

    def update(self, duration: float) -> None:
        """Make the steps of the ball that are due."""
        if not self.flies:
            self.rest -= duration
            if self.rest < 0.0:
                self.passed = self.score
            return
        self.due += duration / self.step
        while self.due > 0.5 and self.flies:
            self.particle.integrate(self.step)
            self.due -= 1.0
            self.steps += 1
            self.look(numbers(self.particle.position))

    def look(self, place: Numbers) -> None:
        """Record the position of the ball, and end the throw if the ball is on the ground."""
        if not is_drawable(place):
            self.end("The position of the ball is not a number.")
            return
        self.way.append((place[0], place[1]))
        if place[1] <= self.BALL or self.steps * self.step > self.LONGEST:
            yours, exact = self.past_hoop(self.way), self.past_hoop(self.truth)
            self.end(f"Your ball: {self.told(yours)}. The exact path: {self.told(exact)}.")
            self.score += self.is_in(yours)

    def past_hoop(self, path: list[Point]) -> float | None:
        """Return how far beyond the rim's center, in m, a path passes the rim's height, if ever."""
        x, y = self.hoop
        for (x1, y1), (x2, y2) in pairwise(path):
            if y1 > y >= y2:
                return x1 + (x2 - x1) * (y1 - y) / (y1 - y2) - x
        return None

    def is_in(self, beyond: float | None) -> bool:
        """Return whether a ball that comes down there goes through the hoop."""
        return beyond is not None and abs(beyond) < self.RIM

    def told(self, beyond: float | None) -> str:
        """Describe in words how well a path hits the hoop."""
        if beyond is None:
            return "too low"
        if self.is_in(beyond):
            return "in"
        return f"{abs(beyond):.2f} m too {'far' if beyond > 0.0 else 'short'}"

    def draw(self) -> None:
        x, y = self.hoop
        left, right = x - self.RIM, x + self.RIM
        self.rim.set_data([left, right], [y, y])
        self.board.set_data([right + 0.3] * 2, [y - 0.3, y + 1.2])
        self.pole.set_data([right + 0.45] * 2, [0.0, y + 0.9])
        self.net.set_segments(_net(left, right, y))
        self.cheer.set(position=(x, y + 1.5), visible=self.score > self.passed)
        self.arrow.set_visible(not self.flies)
        reach = 0.2 * self.speed  # m, of the arrow
        self.arrow.xy = (
            self.HAND[0] + reach * math.cos(self.angle),
            self.HAND[1] + reach * math.sin(self.angle),
        )
        self.earlier.set_data([x for x, _ in self.old], [y for _, y in self.old])
        self.exact.set_data([x for x, _ in self.truth], [y for _, y in self.truth])
        self.dots.set_data([x for x, _ in self.way], [y for _, y in self.way])
        place = true = self.HAND
        if self.throws:
            place = self.way[-1]
            true = self.thrown.exact(self.steps * self.step).position[:2]
        self.gap.set_data([place[0], true[0]], [place[1], true[1]])
        self.gap.set_visible(self.flies)
        self.ball.set(center=(place[0], max(self.BALL, place[1])))
        self.ghost.set(center=true, visible=self.flies)
        self.title.set_text(f"{self.state()}\n{self.message or self.error(place, true)}")

    def state(self) -> str:
        """Describe the next throw and the score."""
        air = "no air" if self.damping == 1.0 else f"air: damping {self.damping:g}"
        return (
            f"{self.speed:.2f} m/s at {math.degrees(self.angle):.0f}°, {self.rate} steps per "
            f"second, {air}; {self.score} of {self.throws} went in"
        )

    def error(self, place: Point, true: Point) -> str:
        """Describe how far the flying ball is from its exact position."""
        time = self.steps * self.step
        off = math.dist(place, true)
        return f"After {time:.2f} s the ball is {off:.2f} m from its exact position."

    def press(self, key: str) -> None:
        if key in ("up", "down"):
            self.aim(self.angle + (self.TURN if key == "up" else -self.TURN), self.speed)
        elif key in ("left", "right"):
            self.aim(self.angle, self.speed + (self.PUSH if key == "right" else -self.PUSH))
        elif key == " ":
            self.throw()
        elif key in ("1", "2", "3", "4", "5"):
            self.rate = self.RATES[int(key) - 1]
        elif key == "a":
            self.damping = self.AIR if self.damping == 1.0 else 1.0
        elif key == "r":
            self.start()

    def aim(self, angle: float, speed: float) -> None:
        """Aim forward, with a speed in m/s that an arm can reach."""
        self.angle = max(0.0, min(math.radians(88.0), angle))
        self.speed = max(self.WEAKEST, min(self.STRONGEST, speed))

    def click(self, axes: object, x: float, y: float) -> None:
        del axes  # there is only one
        if not self.flies:
            dx, dy = x - self.HAND[0], y - self.HAND[1]
            self.aim(math.atan2(dy, dx), self.PULL * math.hypot(dx, dy))
            self.throw()

    def play(self, time: float) -> None:
        """Throw at 60 steps per second, then at 10 with two aims, and in air with two speeds."""
        if self.orders and self.orders[0][0] <= time:
            _, self.rate, self.damping, degrees, speed = self.orders.pop(0)
            self.aim(math.radians(degrees), speed)
            self.throw()


DEMOS = (Throw,)


def _net(left: float, right: float, top: float) -> list[list[Point]]:
    """Return the threads of the net below a rim."""
    threads, bottom, narrow = 6, top - 0.7, 0.2
    above = [left + (right - left) * i / threads for i in range(threads + 1)]
    below = [x + narrow * (1.0 - 2.0 * i / threads) for i, x in enumerate(above)]
    down = [[(above[i], top), (below[j], bottom)] for i, j in _neighbours(threads)]
    return [*down, [(below[0], bottom), (below[-1], bottom)]]


def _neighbours(count: int) -> list[tuple[int, int]]:
    """Return pairs of each index and the next one, in both directions."""
    return [*((i, i + 1) for i in range(count)), *((i + 1, i) for i in range(count))]


def _draw_thrower(axes: Axes, hand: Point) -> None:
    """Draw a person whose hand is at this point."""
    x, y = hand[0] - 0.6, hand[1] - 0.2
    neck, hip = (x, y - 0.25), (x, y - 1.0)
    limbs = [[neck, hip], [neck, hand], [hip, (x - 0.25, 0.0)], [hip, (x + 0.25, 0.0)]]
    axes.add_collection(LineCollection(limbs, colors=BLACK, linewidths=2.5, capstyle="round"))
    axes.add_patch(Circle((x, y), 0.25, color=BLACK))
