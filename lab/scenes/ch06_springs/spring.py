"""Interactive scenes for chapter 6: seven integrators on one spring, and a ball on a spring."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from lab.drawing.pen import Pen
from lab.scene import Pair, Question, Scene
from scenes.integrators import INTEGRATORS
from scenes.parameters import Choice, Slider
from scenes.spring_on_a_wall import DAMPING, MASS, START, STIFFNESS, SpringOnAWall
from scenes.twin import twin_of

RATES = (15.0, 30.0, 60.0, 120.0, 240.0, 480.0)
COLORS = ("red", "blue", "violet", "sky", "green", "orange", "pink")  # one for each integrator
FAR = 3.0  # m; a ball farther out is not drawn


class Stepped(Scene):
    """A scene of particles and a registry of forces, which a subclass must create in ``build``."""

    integrator = Choice("semi-implicit Euler", "integrator", [*INTEGRATORS], live=True)
    rate = Choice(60.0, "steps per second", RATES, "Hz", live=True)

    particles: Sequence[Particle]
    registry: ForceRegistry

    def step(self, duration: float) -> None:
        INTEGRATORS[self.integrator](self.particles, self.registry.update_forces, duration)


class IntegratorRace(Scene):
    """Seven balls on identical springs, each moved by a different integrator, in phase space."""

    title = "Energy of seven integrators"
    question = "Which paths stay on the circle, which spiral out, and which spiral in?"
    view = (-2.6, 4.4, -2.3, 2.3)
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
        _, (x, y) = self.beside_exact()
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

    def beside_exact(self) -> Pair:
        x, v = self.wall.state(self.simulated)
        return self.phase(self.balls["Runge-Kutta 4"]), (x, v / math.sqrt(self.stiffness))

    def facts(self) -> str:
        kappa, _ = self.wall.per_step(1.0 / self.rate)
        return f"k h²/m = {kappa:.4g}; the error shown is that of Runge-Kutta 4"

    def say(self) -> str:
        x, y = self.phase(self.balls["explicit Euler"])
        return f"Explicit Euler has {100.0 * min(x * x + y * y, 1e6):.0f} % of its initial energy."


class OneSpring(Stepped):
    """A ball on a spring, confined to a line so that its exact motion is known."""

    title = "One spring, five integrators"
    question = "Which integrator keeps the energy, and how stiff may the spring be?"
    view = (-2.2, 2.2, -1.2, 1.2)
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

    def exact(self) -> tuple[float, float]:
        """Compute the exact position and velocity."""
        return self.wall.state(self.simulated - self.since, self.x0, self.v0)

    def beside_exact(self) -> Pair:
        return [self.ball.position.x], [self.exact()[0]]

    def per_step(self) -> tuple[float, float]:
        """Return k h^2 / m and c h / m, where h is the length of a time step."""
        return self.wall.per_step(1.0 / self.rate)

    def is_stable(self) -> bool:
        """Predict whether the method keeps the ball from getting farther and farther away."""
        kappa, drag = self.per_step()
        if self.integrator == "explicit Euler":
            return kappa < drag and 2.0 * drag < 4.0 + kappa
        if self.integrator == "velocity Verlet":
            return drag < 2.0 and kappa < 4.0 - 2.0 * drag + drag * drag
        if self.integrator == "Runge-Kutta 4":
            root = cmath.sqrt(0.25 * drag * drag - kappa)
            ends = (-0.5 * drag + root, -0.5 * drag - root)
            # A step multiplies by the series of e^z, whose rounding errors do not count.
            grown = [1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))) for z in ends]
            return round(max(map(abs, grown)), 13) <= 1.0
        return kappa + 2.0 * drag < 4.0

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
        self.ball.position.x, self.ball.velocity.x = self.exact()

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
