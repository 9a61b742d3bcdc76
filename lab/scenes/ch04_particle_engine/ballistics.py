"""Interactive scenes for chapter 4: a shooting range, and a prediction of where a shell lands."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.ballistics import MUZZLE, SHOT_TYPES, BallisticRange, Shot
from ch04_particle_engine.closed_form import state_after
from ch04_particle_engine.targets import TargetBlock, strike_first
from lab.drawing.pen import Pen
from lab.scene import Pair, Question, Scene
from scenes.flight import thrown
from scenes.parameters import Choice, Slider
from scenes.readings import Numbers, is_written
from scenes.shots_and_sparks import shot_names

COLORS = {
    **{"pistol": "black", "artillery": "green", "fireball": "orange", "laser": "red"},
    **{"grenade": "blue", "fragment": "blue"},
}
MIDDLE = -20.0  # y at which the view from above is drawn, below the view from the side


class Artillery(Scene):
    """A scene that predicts where a shell will land before it is fired."""

    title = "Where will the shell land?"
    question = "Can you know where a shell lands without simulating its flight?"
    view = (-5.0, 175.0, -4.0, 90.0)
    seconds = 8.0
    exact_from = "the closed form, state_after"
    predict = Question(
        "With these settings, which elevation carries the shell the farthest?",
        ["30°.", "45°.", "60°."],
        lambda scene: max(range(3), key=lambda i: scene.landing(30.0 + 15.0 * i)[0]),
        "Without drag it is 45°. Drag slows the shell down throughout its flight, so a flatter "
        "shot flies farther: it covers more of the distance while it is still fast.",
        8.0,
    )
    keys = {"f": "fire again"}
    elevation = Slider(45.0, "elevation", "degrees", 5.0, 85.0, step=1.0)
    speed = Slider(40.0, "speed", "m/s", 10.0, 40.0, step=1.0)
    damping = Slider(0.8, "damping d", "", 0.3, 1.0, step=0.05)
    rate = Choice(60, "steps per second", [10, 30, 60, 240], "Hz")

    def build(self) -> None:
        self.shell, self.flies = self.shot(self.elevation), True
        self.path = [(0.0, 0.0)]
        self.fired = self.clock.simulated = self.time
        self.end = math.inf  # s, when the shell lands
        self.length, self.flight = self.landing(self.elevation)
        times = [self.flight * i / 60.0 for i in range(61)]
        self.predicted = [self.place_after(time, self.elevation) for time in times]

    def shot(self, elevation: float) -> Particle:
        """Create a shell fired from the ground at ``elevation``, in degrees."""
        return thrown((0.0, 0.0), self.speed, elevation, self.damping).particle(Particle)

    def place_after(self, time: float, elevation: float) -> tuple[float, float]:
        """Compute the exact position of a shell ``time`` s after it was fired."""
        position, _ = state_after(self.shot(elevation), time)
        return position.x, position.y

    def landing(self, elevation: float) -> tuple[float, float]:
        """Compute how far a shell flies, in m, and for how long, in s, by bisection."""
        low, high = 0.01, 20.0  # s; the shell is above the ground at low and below it at high
        while high - low > 1e-9:
            middle = 0.5 * (low + high)
            above = self.place_after(middle, elevation)[1] > 0.0
            low, high = (middle, high) if above else (low, middle)
        return self.place_after(low, elevation)[0], low

    def step(self, duration: float) -> None:
        if not self.flies:
            return
        self.shell.integrate(duration)
        self.path.append((self.shell.position.x, self.shell.position.y))
        if self.simulated - self.fired >= self.flight:
            self.flies, self.end = False, self.simulated

    def draw(self, pen: Pen) -> None:
        pen.ground()
        pen.line(self.predicted, "gray", 1.5, dashed=True)
        pen.segments([((self.length, -2.0), (self.length, 2.0))], "red", 4.0)
        pen.text((self.length, 5.0), f"{self.length:.1f} m", "red")
        pen.line(self.path, "blue")
        pen.circle(self.shell.position, 1.5, "green")
        pen.arrow(self.shell.position, self.shell.velocity * 0.3, "green", "velocity")

    def chart(self) -> dict[str, float]:
        return {"height, m": self.shell.position.y, "speed, m/s": self.shell.velocity.magnitude()}

    def beside_exact(self) -> Pair:
        flown = min(self.simulated, self.end) - self.fired
        return [*self.shell.position][:2], self.place_after(flown, self.elevation)

    def facts(self) -> str:
        return f"lands {self.length:.2f} m away after {self.flight:.2f} s, as calculated in advance"

    def say(self) -> str:
        p = self.shell.position
        return f"The shell is {p.x:.1f} m away and {p.y:.1f} m high."

    def press(self, key: str) -> None:
        if key == "f":
            self.build()


class Ballistics(Scene):
    """A shooting range, shown from the side in the upper half and from above in the lower."""

    title = "The ballistic range"
    question = "Why can the same code fire a bullet, a fireball and a laser beam?"
    view = (-4.0, 132.0, -36.0, 36.0)
    seconds = 14.0
    keys = {
        **{str(i): f"choose shot type {i}" for i in range(1, 6)},
        "up": "raise the muzzle",
        "down": "lower the muzzle",
        "left": "turn the muzzle to the left",
        "right": "turn the muzzle to the right",
        "f": "fire",
    }
    TURN = math.radians(2.0)
    # The scripted shots: time in s, type, azimuth and elevation in degrees.
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

    def build(self) -> None:
        self.range = BallisticRange()
        if is_written(lambda: strike_first(Vector3(), Particle(), [])):
            self.range.targets += [
                TargetBlock(Vector3(0, 1, 25), (2, 2, 0.3), mass=5),
                TargetBlock(Vector3(-4, 1.5, 45), (3, 3, 1), mass=60),
                TargetBlock(Vector3(4, 1.5, 65), (3, 3, 1), mass=1000),
                TargetBlock(Vector3(0, 4, 120), (16, 8, 0.5), mass=math.inf),
            ]
        self.names = shot_names()
        self.name = "pistol"
        self.azimuth = 0.0
        self.elevation: float | None = None
        self.trails: dict[int, tuple[Shot, list[Numbers]]] = {}
        self.orders = [order for order in self.ORDERS if order[1] in self.names]

    def step(self, duration: float) -> None:
        self.range.update(duration)
        for shot in self.range.shots:
            _, trail = self.trails.setdefault(id(shot), (shot, []))
            p = shot.particle.position
            trail.append((p.x, p.y, p.z))
        for key in [*self.trails][:-24]:  # keep the trails of the last 24 shots
            del self.trails[key]

    def draw(self, pen: Pen) -> None:
        pen.ground()
        pen.text((10.0, 33.0), "from the side", "gray")
        pen.text((10.0, MIDDLE + 14.0), "from above", "gray")
        pen.segments([((-4.0, MIDDLE), (132.0, MIDDLE))], "gray", 0.5)
        for block in self.range.targets:
            color = "wood" if block.particle.has_finite_mass else "gray"
            p, (width, height, depth) = block.particle.position, block.size
            for middle, tall in ((p.y, height), (MIDDLE + p.x, width)):
                left, low = p.z - 0.5 * depth, middle - 0.5 * tall
                right, high = left + depth, low + tall
                pen.area([(left, low), (right, low), (right, high), (left, high)], color)
        for shot, trail in self.trails.values():
            color = COLORS.get(shot.type, "pink")
            pen.dots([(z, y) for _, y, z in trail], color, 2.0)
            pen.dots([(z, MIDDLE + x) for x, _, z in trail], color, 2.0)
        for y, angle in ((MUZZLE[1], self.muzzle()), (MIDDLE, self.azimuth)):
            tip = (10.0 * math.cos(angle), 10.0 * math.sin(angle))
            pen.arrow((0.0, y), tip, COLORS.get(self.name, "pink"))

    def muzzle(self) -> float:
        """Return the elevation of the gun in rad. Until the reader aims, the shot decides it."""
        vx, vy, vz = SHOT_TYPES[self.name].velocity
        own = math.atan2(vy, math.hypot(vx, vz))
        return own if self.elevation is None else self.elevation

    def fire(self) -> None:
        self.range.fire(self.name, self.azimuth, self.elevation)

    def chart(self) -> dict[str, float]:
        return {"shots in flight": float(len(self.range.shots))}

    def facts(self) -> str:
        kind = SHOT_TYPES[self.name]
        return f"{self.name}: {kind.mass:g} kg, damping {kind.damping:g}"

    def say(self) -> str:
        told = []
        for block in self.range.targets:
            p = block.particle
            name = f"{p.mass:g} kg" if p.has_finite_mass else "the wall"
            told.append(f"{name}: {block.hits} hits, {p.velocity.z:.1f} m/s")
        return "; ".join([*told, f"{len(self.range.shots)} shots in flight."])

    def press(self, key: str) -> None:
        if key in "12345"[: len(self.names)]:
            self.name = self.names[int(key) - 1]
        elif key in ("left", "right"):
            self.azimuth += self.TURN if key == "left" else -self.TURN
        elif key in ("up", "down"):
            self.elevation = self.muzzle() + (self.TURN if key == "up" else -self.TURN)
        elif key == "f":
            self.fire()

    def click(self, x: float, y: float) -> None:
        """Aim at a point of the side view or of the view from above, and fire."""
        if x <= MUZZLE[2]:
            return
        if y > 0.5 * MIDDLE:
            self.elevation = math.atan2(y - MUZZLE[1], x)
        else:
            self.azimuth = math.atan2(y - MIDDLE, x)
        self.fire()

    def play(self, time: float) -> None:
        while self.orders and self.orders[0][0] <= time:
            _, self.name, azimuth, elevation = self.orders.pop(0)
            self.azimuth = math.radians(azimuth)
            self.elevation = None if elevation is None else math.radians(elevation)
            self.fire()
