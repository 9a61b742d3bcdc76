"""Project 8.1, a ball game on the bridge: its rules and its play."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch08_mass_aggregate.ball_game import BallGame, Rules
from ch08_mass_aggregate.scene_probes import played
from draw import positive_number
from expect import expect_close, expect_exactly, expect_that, named

RULES = "the docstrings of Rules, landed and fell"
LANDINGS = "the docstrings of Landings and Landings.contacts"
STEP = "the docstring of BallGame.step"
FRAME = 1.0 / 60.0
FIRST = -5.0  # m, the position of the first row
NO_WIN = "All rows are visited, but won is False. Compare len(self.visited) with self.rows."
END = "The game is over if it is won, or if no lives are left. Then self.over must be True."


def play(rows: int, events: Sequence[int], cause: str) -> list[Any]:
    """Return score, lives, visited rows, won and over after each landing on a row or fall, -1."""
    told = ", ".join("rules.fell()" if row < 0 else f"rules.landed({row})" for row in events)
    seen = []
    with calls(cause, f"rules = Rules({rows}); {told}"):
        rules = Rules(rows)
        for row in events:
            rules.fell() if row < 0 else rules.landed(row)
            ends = bool(rules.won), bool(rules.over)
            seen.append((rules.score, rules.lives, sorted(rules.visited), *ends))
    return seen


def expect_all(*rows: tuple[str, Any, Any, str]) -> None:
    """Expect values, each with a name, the wanted value, and the cause if it is wrong."""
    for name, got, wanted, cause in rows:
        expect_exactly(got, wanted, then=f"; {name}", cause=cause)


@pytest.mark.exercise("P8.1a", asks="Later landings on the same row change nothing", read=RULES)
def test_a_row_counts_once(rng: Random) -> None:
    rows = rng.randint(5, 9)
    a, b = rng.sample(range(1, rows - 1), 2)  # other checks have the first and the last row
    once = "Only the first landing on a row scores POINTS, so check self.visited before that."
    seen = play(rows, [a, a, b, a, b], once)
    scores, visited = [score for score, *_ in seen], seen[-1][2]
    every = "Every landing scores, because visited stays empty. Add the row to self.visited."
    if visited:
        every = "Every landing scores. Check first whether it is already in visited."
    early = "Your game already counts as won after the first landing. It is won with all rows."
    why = named(scores, once, {every: [10, 20, 30, 40, 50], early: [160] * 5})
    expect_all(
        ("the score after each call", scores, [10, 10, 20, 20, 20], why),
        ("rules.visited", visited, sorted((a, b)), "Add each row that was hit to self.visited."),
        ("rules.lives", seen[-1][1], 3, "A landing costs no life. Only a fall does."),
    )  # fmt: skip


@pytest.mark.exercise("P8.1a", asks="for each life that is left", read=RULES)
def test_all_rows_win_and_lives_are_a_bonus(rng: Random) -> None:
    rows = rng.randint(3, 6)
    order = rng.sample(range(rows), rows)
    events = [order[0], -1, *order[1:], order[0], -1]  # two lives are left, so neither one nor all
    points, score = 10 * rows, 10 * rows + 100
    exists = f"You reject a row that exists. Accept all rows from 0 to {rows - 1}."
    seen = play(rows, events, exists)
    (last, *_), (before, *_), (_, _, visited, won, over) = seen[-1], seen[rows - 1], seen[rows]
    missing = "You add no bonus. Either you leave it out, or you test self.won before the last row "
    missing += "is in visited. Add the row first, and then BONUS for each life that is left."
    if seen[rows][0] == points and play(rows, order, exists)[-1][0] != points:
        missing = "You remove rows from visited, so the game is never won. Keep them in fell."
    elif not won and list(visited) == [*range(rows)]:
        missing = NO_WIN
    low = "You leave out the POINTS for the last row. Add both these POINTS and the bonus."
    if seen[1][0] < seen[0][0]:
        low = "You take points away for a fall. A fall costs a life, but no points."
    elif before > points - 10:
        low = "Your game counts as won too early. It is won only when every row is in visited."
    lives = "A fall doesn't cost a life. Take one away in fell."
    if seen[1][1] < 3:
        lives = "You add the bonus for all three lives, although one of them is lost."
    bonus = "The row that wins scores POINTS, and BONUS, which is 50, for each life left."
    why = named(seen[rows][0], bonus, {
        missing: points, "You add the bonus only once.": points + 50, lives: points + 150,
        low: score - 10,
    })  # fmt: skip
    play(rows, events[: rows + 1], bonus)
    expect_all(
        ("rules.score", seen[rows][0], score, why),
        ("rules.won", won, True, NO_WIN),
        ("rules.over", over, True, f"The game is won, but over is False. {END}"),
    )
    early = "You add the bonus before the last row is visited. Add it only if self.won is true."
    play(rows, events[:rows], early)
    expect_exactly(before, points - 10, then="; rules.score", unit="points")
    play(rows, events, bonus)
    again = "still {} after the game is over. Return if self.over is true."
    expect_all(
        ("rules.score", last, score, f"A landing {again.format('scores')}"),
        ("rules.lives", seen[-1][1], 2, f"A fall {again.format('costs a life')}"),
    )


@pytest.mark.exercise("P8.1a", asks="Do nothing if the game is over", read=RULES)
def test_three_falls_are_the_end(rng: Random) -> None:
    a, b = rng.sample(range(1, 5), 2)
    why = "Each fall should cost one life, until no lives are left."
    seen = play(6, [-1, a, -1, -1, -1, b], why)
    scores, lives, _, _, overs = map(list, zip(*seen, strict=True))
    over = ("rules.over after each call", overs, [False] * 3 + [True] * 3,
            f"No lives are left, but over is False. {END}")  # fmt: skip
    if type(lives[-1]) is int and lives[-1] < 0:
        if not overs[3]:
            expect_all(over)
        why = "A fall costs a life although none is left. Return if self.over is true."
    changed = "A fall changes the score. It should only cost a life."
    if scores[-1] == 20:
        changed = "You count a landing after the game is over. Return at once if self.over."
    elif scores[0] == scores[1] == 0:
        changed = "A landing after a fall doesn't score. It should, unless the game is over."
    expect_all(
        ("the lives after each call", lives, [2, 2, 1, 0, 0, 0], why),
        over,
        ("rules.score", scores[-1], 10, changed),
        ("rules.visited", seen[-1][2], [a], "A fall should only cost a life."),
    )  # fmt: skip


@pytest.mark.exercise("P8.1b", asks="or is not moving toward them", read=LANDINGS)
def test_a_landing_is_seen_on_the_way_down(rng: Random) -> None:
    row = rng.randint(1, 4)
    before, beyond = FIRST + 2.0 * row - 0.5, FIRST + 2.0 * row + 0.5  # row is nearest to both
    depth, speed = round(rng.uniform(0.01, 0.2), 3), round(rng.uniform(2.0, 9.0), 3)
    for x, above, velocity, wanted, cause in (
        (before, -depth, -speed, row, "Set row to the row that deck.nearest() returns."),
        (beyond, -depth, -0.01, row, "The ball is moving down slowly, but it still lands. Count "
         "any negative separating velocity as a landing, without a minimum speed."),
        (before, -depth, speed, None, "The ball touches the deck but is moving up, so this is not "
         "a landing. Set row to None unless the separating velocity is negative."),
        (before, -depth, 0.0, None, "The ball touches the deck but is at rest, so this is not a "
         "landing. Set row only if the separating velocity is below 0, which it is not here."),
        (before, depth, -speed, None, "Without a contact, set row to None."),
    ):  # fmt: skip
        with calls(cause):
            game = BallGame()
            game.landings.row = 0
            game.ball.position = Vector3(x, 4.5 + above)
            game.ball.velocity = Vector3(1.0, velocity)
            found = game.landings.contacts()
        count, first = len(list(found)), game.landings.row
        lost = "Return exactly the contacts that self.deck.contacts() finds."
        if not count:
            lost = f"The ball falls through the bridge, because you return no contacts. {lost}"
        expect_all(("the number of contacts", count, 2 if above < 0.0 else 0, lost))
        expect_that(first == wanted, f"landings.row is {first}", f"landings.row is {wanted}")
        stale = "You keep the row of the earlier landing, or you set row without a contact. Set it "
        stale += "to None at the start of every call, and to a row only if there is a contact."
        with calls(stale, more=True):
            game.ball.position.y = 14.5
            game.landings.contacts()
        later = game.landings.row
        expect_that(later is None, f"landings.row is {later}", "landings.row is None")


def dropped(row: int, steps: int, cause: str, visited: Sequence[int] = ()) -> list[dict[str, Any]]:
    """Let the ball fall on a row from 0.05 m above it; return what there is after each step."""
    text = f"a game whose visited rows are {[*visited]}; the ball is 0.05 m above row {row} and "
    text += f"falls at 6 m/s; game.step(1/60){f', {steps} times' * (steps > 1)}"
    with calls(cause, text):
        x = FIRST + 2.0 * row
        return played(steps, FRAME, 0, (x, 4.55, 0.0), (0.0, -6.0, 0.0), visited=visited)


@pytest.mark.exercise("P8.1b", asks="so that it gets an acceleration of PUSH", read=STEP)
@pytest.mark.parametrize("direction", [-1, 0, 1])
def test_a_ball_is_steered(rng: Random, direction: int) -> None:
    x, speed = round(rng.uniform(-3.0, 3.0), 3), round(rng.uniform(-2.0, 2.0), 3)
    frame, mass = round(rng.uniform(0.005, 0.03), 4), positive_number(rng)
    with calls(
        "Add a force of direction * PUSH * mass along X between start_frame and run_physics.",
        f"a game with game.direction = {direction}; its ball of {mass} kg is at ({x}, 9, 0) m and "
        f"moves at ({speed}, 0, 0) m/s; three calls to game.step({frame}); the velocity of the "
        "ball",
    ):
        seen = played(3, frame, direction, (x, 9.0, 0.0), (speed, 0.0, 0.0), mass=mass)
    push = 8.0 * direction

    def after(acceleration: float, start: float, h: float = frame) -> float:
        for _ in range(3):
            start = (start + acceleration * h) * 0.6**h
        return start

    vy = after(-9.81, 0.0)
    slips = {
        f"The ball moved as in steps of 1/60 s, not {frame} s. Pass the duration to run_physics.":
            (after(push, speed, FRAME), after(-9.81, 0.0, FRAME), 0.0),
        "The ball's velocity doesn't change. Call self.world.run_physics after the push.":
            (speed, 0.0, 0.0),
    }  # fmt: skip
    if direction:
        slips |= {
            "The push has no effect. Add it after start_frame and before run_physics.":
                (after(0.0, speed), vy, 0.0),
            "You leave the mass out of the push. PUSH is an acceleration.":
                (after(push / mass, speed), vy, 0.0),
            "You set the velocity to PUSH. Add a force of PUSH * mass instead.":
                (push * 0.6**frame, vy, 0.0),
        }  # fmt: skip
    wanted = (after(push, speed), vy, 0.0)
    expect_close(seen[-1]["velocity"], wanted, slips, unit="m/s", tolerance=1e-12)


@pytest.mark.exercise("P8.1b", asks="Make the ball jump by setting", read=STEP)
def test_a_ball_jumps_from_where_it_lands(rng: Random) -> None:
    for row in (rng.randint(1, 4), 0):
        why = "After run_physics, check landings.row. If it is not None, call "
        why += "self.rules.landed(row) and set the ball's vertical velocity to JUMP."
        (seen,) = dropped(row, 1, why)
        if seen["score"] == 10:
            why = "The landing scores, but the ball doesn't jump. Set its velocity along Y to JUMP."
        elif row == 0:
            why = "You ignore a landing on row 0, as 0 is false. Write `if row is not None`."
        name = "; the ball's velocity along Y"
        expect_close(seen["velocity"][1], 6.0, then=name, unit="m/s", tolerance=1e-12, cause=why)
        expect_all(
            ("the score", seen["score"], 10, "The ball jumps, but the landing doesn't score. Call "
             "self.rules.landed(row) when landings.row is not None."),
            ("the visited rows", seen["visited"], [row], "You pass the wrong row. Pass "
             "self.landings.row to self.rules.landed."),
        )  # fmt: skip
    once = "The ball should land once and then rise, without landing again or costing a life. "
    once += "Check that landings.row is None while the ball moves up."
    last = dropped(row, 20, once)[-1]
    got = (last["score"], last["lives"])
    expect_close(got, (10.0, 3.0), then="; the score and the lives", tolerance=0.0)
    again = "A row that was visited before scores nothing, but the ball still jumps from it."
    (seen,) = dropped(row, 1, again, visited=[row])
    name = "; the velocity of the ball along Y in m/s, and the score"
    expect_close((seen["velocity"][1], seen["score"]), (6.0, 0.0), then=name, tolerance=1e-12)


@pytest.mark.exercise("P8.1b", asks="report the fall to the rules", read=STEP)
def test_the_ground_takes_a_life(rng: Random) -> None:
    x = round(rng.uniform(8.0, 9.0), 3)
    beside = f"a game; the ball is beside the bridge, at ({x}, 0.6, 0) m, with v = (3, -9, 0) m/s; "
    missed = "The ball has reached the ground, but you don't take a life. Call self.rules.fell()."
    with calls(missed, f"{beside}game.step(1/60)"):
        seen = played(1, FRAME, 1, (x, 0.6, 0.0), (3.0, -9.0, 0.0), visited=[2, 4])[-1]
    expect_all(
        ("the number of lives that are left", seen["lives"], 2, missed),
        ("the visited rows", seen["visited"], [2, 4], "A fall should only cost a life."),
    )
    # The cables, too short at first, have pulled the row inward by 0.13 m in that step.
    for name, wanted, unit, cause in (
        ("place", (FIRST, 6.0, 0.0), "m",
         "The ball stays on the ground after a fall. Put it back above the first row."),
        ("velocity", (0.0, 0.0, 0.0), "m/s",
         "The ball keeps its velocity after a fall. Call self.start_ball(), which stops it."),
    ):  # fmt: skip
        then = f"; the {name.replace('place', 'position')} of the ball"
        expect_close(seen[name], wanted, then=then, unit=unit, cause=cause, tolerance=0.2)
    for above, lives in ((5e-7, 2), (5e-6, 3)):
        with calls(
            "The ball has fallen if its lowest point is at most TOUCH, which is 1e-6 m, above the "
            "ground. That point is one radius below the ball's center.",
            f"a game in which the ball is beside the bridge, and its lowest point is {above} m "
            "above the ground at the end of game.step(1/60); the number of lives that are left",
        ):
            # In one step gravity takes exactly its upward speed, so it stays where it is.
            seen = played(1, FRAME, 0, (x, 0.5 + above, 0.0), (0.0, 9.81 * FRAME, 0.0))[-1]
        expect_exactly(seen["lives"], lives)
    likely = "The ball keeps moving after the game is over. Return at once if self.rules.over."
    with calls(likely, f"{beside}one life is left; game.step(1/60), three times"):
        seen = played(3, FRAME, 1, (x, 0.6, 0.0), (3.0, -9.0, 0.0), lives=1)
    expect_exactly(seen[-1]["lives"], 0, then="; the number of lives that are left")
    expect_stopped(seen)
    why = "You put the ball back although no lives are left. Do so only until the game is over."
    x = seen[-1]["place"][0]
    name = "; the final position of the ball along X"
    beside = "more than 7 m, which is beside the bridge"
    expect_that(x > 7.0, f"{x:.3g} m", beside, then=name, cause=why)


def expect_stopped(seen: list[dict[str, Any]]) -> None:
    """Expect that the ball does not move after the first step."""
    name = "; the position of the ball, which should not change after the first step"
    expect_close(seen[-1]["place"], seen[0]["place"], then=name, unit="m", tolerance=0.0)


@pytest.mark.exercise("P8.1b", asks="or do nothing if the game is over", read=STEP)
def test_the_last_row_ends_the_game(rng: Random) -> None:
    row = rng.randint(1, 4)
    over = "The first step wins the game and adds POINTS and the bonus. After that the game is "
    over += "over, so step must not change the score or move the ball."
    seen = dropped(row, 3, over, visited=[i for i in range(6) if i != row])
    scores = [frame["score"] for frame in seen]
    expect_exactly(scores, [160] * 3, then="; the score after each step")
    expect_stopped(seen)
