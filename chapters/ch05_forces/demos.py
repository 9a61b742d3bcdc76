"""The demo of chapter 5: the sniper range, through the scope and from above."""

from __future__ import annotations

import math

from matplotlib.figure import Figure
from matplotlib.patches import Circle

from ch05_forces.sniper import (
    BULLET_MASS,
    END_OF_RANGE,
    GRAVITY,
    K1,
    K2,
    MUZZLE,
    MUZZLE_SPEED,
    RINGS,
    SHOTS,
    STRONGEST_WIND,
    SWING,
    TARGETS,
    SniperRange,
)
from studies.drawing import BLACK, BLUE, GREY, ORANGE, RED

RING_COLORS = ("white", "#cfe3f1", BLUE)  # from the outermost


class Sniper:
    """Ten shots at discs at four distances, in a wind that changes after each (project 4.2)."""

    seconds = 22.0
    keys = (
        "A click in the scope shoots there. The arrow keys move the cross by half a mrad, the "
        "space bar shoots where it is, r starts anew."
    )
    STEP = 0.0005  # rad

    def __init__(self, figure: Figure) -> None:
        self.scope, self.above = figure.subplots(2, 1, height_ratios=(3, 2))
        self.scope.set(xlim=(42, -42), ylim=(-15, 24), xlabel="azimuth, mrad", aspect="equal")
        self.scope.set(ylabel="elevation, mrad")
        self.above.set(xlim=(-2, END_OF_RANGE), ylim=(-4, 8), xlabel="z, m", ylabel="x, m")
        for target in TARGETS:
            middle = _seen((target.x, target.y, target.distance))
            for (radius, _), color in zip(reversed(RINGS), RING_COLORS, strict=True):
                size = 1000.0 * radius / target.distance
                self.scope.add_patch(Circle(middle, size, facecolor=color, edgecolor=GREY, lw=0.5))
            label = f"{target.distance:g} m, x {target.factor}"
            below = (middle[0], middle[1] - 14.0)
            self.scope.annotate(label, below, ha="center", va="bottom", fontsize=7)
            reach = RINGS[-1][0]
            across = [target.x - reach, target.x + reach]
            self.above.plot([target.distance] * 2, across, color=BLUE, lw=3)
        self.cross = self.scope.plot([], [], "+", color=RED, ms=14, mew=1)[0]
        self.holes = self.scope.plot([], [], "o", color=RED, mec="white", ms=5)[0]
        self.bullet = self.scope.plot([], [], "o", color=BLACK, ms=3)[0]
        self.path = self.above.plot([], [], color=BLACK, lw=1)[0]
        self.arrow = self.above.annotate(
            "", (0, 0), (0, 0), arrowprops={"arrowstyle": "-|>", "color": ORANGE, "lw": 2}
        )
        self.title = figure.suptitle("", fontsize=10)
        self.seed = 2
        self.start()

    def start(self) -> None:
        """Begin a round, with other winds than the last."""
        self.seed += 1
        self.range = SniperRange(self.seed)
        self.aim = (0.0, 0.0)
        self.way: list[tuple[float, float, float]] = []
        self.waited = 0.0
        self.result = ""

    def update(self, duration: float) -> None:
        flying, holes = self.range.bullet is not None, len(self.range.holes)
        self.range.update(duration)
        self.waited += duration
        if self.range.bullet is not None:
            p = self.range.bullet.position
            self.way.append((p.x, p.y, p.z))
            self.waited = 0.0
        elif flying:
            hits = self.range.holes[holes:]
            self.result = f", the last hit for {hits[0].points}" if hits else ", the last missed"

    def draw(self) -> None:
        self.cross.set_data([1000.0 * self.aim[0]], [1000.0 * self.aim[1]])
        places = [
            _seen((hole.target.x + hole.x, hole.target.y + hole.y, hole.target.distance))
            for hole in self.range.holes
        ]
        self.holes.set_data([x for x, _ in places], [y for _, y in places])
        flying = [_seen(self.way[-1])] if self.way and self.range.bullet is not None else []
        self.bullet.set_data([x for x, _ in flying], [y for _, y in flying])
        self.path.set_data([z for _, _, z in self.way], [x for x, _, _ in self.way])
        wind = self.range.wind.velocity
        # The axes are of different lengths: the arrow is drawn for its direction as one sees it.
        scale = 1.5 / STRONGEST_WIND
        self.arrow.xy = (105.0 + 30.0 * scale * wind.z, 6.0 + 1.2 * scale * wind.x)
        self.arrow.set_position((105.0, 6.0))
        state = f"{self.range.shots_left} of {SHOTS} shots left, score {self.range.score}"
        if self.range.is_over():
            state = f"the round is over with a score of {self.range.score}; r starts anew"
        side, along = "left" if wind.x > 0.0 else "right", "tail" if wind.z > 0.0 else "head"
        self.title.set_text(
            f"wind (the arrow): {abs(wind.x):.1f} m/s to the {side}, {abs(wind.z):.1f} m/s "
            f"{along}wind\n{state}{self.result}"
        )

    def press(self, key: str) -> None:
        azimuth, elevation = self.aim
        if key == "r":
            self.start()
        elif key == " ":
            self.shoot(azimuth, elevation)
        elif key in ("left", "right"):
            self.aim = (azimuth + (self.STEP if key == "left" else -self.STEP), elevation)
        elif key in ("up", "down"):
            self.aim = (azimuth, elevation + (self.STEP if key == "up" else -self.STEP))

    def click(self, axes: object, x: float, y: float) -> None:
        if axes is self.scope:
            self.shoot(x / 1000.0, y / 1000.0)

    def shoot(self, azimuth: float, elevation: float) -> None:
        """Aim there, as far as the rifle turns, and fire if nothing is in flight."""
        self.aim = (_limited(azimuth), _limited(elevation))
        if self.range.shoot(*self.aim):
            self.way = [MUZZLE]

    def play(self, time: float) -> None:
        """Shoot at one target after the other, aimed off for the drop and the wind.

        The player looks at the wind for a second first.
        """
        del time
        if self.waited < 1.0 or self.range.is_over():
            return
        target = TARGETS[(SHOTS - self.range.shots_left) % len(TARGETS)]
        slows = (K1 + K2 * MUZZLE_SPEED) / BULLET_MASS
        flight = -math.log(1.0 - slows * target.distance / MUZZLE_SPEED) / slows
        drop = -GRAVITY[1] * flight * flight / 2.0
        # The wind carries the bullet as far as it goes in the time that the drag costs.
        drift = self.range.wind.velocity.x * (flight - target.distance / MUZZLE_SPEED)
        self.shoot(
            math.atan2(target.x - drift, target.distance),
            math.atan2(target.y + drop - MUZZLE[1], target.distance),
        )


DEMOS = (Sniper,)


def _seen(place: tuple[float, float, float]) -> tuple[float, float]:
    """Return where a place is seen from the muzzle, as azimuth and elevation in mrad."""
    x, y, z = place
    along = max(z, 1.0)
    return 1000.0 * x / along, 1000.0 * (y - MUZZLE[1]) / along


def _limited(angle: float) -> float:
    return max(-SWING, min(SWING, angle))
