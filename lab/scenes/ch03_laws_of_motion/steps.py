"""Interactive scenes for chapter 3: how the length of a time step affects a throw and damping."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.damping import damp_per_frame, damp_per_second
from ch03_laws_of_motion.particle import Particle
from lab.drawing.pen import Pen
from lab.scene import Pair, Question, Scene
from scenes.clock import FRAME, ROUNDING
from scenes.flight import GRAVITY, thrown
from scenes.parameters import Choice, Slider

COLORS = ("red", "orange", "blue")


class FrameRates(Scene):
    """A scene that simulates a throw at three step rates with the book's integrator."""

    title = "One throw at three step rates"
    question = "How does the length of a time step change the path of a ball?"
    view = (-1.0, 25.0, -1.0, 12.0)
    seconds = 3.5
    exact_from = "the closed form of dv/dt = a - k v"
    predict = Question(
        "Three computers simulate the same throw, each at a different step rate. Which ball flies "
        "farthest?",
        ["The ball with the longest steps.", "The ball with the shortest steps.", "No difference."],
        lambda _: 0,
        "Each step moves the ball with its old velocity and applies gravity only afterwards. So in "
        "every step the ball rises g h² / 2 too far, and this error is largest for long steps.",
        3.0,
    )
    rate = Choice(5, "steps per second of the red ball", [5, 10, 15, 30], "Hz")
    damping = Slider(1.0, "damping d", "", 0.2, 1.0, step=0.01)
    speed = Slider(14.0, "speed", "m/s", 4.0, 16.0, step=0.5)
    angle = Slider(50.0, "angle", "degrees", 10.0, 80.0, step=1.0)

    def build(self) -> None:
        self.flight = thrown((0.0, 1.0), self.speed, self.angle, self.damping)
        self.rates: tuple[int, ...] = (self.rate, 2 * self.rate, max(60, 4 * self.rate))
        self.balls = [self.flight.particle(Particle) for _ in self.rates]
        self.paths = [[(ball.position.x, ball.position.y)] for ball in self.balls]

    def advance(self, duration: float = FRAME) -> None:
        """Advance each ball at its own rate, until it lands."""
        self.clock.time += duration
        for rate, ball, path in zip(self.rates, self.balls, self.paths, strict=True):
            while len(path) / rate <= self.time + ROUNDING and ball.position.y > 0.0:
                ball.integrate(1.0 / rate)
                path.append((ball.position.x, ball.position.y))
        self.clock.simulated = self.flown(-1)  # the error shown is that of the last ball

    def flown(self, i: int) -> float:
        """Return how long ball ``i`` has been flying, in s."""
        return (len(self.paths[i]) - 1) / self.rates[i]

    def draw(self, pen: Pen) -> None:
        pen.ground()
        exact = [self.flight.exact(i / 30.0).position[:2] for i in range(100)]
        pen.line([place for place in exact if place[1] >= 0.0], "gray", 2.0, dashed=True)
        for rate, path, color in zip(self.rates, self.paths, COLORS, strict=True):
            x, y = path[-1]
            pen.line(path, color, 1.5)
            pen.dots(path, color)
            pen.circle((x, y), 0.3, color)
            pen.text((x + 0.2, y + 0.8), f"{rate} Hz", color)

    def chart(self) -> dict[str, float]:
        exact = [self.flight.exact(self.flown(i)).position[:2] for i in range(3)]
        ends = zip(self.rates, self.paths, exact, strict=True)
        return {f"error at {rate} Hz, m": math.dist(path[-1], end) for rate, path, end in ends}

    def beside_exact(self) -> Pair:
        return self.paths[-1][-1], self.flight.exact(self.simulated).position[:2]

    def facts(self) -> str:
        rise = 0.5 * -GRAVITY[1] / self.rate**2
        return f"each step at {self.rate} Hz ends g h²/2 = {rise:.3g} m too high"

    def say(self) -> str:
        ends = zip(self.rates, self.paths, strict=True)
        places = ", ".join(f"{path[-1][0]:.1f} m at {rate} Hz" for rate, path in ends)
        return f"The balls have flown {places}."


class DampingForms(Scene):
    """A scene of three sliding pucks, which compares two forms of damping with the exact motion."""

    title = "Damping per step, or per second?"
    question = "Which form of damping does not depend on the step rate?"
    view = (-0.5, 10.5, -0.5, 3.5)
    seconds = 4.0
    exact_from = "the integral of v d^t"
    predict = Question(
        "The damping per step is chosen for 60 steps per second. With these settings, how far does "
        "the red puck slide, compared with the blue puck?",
        ["About as far.", "Less far.", "Farther."],
        lambda scene: 0 if scene.rate == 60 else 1 if scene.rate > 60 else 2,
        "Damping per step removes the same fraction of the speed in every step, so more steps per "
        "second slow the puck more. Damping per second raises d to the power of the step's length.",
        3.0,
    )
    rate = Choice(120, "steps per second", [15, 30, 60, 120, 240], "Hz")
    kept = Slider(0.4, "fraction of v kept per second, d", "", 0.1, 0.9, step=0.05)
    SPEED = 8.0  # m/s
    LANES = (("per step (Eq. 3.5)", "red"), ("per second (Eq. 3.6)", "blue"), ("exact", "gray"))

    def build(self) -> None:
        self.places = [0.0, 0.0]
        self.speeds = [Vector3(self.SPEED), Vector3(self.SPEED)]

    def step(self, duration: float) -> None:
        for i, v in enumerate(self.speeds):
            self.places[i] += v.x * duration
        each_step = self.kept ** (1.0 / 60.0)
        self.speeds[0] = damp_per_frame(self.speeds[0], Vector3(), each_step, duration)
        self.speeds[1] = damp_per_second(self.speeds[1], Vector3(), self.kept, duration)

    def slid(self, time: float) -> float:
        """Compute the exact distance in m that the third puck has slid after ``time`` s."""
        k = -math.log(self.kept)
        return self.SPEED * -math.expm1(-k * time) / k

    def draw(self, pen: Pen) -> None:
        places = (*self.places, self.slid(self.simulated))
        for y, x, (label, color) in zip((2.5, 1.5, 0.5), places, self.LANES, strict=True):
            pen.segments([((0.0, y - 0.3), (10.0, y - 0.3))], "gray")
            pen.circle((x, y), 0.25, color)
            pen.text((1.2, y + 0.45), label, color)

    def chart(self) -> dict[str, float]:
        per_step, per_second = self.speeds
        return {"speed, per step, m/s": per_step.x, "speed, per second, m/s": per_second.x}

    def beside_exact(self) -> Pair:
        return [self.places[1]], [self.slid(self.simulated)]

    def facts(self) -> str:
        found = f"{self.kept ** (self.rate / 60.0):.3g} of v per second, not {self.kept:g}"
        return f"at {self.rate} Hz damping per step keeps {found}"

    def say(self) -> str:
        return f"The red puck is at {self.places[0]:.2f} m, the blue one at {self.places[1]:.2f} m."
