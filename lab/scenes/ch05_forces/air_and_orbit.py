"""Interactive scenes for chapter 5: two balls that fall in air, and a planet's orbit."""

from __future__ import annotations

import math

from ch05_forces.closed_form import quadratic_fall, terminal_speed
from lab.drawing.pen import Pen
from lab.scene import Pair, Question, Scene
from scenes.clock import FRAME
from scenes.fall_in_air import G, falling
from scenes.orbit import KeplerOrbit
from scenes.parameters import Choice, Slider

RATES = (15, 30, 60, 120, 240)


class FallInAir(Scene):
    """A scene of two balls dropped from a tower, with quadratic drag from the air."""

    title = "Which ball lands first?"
    question = "Why does a heavy ball fall faster in air, but not on the moon?"
    view = (-6.0, 10.0, -4.0, 104.0)
    seconds = 7.0
    exact_from = "the closed form of a fall with quadratic drag"
    predict = Question(
        "Both balls are released together. Which one lands first?",
        ["The left ball.", "The right ball.", "Both land together."],
        lambda scene: scene.lands_first(),
        "Without air both balls would land together. With drag, the ball with more weight for its "
        "drag coefficient falls faster: the terminal speed is the square root of m g / k2.",
        6.0,
    )
    left_mass = Slider(4.0, "mass of the left ball", "kg", 0.1, 10.0, log=True)
    right_mass = Slider(0.5, "mass of the right ball", "kg", 0.1, 10.0, log=True)
    left_drag = Slider(0.02, "drag k2 of the left ball", "N s²/m²", 0.0, 0.1, step=0.005)
    right_drag = Slider(0.02, "drag k2 of the right ball", "N s²/m²", 0.0, 0.1, step=0.005)
    rate = Choice(60, "steps per second", RATES, "Hz")
    TOP = 100.0  # m

    def build(self) -> None:
        # The mass and the drag coefficient of each ball.
        self.balls = ((self.left_mass, self.left_drag), (self.right_mass, self.right_drag))
        setup = falling([(mass, 0.0, k2) for mass, k2 in self.balls], self.TOP)
        self.fallers, self.registry = setup.particles, setup.registry()
        self.landed = [math.inf, math.inf]

    def terminal_speeds(self) -> list[float]:
        """Return the terminal speed of each ball in m/s, which is infinite without air."""
        return [terminal_speed(mass * G, 0.0, k2) if k2 else math.inf for mass, k2 in self.balls]

    def lands_first(self) -> int:
        """Predict which ball lands first: 0 for the left, 1 for the right, or 2 for a tie."""
        left, right = self.terminal_speeds()
        return 0 if left > 1.001 * right else 1 if right > 1.001 * left else 2

    def step(self, duration: float) -> None:
        self.registry.update_forces(duration)
        for i, ball in enumerate(self.fallers):
            if ball.position.y > 0.0:
                ball.integrate(duration)
                if ball.position.y <= 0.0:
                    self.landed[i] = self.simulated

    def draw(self, pen: Pen) -> None:
        pen.ground()
        pen.area([(-4.0, 0.0), (-2.0, 0.0), (-2.0, self.TOP), (-4.0, self.TOP)], "gray")
        for x, color, ball, landed, (mass, k2) in zip(
            (0.0, 4.0), ("blue", "orange"), self.fallers, self.landed, self.balls, strict=True
        ):
            middle = (x, max(0.0, ball.position.y) + 1.5)
            pen.circle(middle, 1.2 * mass ** (1.0 / 3.0), color)
            pen.arrow(middle, (0.0, 0.5 * ball.velocity.y), "green", "velocity")
            pen.arrow(middle, (0.0, k2 * ball.velocity.y**2 / mass), "red", "force")
            if landed < math.inf:
                pen.text((x, 12.0), f"{landed:.2f} s", color)

    def chart(self) -> dict[str, float]:
        left, right = self.fallers
        return {"speed, left, m/s": -left.velocity.y, "speed, right, m/s": -right.velocity.y}

    def beside_exact(self) -> Pair:
        """Return the heights of both balls. Those of a ball that has landed are the same."""
        heights, exact, time = [ball.position.y for ball in self.fallers], [], self.simulated
        for height, landed, (mass, k2) in zip(heights, self.landed, self.balls, strict=True):
            fallen = quadratic_fall(mass, G, k2, time)[1] if k2 else 0.5 * G * time * time
            exact.append(self.TOP - fallen if landed == math.inf else height)
        return heights, exact

    def facts(self) -> str:
        ends = self.terminal_speeds()
        left, right = (f"{end:.1f} m/s" if end < math.inf else "none (no air)" for end in ends)
        return f"terminal speeds: {left} and {right}"

    def say(self) -> str:
        left, right = (ball.position.y for ball in self.fallers)
        return f"The balls are {left:.0f} m and {right:.0f} m high."


class Orbit(Scene):
    """A scene of a planet that orbits a star, with two versions of the time step."""

    title = "An orbit that should close"
    question = "Which order of the two moves keeps a planet on its orbit?"
    view = (-3.4, 2.4, -2.2, 2.2)
    seconds = 8.0
    exact_from = "Kepler's equation"
    predict = Question(
        "The planet moves with the chosen form of the step. What happens to its orbit?",
        ["It stays the same.", "It grows.", "It shrinks."],
        lambda scene: 1 if scene.order == "position first" else 0,
        "With the position first, each step moves the planet outward along the tangent, and it "
        "gains energy. With the velocity first, the energy oscillates but does not drift.",
        8.0,
    )
    order = Choice("position first", "step", ["position first", "velocity first"])
    rate = Choice(60, "steps per second", RATES, "Hz")
    eccentricity = Slider(0.4, "eccentricity", "", 0.0, 0.7, step=0.05)
    MU = 4.0  # m^3/s^2

    def build(self) -> None:
        self.orbit = KeplerOrbit(self.eccentricity, 1.5, self.MU)
        setup = self.orbit.setup()
        (self.planet,), self.registry = setup.particles, setup.registry()
        self.ellipse = [self.orbit.exact(i / 90.0 * self.orbit.period) for i in range(91)]
        self.path = [(self.planet.position.x, self.planet.position.y)]

    def advance(self, duration: float = FRAME) -> None:
        super().advance(duration)
        self.path = [*self.path[-600:], (self.planet.position.x, self.planet.position.y)]

    def step(self, duration: float) -> None:
        self.registry.update_forces(duration)
        if self.order == "position first":
            self.planet.integrate(duration)
        else:
            self.planet.kick(duration)
            self.planet.drift(duration)

    def draw(self, pen: Pen) -> None:
        pen.line(self.ellipse, "gray", dashed=True)
        pen.line(self.path, "blue")
        pen.circle((0.0, 0.0), 0.14, "orange")
        pen.circle(self.orbit.exact(self.simulated), 0.08, "gray", fill=False)
        pen.circle(self.planet.position, 0.08, "blue")
        p = self.planet.position
        pen.arrow(p, self.planet.velocity * 0.2, "green", "velocity")
        pen.arrow(p, p * (-0.3 / max(p.magnitude(), 0.3)), "red", "force")

    def chart(self) -> dict[str, float]:
        p, v = self.planet.position, self.planet.velocity
        energy = 0.5 * v.squared_magnitude() - self.MU / p.magnitude()
        return {"energy, J": energy, "angular momentum, kg m²/s": p.x * v.y - p.y * v.x}

    def beside_exact(self) -> Pair:
        return [*self.planet.position][:2], self.orbit.exact(self.simulated)

    def facts(self) -> str:
        period = self.orbit.period
        return f"one orbit takes {period:.2f} s, or {period * self.rate:.0f} steps"

    def say(self) -> str:
        return f"The planet is {self.planet.position.magnitude():.2f} m from the star."
