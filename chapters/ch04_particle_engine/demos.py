"""The demos of chapter 4: a ballistic range, and a display of fireworks to keep alive."""

from __future__ import annotations

import math

from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Rectangle

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.ballistics import (
    MUZZLE,
    SHOT_TYPES,
    BallisticRange,
    Shot,
    grenade_after,
)
from ch04_particle_engine.catherine_wheel import CatherineWheel
from ch04_particle_engine.display import Display, click, find_rocket, is_over, tick
from ch04_particle_engine.firework_types import FIREWORK_TYPES, own_types
from ch04_particle_engine.fireworks import FireworkRule, FireworksShow, endless_types
from ch04_particle_engine.screen_rotation import screen_angle, screen_corners
from ch04_particle_engine.targets import TargetBlock, strike_first
from studies.drawing import BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, SKY, YELLOW
from studies.readings import is_written

SHOT_COLORS = dict.fromkeys(SHOT_TYPES, PINK) | {  # a shot of your own is pink
    "pistol": BLACK,
    "artillery": GREEN,
    "fireball": ORANGE,
    "laser": RED,
    "grenade": BLUE,
    "fragment": BLUE,
}

# One for each of the eleven types, and for the sparks of the wheel.
SPARK_COLORS = (YELLOW, ORANGE, SKY, PINK, YELLOW, RED, SKY, GREEN, "white", PINK, GREEN, ORANGE)
WHEEL_SPARK = FireworkRule(12, 0.5, 0.9, (-1.5, -1.5, -1.5), (1.5, 1.5, 1.5), damping=0.4)


class Ballistics:
    """Shots of five types at blocks of several masses, seen from the side and from above."""

    seconds = 14.0
    keys = (
        "1 to 5 choose a shot, up and down its elevation, left and right its azimuth; the space "
        "bar fires, and a click aims at the point and fires."
    )
    TURN = math.radians(2.0)
    # Time in s, shot, azimuth and elevation in degrees, for the invented player.
    ORDERS = (
        (0.2, "pistol", 0.0, None),
        (1.0, "fireball", 6.0, None),
        (1.5, "laser", 0.0, None),
        (2.5, "artillery", 0.0, 40.0),
        (3.5, "grenade", -12.0, None),
        (4.0, "pistol", -5.0, 1.0),
        (5.0, "pistol", 3.6, 2.0),
        (6.5, "laser", 2.0, 2.0),
        (7.0, "artillery", 2.0, 12.0),
        (8.0, "grenade", 0.0, 60.0),
        (8.5, "artillery", -5.0, 2.0),
    )

    def __init__(self, figure: Figure) -> None:
        self.range = BallisticRange()
        if is_written(lambda: strike_first(Vector3(), Particle(), [])):
            self.range.targets += [
                TargetBlock(Vector3(0, 1, 25), (2, 2, 0.3), mass=5),
                TargetBlock(Vector3(-4, 1.5, 45), (3, 3, 1), mass=60),
                TargetBlock(Vector3(4, 1.5, 65), (3, 3, 1), mass=1000),
                TargetBlock(Vector3(0, 4, 120), (16, 8, 0.5), mass=math.inf),
            ]
        self.name = "pistol"
        self.azimuth = 0.0
        self.elevation: float | None = None
        self.trails: dict[int, tuple[Shot, list[tuple[float, float, float]]]] = {}
        self.names = [name for name in SHOT_TYPES if name != "grenade" or can_throw()]
        self.orders = [order for order in self.ORDERS if order[1] in self.names]
        self.side, self.above = figure.subplots(2, 1, sharex=True)
        self.side.set(xlim=(-2, 130), ylim=(-1, 36), ylabel="y, m")
        self.above.set(xlim=(-2, 130), ylim=(-14, 14), xlabel="z, m", ylabel="x, m")
        self.side.axhline(0.0, color=GREEN, lw=1)
        self.blocks = []
        for axes in (self.side, self.above):
            for block in self.range.targets:
                fixed = not block.particle.has_finite_mass
                box = Rectangle((0, 0), 1, 1, facecolor=GREY if fixed else ORANGE, alpha=0.7)
                self.blocks.append((axes.add_patch(box), block))
        self.lines = {
            (axes, type): axes.plot([], [], ".", ms=2, color=color, alpha=0.6)[0]
            for axes in (self.side, self.above)
            for type, color in SHOT_COLORS.items()
        }
        for name in self.names:
            self.side.plot([], [], ".", color=SHOT_COLORS[name], label=name)
        self.side.legend(fontsize=7, ncols=5, loc="upper right")
        self.title = figure.suptitle("", fontsize=10)

    def update(self, duration: float) -> None:
        self.range.update(duration)
        for shot in self.range.shots:
            p = shot.particle.position
            _, trail = self.trails.setdefault(id(shot), (shot, []))
            trail.append((p.x, p.y, p.z))
        for key in [*self.trails][:-40]:  # the last forty stay to be seen
            del self.trails[key]

    def draw(self) -> None:
        for box, block in self.blocks:
            middle, (width, height, depth) = block.particle.position, block.size
            if box.axes is self.side:
                box.set(x=middle.z - depth / 2, y=middle.y - height / 2, width=depth, height=height)
            else:
                box.set(x=middle.z - depth / 2, y=middle.x - width / 2, width=depth, height=width)
        for (axes, type), line in self.lines.items():
            points = [p for shot, trail in self.trails.values() if shot.type == type for p in trail]
            across = 1 if axes is self.side else 0
            line.set_data([p[2] for p in points], [p[across] for p in points])
        elevation = "its own" if self.elevation is None else f"{math.degrees(self.elevation):.0f}°"
        moved = "; ".join(
            f"{_mass(block)}: hits {block.hits}, {block.particle.velocity.z:.1f} m/s"
            for block in self.range.targets
        )
        self.title.set_text(
            f"{self.name}: azimuth {math.degrees(self.azimuth):.0f}°, elevation {elevation}, "
            f"{len(self.range.shots)} in flight\n{moved}"
        )

    def press(self, key: str) -> None:
        if key in "12345"[: len(self.names)]:
            self.name = self.names[int(key) - 1]
        elif key in ("left", "right"):
            self.azimuth += self.TURN if key == "left" else -self.TURN
        elif key in ("up", "down"):
            vx, vy, vz = SHOT_TYPES[self.name].velocity
            own = math.atan2(vy, math.hypot(vx, vz))
            before = own if self.elevation is None else self.elevation
            self.elevation = before + (self.TURN if key == "up" else -self.TURN)
        elif key == " ":
            self.range.fire(self.name, self.azimuth, self.elevation)

    def click(self, axes: object, x: float, y: float) -> None:
        if x <= MUZZLE[2]:
            return
        if axes is self.side:
            self.elevation = math.atan2(y - MUZZLE[1], x)
        else:
            self.azimuth = math.atan2(y, x)
        self.range.fire(self.name, self.azimuth, self.elevation)

    def play(self, time: float) -> None:
        while self.orders and self.orders[0][0] <= time:
            _, self.name, azimuth, elevation = self.orders.pop(0)
            self.azimuth = math.radians(azimuth)
            self.elevation = None if elevation is None else math.radians(elevation)
            self.range.fire(self.name, self.azimuth, self.elevation)


class Fireworks:
    """A display to keep alive by clicking on its rockets (project 4.1), with a Catherine wheel."""

    seconds = 12.0
    keys = (
        "Click on a rocket, drawn larger, before it has burnt out: it bursts, and another one "
        "starts. 1 to 9 launch a firework, r starts anew."
    )
    SPIN = 5.0  # rad/s, with which sparks turn on the screen

    def __init__(self, figure: Figure) -> None:
        self.axes = figure.add_subplot(facecolor="black")
        self.axes.set(xlim=(-30, 30), ylim=(0, 32), aspect="equal", xlabel="x, m", ylabel="y, m")
        self.sparks = self.axes.add_collection(PolyCollection([]))
        self.rim = self.axes.add_patch(Circle((0, 0), 0, fill=False, edgecolor=GREY))
        self.title = figure.suptitle("", fontsize=10)
        self.start()

    def start(self) -> None:
        """Begin a game with three rockets and a wheel."""
        own = own_types() if is_written(own_types) else []
        rules = [*FIREWORK_TYPES, *own, WHEEL_SPARK]
        self.display = Display(FireworksShow(rules, capacity=400, seed=2))
        self.wheel = make_wheel(self.display.show, Vector3(-22, 10, 0))
        self.turns = can_turn()
        self.plays = is_written(lambda: is_over(self.display)) and is_written(
            lambda: find_rocket(self.display, 0.0, 0.0)
        )
        self.endless = is_written(lambda: endless_types([])) and endless_types(rules)
        self.spins = is_written(
            lambda: screen_corners((0.0, 0.0), 1.0, screen_angle(0.0, 1.0, 0.0))
        )
        for type in (1, 6, 10 if own else 2):
            self.display.show.launch(type)

    def update(self, duration: float) -> None:
        if self.turns and not self.ended():
            self.wheel.update(duration)
        if self.plays:
            tick(self.display, duration)
        else:
            self.display.show.update(duration)

    def ended(self) -> bool:
        """Say whether the game is over, where its rules are written."""
        return self.plays and is_over(self.display)

    def draw(self) -> None:
        show = self.display.show
        squares, colors = [], []
        for firework in show.fireworks:
            p = firework.particle.position
            size = 0.9 if show.rules[firework.type].payloads else 0.45
            if self.spins:
                angle = screen_angle(0.0, self.SPIN, firework.age)
                squares.append(screen_corners((p.x, p.y), size, angle))
            else:
                squares.append([(p.x - size, p.y), (p.x, p.y - size), (p.x + size, p.y)])
            colors.append(SPARK_COLORS[(firework.type - 1) % len(SPARK_COLORS)])
        self.sparks.set(verts=squares, facecolor=colors)
        self.rim.set(center=(self.wheel.center.x, self.wheel.center.y))
        self.rim.set(radius=self.wheel.radius if self.turns else 0.0)
        state = "click on a rocket before it has burnt out" if self.plays else "1 to 9 launch"
        if self.ended():
            state = "the display has ended; r starts anew"
        elif self.endless:
            state = f"types {self.endless} light each other for ever, up to {show.capacity} sparks"
        self.title.set_text(
            f"score {self.display.score}, misses {self.display.misses}, {self.display.time:.1f} s "
            f"alive, {len(show.fireworks)} burn, {show.dropped} had no slot\n{state}"
        )

    def press(self, key: str) -> None:
        if key == "r":
            self.start()
        elif key in "123456789" and not self.ended():
            self.display.show.launch(int(key))

    def click(self, axes: object, x: float, y: float) -> None:
        del axes  # there is only one
        if self.plays:
            click(self.display, x, y)

    def play(self, time: float) -> None:
        """Click on each rocket late, but for the last seconds, in which the display goes dark."""
        if time > self.seconds - 3.0:
            return
        if not self.plays:
            if round(time * 60.0) % 60 == 59:
                self.display.show.launch(1 + round(time) % 2 * 5)
            return
        for firework in [*self.display.show.fireworks]:  # click adds to the show's own list
            if 0.0 < firework.age < 0.3 and firework.type in (1, 2, 6, 10):
                p = firework.particle.position
                click(self.display, p.x, p.y)


DEMOS = (Ballistics, Fireworks)


def make_wheel(show: FireworksShow, center: Vector3) -> CatherineWheel:
    """Return a wheel whose sparks are of the type of WHEEL_SPARK."""
    return CatherineWheel(
        show, WHEEL_SPARK.type, center, radius=2.0, rate=9.0, sparks_per_second=90.0, jet=26.0
    )


def can_throw() -> bool:
    """Say whether what happens to a grenade is written."""
    return is_written(lambda: grenade_after(Shot("grenade", Particle())))


def can_turn() -> bool:
    """Say whether the wheel is written: a trial one throws sparks."""
    show = FireworksShow([WHEEL_SPARK], capacity=9, seed=1)
    return is_written(lambda: make_wheel(show, Vector3()).update(1.0))


def _mass(block: TargetBlock) -> str:
    return f"{block.particle.mass:g} kg" if block.particle.has_finite_mass else "the wall"
