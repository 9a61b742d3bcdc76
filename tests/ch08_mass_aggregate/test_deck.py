"""The rope bridge: the ball on its deck, B8.5."""

from __future__ import annotations

from itertools import pairwise
from random import Random

import pytest

from ch08_mass_aggregate.scene_probes import deck, places_after
from draw import Components, positive_number
from expect import about, blame, cause_of, expect_close, expect_exactly, expect_that
from unmoved import expect_all_kept

NEAREST = "the docstring of Deck.nearest"
DECK = "book 8.2.1, and the docstring of Deck.contacts"
UP = (0.0, 1.0, 0.0)


def draw_rows(rng: Random, count: int) -> list[tuple[Components, Components]]:
    """Draw rows in order along X, 1 to 3 m apart, at heights from 3 to 5 m."""
    x, rows = positive_number(rng, 1.0, 4.0), []
    for _ in range(count):
        left, right = positive_number(rng, 3.0, 5.0), positive_number(rng, 3.0, 5.0)
        rows.append(((x - 0.1, left, -1.0), (x + 0.1, right, 1.0)))
        x = round(x + positive_number(rng, 1.0, 3.0), 3)
    return rows


def middles(rows: list[tuple[Components, Components]]) -> list[tuple[float, float]]:
    """Return x and y of the midpoints of the rows, without the rounding of their sums."""
    return [(round(0.5 * (a[0] + b[0]), 9), round(0.5 * (a[1] + b[1]), 9)) for a, b in rows]


def deck_of(points: list[tuple[float, float]]) -> str:
    """Return what a deck through these midpoints is called."""
    return f"a deck; the midpoints of its rows are at (x, y) = {', '.join(map(str, points))} m"


def nearest_of(points: list[tuple[float, float]], x: float) -> str:
    """Return what is called: nearest() of a deck through these midpoints, with the ball at x."""
    return (
        f"{deck_of(points)}; a ball at x = {x:.6g} m; deck.nearest(), which returns (row, height)"
    )


@pytest.mark.exercise("B8.5", asks="a line of straight segments that connect")
def test_the_deck_is_a_line_from_row_to_row(rng: Random) -> None:
    about.read = NEAREST
    rows = draw_rows(rng, 4)
    points = middles(rows)
    about.call = f"{deck_of(points[:1])}; deck.nearest()"
    expect_all_kept("the position of end {} of the row", places_after("deck", rows[0]), rows[0])
    about.cause = "Between two rows, the deck is a straight line from one midpoint to the next, so "
    about.cause += "interpolate its height at the ball's x. The nearest row is the one whose "
    about.cause += "midpoint is closer to the ball along X."
    for i, ((x, y), (u, v)) in reversed([*enumerate(pairwise(points))]):
        for share in (0.25, 0.4, 0.75):
            at = x + share * (u - x)
            about.call = nearest_of(points, at)
            got = deck((at, 9.0, 0.5), rows, 0.5, 0.0)["nearest"]
            row, height = float(i + (share > 0.5)), y + share * (v - y)
            (_, one, _), (_, two, _) = (rows[n][0] for n in (i, i + 1))
            near = one + (at - rows[i][0][0]) / (rows[i + 1][0][0] - rows[i][0][0]) * (two - one)
            mistakes = [
                ((height, row), "You return (height, row). The row comes first."),
                ((row, y + (1.0 - share) * (v - y)), "You swapped the two rows in your "
                                                     "interpolation. At the first row, the height "
                                                     "is that of the first row."),
                ((row, points[int(row)][1]),
                 "You return the height of the nearest row itself. Interpolate between the "
                 "midpoints on either side of the ball, because the deck slopes there."),
                ((row, y + (v - y) * (at - x)), "You don't divide by the distance along X between "
                                                "the two midpoints."),
                ((row, 0.5 * (y + v)), "You return the mean height of two rows. Interpolate by x."),
                ((0.0, height), "The height is right, but you return row 0, perhaps because you "
                                "compare distances with their signs. Use their absolute values."),
                ((float(i), height), "The height is right, but you return the row before the ball. "
                                     "Return the row whose midpoint is closer along X."),
                ((float(i + 1), height), "The height is right, but you return the row after the "
                                         "ball. Return the row whose midpoint is closer along X."),
                ((row, near), "You use the height of only one end of each row. Interpolate between "
                              "the midpoints, because the two ends can differ in height."),
            ]  # fmt: skip
            wanted = (row, height)
            blame(got, mistakes)
            expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("B8.5", asks="If two rows are equally near, return the first")
def test_the_deck_at_its_rows_and_halfway(rng: Random) -> None:
    about.read = NEAREST
    heights = [positive_number(rng, 3.0, 5.0) for _ in range(3)]
    points = [(2.0 * i, y) for i, y in enumerate(heights)]
    rows = [((x, y, -1.0), (x, y, 1.0)) for x, y in points]
    for i, (x, y) in enumerate(points):
        about.call = nearest_of(points, x)
        about.cause = "The ball is directly above a row, so nearest() should return that row's "
        about.cause += "number and height."
        got = deck((x, 9.0, 0.5), rows, 0.5, 0.0)["nearest"]
        expect_close(got, (float(i), y), tolerance=1e-12)
    for i, (low, high) in enumerate(pairwise(heights)):
        about.call = nearest_of(points, 2.0 * i + 1.0)
        about.cause = "The ball is halfway between two rows. Return the first row and the height "
        about.cause += "midway."
        got = deck((2.0 * i + 1.0, 9.0, 0.5), rows, 0.5, 0.0)["nearest"]
        wanted = (float(i), 0.5 * (low + high))
        last = "You return the second of two rows that are equally near. Return the first one."
        blame(got, [((i + 1.0, wanted[1]), last)])
        expect_close(got, wanted, tolerance=1e-12)
    for x, i in ((-1.0, 0), (5.0, 2)):
        about.call = nearest_of(points, x)
        about.cause = "Your deck ends at its outermost rows. It should extend half a SPACING, "
        about.cause += "which is 1 m, beyond them."
        got = deck((x, 9.0, 0.5), rows, 0.5, 0.0)["nearest"]
        right = f"row {i} at a height of {heights[i]:g} m"
        expect_that(got is not None, "None, which means that there is no deck", right)
        about.cause = f"Beyond row {i} the deck is level, so return that row and its height."
        slope = heights[i] - heights[1]
        mistakes = [((float(i), heights[i] + 0.5 * slope),
                     "You continue the slope of the deck beyond its outermost row. The deck is "
                     "level there, so return the height of that row.")]  # fmt: skip
        blame(got, mistakes)
        expect_close(got, (float(i), heights[i]), tolerance=1e-12)
    for x in (-0.5, 0.0, 0.5):
        about.call = (
            f"a deck of a single row with its midpoint (x, y) at {points[0]} m; a ball at x = {x} "
            "m; deck.nearest(), which returns (row, height)"
        )
        about.cause = "A single row is both the first and the last one, so the deck extends 1 m "
        about.cause += "beyond it on both sides."
        got = deck((x, 9.0, 0.5), rows[:1], 0.5, 0.0)["nearest"]
        expect_close(got, (0.0, heights[0]), tolerance=1e-12)


@pytest.mark.exercise("B8.5", asks="half a SPACING beyond the first or last row")
def test_the_deck_ends_half_a_spacing_beyond(rng: Random) -> None:
    about.read = NEAREST
    rows = draw_rows(rng, 3)
    points = middles(rows)
    (first, low), (last, high) = points[0], points[-1]
    about.cause = "Beyond its first and last rows the deck continues at the height of that row for "
    about.cause += "half a SPACING, which is 1 m."
    for at, row, height in (
        (first - 0.99, 0, low),
        (first, 0, low),
        (last, 2, high),
        (last + 0.99, 2, high),
    ):
        about.call = nearest_of(points, at)
        got = deck((at, 9.0, 0.0), rows, 0.3, 0.0)["nearest"]
        expect_close(got, (float(row), height), tolerance=1e-12)
    for at in (first - 1.001, last + 1.001):
        about.cause = "Your deck extends too far. It ends half a SPACING, which is 1 m, beyond "
        about.cause += "its outermost rows, so return None here."
        about.call = f"{deck_of(points)}; a ball at ({at:.6g}, 1, 0) m"
        outside, about.cause = about.cause, "There is no deck below the ball, so nearest() returns "
        about.cause += "None. Return an empty list from contacts() in this case."
        got = deck((at, 1.0, 0.0), rows, 0.3, 0.0)
        about.cause = outside
        nearest = got["nearest"]
        name = f"{about.call}; deck.nearest(), which returns (row, height)"
        expect_that(nearest is None, str(nearest), "None, because the deck ends there", call=name)
        about.cause = "There is no deck below the ball, so contacts() should return no contacts."
        about.call += "; deck.contacts()"
        count = len(got["contacts"])
        expect_exactly(count, 0, then="; the number of contacts", unit="contacts")


@pytest.mark.exercise("B8.5", asks="with both ends of the nearest row")
def test_a_ball_stands_on_both_ends_of_the_nearest_row(rng: Random) -> None:
    about.read = DECK
    rows = draw_rows(rng, 3)
    (x, y), (u, v), _ = middles(rows)
    radius, c = positive_number(rng, 0.2, 0.8), positive_number(rng, 0.1, 0.9)
    at = x + 0.75 * (u - x)
    height = y + 0.75 * (v - y)
    for depth in (0.3, 0.01, 0.0):
        center = height + radius - depth
        about.call = (
            f"{deck_of(middles(rows))}; the restitution of the deck is {c}; "
            f"a ball of radius {radius} m at ({at:g}, {center:.6g}, 0) m; "
            "particle 0 is the ball, and particles 3 and 4 are the ends of the nearest row; "
            "deck.contacts()"
        )
        about.cause = "The ball rests on the nearest row, so return one contact for each end of "
        about.cause += "that row. In both, the ball is the particle and the end is the other."
        if not depth:
            center = height + radius - 1e-13  # rounding must not lift it off
        got = sorted(deck((at, center, 0.0), rows, radius, c)["contacts"])
        ends = [(a, b) for a, b, *_ in got]
        if ends == []:
            about.cause = (
                "You return no contacts although the ball touches the deck. The penetration is "
                "height + radius - y: either the radius is missing, or the sign is wrong."
            )
            if not depth:
                about.cause = (
                    "You return no contacts for a ball that just touches the deck. Return "
                )
                about.cause += "two contacts with a penetration of 0."
        elif ends in ([(0, 3)], [(0, 4)]):
            about.cause = (
                "You return a contact for only one end of the nearest row. Return one for "
            )
            about.cause += "each of its two ends."
        elif ends == [(3, 0), (4, 0)]:
            about.cause = "You swapped particle and other. The normal points toward the ball, so "
            about.cause += "pass the ball as particle and the end of the row as other."
        elif len(ends) > 2:
            about.cause = "You return contacts for other rows too. Return only those for the two "
            about.cause += "ends of the nearest row, on which the ball rests."
        expect_exactly(ends, [(0, 3), (0, 4)], then="; (particle, other) of each contact")
        for _, _, normal, restitution, penetration in list(got):
            about.cause = "The deck pushes the ball up, so the normal of each contact is +Y."
            expect_close(normal, UP, then="; the normal of a contact", tolerance=1e-15)
            about.cause = "The restitution is wrong. Pass self.restitution to each Contact."
            expect_close(restitution, c, then="; the restitution of a contact", tolerance=1e-12)
            mistakes = [
                (0.5 * depth, "You divide the penetration between the two contacts. Give each of "
                              "them the full penetration."),
                (depth - radius, "You left out the radius of the ball. Its lowest point is one "
                                 "radius below its center."),
            ]  # fmt: skip
            name = f"{about.call}; the penetration of a contact"
            why = "The penetration is how far the lowest point of the ball is below the deck."
            why = cause_of(penetration, mistakes, why)
            expect_close(penetration, depth, call=name, cause=why, unit="m", tolerance=1e-12)
    level = [((x, 4.0, -1.0), (x, 4.0, 1.0)) for x in (0.0, 2.0, 4.0)]
    for y, cause in (
        (4.5, "You return no contacts if the ball just touches the deck. Return two contacts even "
              "if their penetration is 0."),
        (3.5, "You return no contacts if the penetration equals the ball's diameter. The ball has "
              "fallen through only if the penetration is greater than its diameter."),
    ):  # fmt: skip
        about(
            f"a level deck at a height of 4 m; a ball of radius 0.5 m at (2, {y}, 0)", cause=cause
        )
        about.call += "; deck.contacts()"
        got = [depth for *_, depth in deck((2.0, y, 0.0), level, 0.5, 0.0)["contacts"]]
        expect_exactly(len(got), 2, then="; the number of contacts", unit="contacts")
        expect_close(got, (4.5 - y,) * 2, then="; the penetration of each", unit="m")
    for where, lift, ends, cause in (
        ("just above", radius + 1e-6, 0, "The ball is above the deck and doesn't touch it, so "
                                            "there should be no contact."),
        ("whose top is just above", 1e-6 - radius, 2, "The top of the ball is still above the "
                                                         "deck, so the ball has not fallen through "
                                                         "yet and is still in contact."),
        ("whose top is just below", -1e-6 - radius, 0, "Your contacts lift up a ball that has "
                                                       "fallen through the deck. Return none if "
                                                       "the top of the ball is below the deck."),
    ):  # fmt: skip
        about(
            f"{deck_of(middles(rows))}; a ball of radius {radius} m {where} the deck; ",
            cause=cause,
        )
        about.call += "deck.contacts()"
        count = len(deck((at, height + lift, 0.0), rows, radius, c)["contacts"])
        expect_exactly(count, ends, then="; the number of contacts", unit="contacts")
