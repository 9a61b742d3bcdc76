"""Project 8.1b, a ball game on the bridge: its play."""

from __future__ import annotations

from random import Random

import pytest

from ch08_mass_aggregate.scene_probes import landing, played
from draw import positive_number
from expect import about, blame, expect_close, expect_exactly, expect_that

LANDINGS = "the docstrings of Landings and Landings.contacts"
STEP = "the docstring of BallGame.step"
FRAME = 1.0 / 60.0
FIRST = -5.0  # m, the position of the first row


@pytest.mark.exercise("P8.1b")
def test_a_landing_is_seen_on_the_way_down(rng: Random) -> None:
    about.read = LANDINGS
    row = rng.randint(1, 4)
    before, beyond = FIRST + 2.0 * row - 0.5, FIRST + 2.0 * row + 0.5  # row is nearest to both
    depth, speed = round(rng.uniform(0.01, 0.2), 3), round(rng.uniform(2.0, 9.0), 3)
    named = (
        "The ball moves down and touches the deck, so it lands. Set row to the row that "
        "deck.nearest() returns."
    )
    for what, x, height, velocity, wanted, cause in (
        ("that touches the deck and falls", before, 4.5 - depth, -speed, (2, row), named),
        ("that touches the deck and falls slowly", beyond, 4.5 - depth, -0.01, (2, row),
         "You ignore the landing of a ball that is moving down slowly. Count every negative "
         "separating velocity as a landing, without a minimum speed."),
        ("that touches the deck and moves up", before, 4.5 - depth, speed, (2, -1),
         "You set row although the ball is moving up, so this is not a landing. Set row only if "
         "the separating velocity is negative."),
        ("that touches the deck and is at rest", before, 4.5 - depth, 0.0, (2, -1),
         "You set row although the ball is at rest, so this is not a landing. Set row only if the "
         "separating velocity is less than 0."),
        ("that falls, but is still above the deck", before, 4.5 + depth, -speed, (0, -1),
         "You set row although the ball doesn't touch the deck. Set row to None if there is no "
         "contact."),
    ):  # fmt: skip
        about.cause = cause
        about.call = (
            f"a ball at x = {x:g} m {what}; landings.contacts(); the number of contacts, and "
            "landings.row"
        )
        count, first, later = landing(height, velocity, x)
        got = (count, -1 if first is None else first)
        if not count and wanted[0]:
            about.cause = (
                "Your contacts() returns no contacts, so the ball falls through the bridge. Return "
                "the contacts that self.deck.contacts() finds."
            )
        shown = [f"{n} contacts, row {None if at < 0 else at}" for n, at in (got, wanted)]
        expect_that(got == wanted, *shown)
        expect_close(got, wanted, tolerance=0.0)  # which refuses a row that is not a number
        about.call = (
            f"a ball at x = {x:g} m {what}; landings.contacts(); the ball is moved far above the "
            "deck; landings.contacts()"
        )
        about.cause = (
            "Your row keeps its value from the earlier landing. Set it to None in every call of "
            "contacts() in which the ball doesn't land."
        )
        if later == row == landing(4.5 + depth, -speed, before)[1]:
            about.cause = (
                "You set row although the ball doesn't touch the deck. Set it to None if "
                "self.deck.contacts() finds no contacts."
            )
        expect_that(later is None, f"landings.row is {later}", "landings.row is None")


@pytest.mark.exercise("P8.1b")
@pytest.mark.parametrize("direction", [-1, 0, 1])
def test_a_ball_is_steered(rng: Random, direction: int) -> None:
    about.read = STEP
    x, speed = round(rng.uniform(-3.0, 3.0), 3), round(rng.uniform(-2.0, 2.0), 3)
    frame, mass = round(rng.uniform(0.005, 0.03), 4), positive_number(rng)
    about.call = (
        f"a game with game.direction = {direction}; its ball of {mass} kg is at ({x}, 9, 0) m and "
        f"moves at ({speed}, 0, 0) m/s; three calls of game.step({frame}); the velocity of the "
        "ball"
    )
    about.cause = (
        "The player doesn't push the ball as expected. Between start_frame and run_physics, add a "
        "force of direction * PUSH * mass along X."
    )

    def moved(push: float, h: float = frame) -> tuple[float, float, float]:
        """Return the velocity after three steps with an acceleration along X."""
        vx, vy, keep = speed, 0.0, 0.6**h
        for _ in range(3):
            vx, vy = (vx + push * h) * keep, (vy - 9.81 * h) * keep
        return vx, vy, 0.0

    wanted = moved(8.0 * direction)
    seen = played(3, frame, direction, (x, 9.0, 0.0), (speed, 0.0, 0.0), mass=mass)
    got = seen[-1]["velocity"]
    mistakes = [
        (moved(8.0 * direction, FRAME), f"Your step lasts 1/60 s instead of {frame} s. Pass the "
                                        "duration to run_physics."),
    ]  # fmt: skip
    if direction:
        mistakes += [
            (moved(0.0), "The push has no effect. Add it after start_frame, which clears all "
                         "forces, and before run_physics."),
            (moved(8.0 * direction / mass), "You leave the mass out of the push. PUSH is an "
                                            "acceleration in m/s^2, so the force is PUSH * mass."),
            ((8.0 * direction * 0.6**frame, wanted[1], 0.0),
             "You set the velocity of the ball to direction * PUSH. PUSH is an acceleration, so "
             "add a force of direction * PUSH * mass."),
        ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, wanted, unit="m/s", tolerance=1e-12)


@pytest.mark.exercise("P8.1b")
def test_a_ball_jumps_from_where_it_lands(rng: Random) -> None:
    about.read = STEP
    for row in (rng.randint(1, 4), 0):
        x = FIRST + 2.0 * row
        about.call = (
            f"a game in which the ball is 0.05 m above row {row} and falls at 6 m/s; "
            "game.step(1/60), in which the ball lands"
        )
        about.cause = (
            "After run_physics, check landings.row. If it is not None, call self.rules.landed(row) "
            "and set the ball's vertical velocity to JUMP."
        )
        seen = played(1, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0))[-1]
        got = (seen["velocity"][1], seen["score"], *seen["visited"])
        if got[:2] == (6.0, 0):
            about.cause = (
                "The ball jumps, but the landing doesn't score. Call self.rules.landed(row) when "
                "landings.row is not None."
            )
        elif got[1:] == (10, row):
            about.cause = (
                "The landing scores, but the ball doesn't jump. Set the ball's velocity along Y to "
                "JUMP, which is 6 m/s."
            )
        elif row == 0:
            about.cause = (
                "The ball lands on row 0, but you ignore that landing, because `if row` is false "
                "for row 0. Write `if row is not None` instead."
            )
        upward = "; the velocity of the ball along Y"
        expect_close(got[0], 6.0, then=upward, unit="m/s", tolerance=1e-12)
        expect_close(got[1], 10.0, then="; the score", unit="points", tolerance=1e-12)
        expect_close(got[2:], [row], then="; the visited rows", tolerance=1e-12)
    about.call = (
        f"a game in which the ball is 0.05 m above row {row} and falls at 6 m/s; 20 calls of "
        "game.step(1/60); the score and the lives"
    )
    about.cause = (
        "The ball should land once and then rise, without landing again or costing a life during "
        "these steps. Check that landings.row is None while the ball moves up."
    )
    seen = played(20, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0))[-1]
    got = (seen["score"], seen["lives"])
    expect_close(got, (10.0, 3.0), tolerance=0.0)
    about.call = (
        f"a game in which row {row} was visited before, and the ball falls at 6 m/s, 0.05 m above "
        "it; game.step(1/60); the velocity of the ball along Y in m/s, and the score"
    )
    about.cause = (
        "The ball jumps from every row on which it lands. A row that was visited before scores "
        "nothing, but the ball still jumps from it."
    )
    seen = played(1, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0), visited=[row])[-1]
    got = (seen["velocity"][1], seen["score"])
    expect_close(got, (6.0, 0.0), tolerance=1e-12)


@pytest.mark.exercise("P8.1b")
def test_the_ground_takes_a_life(rng: Random) -> None:
    about.read = STEP
    x = round(rng.uniform(8.0, 9.0), 3)
    about.call = (
        f"a game; the ball is beside the bridge, at ({x}, 0.6, 0) m, and falls at 9 m/s; "
        "game.step(1/60)"
    )
    about.cause = (
        "The ball reaches the ground without losing a life. Call self.rules.fell() to take a life."
    )
    seen = played(1, FRAME, 1, (x, 0.6, 0.0), (3.0, -9.0, 0.0), visited=[2, 4])[-1]
    expect_exactly(seen["lives"], 2, then="; the lives that are left", unit="lives")
    kept = (
        "A fall changes the visited rows in your game. It should only cost a life, so leave "
        "visited as it is."
    )
    expect_exactly(
        seen["visited"], [2, 4], then="; the visited rows, which were 2 and 4", cause=kept
    )
    about.cause = (
        "The fall costs a life, but the ball stays on the ground. After the fall, put the ball "
        "back at rest above the first row."
    )
    # The cables, too short at first, have pulled the row inward by 0.13 m in that step.
    place, still = (FIRST, 6.0, 0.0), (0.0, 0.0, 0.0)
    expect_close(seen["place"], place, then="; the position of the ball, in m", tolerance=0.2)
    expect_close(seen["velocity"], still, then="; the velocity of the ball, in m/s", tolerance=0.2)
    about.cause = (
        "The ball has fallen if its lowest point is at most TOUCH, which is 1e-6 m, above the "
        "ground. That point is one radius below the ball's center."
    )
    for above, lives in ((5e-7, 2), (5e-6, 3)):
        about.call = (
            f"a game in which the ball is beside the bridge, and its lowest point is {above} m "
            "above the ground at the end of game.step(1/60); the lives that are left"
        )
        # In one step gravity takes exactly its upward speed, so it stays where it is.
        seen = played(1, FRAME, 0, (x, 0.5 + above, 0.0), (0.0, 9.81 * FRAME, 0.0))[-1]
        expect_exactly(seen["lives"], lives, unit="lives")
    about.call = (
        f"a game with one life left; the ball is at ({x}, 0.6, 0) m and falls at 9 m/s; "
        "three calls of game.step(1/60)"
    )
    about.cause = (
        "No lives are left, but your ball still moves in later steps. Return from step at once if "
        "self.rules.over is true."
    )
    seen = played(3, FRAME, 1, (x, 0.6, 0.0), (3.0, -9.0, 0.0), lives=1)
    expect_exactly(seen[-1]["lives"], 0, then="; the lives that are left", unit="lives")
    expect_close(
        seen[-1]["place"],
        seen[0]["place"],
        then="; the position of the ball in m, which should be the same as after the first step",
        tolerance=0.0,
    )
    about.cause = (
        "No lives are left, but you put the ball back above the first row. Don't move it after "
    )
    about.cause += "the last life is lost."
    x = seen[-1]["place"][0]
    expect_that(x > 7.0, f"the ball is at x = {x:.3g} m", "the ball is still beside the bridge")


@pytest.mark.exercise("P8.1b")
def test_the_last_row_ends_the_game(rng: Random) -> None:
    about.read = STEP
    row = rng.randint(1, 4)
    visited = [i for i in range(6) if i != row]
    x = FIRST + 2.0 * row
    about.call = (
        f"a game in which all rows but {row} are visited, and the ball falls on row {row} at 6 m/s "
        "from 0.05 m above; three calls of game.step(1/60)"
    )
    about.cause = (
        "The first step wins the game and adds POINTS and the bonus. After that the game is over, "
        "so step must not change the score or move the ball."
    )
    seen = played(3, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0), visited=visited)
    scores = [frame["score"] for frame in seen]
    expect_exactly(scores, [160] * 3, then="; the score after each step")
    expect_close(
        seen[-1]["place"],
        seen[0]["place"],
        then="; the position of the ball in m, which should be the same as after the first step",
        tolerance=0.0,
    )
