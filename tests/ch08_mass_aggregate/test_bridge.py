"""The rope bridge: what holds it, and the ball on it, B8.4 and B8.5."""

from __future__ import annotations

import math
from itertools import pairwise
from random import Random
from typing import Any

import pytest

from ch08_mass_aggregate.scene_probes import bridge_links, deck, hung_bridge
from draw import Components, positive_number
from expect import about, blame, cause_of, expect_close, expect_exactly

LINKS = "the docstring of links_of"
NEAREST = "the docstring of Deck.nearest"
DECK = "book 8.2, and the docstring of Deck.contacts"
UP = (0.0, 1.0, 0.0)
# The bridge of the docstrings: six rows of two planks, 2 m apart, at a height of 4 m.
START = [(2.0 * (i // 2) - 5.0, 4.0, 2.0 * (i % 2) - 1.0) for i in range(12)]
SUPPORTS = (3.0, 3.5, 4.0, 4.0, 3.5, 3.0)  # m


def wanted_links(places: list[Components]) -> list[tuple[int, int, float]]:
    """Return ends and penetration of each link's contact, worked out from the docstring."""
    joined = [(2 * i, 2 * i + 1, 2.0) for i in range(6)]
    joined += [(i, i + 2, 1.9) for i in range(10)]
    wanted = []
    for i, j, length in joined:
        depth = math.dist(places[i], places[j]) - length
        is_rod = j == i + 1
        if depth >= 0.0 or is_rod:
            wanted.append((i, j, abs(depth)))
    for i, (x, _, z) in enumerate(START):
        depth = math.dist((1.1 * x, 6.0, 0.8 * z), places[i]) - SUPPORTS[i // 2]
        if depth >= 0.0:
            wanted.append((i, -1, depth))
    return wanted


@pytest.mark.exercise("B8.4")
@pytest.mark.parametrize(
    ("what", "which"),
    [("rods", "rod"), ("cables from row to row", "cable"), ("cables to the anchors", "support")],
)
def test_what_holds_the_planks(rng: Random, what: str, which: str) -> None:
    about.read = LINKS
    wide, low, long = (positive_number(rng, a, b) for a, b in ((1.2, 1.6), (2, 4), (1.2, 1.6)))
    places = [(long * x, y - low - 0.1 * x, wide * z) for x, y, z in START]
    about.call = f"links_of(make_rows()), then every plank pulled {low} m down and apart: "
    about.call += f"contacts() of the {what}, by ends (-1 is an anchor) and how much they are too "
    about.call += "long"
    about.cause = {
        "rod": "a rod of WIDTH joins the two ends of each row: six in all",
        "cable": "a cable of CABLE_LENGTH joins each end to that of the next row on its side: ten",
        "support": "an anchored cable of support_length(row) from anchor_of(end), as it is at the "
        "start: twelve in all",
    }[which]

    def picked(links: Any) -> list[Any]:
        kinds = {"rod": 1, "cable": 2}
        return sorted(
            (i, j, depth)
            for i, j, depth in links
            if (j < 0) == (which == "support") and (j < 0 or j - i == kinds.get(which))
        )

    links = [(i, j, depth) for i, j, _, _, depth in bridge_links(places)]
    got, wanted = picked(links), picked(wanted_links(places))
    ends, right = ([(i, j) for i, j, _ in some] for some in (got, wanted))
    wrong = [(pair, "missing") for pair in right if pair not in ends]
    wrong += [(pair, "too many") for i, pair in enumerate(ends) if pair in ends[:i]]
    wrong += [(pair, "no such link") for pair in ends if pair not in right]
    why = f"{wrong[0][0]} is {wrong[0][1]}: {about.cause}" if wrong else about.cause
    expect_exactly(ends, right, then=": which", cause=why)
    for (i, j, depth), (_, _, right) in zip(got, wanted, strict=True):
        # Lengths of some metres, rounded a few times.
        expect_close(depth, right, then=f": how much that of {(i, j)} is", tolerance=1e-12)


@pytest.mark.exercise("B8.4")
def test_nothing_else_holds_them() -> None:
    about.read = LINKS
    about.call = "links_of(make_rows()): contacts() at the start: ends, and how much they are too "
    about.call += "long"
    about.cause = "at the start only the cables from row to row are taut, by 0.1 m: the rods are "
    about.cause += "right, the supports slack"
    links = sorted((i, j) for i, j, *_ in bridge_links(START))
    expect_exactly(links, [(i, i + 2) for i in range(10)])
    places = [(0.8 * x, 4.5, z) for x, _, z in START]
    about.call = "links_of(make_rows()), then all pushed together along X: how many contacts"
    about.cause = "cables that are shorter than they may be do nothing, and the rods are right"
    count = len(bridge_links(places))
    mistakes = [
        (10, "the ten from row to row push: they are cables, and no rods"),
        (12, "the twelve to the anchors push: they are cables, and no rods"),
        (22, "the links from row to row and to the anchors push: they are cables, and no rods"),
    ]
    blame(count, mistakes)
    expect_exactly(count, 0)
    places = [(1.5 * x, 1.0, 1.5 * z) for x, _, z in START]
    about.call = "links_of(make_rows()), then all pulled apart: how many contacts, and their "
    about.call += "restitution"
    about.cause = "28 links: 6 rods, 10 cables and 12 supports; none bounces"
    found = bridge_links(places)
    got = (len(found), *{c for _, _, _, c, _ in found})
    expect_close(got, (28, 0.0), tolerance=0.0)


@pytest.mark.exercise("B8.4")
def test_a_bridge_that_hangs_keeps_its_lengths() -> None:
    about("the bridge, let go, after 2.5 s at 60 frames a second", read=LINKS)
    about.cause = "the supports end its fall: is each plank's end on one, with the length of its "
    about.cause += "row?"
    places = hung_bridge(150, 1.0 / 60.0)
    lowest = min(y for _, y, _ in places)
    expect_exactly(lowest > 0.0, True, then=": is its lowest plank above the ground")
    over = [math.dist(places[i], places[i + 2]) / 1.9 - 1.0 for i in range(10)]
    for i, (x, _, z) in enumerate(START):
        anchor = (1.1 * x, 6.0, 0.8 * z)
        over.append(math.dist(anchor, places[i]) / SUPPORTS[i // 2] - 1.0)
    # The resolver's default leaves 0.4 % at 60 frames a second; the book's bridge is to keep 2 %.
    expect_exactly(max(over) < 0.02, True, then=": is no cable over its length by more than 2 %")


def draw_rows(rng: Random, count: int) -> list[tuple[Components, Components]]:
    """Draw rows in order along X, 1 to 3 m apart, at heights from 3 to 5 m."""
    x, rows = positive_number(rng, 1.0, 4.0), []
    for _ in range(count):
        left, right = positive_number(rng, 3.0, 5.0), positive_number(rng, 3.0, 5.0)
        rows.append(((x - 0.1, left, -1.0), (x + 0.1, right, 1.0)))
        x = round(x + positive_number(rng, 1.0, 3.0), 3)
    return rows


def middles(rows: list[tuple[Components, Components]]) -> list[tuple[float, float]]:
    """Return x and y of the middles, without the rounding of their sums."""
    return [(round(0.5 * (a[0] + b[0]), 9), round(0.5 * (a[1] + b[1]), 9)) for a, b in rows]


@pytest.mark.exercise("B8.5")
def test_the_deck_is_a_line_from_row_to_row(rng: Random) -> None:
    about.read = NEAREST
    rows = draw_rows(rng, 4)
    points = middles(rows)
    about.cause = "between two rows the deck is on the straight line between their middles, and "
    about.cause += "the nearest row is the one whose middle is nearer along X"
    for i, ((x, y), (u, v)) in enumerate(pairwise(points)):
        for share in (0.25, 0.4, 0.75):
            at = x + share * (u - x)
            about.call = f"a deck through {points}, the ball at x = {at}: nearest()"
            got = deck((at, 9.0, 0.5), rows, 0.5, 0.0)["nearest"]
            row, height = float(i + (share > 0.5)), y + share * (v - y)
            (_, one, _), (_, two, _) = (rows[n][0] for n in (i, i + 1))
            near = one + (at - rows[i][0][0]) / (rows[i + 1][0][0] - rows[i][0][0]) * (two - one)
            mistakes = [
                ((row, points[int(row)][1]), "that is the height of the row: between two rows the "
                 "deck is on the straight line between their middles"),
                ((float(i), height), "that is the row before the ball: the nearest one is wanted"),
                ((float(i + 1), height), "that is the row after the ball: the nearest one is "
                 "wanted"),
                ((row, near), "that is from one end of each row: the line joins their middles"),
            ]  # fmt: skip
            wanted = (row, height)
            blame(got, mistakes)
            expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("B8.5")
def test_the_deck_at_its_rows_and_halfway(rng: Random) -> None:
    about.read = NEAREST
    heights = [positive_number(rng, 3.0, 5.0) for _ in range(3)]
    points = [(2.0 * i, y) for i, y in enumerate(heights)]
    rows = [((x, y, -1.0), (x, y, 1.0)) for x, y in points]
    for i, (x, y) in enumerate(points):
        about.call = f"a deck through {points}, the ball at x = {x}: nearest()"
        about.cause = "right above a row it is that row, and its height"
        got = deck((x, 9.0, 0.5), rows, 0.5, 0.0)["nearest"]
        expect_close(got, (float(i), y), tolerance=1e-12)
    for i, (low, high) in enumerate(pairwise(heights)):
        about.call = f"a deck through {points}, the ball at x = {2.0 * i + 1.0}: nearest()"
        about.cause = "of two rows that are equally near it is the first"
        got = deck((2.0 * i + 1.0, 9.0, 0.5), rows, 0.5, 0.0)["nearest"]
        wanted = (float(i), 0.5 * (low + high))
        expect_close(got, wanted, tolerance=1e-12)
    for x, i in ((-1.0, 0), (5.0, 2)):
        about.call = f"a deck through {points}, the ball at x = {x}: nearest()"
        about.cause = "None where it is further than half a SPACING beyond: just so far it is a "
        about.cause += "deck"
        got = deck((x, 9.0, 0.5), rows, 0.5, 0.0)["nearest"]
        expect_exactly(got is None, False, then=" is None")
        slope = heights[i] - heights[1]
        mistakes = [((float(i), heights[i] + 0.5 * slope), "beyond the rows the deck is level: the "
                     "line of the last two does not go on")]  # fmt: skip
        blame(got, mistakes)
        expect_close(got, (float(i), heights[i]), tolerance=1e-12)
    for x in (-0.5, 0.0, 0.5):
        about.call = f"a deck of the row at {points[0]} alone, the ball at x = {x}: nearest()"
        about.cause = "one row is the first and the last"
        got = deck((x, 9.0, 0.5), rows[:1], 0.5, 0.0)["nearest"]
        expect_close(got, (0.0, heights[0]), tolerance=1e-12)


@pytest.mark.exercise("B8.5")
def test_the_deck_ends_half_a_spacing_beyond(rng: Random) -> None:
    about.read = NEAREST
    rows = draw_rows(rng, 3)
    points = middles(rows)
    (first, low), (last, high) = points[0], points[-1]
    about.cause = "half a SPACING beyond the rows, so 1 m, the deck still is, as high as its last "
    about.cause += "row"
    for at, row, height in (
        (first - 0.99, 0, low),
        (first, 0, low),
        (last, 2, high),
        (last + 0.99, 2, high),
    ):
        about.call = f"a deck through {points}, the ball at x = {at}: nearest()"
        got = deck((at, 9.0, 0.0), rows, 0.3, 0.0)["nearest"]
        expect_close(got, (float(row), height), tolerance=1e-12)
    about.cause = "further out there is no deck: None, and no contact"
    for at in (first - 1.001, last + 1.001):
        about.call = f"a deck through {points}, the ball at ({at}, 1, 0)"
        got = deck((at, 1.0, 0.0), rows, 0.3, 0.0)
        nearest = -1.0 if got["nearest"] is None else got["nearest"]
        expect_close(nearest, -1.0, then=": nearest(), -1 for None")
        count = len(got["contacts"])
        expect_exactly(count, 0, then=": how many contacts")


@pytest.mark.exercise("B8.5")
def test_a_ball_stands_on_both_ends_of_the_nearest_row(rng: Random) -> None:
    about.read = DECK
    rows = draw_rows(rng, 3)
    (x, y), (u, v), _ = middles(rows)
    radius, c = positive_number(rng, 0.2, 0.8), positive_number(rng, 0.1, 0.9)
    at = x + 0.75 * (u - x)
    height = y + 0.75 * (v - y)
    for depth in (0.3, 0.01, 0.0):
        center = height + radius - depth
        about.call = f"a deck through {middles(rows)}, a ball of radius {radius} at ({at}, "
        about.call += f"{center}, 0), restitution {c}: contacts(), where the ball is number 0, the "
        about.call += "row's ends 3 and 4"
        about.cause = "both ends of the nearest row bear it: the ball is the particle, the normal "
        about.cause += "+Y, and the penetration height + radius - y: 0 where it only touches"
        if not depth:
            center = height + radius - 1e-13  # rounding must not lift it off
        got = sorted(deck((at, center, 0.0), rows, radius, c)["contacts"])
        ends = [(a, b) for a, b, *_ in got]
        if ends == []:
            about.cause = "it touches: its lowest point, its y less the radius, is at the deck or "
            about.cause += "in it"
        elif ends in ([(0, 3)], [(0, 4)]):
            about.cause = "both ends of the row bear it: two contacts"
        elif ends == [(3, 0), (4, 0)]:
            about.cause = "they are exchanged: the ball is the particle, an end of the row the "
            about.cause += "other"
        elif len(ends) > 2:
            about.cause = "only the nearest row bears it, by its two ends"
        expect_exactly(ends, [(0, 3), (0, 4)], then=": ends")
        for _, _, normal, restitution, penetration in list(got):
            expect_close(normal, UP, tolerance=1e-15)
            mistakes = [
                ((0.0, depth), "the restitution is left out: it is the deck's"),
                ((c, 0.5 * depth), "the depth is not shared: each contact has all of it"),
                ((c, depth - radius), "the radius is left out: height + radius - y"),
            ]
            got = (restitution, penetration)
            why = cause_of(got, mistakes, about.cause)
            expect_close(
                got, (c, depth), then=": restitution, penetration", cause=why, tolerance=1e-12
            )
    level = [((x, 4.0, -1.0), (x, 4.0, 1.0)) for x in (0.0, 2.0, 4.0)]
    for y, cause in (
        (4.5, "it touches where its lowest point is just at the deck: a contact of depth 0"),
        (
            3.5,
            "only what is deeper than it is high is below: with its top just at the deck it is in",
        ),
    ):
        about(f"a level deck at a height of 4, a ball of radius 0.5 at (2, {y}, 0): ", cause=cause)
        about.call += "contacts(), and the depth of each"
        got = [depth for *_, depth in deck((2.0, y, 0.0), level, 0.5, 0.0)["contacts"]]
        expect_exactly(len(got), 2, then=": how many")
        expect_close(got, (4.5 - y,) * 2)
    for where, lift, ends, cause in (
        ("just above it", radius + 1e-6, 0, "above the deck there is no contact"),
        ("whose top is just above it", 1e-6 - radius, 2, "in the deck it is lifted out"),
        ("whose top is just below it", -1e-6 - radius, 0, "what is all below has fallen off"),
    ):
        about(f"a deck through {middles(rows)}, a ball of radius {radius} {where}: ", cause=cause)
        about.call += "contacts()"
        count = len(deck((at, height + lift, 0.0), rows, radius, c)["contacts"])
        expect_exactly(count, ends, then=": how many")
