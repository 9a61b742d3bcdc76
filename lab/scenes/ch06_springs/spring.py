"""An interactive scene for chapter 6: a ball on a spring, with time steps that may be too long."""

from __future__ import annotations

import cmath
import math

from lab.drawing.pen import Pen
from lab.scene import Question
from lab.stepped import Stepped
from scenes.spring_on_a_wall import DAMPING, MASS, START, STIFFNESS, SpringOnAWall
from scenes.twin import twin_of


def is_stable(integrator: str, kappa: float, drag: float) -> bool:
    """Return True if a step is stable with ``kappa`` = k h^2 / m and ``drag`` = c h / m."""
    if integrator == "explicit Euler":
        return kappa < drag and 2.0 * drag < 4.0 + kappa
    if integrator == "velocity Verlet":
        return drag < 2.0 and kappa < 4.0 - 2.0 * drag + drag * drag
    if integrator == "Runge-Kutta 4":
        root = cmath.sqrt(0.25 * drag * drag - kappa)
        ends = (-0.5 * drag + root, -0.5 * drag - root)
        # A step multiplies by the series of e^z, whose rounding errors do not count.
        grown = [1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))) for z in ends]
        return round(max(map(abs, grown)), 13) <= 1.0
    return kappa + 2.0 * drag < 4.0


class OneSpring(Stepped):
    """A ball on a spring, confined to a line so that its exact motion is known."""

    title = "One spring, five integrators"
    question = "Which integrator keeps the energy, and how stiff may the spring be?"
    view = (-2.2, 2.2, -1.2, 1.2)
    seconds = 6.0
    exact_from = "the closed form"
    predict = Question(
        "The ball starts 1 m from the middle. What will it do?",
        ["It keeps swinging, or comes to rest.", "Each swing is wider than the last."],
        lambda scene: int(not scene.is_stable()),
        "The numbers k h^2 / m and c h / m decide. Without damping, explicit Euler explodes at any "
        "stiffness, and semi-implicit Euler explodes if k h^2 / m is greater than 4. Damping helps "
        "explicit Euler, but it lowers the limit of semi-implicit Euler.",
    )
    keys = {"p": "push the ball to the right"}
    stiffness, mass, damping = STIFFNESS, MASS, DAMPING

    WALL = -2.0  # m
    PUSH = 1.0  # m/s

    def build(self) -> None:
        self.wall = SpringOnAWall(self.stiffness, self.damping, self.mass)
        setup = self.wall.setup()
        self.particles, self.registry = setup.particles, setup.registry()
        (self.ball,) = self.particles
        self.since, self.x0, self.v0 = 0.0, START, 0.0

    def draw(self, pen: Pen) -> None:
        place, speed = self.ball.position, self.ball.velocity.x
        pen.line([(0.0, -0.3), (0.0, 0.3)], "gray", 1.0, dashed=True)
        pen.segments([((self.WALL, -0.8), (self.WALL, 0.8))], "black", 4.0)
        pen.spring((self.WALL, 0.0), place)
        pen.circle(place, 0.15, "blue", grab="ball")
        pen.arrow(place, (0.1 * speed, 0.0), "green", "velocity")
        force = -self.stiffness * place.x / max(self.stiffness, 1e-9)
        pen.arrow(place, (force, 0.0), "orange", "force")

    def chart(self) -> dict[str, float]:
        x = self.ball.position.x
        return {"energy, J": self.ball.kinetic_energy() + 0.5 * self.stiffness * x * x}

    def state(self) -> list[float]:
        return [self.ball.position.x]

    def exact(self, time: float) -> list[float]:
        return [self.wall.state(time - self.since, self.x0, self.v0)[0]]

    def per_step(self) -> tuple[float, float]:
        """Return k h^2 / m and c h / m, where h is the length of a time step."""
        return self.wall.per_step(1.0 / self.rate)

    def is_stable(self) -> bool:
        """Predict whether the method keeps the ball from getting farther and farther away."""
        return is_stable(self.integrator, *self.per_step())

    def facts(self) -> str:
        kappa, drag = self.per_step()
        words = f"{'stable' if self.is_stable() else 'unstable'}; period {self.wall.period:.3g} s"
        return f"k h²/m = {kappa:.4g} and c h/m = {drag:.3g}: {words}"

    def say(self) -> str:
        x, v = self.ball.position.x, self.ball.velocity.x
        return f"The ball is at x = {x:.3g} m, and moves at {v:.3g} m/s."

    def press(self, key: str) -> None:
        if key == "p":
            self.let_go(self.ball.position.x, self.ball.velocity.x + self.PUSH)

    def drag(self, name: str, x: float, y: float) -> None:
        self.let_go(max(-2.0, min(2.0, x)), 0.0)

    def let_go(self, x: float, v: float) -> None:
        """Give the ball a new position and velocity, and restart the exact solution from there."""
        self.ball.position.x, self.ball.velocity.x = x, v
        self.since, self.x0, self.v0 = self.simulated, x, v


class ExactSpring(OneSpring):
    def step(self, duration: float) -> None:
        state = self.wall.state(self.simulated - self.since, self.x0, self.v0)
        self.ball.position.x, self.ball.velocity.x = state

    def is_stable(self) -> bool:
        return True


class PymunkSpring(OneSpring):
    def build(self) -> None:
        super().build()
        self.space, (self.body,) = twin_of(self.wall.setup())

    def step(self, duration: float) -> None:
        self.space.step(duration)
        self.ball.position.x, self.ball.velocity.x = self.body.position.x, self.body.velocity.x

    def is_stable(self) -> bool:
        """Compare k h^2 / m with its limit if a step keeps exp(-c h / m) of the velocity."""
        kappa, drag = self.per_step()
        return kappa < 2.0 * (1.0 + math.exp(drag))

    def let_go(self, x: float, v: float) -> None:
        super().let_go(x, v)
        self.body.position, self.body.velocity = (x, 0.0), (v, 0.0)


OneSpring.peers = {"exact": ExactSpring, "pymunk": PymunkSpring}
