"""An interactive scene for chapter 7 that simulates the same rope of rods with three methods."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.links import Rod
from lab.drawing.pen import Pen
from lab.scene import Question, Scene
from scenes.chain import Chain
from scenes.parameters import Choice, Slider
from scenes.resolving import by_resolver, resolving

LENGTH = 3.0  # m, of the whole rope
METHODS = {"one step": "red", "substeps": "blue", "DirectChain": "green"}


class Ropes(Scene):
    """Three copies of a rope that should not stretch, each simulated with another method."""

    title = "One rope, three methods"
    question = "Which method keeps the rods at their true length?"
    view = (-9.5, 9.5, -4.2, 2.2)
    exact_from = "the length of the rods"
    predict = Question(
        "Which rope stretches the most?",
        ["One step per frame.", "Substeps.", "The direct solve."],
        lambda _: 0,
        "Each iteration of the resolver fixes one rod and disturbs its neighbors. With substeps "
        "there is less to fix in each step. The direct solve finds the pulls of all rods at once.",
        3.0,
    )
    count = Choice(5, "rods", [1, 2, 3, 5, 10, 15, 20])
    angle = Slider(60.0, "angle at the start", "degrees", 0.0, 90.0, step=5.0)
    substeps = Choice(8, "substeps of the blue rope", [1, 2, 4, 8, 16], live=True)

    def build(self) -> None:
        rod = LENGTH / self.count
        self.rope = Chain([1.0] * self.count, rod, math.radians(self.angle), 9.81)
        self.setups = [self.rope.setup(Rod) for _ in METHODS]
        self.chain = DirectChain(self.setups[2].particles, Vector3())

    def step(self, duration: float) -> None:
        for setup, substeps in zip(self.setups, (1, self.substeps), strict=False):
            bodies, rods = setup.particles, setup.contacts
            resolving(semi_implicit_euler, bodies, rods, by_resolver(), substeps=substeps)(duration)
        self.chain.step(duration)

    def too_long(self, i: int) -> float:
        """Add up the excess lengths of all rods of rope ``i``, in m."""
        return math.fsum(self.rope.excess(self.setups[i].particles))

    def draw(self, pen: Pen) -> None:
        for i, (name, color) in enumerate(METHODS.items()):
            x = 6.4 * (i - 1)
            positions = [Vector3(), *(body.position for body in self.setups[i].particles)]
            places = [(x + position.x, position.y) for position in positions]
            pen.line(places, color)
            pen.dots(places, color, 4.0)
            pen.segments([((x - 0.2, 0.0), (x + 0.2, 0.0))], "black", 4.0)
            pen.text((x, 1.5), name, color)
            pen.text((x, 0.8), f"{100.0 * self.too_long(i):.2f} cm too long", color, 12.0)

    def chart(self) -> dict[str, float]:
        return {f"{name}, cm": 100.0 * self.too_long(i) for i, name in enumerate(METHODS)}

    def state(self) -> list[float]:
        return [self.too_long(i) for i in range(3)]

    def exact(self, time: float) -> list[float]:
        return [0.0, 0.0, 0.0]

    def facts(self) -> str:
        return f"{self.count} rods of {self.rope.length:.2g} m"

    def say(self) -> str:
        longest = 100.0 * self.too_long(0)
        return f"With one step per frame the rope is {longest:.1f} cm too long."
