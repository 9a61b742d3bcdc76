"""An interactive scene for chapter 9: a freely spinning box that may keep flipping over."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch09_rotations.going_further.free_box import FreeBox
from lab.drawing.box import draw_box
from lab.drawing.camera import flat
from lab.drawing.pen import Pen
from lab.scene import Question, Scene
from scenes.parameters import Choice, Slider
from scenes.readings import numbers

SPINS = ("smallest", "middle", "largest")


class Spin(Scene):
    """A box shaped like a thick book, which spins about an axis, and a little about another."""

    title = "A book thrown into the air"
    question = "About which of its axes does a free body keep spinning?"
    view = (-0.45, 0.45, -0.34, 0.34)
    seconds = 12.0
    exact_from = "the conservation of energy and angular momentum"
    error_unit = "J or kg m²/s"
    predict = Question(
        "The book is spun about one of its axes. Does it keep on spinning about that axis?",
        ["Yes, it only wobbles a little.", "No, it turns over again and again."],
        lambda scene: int(scene.about == "middle" and scene.disturbance > 0.0),
        "A spin about the axis with the smallest or the largest moment of inertia is stable. About "
        "the middle axis, every disturbance grows until the book has turned over.",
        9.0,
    )
    about = Choice("middle", "axis, by its moment of inertia", SPINS)
    disturbance = Slider(5.0, "spin about another axis", "%", 0.0, 20.0, step=0.5)
    SIDES = (0.2, 0.3, 0.1)  # m
    SPEED = math.tau  # rad/s, one turn per second
    ARROW = 0.24  # m

    def build(self) -> None:
        sides, mass = Vector3(*self.SIDES), 1.0  # m, kg
        moments = numbers(FreeBox(mass, sides, Vector3()).inertia)
        by_moment = sorted(range(3), key=lambda axis: moments[axis])
        self.axis = by_moment[SPINS.index(self.about)]
        spin = [0.0, 0.0, 0.0]
        spin[self.axis] = self.SPEED
        spin[self.axis - 2] = self.SPEED * 0.01 * self.disturbance
        self.box = FreeBox(mass, sides, Vector3(*spin))
        self.first = self.state()
        self.turned_over, self.before = 0, self.SPEED

    def step(self, duration: float) -> None:
        self.box.step(duration)
        now = numbers(self.box.own_velocity())[self.axis]
        self.turned_over += now * self.before < 0.0
        self.before = now

    def draw(self, pen: Pen) -> None:
        turn = self.box.orientation.rotate
        draw_box(pen, self.SIDES, turn)
        velocity = turn(self.box.own_velocity()) * (self.ARROW / self.SPEED)
        pen.arrow((0.0, 0.0), flat(velocity), "pink", "velocity")
        momentum = self.box.angular_momentum.normalized() * self.ARROW
        pen.arrow((0.0, 0.0), flat(momentum), "black")
        pen.text((-0.2, -0.28), "angular momentum: constant", "black", 12.0)
        pen.text((-0.2, -0.31), "angular velocity: changes", "pink", 12.0)

    def chart(self) -> dict[str, float]:
        velocity = numbers(self.box.own_velocity())
        return {f"spin about {name}, rad/s": v for name, v in zip("XYZ", velocity, strict=True)}

    def state(self) -> list[float]:
        """Return the energy in J and the angular momentum in kg m^2/s, both conserved."""
        own = self.box.own_velocity().component_product(self.box.inertia)
        return [self.box.energy(), *numbers(self.box.orientation.rotate(own))]

    def exact(self, time: float) -> list[float]:
        return self.first

    def facts(self) -> str:
        return f"X blue, Y orange, Z green; spun about {'XYZ'[self.axis]} at one turn per second"

    def say(self) -> str:
        times = "once" if self.turned_over == 1 else f"{self.turned_over} times"
        return f"The book has turned over {times}."
