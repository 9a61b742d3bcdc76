"""Project 8.1, a ball game on the bridge: its rules and its play."""

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
FIRST = -5.0  # m, the position of the first row


@pytest.mark.exercise("P8.1a")
def test_a_row_counts_once(rng: Random) -> None:
    rows = rng.randint(5, 9)
    a, b = rng.sample(range(1, rows - 1), 2)  # other checks have the first and the last row
    events = [a, a, b, a, b]
    about(f"Rules({rows}); rules.landed() for the rows {events}: the score after each", read=RULES)
    about.cause = (
        "The first landing on a row scores POINTS, 10. Later landings on it score nothing."
    )
    seen = ruled(rows, events)
    got = [score for score, *_ in seen]
    mistakes = [
        ([10, 20, 30, 40, 50], "A row counts only once. Check whether it is in visited already."),
        ([160] * 5, "The game was won after one row. It must be won when all rows are visited."),
    ]
    blame(got, mistakes)
    expect_exactly(got, [10, 10, 20, 20, 20])
    about.call = f"Rules({rows}); rules.landed() for the rows {events}: visited, lives"
    about.cause = "A landing adds its row to visited and costs no life."
    expect_exactly(seen[-1][2], sorted((a, b)))
    expect_exactly(seen[-1][1], 3)


@pytest.mark.exercise("P8.1a")
def test_all_rows_win_and_lives_are_a_bonus(rng: Random) -> None:
    rows, falls = rng.randint(3, 6), 1  # two lives are left, so neither one nor all
    order = rng.sample(range(rows), rows)
    events = [*order[:1], *([-1] * falls), *order[1:], order[0], -1]
    about(f"Rules({rows}); rules.landed() for these rows (-1 is a fall): {events}", read=RULES)
    about.cause = "The last row gives its POINTS, and then BONUS, 50, for each life that is left."
    seen = ruled(rows, events)
    won = seen[rows + falls - 1]
    score = 10 * rows + 50 * (3 - falls)
    points = 10 * rows
    missing = "The bonus is missing. When the last row is visited, add BONUS for each life left."
    if won[0] == points and ruled(rows, order)[-1][0] != points:
        missing = "The game is not won here, but it is if there is no fall. A fall must not remove "
        missing += "visited rows."
    mistakes = [
        (points, missing),
        (points + 50, "The bonus was given once. It is 50 for each life that is left."),
        (points + 150, "The bonus was given for all three lives. Give it only for those that are "
                       "left."),
        (score - 10, "10 points are missing. The last row gives its POINTS in addition to the "
         "bonus, and a fall costs no points."),
    ]  # fmt: skip
    blame(won[0], mistakes)
    expect_exactly(won[0], score, then=": the score when all rows are visited")
    name = f"Rules({rows}); {events}: rules.won, rules.over when all rows are visited"
    over = "The game is over if it is won, or if no lives are left."
    expect_exactly(list(won[3:]), [True, True], call=name, cause=over)
    before = seen[rows + falls - 2]
    about.cause = "Before the last row is visited, the game is not won, so there is no bonus."
    expect_exactly(before[0], 10 * (rows - 1), then=": the score before the last row")
    about.cause = "After the end of the game, landings and falls must not change anything."
    got = list(seen[-1][:2])
    expect_exactly(got, [score, 3 - falls], then=": score and lives at the end")


@pytest.mark.exercise("P8.1a")
def test_three_falls_are_the_end(rng: Random) -> None:
    a, b = rng.sample(range(1, 5), 2)
    events = [-1, a, -1, -1, -1, b]
    about(f"Rules(6); landings on these rows, and rules.fell() for each -1: {events}", read=RULES)
    about.cause = (
        "A fall takes a life. After the last life the game is over, so lives must stay at 0."
    )
    seen = ruled(6, events)
    got = [lives for _, lives, *_ in seen]
    expect_exactly(got, [2, 2, 1, 0, 0, 0], then=": lives after each")
    got = [over for *_, over in seen]
    wanted = [False, False, False, True, True, True]
    expect_exactly(got, wanted, call=f"Rules(6); {events} (-1 is a fall): rules.over after each")
    about.cause = "A fall must not change the points or the visited rows."
    got = [seen[-1][0], *seen[-1][2]]
    if got[0] == 20:
        about.cause = "A row was counted after the end. Return from landed at once if self.over."
    expect_exactly(got, [10, a], then=": score and visited at the end")


@pytest.mark.exercise("P8.1a")
@pytest.mark.robust
def test_a_row_that_there_is_not_is_refused(rng: Random) -> None:
    about.read = RULES
    rows = rng.randint(3, 6)
    about.cause = "Rows are numbered from 0. Raise ValueError for a row that does not exist."
    for row in (rows, -1):
        about.call = f"Rules({rows}).landed({row}): the error raised ('' is none)"
        error, *after = refused_row(rows, row)
        expect_exactly(error, "ValueError")
        name = f"Rules({rows}).landed({row}): score and visited afterward"
        expect_exactly(after, [0, []], call=name, cause="A rejected row must not count.")
    about.cause = "This row exists, so it must not be rejected."
    for row in (0, rows - 1):
        about.call = f"Rules({rows}).landed({row}): the error raised ('' is none)"
        expect_exactly(refused_row(rows, row)[0], "")


@pytest.mark.exercise("P8.1b")
def test_a_landing_is_seen_on_the_way_down(rng: Random) -> None:
    about.read = LANDINGS
    row = rng.randint(1, 4)
    before, beyond = FIRST + 2.0 * row - 0.5, FIRST + 2.0 * row + 0.5  # row is nearest to both
    depth, speed = round(rng.uniform(0.01, 0.2), 3), round(rng.uniform(2.0, 9.0), 3)
    named = "The ball lands. Set row to the row that deck.nearest() returns."
    for what, x, height, velocity, wanted, cause in (
        ("in the deck, falling", before, 4.5 - depth, -speed, (2, row), named),
        ("in the deck, falling slowly", beyond, 4.5 - depth, -0.01, (2, row), "A slow "
         "ball also lands. Any negative separating velocity counts."),
        ("in the deck, on its way up", before, 4.5 - depth, speed, (2, -1), "A ball that moves up "
         "touches the deck but does not land. Set row to None."),
        ("in the deck, at rest", before, 4.5 - depth, 0.0, (2, -1), "A ball at rest does not land. "
         "The separating velocity must be negative."),
        ("above the deck, falling", before, 4.5 + depth, -speed, (0, -1), "There is no contact, so "
         "row is None."),
    ):  # fmt: skip
        about.cause = cause
        about.call = f"a ball at x = {x}, {what}: number of landings.contacts(), row (-1 is None)"
        count, first, later = landing(height, velocity, x)
        got = (count, -1 if first is None else first)
        if not count and wanted[0]:
            about.cause = "The contacts are missing. Return those of the deck."
        expect_close(got, wanted, tolerance=0.0)
        about.call = f"a ball at x = {x}, {what}; then far above: landings.contacts(); row is None"
        about.cause = "Set row again on every call. It is None if the ball does not touch the deck."
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
    about.cause = "Add the force direction * PUSH * mass along X between start_frame and "
    about.cause += "run_physics, and pass the duration on."
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
            ((free, vy, 0.0), "The push has no effect. Add it after start_frame, which clears "
             "earlier forces."),
            ((weak, vy, 0.0), "PUSH is an acceleration in m/s^2. The force is PUSH * mass."),
        ]  # fmt: skip
        blame(got, mistakes)
    expect_close(got, (vx, vy, 0.0), tolerance=1e-12)


@pytest.mark.exercise("P8.1b")
def test_a_ball_jumps_from_where_it_lands(rng: Random) -> None:
    about.read = STEP
    for row in (rng.randint(1, 4), 0):
        x = FIRST + 2.0 * row
        about.call = f"a game, the ball 0.05 m above row {row} at -6 m/s: its velocity along Y, "
        about.call += "score and visited, after game.step(1/60), in which it lands"
        about.cause = "After run_physics, check landings.row. If it is not None, call "
        about.cause += "self.rules.landed(row) and set the vertical velocity to JUMP."
        seen = played(1, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0))[-1]
        got = (seen["velocity"][1], seen["score"], *seen["visited"])
        if got[:2] == (6.0, 0):
            about.cause = "The ball jumps, but the landing does not count. Call rules.landed(row)."
        elif got[1:] == (10, row):
            about.cause = "The landing counts, but the ball does not jump. Set its velocity along "
            about.cause += "Y to JUMP, 6 m/s."
        elif row == 0:
            about.cause = "0 is the first row, and `if row` is false for it. Compare: row is not "
            about.cause += "None."
        expect_close(got, (6.0, 10.0, float(row)), tolerance=1e-12)
    about.call = f"a game, the ball 0.05 m above row {row} at -6 m/s: score, lives; 20 "
    about.call += "game.step(1/60)"
    about.cause = "The ball must land once and then fly up from the row."
    seen = played(20, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0))[-1]
    got = (seen["score"], seen["lives"])
    expect_close(got, (10.0, 3.0), tolerance=0.0)
    about.call = f"a game with row {row} visited, the ball 0.05 m above it at -6 m/s: its velocity "
    about.call += "along Y, and score, after game.step(1/60)"
    about.cause = "The ball jumps from every row that it lands on, even if the row no longer "
    about.cause += "counts."
    seen = played(1, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0), visited=[row])[-1]
    got = (seen["velocity"][1], seen["score"])
    expect_close(got, (6.0, 0.0), tolerance=1e-12)


@pytest.mark.exercise("P8.1b")
def test_the_ground_takes_a_life(rng: Random) -> None:
    about.read = STEP
    x = round(rng.uniform(8.0, 9.0), 3)
    about.call = f"a game, the ball at ({x}, 0.6, 0), beside the bridge, at -9 m/s; game.step(1/60)"
    about.cause = "The ball has reached the ground. Take a life, and let the ball start again "
    about.cause += "above the first row."
    seen = played(1, FRAME, 1, (x, 0.6, 0.0), (3.0, -9.0, 0.0), visited=[2, 4])[-1]
    expect_exactly(seen["lives"], 2, then=": lives")
    kept = "A fall takes a life and changes nothing else."
    expect_exactly(seen["visited"], [2, 4], then=": visited, which was [2, 4]", cause=kept)
    got = seen["place"] + seen["velocity"]
    place = (FIRST, 6.0, 0.0, 0.0, 0.0, 0.0)
    # The cables, too short at first, have pulled the row inward by 0.13 m in that step.
    expect_close(got, place, then=": position and velocity", tolerance=0.2)
    about.cause = "Take a life if the lowest point is at most TOUCH, 1e-6 m, above the ground."
    for above, lives in ((5e-7, 2), (5e-6, 3)):
        about.call = f"a game, the ball beside the bridge, its lowest point {above} m above the "
        about.call += "ground at the end of a step: lives"
        # In one step gravity takes exactly its upward speed, so it stays where it is.
        seen = played(1, FRAME, 0, (x, 0.5 + above, 0.0), (0.0, 9.81 * FRAME, 0.0))[-1]
        expect_exactly(seen["lives"], lives)
    about.call = f"a game with one life left, the ball at ({x}, 0.6, 0) at -9 m/s; 3 "
    about.call += "game.step(1/60)"
    about.cause = "After the last life the game is over. The ball does not start again, and step "
    about.cause += "does nothing."
    seen = played(3, FRAME, 1, (x, 0.6, 0.0), (3.0, -9.0, 0.0), lives=1)
    expect_exactly(seen[-1]["lives"], 0, then=": lives")
    expect_close(
        seen[-1]["place"],
        seen[0]["place"],
        then=": position, as after the first step",
        tolerance=0.0,
    )
    expect_exactly(seen[-1]["place"][0] > 7.0, True, then=": is the ball still beside the bridge")


@pytest.mark.exercise("P8.1b")
def test_the_last_row_ends_the_game(rng: Random) -> None:
    about.read = STEP
    row = rng.randint(1, 4)
    visited = [i for i in range(6) if i != row]
    x = FIRST + 2.0 * row
    about.call = f"a game with rows {visited} visited, the ball 0.05 m above row {row} at -6 m/s; "
    about.call += "three times game.step(1/60)"
    about.cause = (
        "The game is won. POINTS and the bonus are given only once, and after that nothing moves."
    )
    seen = played(3, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0), visited=visited)
    scores = [frame["score"] for frame in seen]
    expect_exactly(scores, [160] * 3, then=": the scores")
    expect_close(
        seen[-1]["place"],
        seen[0]["place"],
        then=": position, as after the first step",
        tolerance=0.0,
    )
