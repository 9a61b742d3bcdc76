"""The sniper range for chapter 5 (project 4.2): ten shots in a wind that changes with each shot."""

from __future__ import annotations

import math

from ch05_forces import sniper
from lab.drawing.pen import Pen
from lab.scene import Scene

COLORS = ("sky", "water", "blue")  # of the rings, from the outside in
STEP = 0.0005  # rad
TURNS = {"left": (STEP, 0.0), "right": (-STEP, 0.0), "up": (0.0, STEP), "down": (0.0, -STEP)}


class Sniper(Scene):
    """A shooting range, seen through a rifle's scope. Coordinates are angles in milliradians."""

    title = "The sniper range"
    question = "How far beside the target must you aim in this wind?"
    view = (-42.0, 42.0, -17.0, 30.0)
    seconds = 22.0
    keys = {
        "left": "aim to the left",
        "right": "aim to the right",
        "up": "aim higher",
        "down": "aim lower",
        "f": "fire",
        "n": "begin a new round",
    }

    seed = 2  # of the winds

    def build(self) -> None:
        """Begin a new round of ten shots, with new winds."""
        self.seed += 1
        self.range = sniper.SniperRange(self.seed)
        self.aim = (0.0, 0.0)
        self.waited = 0.0
        self.result = "Wait for the wind, aim and fire."

    def step(self, duration: float) -> None:
        flying, holes = self.range.bullet is not None, len(self.range.holes)
        self.range.update(duration)
        self.waited += duration
        if self.range.bullet is not None:
            self.waited = 0.0
        elif flying:
            hits = self.range.holes[holes:]
            self.result = f"A hit for {hits[0].points} points." if hits else "The shot missed."

    def draw(self, pen: Pen) -> None:
        for target in sniper.TARGETS:
            middle = seen(target.x, target.y, target.distance)
            for (radius, _), color in zip(reversed(sniper.RINGS), COLORS, strict=True):
                pen.circle(middle, 1000.0 * radius / target.distance, color)
            below = (middle[0], middle[1] - 14.0)
            pen.text(below, f"{target.distance:g} m, x {target.factor}", "gray", 12.0)
        for hole in self.range.holes:
            x, y = hole.target.x + hole.x, hole.target.y + hole.y
            pen.dots([seen(x, y, hole.target.distance)], "red", 5.0)
        if self.range.bullet is not None:
            p = self.range.bullet.position
            pen.dots([seen(p.x, p.y, p.z)], "black", 4.0)
        x, y = -1000.0 * self.aim[0], 1000.0 * self.aim[1]
        pen.segments([((x - 2.0, y), (x + 2.0, y)), ((x, y - 2.0), (x, y + 2.0))], "red", 1.5)
        wind = self.range.wind.velocity
        scale = 10.0 / sniper.STRONGEST_WIND
        pen.arrow((0.0, 25.0), (-scale * wind.x, 0.0), "orange")
        pen.text((0.0, 27.5), f"crosswind of {abs(wind.x):.1f} m/s", "orange")

    def chart(self) -> dict[str, float]:
        return {"score": float(self.range.score)}

    def facts(self) -> str:
        wind = self.range.wind.velocity
        return f"{abs(wind.z):.1f} m/s {'tail' if wind.z > 0.0 else 'head'}wind; {self.result}"

    def say(self) -> str:
        if self.range.is_over():
            return f"The round is over. Your score is {self.range.score}. Press n for a new round."
        side = "left" if self.range.wind.velocity.x > 0.0 else "right"
        shots = f"{self.range.shots_left} of {sniper.SHOTS} shots"
        return f"The wind blows to the {side}. {shots} are left."

    def press(self, key: str) -> None:
        if key == "n":
            self.build()
        elif key == "f":
            self.shoot(*self.aim)
        elif key in TURNS:
            (azimuth, elevation), (left, up) = self.aim, TURNS[key]
            self.aim = (azimuth + left, elevation + up)

    def click(self, x: float, y: float) -> None:
        self.shoot(-x / 1000.0, y / 1000.0)

    def shoot(self, azimuth: float, elevation: float) -> None:
        """Aim at two angles in rad, as far as the rifle can turn, and fire if it is loaded."""
        most = sniper.SWING
        self.aim = (max(-most, min(most, azimuth)), max(-most, min(most, elevation)))
        self.range.shoot(*self.aim)

    def play(self, time: float) -> None:
        """Simulate a player who shoots at one target after another, and allows for the wind."""
        if self.waited < 1.0 or self.range.is_over():
            return
        target = sniper.TARGETS[(sniper.SHOTS - self.range.shots_left) % len(sniper.TARGETS)]
        slows = (sniper.K1 + sniper.K2 * sniper.MUZZLE_SPEED) / sniper.BULLET_MASS
        flight = -math.log(1.0 - slows * target.distance / sniper.MUZZLE_SPEED) / slows
        drop = -sniper.GRAVITY[1] * flight * flight / 2.0
        # The wind carries the bullet along for as long as drag has delayed it.
        drift = self.range.wind.velocity.x * (flight - target.distance / sniper.MUZZLE_SPEED)
        self.shoot(
            math.atan2(target.x - drift, target.distance),
            math.atan2(target.y + drop - sniper.MUZZLE[1], target.distance),
        )


def seen(x: float, y: float, z: float) -> tuple[float, float]:
    """Compute where the rifle scope shows the point (x, y, z), in milliradians. +x is left."""
    along = max(z, 1.0)
    return -1000.0 * x / along, 1000.0 * (y - sniper.MUZZLE[1]) / along
