"""Exercise 9.7: a box with stones, by sums and by balance lines."""

from __future__ import annotations

import math
from itertools import accumulate
from random import Random

import pytest

from ch09_rotations.exercise_probes import stones_after
from ch09_rotations.exercises import balance_offset, center_of_stones, masses_beside
from ch09_rotations.probes import entered_stones
from draw import number, positive_number
from expect import about, expect_close, expect_error, expect_exactly, expect_unchanged
from turning import TIGHT, named

CENTER = "the docstring of center_of_stones"
OFFSET = "the docstring of balance_offset"
BESIDE = "the docstring of masses_beside, and E-32"
DATA = "exercise 9.7, and the first lines of stones.py"

Stones = list[tuple[str, float, float, float]]
NAMES = ("a pebble", "slate", "a pebble", "quartz")  # two may have one name


def draw_stones(rng: Random, count: int = 4) -> Stones:
    """Draw stones within 1 m, two of one name and one mass."""
    masses = [positive_number(rng, 0.05, 0.9) for _ in range(3)]
    return [
        (
            name,
            mass,
            positive_number(rng, 0.0, 1.0),
            positive_number(rng, 0.0, 1.0),
        )
        for name, mass in list(zip(NAMES, (*masses, masses[0]), strict=True))[:count]
    ]


def draw_telling_stones(rng: Random) -> Stones:
    """Draw masses of stones of which each likely mistake of an edge at 0.3 puts one amiss."""
    a, b, c, d = (
        round(positive_number(rng, 0.9, 1.1) * mass, 3) for mass in (0.22, 0.07, 0.47, 0.51)
    )
    return [
        ("a pebble", a, 0.43, 0.94),
        ("slate", b, 0.28, 0.61),
        ("a pebble", c, 0.83, 0.51),
        ("quartz", a, 0.66, 0.55),
        ("the box", d, 0.49, 0.18),
    ]


def middle(stones: Stones) -> complex:
    """Return the centre of mass as a complex number."""
    total = math.fsum(mass for _, mass, _, _ in stones)
    return sum(mass * complex(x, y) for _, mass, x, y in stones) / total


def left_of(point: complex, angle: float) -> float:
    """Return how far to the left of a line through 0 a point is."""
    return (point * complex(math.cos(angle), -math.sin(angle))).imag


def from_edge(stones: Stones, angle: float) -> list[tuple[float, float]]:
    """Return how far to the left of the edge each stone is, and its mass."""
    line = left_of(middle(stones), angle)
    return [(left_of(complex(x, y), angle) - line, mass) for _, mass, x, y in stones]


def beside(stones: Stones, angle: float) -> tuple[float, float]:
    """Return the masses on the left and on the right of the edge."""
    sides = from_edge(stones, angle)
    left = math.fsum(mass for side, mass in sides if side > 0.0)
    return left, math.fsum(mass for side, mass in sides if side < 0.0)


def center_slips(stones: Stones) -> dict[str, tuple[float, float]]:
    """Return what likely mistakes make of a centre of mass."""
    swapped = middle(stones).imag, middle(stones).real
    ends = {
        "the mean of the places, whatever the masses": middle(
            [(n, 1.0, x, y) for n, _, x, y in stones]
        ),
        "what comes of leaving out the first stone, or of one stone for each name": middle(
            stones[1:] or stones
        ),
        "what comes of leaving out the last stone": middle(stones[:-1] or stones),
        "the sum of mass times place, not divided": middle(stones)
        * sum(m for _, m, _, _ in stones),
    }
    return {"x and y exchanged": swapped} | {name: (z.real, z.imag) for name, z in ends.items()}


@pytest.mark.exercise("9.7")
def test_the_centre_of_a_box_with_stones(rng: Random) -> None:
    about.read = CENTER
    about.cause = "center_of_mass of the second number of each stone, and of its third and fourth"
    for count in (1, 4):
        stones = draw_stones(rng, count)
        about.call = f"center_of_stones({stones})"
        got = center_of_stones(stones)
        wanted = middle(stones)
        why = named(got, about.cause, center_slips(stones))
        expect_close(got, (wanted.real, wanted.imag), cause=why, tolerance=TIGHT)


def offset_slips(stones: Stones, angle: float) -> dict[str, float]:
    """Return what likely mistakes make of where the edge lies."""
    center = middle(stones)
    sides = sorted((left_of(complex(x, y), angle), mass) for _, mass, x, y in stones)
    passed = accumulate(mass for _, mass in sides)
    half = 0.5 * math.fsum(mass for _, mass in sides)
    offset = next(side for (side, _), mass in zip(sides, passed, strict=True) if mass >= half)
    return {
        "the offset to the right, not to the left": -left_of(center, angle),
        "the distance along the edge, not to the left of it": left_of(
            center, angle - 0.5 * math.pi
        ),
        "what comes of the angle taken for degrees": left_of(center, math.radians(angle)),
        "where the masses on both sides are as equal as they come, which is no balance (E-32)": (
            offset
        ),
    }


@pytest.mark.exercise("9.7")
def test_where_the_edge_must_lie(rng: Random) -> None:
    about.read = OFFSET
    stones = draw_stones(rng)
    about(f"balance_offset({stones}, 0)", cause="an edge along X, below the centre of mass: its y")
    got = balance_offset(stones, 0.0)
    why = named(got, about.cause, offset_slips(stones, 0.0))
    expect_close(got, middle(stones).imag, cause=why, tolerance=TIGHT)
    about.cause = "the centre of mass times (-sin, cos), as a scalar product: mind the sign"
    small, large = positive_number(rng, 0.3, 1.4), positive_number(rng, 1.7, 3.0)
    for angle in (0.5 * math.pi, small, -small, large, -large, large + math.tau):
        about.call = f"balance_offset({stones}, {angle})"
        wanted = left_of(middle(stones), angle)
        got = balance_offset(stones, angle)
        why = named(got, about.cause, offset_slips(stones, angle))
        expect_close(got, wanted, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("9.7")
def test_it_balances_though_the_masses_differ() -> None:
    about.read = BESIDE
    stones = [("near and heavy", 3.0, 0.2, 0.4), ("far and light", 1.0, 0.6, 0.8)]
    about.call = f"masses_beside({stones}, 0)"
    about.cause = "y is 0.5 at the edge: 1 kg lies beyond, on the left of an edge along X, and 3 "
    about.cause += "kg here"
    got = masses_beside(stones, 0.0)
    slips = {
        "equal masses, as the book has them, which is wrong (E-32)": (2.0, 2.0),
        "left and right exchanged": (3.0, 1.0),
        "the numbers of stones, not their masses": (1.0, 1.0),
        "all on the left, as of a line through the corner, not the centre of mass": (4.0, 0.0),
    }
    why = named(got, about.cause, slips)
    expect_close(got, (1.0, 3.0), cause=why, tolerance=TIGHT)
    about.call = f"masses_beside({stones}, pi / 2)"
    about.cause = "x is 0.3 at the edge: an edge along Y has the smaller x on its left"
    got = masses_beside(stones, 0.5 * math.pi)
    expect_close(got, (3.0, 1.0), tolerance=TIGHT)


@pytest.mark.exercise("9.7")
def test_the_masses_on_both_sides(rng: Random) -> None:
    about.read = BESIDE
    about.cause = "a stone is on the left where its own offset is larger than the edge's"
    cases = [(draw_telling_stones(rng), 0.3)]
    while len(cases) < 4:
        stones, angle = draw_stones(rng), number(rng, 0.1, 3.0)
        # A stone on the edge has a check of its own.
        if min(abs(side) for side, _ in from_edge(stones, angle)) > 1e-3:
            cases.append((stones, angle))
    for stones, angle in cases:
        about.call = f"masses_beside({stones}, {angle})"
        got, wanted = tuple(masses_beside(stones, angle)), beside(stones, angle)
        expect_close(got, wanted, tolerance=TIGHT)


@pytest.mark.exercise("9.7")
def test_a_stone_over_the_edge_is_on_neither_side(rng: Random) -> None:
    about.read = BESIDE
    mass, far = positive_number(rng), positive_number(rng, 0.1, 0.9)
    x, y, angle = positive_number(rng), positive_number(rng), number(rng, 0.3, 1.4)
    across = complex(-math.sin(angle), math.cos(angle)) * far
    stones = [
        ("over it", mass, x, y),
        ("left of it", 0.7, x + across.real, y + across.imag),
        ("right of it", 0.7, x - across.real, y - across.imag),
    ]
    about.call = f"masses_beside({stones}, {angle})"
    about.cause = "rounding leaves it at some 1e-16 m: within 1e-9 m is over the edge"
    got = tuple(masses_beside(stones, angle))
    expect_close(got, (0.7, 0.7), tolerance=TIGHT)
    for off, wanted in ((3e-9, (0.4, 0.4)), (3e-10, (0.0, 0.0))):
        about.cause = f"within 1e-9 m is over the edge, and {off:.0e} m is "
        about.cause += f"{'less' if off < 1e-9 else 'more'}"
        stones = [("left", 0.4, 0.3, 0.5 + off), ("right", 0.4, 0.6, 0.5 - off)]
        about.call = f"masses_beside({stones}, 0), {off} m from the edge"
        got = tuple(masses_beside(stones, 0.0))
        expect_close(got, wanted, tolerance=TIGHT)


@pytest.mark.exercise("9.7", weight=0.5)
@pytest.mark.parametrize("name", ["center_of_stones", "balance_offset", "masses_beside"])
def test_the_stones_stay_as_they_were(rng: Random, name: str) -> None:
    about.read = "the first lines of exercises.py"
    stones = draw_telling_stones(rng)
    about.call = f"{name}({stones}{'' if name == 'center_of_stones' else ', 0.3'})"
    about.cause = "the call must not change its list: sort, or take from, a copy"
    center = middle(stones)
    wanted = {
        "center_of_stones": (center.real, center.imag),
        "balance_offset": left_of(center, 0.3),
        "masses_beside": beside(stones, 0.3),
    }[name]
    got, after = stones_after(name, stones)
    expect_unchanged("the list", after, stones)
    about.cause = "right for one list as for another"
    expect_close(got, wanted, tolerance=TIGHT)


@pytest.mark.exercise("9.7")
@pytest.mark.robust
def test_a_box_of_nothing_has_no_centre(rng: Random) -> None:
    good = draw_stones(rng)
    calls = (
        ("center_of_stones", center_of_stones, ()),
        ("balance_offset", balance_offset, (0.3,)),
        ("masses_beside", masses_beside, (0.3,)),
    )
    about.cause = "center_of_mass refuses what is no box with stones"
    for name, function, more in calls:
        for stones in (
            [],
            [("a hole", 0.0, 0.1, 0.2)],
            [*good, ("a hole", 0.0, 0.1, 0.2)],
            [*good, ("a balloon", -0.01, 0.1, 0.2)],
            [*good, ("nowhere", 1.0, math.nan, 0.2)],
        ):
            expect_error(
                lambda function=function, stones=stones, more=more: function(stones, *more),
                ValueError,
                call=f"{name}{(stones, *more)}",
                allowed=lambda function=function, more=more: function(good, *more),
                read=f"the docstring of {name}",
            )
    about.cause = "finite of arguments.py refuses an angle that is none"
    for name, function, _ in calls[1:]:
        for angle in (math.nan, math.inf):
            expect_error(
                lambda function=function, angle=angle: function(good, angle),
                ValueError,
                call=f"{name}({good}, {angle})",
                allowed=lambda function=function: function(good, 0.3),
                read=f"the docstring of {name}",
            )


@pytest.mark.exercise("9.7")
def test_your_own_stones() -> None:
    about("center_of_stones(the stones of your stones.csv)", read=DATA)
    about.cause = "enter your own, one a line, with plain numbers of kg and m, such as: a flat "
    about.cause += "piece of slate,0.212,0.120,0.060"
    stones = [tuple(stone) for stone in entered_stones()]
    name = "your stones.csv: how many lines are there, if up to 4 count, three stones and the box"
    expect_exactly(min(len(stones), 4), 4, call=name)
    about.cause = "measure where each lies"
    places = {(x, y) for _, _, x, y in stones}
    name = "your stones.csv: in how many places do stones lie, if up to 3 count"
    expect_exactly(min(len(places), 3), 3, call=name)
    about.call = "center_of_stones(your stones)"
    got = center_of_stones(stones)
    wanted = middle(stones)
    about.cause = "center_of_mass of the second number of each stone, and of its third and fourth"
    expect_close(got, (wanted.real, wanted.imag), tolerance=TIGHT)
