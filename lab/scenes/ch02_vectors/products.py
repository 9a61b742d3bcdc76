"""Interactive scenes for chapter 2 about the scalar and vector products of two vectors."""

from __future__ import annotations

import cmath
import math

from ch02_vectors.vector import Vector3
from lab.drawing.camera import flat, on_the_ground
from lab.drawing.pen import Pen
from lab.scene import Pair, Scene

STEP = math.radians(5.0)  # rotation per key press
TIP = 0.14  # m, radius of the draggable tip of a vector


class TwoVectors(Scene):
    """The base class of scenes with two vectors a and b that the reader can drag and rotate."""

    seconds = 4.0
    exact_from = "the same formula in plain numbers"
    keys = {"left": "rotate a to the left", "right": "rotate a to the right"}
    a: Vector3
    b: Vector3

    def step(self, duration: float) -> None:
        """Do nothing, because the vectors move only when the reader drags or rotates them."""

    def rotate(self, angle: float) -> None:
        """Rotate a to the left by an angle in radians."""
        rotated = complex(self.a.x, self.a.y) * cmath.rect(1.0, angle)
        self.a.x, self.a.y = rotated.real, rotated.imag

    def press(self, key: str) -> None:
        if key in self.keys:
            self.rotate(STEP if key == "left" else -STEP)

    def play(self, time: float) -> None:
        self.press("left")


class Projection(TwoVectors):
    """A scene that shows how far a extends along b, its scalar product with b's unit vector."""

    title = "Projection: how much of a points along b?"
    question = "When is the dot product positive, zero or negative?"
    view = (-4.5, 4.5, -2.5, 3.5)

    def build(self) -> None:
        self.a, self.b = Vector3(1.5, 2.5), Vector3(3.5, 0.5)

    def shadow(self) -> Vector3:
        """Project the vector a onto the vector b with the student's Vector3."""
        direction = self.b.normalized()
        return direction * self.a.dot(direction)

    def draw(self, pen: Pen) -> None:
        zero, shadow = (0.0, 0.0), self.shadow()
        pen.segments([((-4.5, 0.0), (4.5, 0.0)), ((0.0, -2.5), (0.0, 3.5))], "gray")
        pen.line([self.a, shadow], "gray", 1.5, dashed=True)
        pen.line([zero, shadow], "orange", 8.0)
        for name, v, color in (("a", self.a, "blue"), ("b", self.b, "green")):
            pen.arrow(zero, v, color)
            pen.circle(v, TIP, color, grab=name)
            pen.text((1.12 * v.x, 1.12 * v.y + 0.15), name, color, 18.0)

    def chart(self) -> dict[str, float]:
        return {
            "a · b, m²": self.a.dot(self.b),
            "projection, m": self.shadow().dot(self.b.normalized()),
        }

    def beside_exact(self) -> Pair:
        a, b = self.a, self.b
        scale = (a.x * b.x + a.y * b.y) / (b.x * b.x + b.y * b.y)
        return [*self.shadow()][:2], [scale * b.x, scale * b.y]

    def facts(self) -> str:
        angle = abs(math.degrees(math.atan2(self.a.y, self.a.x) - math.atan2(self.b.y, self.b.x)))
        return f"|a| = {self.a.magnitude():.2f} m, angle {min(angle, 360.0 - angle):.0f}°"

    def say(self) -> str:
        return f"a · b is {self.a.dot(self.b):.2f}."

    def drag(self, name: str, x: float, y: float) -> None:
        if math.hypot(x, y) > TIP:  # a vector of zero length has no direction
            moved = self.a if name == "a" else self.b
            moved.x, moved.y = x, y


class CrossProduct(TwoVectors):
    """A scene of two vectors on the ground and their vector product, which points up or down."""

    title = "Cross product: a direction and an area"
    question = "Where does a × b point, and what is its length?"
    view = (-4.5, 4.5, -4.0, 4.5)
    error_unit = "m²"

    def build(self) -> None:
        self.a, self.b = Vector3(0.5, 0.0, 1.8), Vector3(2.0, 0.0, 0.3)

    def draw(self, pen: Pen) -> None:
        zero, product = Vector3(), self.a.cross(self.b)
        grid = [(Vector3(i, 0, -3), Vector3(i, 0, 3)) for i in range(-3, 4)]
        grid += [(Vector3(-3, 0, i), Vector3(3, 0, i)) for i in range(-3, 4)]
        pen.area([flat(v) for v in (zero, self.a, self.a + self.b, self.b)], "sky")
        pen.segments([(flat(v), flat(w)) for v, w in grid], "gray", 0.5)
        for name, v, color in (("a", self.a, "blue"), ("b", self.b, "green")):
            pen.arrow(flat(zero), flat(v), color)
            pen.circle(flat(v), TIP, color, grab=name)
            x, y = flat(v * 1.15)
            pen.text((x, y - 0.25), name, color, 18.0)
        pen.arrow(flat(zero), flat(product), "red")
        x, y = flat(product)
        pen.text((x + 0.5, y), "a × b", "red", 18.0)

    def chart(self) -> dict[str, float]:
        return {"vertical component of a × b, m²": self.a.cross(self.b).y}

    def beside_exact(self) -> Pair:
        a, b = self.a, self.b
        return [*a.cross(b)], [0.0, a.z * b.x - a.x * b.z, 0.0]

    def facts(self) -> str:
        return f"area of the parallelogram: {self.a.cross(self.b).magnitude():.2f} m²"

    def say(self) -> str:
        up = self.a.cross(self.b).y
        return f"a × b points {'up' if up > 0.0 else 'down'}. Its length is {abs(up):.2f} m²."

    def rotate(self, angle: float) -> None:
        """Rotate a on the ground. From above, z points toward the viewer."""
        rotated = complex(self.a.x, self.a.z) * cmath.rect(1.0, -angle)
        self.a.x, self.a.z = rotated.real, rotated.imag

    def drag(self, name: str, x: float, y: float) -> None:
        moved = self.a if name == "a" else self.b
        moved.x, moved.z = on_the_ground(x, y)
