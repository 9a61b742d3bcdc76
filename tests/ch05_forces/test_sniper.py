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
from expect import about, blame, expect_close, expect_error, expect_exactly, expect_unchanged, xyz

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


@pytest.mark.exercise("P4.2b")
def test_a_shot_that_hits_makes_a_hole_and_scores() -> None:
    about.read = UPDATE
    about.cause = "In each step, copy the position, update the forces and integrate. Then check "
    about.cause += "which target was hit on the path from the copy to the new position."
    for x, distance, factor in ((-1.5, 50.0, 1), (2.0, 150.0, 3)):
        azimuth, elevation = math.atan2(x, distance), distance * 0.00007
        level = 120.0 * math.cos(elevation) * math.cos(azimuth)
        y = math.hypot(x, distance) * math.tan(elevation) - fallen(distance / (level * FRAME))
        about.call = f"range without drag; range.shoot({azimuth!r}, {elevation!r}); "
        about.call += "range.update(1/60) until it has landed"
        came = play([(azimuth, elevation)], FRAME)
        holes = [tuple(hole) for hole in came["holes"]]
        expect_exactly(len(holes), 1, then="; number of holes")
        frames = math.floor(distance / (level * FRAME))
        about.cause = "Your bullet flies on after it has hit a target. The target stops it, so set "
        about.cause += "self.bullet to None."
        expect_exactly(len(came["positions"]), frames, then="; steps in flight before")
        points = factor * (10 if abs(y) <= 0.1 else 5 if abs(y) <= 0.25 else 2)
        # A hundred roundings of positions up to 150 m.
        wanted = (distance, 0.0, y, points)
        expect_close(
            holes[0], wanted, then="; distance, x, y and points of the hole", tolerance=1e-10
        )
        about.cause = "Add the points of the hole to the score. Don't multiply them again, "
        expect_exactly(came["score"], points, then="; range.score")


@pytest.mark.exercise("P4.2b")
def test_the_wind_carries_the_bullet_away() -> None:
    about.call = "range with a wind of 10 m/s along X; range.shoot(0.0, 0.02); range.update(1/60)"
    once = "In each step, update the forces exactly once, and then integrate."
    about(
        cause=f"{once} The shot has landed once z is larger than END_OF_RANGE, 210 m.", read=UPDATE
    )
    still = play([(0.0, 0.02)], FRAME, wind=(0.0, 0.0, 0.0), k1=0.05)["positions"]
    blown = play([(0.0, 0.02)], FRAME, wind=(10.0, 0.0, 0.0), k1=0.05)["positions"]
    frames = (len(blown), len(still))
    # With k1 alone a cross wind changes nothing along Z, and both pass 210 m in step 109.
    blame(
        frames,
        {
            "This is how long the flight takes without drag. Update the forces in each step before "
            "you integrate.": (105, 105)
        },
    )
    expect_exactly(frames, (109, 109), then=": steps in flight, and in still air")
    # x' of the book's step with dv/dt = (w - v) k: in units of w, the velocity is 1 - (1 - k h)^n.
    keep = 1.0 - 0.05 * FRAME
    x = 10.0 * FRAME * (109 - (1.0 - keep**109) / (1.0 - keep))
    wanted = (x, 0.0)
    got = (blown[-1][0], still[-1][0])
    about.cause = once
    if got[1] != 0.0:
        about.cause = "The bullet drifted to the side even though there was no wind. Change the "
        about.cause += "wind only after the shot has landed."
    expect_close(got, wanted, then=": x at the end, and in still air", tolerance=1e-10)
    z = 120.0 * math.cos(0.02) * FRAME * (1.0 - keep**109) / (1.0 - keep)
    about.cause = "Drag must slow the bullet down. Call update_forces with the duration before "
    about.cause += "each integration."
    expect_close(blown[-1][2], z, then=": z at the end", tolerance=1e-9)


@pytest.mark.exercise("P4.2b")
def test_a_frame_lasts_as_long_as_it_is_told(rng: Random) -> None:
    about.read = UPDATE
    h = round(rng.uniform(0.1, 0.3), 3)
    about.call = "range.wind.velocity = Vector3(5, 0, 0); range.shoot(0.0, 0.1); a Drag(0.5, 0.0) "
    about.call += f"of the bullet added to range.forces; range.update({h})"
    about.cause = "A step must take exactly the given duration. Pass it to both update_forces and "
    about.cause += "integrate, and let all registered forces act."
    at = SniperRange(1)
    at.wind.k1, at.wind.k2, at.wind.velocity = 0.25, 0.0, Vector3(5, 0, 0)
    at.shoot(0.0, 0.1)
    bullet: Any = at.bullet
    at.forces.add(bullet, Drag(0.5, 0.0))
    v = (0.0, 120.0 * math.sin(0.1), 120.0 * math.cos(0.1))
    at.update(h)
    wanted = tuple((0.0, 1.5, 0.0)[i] + v[i] * h for i in range(3))
    got = xyz(bullet.position)
    expect_close(got, wanted, then="; the position")
    gained = (0.25 * 5.0, -2.0, 0.0)
    wanted = tuple(v[i] + (gained[i] - 0.75 * v[i]) * h for i in range(3))
    got = xyz(bullet.velocity)
    windy = tuple(v[i] + (gained[i] - 0.25 * v[i]) * h for i in range(3))
    only = "Only the wind acted on the bullet. Call update_forces of the registry, so that the "
    blame(got, [(windy, f"{only}Drag that the check added acts too.")])
    expect_close(got, wanted, then="; the velocity")


@pytest.mark.exercise("P4.2b")
def test_what_is_exactly_at_the_edge_flies_on() -> None:
    about("a bullet without forces from (20, 1, 178) with (0, -2, 64) m/s; ", read=UPDATE)
    about.call += "range.update(0.5): the bullet is at (20, 0, 210); range.bullet is None"
    about.cause = "This bullet is exactly at the edge, so it is still in flight. A shot has landed "
    about.cause += "if y < 0 or z > 210, with no equals sign."
    at = SniperRange(1)
    bullet = thrown(at, (20.0, 1.0, 178.0), (0.0, -2.0, 64.0))
    at.update(0.5)
    expect_exactly(at.bullet is None, False)
    got = xyz(bullet.position)
    expect_close(got, (20, 0, 210), then="; its position")
    about.call = "a bullet without forces from (5, 1.5, 190) with (0, 0, 60) m/s; "
    about.call += "range.update(0.5): it passes the target at 200 m and ends at 220 m; number of "
    about.call += "holes"
    about.cause = "In this step the bullet hits a target and also leaves the range. Check for a "
    about.cause += "hit before you check for the end of the range."
    at = SniperRange(1)
    thrown(at, (5.0, 1.5, 190.0), (0.0, 0.0, 60.0))
    at.update(0.5)
    expect_exactly(len(at.holes), 1)


@pytest.mark.exercise("P4.2b")
def test_a_miss_lands_on_the_ground_or_behind_the_range() -> None:
    about.read = UPDATE
    for (azimuth, elevation), cause in (
        (
            (0.1, -0.1),
            "Once y < 0, the bullet is below the ground, so the shot has landed.",
        ),
        (
            (0.15, 0.19),
            "Once z is larger than END_OF_RANGE, which is 210 m, the bullet has left the range, "
            "so the shot has landed.",
        ),
    ):
        about.cause = cause
        about.call = f"range without drag; range.shoot({azimuth}, {elevation}); range.update(1/60) "
        about.call += "until it has landed"
        along = 120.0 * math.cos(elevation) * math.cos(azimuth) * FRAME
        rises = 120.0 * math.sin(elevation) * FRAME
        n = 0
        while 1.5 + rises * (n + 1) >= fallen(n + 1) and along * (n + 1) <= 210.0:
            n += 1
        came = play([(azimuth, elevation)], FRAME)
        expect_exactly(len(came["positions"]), n, then="; steps in flight")
        got = (len(came["holes"]), came["score"], came["shots_left"])
        about.cause = "This shot has missed, so it must not make a hole or earn points. It only "
        about.cause += "reduces shots_left by 1."
        expect_exactly(got, (0, 0, 9), then="; holes, score and shots left")


@pytest.mark.exercise("P4.2b")
def test_the_wind_changes_when_a_shot_has_landed_and_not_before() -> None:
    about.read = UPDATE
    wind = (3.0, 0.0, -4.0)
    ((_, second),) = winds([1], 1)
    drawn = tuple(second)
    for aim, what in (((0.1, -0.1), "misses"), ((math.atan2(-1.5, 50.0), 0.0035), "hits")):
        about.call = f"range.wind.velocity = Vector3{wind}; range.shoot{aim}, which {what}; "
        about.call += "range.update(1/60)"
        about.cause = "The wind must stay the same throughout the flight. Call change_wind only "
        about.cause += "after the shot has landed."
        came = play([aim], FRAME, wind=wind)
        blown = [tuple(one) for one in came["winds"]]
        during = [*dict.fromkeys(blown[:-1])]
        expect_exactly(during, [wind], then="; winds during the flight")
        about.cause = "After every shot the wind must change exactly once. Call change_wind "
        about.cause += "whether the shot hits or misses."
        expect_exactly(blown[-1], drawn, then="; the wind afterwards")


@pytest.mark.exercise("P4.2b")
def test_nothing_acts_on_a_bullet_that_has_landed() -> None:
    about("range = SniperRange(1); range.shoot(0.1, -0.1); bullet = range.bullet; ", read=UPDATE)
    about.call += "range.update(1/60) 20 times; range.forces.update_forces(0.5); "
    about.call += "bullet.force_accumulator"
    about.cause = "No force may act on a bullet that has landed. Remove the pair of bullet and "
    about.cause += "wind with self.forces.remove, or clear the registry."
    at = SniperRange(1)
    at.shoot(0.1, -0.1)
    bullet: Any = at.bullet
    for _ in range(20):
        at.update(FRAME)
    expect_exactly(
        at.bullet is None,
        True,
        call="range.bullet is None, after 20 steps",
        cause="After 8 steps the bullet is below the ground, so the shot has landed. Set "
        "self.bullet to None at that point.",
    )
    at.forces.update_forces(0.5)
    expect_close(xyz(bullet.force_accumulator), (0, 0, 0))
    about.cause = "A bullet that has landed must no longer move. If no bullet is in flight, return "
    about.cause += "from update early."
    place, wind = xyz(bullet.position), xyz(at.wind.velocity)
    at.update(FRAME)
    expect_unchanged("bullet.position", xyz(bullet.position), place, call="range.update(1/60)")
    about.cause = "The wind has changed even though no bullet is in flight. In that case, update "
    about.cause += "must change nothing."
    got = xyz(at.wind.velocity)
    expect_unchanged("the wind", got, wind, call="range.update(1/60)")
    about.cause = "This shot has landed, so the next one can be fired. Set self.bullet to None "
    about.cause += "when a shot lands."
    expect_exactly(at.shoot(0.0, 0.0), True, call="range.shoot(0.0, 0.0)")


@pytest.mark.exercise("P4.2b")
def test_a_whole_round_is_ten_shots() -> None:
    about.read = UPDATE
    near, far = (math.atan2(-1.5, 50.0), 0.0035), (math.atan2(2.0, 150.0), 0.0103)
    miss = (0.1, -0.1)
    aims = [near, miss, far, miss, far, miss] * 2
    about.call = "twelve times range.shoot() and range.update(1/60) until it has landed, every "
    about.call += "other a hit"
    about.cause = "A round has only ten shots, so the last two of these twelve must not be fired."
    came = play(aims, FRAME)
    expect_exactly(came["shots_left"], 0, then="; range.shots_left")
    points = [hole[3] for hole in came["holes"]]
    about.cause = "Each hit must append exactly one hole, in the order of the shots. The score is "
    about.cause += "the sum of the points of these holes."
    wanted = [10, 30, 30, 10, 30]
    expect_exactly(points, wanted, then="; points of the holes")
    expect_exactly(came["score"], 110, then="; range.score")


@pytest.mark.exercise("P4.2b")
@pytest.mark.robust
@pytest.mark.parametrize("duration", [0.0, -0.5, math.inf, math.nan, "0.5"])
def test_a_frame_of_the_range_takes_a_positive_and_finite_duration(duration: float) -> None:
    about.read = UPDATE
    about.cause = "The duration must be positive and finite. Check it with positive from "
    about.cause += "arguments.py before you move anything."
    error = TypeError if isinstance(duration, str) else ValueError
    about.call = f"range.shoot(0.0, 0.1); range.update({duration!r})"
    flying = SniperRange(1)
    flying.shoot(0.0, 0.1)
    bullet: Any = flying.bullet
    before = xyz(bullet.position)
    for at, call in (
        (flying, f"a bullet is in flight; range.update({duration!r})"),
        (SniperRange(1), f"no bullet is in flight; range.update({duration!r})"),
    ):
        about.call = call
        expect_error(
            lambda at=at: at.update(duration), error, allowed=lambda: SniperRange(1).update(0.5)
        )
    about.call = f"a bullet is in flight; range.update({duration!r})"
    got = xyz(bullet.position)
    expect_unchanged("range.bullet.position", got, before)
    got = xyz(bullet.force_accumulator)
    expect_close(got, (0, 0, 0), then="; its force_accumulator")
