"""Demos of bodies of rods in chapter 8: a wheel that rolls and a cube that falls."""

from __future__ import annotations

import math
from itertools import combinations

from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure

from ch02_vectors.vector import Vector3
from ch08_mass_aggregate import cube, wheel
from ch08_mass_aggregate.demos_common import EARTH, Point, WorldDemo, lines
from studies.drawing import BLACK, BLUE, GREY, ORANGE
from studies.links import ends_of
from studies.readings import is_written


class Wheel(WorldDemo):
    """A wheel of rods that is driven at its rim (mini-project 8.3)."""

    seconds = 10.0
    keys = (
        "The up and down arrow keys change the force, 1 to 8 how many particles of the rim are "
        "driven, which starts anew, as r does."
    )
    RATE = 60.0  # Hz
    STRONGEST = 20.0  # N

    def __init__(self, figure: Figure) -> None:
        super().__init__(figure)
        side, self.plot = figure.subplots(1, 2)
        side.set(xlim=(-1.6, 1.6), ylim=(-1.6, 1.6), aspect="equal", xticks=[], yticks=[])
        self.rods = lines(side, BLUE, 3.0)
        self.rim = side.plot([], [], "o", color=BLACK, ms=8)[0]
        self.driven_rim = side.plot([], [], "o", color=ORANGE, ms=12)[0]
        side.plot([0], [0], "s", color=GREY, ms=12)
        self.arrows = lines(side, ORANGE, 2.5)
        self.plot.set(xlim=(0, 8), ylim=(-6, 14), xlabel="time, s", ylabel="spin, rad/s")
        self.plot.set_box_aspect(1.0)
        self.rigid = self.plot.plot([], [], "--", color=GREY, label="of a rigid wheel")[0]
        self.spin = self.plot.plot([], [], color=BLUE, label="of this wheel")[0]
        self.plot.legend(fontsize=8, loc="lower right")
        self.plot.locator_params(nbins=5)
        self.force, self.driven = 1.0, wheel.COUNT
        self.start()

    def start(self) -> None:
        """Build the wheel anew, at rest."""
        self.wheel = wheel.Wheel(self.force, self.driven)
        hub, rim, rods = self.wheel.hub, self.wheel.rim, self.wheel.rods
        self.can_spin = is_written(lambda: wheel.spin(hub, rim))
        self.can_deform = is_written(lambda: wheel.deformation(rods))
        self.time = self.rigid_spin = 0.0
        self.track: list[tuple[float, float, float]] = []
        self.plot.set_xlim(0.0, 8.0)
        self.run(self.wheel.step, self.wheel.world, self.RATE)

    def advance(self, duration: float) -> None:
        super().advance(duration)
        self.time += duration
        torque = self.driven * self.force * wheel.RADIUS
        self.rigid_spin += torque / (wheel.COUNT * wheel.MASS * wheel.RADIUS**2) * duration
        spin = wheel.spin(self.wheel.hub, self.wheel.rim) if self.can_spin else math.nan
        self.track.append((self.time, spin, self.rigid_spin))

    def draw(self) -> None:
        self.rods.set_segments([[*map(_flat, ends_of(rod))] for rod in self.wheel.rods])
        rim = [_flat(particle.position) for particle in self.wheel.rim]
        self.rim.set_data([x for x, _ in rim], [y for _, y in rim])
        driven = rim[: self.driven]
        self.driven_rim.set_data([x for x, _ in driven], [y for _, y in driven])
        reach = 0.05 * self.force
        self.arrows.set_segments([[(x, y), (x - reach * y, y + reach * x)] for x, y in driven])
        times = [time for time, _, _ in self.track]
        self.spin.set_data(times, [spin for _, spin, _ in self.track])
        self.rigid.set_data(times, [spin for _, _, spin in self.track])
        if self.time > self.plot.get_xlim()[1]:
            self.plot.set_xlim(0.0, 2.0 * self.time)
        state = f"{self.driven} of {wheel.COUNT} driven by {self.force:g} N each"
        if self.track and self.can_spin:
            state += f": spin {self.track[-1][1]:.2f} rad/s"
        if self.can_deform:
            state += f", deformed by {100.0 * wheel.deformation(self.wheel.rods):.4f} %"
        why = "each step takes away the speed along the rods: the faster it spins, the more that is"
        self.say(f"{state}\n{why}")

    def press(self, key: str) -> None:
        if key in ("up", "down"):
            force = self.force + (1.0 if key == "up" else -1.0)
            self.force = max(-self.STRONGEST, min(self.STRONGEST, force))
            self.wheel.drive.force = self.force
        elif key in tuple("12345678"):
            self.driven = int(key)
            self.start()
        elif key == "r":
            self.start()

    def play(self, time: float) -> None:
        """Drive all of the rim, brake it, and then drive one particle alone with much more."""
        orders = dict.fromkeys(range(60, 84, 6), "up") | dict.fromkeys(range(240, 288, 6), "down")
        orders |= {370: "1"} | dict.fromkeys(range(380, 600, 6), "up")
        if key := orders.get(round(60.0 * time)):
            self.press(key)


class Cube(WorldDemo):
    """A cube of rods falls on a corner; how many can be taken away (mini-project 8.2)?"""

    seconds = 10.5
    keys = "d takes a rod away, a puts it back, each starts anew, as r does."
    RATE = 60.0  # Hz
    HEIGHT = 1.6  # m, of the lowest corner at first

    def __init__(self, figure: Figure) -> None:
        super().__init__(figure)
        axes = figure.subplots()
        axes.set(xlim=(-3.5, 3.5), ylim=(-1.1, 3.2), aspect="equal")
        axes.set_axis_off()
        size = 2.2
        corners = [(-size, -size), (size, -size), (size, size), (-size, size)]
        ground = [_tilted(Vector3(x, 0.0, z)) for x, z in corners]
        axes.add_collection(PolyCollection([ground], facecolor=EARTH))
        self.shadows = lines(axes, "#C4BDB0", 2.0)
        self.rods = lines(axes, BLUE, 3.0)
        self.corners = axes.plot([], [], "o", color=BLACK, ms=7)[0]
        self.all_rods = cube.cube_rods()
        self.count = len(self.all_rods)
        self.start()

    def start(self) -> None:
        """Let a cube of the rods that are left fall."""
        self.cube = cube.Cube(self.HEIGHT, self.all_rods[: self.count])
        self.first = self.distances()
        self.run(self.cube.step, self.cube.world, self.RATE)

    def distances(self) -> list[float]:
        """Return how far every two corners are apart."""
        places = [particle.position for particle in self.cube.particles]
        return [(b - a).magnitude() for a, b in combinations(places, 2)]

    def draw(self) -> None:
        rods = [ends_of(rod) for rod in self.cube.rods]
        self.rods.set_segments([[_tilted(a), _tilted(b)] for a, b in rods])
        flat = Vector3(1.0, 0.0, 1.0)
        shadows = [[_tilted(a.component_product(flat)) for a in ends] for ends in rods]
        self.shadows.set_segments(shadows)
        places = [_tilted(particle.position) for particle in self.cube.particles]
        self.corners.set_data([x for x, _ in places], [y for _, y in places])
        pairs = zip(self.distances(), self.first, strict=True)
        change = 100.0 * max(abs(now / then - 1.0) for now, then in pairs)
        state = f"{self.count} of {len(self.all_rods)} rods"
        if is_written(lambda: cube.fewest_rods(8)):
            state += f", at least {cube.fewest_rods(8)} make a cube rigid"
        self.say(f"{state}\nthe distance of two corners has changed by up to {change:.1f} %")

    def press(self, key: str) -> None:
        if key == "d":
            self.count = max(0, self.count - 1)
        elif key == "a":
            self.count = min(len(self.all_rods), self.count + 1)
        elif key != "r":
            return
        self.start()

    def play(self, time: float) -> None:
        """Watch the rigid cube, one without a rod, and one that has only a few."""
        frame = round(60.0 * time)
        if frame == 200 or frame in range(420, 430, 2):
            self.press("d")


def _flat(place: Vector3) -> Point:
    return place.x, place.y


def _tilted(place: Vector3) -> Point:
    """Return where a place is seen from a corner, and from above."""
    across, away = 0.87 * place.x - 0.5 * place.z, 0.5 * place.x + 0.87 * place.z
    return across, 0.94 * place.y + 0.34 * away
