"""The demos of chapter 6: a bridge that springs hold up, and a cloth; both can explode."""

from __future__ import annotations

import textwrap
from itertools import pairwise

from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.cloth import G, make_cloth, neighbours
from ch06_springs.integrators import explicit_euler, semi_implicit_euler
from ch06_springs.spring_bridge import hang_bridge, load_bridge
from studies.drawing import BLACK, BLUE, GREY, ORANGE, RED
from studies.stability import stopped, watching

SPEED_LIMIT = 100.0  # m/s, far more than anything here has while it is well
STEPS = {"i": ("velocity first", semi_implicit_euler), "e": ("the book's step", explicit_euler)}


class SpringBridge:
    """A walker on planks that hang on springs (G6.2), which can be made too stiff for the step."""

    seconds = 8.0
    keys = (
        "The left and right arrow keys walk, s and d make the springs stiffer and softer, e takes "
        "the book's step and i the one with the velocity first, r starts anew."
    )
    PLANKS = 9
    PLANK_MASS = 5.0  # kg
    HEIGHT = 3.0  # m, of the anchors above the planks
    DAMPING = 40.0  # N s/m
    WEIGHT = 600.0  # N, of the walker
    PACE = 0.2  # m
    SUBSTEPS = 4  # a frame

    def __init__(self, figure: Figure) -> None:
        axes = figure.subplots()
        axes.set(xlim=(-1.0, self.PLANKS), ylim=(-1.6, self.HEIGHT + 0.4), aspect="equal")
        axes.set(xlabel="x, m", ylabel="y, m")
        anchors = range(self.PLANKS)
        axes.plot(anchors, [self.HEIGHT] * self.PLANKS, "s", color=GREY, ms=5)
        self.hangers = axes.add_collection(LineCollection([], colors=GREY, linewidths=1))
        self.deck = axes.plot([], [], "o-", color=BLUE, lw=3, ms=6)[0]
        self.walker = axes.plot([], [], "o-", color=ORANGE, lw=4, ms=9, markevery=[1])[0]
        self.title = figure.suptitle("", fontsize=10)
        self.stiffness = 2000.0  # N/m
        self.choice = "i"
        self.start()

    def start(self) -> None:
        """Hang the bridge anew, with the walker at its left end."""
        down = Vector3(0.0, -G, 0.0)
        self.planks = [
            Particle(Vector3(float(i)), acceleration=down, mass=self.PLANK_MASS)
            for i in range(self.PLANKS)
        ]
        self.registry = ForceRegistry()
        hang_bridge(self.registry, self.planks, self.HEIGHT, self.stiffness, self.DAMPING)
        self.x = 0.5
        self.choose(self.choice)

    def choose(self, choice: str) -> None:
        """Go on with another step."""
        self.choice, self.message = choice, ""
        self.step = watching(STEPS[choice][1], SPEED_LIMIT)

    def update(self, duration: float) -> None:
        if not self.message:
            self.message = stopped(lambda: self.advance(duration))

    def advance(self, duration: float) -> None:
        """Let a frame pass, in substeps; the walker's weight is added by hand before each."""
        for _ in range(self.SUBSTEPS):
            load_bridge(self.planks, self.x, self.WEIGHT)
            self.step(self.planks, self.registry.update_forces, duration / self.SUBSTEPS)

    def draw(self) -> None:
        places = [(plank.position.x, plank.position.y) for plank in self.planks]
        self.deck.set_data([x for x, _ in places], [y for _, y in places])
        tops = [(float(i), self.HEIGHT) for i in range(self.PLANKS)]
        self.hangers.set_segments([*map(list, zip(tops, places, strict=True))])
        ground = self.ground(places)
        self.walker.set_data([self.x, self.x], [ground, ground + 0.7])
        rate = 60 * self.SUBSTEPS
        state = f"{STEPS[self.choice][0]} at {rate} Hz, springs of {self.stiffness:,.0f} N/m"
        _say(self.title, state, self.message)

    def ground(self, places: list[tuple[float, float]]) -> float:
        """Return how high the bridge is where the walker stands."""
        for (x, y), (following, height) in pairwise(places):
            if x <= self.x <= following and following > x:
                return y + (height - y) * (self.x - x) / (following - x)
        return places[-1][1] if self.x > places[0][0] else places[0][1]

    def press(self, key: str) -> None:
        if key in ("left", "right"):
            pace = self.PACE if key == "right" else -self.PACE
            self.x = max(0.0, min(self.PLANKS - 1.0, self.x + pace))
        elif key in ("s", "d"):
            self.stiffness *= 2.0 if key == "s" else 0.5
            place = self.x
            self.start()
            self.x = place
        elif key in STEPS:
            if self.message:  # what has exploded begins anew
                self.start()
            self.choose(key)
        elif key == "r":
            self.start()

    def click(self, axes: object, x: float, y: float) -> None:
        """Nothing here is clicked."""

    def play(self, time: float) -> None:
        """Walk to and fro, make the springs stiffer, and try the book's step."""
        frame = round(60.0 * time)
        if frame in (180, 190, 200):
            self.press("s")
        elif frame == 270:
            self.press("e")
        elif frame == 420:
            self.press("i")
            self.press("r")
        elif frame % 5 == 0 and not self.message:
            self.press("right" if frame < 150 or frame > 420 else "left")


class Cloth:
    """A cloth that hangs from two corners: how many frames a second does each step need?"""

    seconds = 8.0
    keys = (
        "e takes the book's step and i the one with the velocity first, the up and down arrow "
        "keys change the frame rate, r starts anew."
    )
    RATES = (30, 60, 75, 90, 120, 240, 480, 960, 1920)  # Hz
    DAMPING = 0.2  # N s/m

    def __init__(self, figure: Figure) -> None:
        axes = figure.subplots()
        axes.set(xlim=(-1.7, 2.6), ylim=(-1.9, 0.7), aspect="equal")
        axes.set(xlabel="x + z / 3, m", ylabel="y + z / 3, m")
        self.mesh = axes.add_collection(LineCollection([], colors=BLUE, linewidths=1))
        self.held = axes.plot([], [], "o", color=RED, ms=6)[0]
        self.title = figure.suptitle("", fontsize=10)
        self.rate, self.choice = 240, "i"
        self.start()

    def start(self) -> None:
        """Let go of the cloth anew, level as it was."""
        self.knots, self.registry = make_cloth(self.DAMPING)
        self.time = self.due = 0.0
        self.message = ""
        self.step = watching(STEPS[self.choice][1], SPEED_LIMIT)

    def update(self, duration: float) -> None:
        if not self.message:
            self.message = stopped(lambda: self.advance(duration))

    def advance(self, duration: float) -> None:
        """Make the steps that are due by now."""
        self.due += duration * self.rate
        while self.due > 0.5:
            self.step(self.knots, self.registry.update_forces, 1.0 / self.rate)
            self.due -= 1.0
            self.time += 1.0 / self.rate

    def draw(self) -> None:
        places = [_oblique(knot.position) for knot in self.knots]
        self.mesh.set_segments([[places[a], places[b]] for a, b in neighbours()])
        held = [
            place
            for place, knot in zip(places, self.knots, strict=True)
            if not knot.has_finite_mass
        ]
        self.held.set_data([x for x, _ in held], [y for _, y in held])
        state = f"{STEPS[self.choice][0]} at {self.rate} Hz, after {self.time:.2f} s"
        _say(self.title, state, self.message)

    def press(self, key: str) -> None:
        if key in STEPS:
            self.choice = key
            self.start()
        elif key in ("up", "down"):
            place = self.RATES.index(self.rate) + (1 if key == "up" else -1)
            self.rate = self.RATES[max(0, min(len(self.RATES) - 1, place))]
            self.start()
        elif key == "r":
            self.start()

    def click(self, axes: object, x: float, y: float) -> None:
        """Nothing here is clicked."""

    def play(self, time: float) -> None:
        """Look at the cloth, then at the book's step, then at a low frame rate."""
        orders = {210: "e", 320: "i", 330: "down", 335: "down", 340: "down", 345: "down"}
        if key := orders.get(round(60.0 * time)):
            self.press(key)


DEMOS = (SpringBridge, Cloth)


def _oblique(place: Vector3) -> tuple[float, float]:
    """Return where a place is seen, from the side and from above."""
    return place.x + place.z / 3.0, place.y + place.z / 3.0


def _say(title: object, state: str, message: str) -> None:
    """Write the state above the picture, or what stopped it."""
    words = f"{state}: stopped; r starts anew. {message}" if message else state
    lines = textwrap.wrap(words, 100)
    lines += [""] * (3 - len(lines))  # the picture is laid out once, for the longest
    title.set(text="\n".join(lines), color=RED if message else BLACK)  # type: ignore[attr-defined]
