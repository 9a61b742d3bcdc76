"""Firing a shot on the sniper range, what it hits and the points for it, project 4.2b."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.sniper import SniperRange, hit_on_the_way, ring_points
from draw import Components, Triple
from expect import about, expect_close, expect_exactly, expect_that, is_plain, named, xyz
from unmoved import expect_kept

SHOOT = "the docstring of shoot"
RING = "the docstring of ring_points"
WAY = "the docstring of hit_on_the_way"
EARLY = "This call fires no bullet, so return False before you reduce shots_left."
# The targets of sniper.py, by their distance: x, y, distance and factor.
TARGETS = {
    50.0: (-1.5, 1.5, 50.0, 1),
    100.0: (-0.5, 1.5, 100.0, 2),
    150.0: (2.0, 1.5, 150.0, 3),
    200.0: (5.0, 1.5, 200.0, 4),
}
RINGS = ((0.1, 10), (0.25, 5), (0.5, 2))  # as in sniper.py: radius and points


def draw_angles(rng: Random) -> tuple[float, float]:
    return round(rng.uniform(0.05, 0.19), 4), round(rng.uniform(0.05, 0.19), 4)


def aimed(azimuth: float, elevation: float) -> Triple:
    """Return the velocity of a bullet that is fired in this direction."""
    x, z = math.sin(azimuth), math.cos(azimuth)
    return 120.0 * Triple((math.cos(elevation) * x, math.sin(elevation), math.cos(elevation) * z))


@pytest.mark.exercise("P4.2b", asks="The smallest ring in RINGS that contains (x, y)", read=RING)
def test_only_the_smallest_ring_counts(rng: Random) -> None:
    only = (
        "Only the smallest ring around the hole counts. A hole scores 10 points up to 0.1 m from "
        "the center, 5 up to 0.25 m, 2 up to 0.5 m, and 0 beyond."
    )
    edge = "A hole exactly on the edge of a ring belongs to it. Compare with <= instead of <."
    use = "Compare the true distance, math.hypot(x, y), with the radii."
    early = "You return 0 before you check the larger rings. Only return 0 after the loop."
    add = "You add up the points of all rings around the hole. Count only the smallest ring."
    largest = "You return the points of the largest ring. Check the smallest ring first."
    turn = rng.uniform(0.1, 1.4)
    around = [
        (away * math.cos(angle), away * math.sin(angle), points, only, {})
        for away, points in (
            (0.0, 10), (0.0999, 10), (0.1001, 5), (0.24, 5), (0.26, 2), (0.49, 2), (0.51, 0)
        )
        for angle in (turn, turn + math.pi)
    ]  # fmt: skip
    for x, y, wanted, cause, slips in (
        (0.3, -0.3, 2, only,
         {f"You compare the squared distance with the radii. {use}": 5,
          f"You add x and y. {use}": 10, early: 0}),
        (0.0, 0.3, 2, only, {f"You compare only x with the radii of the rings. {use}": 10}),
        (0.3, 0.0, 2, only, {f"You compare only y with the radii of the rings. {use}": 10}),
        (0.08, -0.08, 5, only, {f"This hole is not inside the 0.1 m ring. {use}": 10}),
        (0.2, 0.2, 2, only, {f"You use the larger of |x| and |y|. {use}": 5}),
        *around,
        (0.1, 0.0, 10, edge, {}), (0.0, -0.25, 5, edge, {}),
        (-0.5, 0.0, 2, edge, {}), (0.3, 0.4, 2, edge, {}),
    ):  # fmt: skip
        away = math.hypot(x, y)
        shown = f"ring_points({x:.6g}, {y:.6g}), for a hole {away:.4g} m from the center"
        with calls(cause, shown):
            got = ring_points(x, y)
        if cause is only:
            every = sum(points for radius, points in RINGS if away <= radius)
            slips = {**slips, add: every, largest: 2}
        expect_exactly(got, wanted, cause=named(got, cause, slips))


@pytest.mark.exercise("P4.2b", asks="starts at MUZZLE with MUZZLE_SPEED", read=SHOOT)
def test_a_bullet_leaves_the_muzzle_as_it_was_aimed(rng: Random) -> None:
    a, e = draw_angles(rng)
    for azimuth, elevation in ((0.0, 0.0), (a, e), (-a, -e)):
        with calls("MUZZLE and GRAVITY are tuples. Make vectors of them, as in Vector3(*MUZZLE)."):
            game = SniperRange(1)
            fired = game.shoot(azimuth=azimuth, elevation=elevation)
        cause = "shoot must fire a bullet here, store it in self.bullet, and return True."
        expect_exactly(fired, True, cause=cause)
        expect_exactly(game.bullet is None, False, then="; game.bullet is None", cause=cause)
        bullet: Any = game.bullet
        x, y, z = wanted = aimed(azimuth, elevation)
        slips = {
            "The velocity of your bullet is a unit vector. Multiply it by MUZZLE_SPEED.":
                wanted / 120.0,
            "You swapped the azimuth and the elevation.": aimed(elevation, azimuth),
            "Your azimuth rotates the shot in the wrong direction.": (-x, y, z),
            "You swapped the sine and the cosine of the azimuth.": (z, y, x),
            "Your bullet is too fast, because its horizontal part is the whole speed.":
                (120.0 * math.sin(azimuth), y, 120.0 * math.cos(azimuth)),
            "You converted the angles from degrees, but they are already in radians.":
                aimed(math.radians(azimuth), math.radians(elevation)),
        }  # fmt: skip
        expect_close(
            bullet.velocity, wanted, slips, then="; game.bullet.velocity", unit="m/s",
            cause="The vertical part must be speed x sin(elevation), and the horizontal part speed "
            "x cos(elevation), rotated from Z toward X by the azimuth.",
        )  # fmt: skip
        for name, got, right, unit, cause in (
            ("position", bullet.position, (0, 1.5, 0), "m",
             "Your bullet doesn't start at the muzzle. Use MUZZLE as its position."),
            ("acceleration", bullet.acceleration, (0, -2, 0), "m/s^2",
             "Gravity doesn't act on your bullet. Use GRAVITY as its acceleration."),
            ("mass", bullet.mass, 1.0, "kg", "The bullet's mass must be BULLET_MASS."),
            ("damping", bullet.damping, 1.0, "", "The bullet's damping must be 1."),
        ):  # fmt: skip
            expect_close(got, right, then=f"; game.bullet.{name}", unit=unit, cause=cause)
        cause = "shoot doesn't count this shot. Reduce shots_left by 1 when you fire a bullet."
        minus = "You set shots_left to -1, because =- is not -=. Write self.shots_left -= 1."
        cause = named(game.shots_left, cause, {minus: -1})
        expect_exactly(game.shots_left, 9, then="; game.shots_left", cause=cause)


@pytest.mark.exercise("P4.2b", asks="the wind acts on it through self.forces", read=SHOOT)
def test_the_wind_acts_on_the_bullet() -> None:
    with calls("Call self.forces.add exactly once in shoot: first the bullet, then the wind."):
        game = SniperRange(1)
        game.wind.velocity = Vector3(4, 0, 20)
        game.shoot(0.0, 0.0)
        game.forces.update_forces(0.5)
        got = game.bullet.force_accumulator
    # K1 and K2 are 0.02 and 0.0003; relative to the air the bullet has (-4, 0, 100).
    wanted = Triple((4.0, 0.0, -100.0)) * (0.02 + 0.0003 * math.hypot(4.0, 100.0))
    slips = {
        "You registered the wind for your bullet twice.": 2.0 * wanted,
        "The wind doesn't act on your bullet.": (0.0, 0.0, 0.0),
    }
    expect_close(got, wanted, slips, unit="N")


@pytest.mark.exercise(
    "P4.2b", asks="The rifle does not fire while another bullet is in flight", read=SHOOT
)
def test_one_bullet_flies_at_a_time(rng: Random) -> None:
    a, e = draw_angles(rng)
    cause = "Integrate the bullet exactly once per step in update, and never in shoot."
    with calls(cause):
        game = SniperRange(1)
        game.shoot(a, e)
        game.update(1.0 / 60.0)
    x, y, _ = place = xyz(game.bullet.position)
    wanted = aimed(a, e)[0] / 60.0, 1.5 + aimed(a, e)[1] / 60.0
    if y > wanted[1]:
        cause = f"Your bullet moves too far. {cause}"
    then, way = "; x and y of game.bullet.position, in m", "the docstring of update"
    slips = {"Your update doesn't move the bullet.": (0.0, 1.5)}
    expect_close((x, y), wanted, slips, then=then, cause=cause, read=way, tolerance=1e-12)
    with calls(
        "A bullet is in flight, so fire no other one. Return False instead.",
        f"game = SniperRange(1); game.shoot({a}, {e}); one step of 1/60 s; game.shoot(0.0, 0.0)",
    ):
        fired = game.shoot(0.0, 0.0)
    expect_exactly(fired, False)
    expect_exactly(game.shots_left, 9, then="; game.shots_left", cause=EARLY)
    expect_close(game.bullet.position, place, then="; game.bullet.position", unit="m")


@pytest.mark.exercise("P4.2b", asks="or if no shots are left", read=SHOOT)
def test_without_shots_left_none_is_fired() -> None:
    with calls("There is one shot left, so shoot must fire it and return True."):
        game = SniperRange(1)
        game.shots_left = 1
        fired = game.shoot(0.0, 0.0)
    expect_exactly(fired, True)
    with calls("No shots are left, so fire no bullet. Return False if shots_left is 0.", more=True):
        game.bullet = None
        fired = game.shoot(0.0, 0.0)
    expect_exactly(fired, False)
    expect_exactly(game.shots_left, 0, then="; game.shots_left", cause=EARLY)
    expect_exactly(game.bullet is None, True, then="; game.bullet is None")


# hit_on_the_way


def expect_hole(
    path: tuple[Components, Components],
    wanted: tuple[float, float, float, int] | None,
    cause: str,
    *,
    wrong: str = "",
) -> None:
    """Expect a hole: the distance of its target, x, y and points. None means no hole.

    ``wrong`` is the cause if there is a hole, but in a different target.
    """
    with calls(cause):
        start, end = Vector3(*path[0]), Vector3(*path[1])
        hole = hit_on_the_way(start, end)
    expect_kept("start", xyz(start), path[0])
    expect_kept("end", xyz(end), path[1])
    expect_that(wanted is not None or hole is None, "a hole", "no hole (None)")
    if wanted is None:
        return
    distance, x, y, points = wanted
    middle, height, _, factor = TARGETS[distance]
    expect_that(hole is not None, "no hole (None)", f"a hole in the target at {distance:g} m")
    about(cause="Return a Hole with the target that was hit, x, y and points.")
    expect_that(not is_plain(hole), repr(hole), "a Hole, or None")
    target, got = hole.target, (hole.x, hole.y, hole.points)
    target = target.x, target.y, target.distance, target.factor
    then = "; x, y, distance and factor of the hole's target"
    expect_close(target, TARGETS[distance], then=then, tolerance=1e-12, cause=wrong or cause)
    if wrong:
        cause = (
            "Measure x and y from the target's center to where the path crosses its plane. Get the "
            "points from ring_points."
        )
    slips = {
        "Your points are those of the ring alone. Multiply them by the target's factor.":
            (x, y, points / factor),
        "Your x and y have the wrong sign. Subtract the target's center from them.":
            (-x, -y, points),
        "Your x and y are the position of the hole in the world. Subtract the target's center.":
            (x + middle, y + height, points),
    }  # fmt: skip
    # Positions of 200 m, some roundings each.
    then = "; x, y and points of the hole"
    expect_close(got, (x, y, points), slips, then=then, cause=cause, tolerance=1e-12)


@pytest.mark.exercise("P4.2b", asks="If the crossing point lies inside a ring", read=WAY)
def test_a_hole_is_where_the_path_crosses_the_target(rng: Random) -> None:
    none = (
        "The path goes through a target, but you find no hole. Find x and y where it crosses the "
        "target's plane, and subtract the target's center before you call ring_points."
    )
    nearest = "You check only the nearest target. Check every target along the path."
    quarter = (
        "You use x and y at the wrong point. The path crosses the target's plane a quarter of the "
        "way from start to end, so interpolate x and y there."
    )
    away, along = round(rng.uniform(0.02, 0.06), 3), Triple((0.0, 0.0, 1.0))
    for distance, (middle, height, _, factor) in TARGETS.items():
        for x, y in ((away, -away), (-away, away)):
            place = Triple((middle + x, height + y, distance))
            path, hole = (place - along, place + along), (distance, x, y, 10 * factor)
            wrong = "Your target is wrong. Return the one whose plane the path crosses."
            expect_hole(path, hole, none if distance == 50.0 else nearest, wrong=wrong)
    for y, points in ((0.0, 20), (0.3, 4)):
        path = (0.5, 0.5 + y, 99.0), (-3.5, 4.5 + y, 103.0)
        expect_hole(path, (100.0, 0.0, y, points), quarter)


@pytest.mark.exercise("P4.2b", asks="if start.z < distance <= end.z", read=WAY)
def test_a_path_that_misses_the_target_makes_no_hole() -> None:
    middle = (-1.5, 1.5)
    for path, hole, cause in (
        (((-2.1, 1.5, 49.0), (-2.1, 1.5, 51.0)), None,
         "The path passes outside the largest ring. Return None if ring_points returns 0."),
        (((*middle, 40.0), (*middle, 49.9)), None,
         "The path ends before it reaches the target, so there is no hole. Return None."),
        (((*middle, 50.1), (*middle, 60.0)), None,
         "The path starts behind the target, so it makes no hole. Return None."),
        (((*middle, 51.0), (*middle, 49.0)), None,
         "The path crosses the plane from behind, which makes no hole. Return None."),
        (((*middle, 50.0), (*middle, 50.0)), None,
         "You divide by end.z - start.z, which is 0. Check that start.z < distance first."),
        (((3.5, 1.5, 49.0), (*middle, 51.0)), None,
         "The path crosses the target's plane outside the target. Use x and y at the plane, not "
         "at the end of the path."),
        (((*middle, 50.0), (*middle, 52.0)), None,
         "The previous step has checked the start. Count a target only if start.z < distance."),
        (((*middle, 48.0), (*middle, 50.0)), (50.0, 0.0, 0.0, 10),
         "The end of the path counts as a hit. Use start.z < distance <= end.z."),
    ):  # fmt: skip
        expect_hole(path, hole, cause)


@pytest.mark.exercise("P4.2b", asks="Find the first hole that a bullet makes", read=WAY)
def test_a_long_path_hits_the_first_target_on_it() -> None:
    first = "The path hits two targets. Return the hole in the nearer one, which stops the bullet."
    expect_hole(((-2.0, 1.5, 25.0), (0.0, 1.5, 125.0)), (50.0, 0.0, 0.0, 10), first, wrong=first)
    miss = "The path misses the first target. Continue with the next one after a miss."
    for x, distance, points in ((-0.5, 100.0, 20), (2.0, 150.0, 30)):
        path = (x, 1.5, 25.0), (x, 1.5, distance + 25.0)
        expect_hole(path, (distance, 0.0, 0.0, points), miss)
