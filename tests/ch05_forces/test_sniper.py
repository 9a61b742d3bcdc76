"""How a round of the sniper range goes on, without a screen: project 4.2b."""

from __future__ import annotations

import math
from typing import Any

import pytest

from ch05_forces.probes import play
from ch05_forces.sniper import SniperRange
from expect import expect_close, expect_error, expect_exactly, expect_unchanged, xyz

SHOOT = "the docstring of shoot"
UPDATE = "the docstring of update"
FRAME = 1.0 / 60.0


def fallen(frames: float) -> float:
    """Return how far a bullet without drag has fallen after so many frames.

    Explicit Euler falls g h^2 n (n - 1) / 2 in n frames; within a frame the way is straight.
    """
    n = math.floor(frames)
    before, after = (FRAME**2 * k * (k - 1) for k in (n, n + 1))  # g is 2 m/s^2
    return before + (after - before) * (frames - n)


@pytest.mark.exercise("P4.2b")
def test_a_shot_that_hits_makes_a_hole_and_scores() -> None:
    cause = "in each frame: the forces, the step, and then what the way of this frame has hit"
    for x, distance, factor in ((-1.5, 50.0, 1), (2.0, 150.0, 3)):
        azimuth, elevation = math.atan2(x, distance), distance * 0.00007
        level = 120.0 * math.cos(elevation) * math.cos(azimuth)
        y = math.hypot(x, distance) * math.tan(elevation) - fallen(distance / (level * FRAME))
        call = f"range without drag; range.shoot({azimuth!r}, {elevation!r}); range.update(1/60) "
        call += "until it has landed"
        came = play([(azimuth, elevation)], FRAME)
        holes = [tuple(hole) for hole in came["holes"]]
        expect_exactly(f"{call}; how many holes", len(holes), 1, cause=cause, read=UPDATE)
        points = factor * (10 if abs(y) <= 0.1 else 5 if abs(y) <= 0.25 else 2)
        name = f"{call}; distance, x, y and points of the hole"
        # A hundred roundings of positions up to 150 m.
        wanted = (distance, 0.0, y, points)
        expect_close(name, holes[0], wanted, cause=cause, read=UPDATE, tolerance=1e-10)
        cause = "its points are added to the score"
        expect_exactly(f"{call}; range.score", came["score"], points, cause=cause, read=UPDATE)


@pytest.mark.exercise("P4.2b")
def test_the_wind_carries_the_bullet_away() -> None:
    call = "range with a wind of 10 m/s along X; range.shoot(0.0, 0.02); range.update(1/60)"
    cause = "every frame asks the registry for the forces, and then moves the bullet"
    read = UPDATE
    still = play([(0.0, 0.02)], FRAME, wind=(0.0, 0.0, 0.0), k1=0.05)["positions"]
    blown = play([(0.0, 0.02)], FRAME, wind=(10.0, 0.0, 0.0), k1=0.05)["positions"]
    name = f"{call}: frames in flight, and in still air"
    frames = (len(blown), len(still))
    # With k1 alone a cross wind changes nothing along Z, and both pass 210 m in frame 109.
    expect_exactly(name, frames, (109, 109), cause=cause, read=read)
    # x' of the book's step with dv/dt = (w - v) k: in units of w, the velocity is 1 - (1 - k h)^n.
    keep = 1.0 - 0.05 * FRAME
    x = 10.0 * FRAME * (109 - (1.0 - keep**109) / (1.0 - keep))
    wanted = (x, 0.0)
    got = (blown[-1][0], still[-1][0])
    expect_close(f"{call}: x at the end", got, wanted, cause=cause, read=read, tolerance=1e-10)
    z = 120.0 * math.cos(0.02) * FRAME * (1.0 - keep**109) / (1.0 - keep)
    name = f"{call}: z at the end"
    expect_close(name, blown[-1][2], z, cause="drag slows it down", read=read, tolerance=1e-9)


@pytest.mark.exercise("P4.2b")
def test_a_miss_lands_on_the_ground_or_behind_the_range() -> None:
    for (azimuth, elevation), cause in (
        ((0.1, -0.1), "below the ground, y < 0, the shot has landed"),
        ((0.15, 0.19), "past END_OF_RANGE, 210 m, the shot has landed"),
    ):
        call = f"range without drag; range.shoot({azimuth}, {elevation}); range.update(1/60) until "
        call += "it has landed"
        along = 120.0 * math.cos(elevation) * math.cos(azimuth) * FRAME
        rises = 120.0 * math.sin(elevation) * FRAME
        n = 0
        while 1.5 + rises * (n + 1) >= fallen(n + 1) and along * (n + 1) <= 210.0:
            n += 1
        came = play([(azimuth, elevation)], FRAME)
        name = f"{call}; frames in flight"
        expect_exactly(name, len(came["positions"]), n, cause=cause, read=UPDATE)
        name = f"{call}; holes, score and shots left"
        got = (len(came["holes"]), came["score"], came["shots_left"])
        cause = "a miss makes no hole and scores nothing"
        expect_exactly(name, got, (0, 0, 9), cause=cause, read=UPDATE)


@pytest.mark.exercise("P4.2b")
def test_the_wind_changes_when_a_shot_has_landed_and_not_before() -> None:
    read = UPDATE
    wind = (3.0, 0.0, -4.0)
    for aim, what in (((0.1, -0.1), "misses"), ((math.atan2(-1.5, 50.0), 0.0035), "hits")):
        call = f"range.wind.velocity = Vector3{wind}; range.shoot{aim}, which {what}; "
        call += "range.update(1/60)"
        came = play([aim], FRAME, wind=wind)
        winds = [tuple(blown) for blown in came["winds"]]
        cause = "during the flight the wind stays as it is"
        during = [*dict.fromkeys(winds[:-1])]
        expect_exactly(f"{call}; winds during the flight", during, [wind], cause=cause, read=read)
        cause = "a shot that has landed, hit or not, changes the wind: change_wind()"
        same = winds[-1] == wind
        expect_exactly(
            f"{call}; is the wind the same afterwards", same, False, cause=cause, read=read
        )


@pytest.mark.exercise("P4.2b")
def test_nothing_acts_on_a_bullet_that_has_landed() -> None:
    call = (
        "range = SniperRange(1); range.shoot(0.1, -0.1); bullet = range.bullet; range.update(1/60) "
    )
    call += "20 times; range.forces.update_forces(0.5); bullet.force_accumulator"
    cause = "take the bullet and the wind out of the registry: self.forces.remove, or clear"
    at = SniperRange(1)
    at.shoot(0.1, -0.1)
    bullet: Any = at.bullet
    for _ in range(20):
        at.update(FRAME)
    expect_exactly(
        "range.bullet is None, after 20 frames",
        at.bullet is None,
        True,
        cause="y was below 0 after 8 frames",
        read=UPDATE,
    )
    at.forces.update_forces(0.5)
    expect_close(call, xyz(bullet.force_accumulator), (0, 0, 0), cause=cause, read=UPDATE)
    cause = "a bullet that has landed does not move any more"
    place = xyz(bullet.position)
    at.update(FRAME)
    expect_unchanged(
        "range.update(1/60)",
        "bullet.position",
        xyz(bullet.position),
        place,
        cause=cause,
        read=UPDATE,
    )
    cause = "once the shot has landed the next one may be fired"
    expect_exactly("range.shoot(0.0, 0.0)", at.shoot(0.0, 0.0), True, cause=cause, read=UPDATE)


@pytest.mark.exercise("P4.2b")
def test_a_whole_round_is_ten_shots() -> None:
    aims = [(math.atan2(-1.5, 50.0), 0.0035), (0.1, -0.1)] * 6
    call = (
        "twelve times range.shoot() and range.update(1/60) until it has landed, every other a hit"
    )
    came = play(aims, FRAME)
    cause = "ten are fired, the other two are refused"
    expect_exactly(f"{call}; range.shots_left", came["shots_left"], 0, cause=cause, read=UPDATE)
    points = [hole[3] for hole in came["holes"]]
    cause = "each hit has its hole, in the order of the shots, and the score is their sum"
    expect_exactly(f"{call}; points of the holes", points, [10] * 5, cause=cause, read=UPDATE)
    expect_exactly(f"{call}; range.score", came["score"], 50, cause=cause, read=UPDATE)


@pytest.mark.exercise("P4.2b", weight=0.5)
@pytest.mark.parametrize("duration", [0.0, -0.5, math.inf, math.nan, "0.5"])
def test_a_frame_of_the_range_takes_a_positive_and_finite_duration(duration: float) -> None:
    call = f"range.shoot(0.0, 0.1); range.update({duration!r})"
    cause = "positive of arguments.py raises the errors for you, before anything has moved"
    at = SniperRange(1)
    at.shoot(0.0, 0.1)
    bullet: Any = at.bullet
    before = xyz(bullet.position)
    expect_error(
        call,
        lambda: at.update(duration),
        TypeError if isinstance(duration, str) else ValueError,
        allowed=lambda: SniperRange(1).update(0.5),
        cause=cause,
        read=UPDATE,
    )
    expect_unchanged(
        call, "range.bullet.position", xyz(bullet.position), before, cause=cause, read=UPDATE
    )
    got = xyz(bullet.force_accumulator)
    expect_close(
        f"{call}; range.bullet.force_accumulator", got, (0, 0, 0), cause=cause, read=UPDATE
    )
