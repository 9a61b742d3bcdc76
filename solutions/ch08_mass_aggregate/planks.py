"""A ball that collides with planks, tested against the segment of each plank (book 8.2.1).

This is the book's design for the bridge. The ball may be above, below or beside a plank. Lengths
are in m. The constructor raises ValueError for a number that is out of range.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.arguments import finite_vector, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, a_restitution, direction_of
from ch08_mass_aggregate.bridge_plan import Row


def nearest_on_segment(point: Vector3, a: Vector3, b: Vector3) -> Vector3:
    """Find the point of the line segment from ``a`` to ``b`` that is nearest to ``point``.

    On the whole line through a and b, the nearest point is a + (b - a) t with
    t = (point - a) . (b - a) / |b - a|^2. The segment ends at t = 0 and t = 1, so limit t to this
    range. If a and b are equal, the segment is a single point, which is the result. Return a new
    vector.
    """
    finite_vector("point", point)
    along = finite_vector("b", b) - finite_vector("a", a)
    length_squared = along.squared_magnitude()
    if length_squared == 0.0:
        return a.copy()
    t = (point - a).dot(along) / length_squared
    return a + along * min(1.0, max(0.0, t))


class Planks:
    """A contact generator for a ball of a given ``radius`` that may touch planks from any side.

    Each plank is the segment between two particles. Unlike ``Deck``, this generator does not close
    the gaps between the planks, so a ball can fall through a gap that is wider than the ball.
    """

    def __init__(
        self, ball: Particle, radius: float, planks: Sequence[Row], restitution: float = 0.0
    ) -> None:
        self.ball = ball
        self.radius = positive("radius", radius)
        self.planks = planks
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self) -> list[Contact]:
        """Return one contact for each plank that the ball touches or overlaps, in their order.

        ``particle`` is the ball, and ``other`` is the end of the plank that is nearer to the ball's
        center, or the first one if both are equally near. The normal points from the nearest point
        of the plank to the center of the ball. It is +Y if these are equal, as ``direction_of`` of
        ``ch07_constraints.contacts`` returns it. The penetration is the radius minus the distance
        between them. There is a contact if it is 0 or more.
        """
        found = []
        center = self.ball.position
        for a, b in self.planks:
            offset = center - nearest_on_segment(center, a.position, b.position)
            depth = self.radius - offset.magnitude()
            if depth >= 0.0:
                end = min(a, b, key=lambda end: (center - end.position).magnitude())
                found.append(Contact(self.ball, end, direction_of(offset), self.restitution, depth))
        return found
