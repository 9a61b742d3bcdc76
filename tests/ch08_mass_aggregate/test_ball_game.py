"""Project 8.1, a ball game over the bridge: its rules, and its play."""

from __future__ import annotations

from random import Random

import pytest

from ch08_mass_aggregate.scene_probes import landing, played, refused_row, ruled
from draw import positive_number
from expect import about, blame, expect_close, expect_exactly

RULES = "the docstrings of Rules, landed and fell"
LANDINGS = "the docstrings of Landings and Landings.contacts"
STEP = "the docstring of BallGame.step"
FRAME = 1.0 / 60.0
FIRST = -5.0  # m, where the first row is


@pytest.mark.exercise("P8.1a")
def test_a_row_counts_once(rng: Random) -> None:
    about.read = RULES
    rows = rng.randint(5, 9)
    a, b = rng.sample(range(1, rows - 1), 2)  # the first and the last have a check of their own
    events = [a, a, b, a, b]
    about.call = f"Rules({rows}); rules.landed() on {events} in turn: the score after each"
    about.cause = "POINTS, 10, for a row that is not in visited yet, and nothing for one that is"
    seen = ruled(rows, events)
    got = [score for score, *_ in seen]
    mistakes = [
        ([10, 20, 30, 40, 50], "a row counts once: look whether it is in visited already"),
        ([160] * 5, "won after one row: won is that all rows are visited"),
    ]
    blame(got, mistakes)
    expect_exactly(got, [10, 10, 20, 20, 20])
    about.call = f"Rules({rows}); rules.landed() on {events} in turn: visited, lives"
    about.cause = "a landing adds its row to visited, and costs no life"
    expect_exactly(seen[-1][2], sorted((a, b)))
    expect_exactly(seen[-1][1], 3)


@pytest.mark.exercise("P8.1a")
def test_all_rows_win_and_lives_are_a_bonus(rng: Random) -> None:
    about.read = RULES
    rows, falls = rng.randint(3, 6), 1  # two lives are left: neither one nor all
    order = rng.sample(range(rows), rows)
    events = [*order[:1], *([-1] * falls), *order[1:], order[0], -1]
    about.call = f"Rules({rows}); rules.landed() on rows, or -1 for a fall: {events}"
    about.cause = "the last row wins: its POINTS, and then BONUS, 50, for each life that is left"
    seen = ruled(rows, events)
    won = seen[rows + falls - 1]
    score = 10 * rows + 50 * (3 - falls)
    points = 10 * rows
    mistakes = [
        (
            points,
            "no bonus: is it left out, or does a fall take visited rows away, so that some "
            "are missing?",
        ),
        (points + 50, "the bonus is 50 for each life that is left, not once"),
        (points + 150, "the bonus is for the lives that are left, not for all three"),
        (score - 10, "10 too few: does the last row count, beside the bonus, or does a fall cost?"),
    ]
    blame(won[0], mistakes)
    expect_exactly(won[0], score, then=": score once all are visited")
    name = f"Rules({rows}); {events}: rules.won, rules.over"
    expect_exactly(list(won[3:]), [True, True], call=name)
    before = seen[rows + falls - 2]
    about.cause = "before the last row nothing is won, and there is no bonus"
    expect_exactly(before[0], 10 * (rows - 1), then=": score before")
    about.cause = "once it is over nothing counts any more"
    got = list(seen[-1][:2])
    expect_exactly(got, [score, 3 - falls], then=": score and lives in the end")


@pytest.mark.exercise("P8.1a")
def test_three_falls_are_the_end(rng: Random) -> None:
    about.read = RULES
    a, b = rng.sample(range(1, 5), 2)
    events = [-1, a, -1, -1, -1, b]
    about.call = f"Rules(6); rows landed on, or -1 for a rules.fell(): {events}"
    about.cause = "a fall takes a life, but never one below 0, and after the last one nothing "
    about.cause += "counts"
    seen = ruled(6, events)
    got = [lives for _, lives, *_ in seen]
    expect_exactly(got, [2, 2, 1, 0, 0, 0], then=": lives")
    got = [over for *_, over in seen]
    wanted = [False, False, False, True, True, True]
    expect_exactly(got, wanted, call=f"Rules(6); {events}: rules.over")
    about.cause = "a fall takes neither points nor the rows that were visited"
    got = [seen[-1][0], *seen[-1][2]]
    if got[0] == 20:
        about.cause = "a row counts after the end: landed does nothing where self.over"
    expect_exactly(got, [10, a], then=": score, visited, in the end")


@pytest.mark.exercise("P8.1a")
@pytest.mark.robust
def test_a_row_that_there_is_not_is_refused(rng: Random) -> None:
    about.read = RULES
    rows = rng.randint(3, 6)
    about.cause = "rows are numbered from 0: ValueError for any other"
    for row in (rows, -1):
        about.call = f"Rules({rows}).landed({row}): the error, '' for none"
        error, *after = refused_row(rows, row)
        expect_exactly(error, "ValueError")
        name = f"Rules({rows}).landed({row}): score and visited then"
        expect_exactly(after, [0, []], call=name, cause="what is refused does not count")
    about.cause = "what is right must not be refused"
    for row in (0, rows - 1):
        about.call = f"Rules({rows}).landed({row}): the error, '' for none"
        expect_exactly(refused_row(rows, row)[0], "")


@pytest.mark.exercise("P8.1b")
def test_a_landing_is_seen_on_the_way_down(rng: Random) -> None:
    about.read = LANDINGS
    row = rng.randint(1, 4)
    before, beyond = FIRST + 2.0 * row - 0.5, FIRST + 2.0 * row + 0.5  # it is the nearest of both
    depth, speed = round(rng.uniform(0.01, 0.2), 3), round(rng.uniform(2.0, 9.0), 3)
    named = "the row that the deck names"
    for what, x, height, velocity, wanted, cause in (
        ("in the deck, falling", before, 4.5 - depth, -speed, (2, row), named),
        ("in the deck, falling slowly", beyond, 4.5 - depth, -0.01, (2, row), "however slow it is"),
        (
            "in the deck, on its way up",
            before,
            4.5 - depth,
            speed,
            (2, -1),
            "on its way up it is in contact, but lands nowhere",
        ),
        (
            "in the deck, at rest",
            before,
            4.5 - depth,
            0.0,
            (2, -1),
            "it lands only on its way down",
        ),
        ("above the deck, falling", before, 4.5 + depth, -speed, (0, -1), "it touches nothing yet"),
    ):
        about.cause = cause
        about.call = f"a ball at x = {x}, {what}: landings.contacts(), how many; row, -1 for None"
        count, first, later = landing(height, velocity, x)
        got = (count, -1 if first is None else first)
        expect_close(got, wanted, tolerance=0.0)
        about.call = f"a ball at x = {x}, {what}; again, far above: landings.contacts(); row"
        about.cause = "the row is that of the last frame: None where the ball does not touch then"
        expect_exactly(later is None, True)


@pytest.mark.exercise("P8.1b")
@pytest.mark.parametrize("direction", [-1, 0, 1])
def test_a_ball_is_steered(rng: Random, direction: int) -> None:
    about.read = STEP
    x, speed = round(rng.uniform(-3.0, 3.0), 3), round(rng.uniform(-2.0, 2.0), 3)
    frame, mass = round(rng.uniform(0.005, 0.03), 4), positive_number(rng)
    damped = 0.6**frame
    about.call = f"a game with direction {direction}, the ball at ({x}, 9, 0), velocity ({speed}, "
    about.call += f"0, 0), mass {mass}; three times game.step({frame}): its velocity"
    about.cause = "PUSH * mass is a force, of PUSH = 8 m/s^2, added between start_frame and "
    about.cause += "run_physics"
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
            (
                (free, vy, 0.0),
                "no push comes: add it after start_frame, which clears what was there before",
            ),
            ((weak, vy, 0.0), "PUSH is in m/s^2: the force is PUSH * mass"),
        ]
        blame(got, mistakes)
    expect_close(got, (vx, vy, 0.0), tolerance=1e-12)


@pytest.mark.exercise("P8.1b")
def test_a_ball_jumps_from_where_it_lands(rng: Random) -> None:
    about.read = STEP
    for row in (rng.randint(1, 4), 0):
        x = FIRST + 2.0 * row
        about.call = f"a game, the ball 0.05 m above row {row} at -6 m/s: its velocity along Y, "
        about.call += "score and visited, after game.step(1/60), in which it lands"
        about.cause = "landings.row is known once the physics have run: tell the rules, and let "
        about.cause += "the ball go up at JUMP"
        seen = played(1, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0))[-1]
        got = (seen["velocity"][1], seen["score"], *seen["visited"])
        if got[:2] == (6.0, 0):
            about.cause = "it jumps, but the landing does not count: tell self.rules by landed(row)"
        elif got[1:] == (10, row):
            about.cause = "it counts, but the ball does not jump: its velocity along Y is JUMP, 6 "
            about.cause += "m/s"
        elif row == 0:
            about.cause = "0 is the first row, and None is none: ask whether landings.row is None"
        expect_close(got, (6.0, 10.0, float(row)), tolerance=1e-12)
    about.call = f"a game, the ball 0.05 m above row {row} at -6 m/s: score, lives; 20 "
    about.call += "game.step(1/60)"
    about.cause = "it lands once, and flies on from there"
    seen = played(20, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0))[-1]
    got = (seen["score"], seen["lives"])
    expect_close(got, (10.0, 3.0), tolerance=0.0)
    about.call = f"a game with row {row} visited, the ball 0.05 m above it at -6 m/s: its velocity "
    about.call += "along Y, and score, after game.step(1/60)"
    about.cause = "it jumps from every row that it lands on, whether that counts or not"
    seen = played(1, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0), visited=[row])[-1]
    got = (seen["velocity"][1], seen["score"])
    expect_close(got, (6.0, 0.0), tolerance=1e-12)


@pytest.mark.exercise("P8.1b")
def test_the_ground_takes_a_life(rng: Random) -> None:
    about.read = STEP
    x = round(rng.uniform(8.0, 9.0), 3)
    about.call = f"a game, the ball at ({x}, 0.6, 0), beside the bridge, at -9 m/s; game.step(1/60)"
    about.cause = "where its lowest point is at the ground, a life goes, and the ball starts anew: "
    about.cause += "over the first row, 2 m above where the bridge begins, at rest"
    seen = played(1, FRAME, 1, (x, 0.6, 0.0), (3.0, -9.0, 0.0), visited=[2, 4])[-1]
    expect_exactly(seen["lives"], 2, then=": lives")
    kept = "it takes a life, and nothing else"
    expect_exactly(seen["visited"], [2, 4], then=": visited, of rows 2 and 4 before", cause=kept)
    got = seen["place"] + seen["velocity"]
    place = (FIRST, 6.0, 0.0, 0.0, 0.0, 0.0)
    # The cables, too short at first, have pulled the row inwards by 0.13 m in that frame.
    expect_close(got, place, then=": place and velocity", tolerance=0.2)
    about.cause = "where its lowest point is no more than TOUCH, 1e-6 m, above the ground, a life "
    about.cause += "goes"
    for above, lives in ((5e-7, 2), (5e-6, 3)):
        about.call = f"a game, the ball beside the bridge, its lowest point {above} m above the "
        about.call += "ground at the end of a frame: lives"
        # Its speed upwards is what gravity takes in that frame: it stays where it is.
        seen = played(1, FRAME, 0, (x, 0.5 + above, 0.0), (0.0, 9.81 * FRAME, 0.0))[-1]
        expect_exactly(seen["lives"], lives)
    about.call = f"a game with one life left, the ball at ({x}, 0.6, 0) at -9 m/s; 3 "
    about.call += "game.step(1/60)"
    about.cause = "after the last life it is over: the ball stays where it is, and no frame moves "
    about.cause += "it"
    seen = played(3, FRAME, 1, (x, 0.6, 0.0), (3.0, -9.0, 0.0), lives=1)
    expect_exactly(seen[-1]["lives"], 0, then=": lives")
    expect_close(
        seen[-1]["place"],
        seen[0]["place"],
        then=": place, as after the first of them",
        tolerance=0.0,
    )
    expect_exactly(seen[-1]["place"][0] > 7.0, True, then=": is it still beside the bridge")


@pytest.mark.exercise("P8.1b")
def test_the_last_row_ends_the_game(rng: Random) -> None:
    about.read = STEP
    row = rng.randint(1, 4)
    visited = [i for i in range(6) if i != row]
    x = FIRST + 2.0 * row
    about.call = f"a game with rows {visited} visited, the ball 0.05 m above row {row} at -6 m/s; "
    about.call += "three times game.step(1/60)"
    about.cause = "the game is won: POINTS and BONUS, once; then nothing moves any more"
    seen = played(3, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0), visited=visited)
    scores = [frame["score"] for frame in seen]
    expect_exactly(scores, [160] * 3, then=": score")
    expect_close(
        seen[-1]["place"],
        seen[0]["place"],
        then=": place, as after the first of them",
        tolerance=0.0,
    )
