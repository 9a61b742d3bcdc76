"""A ball that collides with planks, tested against the segment of each plank (book 8.2.1).

This is the book's design for the bridge. The ball may be above, below or beside a plank, and the
contact normal points from the plank to the ball. Lengths are in m. Arguments of the wrong type
raise TypeError.
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

    On the whole line through a and b, the nearest point is a + (b - a) t, where t is the
    projection (point - a) . (b - a) / |b - a|^2. The segment has only the points from t = 0 to
    t = 1, so limit t to this range. If a and b are equal, the segment is a single point, and this
    point is the result. Return a new vector.

    Example:
        For the segment from (0, 0, 0) to (4, 0, 0), the point nearest to (3, 5, 0) is (3, 0, 0),
        and the point nearest to (9, 5, 0) is the end (4, 0, 0).

    Book: section 8.2.1.
    """
    finite_vector("point", point)
    along = finite_vector("b", b) - finite_vector("a", a)
    length_squared = along.squared_magnitude()
    if length_squared == 0.0:
        return a.copy()
    share = (point - a).dot(along) / length_squared
    return a + along * min(1.0, max(0.0, share))


class Planks:
    """A contact generator for a ball that may touch any of several planks from any side.

    ``radius`` is the radius of the ball. Each plank is a pair of particles, and has the shape of
    the segment between them. Unlike ``Deck``, this generator does not close the gaps between the
    planks. A ball can fall through a gap that is wider than the ball.

    Raises:
        ValueError: if the radius is not positive and finite, or the restitution is not from 0 to 1.
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

        Use ``nearest_on_segment`` to find the point of the plank that is nearest to the center of
        the ball. In each contact, ``particle`` is the ball, and ``other`` is the end of the plank
        that is nearer to this center, or the first one if both are equally near. The normal points
        from the nearest point of the plank to the center of the ball. The penetration is the radius
        minus the distance between these two points. If the distance is 0, the normal is +Y, as
        ``direction_of`` of ``ch07_constraints.contacts`` returns it. There is a contact if the
        penetration is 0 or more.

        Book: section 8.2.1.
        """
        found = []
        center = self.ball.position
        for a, b in self.planks:
            offset = center - nearest_on_segment(center, a.position, b.position)
            depth = self.radius - offset.magnitude()
            if depth >= 0.0:
                end = min(a, b, key=lambda some: (center - some.position).squared_magnitude())
                found.append(Contact(self.ball, end, direction_of(offset), self.restitution, depth))
        return found
