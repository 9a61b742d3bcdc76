"""The book's way to let a ball touch planks: each plank is a segment between two particles."""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.arguments import finite_vector, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, direction_of
from ch08_mass_aggregate.bridge_plan import Row


def nearest_on_segment(point: Vector3, a: Vector3, b: Vector3) -> Vector3:
    p, start, end = (finite_vector(name, v) for name, v in (("point", point), ("a", a), ("b", b)))
    way = end - start
    length = way.magnitude()
    if not length:
        return start
    unit = way * (1.0 / length)
    done = (p - start) @ unit
    if done <= 0.0:
        return start
    if done >= length:
        return end
    start.add_scaled(unit, done)
    return start


class Planks:
    """Generates the contacts of a ball with planks, whose shape is the segment of their ends."""

    def __init__(
        self, ball: Particle, radius: float, planks: Sequence[Row], restitution: float = 0.0
    ) -> None:
        self.ball = ball
        self.radius = positive("radius", radius)
        self.planks = planks
        self.restitution = restitution

    def contacts(self) -> list[Contact]:
        found: list[Contact] = []
        for front, back in self.planks:
            touched = nearest_on_segment(self.ball.position, front.position, back.position)
            away = self.ball.position - touched
            gap = away.magnitude() - self.radius
            if gap > 0.0:
                continue
            to_front = (self.ball.position - front.position).magnitude()
            to_back = (self.ball.position - back.position).magnitude()
            end = back if to_back < to_front else front
            found.append(Contact(self.ball, end, direction_of(away), self.restitution, -gap))
        return found
