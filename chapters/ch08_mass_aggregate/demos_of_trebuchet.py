"""The trebuchet of chapter 8, thrown again and again."""

from __future__ import annotations

import dataclasses

from matplotlib.figure import Figure

from ch08_mass_aggregate import trebuchet
from ch08_mass_aggregate.demos_common import EARTH, WOOD, Point, WorldDemo, lines
from studies.drawing import BLACK, BLUE, GREY, ORANGE


class Trebuchet(WorldDemo):
    """A trebuchet throws (project 8.2), and where the counterweight's energy goes."""

    seconds = 11.3
    keys = (
        "The up and down arrow keys change the counterweight, left and right the angle at which "
        "the sling lets go; each throws anew, and r does so as it is."
    )
    LIGHTEST, HEAVIEST = 250.0, 600.0  # kg
    # For a chapter without my_design.
    DESIGN = trebuchet.Design(400.0, 1.0, 4.0, 3.0, 40.0)

    def __init__(self, figure: Figure) -> None:
        super().__init__(figure)
        places = figure.subplot_mosaic(
            [["machine", "flight"], ["machine", "energy"]], width_ratios=(4, 5)
        )
        self.machine, self.flight, self.energy = (
            places[name] for name in ("machine", "flight", "energy")
        )
        self.flight.set(xlim=(-10.0, 130.0), ylim=(-4.0, 45.0), aspect="equal")
        self.flight.set(xlabel="x, m", ylabel="y, m", xticks=(0, 50, 100), yticks=(0, 40))
        self.energy.set(xlim=(0.0, 2.5), xlabel="time, s", ylabel="energy, kJ")
        self.energy.locator_params(nbins=3)
        self.machine.set(aspect="equal")
        self.machine.set_axis_off()  # most of the time for a picture is for the axes
        for axes in (self.machine, self.flight):
            axes.axhspan(-4.0, 0.0, color=EARTH, zorder=0)
        top = trebuchet.PIVOT_HEIGHT
        self.machine.plot([-1.5, 0.0, 1.5], [0.0, top, 0.0], color=GREY, lw=3)
        self.brace = self.machine.plot([], [], color=WOOD, lw=1)[0]
        self.beam = self.machine.plot([], [], color=WOOD, lw=5, solid_joinstyle="round")[0]
        self.weight = self.machine.plot([], [], "s", color=BLUE)[0]
        self.sling = self.machine.plot([], [], color=BLACK, lw=1)[0]
        self.swing = self.machine.plot([], [], ":", color=ORANGE, lw=1.5)[0]
        self.stone = self.machine.plot([], [], "o", color=ORANGE, ms=7)[0]
        self.flight.plot([0, 0], [0, top], color=GREY, lw=3)
        self.earlier = lines(self.flight, "#BBBBBB")
        self.path = self.flight.plot([], [], color=ORANGE, lw=2)[0]
        self.shot = self.flight.plot([], [], "o", color=ORANGE, ms=5)[0]
        self.lost = self.energy.plot([], [], color=BLUE, lw=2)[0]
        self.gained = self.energy.plot([], [], color=ORANGE, lw=2)[0]
        gains = (("the counterweight lost", 0.86, BLUE), ("the projectile gained", 0.72, ORANGE))
        for label, height, color in gains:
            self.energy.text(0.03, height, label, color=color, transform=self.energy.transAxes)
        self.paths: list[list[Point]] = []
        self.way: list[Point] = []
        self.design = first_design()
        self.start()

    def start(self) -> None:
        """Throw with the design as it is now; what flew before stays to be seen."""
        if self.way:
            self.paths = [*self.paths[-5:], self.way]
        design = self.design
        self.engine = trebuchet.Trebuchet(design)
        self.throw: trebuchet.Throw | None = None
        self.way = []
        self.energies: list[tuple[float, float, float]] = []
        self.time = 0.0
        self.end = ""
        self.heights = (self.engine.weight.position.y, self.engine.projectile.position.y)
        self.run(self.engine.step, self.engine.world, 1.0 / trebuchet.STEP)
        reach = design.long_arm + design.sling
        top = trebuchet.PIVOT_HEIGHT + reach + 0.5
        self.machine.set(xlim=(-0.5 * top, 0.5 * top), ylim=(-0.7, top))
        self.energy.set(ylim=(-0.5, 2.2e-3 * design.counterweight * trebuchet.G * design.short_arm))

    def advance(self, duration: float) -> None:
        engine = self.engine
        if self.end and not engine.flies:
            return
        if self.time == 0.0:  # only now: it takes long, and keys may follow each other fast
            self.throw = thrown(self.design)
        swings = not engine.flies
        super().advance(duration)
        self.time += duration
        if self.end:
            return
        place = engine.projectile.position
        self.way.append((place.x, max(0.0, place.y)))
        if swings:
            self.energies.append(self.measure())
        if place.y <= 0.0:
            self.end = "it is down" if engine.flies else "it touched the ground in the sling"
            engine.world.particles.remove(engine.projectile)  # the world has no ground

    def measure(self) -> tuple[float, float, float]:
        """Return the time, what the counterweight has lost and the projectile has gained, in kJ."""
        weight, projectile = self.engine.weight, self.engine.projectile
        lost = weight.mass * trebuchet.G * (self.heights[0] - weight.position.y)
        risen = projectile.mass * trebuchet.G * (projectile.position.y - self.heights[1])
        return self.time, 1e-3 * lost, 1e-3 * (risen + projectile.kinetic_energy())

    def draw(self) -> None:
        engine = self.engine
        pivot, weight, tip, stone = (
            (particle.position.x, particle.position.y)
            for particle in (engine.pivot, engine.weight, engine.tip, engine.projectile)
        )
        self.brace.set_data([weight[0], tip[0]], [weight[1], tip[1]])
        self.beam.set_data([weight[0], pivot[0], tip[0]], [weight[1], pivot[1], tip[1]])
        self.weight.set_data([weight[0]], [weight[1]])
        self.weight.set_markersize(2.5 * self.design.counterweight ** (1.0 / 3.0))
        self.sling.set_data([], [])
        if not engine.flies:
            self.sling.set_data([tip[0], stone[0]], [tip[1], stone[1]])
        x, y = [p[0] for p in self.way], [p[1] for p in self.way]
        for line in (self.swing, self.path):
            line.set_data(x, y)
        for dot in (self.stone, self.shot):
            dot.set_data([stone[0]], [max(0.0, stone[1])])
        self.earlier.set_segments(self.paths)
        times = [time for time, _, _ in self.energies]
        self.lost.set_data(times, [lost for _, lost, _ in self.energies])
        self.gained.set_data(times, [gained for _, _, gained in self.energies])
        self.say(self.state())

    def state(self) -> str:
        """Return what the title says: the design, and what the throw came to."""
        state = (
            f"counterweight {self.design.counterweight:g} kg, "
            f"lets go at {self.design.release_angle:g}°"
        )
        if not self.engine.flies:
            return f"{state}\n{self.end or 'it swings'}"
        state += f"\n{self.end or 'it flies'}"
        if self.throw is not None:
            share = 100.0 * self.throw.share
            state += f": range {self.throw.range:.1f} m, with {share:.0f} % of the energy"
        return state

    def press(self, key: str) -> None:
        design = self.design
        if key in ("up", "down"):
            mass = design.counterweight + (50.0 if key == "up" else -50.0)
            mass = max(self.LIGHTEST, min(self.HEAVIEST, mass))
            self.design = dataclasses.replace(design, counterweight=mass)
        elif key in ("left", "right"):
            angle = design.release_angle + (5.0 if key == "left" else -5.0)
            angle = max(-80.0, min(80.0, angle))
            self.design = dataclasses.replace(design, release_angle=angle)
        elif key != "r":
            return
        self.start()

    def play(self, time: float) -> None:
        """Throw, then with a heavier counterweight, and let go earlier."""
        if round(60.0 * time) == 320:
            for key in ("up", "up", "up", "left", "left"):
                self.press(key)


def first_design() -> trebuchet.Design:
    """Return my_design, or a middling one while that is a stub."""
    try:
        return trebuchet.my_design()
    except NotImplementedError:
        return Trebuchet.DESIGN


def thrown(design: trebuchet.Design) -> trebuchet.Throw | None:
    """Return what the engine says of a throw, None where it cannot or that is a stub."""
    try:
        return trebuchet.Trebuchet(design).throw()
    except (NotImplementedError, ArithmeticError, ValueError):
        return None
