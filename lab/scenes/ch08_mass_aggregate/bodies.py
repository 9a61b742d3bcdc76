"""Interactive scenes for chapter 8: a platform that tilts on a pivot, and a blob that can tear."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch08_mass_aggregate import blob, tilting_platform
from lab.drawing.camera import flat
from lab.drawing.pen import Pen
from lab.scene import Question
from lab.world_scene import WorldScene
from scenes.links import ends_of
from scenes.parameters import Choice, Slider
from scenes.readings import is_written

# kg m, the torque of the unloaded platform divided by g
ENDS = 2.0 * tilting_platform.MASS * (tilting_platform.LEFT + tilting_platform.RIGHT)
DIRECTIONS = {"left": (-1.0, 0.0), "right": (1.0, 0.0), "down": (0.0, -1.0), "up": (0.0, 1.0)}


class Platform(WorldScene):
    """A platform that tilts on a pivot, under a weight that the reader moves (mini-project 8.1)."""

    title = "A platform that tips"
    question = "Where does the weight balance the platform?"
    view = (-7.0, 7.0, -1.2, 6.3)
    seconds = 12.0
    keys = {
        "left": "move the weight to the left",
        "right": "move the weight to the right",
        "f": "free the pivot",
    }
    predict = Question(
        "The right end is farther from the pivot. Which end goes down?",
        ["The left end.", "The right end.", "Neither: the platform is balanced."],
        lambda scene: 2 if abs(scene.torque()) < 1e-9 else int(scene.torque() > 0.0),
        "Each mass exerts a torque in proportion to its distance from the pivot. The end on the "
        "side with the larger torque goes down.",
        3.0,
    )
    mass = Slider(4.0, "weight", "kg", 0.0, 32.0, step=0.5, live=True)
    x = Slider(-1.0, "position of the weight", "m", -3.0, 4.0, step=0.25, live=True)
    PACES = {"left": -0.5, "right": 0.5}  # m
    # Let the platform tip for 3 s. Then move the weight back and forth, and free the pivot.
    script = dict.fromkeys(range(180, 240, 10), "right") | {500: "f"}
    script |= dict.fromkeys(range(380, 480, 8), "left")
    script |= dict.fromkeys(range(580, 650, 5), "right")

    def build(self) -> None:
        self.platform = tilting_platform.TiltingPlatform()
        self.free = False
        self.put: tuple[float, float] | None = None
        self.run(self.platform.step, self.platform.world)

    def step(self, duration: float) -> None:
        if self.put != (self.mass, self.x):
            self.platform.put_weight(self.mass, self.x)
            self.put = self.mass, self.x
        super().step(duration)

    def draw(self, pen: Pen) -> None:
        pen.ground()
        corners = [particle.position for particle in self.platform.particles]
        pen.area([flat(corners[i]) for i in (2, 3, 5, 4)], "wood")
        rods = [(flat(a), flat(b)) for a, b in map(ends_of, self.platform.rods)]
        pen.segments(rods, "blue", 1.5)
        pen.dots(map(flat, corners[:2]), "green" if self.free else "red", 9.0)
        share = (self.x - tilting_platform.LEFT) / (tilting_platform.RIGHT - tilting_platform.LEFT)
        place = (corners[2] + corners[3]) * (0.5 - 0.5 * share)
        place.add_scaled(corners[4] + corners[5], 0.5 * share)
        radius = 0.18 * self.mass ** (1.0 / 3.0)
        pen.circle((place.x, place.y + radius), radius, "orange", grab="weight")
        pen.arrow(place, (0.0, -0.05 * self.mass), "red", "force")
        self.contacts.draw(pen, 1.0)

    def chart(self) -> dict[str, float]:
        return {"tilt, degrees": math.degrees(self.platform.tilt()), **self.used()}

    def torque(self) -> float:
        return float(ENDS + self.mass * self.x)

    def facts(self) -> str:
        balance = f"{-ENDS / self.x:.2f} kg" if self.x * ENDS < 0.0 else "no weight"
        return f"torque / g = {self.torque():+.2f} kg m; {balance} would balance it here"

    def say(self) -> str:
        pivot = "free" if self.free else "held"
        tilt = math.degrees(self.platform.tilt())
        return f"The platform is tilted by {tilt:.0f}°. The pivot is {pivot}."

    def press(self, key: str) -> None:
        if key in self.PACES:
            self.drag("weight", self.x + self.PACES[key], 0.0)
        elif key == "f" and not self.free:
            self.platform.free_pivot()
            self.free = True

    def drag(self, name: str, x: float, y: float) -> None:
        self.values["x"] = max(tilting_platform.LEFT, min(tilting_platform.RIGHT, x))


class Blob(WorldScene):
    """A blob of particles with bonds that can break and heal, which the reader pushes around."""

    title = "A blob that tears"
    question = "How hard a push tears the blob apart, and can cables prevent it?"
    view = (-4.1, 4.1, -0.4, 4.1)
    seconds = 12.0
    keys = {
        "left": "push to the left",
        "right": "push to the right",
        "down": "push down",
        "up": "push up",
    }
    rate = Choice(120, "steps per second", [60, 120, 240], "Hz", live=True)
    cables = Choice("none", "cables", ["none", "along each bond"])
    push = Slider(6.0, "push on each particle", "N", 1.0, 20.0, step=1.0, live=True)
    MOMENT = 0.2  # s, how long a push lasts

    def build(self) -> None:
        self.blob = blob.Blob(cables=self.cables != "none")
        self.pushed = 0.0
        self.eye = 0.0  # m, x of the middle of the picture
        self.can_measure = is_written(lambda: blob.spread(self.blob.particles))
        self.run(self.blob.step, self.blob.world)

    def step(self, duration: float) -> None:
        if self.pushed <= 0.0:
            self.blob.push = Vector3()
        super().step(duration)
        self.pushed -= duration

    def draw(self, pen: Pen) -> None:
        places = [particle.position for particle in self.blob.particles]
        middle = sum(places[1:], places[0]) / len(places)
        if abs(middle.x - self.eye) > 3.0:  # follow the blob, which slides without friction
            self.eye = middle.x + math.copysign(3.0, self.eye - middle.x)
        away = Vector3(-self.eye)
        pen.ground()
        first = math.floor(self.eye - 4.0)
        marks = [x - self.eye for x in range(first, first + 10)]
        pen.segments([((x, 0.0), (x, -0.1)) for x in marks])
        seen: dict[bool, list[tuple[Vector3, Vector3]]] = {False: [], True: []}
        for bond in self.blob.bonds:
            if bond.holds:
                a, b = bond.a.position, bond.b.position
                is_over = (b - a).magnitude() > blob.LIMIT * bond.rest_length
                seen[is_over].append((a + away, b + away))
        pen.segments(seen[False], "blue", 1.5)
        pen.segments(seen[True], "red", 1.5)
        pen.dots([place + away for place in places], "black", 7.0)
        pen.arrow(middle + away, self.blob.push * 0.15, "orange", "force")
        self.contacts.draw(pen, 2.0)

    def holding(self) -> int:
        return sum(bond.holds for bond in self.blob.bonds)

    def chart(self) -> dict[str, float]:
        found = {"intact bonds": float(self.holding())}
        if self.can_measure:
            found["spread, m"] = blob.spread(self.blob.particles)
        return found

    def facts(self) -> str:
        limit, most = f"{blob.LIMIT:g}", f"{blob.BREAK:g}"
        return f"a bond turns red beyond {limit} and breaks at {most} times its length"

    def say(self) -> str:
        return f"{self.holding()} of {len(self.blob.bonds)} bonds are intact."

    def press(self, key: str) -> None:
        if key in DIRECTIONS:
            self.blob.push = Vector3(*DIRECTIONS[key]) * self.push
            self.pushed = self.MOMENT

    def play(self, time: float) -> None:
        """Push the blob upward, downward and to both sides."""
        orders = {70: "up", 110: "down", 122: "down", 134: "down", 270: "right", 300: "left"}
        self.press(orders.get(round(60.0 * time) % 360, ""))
