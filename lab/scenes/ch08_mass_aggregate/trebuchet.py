"""An interactive scene for chapter 8: a trebuchet, and where its energy goes (project 8.2)."""

from __future__ import annotations

from dataclasses import replace

from ch08_mass_aggregate import trebuchet
from lab.drawing.pen import Pen
from lab.scene import Question
from lab.world_scene import WorldScene
from scenes.parameters import Choice, Slider
from scenes.readings import is_written

# The machine is drawn a second time, enlarged by this factor and at this position in m.
LARGER, MACHINE = 2.2, (27.0, 33.0)
DESIGN = trebuchet.Design(400.0, 1.0, 4.0, 3.0, 40.0)  # used if my_design is not written


class Trebuchet(WorldScene):
    """The student's trebuchet, whose counterweight and release angle the reader can change."""

    title = "A trebuchet"
    question = "Which angle of release throws farthest?"
    view = (-14.0, 134.0, -5.0, 66.0)
    seconds = 7.0
    predict = Question(
        "How much of the counterweight's energy does the projectile get?",
        ["Less than a quarter.", "From a quarter to a half.", "From a half to three quarters."],
        lambda scene: int(scene.share() >= 0.25) + int(scene.share() >= 0.5),
        "The counterweight falls, then slows down while the beam and the sling speed up. In a good "
        "design it has almost stopped when the sling lets go of the projectile.",
        4.0,
    )
    rate = Choice(240, "steps per second", [60, 120, 240, 480], "Hz", live=True)
    counterweight = Slider(400.0, "counterweight", "kg", 250.0, 600.0, step=25.0)
    earlier = Slider(0.0, "release earlier by", "degrees", -40.0, 40.0, step=5.0)

    def build(self) -> None:
        own = trebuchet.my_design() if is_written(trebuchet.my_design) else DESIGN
        angle = max(-80.0, min(80.0, own.release_angle + self.earlier))
        self.design = replace(own, counterweight=self.counterweight, release_angle=angle)
        self.engine = trebuchet.Trebuchet(self.design)
        self.way: list[tuple[float, float]] = []  # of the projectile
        self.end = ""  # says where the projectile landed
        self.lost = self.gained = 0.0  # J
        self.heights = (self.engine.weight.position.y, self.engine.projectile.position.y)
        self.run(self.engine.step, self.engine.world)

    def step(self, duration: float) -> None:
        if self.end:
            return
        super().step(duration)
        engine, weight, projectile = self.engine, self.engine.weight, self.engine.projectile
        place = projectile.position
        self.way.append((place.x, max(0.0, place.y)))
        if not engine.flies:
            self.lost = weight.mass * trebuchet.G * (self.heights[0] - weight.position.y)
            risen = projectile.mass * trebuchet.G * (place.y - self.heights[1])
            self.gained = risen + projectile.kinetic_energy()
        if place.y <= 0.0:
            landed = f"It lands {place.x:.1f} m from the pivot."
            self.end = landed if engine.flies else "It touches the ground in the sling."

    def share(self) -> float:
        """Compute what fraction of the energy lost by the counterweight went to the projectile."""
        return self.gained / self.lost if self.lost > 0.0 else 0.0

    def draw(self, pen: Pen) -> None:
        pen.ground()
        x, y = MACHINE
        self.draw_machine(pen, 1.0, 0.0, 0.0)
        self.draw_machine(pen, LARGER, x, y)
        pen.text((x, y - 3.0), f"the machine, enlarged {LARGER:g} times", "gray", 12.0)
        pen.segments([((x - 20.0, y), (x + 20.0, y))], "gray")
        pen.line(self.way, "orange", 1.5)
        stone = self.engine.projectile
        pen.dots([(stone.position.x, max(0.0, stone.position.y))], "orange", 8.0)
        pen.arrow(stone.position, stone.velocity * 0.4, "green", "velocity")
        pen.text((88.0, 58.0), self.end, "black", 14.0)

    def draw_machine(self, pen: Pen, scale: float, x0: float, y0: float) -> None:
        """Draw the trebuchet, enlarged by ``scale``, with its origin at (x0, y0)."""
        engine = self.engine
        pivot, weight, tip, stone = (
            (x0 + scale * one.position.x, y0 + scale * max(0.0, one.position.y))
            for one in (engine.pivot, engine.weight, engine.tip, engine.projectile)
        )
        width = 1.0 + scale
        pen.line([(x0 - 1.5 * scale, y0), pivot, (x0 + 1.5 * scale, y0)], "gray", width)
        pen.line([weight, pivot, tip], "wood", 1.5 * width)
        pen.circle(weight, scale * 0.09 * self.design.counterweight ** (1.0 / 3.0), "blue")
        if not engine.flies:
            pen.line([tip, stone], "black", 1.0)
            pen.circle(stone, 0.25 * scale, "orange")

    def chart(self) -> dict[str, float]:
        return {"counterweight lost, kJ": 1e-3 * self.lost, "projectile, kJ": 1e-3 * self.gained}

    def facts(self) -> str:
        one = self.design
        arms = f"arms {one.short_arm:g} m and {one.long_arm:g} m"
        return f"{arms}, sling {one.sling:g} m, release at {one.release_angle:g}°"

    def say(self) -> str:
        if self.end:
            return f"{self.end} It received {100.0 * self.share():.0f} % of the energy."
        return "The projectile flies." if self.engine.flies else "The beam swings."
