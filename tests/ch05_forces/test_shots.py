"""Firing a shot on the sniper range and finding what it hits, project 4.2b."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.sniper import SniperRange, hit_on_the_way, ring_points
from expect import (
    UNCHANGED,
    about,
    blame,
    cause_of,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    named,
    scoped,
    xyz,
)

SHOOT = "the docstring of shoot"
WAY = "the docstring of hit_on_the_way"
RINGS = ((0.1, 10), (0.25, 5), (0.5, 2))  # as in sniper.py: radius and points
# The targets of sniper.py, by their distance: x, y, distance and factor.
TARGETS = {
    50.0: (-1.5, 1.5, 50.0, 1),
    100.0: (-0.5, 1.5, 100.0, 2),
    150.0: (2.0, 1.5, 150.0, 3),
    200.0: (5.0, 1.5, 200.0, 4),
}


def draw_angles(rng: Random) -> tuple[float, float]:
    return round(rng.uniform(0.05, 0.19), 4), round(rng.uniform(0.05, 0.19), 4)


@pytest.mark.exercise("P4.2b")
def test_a_bullet_leaves_the_muzzle_as_it_was_aimed(rng: Random) -> None:
    about.read = SHOOT
    a, e = draw_angles(rng)
    for azimuth, elevation in ((0.0, 0.0), (a, e), (-a, -e)):
        about.call = f"range = SniperRange(1); range.shoot({azimuth}, {elevation})"
        at = SniperRange(1)
        about.cause = "There are shots left and no bullet is in flight, so fire this shot and "
        about.cause += "return True."
        fired = at.shoot(azimuth, elevation)
        expect_exactly(fired, True)
        expect_exactly(at.bullet is None, False, then="; range.bullet is None")
        bullet: Any = at.bullet
        about.cause = "The vertical part of the velocity is speed x sin(elevation), and the "
        about.cause += "horizontal part is speed x cos(elevation). The azimuth rotates the "
        about.cause += "horizontal part from Z toward X."
        wanted = (
            120.0 * math.cos(elevation) * math.sin(azimuth),
            120.0 * math.sin(elevation),
            120.0 * math.cos(elevation) * math.cos(azimuth),
        )
        got = xyz(bullet.velocity)
        slips = {
            "Azimuth and elevation are swapped. The elevation sets the vertical part, and the "
            "azimuth rotates the horizontal part.": (
                120.0 * math.cos(azimuth) * math.sin(elevation),
                120.0 * math.sin(azimuth),
                wanted[2],
            ),
            "Your azimuth rotates the shot away from X. A positive azimuth must give a positive "
            "x component.": (
                -wanted[0],
                *wanted[1:],
            ),
            "The sine and the cosine of the azimuth are swapped. At an azimuth of 0 the bullet "
            "must fly along Z.": wanted[::-1],
            "The bullet is too fast, because you didn't multiply the horizontal part by "
            "cos(elevation).": (
                120.0 * math.sin(azimuth),
                wanted[1],
                120.0 * math.cos(azimuth),
            ),
            "The angles were converted from degrees, but they are already in radians. Pass them "
            "to sin and cos as they are.": (
                120.0 * math.cos(math.radians(elevation)) * math.sin(math.radians(azimuth)),
                120.0 * math.sin(math.radians(elevation)),
                120.0 * math.cos(math.radians(elevation)) * math.cos(math.radians(azimuth)),
            ),
        }
        blame(got, slips)
        expect_close(got, wanted, then="; range.bullet.velocity")
        about.cause = "One attribute of the new bullet is wrong. Use MUZZLE, GRAVITY and "
        about.cause += "BULLET_MASS from the top of the file, and a damping of 1."
        got = xyz(bullet.position)
        expect_close(got, (0, 1.5, 0), then="; range.bullet.position")
        got = xyz(bullet.acceleration)
        expect_close(got, (0, -2, 0), then="; range.bullet.acceleration")
        numbers = (bullet.mass, bullet.damping)
        expect_close(numbers, (1.0, 1.0), then="; mass and damping of range.bullet")
        about.cause = "Each shot that is fired must reduce shots_left by 1."
        expect_exactly(at.shots_left, 9, then="; range.shots_left")


@pytest.mark.exercise("P4.2b")
def test_the_wind_acts_on_the_bullet() -> None:
    about("range = SniperRange(1); range.wind.velocity = Vector3(4, 0, 20); ", read=SHOOT)
    about.call += "range.shoot(0.0, 0.0); range.forces.update_forces(0.5); "
    about.call += "range.bullet.force_accumulator"
    about.cause = "The wind must act on the bullet exactly once. For every shot, add the pair of "
    about.cause += "bullet and wind to self.forces once."
    at = SniperRange(1)
    at.wind.velocity = Vector3(4, 0, 20)
    at.shoot(0.0, 0.0)
    at.forces.update_forces(0.5)
    bullet: Any = at.bullet
    # K1 and K2 are 0.02 and 0.0003; relative to the air the bullet has (-4, 0, 100).
    drag = 0.02 + 0.0003 * math.hypot(4.0, 100.0)
    wanted = (4.0 * drag, 0.0, -100.0 * drag)
    expect_close(xyz(bullet.force_accumulator), wanted)


@pytest.mark.exercise("P4.2b")
def test_one_bullet_flies_at_a_time(rng: Random) -> None:
    about.read = SHOOT
    a, e = draw_angles(rng)
    about.call = f"range = SniperRange(1); range.shoot({a}, {e}); a step of 1/60 s later"
    at = SniperRange(1)
    about.cause = "One step must move the bullet by v h, exactly once. Check that update "
    about.cause += "integrates the bullet and that shoot doesn't."
    at.shoot(a, e)
    at.update(1.0 / 60.0)
    bullet: Any = at.bullet
    place = xyz(bullet.position)
    wanted = (120.0 * math.cos(e) * math.sin(a) / 60.0, 1.5 + 2.0 * math.sin(e))
    name = f"range.shoot({a}, {e}); range.update(1/60); x and y of range.bullet.position"
    way = "the docstring of update"
    expect_close(place[:2], wanted, call=name, read=way, tolerance=1e-12)
    about.call += "; range.shoot(0.0, 0.0)"
    about.cause = "A bullet is still in flight, so you must not fire another. Return False and "
    about.cause += "change nothing."
    expect_exactly(at.shoot(0.0, 0.0), False)
    expect_exactly(at.shots_left, 9, then="; range.shots_left")
    bullet = at.bullet
    expect_close(xyz(bullet.position), place, then="; range.bullet.position")


@pytest.mark.exercise("P4.2b")
def test_without_shots_left_none_is_fired() -> None:
    about("range = SniperRange(1); range.shots_left = 1; range.shoot(0.0, 0.0); ", read=SHOOT)
    about.call += "range.bullet = None; range.shoot(0.0, 0.0)"
    about.cause = "There are no shots left, so shoot must return False instead of firing a bullet."
    at = SniperRange(1)
    at.shots_left = 1
    fired = at.shoot(0.0, 0.0)
    expect_exactly(
        fired,
        True,
        call="range.shots_left = 1; range.shoot(0.0, 0.0)",
        cause="There is one shot left, so shoot must fire it and return True.",
    )
    at.bullet = None
    expect_exactly(at.shoot(0.0, 0.0), False)
    expect_exactly(at.shots_left, 0, then="; range.shots_left")
    expect_exactly(at.bullet is None, True, then="; range.bullet is None")


@pytest.mark.exercise("P4.2b")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [0.2001, -0.2001, 1.6, math.inf, math.nan])
def test_the_rifle_turns_only_so_far(bad: float) -> None:
    about.read = SHOOT
    for angles in ((bad, 0.0), (0.0, bad)):
        about.call = f"range.shoot{angles}"
        about.cause = "Both angles must lie between -SWING and SWING, which is 0.2. Raise "
        about.cause += "ValueError for any angle outside that range, but allow exactly 0.2."
        at = SniperRange(1)

        def allowed() -> None:
            for good in ((0.2, -0.2), (-0.2, 0.2)):
                SniperRange(1).shoot(*good)

        expect_error(lambda at=at, angles=angles: at.shoot(*angles), ValueError, allowed=allowed)
        about.cause = "The angles were rejected, but something changed anyway. Check both angles "
        about.cause += "before you change shots_left or anything else."
        expect_exactly(at.shots_left, 10, then="; range.shots_left")
        expect_exactly(at.bullet is None, True, then="; range.bullet is None")
        at.shoot(0.0, 0.0)
        about.cause = "An invalid angle must be rejected even while a bullet is in flight. Check "
        about.cause += "the angles before anything else."
        expect_error(
            lambda at=at, angles=angles: at.shoot(*angles),
            ValueError,
            call=f"range.shoot(0.0, 0.0); {about.call}",
            allowed=allowed,
        )


# ring_points and hit_on_the_way


@pytest.mark.exercise("P4.2b")
def test_the_innermost_ring_counts(rng: Random) -> None:
    about.read = "the docstring of ring_points"
    about.cause = "The points depend on the distance from the center. A hole within 0.1 m scores "
    about.cause += "10 points, one within 0.25 m scores 5, and one within 0.5 m scores 2."
    use = "Compare the distance from the center, math.hypot(x, y), with the radii."
    for x, y, points, slip, gives in (
        (0.0, 0.3, 2, "You compared only x with the radii of the rings.", 10),
        (0.3, 0.0, 2, "You compared only y with the radii of the rings.", 10),
        (0.08, -0.08, 5, "You used the sum x + y as the distance.", 10),
        (
            0.2,
            0.2,
            2,
            "You used only the larger of |x| and |y|, which makes the rings square.",
            5,
        ),
    ):
        about.call = f"ring_points({x}, {y}), {math.hypot(x, y):.4f} m from the center"
        got = ring_points(x, y)
        expect_exactly(got, points, cause=cause_of(got, [(gives, f"{slip} {use}")], about.cause))
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
            about.call = f"ring_points({x!r}, {y!r}), {away} m from the center"
            got = ring_points(x, y)
            slips = {
                "You added up the points of all rings around the hole. Only the smallest of these "
                "rings counts.": sum(points for radius, points in RINGS if away <= radius),
                "These are the points of the largest ring. Check the smallest ring first, because "
                "it scores the most.": RINGS[-1][1],
            }
            why = named(got, about.cause, slips)
            expect_exactly(got, points, cause=why)
    about.cause = "This point is exactly on the edge of a ring, which still counts as inside. "
    about.cause += "Compare with <= instead of <."
    for x, y, points in ((0.1, 0.0, 10), (0.0, -0.25, 5), (-0.5, 0.0, 2), (0.3, 0.4, 2)):
        about.call = f"ring_points({x}, {y})"
        expect_exactly(ring_points(x, y), points)


@scoped
def way_of(start: tuple[float, float, float], end: tuple[float, float, float]) -> tuple[str, Any]:
    """Return the call and the hole that a path makes, as numbers, or None."""
    about(f"hit_on_the_way(Vector3{start}, Vector3{end})", read=WAY)
    first, last = Vector3(*start), Vector3(*end)
    hole = hit_on_the_way(first, last)
    for name, now, before in (("start", first, start), ("end", last, end)):
        expect_unchanged(name, xyz(now), before, cause=UNCHANGED)
    del about.cause  # what is said where hit_on_the_way raises
    if hole is None:
        return about.call, None
    target = hole.target
    return about.call, (
        target.x,
        target.y,
        target.distance,
        target.factor,
        hole.x,
        hole.y,
        hole.points,
    )


@scoped
def expect_hole(
    start: tuple[float, float, float],
    end: tuple[float, float, float],
    wanted: tuple[float, float, float, int],
) -> None:
    about.read = WAY
    about.call, got = way_of(start, end)
    expect_exactly(got is not None, True, then=": is there a hole")
    distance, *hole = wanted
    x, y, points = hole
    middle, height, _, factor = TARGETS[distance]
    slips = {
        "The points of the ring are right, but they were not multiplied by the target's factor.": (
            *TARGETS[distance],
            x,
            y,
            points / factor,
        ),
        "This is the position of the hole in the world, but x and y are measured from the "
        "target's center. Subtract the center.": (
            *TARGETS[distance],
            x + middle,
            y + height,
            points,
        ),
    }
    blame(got, slips)
    # Positions of 200 m, some roundings each.
    expect_close(
        got,
        (*TARGETS[distance], *hole),
        then=": target (x, y, distance, factor), then x, y and points of the hole",
        tolerance=1e-12,
    )


@scoped
def expect_no_hole(start: tuple[float, float, float], end: tuple[float, float, float]) -> None:
    about.read = WAY
    about.call, got = way_of(start, end)
    expect_exactly(got is not None, False, then=": is there a hole")


@pytest.mark.exercise("P4.2b")
def test_a_hole_is_where_the_way_passes_the_plane_of_the_target(rng: Random) -> None:
    away = round(rng.uniform(0.02, 0.06), 3)
    about.cause = "This path hits a target. Check every target along the path, measure x and y of "
    about.cause += "the hole from the target's center, and multiply the points by its factor."
    for distance, (middle, height, _, factor) in TARGETS.items():
        for x, y in ((away, -away), (-away, away)):
            start = (middle + x, height + y, distance - 1.0)
            end = (middle + x, height + y, distance + 1.0)
            expect_hole(start, end, (distance, x, y, 10 * factor))
    about.cause = "This path is oblique, so x and y change along it. Interpolate them at the "
    about.cause += "target's plane, which the path crosses a quarter of the way along."
    start, end = (0.5, 0.5, 99.0), (-3.5, 4.5, 103.0)
    expect_hole(start, end, (100.0, 0.0, 0.0, 20))
    start, end = (0.5, 0.8, 99.0), (-3.5, 4.8, 103.0)
    expect_hole(start, end, (100.0, 0.0, 0.3, 4))


@pytest.mark.exercise("P4.2b")
def test_a_way_beside_the_target_or_short_of_it_makes_no_hole() -> None:
    for start, end, cause in (
        (
            (-2.1, 1.5, 49.0),
            (-2.1, 1.5, 51.0),
            "This path passes beside the target, outside even its largest ring, so there is no "
            "hole. Return None.",
        ),
        (
            (-1.5, 1.5, 40.0),
            (-1.5, 1.5, 49.9),
            "This path ends before it reaches the target, so there is no hole. Return None.",
        ),
        (
            (-1.5, 1.5, 50.1),
            (-1.5, 1.5, 60.0),
            "This path starts behind the target, so it doesn't cross the target's plane. Return "
            "None.",
        ),
        (
            (-1.5, 1.5, 51.0),
            (-1.5, 1.5, 49.0),
            "This path crosses the target's plane from behind, which doesn't count as a hit. "
            "Return None.",
        ),
        (
            (-1.5, 1.5, 50.0),
            (-1.5, 1.5, 50.0),
            "This path has no length, so it hits nothing. Check start.z < distance before you "
            "divide by the length.",
        ),
        (
            (3.5, 1.5, 49.0),
            (-1.5, 1.5, 51.0),
            "Where this path crosses the target's plane, x is 1, so it misses the target. Don't "
            "use the end of the path, where x is -1.5.",
        ),
        (
            (-1.5, 1.5, 50.0),
            (-1.5, 1.5, 52.0),
            "This path starts exactly on the target's plane, so the previous step has already "
            "been checked there. Use start.z < distance as the condition.",
        ),
    ):
        about.cause = cause
        expect_no_hole(start, end)
    about.cause = "This path ends exactly on the target's plane, which counts as a hit. Use "
    about.cause += "distance <= end.z as the condition."
    expect_hole((-1.5, 1.5, 48.0), (-1.5, 1.5, 50.0), (50.0, 0.0, 0.0, 10))


@pytest.mark.exercise("P4.2b")
def test_a_long_way_hits_the_first_target_that_it_meets() -> None:
    about.cause = "The path meets two targets, but the nearer one stops the bullet. Return the "
    about.cause += "hole in the nearer one."
    expect_hole((-2.0, 1.5, 25.0), (0.0, 1.5, 125.0), (50.0, 0.0, 0.0, 10))
    about.cause = "The path misses the nearer target, so it can still hit one behind it. Continue "
    about.cause += "with the next target."
    expect_hole((-0.5, 1.5, 25.0), (-0.5, 1.5, 125.0), (100.0, 0.0, 0.0, 20))
    expect_hole((2.0, 1.5, 25.0), (2.0, 1.5, 175.0), (150.0, 0.0, 0.0, 30))
