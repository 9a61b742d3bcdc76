"""Project 8.1, a ball game on the bridge: its rules and its play."""

from __future__ import annotations

from random import Random

import pytest

from ch08_mass_aggregate.scene_probes import landing, played, ruled
from draw import positive_number
from expect import about, blame, expect_close, expect_exactly, expect_that

RULES = "the docstrings of Rules, landed and fell"
LANDINGS = "the docstrings of Landings and Landings.contacts"
STEP = "the docstring of BallGame.step"
FRAME = 1.0 / 60.0
FIRST = -5.0  # m, the position of the first row


def called(events: list[int]) -> str:
    """Return the calls for these events: a row on which the ball lands, or -1 for a fall."""
    return ", ".join("rules.fell()" if row < 0 else f"rules.landed({row})" for row in events)


@pytest.mark.exercise("P8.1a", asks="Later landings on the same row change nothing")
def test_a_row_counts_once(rng: Random) -> None:
    rows = rng.randint(5, 9)
    a, b = rng.sample(range(1, rows - 1), 2)  # other checks have the first and the last row
    events = [a, a, b, a, b]
    about(
        f"rules = Rules({rows}); rules.landed(row) for each row in {events}; the score after each "
        "call",
        read=RULES,
    )
    about.cause = "The first landing on a row scores POINTS, which is 10, and later landings on "
    about.cause += "the same row score nothing. Check self.visited before you add points."
    seen = ruled(rows, events)
    got = [score for score, *_ in seen]
    mistakes = [
        ([10, 20, 30, 40, 50], "Every landing scores, even on a row that the ball has visited "
                               "before. A row scores only once, so check first whether it is "
                               "already in visited."),
        ([160] * 5, "Your game already counts as won after the first landing, so it adds the "
                    "bonus. It is won only when every row has been visited."),
    ]  # fmt: skip
    if not seen[-1][2]:
        why = "Every landing scores, because visited stays empty. Add the row to self.visited."
        mistakes.insert(0, ([10, 20, 30, 40, 50], why))
    blame(got, mistakes)
    expect_exactly(got, [10, 10, 20, 20, 20])
    about.call = (
        f"rules = Rules({rows}); rules.landed(row) for each row in {events}; rules.visited and "
        "then rules.lives"
    )
    about.cause = "self.visited lacks the rows that were hit. Add each row to it in landed."
    expect_exactly(seen[-1][2], sorted((a, b)))
    about.cause = "A landing costs a life. Only a fall should, so don't change lives in landed."
    expect_exactly(seen[-1][1], 3)


@pytest.mark.exercise("P8.1a", asks="for each life that is left")
def test_all_rows_win_and_lives_are_a_bonus(rng: Random) -> None:
    rows, falls = rng.randint(3, 6), 1  # two lives are left, so neither one nor all
    order = rng.sample(range(rows), rows)
    events = [*order[:1], *([-1] * falls), *order[1:], order[0], -1]
    about(f"rules = Rules({rows}); {called(events[: rows + falls])}", read=RULES)
    about.cause = (
        f"You reject a row that exists. The rows are numbered from 0 to {rows - 1}, so accept each "
        "of these numbers."
    )
    seen = ruled(rows, events)
    about.cause = "Each new row scores POINTS. The last one also wins the game, so add BONUS, "
    about.cause += "which is 50, for each life that is left."
    won, before = seen[rows + falls - 1], seen[rows + falls - 2]
    score = 10 * rows + 50 * (3 - falls)
    points = 10 * rows
    missing = "You add no bonus. Either you leave it out, or you test self.won before the last row "
    missing += "is in visited. Add the row first, and then BONUS for each life that is left."
    if won[0] == points and ruled(rows, order)[-1][0] != points:
        missing = "You remove rows from visited after a fall, so the game is never won. Don't "
        missing += "change visited in fell."
    elif not won[3] and list(won[2]) == [*range(rows)]:
        missing = "All rows are visited, but won is False, so there is no bonus. Compare "
        missing += "len(self.visited) with self.rows."
    low = "You leave out the POINTS for the last row. Add both these POINTS and the bonus."
    if seen[1][0] < seen[0][0]:
        low = "You take points away for a fall. A fall costs a life, but no points."
    elif before[0] > points - 10:
        low = "Your game counts as won before the last row is visited. It is won only when every "
        low += "row is in visited."
    mistakes = [
        (points, missing),
        (points + 50, "You add the bonus only once. Multiply BONUS, which is 50, by the number of "
                      "lives that are left."),
        (points + 150, "A fall doesn't cost a life. Take one away in fell." if seen[1][1] == 3 else
         "You add the bonus for all three lives, although one of them is lost. Multiply BONUS by "
         "the number of lives that are left."),
        (score - 10, low),
    ]  # fmt: skip
    blame(won[0], mistakes)
    expect_exactly(won[0], score, then="; rules.score", unit="points")
    about.cause = "All rows are visited, but won is False. Compare len(self.visited) with "
    about.cause += "self.rows."
    expect_that(won[3], "False", "True", then="; rules.won")
    about.cause = "The game is won, but over is False. It should be True if no lives are left and "
    about.cause += "also if the game is won."
    expect_that(won[4], "False", "True", then="; rules.over")
    about.cause = "You add the bonus before the last row is visited. Add it only if self.won is "
    about.cause += "true."
    about.call = f"rules = Rules({rows}); {called(events[: rows + falls - 1])}"
    expect_exactly(before[0], points - 10, then="; rules.score", unit="points")
    about.call = f"rules = Rules({rows}); {called(events)}"
    about.cause = "A landing still scores after the game is over. Return if self.over is true."
    expect_exactly(seen[-1][0], score, then="; rules.score", unit="points")
    about.cause = "A fall still costs a life after the game is over. Return if self.over is true."
    expect_exactly(seen[-1][1], 3 - falls, then="; rules.lives")


@pytest.mark.exercise("P8.1a", asks="Do nothing if the game is over")
def test_three_falls_are_the_end(rng: Random) -> None:
    a, b = rng.sample(range(1, 5), 2)
    events = [-1, a, -1, -1, -1, b]
    about(f"rules = Rules(6); {called(events)}", read=RULES)
    about.cause = "Each fall should cost one life, until no lives are left."
    seen = ruled(6, events)
    got = [lives for _, lives, *_ in seen]
    overs = [over for *_, over in seen]
    wanted = [False, False, False, True, True, True]
    if type(got[-1]) is int and got[-1] < 0:
        seen = "No lives are left, but over is False. It should be True if the game is won and "
        seen += "also if no lives are left."
        expect_that(
            overs[3], f"{overs}", f"{wanted}", then="; rules.over after each call", cause=seen
        )
        about.cause = "A fall costs a life although none is left. Return if self.over is true."
    expect_exactly(got, [2, 2, 1, 0, 0, 0], then="; the lives after each call")
    about.cause = "over should be True from the moment when no lives are left."
    expect_exactly(overs, wanted, then="; rules.over after each call")
    about.cause = "A fall changes the score. It should only cost a life."
    if seen[-1][0] == 20:
        about.cause = "You count a landing after the game is over. Return from landed at once if "
        about.cause += "self.over is true."
    elif seen[0][0] == seen[1][0] == 0:
        about.cause = "A landing after a fall doesn't score. It should, unless the game is over."
    expect_exactly(seen[-1][0], 10, then="; rules.score", unit="points")
    about.cause = "A fall changes the visited rows. It should only cost a life."
    expect_exactly(seen[-1][2], [a], then="; rules.visited")


@pytest.mark.exercise("P8.1b", asks="or is not moving toward them")
def test_a_landing_is_seen_on_the_way_down(rng: Random) -> None:
    about.read = LANDINGS
    row = rng.randint(1, 4)
    before, beyond = FIRST + 2.0 * row - 0.5, FIRST + 2.0 * row + 0.5  # row is nearest to both
    depth, speed = round(rng.uniform(0.01, 0.2), 3), round(rng.uniform(2.0, 9.0), 3)
    named = "The ball moves down and touches the deck, so it lands. Set row to the row that "
    named += "deck.nearest() returns."
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
        about.call = f"a ball at x = {x:g} m {what}; landings.contacts()"
        count, first, later = landing(height, velocity, x)
        lost = "Your contacts() returns no contacts, so the ball falls through the bridge. Return "
        lost += "the contacts that self.deck.contacts() finds."
        if count:
            lost = "Your contacts() must return exactly what self.deck.contacts() finds."
        name = f"{about.call}; the number of contacts"
        expect_exactly(count, wanted[0], call=name, cause=lost, unit="contacts")
        hit = None if wanted[1] < 0 else wanted[1]
        expect_that(first == hit, f"landings.row is {first}", f"landings.row is {hit}")
        about.call += "; the ball is moved far above the deck; landings.contacts()"
        about.cause = "You keep the row of the earlier landing. Set row to None at the start of "
        about.cause += "every call to contacts()."
        if later is not None and landing(4.5 + depth, -speed, before)[1] == row:
            about.cause = "You set row although the ball doesn't touch the deck. Set it only if "
            about.cause += "there is a contact."
        expect_that(later is None, f"landings.row is {later}", "landings.row is None")


@pytest.mark.exercise("P8.1b", asks="so that it gets an acceleration of PUSH")
@pytest.mark.parametrize("direction", [-1, 0, 1])
def test_a_ball_is_steered(rng: Random, direction: int) -> None:
    about.read = STEP
    x, speed = round(rng.uniform(-3.0, 3.0), 3), round(rng.uniform(-2.0, 2.0), 3)
    frame, mass = round(rng.uniform(0.005, 0.03), 4), positive_number(rng)
    damped = 0.6**frame
    about.call = (
        f"a game with game.direction = {direction}; its ball of {mass} kg is at ({x}, 9, 0) m and "
        f"moves at ({speed}, 0, 0) m/s; three calls to game.step({frame}); the velocity of the "
        "ball"
    )
    about.cause = "The push is wrong. Add a force of direction * PUSH * mass along X between "
    about.cause += "start_frame and run_physics."
    late, pull, vx, vy = [speed, 0.0], (8.0 * direction, -9.81), speed, 0.0
    free, weak = speed, speed
    for _ in range(3):
        free = free * damped
        weak = (weak + 8.0 * direction / mass * frame) * damped
        vx, vy = (vx + 8.0 * direction * frame) * damped, (vy - 9.81 * frame) * damped
        late = [(v + a * FRAME) * 0.6**FRAME for v, a in zip(late, pull, strict=True)]
    seen = played(3, frame, direction, (x, 9.0, 0.0), (speed, 0.0, 0.0), mass=mass)
    got = seen[-1]["velocity"]
    mistakes = [
        ((*late, 0.0), f"The ball moved as in steps of 1/60 s, not {frame} s. Pass the duration to "
                       "run_physics."),
        ((speed, 0.0, 0.0), "The velocity of the ball doesn't change. Call "
                            "self.world.run_physics(duration) after the push."),
    ]  # fmt: skip
    if direction:
        mistakes += [
            ((free, vy, 0.0), "The push has no effect. Add it after start_frame, which clears all "
                              "forces, and before run_physics."),
            ((weak, vy, 0.0), "You leave the mass out of the push. PUSH is an acceleration in "
                              "m/s^2, so the force is PUSH * mass."),
            ((8.0 * direction * damped, vy, 0.0), "You set the velocity of the ball to PUSH, which "
                                                  "is an acceleration. Add a force of PUSH * mass "
                                                  "instead."),
        ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, (vx, vy, 0.0), unit="m/s", tolerance=1e-12)


@pytest.mark.exercise("P8.1b", asks="Make the ball jump by setting")
def test_a_ball_jumps_from_where_it_lands(rng: Random) -> None:
    about.read = STEP
    for row in (rng.randint(1, 4), 0):
        x = FIRST + 2.0 * row
        about.call = (
            f"a game in which the ball is 0.05 m above row {row} and falls at 6 m/s; "
            "game.step(1/60), in which the ball lands"
        )
        about.cause = "After run_physics, check landings.row. If it is not None, call "
        about.cause += "self.rules.landed(row) and set the ball's vertical velocity to JUMP."
        seen = played(1, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0))[-1]
        if seen["score"] == 10:
            about.cause = (
                "The landing scores, but the ball doesn't jump. Set its velocity along Y to JUMP, "
                "which is 6 m/s."
            )
        elif row == 0:
            about.cause = (
                "You ignore a landing on row 0, because Python treats 0 as false in `if row`. "
                "Write `if row is not None` instead."
            )
        name = "; the ball's velocity along Y"
        expect_close(seen["velocity"][1], 6.0, then=name, unit="m/s", tolerance=1e-12)
        about.cause = "The ball jumps, but the landing doesn't score. Call self.rules.landed(row) "
        about.cause += "when landings.row is not None."
        expect_close(seen["score"], 10, then="; the score", unit="points", tolerance=1e-12)
        about.cause = "You pass the wrong row. Pass self.landings.row to self.rules.landed."
        expect_exactly(seen["visited"], [row], then="; the visited rows")
    about.call = (
        f"a game in which the ball is 0.05 m above row {row} and falls at 6 m/s; 20 calls to "
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


@pytest.mark.exercise("P8.1b", asks="report the fall to the rules")
def test_the_ground_takes_a_life(rng: Random) -> None:
    about.read = STEP
    x = round(rng.uniform(8.0, 9.0), 3)
    about.call = (
        f"a game in which the ball is beside the bridge, at ({x}, 0.6, 0) m, and moves at (3, -9, "
        "0) m/s; game.step(1/60)"
    )
    about.cause = (
        "The ball has reached the ground, but you don't take a life. Call self.rules.fell() in "
        "this case."
    )
    seen = played(1, FRAME, 1, (x, 0.6, 0.0), (3.0, -9.0, 0.0), visited=[2, 4])[-1]
    expect_exactly(seen["lives"], 2, then="; the number of lives that are left")
    about.cause = "The ball stays on the ground after a fall. Put it back above the first row."
    kept = (
        "A fall changes the visited rows in your game. It should only cost a life, so leave "
        "visited as it is."
    )
    expect_exactly(
        seen["visited"], [2, 4], then="; the visited rows, which were 2 and 4", cause=kept
    )
    place, still = (FIRST, 6.0, 0.0), (0.0, 0.0, 0.0)
    # The cables, too short at first, have pulled the row inward by 0.13 m in that step.
    name = "; the position of the ball"
    expect_close(seen["place"], place, then=name, unit="m", tolerance=0.2)
    about.cause = "The ball keeps its velocity after a fall. Call self.start_ball(), which also "
    about.cause += "stops it."
    name = "; the velocity of the ball"
    expect_close(seen["velocity"], still, then=name, unit="m/s", tolerance=0.2)
    about.cause = (
        "The ball has fallen if its lowest point is at most TOUCH, which is 1e-6 m, above the "
        "ground. That point is one radius below the ball's center."
    )
    for above, lives in ((5e-7, 2), (5e-6, 3)):
        about.call = (
            f"a game in which the ball is beside the bridge, and its lowest point is {above} m "
            "above the ground at the end of game.step(1/60); the number of lives that are left"
        )
        # In one step gravity takes exactly its upward speed, so it stays where it is.
        seen = played(1, FRAME, 0, (x, 0.5 + above, 0.0), (0.0, 9.81 * FRAME, 0.0))[-1]
        expect_exactly(seen["lives"], lives)
    about.call = (
        f"a game with one life left, in which the ball is beside the bridge, at ({x}, 0.6, 0) m, "
        "and moves at (3, -9, 0) m/s; three calls to game.step(1/60)"
    )
    about.cause = "The ball keeps moving after the game is over. Return from step at once if "
    about.cause += "self.rules.over is true."
    seen = played(3, FRAME, 1, (x, 0.6, 0.0), (3.0, -9.0, 0.0), lives=1)
    expect_exactly(seen[-1]["lives"], 0, then="; the number of lives that are left")
    expect_close(
        seen[-1]["place"],
        seen[0]["place"],
        then="; the position of the ball, which should not change after the first step",
        unit="m",
        tolerance=0.0,
    )
    x = seen[-1]["place"][0]
    about.cause = "You put the ball back although no lives are left. Put it back only if the game "
    about.cause += "is not over."
    name = "; the final position of the ball along X"
    expect_that(x > 7.0, f"{x:.3g} m", "more than 7 m, which is beside the bridge", then=name)


@pytest.mark.exercise("P8.1b", asks="or do nothing if the game is over")
def test_the_last_row_ends_the_game(rng: Random) -> None:
    about.read = STEP
    row = rng.randint(1, 4)
    visited = [i for i in range(6) if i != row]
    x = FIRST + 2.0 * row
    about.call = (
        f"a game in which all rows but {row} are visited, and the ball falls on row {row} at 6 m/s "
        "from 0.05 m above; three calls to game.step(1/60)"
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
        then="; the position of the ball, which should not change after the first step",
        unit="m",
        tolerance=0.0,
    )
