"""A round of the sniper range without a screen, project 4.2b."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag
from ch05_forces.probes import play, winds
from ch05_forces.sniper import SniperRange
from draw import Components
from expect import (
    about,
    blame,
    expect_close,
    expect_exactly,
    expect_that,
    expect_unchanged,
    xyz,
)

UPDATE = "the docstring of update"
FRAME = 1.0 / 60.0


def fallen(frames: float) -> float:
    """Return how far a bullet without drag has fallen after this number of steps.

    Explicit Euler falls g h^2 n (n - 1) / 2 in n steps. Within a step the path is straight.
    """
    n = math.floor(frames)
    before, after = (FRAME**2 * k * (k - 1) for k in (n, n + 1))  # g is 2 m/s^2
    return before + (after - before) * (frames - n)


def thrown(at: SniperRange, position: Components, velocity: Components) -> Any:
    """Fire a bullet, give it this position and velocity, and let no force act on it."""
    at.shoot(0.0, 0.0)
    at.forces.clear()
    bullet: Any = at.bullet
    bullet.position, bullet.velocity = Vector3(*position), Vector3(*velocity)
    bullet.acceleration = Vector3()
    return bullet


@pytest.mark.exercise("P4.2b", asks="add the hole to holes and its points to the score")
def test_a_shot_that_hits_makes_a_hole_and_scores() -> None:
    about.read = UPDATE
    for x, distance, factor in ((-1.5, 50.0, 1), (2.0, 150.0, 3)):
        azimuth, elevation = math.atan2(x, distance), distance * 0.00007
        level = 120.0 * math.cos(elevation) * math.cos(azimuth)
        y = math.hypot(x, distance) * math.tan(elevation) - fallen(distance / (level * FRAME))
        about.call = f"range = SniperRange(1), without drag; range.shoot(azimuth={azimuth:.6g}, "
        about.call += f"elevation={elevation:.6g}); range.update(1/60) until range.bullet is None"
        about.cause = "The bullet flies through a target, but you find no hit. Perhaps start and "
        about.cause += (
            "end are the same point. Copy the position before you call integrate, which changes it "
            "in place. Call hit_on_the_way after that, with this copy "
        )
        about.cause += "as start, and the new position as end."
        came = play([(azimuth, elevation)], FRAME)
        holes = [tuple(hole) for hole in came["holes"]]
        if holes:
            about.cause = (
                "You append more than one hole. Append exactly one when the bullet hits a target."
            )
        elif came["score"]:
            about.cause = "You added points to the score but no hole to the list. Append the hole "
            about.cause += "to self.holes."
        expect_exactly(len(holes), 1, then="; number of holes in range.holes")
        frames = math.floor(distance / (level * FRAME))
        about.cause = "Your bullet flies on after it has hit a target. A hit ends the shot, so set "
        about.cause += "self.bullet to None."
        expect_exactly(
            len(came["positions"]), frames, then="; number of steps in flight before the hit"
        )
        points = factor * (10 if abs(y) <= 0.1 else 5 if abs(y) <= 0.25 else 2)
        about.cause = "The hole is wrong. Append the hole that hit_on_the_way returns for the path "
        about.cause += "of this step."
        # A hundred roundings of positions up to 150 m.
        wanted = (distance, 0.0, y, points)
        expect_close(
            holes[0],
            wanted,
            then="; distance of the target, then x, y and points of the hole",
            tolerance=1e-10,
        )
        about.cause = "Your score is not the points of the hole, hole.points. They already contain "
        about.cause += "the target's factor, so add them unchanged."
        counts = "You count the hits instead of their points. Add hole.points to the score."
        blame(came["score"], [(1, counts)])
        expect_exactly(came["score"], points, then="; range.score")


@pytest.mark.exercise("P4.2b", asks="update the forces, move the bullet")
def test_the_wind_carries_the_bullet_away() -> None:
    about.call = "two ranges, one with a wind of 10 m/s along X and one without wind; on each, "
    about.call += "range.shoot(0.0, 0.02); range.update(1/60) until range.bullet is None"
    once = "The drag on your bullet is wrong. Call update_forces exactly once in each step, before "
    once += "you integrate the bullet."
    about(cause=once, read=UPDATE)
    still = play([(0.0, 0.02)], FRAME, wind=(0.0, 0.0, 0.0), k1=0.05)["positions"]
    blown = play([(0.0, 0.02)], FRAME, wind=(10.0, 0.0, 0.0), k1=0.05)["positions"]
    frames = (len(blown), len(still))
    # With k1 alone a cross wind changes nothing along Z, and both pass 210 m in step 109.
    none = "Your bullet flies as if there were no drag. Call update_forces before you call "
    none += "integrate."
    blame(frames, [((105, 105), none)])
    if min(frames) > 109:
        about.cause = "Your bullet flies on beyond the end of the range. End the shot as soon as "
        about.cause += "its z is larger than END_OF_RANGE, which is 210 m."
    expect_exactly(
        frames, (109, 109), then="; number of steps in flight, with wind and without wind"
    )
    # x' of the book's step with dv/dt = (w - v) k: in units of w, the velocity is 1 - (1 - k h)^n.
    keep = 1.0 - 0.05 * FRAME
    x, before = (10.0 * FRAME * (n - (1.0 - keep**n) / (1.0 - keep)) for n in (109, 108))
    wanted = (x, 0.0)
    got = (blown[-1][0], still[-1][0])
    about.cause = once
    late = "You call update_forces after integrate, so every force acts one step too late. Call "
    blame(got, [((before, 0.0), f"{late}it before integrate.")])
    if got[1] != 0.0:
        about.cause = "Without wind, x must stay 0, but your bullet drifts sideways. Call "
        about.cause += "change_wind only after the shot has ended."
    expect_close(
        got,
        wanted,
        then="; the bullet's x after its last step in flight, with wind and without wind, in m",
        tolerance=1e-10,
    )
    z = 120.0 * math.cos(0.02) * FRAME * (1.0 - keep**109) / (1.0 - keep)
    about.cause = once
    then = "; the bullet's z after its last step in flight, with wind, in m"
    expect_close(blown[-1][2], z, then=then, tolerance=1e-9)


@pytest.mark.exercise("P4.2b", asks="Advance the bullet by duration s")
def test_a_step_takes_the_given_duration(rng: Random) -> None:
    about.read = UPDATE
    h = round(rng.uniform(0.1, 0.3), 3)
    about.call = "range.wind.velocity = Vector3(5, 0, 0); range.shoot(0.0, 0.1); "
    about.call += f"range.forces.add(range.bullet, Drag(0.5, 0.0)); range.update({h})"
    about.cause = "The step must last as long as the duration that is passed to update. Pass it on "
    about.cause += "to update_forces and integrate."
    at = SniperRange(1)
    at.wind.k1, at.wind.k2, at.wind.velocity = 0.25, 0.0, Vector3(5, 0, 0)
    at.shoot(0.0, 0.1)
    bullet: Any = at.bullet
    at.forces.add(bullet, Drag(0.5, 0.0))
    v = (0.0, 120.0 * math.sin(0.1), 120.0 * math.cos(0.1))
    at.update(h)
    wanted = tuple((0.0, 1.5, 0.0)[i] + v[i] * h for i in range(3))
    got = xyz(bullet.position)
    short = tuple((0.0, 1.5, 0.0)[i] + v[i] * FRAME for i in range(3))
    fixed = f"Your bullet moves for 1/60 s, but this step takes {h} s. Pass the duration of update "
    blame(got, [(short, f"{fixed}to integrate.")])
    expect_close(got, wanted, then="; range.bullet.position, in m")
    gained = (0.25 * 5.0, -2.0, 0.0)
    wanted = tuple(v[i] + (gained[i] - 0.75 * v[i]) * h for i in range(3))
    got = xyz(bullet.velocity)
    windy = tuple(v[i] + (gained[i] - 0.25 * v[i]) * h for i in range(3))
    only = "Only the wind acts on your bullet, not the Drag that was registered for it. Call "
    blame(got, [(windy, f"{only}self.forces.update_forces, which applies every registered force.")])
    expect_close(got, wanted, then="; range.bullet.velocity, in m/s")


@pytest.mark.exercise("P4.2b", asks="or beyond END_OF_RANGE in z")
def test_a_bullet_exactly_at_the_edge_flies_on() -> None:
    about("range.bullet.position = Vector3(20, 1, 178); ", read=UPDATE)
    about.call += "range.bullet.velocity = Vector3(0, -2, 64); no force or gravity acts on the "
    about.call += "bullet; range.update(0.5)"
    about.cause = "This step must move the bullet to y = 0 and z = 210, where the shot is not over "
    about.cause += "yet. End the shot only if y < 0 or z > 210."
    at = SniperRange(1)
    bullet = thrown(at, (20.0, 1.0, 178.0), (0.0, -2.0, 64.0))
    at.update(0.5)
    ended = "the shot has ended (range.bullet is None)"
    expect_that(at.bullet is not None, ended, "the bullet is still in flight")
    got = xyz(bullet.position)
    moves = "The bullet must move by its velocity times the duration. Integrate it once per step."
    expect_close(got, (20, 0, 210), then="; range.bullet.position, in m", cause=moves)
    about.call = "range.bullet.position = Vector3(5, 1.5, 190); range.bullet.velocity = "
    about.call += "Vector3(0, 0, 60); no force or gravity acts on the bullet; range.update(0.5); "
    about.call += "number of holes in range.holes"
    about.cause = "In this step, the bullet hits the target at 200 m and leaves the range. Check "
    about.cause += "for a hit before you check for the end of the range."
    at = SniperRange(1)
    thrown(at, (5.0, 1.5, 190.0), (0.0, 0.0, 60.0))
    at.update(0.5)
    expect_exactly(len(at.holes), 1)


@pytest.mark.exercise("P4.2b", asks="when the bullet is below the ground")
def test_a_miss_lands_on_the_ground_or_behind_the_range() -> None:
    about.read = UPDATE
    for (azimuth, elevation), cause in (
        (
            (0.1, -0.1),
            "Your bullet flies on below the ground. The shot has landed as soon as y < 0, so set "
            "self.bullet to None then.",
        ),
        (
            (0.15, 0.19),
            "Your bullet flies on beyond the end of the range. End the shot as soon as its z is "
            "larger than END_OF_RANGE, which is 210 m.",
        ),
    ):
        about.cause = cause
        about.call = f"range = SniperRange(1), without drag; range.shoot(azimuth={azimuth}, "
        about.call += f"elevation={elevation}); range.update(1/60) until range.bullet is None"
        along = 120.0 * math.cos(elevation) * math.cos(azimuth) * FRAME
        rises = 120.0 * math.sin(elevation) * FRAME
        n = 0
        while 1.5 + rises * (n + 1) >= fallen(n + 1) and along * (n + 1) <= 210.0:
            n += 1
        came = play([(azimuth, elevation)], FRAME)
        expect_exactly(len(came["positions"]), n, then="; number of steps in flight")
        got = (len(came["holes"]), came["score"], came["shots_left"])
        about.cause = "This shot misses all targets, so it must not create a hole or score points. "
        about.cause += "It must only reduce shots_left by 1."
        expect_exactly(got, (0, 0, 9), then="; number of holes, score and shots left")


@pytest.mark.exercise("P4.2b", asks="set bullet to None, and change the wind")
def test_the_wind_changes_when_a_shot_has_landed_and_not_before() -> None:
    about.read = UPDATE
    wind = (3.0, 0.0, -4.0)
    ((_, second),) = winds([1], 1)
    drawn = tuple(second)
    for aim, what in (((0.1, -0.1), "misses"), ((math.atan2(-1.5, 50.0), 0.0035), "hits")):
        about.call = f"range.wind.velocity = Vector3({wind[0]:g}, {wind[1]:g}, {wind[2]:g}); "
        about.call += f"range.shoot({aim[0]:.6g}, {aim[1]:.6g}), which {what}; range.update(1/60) "
        about.call += "until range.bullet is None"
        about.cause = "The wind must stay the same while the bullet is in flight. Call "
        about.cause += "change_wind only after the shot has landed."
        came = play([aim], FRAME, wind=wind)
        blown = [tuple(one) for one in came["winds"]]
        during = [*dict.fromkeys(blown[:-1])]
        expect_exactly(
            during, [wind], then="; the different velocities of the wind during the flight, in m/s"
        )
        about.cause = "You change the wind more than once after a shot. Call change_wind exactly "
        about.cause += "once when a shot ends."
        if blown[-1] == wind:
            about.cause = f"You don't change the wind after this shot, which {what}. Call "
            about.cause += "change_wind after every shot, whether it hits or misses."
        expect_exactly(blown[-1], drawn, then="; range.wind.velocity after the shot, in m/s")


@pytest.mark.exercise("P4.2b", asks="If no bullet is in flight, do nothing")
def test_nothing_acts_on_a_bullet_that_has_landed() -> None:
    about("range = SniperRange(1); range.shoot(0.1, -0.1); bullet = range.bullet; ", read=UPDATE)
    about.call += "range.update(1/60) 20 times"
    about.cause = "After the shot has landed, self.bullet is None. Return at the start of update "
    about.cause += "if no bullet is in flight."
    at = SniperRange(1)
    at.shoot(0.1, -0.1)
    bullet: Any = at.bullet
    for _ in range(20):
        at.update(FRAME)
    expect_exactly(
        at.bullet is None,
        True,
        call="range.bullet is None, after 20 steps of 1/60 s",
        cause="After 8 steps the bullet is below the ground, so the shot has landed. Set "
        "self.bullet to None when a shot lands.",
    )
    about.call += "; range.forces.update_forces(0.5); bullet.force_accumulator, in N"
    about.cause = "The wind still acts on a bullet that has landed. Clear the registered forces "
    about.cause += "when the shot ends."
    at.forces.update_forces(0.5)
    expect_close(xyz(bullet.force_accumulator), (0, 0, 0))
    about.cause = "A bullet that has landed must no longer move. If self.bullet is None, return "
    about.cause += "at the start of update."
    place, wind = xyz(bullet.position), xyz(at.wind.velocity)
    at.update(FRAME)
    expect_unchanged(
        "bullet.position",
        xyz(bullet.position),
        place,
        call="range.update(1/60) after the bullet has landed",
    )
    about.cause = "You change the wind even if no bullet is in flight. If self.bullet is None, "
    about.cause += "return before you change anything."
    got = xyz(at.wind.velocity)
    expect_unchanged(
        "range.wind.velocity", got, wind, call="range.update(1/60) after the bullet has landed"
    )
    about.cause = "The last shot has landed, so the next one can be fired. Set self.bullet to "
    about.cause += "None when a shot lands."
    expect_exactly(at.shoot(0.0, 0.0), True, call="range.shoot(0.0, 0.0)")


@pytest.mark.exercise("P4.2b", asks="in which the player has SHOTS shots")
def test_a_whole_round_is_ten_shots() -> None:
    about.read = UPDATE
    near, far = (math.atan2(-1.5, 50.0), 0.0035), (math.atan2(2.0, 150.0), 0.0103)
    miss = (0.1, -0.1)
    aims = [near, miss, far, miss, far, miss] * 2
    about.call = "range = SniperRange(1), without drag; range.shoot is called 12 times; every "
    about.call += "second shot misses; after each shot, range.update(1/60) until range.bullet is "
    about.call += "None"
    about.cause = "A round has only ten shots, so the last two of these twelve must not be fired."
    came = play(aims, FRAME)
    expect_exactly(came["shots_left"], 0, then="; range.shots_left")
    points = [hole[3] for hole in came["holes"]]
    about.cause = "Each hit must append exactly one hole to the list, in the order of the shots."
    wanted = [10, 30, 30, 10, 30]
    if points == wanted[::-1]:
        about.cause = "Your list starts with the newest hole. Append each new hole at the end."
    expect_exactly(points, wanted, then="; points of each hole in range.holes")
    about.cause = "The score must be the sum of the points of all holes."
    last = "Your score is only the points of the last hit, because each hit replaces the score. "
    blame(came["score"], [(30, f"{last}Add the points of each hit to the score instead.")])
    expect_exactly(came["score"], 110, then="; range.score")
