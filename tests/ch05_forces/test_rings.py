"""The points of a hole in a target of the sniper game, project 4.2b."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch05_forces.sniper import ring_points
from expect import about, cause_of, expect_exactly, expect_that, named

RINGS = ((0.1, 10), (0.25, 5), (0.5, 2))  # as in sniper.py: radius and points


@pytest.mark.exercise("P4.2b", asks="The smallest ring in RINGS that contains (x, y)")
def test_only_the_smallest_ring_counts(rng: Random) -> None:
    about.read = "the docstring of ring_points"
    about.cause = "Only the smallest ring around the hole counts. A hole scores 10 points up to "
    about.cause += "0.1 m from the center, 5 up to 0.25 m, 2 up to 0.5 m, and 0 beyond."
    use = "Compare the true distance, math.hypot(x, y), with the radii."
    add = "You add up the points of all rings around the hole. Count only the smallest ring."
    largest = "You return the points of the largest ring. Check the smallest ring first."
    x, y = 0.3, -0.3
    about.call = f"ring_points({x}, {y}), for a hole {math.hypot(x, y):.4f} m from the center"
    got = ring_points(x, y)
    early = (
        "You return 0 as soon as the hole lies outside the smallest ring. Check the larger rings "
    )
    early += "first, and return 0 after the loop."
    slips = {
        f"You compare the squared distance with the radii. {use}": 5,
        f"You add x and y. {use}": 10,
        early: 0,
    }
    expect_exactly(got, 2, cause=named(got, about.cause, slips))
    for x, y, points, slip, gives in (
        (0.0, 0.3, 2, "You compare only x with the radii of the rings.", 10),
        (0.3, 0.0, 2, "You compare only y with the radii of the rings.", 10),
        (0.08, -0.08, 5, "You treat this hole as if it were inside the 0.1 m ring.", 10),
        (0.2, 0.2, 2, "You use the larger of |x| and |y|, which makes the rings square.", 5),
    ):
        about.call = f"ring_points({x}, {y}), for a hole {math.hypot(x, y):.4f} m from the center"
        got = ring_points(x, y)
        mistakes = [(gives, f"{slip} {use}"), (7, add), (2, largest)]
        expect_exactly(got, points, cause=cause_of(got, mistakes, about.cause))
    turn = rng.uniform(0.1, 1.4)
    for away, points in (
        (0.0, 10),
        (0.0999, 10),
        (0.1001, 5),
        (0.24, 5),
        (0.26, 2),
        (0.49, 2),
        (0.51, 0),
    ):
        for angle in (turn, turn + math.pi):
            x, y = away * math.cos(angle), away * math.sin(angle)
            about.call = f"ring_points({x:.6g}, {y:.6g}), for a hole {away} m from the center"
            got = ring_points(x, y)
            nothing = "You return nothing for a hole outside all rings. Return 0 in this case."
            expect_that(got is not None, "nothing (None)", f"{points}", cause=nothing)
            both = sum(points for radius, points in RINGS if away <= radius)
            why = named(got, about.cause, {add: both, largest: RINGS[-1][1]})
            expect_exactly(got, points, cause=why)
    about.cause = "You treat a hole exactly on the edge of a ring as outside. Compare with <= "
    about.cause += "instead of <."
    for x, y, points in ((0.1, 0.0, 10), (0.0, -0.25, 5), (-0.5, 0.0, 2), (0.3, 0.4, 2)):
        about.call = f"ring_points({x}, {y}), for a hole on the edge of a ring"
        expect_exactly(ring_points(x, y), points)
