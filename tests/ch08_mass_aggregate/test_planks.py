"""Going further, G8.2: the nearest point of a segment, and a ball that touches planks."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch08_mass_aggregate.planks import nearest_on_segment
from ch08_mass_aggregate.rough_probes import touched_planks
from draw import Components, components, direction, dot, positive_number, rounded
from expect import (
    about,
    blame,
    cause_of,
    expect_close,
    expect_exactly,
    expect_that,
    expect_unchanged,
    expect_vector,
    xyz,
)
from unmoved import expect_kept

NEAREST = "the docstring of nearest_on_segment"
PLANKS = "book 8.2.1, and the docstring of Planks.contacts"
UP = (0.0, 1.0, 0.0)
# Coordinates are below 40 m, and are rounded in about ten operations.
NEAR = 1e-12


def plus(a: Components, b: Components, share: float = 1.0) -> Components:
    """Return a + share b."""
    x, y, z = (p + share * q for p, q in zip(a, b, strict=True))
    return x, y, z


def at_right_angle(rng: Random, way: Components) -> Components:
    """Draw a unit vector at a right angle to a unit vector."""
    while True:
        drawn = direction(rng)
        across = plus(drawn, way, -dot(drawn, way))
        length = math.hypot(*across)
        if length > 0.3:
            return plus((0.0, 0.0, 0.0), across, 1.0 / length)


def called(point: Components, a: Components, b: Components) -> str:
    return f"nearest_on_segment(point={rounded(point)}, a={rounded(a)}, b={rounded(b)})"


@pytest.mark.exercise("G8.2", asks="Find the point of the line segment")
def test_the_nearest_point_between_the_ends(rng: Random) -> None:
    about.read = NEAREST
    about.cause = "Project point - a onto b - a, and start from a: a + (b - a) t."
    for share in (0.15, 0.4, 0.75):
        a, way = components(rng), direction(rng)
        length, distance = positive_number(rng, 2.0, 8.0), positive_number(rng, 0.5, 4.0)
        b, wanted = plus(a, way, length), plus(a, way, share * length)
        across = at_right_angle(rng, way)
        point = plus(wanted, across, distance)
        about.call = called(point, a, b)
        vectors = Vector3(*point), Vector3(*a), Vector3(*b)
        result = nearest_on_segment(*vectors)
        for name, v, old in zip(("point", "a", "b"), vectors, (point, a, b), strict=True):
            expect_kept(name, xyz(v), old)
        got = expect_vector(result)
        mistakes = [
            (plus(wanted, a, -1.0), "You return the vector from a to the nearest point. Add a."),
            (plus(b, way, -share * length), "You measure the projection from b instead of a."),
            (plus(b, way, share * length), "You add the projection to b. It starts at a."),
            (b, "You return b although the nearest point is between the ends. Either you don't "
                "divide by the squared length of b - a, or you swapped min and max."),
            (a if share < 0.5 else b, "You return the nearer end of the segment. The nearest point "
                                      "may also be between the ends."),
            (plus(a, way, min(1.0, share * length) * length),
             "You divide by the length of b - a. Divide by its square to get t."),
        ]  # fmt: skip
        blame(got, mistakes)
        expect_close(got, wanted, unit="m", tolerance=NEAR)


@pytest.mark.exercise("G8.2", asks="so limit t to this range")
def test_the_nearest_point_beyond_an_end_is_the_end(rng: Random) -> None:
    about.read = NEAREST
    about.cause = "Beyond an end of the segment, the nearest point is that end. Limit t to the "
    about.cause += "range from 0 to 1."
    for share in (-0.3, -2.0, 1.2, 3.0):
        a, way = components(rng), direction(rng)
        length = positive_number(rng, 1.0, 5.0)
        b, there = plus(a, way, length), plus(a, way, share * length)
        point = plus(there, at_right_angle(rng, way), positive_number(rng, 0.5, 3.0))
        wanted, name = (a, "a") if share < 0.0 else (b, "b")
        about.call = called(point, a, b)
        got = expect_vector(nearest_on_segment(Vector3(*point), Vector3(*a), Vector3(*b)))
        mistakes = [
            (there, "You return the nearest point of the infinite line. The segment ends at "
                    f"{name}, so limit t to the range from 0 to 1."),
            (b if name == "a" else a, "You return the wrong end of the segment."),
        ]  # fmt: skip
        blame(got, mistakes)
        expect_close(got, wanted, unit="m", tolerance=NEAR)


@pytest.mark.exercise("G8.2", asks="the segment is a single point")
def test_a_segment_may_be_a_single_point(rng: Random) -> None:
    about.read = NEAREST
    about.cause = "If a and b are equal, the squared length of b - a is 0. Don't divide by it, but "
    about.cause += "return a copy of a."
    a, point = components(rng), components(rng)
    about.call = called(point, a, a)
    got = expect_vector(nearest_on_segment(Vector3(*point), Vector3(*a), Vector3(*a)))
    expect_close(got, a, unit="m", tolerance=0.0)


@pytest.mark.exercise("G8.2", asks="Return a new vector")
def test_the_nearest_point_is_a_new_vector(rng: Random) -> None:
    about.read = NEAREST
    a, way = components(rng), direction(rng)
    b = plus(a, way, positive_number(rng, 1.0, 5.0))
    for point, one, two in (
        (plus(a, way, -1.0), a, b),
        (plus(b, way), a, b),
        (components(rng), a, a),
        (components(rng), a, b),
    ):
        vectors = [Vector3(*v) for v in (point, one, two)]
        about.call = called(point, one, two)
        about.cause = "You return one of the arguments itself. Return a new vector."
        got = nearest_on_segment(*vectors)
        expect_vector(got)
        got.x += 1.0
        about.call += "; the result is then changed"
        for name, v, before in zip(("point", "a", "b"), vectors, (point, one, two), strict=True):
            expect_unchanged(name, xyz(v), before)


@pytest.mark.exercise("G8.2", asks="from the nearest point of the plank to the center")
def test_a_ball_touches_a_plank_from_any_side(rng: Random) -> None:
    about.read = PLANKS
    for share, over, nearer in ((0.2, 0.0, 1), (0.8, 0.0, 2), (0.0, -0.6, 1), (1.0, 0.6, 2)):
        a, way = components(rng), direction(rng)
        length, radius = positive_number(rng, 2.0, 3.0), positive_number(rng, 0.6, 1.0)
        c, depth = positive_number(rng, 0.1, 0.9), positive_number(rng, 0.05, 0.2)
        b, across = plus(a, way, length), at_right_angle(rng, way)
        touched = plus(a, way, share * length)
        aside = math.sqrt(1.0 - over**2)  # the ball is beyond an end by the fraction over
        ball = plus(plus(touched, way, over * (radius - depth)), across, aside * (radius - depth))
        offset = plus(ball, touched, -1.0)
        distance = math.hypot(*offset)
        normal = plus((0.0, 0.0, 0.0), offset, 1.0 / distance)
        about.call = f"a ball of radius {radius} m at {rounded(ball)}; a plank from {rounded(a)}, "
        about.call += f"particle 1, to {rounded(b)}, particle 2; Planks(...).contacts()"
        about.cause = (
            "The arguments of Contact are the ball, the nearer end, direction_of(offset), "
        )
        about.cause += "self.restitution and the penetration, in this order. The normal must be a "
        about.cause += "unit vector. Put each contact into the list that you return."
        got = touched_planks(ball, radius, [(a, b)], c)
        about.cause = "The ball overlaps the plank, so return one contact. Its particle is the "
        about.cause += "ball, and its other is the end of the plank that is nearer to the ball."
        ends = [(one, two) for one, two, *_ in got]
        if ends == [(0, 1), (0, 2)]:
            about.cause = "You return a contact for each end. Return one, with the nearer end."
        elif ends == [(0, 3 - nearer)]:
            about.cause = "You return a contact with the end that is farther from the ball."
        elif ends == [(nearer, 0)]:
            about.cause = "You swapped particle and other. The particle is the ball."
        expect_exactly(ends, [(0, nearer)], then="; (particle, other) of each contact")
        _, _, seen, restitution, penetration = next(iter(got))
        about.cause = "The normal points from the nearest point of the plank to the ball's center."
        back = plus((0.0, 0.0, 0.0), normal, -1.0)
        end = a if nearer == 1 else b
        from_end = plus(ball, end, -1.0)
        from_end = plus((0.0, 0.0, 0.0), from_end, 1.0 / math.hypot(*from_end))
        mistakes = [
            (UP, "Your normal is always +Y, as in Deck. Let it point from the nearest point of the "
                 "plank to the ball's center."),
            (back, "Your normal points from the ball to the plank. Reverse it."),
            (across, "You use the line through both ends, which goes on beyond them."),
            (from_end, "Your normal starts at the end of the plank. Let it start at the point of "
                       "the plank that is nearest to the ball."),
        ]  # fmt: skip
        why = cause_of(seen, mistakes, about.cause)
        # The normal is a difference of coordinates, divided by a distance of at least 0.4 m.
        expect_close(seen, normal, then="; the normal", cause=why, tolerance=1e-11)
        about.cause = "The penetration is the radius minus the distance from the ball's center to "
        about.cause += "the nearest point of the plank."
        mistakes = [
            (distance, "You return the distance itself. Subtract it from the radius."),
            (distance - radius, "You swapped the radius and the distance."),
            (c, "You swapped the restitution and the penetration. The restitution comes first."),
        ]
        why = cause_of(penetration, mistakes, about.cause)
        name = "; the penetration"
        expect_close(penetration, radius - distance, then=name, cause=why, unit="m", tolerance=NEAR)
        about.cause = "Pass self.restitution to each Contact."
        expect_close(restitution, c, then="; the restitution", tolerance=1e-12)


@pytest.mark.exercise("G8.2", asks="Return one contact for each plank")
def test_which_planks_a_ball_touches(rng: Random) -> None:
    about.read = PLANKS
    x = float(rng.randint(2, 9))
    planks = [((x + 2.0 * i, 4.0, -1.0), (x + 2.0 * i, 4.0, 1.0)) for i in range(3)]
    row = "planks 2 m apart along X, at a height of 4 m"
    for ball, radius, wanted, cause in (
        ((x, 4.5, 0.5), 0.5, [(0, 2)], "The ball just touches the first plank. Return a contact "
         "with a penetration of 0."),
        ((x, 4.500001, 0.5), 0.5, [], "The ball is just above the plank, so there is no contact."),
        ((x, 4.0, 1.625), 0.5, [], "The ball is beyond the end of the plank. Only the infinite "
         "line goes through the ball, but the segment doesn't."),
        ((x + 1.0, 4.5, 0.5), 1.5, [(0, 2), (0, 4)], "The ball is between two planks and touches "
         "both. Return a contact for each, in the order of the planks."),
        ((x + 1.0, 4.0, 0.5), 0.5, [], "The ball is in the gap between two planks, and touches "
         "neither of them."),
        ((x, 3.75, 0.0), 0.5, [(0, 1)], "Both ends are equally near to the ball. Return a contact "
         "with the first one."),
    ):  # fmt: skip
        about(f"{row}; a ball of radius {radius} m at {rounded(ball)}", cause=cause)
        about.call += "; particle 0 is the ball, and 1 to 6 are the ends; Planks(...).contacts()"
        got = [(a, b) for a, b, *_ in touched_planks(ball, radius, planks, 0.0)]
        expect_exactly(got, wanted, then="; (particle, other) of each contact")
    about(f"{row}; a ball whose center is on the first plank; Planks(...).contacts()")
    about.cause = "The offset is zero and has no direction. Use direction_of, which returns +Y."
    found = touched_planks((x, 4.0, 0.5), 0.5, planks, 0.0)
    expect_that(len(found) == 1, f"{len(found)} contacts", "1 contact")
    _, _, normal, _, depth = next(iter(found))
    expect_close(normal, UP, then="; the normal", tolerance=0.0)
    expect_close(depth, 0.5, then="; the penetration", unit="m")
