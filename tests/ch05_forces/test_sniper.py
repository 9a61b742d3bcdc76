"""A round of the sniper range without a screen, project 4.2b."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag
from ch05_forces.probes import play, winds
from ch05_forces.sniper import SniperRange
from draw import Components, Triple
from expect import about, expect_close, expect_exactly, expect_that, expect_unchanged, named, xyz

READ = "the docstring of update"
STEP = 1.0 / 60.0
BEYOND = "Your bullet flies on beyond the range. End the shot as soon as z > END_OF_RANGE."
UNTIL = "game.update(1/60) until game.bullet is None"
NEAR, FAR, MISS = (math.atan2(-1.5, 50.0), 0.0035), (math.atan2(2.0, 150.0), 0.0103), (0.1, -0.1)


def fallen(steps: float) -> float:
    """Return how far a bullet without drag has fallen after this number of steps.

    Explicit Euler falls g h^2 n (n - 1) / 2 in n steps. Within a step the path is straight.
    """
    n = math.floor(steps)
    before, after = (STEP**2 * k * (k - 1) for k in (n, n + 1))  # g is 2 m/s^2
    return before + (after - before) * (steps - n)


def fired(cause: str, aim: tuple[float, float], wind: Components | None = None) -> dict[str, Any]:
    """Fire a shot without drag, and return what ``play`` reports."""
    start = f"game.wind.velocity = Vector3{wind}; " if wind else ""
    shot = "{}game.shoot(azimuth={:.6g}, elevation={:.6g})".format(start, *aim)
    with calls(cause, f"game = SniperRange(1), without drag; {shot}; {UNTIL}"):
        return play([aim], STEP, wind=wind)


@pytest.mark.exercise("P4.2b", asks="add the hole to holes and its points to the score", read=READ)
def test_a_shot_that_hits_makes_a_hole_and_scores() -> None:
    for x, distance, factor in ((-1.5, 50.0, 1), (2.0, 150.0, 3)):
        azimuth, elevation = math.atan2(x, distance), distance * 0.00007
        steps = distance / (120.0 * math.cos(elevation) * math.cos(azimuth) * STEP)
        y = math.hypot(x, distance) * math.tan(elevation) - fallen(steps)
        points = factor * (10 if abs(y) <= 0.1 else 5 if abs(y) <= 0.25 else 2)
        came = fired(
            "The bullet flies through a target, but you find no hit. Perhaps start and end are the "
            "same point. Copy the position before you call integrate, which changes it in place. "
            "Call hit_on_the_way after that, with this copy as start, and the new position as end.",
            (azimuth, elevation),
        )
        holes, score = came["holes"], came["score"]
        if holes:
            about(cause="Append exactly one hole when the bullet hits a target.")
        elif score:
            about(cause="You added points to the score but no hole. Append it to self.holes.")
        expect_exactly(len(holes), 1, then="; number of holes in game.holes")
        expect_exactly(
            len(came["positions"]), math.floor(steps), then="; number of steps before the hit",
            cause="A hit ends the shot, so set self.bullet to None after a hit.",
        )  # fmt: skip
        # A hundred roundings of positions up to 150 m.
        expect_close(
            holes[0], (distance, 0.0, y, points), tolerance=1e-10,
            then="; distance of the target, then x, y and points of the hole",
            cause="Append the hole that hit_on_the_way returns for the path of this step.",
        )  # fmt: skip
        cause = "Add hole.points unchanged, because they contain the target's factor."
        counts = "You count the hits instead of their points. Add hole.points to the score."
        cause = named(score, cause, {counts: 1})
        expect_exactly(score, points, then="; game.score", cause=cause)


@pytest.mark.exercise("P4.2b", asks="update the forces, move the bullet", read=READ)
def test_the_wind_carries_the_bullet_away() -> None:
    once = "Call update_forces exactly once in each step, before you integrate the bullet."
    with calls(
        once,
        "two ranges, one with a wind of 10 m/s along X and one without wind; on each, "
        f"game.shoot(0.0, 0.02); {UNTIL}",
    ):
        still, blown = (
            play([(0.0, 0.02)], STEP, wind=(x, 0.0, 0.0), k1=0.05)["positions"] for x in (0.0, 10.0)
        )
    steps, cause = (len(blown), len(still)), once
    if min(steps) > 109:
        cause = BEYOND
    # With k1 alone a cross wind changes nothing along Z, and both pass 210 m in step 109.
    none = "Your bullet flies as if there were no drag. Call update_forces in each step."
    cause = named(steps, cause, {none: (105, 105)})
    then = "; number of steps in flight, with wind and without wind"
    expect_exactly(steps, (109, 109), then=then, cause=cause)
    # x' of the book's step with dv/dt = (w - v) k: in units of w, the velocity is 1 - (1 - k h)^n.
    keep = 1.0 - 0.05 * STEP
    x, before = (10.0 * STEP * (n - (1.0 - keep**n) / (1.0 - keep)) for n in (109, 108))
    got, cause = (blown[-1][0], still[-1][0]), once
    if got[1] != 0.0:
        cause = "Without wind, x must stay 0. Call change_wind only after the shot has ended."
    late = "Your forces act one step too late. Call update_forces before integrate."
    then = "; the bullet's x after its last step in flight, with wind and without wind, in m"
    expect_close(got, (x, 0.0), {late: (before, 0.0)}, then=then, tolerance=1e-10, cause=cause)
    z = 120.0 * math.cos(0.02) * STEP * (1.0 - keep**109) / (1.0 - keep)
    then = "; the bullet's z after its last step in flight, with wind, in m"
    expect_close(blown[-1][2], z, then=then, tolerance=1e-9)


@pytest.mark.exercise("P4.2b", asks="Advance the bullet by duration s", read=READ)
def test_a_step_takes_the_given_duration(rng: Random) -> None:
    h = round(rng.uniform(0.1, 0.3), 3)
    with calls("Pass the duration of update on to update_forces and integrate."):
        game = SniperRange(1)
        game.wind.k1, game.wind.k2, game.wind.velocity = 0.25, 0.0, Vector3(5, 0, 0)
        game.shoot(0.0, 0.1)
        bullet = game.bullet
        game.forces.add(bullet, Drag(0.5, 0.0))
        game.update(h)
    start, v = Triple((0.0, 1.5, 0.0)), Triple((0.0, 120.0 * math.sin(0.1), 120.0 * math.cos(0.1)))
    slips = {f"Your bullet moves for 1/60 s, but this step takes {h} s.": start + v * STEP}
    expect_close(bullet.position, start + v * h, slips, then="; bullet.position", unit="m")
    gained = Triple((0.25 * 5.0, -2.0, 0.0))
    only = "Only the wind acts on your bullet. Apply all forces with self.forces.update_forces."
    slips, wanted = {only: v + (gained - 0.25 * v) * h}, v + (gained - 0.75 * v) * h
    expect_close(bullet.velocity, wanted, slips, then="; bullet.velocity", unit="m/s")


def thrown(cause: str, position: Components, velocity: Components) -> tuple[Any, Any]:
    """Return a range and a bullet that has made one step from here, without forces."""
    shown = f"game.bullet.position = Vector3{position}; game.bullet.velocity = Vector3{velocity}; "
    with calls(cause, f"{shown}no force or gravity acts on the bullet; game.update(0.5)"):
        game = SniperRange(1)
        game.shoot(0.0, 0.0)
        game.forces.clear()
        bullet = game.bullet
        bullet.position, bullet.velocity = Vector3(*position), Vector3(*velocity)
        bullet.acceleration = Vector3()
        game.update(0.5)
    return game, bullet


@pytest.mark.exercise("P4.2b", asks="or beyond END_OF_RANGE in z", read=READ)
def test_a_bullet_exactly_at_the_edge_flies_on() -> None:
    cause = "At y = 0 and z = 210, the shot is not over yet. End it only if y < 0 or z > 210."
    game, bullet = thrown(cause, (20.0, 1.0, 178.0), (0.0, -2.0, 64.0))
    ended = "the shot has ended (game.bullet is None)"
    expect_that(game.bullet is not None, ended, "the bullet is still in flight")
    moves = "The bullet must move by its velocity times the duration. Integrate it once per step."
    then = "; game.bullet.position"
    expect_close(bullet.position, (20, 0, 210), then=then, unit="m", cause=moves)
    cause = "The bullet hits a target and leaves the range in one step. Check for a hit first."
    game, _ = thrown(cause, (5.0, 1.5, 190.0), (0.0, 0.0, 60.0))
    expect_exactly(len(game.holes), 1, then="; number of holes in game.holes")


@pytest.mark.exercise("P4.2b", asks="when the bullet is below the ground", read=READ)
def test_a_miss_lands_on_the_ground_or_behind_the_range() -> None:
    for azimuth, elevation, cause in (
        (*MISS, "Your bullet flies on below the ground. End the shot as soon as y < 0."),
        (0.15, 0.19, BEYOND),
    ):
        along = 120.0 * math.cos(elevation) * math.cos(azimuth) * STEP
        rises = 120.0 * math.sin(elevation) * STEP
        n = 0
        while 1.5 + rises * (n + 1) >= fallen(n + 1) and along * (n + 1) <= 210.0:
            n += 1
        came = fired(cause, (azimuth, elevation))
        expect_exactly(len(came["positions"]), n, then="; number of steps in flight")
        expect_exactly(
            (len(came["holes"]), came["score"], came["shots_left"]), (0, 0, 9),
            then="; number of holes, score and shots left",
            cause="This shot misses all targets, so it must only reduce shots_left by 1.",
        )  # fmt: skip


@pytest.mark.exercise("P4.2b", asks="set bullet to None, and change the wind", read=READ)
def test_the_wind_changes_when_a_shot_has_landed_and_not_before() -> None:
    wind = (3.0, 0.0, -4.0)
    ((_, second),) = winds([1], 1)
    for aim, what in ((MISS, "misses"), (NEAR, "hits")):
        early = "The wind changes in flight. Call change_wind only after the shot has landed."
        came = fired(early, aim, wind)
        *during, last = map(tuple, came["winds"])
        then = "; the different velocities of the wind during the flight, in m/s"
        expect_exactly([*dict.fromkeys(during)], [wind], then=then)
        cause = "You change the wind more than once. Call change_wind once when a shot ends."
        if last == wind:
            cause = f"You don't change the wind after a shot that {what}. Call change_wind then."
        then = "; game.wind.velocity after the shot, in m/s"
        expect_exactly(last, tuple(second), then=then, cause=cause)


@pytest.mark.exercise("P4.2b", asks="If no bullet is in flight, do nothing", read=READ)
def test_nothing_acts_on_a_bullet_that_has_landed() -> None:
    with calls(
        "Return at the start of update if no bullet is in flight (self.bullet is None).",
        "game = SniperRange(1); game.shoot(0.1, -0.1); bullet = game.bullet; "
        "game.update(1/60) 20 times",
    ):
        game = SniperRange(1)
        game.shoot(*MISS)
        bullet = game.bullet
        for _ in range(20):
            game.update(STEP)
    cause = "The bullet is below the ground. Set self.bullet to None when a shot lands."
    expect_exactly(game.bullet is None, True, then="; game.bullet is None", cause=cause)
    with calls("The wind still acts on the bullet. Clear the forces after the shot.", more=True):
        game.forces.update_forces(0.5)
        got = bullet.force_accumulator
    expect_close(got, (0, 0, 0), unit="N")
    place, wind = xyz(bullet.position), xyz(game.wind.velocity)
    with calls("Return at the start of update if self.bullet is None.", more=True):
        game.update(STEP)
    expect_unchanged("bullet.position", bullet.position, place)
    expect_unchanged("game.wind.velocity", game.wind.velocity, wind)
    with calls("The next shot can be fired. Set self.bullet to None after a landing.", more=True):
        again = game.shoot(0.0, 0.0)
    expect_exactly(again, True)


@pytest.mark.exercise("P4.2b", asks="in which the player has SHOTS shots", read=READ)
def test_a_whole_round_is_ten_shots() -> None:
    with calls(
        "A round has only ten shots, so the last two of these twelve must not be fired.",
        "game = SniperRange(1), without drag; game.shoot is called 12 times; every second shot "
        f"misses; after each shot, {UNTIL}",
    ):
        came = play([NEAR, MISS, FAR, MISS, FAR, MISS] * 2, STEP)
    expect_exactly(came["shots_left"], 0, then="; game.shots_left")
    points, wanted = [hole[3] for hole in came["holes"]], [10, 30, 30, 10, 30]
    cause = "Each hit must append exactly one hole to the list, in the order of the shots."
    if points == wanted[::-1]:
        cause = "Your list starts with the newest hole. Append each new hole at the end."
    expect_exactly(points, wanted, then="; points of each hole in game.holes", cause=cause)
    cause = "Add the points of each hit to the score."
    last = "Your score is only the points of the last hit, because each hit replaces the score."
    cause = named(came["score"], cause, {last: 30})
    expect_exactly(came["score"], 110, then="; game.score", cause=cause)
