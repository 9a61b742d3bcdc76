"""Going further, G8.2: the nearest point of a segment, and a ball that touches planks."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch08_mass_aggregate.planks import Planks, nearest_on_segment
from ch08_mass_aggregate.scene_probes import told
from draw import Triple, positive_number, unit_vector, vector
from expect import expect_close, expect_exactly, expect_unchanged, expect_vector, named
from unmoved import expect_kept

NEAREST = "the docstring of nearest_on_segment"
PLANKS = "book 8.2.1, and the docstring of Planks.contacts"
UP = Triple((0.0, 1.0, 0.0))
# Coordinates are below 40 m, and are rounded in about ten operations.
NEAR = 1e-12


def at_right_angle(rng: Random, way: Triple) -> Triple:
    """Draw a unit vector at a right angle to a unit vector."""
    while True:
        drawn = unit_vector(rng)
        across = drawn - way * (drawn @ way)
        if abs(across) > 0.3:
            return across / abs(across)


def nearest(point: Triple, a: Triple, b: Triple, cause: str) -> Any:
    """Return the point of a segment that is nearest to a point, and the three vectors."""
    with calls(cause):
        p, q, r = Vector3(*point), Vector3(*a), Vector3(*b)
        got = nearest_on_segment(point=p, a=q, b=r)
    return expect_vector(got), p, q, r


@pytest.mark.exercise("G8.2", asks="Find the point of the line segment", read=NEAREST)
def test_the_nearest_point_between_the_ends(rng: Random) -> None:
    for share in (0.15, 0.4, 0.75):
        a, way = vector(rng), unit_vector(rng)
        length, distance = positive_number(rng, 2.0, 8.0), positive_number(rng, 0.5, 4.0)
        along = way * (share * length)
        b, wanted = a + way * length, a + along
        project = "Project point - a onto b - a, and start from a: a + (b - a) t."
        point = wanted + at_right_angle(rng, way) * distance
        got, *vectors = nearest(point, a, b, project)
        for name, v, old in zip(("point", "a", "b"), vectors, (point, a, b), strict=True):
            expect_kept(name, v, old)
        slips = {
            "You return the vector from a to the nearest point. Add a.": along,
            "You measure the projection from b instead of a.": b - along,
            "You add the projection to b. It starts at a.": b + along,
            "You return b although the nearest point is between the ends. Either you don't divide "
            "by the squared length of b - a, or you swapped min and max.": b,
            "You return the nearer end. The nearest point may also be between the ends.":
                a if share < 0.5 else b,
            "You divide by the length of b - a. Divide by its square to get t.":
                a + way * (min(1.0, share * length) * length),
        }  # fmt: skip
        expect_close(got, wanted, slips, unit="m", tolerance=NEAR)


@pytest.mark.exercise("G8.2", asks="so limit t to this range", read=NEAREST)
def test_the_nearest_point_beyond_an_end_is_the_end(rng: Random) -> None:
    for share in (-0.3, -2.0, 1.2, 3.0):
        a, way, length = vector(rng), unit_vector(rng), positive_number(rng, 1.0, 5.0)
        b, there = a + way * length, a + way * (share * length)
        point = there + at_right_angle(rng, way) * positive_number(rng, 0.5, 3.0)
        end = "Beyond an end, that end is the nearest point. Limit t to the range from 0 to 1."
        got, *_ = nearest(point, a, b, end)
        wanted, other, name = (a, b, "a") if share < 0.0 else (b, a, "b")
        slips = {
            f"You return the nearest point of the infinite line. The segment ends at {name}, so "
            "limit t to the range from 0 to 1.": there,
            "You return the wrong end of the segment.": other,
        }
        expect_close(got, wanted, slips, unit="m", tolerance=NEAR)


@pytest.mark.exercise("G8.2", asks="the segment is a single point", read=NEAREST)
def test_a_segment_may_be_a_single_point(rng: Random) -> None:
    a, point = vector(rng), vector(rng)
    single = "If a and b are equal, don't divide by |b - a|^2, but return a copy of a."
    expect_close(nearest(point, a, a, single)[0], a, unit="m", tolerance=0.0)


@pytest.mark.exercise("G8.2", asks="Return a new vector", read=NEAREST)
def test_the_nearest_point_is_a_new_vector(rng: Random) -> None:
    a, way, point = vector(rng), unit_vector(rng), vector(rng)
    b = a + way * positive_number(rng, 1.0, 5.0)
    for place, one, two in ((a - way, a, b), (b + way, a, b), (point, a, a), (point, a, b)):
        with calls("You return one of the arguments itself. Return a new vector."):
            p, q, r = Vector3(*place), Vector3(*one), Vector3(*two)
            got = nearest_on_segment(point=p, a=q, b=r)
            got.x += 1.0
        for name, v, old in (("point", p, place), ("a", q, one), ("b", r, two)):
            expect_unchanged(name, v, old)


def touched(
    ball: Triple, radius: float, planks: Sequence[tuple[Triple, Triple]], c: float, cause: str
) -> Any:
    """Return particle, other, normal, restitution and penetration of each contact."""
    text = f"particle 0 is a ball of radius {radius} m at {ball}; particles 1, 2, ... are the two "
    text += f"ends of each plank: {', '.join(map(str, planks))}; Planks(...).contacts()"
    with calls(cause, text):
        center = Particle(Vector3(*ball))
        rows = [(Particle(Vector3(*a)), Particle(Vector3(*b))) for a, b in planks]
        found = Planks(center, radius, rows, c).contacts()
        return told(found, [center, *(end for row in rows for end in row)])


@pytest.mark.exercise("G8.2", asks="from the nearest point of the plank to the center", read=PLANKS)
def test_a_ball_touches_a_plank_from_any_side(rng: Random) -> None:
    for share, over, nearer in ((0.2, 0.0, 1), (0.8, 0.0, 2), (0.0, -0.6, 1), (1.0, 0.6, 2)):
        a, way = vector(rng), unit_vector(rng)
        length, radius = positive_number(rng, 2.0, 3.0), positive_number(rng, 0.6, 1.0)
        c, distance = positive_number(rng, 0.1, 0.9), radius - positive_number(rng, 0.05, 0.2)
        b, across = a + way * length, at_right_angle(rng, way)
        # The ball is beyond an end by the fraction over.
        normal = way * over + across * math.sqrt(1.0 - over**2)
        ball = a + way * (share * length) + normal * distance
        why = "The arguments of Contact are the ball, the nearer end, direction_of(offset), "
        why += "self.restitution and the penetration, in this order. The normal must be a unit "
        why += "vector. Put each contact into the list that you return."
        got = touched(ball, radius, [(a, b)], c, why)
        ends = [(one, two) for one, two, *_ in got]
        why = {
            ((0, 1), (0, 2)): "You return a contact for each end. Return one, with the nearer end.",
            ((0, 3 - nearer),): "You return a contact with the end that is farther from the ball.",
            ((nearer, 0),): "You swapped particle and other. The particle is the ball.",
        }.get(
            tuple(ends),
            "The ball overlaps the plank, so return one contact. Its particle is the ball, and its "
            "other is the end of the plank that is nearer to the ball.",
        )
        expect_exactly(ends, [(0, nearer)], then="; (particle, other) of each contact", cause=why)
        _, _, seen, restitution, penetration = next(iter(got))
        from_end = ball - (a if nearer == 1 else b)
        from_plank = "The normal points from the nearest point of the plank to the ball's center."
        why = named(seen, from_plank, {
            "Your normal is always +Y, as in Deck.": UP,
            "Your normal points from the ball to the plank. Reverse it.": -normal,
            "You use the line through both ends, which goes on beyond them.": across,
            "Your normal starts at the end of the plank.": from_end / abs(from_end),
        })  # fmt: skip
        # The normal is a difference of coordinates, divided by a distance of at least 0.4 m.
        expect_close(seen, normal, then="; the normal", cause=why, tolerance=1e-11)
        why = "The penetration is the radius minus the distance to the nearest point."
        why = named(penetration, why, {
            "You return the distance itself. Subtract it from the radius.": distance,
            "You swapped the radius and the distance.": distance - radius,
            "You swapped the restitution and the penetration. The restitution comes first.": c,
        })  # fmt: skip
        name, wanted = "; the penetration", radius - distance
        expect_close(penetration, wanted, then=name, cause=why, unit="m", tolerance=NEAR)
        why = "Pass self.restitution to each Contact."
        expect_close(restitution, c, then="; the restitution", cause=why, tolerance=1e-12)


@pytest.mark.exercise("G8.2", asks="Return one contact for each plank", read=PLANKS)
def test_which_planks_a_ball_touches(rng: Random) -> None:
    x = float(rng.randint(2, 9))
    planks = [(Triple((x + 2.0 * i, 4.0, -1.0)), Triple((x + 2.0 * i, 4.0, 1.0))) for i in range(3)]
    for right, y, z, radius, wanted, cause in (
        (0.0, 4.5, 0.5, 0.5, [(0, 2)], "A ball that just touches a plank has a contact."),
        (0.0, 4.500001, 0.5, 0.5, [], "The ball is just above the plank, so there is no contact."),
        (0.0, 4.0, 1.625, 0.5, [], "The ball is beyond the end of the plank. Only the infinite "
         "line goes through the ball, but the segment doesn't."),
        (1.0, 4.5, 0.5, 1.5, [(0, 2), (0, 4)], "The ball is between two planks and touches both. "
         "Return a contact for each, in the order of the planks."),
        (1.0, 4.0, 0.5, 0.5, [], "The ball is in the gap between two planks."),
        (0.0, 3.75, 0.0, 0.5, [(0, 1)], "If both ends are equally near, return the first one."),
    ):  # fmt: skip
        found = touched(Triple((x + right, y, z)), radius, planks, 0.0, cause)
        name = "; (particle, other) of each contact"
        expect_exactly([(a, b) for a, b, *_ in found], wanted, then=name)
    no_offset = "The offset is zero and has no direction. Use direction_of, which returns +Y."
    found = touched(Triple((x, 4.0, 0.5)), 0.5, planks, 0.0, no_offset)
    expect_exactly(len(found), 1, then="; the number of contacts", unit="contacts")
    _, _, normal, _, depth = next(iter(found))
    expect_close(normal, UP, then="; the normal", tolerance=0.0)
    expect_close(depth, 0.5, then="; the penetration", unit="m")
