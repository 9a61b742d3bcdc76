"""The demo of chapter 9: a box that spins freely about one of its axes, or flips over."""

from __future__ import annotations

import math

from matplotlib.artist import Artist
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from ch02_vectors.vector import Vector3
from ch09_rotations.free_box import FreeBox
from studies.drawing import BLACK, BLUE, GREEN, GREY, PINK, RED, axes_3d
from studies.readings import Numbers, numbers

COLORS = (BLUE, RED, GREEN)  # of X, Y and Z
MOMENTS = ("smallest", "middle", "largest")


class Spin:
    """A box that spins about one of its axes, and a little about the next."""

    seconds = 16.0
    keys = (
        "1, 2 and 3 spin it about the axis of the smallest, middle and largest moment of inertia, "
        "the up and down arrow keys change the disturbance, the space bar pauses and resumes, "
        "r starts again."
    )
    MASS = 1.0  # kg
    SIDES = (0.2, 0.3, 0.1)  # m, as a thick book has them
    SPEED = math.tau  # rad/s, a turn a second
    DISTURBANCES = (0.0, 0.001, 0.01, 0.05, 0.2)  # fractions of the speed
    SHOWN = 9.0  # s
    ARROW = 0.24  # m

    def __init__(self, figure: Figure) -> None:
        left, right = figure.add_gridspec(1, 2)
        self.space = axes_3d(figure, left, 0.16)
        self.space.set_axis_off()
        self.space.computed_zorder = False  # the arrows can be seen through the box
        pale = [tuple(1.0 - 0.3 * (1.0 - part) for part in to_rgb(color)) for color in COLORS]
        colors = [color for pair in zip(pale, COLORS, strict=True) for color in pair]
        self.own_faces = _faces(self.SIDES)
        self.faces = Poly3DCollection([[(0.0, 0.0, 0.0)] * 4] * 6, facecolors=colors)
        self.faces.set(edgecolor=BLACK, zorder=1)
        self.space.add_collection3d(self.faces)
        self.arrows: list[Artist] = []
        for height, words, color in (
            (0.08, "angular momentum: constant", BLACK),
            (0.03, "angular velocity: changes", PINK),
            (-0.02, "pale: sides on the negative axes", GREY),
        ):
            where = self.space.transAxes
            self.space.text2D(0.0, height, words, color=color, fontsize=9, transform=where)
        self.graph = figure.add_subplot(right)
        self.graph.set(ylim=(-1.7 * self.SPEED, 1.2 * self.SPEED), xlabel="time, s")
        self.graph.set_title("angular velocity about its own axes, rad/s", fontsize=10)
        self.graph.locator_params(nbins=5)  # drawing numbers takes most of the time of a picture
        self.graph.axhline(0.0, color=BLACK, lw=0.8)
        self.curves = [self.graph.plot([], [], color=color)[0] for color in COLORS]
        box = FreeBox(self.MASS, Vector3(*self.SIDES), Vector3())
        moments = numbers(box.inertia)
        self.axes = sorted(range(3), key=lambda axis: moments[axis])  # by their moments
        names = [f"{'XYZ'[axis]}, {MOMENTS[self.axes.index(axis)]} moment" for axis in range(3)]
        self.graph.legend(self.curves, names, fontsize=8, loc="lower left")
        self.title = figure.suptitle("", fontsize=10)
        self.chosen, self.disturbed = 1, 3
        self.start()

    def start(self) -> None:
        """Spin the box again, from the reference orientation."""
        self.axis = self.axes[self.chosen]
        spin = [0.0, 0.0, 0.0]
        spin[self.axis] = self.SPEED
        spin[self.axis - 2] = self.SPEED * self.DISTURBANCES[self.disturbed]
        self.box = FreeBox(self.MASS, Vector3(*self.SIDES), Vector3(*spin))
        self.first = (self.box.energy(), self.momentum())
        self.runs = True
        self.time, self.turned_over = 0.0, 0
        self.times, self.velocities = [0.0], [numbers(self.box.own_velocity())]

    def momentum(self) -> Numbers:
        """Return the angular momentum from the visible rotation of the box, in kg m^2/s."""
        own = self.box.own_velocity().component_product(self.box.inertia)
        return numbers(self.box.orientation.rotate(own))

    def update(self, duration: float) -> None:
        if not self.runs:
            return
        self.box.step(duration)
        self.time += duration
        self.times.append(self.time)
        self.velocities.append(numbers(self.box.own_velocity()))
        before, now = (velocity[self.axis] for velocity in self.velocities[-2:])
        self.turned_over += before * now < 0.0
        if self.time > self.SHOWN:
            del self.times[0], self.velocities[0]

    def draw(self) -> None:
        turn = self.box.orientation.rotate
        self.faces.set_verts([[_seen(turn(corner)) for corner in face] for face in self.own_faces])
        for old in self.arrows:
            old.remove()
        velocity = turn(self.box.own_velocity()) * (self.ARROW / self.SPEED)
        momentum = self.box.angular_momentum.normalized() * self.ARROW
        self.arrows = [
            self.space.quiver(0, 0, 0, *_seen(tip), color=color, lw=2.5, zorder=2)
            for tip, color in ((momentum, BLACK), (velocity, PINK))
        ]
        for curve, components in zip(self.curves, zip(*self.velocities, strict=True), strict=True):
            curve.set_data(self.times, components)
        self.graph.set_xlim(self.times[0], self.times[0] + self.SHOWN)
        energy, momentum_then = self.first
        drift = math.dist(self.momentum(), momentum_then) / math.hypot(*momentum_then)
        times = "once" if self.turned_over == 1 else f"{self.turned_over} times"
        self.title.set_text(
            f"spun about {'XYZ'[self.axis]}, the axis of its {MOMENTS[self.chosen]} moment, and "
            f"{100.0 * self.DISTURBANCES[self.disturbed]:g}% about the next; "
            f"turned over {times} in {self.time:.1f} s\n"
            f"change since the start: kinetic energy {self.box.energy() / energy - 1.0:+.3%}, "
            f"angular momentum {drift:.3%}"
        )

    def press(self, key: str) -> None:
        if key in ("1", "2", "3"):
            self.chosen = int(key) - 1
            self.start()
        elif key in ("up", "down"):
            change = 1 if key == "up" else -1
            self.disturbed = max(0, min(len(self.DISTURBANCES) - 1, self.disturbed + change))
            self.start()
        elif key == " ":
            self.runs = not self.runs
        elif key == "r":
            self.start()

    def click(self, axes: object, x: float, y: float) -> None:
        """Ignore clicks."""

    def play(self, time: float) -> None:
        """Watch the box flip over, then disturb it more and spin it about the other two axes."""
        frame = round(60.0 * time)
        if frame == 540:
            self.press("up")
            self.press("1")
        elif frame == 750:
            self.press("3")


DEMOS = (Spin,)


def _faces(sides: Numbers) -> list[list[Vector3]]:
    """Return the corners of the six faces in the box's own axes: -X, X, -Y, Y, -Z, Z."""
    around = ((-1, -1), (-1, 1), (1, 1), (1, -1))
    faces = []
    for axis in range(3):
        for sign in (-1, 1):
            corners = [[sign, *pair] for pair in around]  # of the axis and the two after it
            face = [[0.5 * sides[i] * corner[i - axis] for i in range(3)] for corner in corners]
            faces.append([Vector3(*corner) for corner in face])
    return faces


def _seen(v: Vector3) -> Numbers:
    """Return a vector as it is drawn: matplotlib's third axis points up, the engine's second."""
    x, y, z = numbers(v)
    return z, x, y
