"""Interactive scenes for chapter 9: a free box, three ways to store an orientation, and Eq. 9.5."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import first_order_drift
from ch09_rotations.euler import euler_rates, euler_to_quaternion
from ch09_rotations.going_further.free_box import FreeBox
from ch09_rotations.matrix3 import Matrix3
from ch09_rotations.quaternion import Quaternion
from lab.drawing.camera import draw_box, flat
from lab.drawing.pen import Pen
from lab.scene import Pair, Question, Scene
from scenes.parameters import Choice, Slider
from scenes.readings import numbers

SPINS = ("smallest", "middle", "largest")


class Spin(Scene):
    """A box shaped like a thick book, which spins about an axis, and a little about another."""

    title = "A book thrown into the air"
    question = "About which of its axes does a free body keep spinning?"
    view = (-0.45, 0.45, -0.34, 0.34)
    seconds = 12.0
    exact_from = "the conservation of energy and angular momentum"
    error_unit = "J or kg m²/s"
    predict = Question(
        "The book is spun about one of its axes. Does it keep on spinning about that axis?",
        ["Yes, it only wobbles a little.", "No, it turns over again and again."],
        lambda scene: int(scene.about == "middle" and scene.disturbance > 0.0),
        "A spin about the axis with the smallest or the largest moment of inertia is stable. About "
        "the middle axis, every disturbance grows until the book has turned over.",
        9.0,
    )
    about = Choice("middle", "axis, by its moment of inertia", SPINS)
    disturbance = Slider(5.0, "spin about another axis", "%", 0.0, 20.0, step=0.5)
    SIDES = (0.2, 0.3, 0.1)  # m
    SPEED = math.tau  # rad/s, one turn per second
    ARROW = 0.24  # m

    def build(self) -> None:
        sides, mass = Vector3(*self.SIDES), 1.0  # m, kg
        moments = numbers(FreeBox(mass, sides, Vector3()).inertia)
        by_moment = sorted(range(3), key=lambda axis: moments[axis])
        self.axis = by_moment[SPINS.index(self.about)]
        spin = [0.0, 0.0, 0.0]
        spin[self.axis] = self.SPEED
        spin[self.axis - 2] = self.SPEED * 0.01 * self.disturbance
        self.box = FreeBox(mass, sides, Vector3(*spin))
        self.first = self.conserved()
        self.turned_over, self.before = 0, self.SPEED

    def step(self, duration: float) -> None:
        self.box.step(duration)
        now = numbers(self.box.own_velocity())[self.axis]
        self.turned_over += now * self.before < 0.0
        self.before = now

    def draw(self, pen: Pen) -> None:
        turn = self.box.orientation.rotate
        draw_box(pen, self.SIDES, turn)
        velocity = turn(self.box.own_velocity()) * (self.ARROW / self.SPEED)
        pen.arrow((0.0, 0.0), flat(velocity), "pink", "velocity")
        momentum = self.box.angular_momentum.normalized() * self.ARROW
        pen.arrow((0.0, 0.0), flat(momentum), "black")
        pen.text((-0.2, -0.28), "angular momentum: constant", "black", 12.0)
        pen.text((-0.2, -0.31), "angular velocity: changes", "pink", 12.0)

    def chart(self) -> dict[str, float]:
        velocity = numbers(self.box.own_velocity())
        return {f"spin about {name}, rad/s": v for name, v in zip("XYZ", velocity, strict=True)}

    def conserved(self) -> list[float]:
        """Return the energy in J and the angular momentum in kg m^2/s."""
        own = self.box.own_velocity().component_product(self.box.inertia)
        return [self.box.energy(), *numbers(self.box.orientation.rotate(own))]

    def beside_exact(self) -> Pair:
        return self.conserved(), self.first

    def facts(self) -> str:
        return f"X blue, Y orange, Z green; spun about {'XYZ'[self.axis]} at one turn per second"

    def say(self) -> str:
        times = "once" if self.turned_over == 1 else f"{self.turned_over} times"
        return f"The book has turned over {times}."


SIDES = (1.3, 0.8, 0.3)  # m
X, Y, Z = Vector3(1.0), Vector3(0.0, 1.0), Vector3(0.0, 0.0, 1.0)
PLACES = {"matrix": -2.4, "quaternion": 0.0, "Euler angles": 2.4}


class Orientations(Scene):
    """Three boxes that rotate alike, but store their orientations in three ways."""

    title = "Matrix, quaternion, Euler angles"
    question = "Which way to store an orientation stays accurate over many steps?"
    view = (-3.8, 3.8, -1.6, 1.9)
    seconds = 8.0
    exact_from = "a single rotation about the fixed axis"
    error_unit = "axis lengths"
    predict = Question(
        "Three boxes have the same angular velocity. Which box is wrong after four seconds?",
        ["The matrix.", "The quaternion.", "The Euler angles.", "None of them."],
        lambda scene: scene.worst(),
        "When the second angle comes near a quarter turn, the rates of the other two become huge "
        "and a step overshoots. Adding small changes to a matrix stretches it. The quaternion is "
        "multiplied by the exact rotation of each step.",
        4.0,
    )
    rate = Choice(60, "steps per second", [30, 60, 120, 240], "Hz")
    speed = Slider(120.0, "angular speed", "degrees/s", 10.0, 360.0, step=10.0)
    tilt = Slider(2.0, "tilt of the axis from Y toward X", "degrees", 1.0, 90.0, step=1.0)
    repair = Choice("yes", "normalize the matrix", ["yes", "no"])

    def build(self) -> None:
        tilt = math.radians(self.tilt)
        self.velocity = Vector3(math.sin(tilt), math.cos(tilt)) * math.radians(self.speed)
        self.quaternion = Quaternion()
        self.columns = [X.copy(), Y.copy(), Z.copy()]
        self.angles = Vector3()
        self.locked = False

    def step(self, duration: float) -> None:
        self.quaternion.rotate_by(self.velocity * duration)
        for column in self.columns:  # an axis of the box, whose tip moves with w x column
            column.add_scaled(self.velocity.cross(column), duration)
        if self.repair == "yes":
            x, y, _ = self.columns
            x.normalize()
            y.add_scaled(x, -x.dot(y))
            y.normalize()
            self.columns[2] = x.cross(y)
        a = self.angles
        try:
            a.add_scaled(euler_rates(a.x, a.y, a.z, self.velocity), duration)
        except ValueError:  # in gimbal lock, the rates are undefined
            self.locked = True

    def turns(self) -> list[list[Vector3]]:
        """Compute the directions of the three axes of each box, in the order of PLACES."""
        x, y, z = self.columns
        matrix = Matrix3(x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z)
        q = self.quaternion.copy()
        q.normalize()
        angles = euler_to_quaternion(self.angles.x, self.angles.y, self.angles.z)
        ways = (matrix.transform, q.rotate, angles.rotate)
        return [[turn(axis) for axis in (X, Y, Z)] for turn in ways]

    def errors(self) -> list[float]:
        """Compute how far an axis of each box is off at most, in % of the axis's length."""
        speed = self.velocity.magnitude()
        right = Quaternion.from_axis_angle(self.velocity, speed * self.simulated)
        exact = [right.rotate(axis) for axis in (X, Y, Z)]
        return [
            100.0 * max((b - a).magnitude() for a, b in zip(exact, found, strict=True))
            for found in self.turns()
        ]

    def worst(self) -> int:
        """Return the index of the box with the largest error, or 3 if none exceeds 10 %."""
        errors = self.errors()
        return errors.index(max(errors)) if max(errors) > 10.0 else 3

    def draw(self, pen: Pen) -> None:
        for (name, x), axes, error in zip(PLACES.items(), self.turns(), self.errors(), strict=True):

            def turn(v: Vector3, axes: list[Vector3] = axes) -> Vector3:
                return axes[0] * v.x + axes[1] * v.y + axes[2] * v.z

            draw_box(pen, SIDES, turn, (x, 0.0))
            axis = flat(self.velocity.normalized())
            pen.arrow((x, 0.0), axis, "pink", "velocity")
            pen.text((x, 1.6), name, "black", 15.0)
            words = f"{error:.2g} % off" if error < 10.0 else f"{error:.0f} % off"
            pen.text((x, -1.35), words, "red" if error > 10.0 else "gray", 13.0)

    def chart(self) -> dict[str, float]:
        return {f"{name}, % off": e for name, e in zip(PLACES, self.errors(), strict=True)}

    def beside_exact(self) -> Pair:
        """Return the error of the box with the quaternion, as a fraction of an axis, and 0."""
        return [0.01 * self.errors()[1]], [0.0]

    def facts(self) -> str:
        near = 90.0 - abs(math.remainder(math.degrees(self.angles.y), 180.0))
        return f"the second Euler angle is {near:.0f}° from gimbal lock"

    def say(self) -> str:
        matrix, quaternion, angles = self.errors()
        lock = " The Euler angles are locked." if self.locked else ""
        others = f"the quaternion {quaternion:.0f} % and the Euler angles {angles:.0f} %"
        return f"The matrix is {matrix:.0f} % off, {others}.{lock}"


class FirstOrder(Scene):
    """A clock hand that falls behind, because a step with Eq. 9.5 moves q along a straight line."""

    title = "What Eq. 9.5 leaves out"
    question = "Does normalizing remove the whole error of a step?"
    view = (-2.4, 2.4, -1.7, 1.7)
    seconds = 8.0
    exact_from = "the angle of a steady rotation"
    error_unit = "rad"
    predict = Question(
        "The hand turns once per second. Its quaternion is normalized after each step. Does the "
        "hand keep up?",
        ["Yes, normalizing is enough.", "No, it falls behind."],
        lambda _: 1,
        "A step along the tangent makes the quaternion longer and rotates it by too small an "
        "angle. Normalizing removes the first error but not the second.",
        8.0,
    )
    rate = Choice(15, "steps per second", [10, 15, 30, 60, 120], "Hz")
    speed = Slider(360.0, "angular speed", "degrees/s", 30.0, 720.0, step=30.0)
    normalize = Choice("yes", "normalize after each step", ["yes", "no"], live=True)

    def build(self) -> None:
        self.q = Quaternion()
        self.spin = Vector3(0.0, 0.0, math.radians(self.speed))
        self.angle = 0.0

    def step(self, duration: float) -> None:
        before = self.half_angle()
        self.q.add_scaled(self.spin, duration)
        self.angle += 2.0 * math.remainder(self.half_angle() - before, math.tau)
        if self.normalize == "yes":
            self.q.normalize()

    def half_angle(self) -> float:
        """Compute half the angle by which the hand's quaternion rotates about Z, in radians."""
        return math.atan2(self.q.k, self.q.r)

    def behind(self) -> float:
        """Compute by how many degrees the hand is behind the steady rotation."""
        return math.degrees(self.spin.z * self.simulated - self.angle)

    def draw(self, pen: Pen) -> None:
        pen.circle((0.0, 0.0), 1.0, "gray", fill=False)
        right = self.spin.z * self.simulated
        pen.arrow((0.0, 0.0), (math.cos(right), math.sin(right)), "gray")
        length = self.q.magnitude() ** 2  # the factor by which q scales a vector
        hand = (length * math.cos(self.angle), length * math.sin(self.angle))
        pen.arrow((0.0, 0.0), hand, "blue")
        pen.text((-1.75, 1.4), "steady rotation", "gray", 13.0)
        pen.text((-1.75, 1.15), "Eq. 9.5", "blue", 13.0)

    def chart(self) -> dict[str, float]:
        return {"behind, degrees": self.behind(), "length of q": self.q.magnitude()}

    def beside_exact(self) -> Pair:
        """Return the angle in rad through which the hand has turned, and the right one."""
        return [self.angle], [self.spin.z * self.simulated]

    def facts(self) -> str:
        length, angle = first_order_drift(self.spin.z, 1.0, self.rate)
        behind = f"{math.degrees(angle):.3g}° behind"
        return f"in theory {behind} and {length:.3g} times as long after 1 s"

    def say(self) -> str:
        length = self.q.magnitude()
        return f"The hand is {self.behind():.1f}° behind. The length of q is {length:.3g}."
