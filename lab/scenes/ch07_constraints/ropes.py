"""An interactive scene for chapter 7 that simulates the same rope of rods with three methods."""

from __future__ import annotations

import math
from itertools import pairwise

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.links import Rod
from lab.drawing.pen import Pen
from lab.scene import Question, Scene
from scenes.parameters import Choice, Slider

LENGTH = 3.0  # m, of the whole rope
COLORS = ("red", "blue", "green")


def no_forces(duration: float) -> None:
    """Add no forces, because gravity is already part of each particle's acceleration."""


class Ropes(Scene):
    """A scene of three copies of a rope of rods, each simulated with a different method.

    The methods are one step per frame, substeps, and a direct solve. A rope should not stretch, so
    the picture shows the excess length of each copy.
    """

    chapter = 7
    title = "One rope, three methods"
    question = "Which method keeps the rods at their true length?"
    view = (-9.5, 9.5, -4.2, 2.2)
    seconds = 6.0
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
    NAMES = ("one step", "substeps", "DirectChain")

    def build(self) -> None:
        self.ropes = [self.rope() for _ in COLORS]
        self.rods = [
            [Rod(a, b, LENGTH / self.count) for a, b in pairwise(rope)] for rope in self.ropes
        ]
        self.chain = DirectChain(self.ropes[2][1:], Vector3())

    def rope(self) -> list[Particle]:
        """Create the particles of a straight rope.

        The first particle is immovable, and the others hang from it.
        """
        a, link = math.radians(self.angle), LENGTH / self.count
        direction, down = Vector3(math.sin(a), -math.cos(a)), Vector3(0.0, -9.81)
        chain = [
            Particle(direction * (link * i), acceleration=down) for i in range(1, self.count + 1)
        ]
        return [Particle(mass=math.inf), *chain]

    def step(self, duration: float) -> None:
        for i, substeps in ((0, 1), (1, self.substeps)):
            part = duration / substeps
            for _ in range(substeps):
                semi_implicit_euler(self.ropes[i][1:], no_forces, part)
                if contacts := [contact for rod in self.rods[i] for contact in rod.contacts()]:
                    ContactResolver().resolve_contacts(contacts, part)
        self.chain.step(duration)

    def too_long(self, i: int) -> float:
        """Compute the excess length of rope ``i`` in m, added up over all of its rods."""
        return math.fsum(
            (b.position - a.position).magnitude() - LENGTH / self.count
            for a, b in pairwise(self.ropes[i])
        )

    def draw(self, pen: Pen) -> None:
        for i, (rope, color, name) in enumerate(zip(self.ropes, COLORS, self.NAMES, strict=True)):
            x = 6.4 * (i - 1)
            places = [(x + one.position.x, one.position.y) for one in rope]
            pen.line(places, color)
            pen.dots(places, color, 4.0)
            pen.segments([((x - 0.2, 0.0), (x + 0.2, 0.0))], "black", 4.0)
            pen.text((x, 1.5), name, color)
            pen.text((x, 0.8), f"{100.0 * self.too_long(i):.2f} cm too long", color, 12.0)

    def chart(self) -> dict[str, float]:
        return {f"{name}, cm": 100.0 * self.too_long(i) for i, name in enumerate(self.NAMES)}

    def state(self) -> list[float]:
        return [self.too_long(i) for i in range(3)]

    def exact(self, time: float) -> list[float]:
        return [0.0, 0.0, 0.0]

    def facts(self) -> str:
        return f"{self.count} rods of {LENGTH / self.count:.2g} m"

    def say(self) -> str:
        longest = 100.0 * self.too_long(0)
        return f"With one step per frame the rope is {longest:.1f} cm too long."


SCENES = (Ropes,)
