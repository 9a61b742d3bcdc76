"""Exercise 9.7: a box with stones, by sums and by balance lines."""

from __future__ import annotations

import math
from itertools import accumulate
from random import Random

import pytest

from calls import calls
from ch09_rotations.exercise_probes import stones_after
from ch09_rotations.exercises import balance_offset, center_of_stones, masses_beside
from ch09_rotations.probes import entered_stones
from draw import number, positive_number
from expect import expect_close, expect_exactly, expect_unchanged
from turning import TIGHT

CENTER = "the docstring of center_of_stones"
OFFSET = "the docstring of balance_offset"
BESIDE = "the docstring of masses_beside, and E-32"
TOP = "the docstring at the top of exercises.py"
DATA = "exercise 9.7, and the docstring at the top of stones.py"
USE = "Call center_of_mass with the masses and the (x, y) positions of the stones."
Pair = tuple[float, float]
Stones = list[tuple[str, float, float, float]]


def draw_stones(rng: Random, count: int = 4) -> Stones:
    """Draw stones within 1 m. Two have the same name, and two the same mass."""
    a, b, c = (positive_number(rng, 0.05, 0.9) for _ in range(3))
    names = (("a pebble", a), ("slate", b), ("a pebble", c), ("quartz", a))
    places = [(positive_number(rng, 0.0, 1.0), positive_number(rng, 0.0, 1.0)) for _ in names]
    return [(*named, *place) for named, place in zip(names, places, strict=True)][:count]


def draw_telling_stones(rng: Random) -> Stones:
    """Draw stones for which every likely mistake puts one on the wrong side of an edge at 0.3."""
    a, b, c, d = (round(rng.uniform(0.9, 1.1) * mass, 3) for mass in (0.22, 0.07, 0.47, 0.51))
    return [
        ("a pebble", a, 0.43, 0.94),
        ("slate", b, 0.28, 0.61),
        ("a pebble", c, 0.83, 0.51),
        ("quartz", a, 0.66, 0.55),
        ("the box", d, 0.49, 0.18),
    ]


def with_stones(stones: Stones, call: str) -> str:
    """Return what is called: a function of these stones, which are written one per line."""
    each = (f"({name!r}, {m:.6g}, {x:.6g}, {y:.6g})" for name, m, x, y in stones)
    lines = ",\n    ".join(each)
    return f"stones = [{lines}], where each stone is (name, mass, x, y); {call}"


def middle(stones: Stones) -> complex:
    """Return the center of mass as a complex number."""
    total = math.fsum(mass for _, mass, _, _ in stones)
    return sum(mass * complex(x, y) for _, mass, x, y in stones) / total


def left_of(point: complex, angle: float) -> float:
    """Return the distance of a point to the left of a line through 0."""
    return (point * complex(math.cos(angle), -math.sin(angle))).imag


def from_edge(stones: Stones, angle: float) -> list[Pair]:
    """Return the distance of each stone to the left of the edge, and its mass."""
    line = left_of(middle(stones), angle)
    return [(left_of(complex(x, y), angle) - line, mass) for _, mass, x, y in stones]


def beside(stones: Stones, angle: float) -> Pair:
    """Return the masses on the left and on the right of the edge."""
    sides = from_edge(stones, angle)
    left = math.fsum(mass for side, mass in sides if side > 0.0)
    return left, math.fsum(mass for side, mass in sides if side < 0.0)


@pytest.mark.exercise("9.7", asks="compute the center of mass (x, y) of a box", read=CENTER)
def test_the_center_of_a_box_with_stones(rng: Random) -> None:
    for count in (4, 1):
        stones = draw_stones(rng, count)
        with calls(USE, with_stones(stones, "center_of_stones(stones)")):
            got = center_of_stones(stones)
        wanted = middle(stones)
        ends = {
            "You swap x and y. Pass each position as (x, y).": complex(wanted.imag, wanted.real),
            "You take the mean of the positions, which ignores the masses. Pass the masses to "
            "center_of_mass.": middle([(n, 1.0, x, y) for n, _, x, y in stones]),
            "You leave out the first stone, which has the same name as the third. Count every "
            "stone.": middle(stones[1:] or stones),
            "You leave out the last stone.": middle(stones[:-1] or stones),
            "You don't divide by the total mass.": wanted * sum(m for _, m, _, _ in stones),
        }
        slips = {name: (z.real, z.imag) for name, z in ends.items()}
        expect_close(got, (wanted.real, wanted.imag), slips, tolerance=TIGHT)


def offset_slips(stones: Stones, angle: float) -> dict[str, float]:
    """Return the offsets that likely mistakes give."""
    center = middle(stones)
    cosine, sine = math.cos(angle), math.sin(angle)
    sides = sorted((left_of(complex(x, y), angle), mass) for _, mass, x, y in stones)
    half = 0.5 * math.fsum(mass for _, mass in sides)
    passed = accumulate(mass for _, mass in sides)
    offset = next(side for (side, _), mass in zip(sides, passed, strict=True) if mass >= half)
    # The first angle is 0, and the offset is then positive.
    sign = "You measure the offset to the right, so its sign is wrong. Measure it to the left."
    if angle:
        sign = "Your offset is never negative. It must be if the edge is right of the corner."
    return {
        sign: -left_of(center, angle),
        "You add the two products.": cosine * center.imag + sine * center.real,
        "You swap sine and cosine.": sine * center.imag - cosine * center.real,
        "You measure the offset along the edge.": left_of(center, angle - 0.5 * math.pi),
        "You treat the angle as degrees.": left_of(center, math.radians(angle)),
        "You place the edge so that half of the mass is on each side (E-32). Place it directly "
        "below the center of mass instead.": offset,
    }


@pytest.mark.exercise("9.7", asks="The offset is positive if the edge passes", read=OFFSET)
def test_where_the_edge_must_lie(rng: Random) -> None:
    stones = draw_stones(rng)
    small, large = positive_number(rng, 0.3, 1.4), positive_number(rng, 1.7, 3.0)
    for angle in (0, small, -small, large, -large, large + math.tau, 0.5 * math.pi):
        cause = "The offset is the scalar product of the center and (-sin(angle), cos(angle))."
        if angle == 0:
            cause = "The edge is parallel to X and below the center. Its offset is the center's y."
        with calls(cause, with_stones(stones, f"balance_offset(stones, angle={angle})")):
            got = balance_offset(stones, float(angle))
        wanted = left_of(middle(stones), angle)
        expect_close(got, wanted, offset_slips(stones, angle), unit="m", tolerance=TIGHT)


def expect_masses(
    stones: Stones, angle: float, cause: str, wanted: Pair, slips: dict[str, Pair] | None = None
) -> None:
    """Expect the masses to the left and right of the edge."""
    shown = "pi / 2" if angle == 0.5 * math.pi else f"{angle:g}"
    call = f"masses_beside(stones, angle={shown}), the masses to the left and right of the edge"
    with calls(cause, with_stones(stones, call)):
        got = masses_beside(stones, angle)
    expect_close(got, wanted, slips, unit="kg", tolerance=TIGHT)


@pytest.mark.exercise("9.7", asks="However, they can differ", read=BESIDE)
def test_it_balances_though_the_masses_differ() -> None:
    stones = [("near and heavy", 3.0, 0.2, 0.4), ("far and light", 1.0, 0.6, 0.8)]
    slips = {
        "You give each side half of the total mass, as the book does (E-32). Add up the masses of "
        "the stones on each side instead.": (2.0, 2.0),
        "You swap the two masses.": (3.0, 1.0),
        "You count the stones on each side. Add their masses instead.": (1.0, 1.0),
        "You add up mass times distance. Add only the masses.": (0.3, 0.3),
        "You use an edge through the corner of the box.": (4.0, 0.0),
    }
    cause = "The edge is at y = 0.5, so there is 1 kg on its left, where y is larger, and 3 kg on "
    expect_masses(stones, 0.0, f"{cause}its right.", (1.0, 3.0), slips)
    cause = "The edge is at x = 0.3 and is parallel to Y, so stones with a smaller x are on its "
    only_y = "You compare y with the offset. The offset of a stone is cos(angle) y - sin(angle) x."
    expect_masses(stones, 0.5 * math.pi, f"{cause}left.", (3.0, 1.0), {only_y: (4.0, 0.0)})


@pytest.mark.exercise(
    "9.7", asks="A stone belongs to the side on which its center lies", read=BESIDE
)
def test_the_masses_on_both_sides(rng: Random) -> None:
    cases = [(draw_telling_stones(rng), 0.3)]
    while len(cases) < 4:
        stones, angle = draw_stones(rng), number(rng, 0.1, 3.0)
        # Stones on the edge have a check of their own.
        if min(abs(side) for side, _ in from_edge(stones, angle)) > 1e-3:
            cases.append((stones, angle))
    for stones, angle in cases:
        cause = "A stone is to the left of the edge if its offset is greater than the edge's."
        expect_masses(stones, angle, cause, beside(stones, angle))


@pytest.mark.exercise("9.7", asks="the stone belongs to neither side", read=BESIDE)
def test_a_stone_on_the_edge_is_on_neither_side(rng: Random) -> None:
    mass, far = positive_number(rng), positive_number(rng, 0.1, 0.9)
    x, y, angle = positive_number(rng), positive_number(rng), number(rng, 0.3, 1.4)
    across = complex(-math.sin(angle), math.cos(angle)) * far
    stones = [
        ("over it", mass, x, y),
        ("left of it", 0.7, x + across.real, y + across.imag),
        ("right of it", 0.7, x - across.real, y - across.imag),
    ]
    cause = "You add the stone on the edge to one side, because of a rounding error. Add a stone "
    expect_masses(stones, angle, f"{cause}within 1e-9 m of the edge to neither side.", (0.7, 0.7))
    for off, wanted in ((3e-9, (0.4, 0.4)), (3e-10, (0.0, 0.0))):
        cause = f"Each stone is only {off:.0e} m from the edge. Add it to neither side."
        if off > 1e-9:
            cause = f"Each stone is {off:.0e} m from the edge, so add it to its side. Only stones "
            cause += "within 1e-9 m of the edge belong to neither side."
        stones = [("left", 0.4, 0.3, 0.5 + off), ("right", 0.4, 0.6, 0.5 - off)]
        expect_masses(stones, 0.0, cause, wanted)


@pytest.mark.exercise(
    "9.7", asks="The functions do not change their arguments", weight=0.5, read=TOP
)
@pytest.mark.parametrize("name", ["center_of_stones", "balance_offset", "masses_beside"])
def test_the_stones_stay_as_they_were(rng: Random, name: str) -> None:
    stones = draw_telling_stones(rng)
    angle = "" if name == "center_of_stones" else ", angle=0.3"
    cause = "Your function changes the list of stones, which it should only read. Work on a copy "
    with calls(f"{cause}of the list.", with_stones(stones, f"{name}(stones{angle})")):
        got, after = stones_after(name, stones)
    expect_unchanged("the list", after, stones)
    center = middle(stones)
    wanted = {
        "center_of_stones": (center.real, center.imag),
        "balance_offset": left_of(center, 0.3),
        "masses_beside": beside(stones, 0.3),
    }[name]
    cause = "Your result for these stones is wrong. Compare your formula with the docstring."
    expect_close(got, wanted, cause=cause, tolerance=TIGHT)


@pytest.mark.exercise("9.7", asks="Enter at least three stones, and add a line", read=DATA)
def test_your_own_stones() -> None:
    with calls(
        "Enter your own stones in stones.csv, one stone per line, in kg and m. For example: a flat "
        "piece of slate,0.212,0.120,0.060",
        "center_of_stones(the stones of your stones.csv)",
    ):
        stones = [tuple(stone) for stone in entered_stones()]
    name = "your stones.csv: the number of lines, of which at most 4 count (three stones and the "
    expect_exactly(min(len(stones), 4), 4, call=f"{name}box)")
    cause = "Some stones have the same position. Measure the position of each one separately."
    name = "your stones.csv: the number of different positions, of which at most 3 count"
    places = {(x, y) for _, _, x, y in stones}
    expect_exactly(min(len(places), 3), 3, call=name, cause=cause)
    with calls(USE, "center_of_stones(your stones)"):
        got = center_of_stones(stones)
    wanted = middle(stones)
    expect_close(got, (wanted.real, wanted.imag), tolerance=TIGHT)
