"""Project 8.1, a ball game on the bridge: its rules and its play."""

from __future__ import annotations

from random import Random

import pytest

from ch08_mass_aggregate.scene_probes import landing, played, refused_row, ruled
from draw import positive_number
from expect import about, blame, expect_close, expect_exactly, expect_that

RULES = "the docstrings of Rules, landed and fell"
LANDINGS = "the docstrings of Landings and Landings.contacts"
STEP = "the docstring of BallGame.step"
FRAME = 1.0 / 60.0
FIRST = -5.0  # m, the position of the first row


@pytest.mark.exercise("P8.1a")
def test_a_row_counts_once(rng: Random) -> None:
    rows = rng.randint(5, 9)
    a, b = rng.sample(range(1, rows - 1), 2)  # other checks have the first and the last row
    events = [a, a, b, a, b]
    about(
        f"rules = Rules({rows}); rules.landed(row) for each row in {events}; the score after each "
        "call",
        read=RULES,
    )
    about.cause = (
        "The first landing on a row scores POINTS, which is 10, and later landings on the same row "
        "score nothing. Check self.visited before you add points."
    )
    seen = ruled(rows, events)
    got = [score for score, *_ in seen]
    mistakes = [
        ([10, 20, 30, 40, 50], "Every landing scores, even on a row that the ball has visited "
                               "before. A row scores only once, so check first whether it is "
                               "already in visited."),
        ([160] * 5, "Your game already counts as won after the first landing, so it adds the "
                    "bonus. It is won only when every row has been visited."),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_exactly(got, [10, 10, 20, 20, 20])
    about.call = (
        f"rules = Rules({rows}); rules.landed(row) for each row in {events}; rules.visited (as a "
        "list) and then rules.lives"
    )
    about.cause = (
        "Each landing should add its row to visited. Only a fall costs a life, so leave lives "
        "alone."
    )
    expect_exactly(seen[-1][2], sorted((a, b)))
    expect_exactly(seen[-1][1], 3)


@pytest.mark.exercise("P8.1a")
def test_all_rows_win_and_lives_are_a_bonus(rng: Random) -> None:
    rows, falls = rng.randint(3, 6), 1  # two lives are left, so neither one nor all
    order = rng.sample(range(rows), rows)
    events = [*order[:1], *([-1] * falls), *order[1:], order[0], -1]
    about(
        f"rules = Rules({rows}); for each row in {events}, rules.landed(row), or rules.fell() if "
        "row is -1",
        read=RULES,
    )
    about.cause = (
        "Every row from 0 to rows - 1 is valid and scores POINTS. The row that is visited last "
        "also wins the game, so add BONUS, which is 50, for each life that is left."
    )
    seen = ruled(rows, events)
    won = seen[rows + falls - 1]
    score = 10 * rows + 50 * (3 - falls)
    points = 10 * rows
    missing = (
        "You leave out the bonus. When a landing visits the last row, add BONUS for each life that "
        "is left."
    )
    if won[0] == points and ruled(rows, order)[-1][0] != points:
        missing = (
            "Your game is not won when all rows have been visited, because an earlier fall removed "
            "rows from visited. A fall must not change visited."
        )
    mistakes = [
        (points, missing),
        (points + 50, "You add the bonus only once. Multiply BONUS, which is 50, by the number of "
                      "lives that are left."),
        (points + 150, "You add the bonus for all three lives, although one of them is lost. "
                       "Multiply BONUS by the number of lives that are left."),
        (score - 10, "Your score is 10 points too low. Check that the last row earns its POINTS as "
                     "well as the bonus, that the game isn't won one row too early, and that a "
                     "fall costs no points."),
    ]  # fmt: skip
    blame(won[0], mistakes)
    expect_exactly(won[0], score, then="; the score once all rows are visited", unit="points")
    name = f"rules = Rules({rows}); landings on the rows {events}, where -1 is a fall; "
    name += "rules.won and rules.over once all rows are visited"
    over = (
        "Your over misses one of the two ways in which the game can end. Check both: every row has "
        "been visited, or no lives are left."
    )
    expect_exactly(list(won[3:]), [True, True], call=name, cause=over)
    before = seen[rows + falls - 2]
    about.cause = (
        "You add points before the last row has been visited. Add the bonus only when self.won is "
        "true."
    )
    expect_exactly(before[0], 10 * (rows - 1), then="; the score before the last row is visited")
    about.cause = (
        "A landing or fall still counts after the game is over. Check self.over first, in both "
        "landed and fell."
    )
    got = list(seen[-1][:2])
    expect_exactly(got, [score, 3 - falls], then="; the score and the lives at the end")


@pytest.mark.exercise("P8.1a")
def test_three_falls_are_the_end(rng: Random) -> None:
    a, b = rng.sample(range(1, 5), 2)
    events = [-1, a, -1, -1, -1, b]
    about(
        f"rules = Rules(6); for each row in {events}, a landing on that row, or rules.fell() if it "
        "is -1",
        read=RULES,
    )
    about.cause = (
        "A fall costs exactly one life. The game is over when no lives are left, so later falls "
        "leave lives at 0."
    )
    seen = ruled(6, events)
    got = [lives for _, lives, *_ in seen]
    expect_exactly(got, [2, 2, 1, 0, 0, 0], then="; the lives after each call")
    got = [over for *_, over in seen]
    wanted = [False, False, False, True, True, True]
    expect_exactly(
        got,
        wanted,
        call=f"rules = Rules(6), then landings on the rows {events}, where -1 is a fall; "
        "rules.over after each call",
    )
    about.cause = "A fall costs a life, but it must not change the score or the visited rows."
    got = [seen[-1][0], *seen[-1][2]]
    if got[0] == 20:
        about.cause = (
            "Your game counts a landing after it is over. Return from landed at once if self.over "
            "is true."
        )
    expect_exactly(got, [10, a], then="; the score, followed by the visited rows, at the end")


@pytest.mark.exercise("P8.1a")
@pytest.mark.robust
def test_a_row_that_there_is_not_is_refused(rng: Random) -> None:
    about.read = RULES
    rows = rng.randint(3, 6)
    about.cause = (
        "There is no row with this number. Rows are numbered from 0 to rows - 1, so raise "
        "ValueError for any other number."
    )
    for row in (rows, -1):
        about.call = f"Rules({rows}).landed({row}): the error that it raises"
        error, *after = refused_row(rows, row)
        expect_exactly(error, "ValueError")
        name = f"Rules({rows}).landed({row}): the score and the visited rows afterward"
        expect_exactly(
            after,
            [0, []],
            call=name,
            cause="The call raises an error, but only after it has changed the score or the "
            "visited rows. Check the row before you change anything.",
        )
    about.cause = "This row exists, so landed should accept it. Both 0 and rows - 1 are valid."
    for row in (0, rows - 1):
        about.call = f"Rules({rows}).landed({row}): the error that it raises"
        expect_exactly(refused_row(rows, row)[0], "no error")


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
         "The ball is moving down slowly, but it still lands. Count any negative separating "
         "velocity as a landing, without a minimum speed."),
        ("that touches the deck and moves up", before, 4.5 - depth, speed, (2, -1),
         "The ball touches the deck but is moving up, so this is not a landing. Set row to None "
         "unless the separating velocity is negative."),
        ("that touches the deck and is at rest", before, 4.5 - depth, 0.0, (2, -1),
         "The ball touches the deck but is at rest, so this is not a landing. Set row only if the "
         "separating velocity is below 0, which it is not here."),
        ("that falls, but is still above the deck", before, 4.5 + depth, -speed, (0, -1),
         "The ball doesn't touch the deck, so it hasn't landed. Set row to None when there is no "
         "contact."),
    ):  # fmt: skip
        about.cause = cause
        about.call = (
            f"a ball at x = {x:g} m {what}; landings.contacts(); the number of contacts, and "
            "landings.row (-1 stands for None)"
        )
        count, first, later = landing(height, velocity, x)
        got = (count, -1 if first is None else first)
        if not count and wanted[0]:
            about.cause = (
                "Your contacts() returns no contacts, so the ball falls through the bridge. Return "
                "the contacts that self.deck.contacts() finds."
            )
        expect_close(got, wanted, tolerance=0.0)
        about.call = (
            f"a ball at x = {x:g} m {what}; landings.contacts(); the ball is moved far above the "
            "deck; landings.contacts()"
        )
        about.cause = (
            "You keep the row of the earlier landing. Set row in every call of contacts(), and set "
            "it to None if the ball doesn't touch the deck."
        )
        expect_that(later is None, f"landings.row is {later}", "landings.row is None")


@pytest.mark.exercise("P8.1b")
@pytest.mark.parametrize("direction", [-1, 0, 1])
def test_a_ball_is_steered(rng: Random, direction: int) -> None:
    about.read = STEP
    x, speed = round(rng.uniform(-3.0, 3.0), 3), round(rng.uniform(-2.0, 2.0), 3)
    frame, mass = round(rng.uniform(0.005, 0.03), 4), positive_number(rng)
    damped = 0.6**frame
    about.call = (
        f"a game with game.direction = {direction}; its ball of {mass} kg is at ({x}, 9, 0) m and "
        f"moves at ({speed}, 0, 0) m/s; three calls of game.step({frame}); the velocity of the "
        "ball"
    )
    about.cause = (
        "The player pushes the ball along X with the force direction * PUSH * mass. Add it "
        "between start_frame and run_physics, and pass the duration to run_physics."
    )
    vx, vy = speed, 0.0
    free, weak = speed, speed
    for _ in range(3):
        free = free * damped
        weak = (weak + 8.0 * direction / mass * frame) * damped
        vx, vy = (vx + 8.0 * direction * frame) * damped, (vy - 9.81 * frame) * damped
    seen = played(3, frame, direction, (x, 9.0, 0.0), (speed, 0.0, 0.0), mass=mass)
    got = seen[-1]["velocity"]
    if direction:
        mistakes = [
            ((free, vy, 0.0), "The push has no effect, probably because you add it before "
                              "start_frame, which clears the forces. Add it after start_frame and "
                              "before run_physics."),
            ((weak, vy, 0.0), "You leave the mass out of the push. PUSH is an acceleration in "
                              "m/s^2, so the force is PUSH * mass."),
        ]  # fmt: skip
        blame(got, mistakes)
    expect_close(got, (vx, vy, 0.0), unit="m/s", tolerance=1e-12)


@pytest.mark.exercise("P8.1b")
def test_a_ball_jumps_from_where_it_lands(rng: Random) -> None:
    about.read = STEP
    for row in (rng.randint(1, 4), 0):
        x = FIRST + 2.0 * row
        about.call = (
            f"a game in which the ball is 0.05 m above row {row} and falls at 6 m/s; "
            "game.step(1/60), in which the ball lands; its velocity along Y in m/s, the score, and "
            "then each visited row"
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
                "The landing scores, but the ball doesn't jump. Set its velocity along Y to JUMP, "
                "which is 6 m/s."
            )
        elif row == 0:
            about.cause = (
                "The ball lands on row 0, but you ignore that landing, because `if row` is false "
                "for row 0. Write `if row is not None` instead."
            )
        expect_close(got, (6.0, 10.0, float(row)), tolerance=1e-12)
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
        "The ball has reached the ground. Call self.rules.fell() to take a life, and put the ball "
        "back above the first row."
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
    got = seen["place"] + seen["velocity"]
    place = (FIRST, 6.0, 0.0, 0.0, 0.0, 0.0)
    # The cables, too short at first, have pulled the row inward by 0.13 m in that step.
    expect_close(
        got, place, then="; the position (m) and then the velocity (m/s) of the ball", tolerance=0.2
    )
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
        "No lives are left, so the game is over. Don't put the ball back after this fall, and in "
        "later steps return at once if self.rules.over is true."
    )
    seen = played(3, FRAME, 1, (x, 0.6, 0.0), (3.0, -9.0, 0.0), lives=1)
    expect_exactly(seen[-1]["lives"], 0, then="; the lives that are left", unit="lives")
    expect_close(
        seen[-1]["place"],
        seen[0]["place"],
        then="; the position of the ball in m, which should be the same as after the first step",
        tolerance=0.0,
    )
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
