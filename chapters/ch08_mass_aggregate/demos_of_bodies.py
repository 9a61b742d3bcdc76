"""More demos of chapter 8: what rods and bonds hold together, and what they do not."""

from __future__ import annotations

import math
from itertools import combinations

from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from ch02_vectors.vector import Vector3
from ch08_mass_aggregate import blob, cube, tilting_platform, wheel
from ch08_mass_aggregate.demos_common import (
    EARTH,
    WOOD,
    Point,
    WorldDemo,
    draw_ground,
    lines,
    seen,
)
from studies.drawing import BLACK, BLUE, GREEN, GREY, ORANGE, RED, is_written
from studies.links import ends_of

DIRECTIONS = {"left": (-1.0, 0.0), "right": (1.0, 0.0), "down": (0.0, -1.0), "up": (0.0, 1.0)}


class Platform(WorldDemo):
    """A weight on a platform that tilts on a pivot, which can be freed (mini-project 8.1)."""

    seconds = 12.0
    keys = (
        "The left and right arrow keys move the weight, up and down make it heavier and lighter, "
        "f frees the pivot, r starts anew."
    )
    RATE = 60.0  # Hz
    PACE = 0.5  # m
    LEAST, MOST = 1.0, 32.0  # kg

    def __init__(self, figure: Figure) -> None:
        super().__init__(figure)
        axes = figure.subplots()
        axes.set(xlim=(-7.0, 7.0), ylim=(-1.2, 6.3), aspect="equal", xlabel="x, m", ylabel="y, m")
        draw_ground(axes, 1.2)
        self.top = axes.add_collection(PolyCollection([], facecolor=WOOD, alpha=0.5))
        self.rods = lines(axes, BLUE, 1.5)
        self.pivot = axes.plot([], [], "^", ms=11)[0]
        self.weight = axes.add_patch(Rectangle((0, 0), 1, 1, color=ORANGE, zorder=3))
        platform = tilting_platform.TiltingPlatform
        self.can_load = is_written(lambda: platform().put_weight(0.0, 0.0))
        self.can_free = is_written(lambda: platform().free_pivot())
        self.start()

    def start(self) -> None:
        """Build the platform anew, with a weight over its pivot."""
        self.platform = tilting_platform.TiltingPlatform()
        self.mass, self.x = 4.0, 0.0
        self.free = False
        self.put()
        self.run(self.platform.step, self.platform.world, self.RATE)

    def put(self) -> None:
        """Put the weight where it is to be."""
        if self.can_load:
            self.platform.put_weight(self.mass, self.x)

    def draw(self) -> None:
        left, right = tilting_platform.LEFT, tilting_platform.RIGHT
        corners = [particle.position for particle in self.platform.particles]
        self.top.set_verts([[seen(corners[i]) for i in (2, 3, 5, 4)]])
        self.rods.set_segments([[*map(seen, ends_of(rod))] for rod in self.platform.rods])
        pivots = [seen(corner) for corner in corners[:2]]
        self.pivot.set_data([x for x, _ in pivots], [y for _, y in pivots])
        self.pivot.set_color(GREEN if self.free else RED)
        share = (self.x - left) / (right - left)
        x = corners[2].x + share * (corners[4].x - corners[2].x)
        y = corners[2].y + share * (corners[4].y - corners[2].y)
        size = 0.35 * self.mass ** (1.0 / 3.0) if self.can_load else 0.0
        angle = math.degrees(self.platform.tilt())
        self.weight.set(xy=(x - 0.5 * size, y), width=size, height=size, angle=angle)
        self.weight.rotation_point = (x, y)
        pivot = "free" if self.free else "held"
        self.say(
            f"weight {self.mass:g} kg at {self.x:g} m along the platform, tilt {angle:.1f}°\n"
            f"the pivot is {pivot}{self.balance()}"
        )

    def balance(self) -> str:
        """Return in words what would balance where the weight is."""
        places = [tilting_platform.LEFT, tilting_platform.RIGHT]
        ends = [2.0 * tilting_platform.MASS] * 2
        try:
            mass = tilting_platform.balancing_mass(ends, places, self.x)
        except NotImplementedError:
            return ""
        except ValueError:
            return "; no mass at this place balances the platform"
        return f"; {mass:.1f} kg at this place balance the platform while it is level"

    def press(self, key: str) -> None:
        if key in ("left", "right"):
            x = self.x + (self.PACE if key == "right" else -self.PACE)
            self.x = max(tilting_platform.LEFT, min(tilting_platform.RIGHT, x))
            self.put()
        elif key in ("up", "down"):
            self.mass *= 2.0 if key == "up" else 0.5
            self.mass = max(self.LEAST, min(self.MOST, self.mass))
            self.put()
        elif key == "f" and self.can_free and not self.free:
            self.platform.free_pivot()
            self.free = True
        elif key == "r":
            self.start()

    def play(self, time: float) -> None:
        """Let it tip, walk the weight to the left end and back, and free the pivot."""
        orders = dict.fromkeys(range(180, 240, 10), "left") | {330: "up", 340: "up"}
        orders |= dict.fromkeys(range(380, 480, 8), "right") | {500: "f"}
        orders |= dict.fromkeys(range(580, 650, 5), "left")
        if key := orders.get(round(60.0 * time)):
            self.press(key)


class Blob(WorldDemo):
    """A blob of bonds that break and heal, to throw about; cables can hold it together."""

    seconds = 12.0
    keys = (
        "The arrow keys push the blob for a moment, c switches cables on and off and starts "
        "anew, r starts anew."
    )
    RATE = 120.0  # Hz
    PUSH = 6.0  # N on each particle, six times its weight
    MOMENT = 0.2  # s

    def __init__(self, figure: Figure) -> None:
        super().__init__(figure)
        self.axes = axes = figure.subplots()
        axes.set(xlim=(-4.1, 4.1), ylim=(-0.4, 4.1), aspect="equal", xlabel="x, m", ylabel="y, m")
        draw_ground(axes, 0.4)
        self.bonds = lines(axes, BLUE, 1.2)
        self.dots = axes.plot([], [], "o", color=BLACK, ms=7)[0]
        self.arrow = axes.quiver(
            [0], [0], [0], [0], color=ORANGE, angles="xy", scale_units="xy", scale=1, zorder=3
        )
        self.cables = False
        self.can_measure = is_written(lambda: blob.spread(blob.Blob().particles))
        self.start()

    def start(self) -> None:
        """Let a blob fall."""
        self.blob = blob.Blob(cables=self.cables)
        self.pushed = 0.0
        self.eye = 0.0  # x in m of the middle of the picture
        self.axes.set_xlim(-4.1, 4.1)
        self.run(self.blob.step, self.blob.world, self.RATE)

    def advance(self, duration: float) -> None:
        if self.pushed <= 0.0:
            self.blob.push = Vector3()
        super().advance(duration)
        self.pushed -= duration

    def draw(self) -> None:
        segments, colors = [], []
        for bond in self.blob.bonds:
            if bond.holds:
                a, b = bond.a.position, bond.b.position
                segments.append([(a.x, a.y), (b.x, b.y)])
                stretch = (b - a).magnitude() / bond.rest_length
                colors.append(RED if stretch > blob.LIMIT else BLUE)
        self.bonds.set_segments(segments)
        self.bonds.set(colors=colors)
        x = [particle.position.x for particle in self.blob.particles]
        y = [particle.position.y for particle in self.blob.particles]
        self.dots.set_data(x, y)
        push = self.blob.push
        middle = math.fsum(x) / len(x)
        self.arrow.set_offsets([(middle, math.fsum(y) / len(y))])
        self.arrow.set_UVC([0.15 * push.x], [0.15 * push.y])
        if abs(middle - self.eye) > 3.0:  # it has no friction, and would soon be out of sight
            self.eye = middle + math.copysign(3.0, self.eye - middle)
            self.axes.set_xlim(self.eye - 4.1, self.eye + 4.1)
        kind = "with cables" if self.cables else "without cables"
        state = f"{kind}: {len(segments)} of {len(self.blob.bonds)} bonds hold"
        if self.can_measure:
            state += f", the spread is {blob.spread(self.blob.particles):.2f} m"
        self.say(f"{state}\nred bonds are stretched beyond their limit of elasticity")

    def press(self, key: str) -> None:
        if key in DIRECTIONS:
            x, y = DIRECTIONS[key]
            self.blob.push = Vector3(x * self.PUSH, y * self.PUSH)
            self.pushed = self.MOMENT
        elif key == "c":
            self.cables = not self.cables
            self.start()
        elif key == "r":
            self.start()

    def play(self, time: float) -> None:
        """Throw the blob about, then again with cables."""
        frame = round(60.0 * time) % 360
        orders = {70: "up", 110: "down", 122: "down", 134: "down", 270: "right", 300: "left"}
        if key := orders.get(frame):
            self.press(key)
        elif frame == 0 and time > 0.0:
            self.press("c")


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
