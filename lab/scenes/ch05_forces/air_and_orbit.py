"""Interactive scenes for chapter 5: two balls that fall in air, and a planet's orbit."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch05_forces.closed_form import quadratic_fall, terminal_speed
from ch05_forces.forces import Drag, ForceRegistry, InverseSquareGravity
from ch05_forces.particle import Particle
from lab.drawing.pen import Pen
from lab.scene import Question, Scene
from scenes.clock import FRAME
from scenes.parameters import Choice, Slider

G = 9.81  # m/s^2


def lands_first(scene: FallInAir) -> int:
    """Predict which ball lands first: 0 for the left, 1 for the right, or 2 for a tie.

    The ball with the higher terminal speed wins. Without air, there is no such limit.
    """
    left, right = (
        terminal_speed(mass * G, 0.0, k2) if k2 else math.inf for mass, k2, _ in scene.balls()
    )
    return 0 if left > 1.001 * right else 1 if right > 1.001 * left else 2


class FallInAir(Scene):
    """A scene of two balls dropped from a tower, with quadratic drag from the air."""

    chapter = 5
    title = "Which ball lands first?"
    question = "Why does a heavy ball fall faster in air, but not on the moon?"
    view = (-6.0, 10.0, -4.0, 104.0)
    seconds = 7.0
    exact_from = "the closed form of a fall with quadratic drag"
    predict = Question(
        "Both balls are released together. Which one lands first?",
        ["The left ball.", "The right ball.", "Both land together."],
        lands_first,
        "Without air both balls would land together. With drag, the ball with more weight for its "
        "drag coefficient falls faster: the terminal speed is the square root of m g / k2.",
        6.0,
    )
    left_mass = Slider(4.0, "mass of the left ball", "kg", 0.1, 10.0, log=True)
    right_mass = Slider(0.5, "mass of the right ball", "kg", 0.1, 10.0, log=True)
    left_drag = Slider(0.02, "drag k2 of the left ball", "N s²/m²", 0.0, 0.1, step=0.005)
    right_drag = Slider(0.02, "drag k2 of the right ball", "N s²/m²", 0.0, 0.1, step=0.005)
    rate = Choice(60, "steps per second", [15, 30, 60, 120, 240], "Hz")
    TOP = 100.0  # m

    def balls(self) -> list[tuple[float, float, str]]:
        """Return the mass, the drag coefficient and the color of each ball."""
        return [
            (self.left_mass, self.left_drag, "blue"),
            (self.right_mass, self.right_drag, "orange"),
        ]

    def build(self) -> None:
        self.registry = ForceRegistry()
        self.fallers = []
        for i, (mass, k2, _) in enumerate(self.balls()):
            ball = Particle(Vector3(4.0 * i, self.TOP), acceleration=Vector3(0.0, -G), mass=mass)
            if k2 > 0.0:
                self.registry.add(ball, Drag(0.0, k2))
            self.fallers.append(ball)
        self.landed = [math.inf, math.inf]

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
        for i, (ball, (mass, k2, color)) in enumerate(zip(self.fallers, self.balls(), strict=True)):
            height = max(0.0, ball.position.y)
            pen.circle((4.0 * i, height + 1.5), 1.2 * mass ** (1.0 / 3.0), color)
            pen.arrow((4.0 * i, height + 1.5), (0.0, 0.5 * ball.velocity.y), "green", "velocity")
            drag = k2 * ball.velocity.y**2 / mass
            pen.arrow((4.0 * i, height + 1.5), (0.0, drag), "red", "force")
            if self.landed[i] < math.inf:
                pen.text((4.0 * i, 12.0), f"{self.landed[i]:.2f} s", color)

    def chart(self) -> dict[str, float]:
        left, right = self.fallers
        return {"speed, left, m/s": -left.velocity.y, "speed, right, m/s": -right.velocity.y}

    def state(self) -> list[float]:
        return [ball.position.y for ball in self.fallers]

    def exact(self, time: float) -> list[float]:
        """Compute the exact heights of both balls, in m.

        For a ball that has landed, return its simulated height, so that its error is 0.
        """
        heights = []
        for ball, landed, (mass, k2, _) in zip(
            self.fallers, self.landed, self.balls(), strict=True
        ):
            fallen = quadratic_fall(mass, G, k2, time)[1] if k2 else 0.5 * G * time * time
            heights.append(self.TOP - fallen if landed == math.inf else ball.position.y)
        return heights

    def facts(self) -> str:
        speeds = [
            f"{terminal_speed(mass * G, 0.0, k2):.1f} m/s" if k2 else "none (no air)"
            for mass, k2, _ in self.balls()
        ]
        return f"terminal speeds: {speeds[0]} and {speeds[1]}"

    def say(self) -> str:
        left, right = self.fallers
        heights = (left.position.y, right.position.y)
        return f"The balls are {heights[0]:.0f} m and {heights[1]:.0f} m high."


class Orbit(Scene):
    """A scene of a planet that orbits a star, for comparing two versions of the time step.

    In the book's version, a step moves the planet before it changes the velocity. In the other
    version, the velocity changes first.
    """

    chapter = 5
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
    rate = Choice(60, "steps per second", [15, 30, 60, 120, 240], "Hz")
    eccentricity = Slider(0.4, "eccentricity", "", 0.0, 0.7, step=0.05)
    MU = 4.0  # m^3/s^2
    AXIS = 1.5  # m, semi-major axis

    def build(self) -> None:
        e = self.eccentricity
        near, speed = self.AXIS * (1.0 - e), math.sqrt(self.MU / self.AXIS * (1.0 + e) / (1.0 - e))
        self.planet = Particle(Vector3(near), Vector3(0.0, speed))
        self.registry = ForceRegistry()
        self.registry.add(self.planet, InverseSquareGravity(Vector3(), self.MU))
        self.path = [(near, 0.0)]

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
        pen.line([self.kepler(i / 90.0 * self.period()) for i in range(91)], "gray", dashed=True)
        pen.line(self.path, "blue")
        pen.circle((0.0, 0.0), 0.14, "orange")
        pen.circle(self.kepler(self.simulated), 0.08, "gray", fill=False)
        pen.circle(self.planet.position, 0.08, "blue")
        p = self.planet.position
        pen.arrow(p, self.planet.velocity * 0.2, "green", "velocity")
        pen.arrow(p, p * (-0.3 / max(p.magnitude(), 0.3)), "red", "force")

    def period(self) -> float:
        """Compute how long one orbit of the planet takes, in s."""
        return math.tau * math.sqrt(self.AXIS**3 / self.MU)

    def kepler(self, time: float) -> tuple[float, float]:
        """Compute the planet's exact position at ``time``, in s.

        The position follows from Kepler's equation M = E - e sin E, which is solved by Newton's
        method.
        """
        e, mean = self.eccentricity, math.tau * time / self.period()
        anomaly = mean
        for _ in range(12):
            anomaly -= (anomaly - e * math.sin(anomaly) - mean) / (1.0 - e * math.cos(anomaly))
        wide = self.AXIS * math.sqrt(1.0 - e * e)
        return self.AXIS * (math.cos(anomaly) - e), wide * math.sin(anomaly)

    def chart(self) -> dict[str, float]:
        p, v = self.planet.position, self.planet.velocity
        energy = 0.5 * v.squared_magnitude() - self.MU / p.magnitude()
        return {"energy, J": energy, "angular momentum, kg m²/s": p.x * v.y - p.y * v.x}

    def state(self) -> list[float]:
        return [self.planet.position.x, self.planet.position.y]

    def exact(self, time: float) -> list[float]:
        return [*self.kepler(time)]

    def facts(self) -> str:
        return f"one orbit takes {self.period():.2f} s, or {self.period() * self.rate:.0f} steps"

    def say(self) -> str:
        return f"The planet is {self.planet.position.magnitude():.2f} m from the star."


SCENES = (FallInAir, Orbit)
