"""Interactive scenes for chapter 8 with bodies made of rods: a driven wheel and a falling cube."""

from __future__ import annotations

import math
from itertools import combinations, pairwise

from ch02_vectors.vector import Vector3
from ch07_constraints.links import Rod
from ch08_mass_aggregate import cube, wheel
from lab.drawing.pen import Pen
from lab.scene import Pair, Question
from lab.world_scene import WorldScene
from scenes.links import ends_of
from scenes.parameters import Choice, Slider
from scenes.readings import is_written
from scenes.setup import Setup
from scenes.twin import twin_of


class Wheel(WorldScene):
    """A wheel of rods that is driven at its rim (mini-project 8.3), beside a rigid wheel."""

    title = "A wheel of rods"
    question = "Does a wheel of particles spin up like a rigid wheel?"
    view = (-1.6, 1.6, -1.6, 1.6)
    seconds = 10.0
    exact_from = "a rigid wheel"
    error_unit = "rad/s"
    iterations = Choice(300, "most iterations per phase", [1, 3, 10, 30, 100, 300], live=True)
    force = Slider(1.0, "force on each particle", "N", -20.0, 20.0, step=1.0, live=True)
    driven = Choice(8, "driven particles", [1, 2, 4, 8])

    def build(self) -> None:
        self.wheel = wheel.Wheel(self.force, self.driven)
        self.can_deform = is_written(lambda: wheel.deformation(self.wheel.rods))
        self.rigid_spin = 0.0  # rad/s
        self.run(self.wheel.step, self.wheel.world)

    def step(self, duration: float) -> None:
        self.wheel.drive.force = self.force
        super().step(duration)
        torque = self.driven * self.force * wheel.RADIUS
        self.rigid_spin += torque / (wheel.COUNT * wheel.MASS * wheel.RADIUS**2) * duration

    def draw(self, pen: Pen) -> None:
        pen.segments([ends_of(rod) for rod in self.wheel.rods], "blue", 3.0)
        pen.circle(self.wheel.hub.position, 0.06, "gray")
        for i, particle in enumerate(self.wheel.rim):
            driven = i < self.driven
            pen.circle(particle.position, 0.07, "orange" if driven else "black")
            if driven:
                x, y = particle.position.x, particle.position.y
                reach = 0.05 * self.force
                pen.arrow(particle.position, (-reach * y, reach * x), "red", "force")
            pen.arrow(particle.position, particle.velocity * 0.1, "green", "velocity")
        self.contacts.draw(pen, 1.0)

    def spin(self) -> float:
        return wheel.spin(self.wheel.hub, self.wheel.rim)

    def chart(self) -> dict[str, float]:
        return {"spin, rad/s": self.spin(), "rigid wheel, rad/s": self.rigid_spin}

    def beside_exact(self) -> Pair:
        return [self.spin()], [self.rigid_spin]

    def facts(self) -> str:
        return "a rigid wheel gains " + (
            f"{self.driven * self.force / (wheel.COUNT * wheel.MASS * wheel.RADIUS):.2f} rad/s per "
            "second; this wheel loses the speed along its rods in each step"
        )

    def say(self) -> str:
        words = f"The wheel spins at {self.spin():.2f} rad/s"
        if self.can_deform:
            words += f" and is deformed by {100.0 * wheel.deformation(self.wheel.rods):.3f} %"
        return words + "."

    def play(self, time: float) -> None:
        """Drive the rim of the wheel harder, and then brake it."""
        self.values["force"] = 1.0 if time < 1.0 else 5.0 if time < 4.0 else -3.0


class PymunkWheel(Wheel):
    """A version of the ``Wheel`` scene in which pymunk simulates the wheel, with pin joints."""

    def build(self) -> None:
        super().build()
        hub, rim = self.wheel.hub, self.wheel.rim
        ends = [(a, b) for a, after in pairwise([*rim, rim[0]]) for b in (hub, after)]
        joints = [Rod(b, a, (b.position - a.position).magnitude()) for a, b in ends]
        self.space, (*self.bodies, _) = twin_of(Setup([*rim, hub], contacts=joints))
        self.make_step = self.step_space

    def step_space(self, duration: float) -> None:
        for body in self.bodies[: self.driven]:
            x, y = body.position
            share = self.force / math.hypot(x, y)
            body.force = (-y * share, x * share)
        self.space.iterations = self.iterations
        self.space.step(duration)
        for particle, body in zip(self.wheel.rim, self.bodies, strict=True):
            particle.position.x, particle.position.y = body.position.x, body.position.y
            particle.velocity.x, particle.velocity.y = body.velocity.x, body.velocity.y


class Cube(WorldScene):
    """A cube of rods that falls on one of its corners (mini-project 8.2)."""

    title = "A cube of rods"
    question = "How many rods can be removed before the cube collapses?"
    view = (-3.5, 3.5, -1.1, 3.2)
    predict = Question(
        "The cube falls on a corner. Does it keep its shape?",
        ["Yes, it stays a cube.", "No, it collapses."],
        lambda scene: int(scene.changed() > 10.0),
        "Eight particles have 24 degrees of freedom, and a rigid body has six. Each rod removes "
        "one of them, so a rigid cube needs at least 18 rods.",
        3.0,
    )
    iterations = Choice(300, "most iterations per phase", [1, 3, 10, 30, 100, 300], live=True)
    taken = Choice(1, "removed rods", [0, 1, 2, 3, 6, 12, 18])
    HEIGHT = 1.6  # m, initial height of the lowest corner
    SIZE = 2.2  # m, half the side length of the ground

    def build(self) -> None:
        rods = cube.cube_rods()
        self.count = max(0, len(rods) - self.taken)
        self.cube = cube.Cube(self.HEIGHT, rods[: self.count])
        self.first = self.distances()
        self.run(self.cube.step, self.cube.world)

    def distances(self) -> list[float]:
        places = [particle.position for particle in self.cube.particles]
        return [(b - a).magnitude() for a, b in combinations(places, 2)]

    def changed(self) -> float:
        """Find the largest change in the distance between two corners, in percent."""
        pairs = zip(self.distances(), self.first, strict=True)
        return 100.0 * max(abs(now / then - 1.0) for now, then in pairs)

    def draw(self, pen: Pen) -> None:
        size = self.SIZE
        corners = [(-size, -size), (size, -size), (size, size), (-size, size)]
        pen.area([tilted(Vector3(x, 0.0, z)) for x, z in corners], "gray")
        rods = [ends_of(rod) for rod in self.cube.rods]
        shadows = [(Vector3(a.x, 0.0, a.z), Vector3(b.x, 0.0, b.z)) for a, b in rods]
        pen.segments([(tilted(a), tilted(b)) for a, b in shadows], "gray", 2.0)
        pen.segments([(tilted(a), tilted(b)) for a, b in rods], "blue", 3.0)
        pen.dots([tilted(particle.position) for particle in self.cube.particles], "black", 7.0)

    def chart(self) -> dict[str, float]:
        return {"largest change in a distance, %": self.changed(), **self.used()}

    def facts(self) -> str:
        fewest = ""
        if is_written(lambda: cube.fewest_rods(8)):
            fewest = f"; a rigid cube needs at least {cube.fewest_rods(8)}"
        return f"{self.count} rods{fewest}"

    def say(self) -> str:
        return f"The distance between two corners has changed by up to {self.changed():.1f} %."


def tilted(place: Vector3) -> tuple[float, float]:
    """Project a 3D point onto the picture, as seen from above at an angle."""
    across, away = 0.87 * place.x - 0.5 * place.z, 0.5 * place.x + 0.87 * place.z
    return across, 0.94 * place.y + 0.34 * away


Wheel.peers = {"pymunk": PymunkWheel}
