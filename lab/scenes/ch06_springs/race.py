"""An interactive scene for chapter 6 in which seven integrators simulate the same spring."""

from __future__ import annotations

import math

from ch05_forces.particle import Particle
from lab.drawing.pen import Pen
from lab.scene import Question, Scene
from lab.stepped import RATES
from scenes.parameters import Choice, Slider
from scenes.spring_on_a_wall import SpringOnAWall

COLORS = ("red", "blue", "violet", "sky", "green", "orange", "pink")  # one for each integrator
FAR = 3.0  # m; a ball farther out is not drawn


class IntegratorRace(Scene):
    """Seven balls on identical springs, each moved by a different integrator, in phase space."""

    title = "Energy of seven integrators"
    question = "Which paths stay on the circle, which spiral out, and which spiral in?"
    view = (-2.6, 4.4, -2.3, 2.3)
    seconds = 6.0
    exact_from = "the closed form"
    predict = Question(
        "The circle is the exact motion. What does the path of backward Euler do?",
        ["It spirals out.", "It stays on the circle.", "It spirals in."],
        lambda _: 2,
        "Backward Euler uses the forces at the end of the step and loses energy in every swing. "
        "Explicit Euler uses the forces at its start and gains energy at the same rate.",
        5.0,
    )
    stiffness = Slider(40.0, "stiffness k", "N/m", 1.0, 2_000.0, log=True)
    rate = Choice(30.0, "steps per second", RATES, "Hz")

    def build(self) -> None:
        self.wall = SpringOnAWall(self.stiffness)
        self.balls, self.moves = {}, {}
        for name, method in self.wall.methods().items():
            setup = self.wall.setup()
            (self.balls[name],) = setup.particles
            self.moves[name] = setup.moved_by(method)
        self.trails: dict[str, list[tuple[float, float]]] = {name: [] for name in self.balls}

    def step(self, duration: float) -> None:
        for name, ball in self.balls.items():
            if abs(ball.position.x) <= 100.0:  # otherwise it has exploded, and the others continue
                self.moves[name](duration)
                self.trails[name] = [*self.trails[name][-90:], self.phase(ball)]

    def phase(self, ball: Particle) -> tuple[float, float]:
        """Return the position and the scaled velocity, which move on a circle in exact motion."""
        return ball.position.x, ball.velocity.x / math.sqrt(self.stiffness)

    def draw(self, pen: Pen) -> None:
        pen.circle((0.0, 0.0), 1.0, "gray", fill=False)
        pen.text((-1.9, 2.1), "velocity / ω against position", "gray", 13.0)
        x, y = self.exact(self.simulated)
        pen.circle((x, y), 0.1, "gray", fill=False)
        for i, ((name, ball), color) in enumerate(zip(self.balls.items(), COLORS, strict=True)):
            x, y = self.phase(ball)
            if math.hypot(x, y) < FAR:
                pen.line(self.trails[name], color, 1.0)
                pen.circle((x, y), 0.06, color)
            percent = 100.0 * (x * x + y * y)
            words = f"{name}: {percent:.0f} %" if percent < 1e4 else f"{name}: exploded"
            pen.text((3.4, 1.8 - 0.35 * i), words, color, 13.0)
        pen.text((3.4, 2.15), "energy", "black", 13.0)

    def chart(self) -> dict[str, float]:
        found = {}
        for name in ("explicit Euler", "semi-implicit Euler", "Runge-Kutta 4", "backward Euler"):
            x, y = self.phase(self.balls[name])
            found[f"energy, {name}, J"] = min(0.5 * self.stiffness * (x * x + y * y), 1e9)
        return found

    def state(self) -> list[float]:
        return [*self.phase(self.balls["Runge-Kutta 4"])]

    def exact(self, time: float) -> list[float]:
        x, v = self.wall.state(time)
        return [x, v / math.sqrt(self.stiffness)]

    def facts(self) -> str:
        kappa, _ = self.wall.per_step(1.0 / self.rate)
        return f"k h²/m = {kappa:.4g}; the error shown is that of Runge-Kutta 4"

    def say(self) -> str:
        x, y = self.phase(self.balls["explicit Euler"])
        return f"Explicit Euler has {100.0 * min(x * x + y * y, 1e6):.0f} % of its initial energy."
