"""The rope bridge: the ball on its deck, B8.5."""

from __future__ import annotations

from itertools import pairwise
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch08_mass_aggregate.bridge import Deck
from ch08_mass_aggregate.scene_probes import told
from draw import Components, positive_number
from expect import expect_close, expect_exactly, expect_that, named
from unmoved import expect_all_kept

NEAREST = "the docstring of Deck.nearest"
DECK = "book 8.2.1, and the docstring of Deck.contacts"
UP = (0.0, 1.0, 0.0)
STRAIGHT = "The deck is a straight line from midpoint to midpoint, so interpolate its height at "
STRAIGHT += "the ball's x. The nearest row is the one whose midpoint is closer to the ball along X."
FIRST = "Return the first one of two rows that are equally near."
ENDS = "Your deck {}. It should end half a SPACING, which is 1 m, beyond its outermost rows."
TOUCHES = "The ball just touches the deck. Return two contacts even if their penetration is 0."
Rows = list[tuple[Components, Components]]


def draw_rows(rng: Random, count: int) -> Rows:
    """Draw rows in order along X, 1 to 3 m apart, at heights from 3 to 5 m."""
    x, rows = positive_number(rng, 1.0, 4.0), []
    for _ in range(count):
        left, right = positive_number(rng, 3.0, 5.0), positive_number(rng, 3.0, 5.0)
        rows.append(((x - 0.1, left, -1.0), (x + 0.1, right, 1.0)))
        x = round(x + positive_number(rng, 1.0, 3.0), 3)
    return rows


def level_rows(*heights: float) -> Rows:
    """Return rows 2 m apart whose ends have the same height."""
    return [((2.0 * i, y, -1.0), (2.0 * i, y, 1.0)) for i, y in enumerate(heights)]


def middles(rows: Rows) -> list[tuple[float, float]]:
    """Return x and y of the midpoints of the rows, without the rounding of their sums."""
    return [(round(0.5 * (a[0] + b[0]), 9), round(0.5 * (a[1] + b[1]), 9)) for a, b in rows]


def shown(rows: Rows) -> str:
    """Return in words a deck of these rows."""
    return f"a deck; the midpoints of its rows are at (x, y) = {str(middles(rows))[1:-1]} m; "


def nearest(rows: Rows, x: float, cause: str) -> Any:
    """Return the row nearest to a ball at x, and the height of the deck there."""
    called = "deck.nearest(), which returns (row, height)"
    with calls(cause, f"{shown(rows)}a ball at x = {x:.6g} m; {called}"):
        ends = [(Particle(Vector3(*a)), Particle(Vector3(*b))) for a, b in rows]
        return Deck(Particle(Vector3(x, 9.0, 0.5)), 0.5, ends, 0.0).nearest()


def contacts(rows: Rows, x: float, y: float, cause: str, radius: float = 0.5, c: float = 0) -> Any:
    """Return ball, end, normal, restitution and penetration of each contact, in order."""
    text = f"{shown(rows)}its restitution is {c}; particle 0 is a ball of radius {radius} m at "
    text += f"({x:.6g}, {y:.9g}, 0) m, and the others are the ends of the rows; deck.contacts()"
    with calls(cause, text):
        ball = Particle(Vector3(x, y), Vector3(0.0, 3.0))  # on its way up: it touches as well
        ends = [(Particle(Vector3(*a)), Particle(Vector3(*b))) for a, b in rows]
        numbered = [ball, *(end for row in ends for end in row)]
        return sorted(told(Deck(ball, radius, ends, c).contacts(), numbered))


@pytest.mark.exercise("B8.5", asks="a line of straight segments that connect", read=NEAREST)
def test_the_deck_is_a_line_from_row_to_row(rng: Random) -> None:
    rows = draw_rows(rng, 4)
    points = middles(rows)
    with calls("Work on copies of the positions.", "a deck of a single row; deck.nearest()"):
        a, b = (Particle(Vector3(*place)) for place in rows[0])
        Deck(Particle(), 0.5, [(a, b)], 0.0).nearest()
    expect_all_kept("the position of end {} of the row", (a.position, b.position), rows[0])
    for i, ((x, y), (u, v)) in reversed([*enumerate(pairwise(points))]):
        for share in (0.25, 0.4, 0.75):
            at = x + share * (u - x)
            got = nearest(rows, at, STRAIGHT)
            row, height = float(i + (share > 0.5)), y + share * (v - y)
            (_, one, _), (_, two, _) = (rows[n][0] for n in (i, i + 1))
            near = one + (at - rows[i][0][0]) / (rows[i + 1][0][0] - rows[i][0][0]) * (two - one)
            closer = "Return the row whose midpoint is closer along X."
            slips = {
                "You return (height, row). The row comes first.": (height, row),
                "You swapped the two rows in your interpolation.":
                    (row, y + (1.0 - share) * (v - y)),
                "You return the height of the nearest row itself.": (row, points[int(row)][1]),
                "You don't divide by the distance along X between the two midpoints.":
                    (row, y + (v - y) * (at - x)),
                "You return the mean height of two rows.": (row, 0.5 * (y + v)),
                "The height is right, but you return row 0, perhaps because you compare distances "
                "with their signs. Use their absolute values.": (0.0, height),
                f"The height is right, but you return the row before the ball. {closer}":
                    (float(i), height),
                f"The height is right, but you return the row after the ball. {closer}":
                    (float(i + 1), height),
                "You use the height of only one end of each row. Interpolate between the "
                "midpoints, because the two ends can differ in height.": (row, near),
            }  # fmt: skip
            expect_close(got, (row, height), slips, tolerance=1e-12)


@pytest.mark.exercise("B8.5", asks="If two rows are equally near, return the first", read=NEAREST)
def test_the_deck_at_its_rows_and_halfway(rng: Random) -> None:
    heights = [positive_number(rng, 3.0, 5.0) for _ in range(3)]
    rows = level_rows(*heights)
    for i, y in enumerate(heights):
        above = "The ball is directly above a row. Return that row's number and height."
        expect_close(nearest(rows, 2.0 * i, above), (float(i), y), tolerance=1e-12)
    for i, (low, high) in enumerate(pairwise(heights)):
        halfway = "The ball is halfway between two rows. Return the first, and the height midway."
        got, height = nearest(rows, 2.0 * i + 1.0, halfway), 0.5 * (low + high)
        slips = {f"You return the second row. {FIRST}": (i + 1.0, height)}
        expect_close(got, (float(i), height), slips, tolerance=1e-12)
    for x, i in ((-1.0, 0), (5.0, 2)):
        got = nearest(rows, x, ENDS.format("ends at its outermost rows"))
        right = f"row {i} at a height of {heights[i]:g} m"
        expect_that(got is not None, "None, which means that there is no deck", right)
        slope = "You continue the slope of the deck beyond its outermost row."
        slips = {slope: (float(i), 1.5 * heights[i] - 0.5 * heights[1])}
        level = f"The deck is level beyond row {i}, so return that row and its height."
        why = named(got, level, slips)
        expect_close(got, (float(i), heights[i]), cause=why, tolerance=1e-12)
    for x in (-0.5, 0.0, 0.5):
        alone = "The deck extends 1 m beyond a single row on both sides."
        expect_close(nearest(rows[:1], x, alone), (0.0, heights[0]), tolerance=1e-12)


@pytest.mark.exercise("B8.5", asks="half a SPACING beyond the first or last row", read=NEAREST)
def test_the_deck_ends_half_a_spacing_beyond(rng: Random) -> None:
    rows = draw_rows(rng, 3)
    (first, low), _, (last, high) = middles(rows)
    for at, row, height in (
        (first - 0.99, 0.0, low),
        (first, 0.0, low),
        (last, 2.0, high),
        (last + 0.99, 2.0, high),
    ):
        got = nearest(rows, at, ENDS.format("should continue at the height of its last row"))
        expect_close(got, (row, height), tolerance=1e-12)
    for at in (first - 1.001, last + 1.001):
        got = nearest(rows, at, f"{ENDS.format('extends too far')} Return None here.")
        expect_that(got is None, str(got), "None, because the deck ends there")
        none = "If nearest() returns None, return an empty list from contacts()."
        count = len(contacts(rows, at, 1.0, none, 0.3))
        expect_exactly(count, 0, then="; the number of contacts", unit="contacts")


@pytest.mark.exercise("B8.5", asks="with both ends of the nearest row", read=DECK)
def test_a_ball_stands_on_both_ends_of_the_nearest_row(rng: Random) -> None:
    rows = draw_rows(rng, 3)
    (x, y), (u, v), _ = middles(rows)
    radius, c = positive_number(rng, 0.2, 0.8), positive_number(rng, 0.1, 0.9)
    at, height = x + 0.75 * (u - x), y + 0.75 * (v - y)
    for depth in (0.3, 0.01, 0.0):
        why = "Return a contact for each end of the nearest row, with the ball as the particle."
        center = height + radius - (depth or 1e-13)  # rounding must not lift it off
        got = contacts(rows, at, center, why, radius, c)
        ends = [(a, b) for a, b, *_ in got]
        if ends == []:
            why = "You return no contacts although the ball touches the deck. In height + radius - "
            why += "y, either the radius is missing, or the sign is wrong."
            why = why if depth else TOUCHES
        elif ends in ([(0, 3)], [(0, 4)]):
            why = "You return a contact for only one end of the nearest row. Return one for each."
        elif ends == [(3, 0), (4, 0)]:
            why = f"You swapped particle and other. {why}"
        elif len(ends) > 2:
            why = f"You return contacts for other rows too. {why}"
        name = "; (particle, other) of each contact"
        expect_exactly(ends, [(0, 3), (0, 4)], then=name, cause=why)
        deep = "The penetration is how far the lowest point of the ball is below the deck."
        slips = {
            "You divide the penetration between the two contacts.": 0.5 * depth,
            "You left out the radius of the ball.": depth - radius,
        }
        for _, _, normal, restitution, penetration in list(got):
            for name, seen, wanted, near, cause in (
                ("normal", normal, UP, 1e-15,
                 "The deck pushes the ball up, so the normal of each contact is +Y."),
                ("restitution", restitution, c, 1e-12,
                 "The restitution is wrong. Pass self.restitution to each Contact."),
                ("penetration, in m,", penetration, depth, 1e-12, named(penetration, deep, slips)),
            ):  # fmt: skip
                then = f"; the {name} of a contact"
                expect_close(seen, wanted, then=then, cause=cause, tolerance=near)
    diameter = "The ball has fallen through only if the penetration is greater than its diameter."
    level = level_rows(4.0, 4.0, 4.0)
    for low, cause in ((4.5, TOUCHES), (3.5, diameter)):
        got = [depth for *_, depth in contacts(level, 2.0, low, cause)]
        expect_exactly(len(got), 2, then="; the number of contacts", unit="contacts")
        expect_close(got, (4.5 - low,) * 2, then="; the penetration of each", unit="m")
    for lift, count, cause in (
        (radius + 1e-6, 0, "The ball doesn't touch the deck, so there is no contact."),
        (1e-6 - radius, 2, "The top of the ball is above the deck, so it has not fallen through."),
        (-1e-6 - radius, 0, "Your contacts lift up a ball that has fallen through the deck. Return "
                            "none if the top of the ball is below the deck."),
    ):  # fmt: skip
        got = len(contacts(rows, at, height + lift, cause, radius, c))
        expect_exactly(got, count, then="; the number of contacts", unit="contacts")
