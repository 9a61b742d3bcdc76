"""Project 8.1a, a ball game on the bridge: its rules."""

from __future__ import annotations

from random import Random

import pytest

from ch08_mass_aggregate.scene_probes import refused_row, ruled
from expect import about, blame, expect_exactly, expect_that

RULES = "the docstrings of Rules, landed and fell"


def calls(rows: int, events: list[int]) -> str:
    """Write the calls of the rules for some events: the row of each landing, or -1 for a fall."""
    made = ", ".join("fell()" if row < 0 else f"landed({row})" for row in events)
    return f"rules = Rules({rows}); calls of rules: {made}"


@pytest.mark.exercise("P8.1a")
def test_a_row_counts_once(rng: Random) -> None:
    rows = rng.randint(5, 9)
    a, b = rng.sample(range(1, rows - 1), 2)  # other checks have the first and the last row
    events = [a, a, b, a, b]
    about.read = RULES
    about.call = f"{calls(rows, events)}; the score after each call"
    about.cause = (
        "The first landing on a row scores POINTS, which is 10, and later landings on the same row "
        "score nothing. Check self.visited before you add points."
    )
    seen = ruled(rows, events)
    got = [score for score, *_ in seen]
    mistakes = [
        ([10, 20, 30, 40, 50], "Every landing scores in your game, even on a row that the ball has "
                               "visited before. Return at once if the row is already in visited."),
        ([160] * 5, "Your game already counts as won after the first landing, so it adds the "
                    "bonus. It is won only when every row has been visited."),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_exactly(got, [10, 10, 20, 20, 20])
    about.call = f"{calls(rows, events)}; rules.visited (as a list) and then rules.lives"
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
    about.read = RULES
    about.call = calls(rows, events)
    about.cause = (
        f"A bridge of {rows} rows has the rows 0 to {rows - 1}, and the ball may land on each of "
        "them. Your landed must accept the first and the last row too."
    )
    seen = ruled(rows, events)
    about.cause = (
        "Your score is wrong when the game is won. Each row scores POINTS, and the last one also "
        "adds BONUS, which is 50, for each life that is left."
    )
    won, before = seen[rows + falls - 1], seen[rows + falls - 2]
    score = 10 * rows + 50 * (3 - falls)
    points = 10 * rows
    missing = (
        "You leave out the bonus. When the ball lands on the last missing row, add BONUS for each "
        "life that is left."
    )
    if won[0] == points and ruled(rows, order)[-1][0] != points:
        missing = (
            "A fall removes rows from visited, so your game is not won when the ball has landed on "
            "all rows. A fall must not change visited."
        )
    short = (
        "Your score is 10 points too low, because the last row scores no POINTS. Add POINTS as "
        "well as the bonus."
    )
    if before[3]:
        short = (
            "Your game is won one row too early, so the last row scores nothing. Make won true "
            "only when all rows have been visited."
        )
    elif seen[1][0] < seen[0][0]:
        short = (
            "A fall costs points in your game. It must only cost a life, so leave score unchanged."
        )
    mistakes = [
        (points, missing),
        (points + 50, "You add the bonus only once. Multiply BONUS, which is 50, by the number of "
                      "lives that are left."),
        (points + 150, "You add the bonus for all three lives, although one of them is lost. "
                       "Multiply BONUS by the number of lives that are left."),
        (score - 10, short),
    ]  # fmt: skip
    blame(won[0], mistakes)
    expect_exactly(won[0], score, then="; the score once all rows are visited", unit="points")
    over = "Your over is false although the game is won. There are two ways in which the game can "
    over += "end: it is won, or no lives are left."
    if not won[3]:
        over = (
            "Your won is false although every row has been visited. Compare the number of visited "
        )
        over += "rows with the number of rows."
    expect_that(
        won[3:] == (True, True),
        f"won is {won[3]} and over is {won[4]}",
        "won is True and over is True",
        then="; rules.won and rules.over once all rows are visited",
        cause=over,
    )
    about.cause = (
        "You add points before the last row has been visited. Add the bonus only when self.won is "
        "true."
    )
    expect_exactly(before[0], 10 * (rows - 1), then="; the score before the last row is visited")
    got = list(seen[-1][:2])
    act, method = (
        ("fall still costs a life", "fell") if got[0] == score else ("landing scores", "landed")
    )
    about.cause = (
        f"A {act} after the game is over. Return from {method} at once if self.over is true."
    )
    expect_that(
        got == [score, 3 - falls],
        f"{got[0]} points, lives left: {got[1]}",
        f"{score} points, lives left: {3 - falls}",
        then="; the score and the lives at the end",
    )


@pytest.mark.exercise("P8.1a")
def test_three_falls_are_the_end(rng: Random) -> None:
    a, b = rng.sample(range(1, 5), 2)
    events = [-1, a, -1, -1, -1, b]
    about.read = RULES
    about.call = calls(6, events)
    about.cause = (
        "A fall must cost exactly one life, and a landing none. Subtract 1 from lives in fell."
    )
    seen = ruled(6, events)
    got = [lives for _, lives, *_ in seen]
    if min(got) < 0:
        about.cause = (
            "Your game goes on when no lives are left. Make over true then, so that fell does "
            "nothing."
        )
    expect_exactly(got, [2, 2, 1, 0, 0, 0], then="; the lives after each call")
    got = [over for *_, over in seen]
    wanted = [False, False, False, True, True, True]
    about.cause = (
        "Your over is wrong after some of these calls. It must be true once no lives are left."
    )
    expect_exactly(got, wanted, then="; rules.over after each call")
    about.cause = "A fall costs a life, but it must not change the score or the visited rows."
    got = [seen[-1][0], *seen[-1][2]]
    if got[0] == 20:
        about.cause = (
            "A landing still scores after the game is over. Return from landed at once if "
            "self.over is true."
        )
    expect_that(
        got == [10, a],
        f"{got[0]} points, visited rows: {got[1:]}",
        f"10 points, visited rows: {[a]}",
        then="; the score and the visited rows at the end",
    )


@pytest.mark.exercise("P8.1a")
@pytest.mark.robust
def test_rejects_a_row_that_does_not_exist(rng: Random) -> None:
    about.read = RULES
    rows = rng.randint(3, 6)
    for row in (rows, -1):
        about.call = f"Rules({rows}).landed({row})"
        about.cause = (
            f"Your landed accepts row {row}, which doesn't exist. Rows are numbered from 0 to rows "
            "- 1, so raise ValueError for any other number."
        )
        error, *after = refused_row(rows, row)
        expect_that(error == "ValueError", error, "ValueError")
        name = f"Rules({rows}).landed({row}); the score and the visited rows afterward"
        expect_exactly(
            after,
            [0, []],
            call=name,
            cause="The call raises an error, but only after it has changed the score or the "
            "visited rows. Check the row before you change anything.",
        )
    about.cause = "This row exists, so landed should accept it. Both 0 and rows - 1 are valid."
    for row in (0, rows - 1):
        about.call = f"Rules({rows}).landed({row})"
        error = refused_row(rows, row)[0]
        expect_that(error == "no error", error, "no error")
