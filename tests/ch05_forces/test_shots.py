"""Firing a shot on the sniper range and finding what it hits, project 4.2b."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.sniper import SniperRange, hit_on_the_way
from expect import (
    about,
    blame,
    expect_close,
    expect_exactly,
    expect_that,
    expect_unchanged,
    is_plain,
    scoped,
    xyz,
)

SHOOT = "the docstring of shoot"
WAY = "the docstring of hit_on_the_way"
NO_HOLE = "no hole (None)"
# The targets of sniper.py, by their distance: x, y, distance and factor.
TARGETS = {
    50.0: (-1.5, 1.5, 50.0, 1),
    100.0: (-0.5, 1.5, 100.0, 2),
    150.0: (2.0, 1.5, 150.0, 3),
    200.0: (5.0, 1.5, 200.0, 4),
}


def draw_angles(rng: Random) -> tuple[float, float]:
    return round(rng.uniform(0.05, 0.19), 4), round(rng.uniform(0.05, 0.19), 4)


@pytest.mark.exercise("P4.2b", asks="starts at MUZZLE with MUZZLE_SPEED")
def test_a_bullet_leaves_the_muzzle_as_it_was_aimed(rng: Random) -> None:
    about.read = SHOOT
    a, e = draw_angles(rng)
    for azimuth, elevation in ((0.0, 0.0), (a, e), (-a, -e)):
        about.call = f"range = SniperRange(1); range.shoot(azimuth={azimuth}, "
        about.call += f"elevation={elevation})"
        at = SniperRange(1)
        about.cause = (
            "shoot must fire a bullet here. MUZZLE and GRAVITY are tuples, so make vectors "
        )
        about.cause += "of them, as in Vector3(*MUZZLE)."
        fired = at.shoot(azimuth, elevation)
        about.cause = "There are shots left, and no bullet is in flight. shoot must therefore "
        about.cause += "fire a bullet, store it in self.bullet, and return True."
        nothing = "shoot returned nothing. Return True after a bullet is fired."
        expect_that(fired is not None, "nothing (None)", "True", cause=nothing)
        expect_exactly(fired, True)
        expect_exactly(at.bullet is None, False, then="; range.bullet is None")
        bullet: Any = at.bullet
        about.cause = "The velocity of the bullet is wrong. Its vertical part is speed x "
        about.cause += "sin(elevation) and its horizontal part speed x cos(elevation), rotated "
        about.cause += "from Z toward X by the azimuth."
        wanted = (
            120.0 * math.cos(elevation) * math.sin(azimuth),
            120.0 * math.sin(elevation),
            120.0 * math.cos(elevation) * math.cos(azimuth),
        )
        got = xyz(bullet.velocity)
        slips = {
            "The velocity of your bullet is a unit vector. Multiply it by MUZZLE_SPEED.": [
                part / 120.0 for part in wanted
            ],
            "You swapped the azimuth and the elevation. The elevation sets the vertical part "
            "of the velocity, and the azimuth rotates the horizontal part.": (
                120.0 * math.cos(azimuth) * math.sin(elevation),
                120.0 * math.sin(azimuth),
                wanted[2],
            ),
            "Your azimuth rotates the shot in the wrong direction. A positive azimuth must rotate "
            "it from Z toward X, so that x is positive.": (-wanted[0], *wanted[1:]),
            "You swapped the sine and the cosine of the azimuth. With an azimuth of 0, the "
            "bullet must fly along Z.": wanted[::-1],
            "Your bullet is too fast, because its horizontal part is the whole speed. Multiply "
            "the horizontal part by cos(elevation).": (
                120.0 * math.sin(azimuth),
                wanted[1],
                120.0 * math.cos(azimuth),
            ),
            "You converted the angles from degrees to radians. They are already in radians, so "
            "use them unchanged.": (
                120.0 * math.cos(math.radians(elevation)) * math.sin(math.radians(azimuth)),
                120.0 * math.sin(math.radians(elevation)),
                120.0 * math.cos(math.radians(elevation)) * math.cos(math.radians(azimuth)),
            ),
        }
        blame(got, slips)
        expect_close(got, wanted, then="; range.bullet.velocity, in m/s")
        about.cause = "Your bullet doesn't start at the muzzle. Use MUZZLE as its position."
        got = xyz(bullet.position)
        expect_close(got, (0, 1.5, 0), then="; range.bullet.position, in m")
        about.cause = "Gravity doesn't act on your bullet. Use GRAVITY as its acceleration."
        got = xyz(bullet.acceleration)
        expect_close(got, (0, -2, 0), then="; range.bullet.acceleration, in m/s^2")
        about.cause = "The bullet's mass must be BULLET_MASS, and its damping must be 1."
        numbers = (bullet.mass, bullet.damping)
        expect_close(numbers, (1.0, 1.0), then="; range.bullet.mass and range.bullet.damping")
        about.cause = (
            "shoot doesn't count this shot. Reduce shots_left by 1 when you fire a bullet."
        )
        minus = "You set shots_left to -1, because =- is not -=. Write self.shots_left -= 1."
        blame(at.shots_left, [(-1, minus)])
        expect_exactly(at.shots_left, 9, then="; range.shots_left")


@pytest.mark.exercise("P4.2b", asks="the wind acts on it through self.forces")
def test_the_wind_acts_on_the_bullet() -> None:
    about("range = SniperRange(1); range.wind.velocity = Vector3(4, 0, 20); ", read=SHOOT)
    about.call += "range.shoot(0.0, 0.0); range.forces.update_forces(0.5); "
    about.call += "range.bullet.force_accumulator, in N"
    about.cause = (
        "The wind must act on the bullet exactly once. In shoot, call self.forces.add once, "
    )
    about.cause += "with the new bullet first and the wind second."
    at = SniperRange(1)
    at.wind.velocity = Vector3(4, 0, 20)
    at.shoot(0.0, 0.0)
    at.forces.update_forces(0.5)
    bullet: Any = at.bullet
    # K1 and K2 are 0.02 and 0.0003; relative to the air the bullet has (-4, 0, 100).
    drag = 0.02 + 0.0003 * math.hypot(4.0, 100.0)
    wanted = (4.0 * drag, 0.0, -100.0 * drag)
    got = xyz(bullet.force_accumulator)
    twice = "You registered the wind for your bullet twice. Register it only once."
    never = "The wind doesn't act on your bullet. In shoot, register the wind for the new bullet "
    never += "in self.forces."
    blame(got, [([2.0 * part for part in wanted], twice), ((0.0, 0.0, 0.0), never)])
    expect_close(got, wanted)


@pytest.mark.exercise("P4.2b", asks="The rifle does not fire while another bullet is in flight")
def test_one_bullet_flies_at_a_time(rng: Random) -> None:
    about.read = SHOOT
    a, e = draw_angles(rng)
    about.call = f"range = SniperRange(1); range.shoot({a}, {e}); range.update(1/60)"
    at = SniperRange(1)
    about.cause = "Your bullet must move by its velocity times the duration of the step. "
    about.cause += "Integrate it exactly once per step in update, and never in shoot."
    at.shoot(a, e)
    at.update(1.0 / 60.0)
    bullet: Any = at.bullet
    place = xyz(bullet.position)
    wanted = (120.0 * math.cos(e) * math.sin(a) / 60.0, 1.5 + 2.0 * math.sin(e))
    blame(place[:2], [((0.0, 1.5), "Your update doesn't move the bullet. Call bullet.integrate.")])
    if place[1] > wanted[1]:
        about.cause = "Your bullet moves too far in one step, as if integrate were called twice. "
        about.cause += "Call it once in update, and never in shoot."
    name, way = "; x and y of range.bullet.position, in m", "the docstring of update"
    expect_close(place[:2], wanted, then=name, read=way, tolerance=1e-12)
    about.call = f"range = SniperRange(1); range.shoot({a}, {e}); one step of 1/60 s; "
    about.call += "fired = range.shoot(0.0, 0.0)"
    about.cause = "You fire a second bullet while the first one is in flight. Return False instead."
    expect_exactly(at.shoot(0.0, 0.0), False, then="; fired")
    early = "The second call of shoot fires no bullet, so it must not change shots_left. Return "
    early += "False before you reduce shots_left."
    expect_exactly(at.shots_left, 9, then="; range.shots_left", cause=early)
    bullet = at.bullet
    expect_close(xyz(bullet.position), place, then="; range.bullet.position, in m")


@pytest.mark.exercise("P4.2b", asks="or if no shots are left")
def test_without_shots_left_none_is_fired() -> None:
    about("range = SniperRange(1); range.shots_left = 1; range.shoot(0.0, 0.0); ", read=SHOOT)
    about.call += "range.bullet = None; fired = range.shoot(0.0, 0.0)"
    about.cause = "You fire a bullet although no shots are left. Return False if shots_left is 0."
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
    expect_exactly(at.shoot(0.0, 0.0), False, then="; fired")
    expect_exactly(at.shots_left, 0, then="; range.shots_left")
    expect_exactly(at.bullet is None, True, then="; range.bullet is None")


# hit_on_the_way


@scoped
def way_of(start: tuple[float, float, float], end: tuple[float, float, float]) -> tuple[str, Any]:
    """Return the call and the hole that a path makes, as numbers, or None."""
    about(f"hit_on_the_way(start=Vector3{start}, end=Vector3{end})", read=WAY)
    first, last = Vector3(*start), Vector3(*end)
    hole = hit_on_the_way(first, last)
    for name, now, before in (("start", first, start), ("end", last, end)):
        only_read = f"You change {name}, which hit_on_the_way must only read. Calculate with its "
        only_read += "components instead, or work on a copy."
        expect_unchanged(name, xyz(now), before, cause=only_read)
    about.cause = "Return a Hole with the target that was hit, x, y and points."
    if hole is None:
        return about.call, None
    expect_that(not is_plain(hole), repr(hole), "a Hole, or None")
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
    *,
    wrong: str | None = None,
) -> None:
    """Expect this hole. ``wrong`` is the cause if there is a hole, but in a different target."""
    about.read = WAY
    about.call, got = way_of(start, end)
    expect_that(got is not None, NO_HOLE, f"a hole in the target at {wanted[0]:g} m")
    about.cause = wrong or about.cause
    distance, *hole = wanted
    x, y, points = hole
    middle, height, _, factor = TARGETS[distance]
    then = "; x, y, distance and factor of the hole's target"
    expect_close(got[:4], TARGETS[distance], then=then, tolerance=1e-12)
    if wrong:
        about.cause = (
            "Your hole is wrong. Find the point where the path crosses the target's plane, and "
        )
        about.cause += "measure x and y from the target's center. Get the points from ring_points."
    slips = {
        "Your points are those of the ring alone. Multiply them by the target's factor, which is "
        f"{factor} here.": (x, y, points / factor),
        "Your x and y have the wrong sign. Subtract the target's center from the point where the "
        "path crosses its plane, not the other way around.": (-x, -y, points),
        "Your x and y are the position of the hole in the world. Subtract the target's center.": (
            x + middle,
            y + height,
            points,
        ),
    }
    blame(got[4:], slips)
    # Positions of 200 m, some roundings each.
    expect_close(got[4:], hole, then="; x, y and points of the hole", tolerance=1e-12)


@scoped
def expect_no_hole(start: tuple[float, float, float], end: tuple[float, float, float]) -> None:
    about.read = WAY
    about.call, got = way_of(start, end)
    expect_that(got is None, "a hole", NO_HOLE)


@pytest.mark.exercise("P4.2b", asks="If the crossing point lies inside a ring")
def test_a_hole_is_where_the_path_crosses_the_target(rng: Random) -> None:
    away = round(rng.uniform(0.02, 0.06), 3)
    about.cause = (
        "The path goes through a target, but you find no hole. Find x and y where it crosses "
    )
    about.cause += (
        "the target's plane, and subtract the target's center before you call ring_points."
    )
    for distance, (middle, height, _, factor) in TARGETS.items():
        for x, y in ((away, -away), (-away, away)):
            start = (middle + x, height + y, distance - 1.0)
            end = (middle + x, height + y, distance + 1.0)
            hole = (distance, x, y, 10 * factor)
            expect_hole(
                start,
                end,
                hole,
                wrong="Your target is wrong. Return the one whose plane the path crosses.",
            )
        about.cause = "You check only the nearest target. Check every target along the path."
    about.cause = "You use x and y at the wrong point. The path crosses the target's plane a "
    about.cause += "quarter of the way from start to end, so interpolate x and y there."
    start, end = (0.5, 0.5, 99.0), (-3.5, 4.5, 103.0)
    expect_hole(start, end, (100.0, 0.0, 0.0, 20))
    start, end = (0.5, 0.8, 99.0), (-3.5, 4.8, 103.0)
    expect_hole(start, end, (100.0, 0.0, 0.3, 4))


@pytest.mark.exercise("P4.2b", asks="if start.z < distance <= end.z")
def test_a_path_that_misses_the_target_makes_no_hole() -> None:
    for start, end, cause in (
        (
            (-2.1, 1.5, 49.0),
            (-2.1, 1.5, 51.0),
            "You count a path that passes outside the target's largest ring as a hit. Return None "
            "if ring_points returns 0.",
        ),
        (
            (-1.5, 1.5, 40.0),
            (-1.5, 1.5, 49.9),
            "The path ends before it reaches the target, so there is no hole. Return None.",
        ),
        (
            (-1.5, 1.5, 50.1),
            (-1.5, 1.5, 60.0),
            "The path starts behind the target, so it does not cross the target's plane. "
            "Return None.",
        ),
        (
            (-1.5, 1.5, 51.0),
            (-1.5, 1.5, 49.0),
            "The path crosses the target's plane from behind, which does not count as a hit. "
            "Return None.",
        ),
        (
            (-1.5, 1.5, 50.0),
            (-1.5, 1.5, 50.0),
            "The path has no length, so end.z - start.z is 0. Check that start.z < distance before "
            "you divide by end.z - start.z.",
        ),
        (
            (3.5, 1.5, 49.0),
            (-1.5, 1.5, 51.0),
            "The path crosses the target's plane at x = 1, outside the target. Use x and y at "
            "the plane, not at the end of the path, where x is -1.5.",
        ),
        (
            (-1.5, 1.5, 50.0),
            (-1.5, 1.5, 52.0),
            "The path starts exactly on the target's plane, and the previous step has already "
            "checked this point. Count a target only if start.z < distance.",
        ),
    ):
        about.cause = cause
        expect_no_hole(start, end)
    about.cause = "The path ends exactly on the target's plane, which also counts as a hit. Use "
    about.cause += "the condition start.z < distance <= end.z."
    expect_hole((-1.5, 1.5, 48.0), (-1.5, 1.5, 50.0), (50.0, 0.0, 0.0, 10))


@pytest.mark.exercise("P4.2b", asks="Find the first hole that a bullet makes")
def test_a_long_path_hits_the_first_target_on_it() -> None:
    about.cause = "The path hits two targets, but you find no hole. Return the hole in the nearer "
    about.cause += "target."
    farther = "The path hits two targets, and you return the hole in the farther one. Check the "
    farther += "nearer target first, because it stops the bullet."
    expect_hole((-2.0, 1.5, 25.0), (0.0, 1.5, 125.0), (50.0, 0.0, 0.0, 10), wrong=farther)
    about.cause = "You stop at the first target, which the path misses. Continue with the next "
    about.cause += "target after a miss."
    expect_hole((-0.5, 1.5, 25.0), (-0.5, 1.5, 125.0), (100.0, 0.0, 0.0, 20))
    expect_hole((2.0, 1.5, 25.0), (2.0, 1.5, 175.0), (150.0, 0.0, 0.0, 30))
