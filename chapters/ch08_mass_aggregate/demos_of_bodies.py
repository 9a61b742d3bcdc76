"""Demos of bodies in chapter 8 that tip over or tear: the tilting platform and the blob."""

from __future__ import annotations

import math

from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from ch02_vectors.vector import Vector3
from ch08_mass_aggregate import blob, tilting_platform
from ch08_mass_aggregate.demos_common import WOOD, WorldDemo, draw_ground, lines, seen
from studies.drawing import BLACK, BLUE, GREEN, ORANGE, RED
from studies.links import ends_of
from studies.readings import is_written

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
