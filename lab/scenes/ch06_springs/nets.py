"""Interactive scenes for chapter 6 with many springs, which may explode: a bridge and a cloth."""

from __future__ import annotations

from itertools import pairwise

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.going_further.cloth import KNOTS, G, make_cloth, neighbors
from ch06_springs.spring_bridge import hang_bridge, load_bridge
from lab.drawing.pen import Pen
from lab.scenes.ch06_springs.spring import Stepped
from scenes.parameters import Choice, Slider


class SpringBridge(Stepped):
    """A person walks across a bridge whose planks hang from springs (exercise G6.2)."""

    title = "A bridge on springs"
    question = "How stiff may the springs be before the bridge explodes?"
    view = (-1.0, 9.0, -2.0, 4.2)
    seconds = 8.0
    keys = {"left": "walk to the left", "right": "walk to the right"}
    rate = Choice(240.0, "steps per second", [60.0, 120.0, 240.0, 480.0], "Hz", live=True)
    stiffness = Slider(2000.0, "stiffness k", "N/m", 500.0, 200_000.0, log=True)
    PLANKS = 9
    PLANK_MASS = 5.0  # kg
    HEIGHT = 3.0  # m, of the anchors above the planks
    DAMPING = 40.0  # N s/m
    WEIGHT = 600.0  # N, of the walker
    PACE = 0.2  # m
    script = {frame: "right" if frame < 240 else "left" for frame in range(0, 480, 6)}

    def build(self) -> None:
        down = Vector3(0.0, -G, 0.0)
        places = [Vector3(float(i)) for i in range(self.PLANKS)]
        self.particles = [Particle(at, acceleration=down, mass=self.PLANK_MASS) for at in places]
        self.registry = ForceRegistry()
        hang_bridge(self.registry, self.particles, self.HEIGHT, self.stiffness, self.DAMPING)
        self.x = 0.5

    def step(self, duration: float) -> None:
        load_bridge(self.particles, self.x, self.WEIGHT)
        super().step(duration)

    def draw(self, pen: Pen) -> None:
        places = [plank.position for plank in self.particles]
        tops = [(float(i), self.HEIGHT) for i in range(self.PLANKS)]
        for ends in zip(tops, places, strict=True):
            pen.spring(*ends)
        pen.dots(tops, "black", 5.0)
        pen.line(places, "wood", 5.0)
        ground = self.ground()
        pen.segments([((self.x, ground), (self.x, ground + 0.8))], "orange", 5.0)
        pen.circle((self.x, ground + 0.95), 0.18, "orange")
        pen.arrow((self.x, ground), (0.0, -0.002 * self.WEIGHT), "red", "force")

    def ground(self) -> float:
        """Compute the height of the bridge where the person stands, in m."""
        places = [plank.position for plank in self.particles]
        for a, b in pairwise(places):
            if a.x <= self.x <= b.x and b.x > a.x:
                return a.y + (b.y - a.y) * (self.x - a.x) / (b.x - a.x)
        return places[-1].y if self.x > places[0].x else places[0].y

    def chart(self) -> dict[str, float]:
        return {"height of the walker, m": self.ground()}

    def facts(self) -> str:
        return f"semi-implicit Euler is stable below about {self.limit():,.0f} N/m"

    def limit(self) -> float:
        """Compute the largest stiffness in N/m for which semi-implicit Euler is stable.

        In the fastest oscillation of a long row, neighboring planks move in opposite directions. A
        plank of mass m then moves as if it hung from a spring with stiffness 4 k and damping 4 c.
        With steps of length h, it is stable if 4 k h^2 / m + 2 (4 c) h / m < 4.
        """
        rate: float = self.rate
        return self.PLANK_MASS * rate * rate - 2.0 * self.DAMPING * rate

    def say(self) -> str:
        return f"The walker stands at x = {self.x:.1f} m, {self.ground():.2f} m high."

    def press(self, key: str) -> None:
        pace = {"left": -self.PACE, "right": self.PACE}.get(key, 0.0)
        self.x = max(0.0, min(self.PLANKS - 1.0, self.x + pace))


class Cloth(Stepped):
    """A cloth hangs from two corners, which the reader can drag."""

    title = "A cloth of 180 springs"
    question = "How many steps per second does each integrator need for a cloth?"
    view = (-1.7, 2.6, -2.1, 0.9)
    seconds = 8.0
    rates = [30.0, 60.0, 90.0, 120.0, 240.0, 480.0]
    rate = Choice(240.0, "steps per second", rates, "Hz", live=True)
    damping = Slider(0.2, "damping c", "N s/m", 0.0, 1.0, step=0.05)
    HELD = (("left", 0), ("right", KNOTS - 1))

    def build(self) -> None:
        self.particles, self.registry = make_cloth(self.damping)

    def draw(self, pen: Pen) -> None:
        places = [oblique(knot.position) for knot in self.particles]
        pen.segments([(places[a], places[b]) for a, b in neighbors()], "blue")
        for name, i in self.HELD:
            pen.circle(places[i], 0.05, "red", grab=name)

    def chart(self) -> dict[str, float]:
        movable = [knot for knot in self.particles if knot.has_finite_mass]
        energies = [knot.kinetic_energy() + knot.mass * G * knot.position.y for knot in movable]
        return {"kinetic + gravitational energy, J": sum(energies)}

    def facts(self) -> str:
        return f"{len(neighbors())} springs, evaluated at least {self.rate:g} times per second"

    def say(self) -> str:
        lowest = min(knot.position.y for knot in self.particles)
        return f"The lowest knot is {-lowest:.2f} m below the corners."

    def drag(self, name: str, x: float, y: float) -> None:
        knot = self.particles[dict(self.HELD)[name]]
        knot.position.x, knot.position.y = x, min(y, 0.8)

    def play(self, time: float) -> None:
        """Pull a corner of the cloth aside and up, and then move it back."""
        if 3.0 < time < 5.0:
            self.drag("right", 0.9 + 0.4 * (time - 3.0), 0.2 * (time - 3.0))
        elif 5.0 < time < 7.0:
            self.drag("right", 1.7 - 0.4 * (time - 5.0), 0.4 - 0.2 * (time - 5.0))


def oblique(place: Vector3) -> tuple[float, float]:
    """Project a 3D point onto the picture, as seen from one side and slightly from above."""
    return place.x + place.z / 3.0, place.y + place.z / 3.0
