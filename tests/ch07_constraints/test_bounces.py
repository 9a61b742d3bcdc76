"""Exercises 7.1, 7.3 and 7.4: measured bounces, two balls dropped at once, a short push."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch07_constraints.exercises import (
    force_for_frame,
    restitution_of_drop,
    table_of_drops,
    top_ball_speed,
)
from ch07_constraints.probes import entered_drops
from draw import positive_number, vector
from expect import expect_close, expect_exactly, expect_unchanged, xyz

DROP = "exercise 7.1, and the docstring of restitution_of_drop"
TABLE = "the docstring of table_of_drops"
DATA = "exercise 7.1, and the file drops.csv of this chapter"
TWO = "exercise 7.3, and the docstring of top_ball_speed"
PUSH = "exercise 7.4, and the docstring of force_for_frame"


@pytest.mark.exercise("7.1", asks="square root of bounce_height / initial_height", read=DROP)
def test_restitution_is_a_square_root(rng: Random) -> None:
    h, c = positive_number(rng), rng.uniform(0.1, 0.9)
    for initial, bounce, wanted in ((1.0, 0.64, 0.8), (h, c * c * h, c), (2.0, 2.0, 1.0)):
        with calls("Return the square root of the ratio of heights, which is a ratio of speeds."):
            got = restitution_of_drop(initial_height=initial, bounce_height=bounce)
        slips = {
            "You returned the ratio of the heights.": wanted * wanted,
            "Your ratio is upside down.": 1.0 / wanted,
        }
        expect_close(got, wanted, slips)
    with calls("A bounce height of 0 is a valid measurement. Return a restitution of 0."):
        got = restitution_of_drop(initial_height=2.0, bounce_height=0.0)
    expect_close(got, 0.0)


@pytest.mark.exercise("7.1", asks="The table has a row for each material", read=TABLE)
def test_each_material_has_its_row(rng: Random) -> None:
    a = [k / 16.0 for k in rng.sample(range(3, 15), 4)]  # so that the heights are short numbers
    b = [k / 16.0 for k in rng.sample(range(3, 15), 2)]
    materials = ["Clay", "oak", "Clay", "ash", "Clay", "oak", "Clay"]
    restitutions = [a[0], b[0], a[1], 0.5, a[2], b[1], a[3]]
    heights = [1.0, 2.0, 0.5, 1.0, 4.0, 0.25, 2.0]
    drops = [
        (name, h, h * c * c) for name, h, c in zip(materials, heights, restitutions, strict=True)
    ]
    with calls(
        "Return one row per material, in the order in which the materials first appear in the list "
        "of drops, however few drops a material has. A single drop has no standard deviation, so "
        "the standard error of its row is None."
    ):
        got = table_of_drops(drops)
    names, counts, means, errors = ([row[i] for row in got] for i in range(4))
    expect_exactly(names, ["Clay", "oak", "ash"], then="; the materials of the rows")
    why = "Count the drops of each material, and return this number as the second entry of its row."
    expect_exactly(counts, [4, 2, 1], then="; the number of drops in each row", cause=why)
    why = "Compute the restitution of each drop with restitution_of_drop, and then take the mean."
    wanted = (math.fsum(a) / 4.0, math.fsum(b) / 2.0, 0.5)
    # Roots of the heights, a few roundings of 1.
    roots = tuple(math.sqrt(math.fsum(c * c for c in part) / len(part)) for part in (a, b, [0.5]))
    slips = {"You took the mean before the square root, which gives a different number.": roots}
    name = "; the mean restitution in each row"
    expect_close(means, wanted, slips, then=name, cause=why, tolerance=1e-14)
    why = "The standard error of the mean of n restitutions is s / sqrt(n). Compute their standard "
    why += "deviation s with statistics.stdev, which divides by n - 1."
    clay = math.sqrt(math.fsum((c - wanted[0]) ** 2 for c in a) / 12.0)
    oak = abs(b[0] - b[1]) / 2.0
    slips = {
        "You returned the standard deviation s.": (2.0 * clay, math.sqrt(2.0) * oak),
        "Your standard deviation divides by n.": (math.sqrt(0.75) * clay, oak / math.sqrt(2.0)),
        "You divided s by n instead of sqrt(n).": (0.5 * clay, oak / math.sqrt(2.0)),
    }
    name = "; the standard errors of Clay and oak"
    expect_close(errors[:2], (clay, oak), slips, then=name, cause=why, tolerance=1e-14)
    why = "Return None, because a single drop says nothing about how much restitutions vary."
    name = "; the standard error of ash, with a single drop"
    expect_exactly(errors[2], None, then=name, cause=why)
    with calls("The list of drops is empty, so there are no rows to return."):
        got = table_of_drops([])
    expect_exactly(len(got), 0, then="; the number of rows")


@pytest.mark.exercise("7.1", asks="at least three times on each", weight=2, read=DATA)
def test_bounces_were_measured() -> None:
    """Only this check reads the student's measurements. No other file replaces them."""
    with calls(
        "Enter your own drops in drops.csv, one drop per line, as in drops_sample.csv: "
        "material,initial_height,bounce_height. The heights are in m, and no bounce is higher than "
        "its drop.",
        "table_of_drops(the drops in your drops.csv)",
    ):
        drops = entered_drops()
        got = sum(row[1] for row in table_of_drops(drops))
    expect_exactly(got, len(drops), then="; the sum of all counts", unit="drops")
    call = "the number of materials that still need three drops in your drops.csv, out of three"
    names = [name for name, _, _ in drops]
    got = sum(names.count(name) >= 3 for name in {*names})
    expect_exactly(max(0, 3 - got), 0, call=call, unit="materials")
    call = "the number of drops in your drops.csv with a bounce height of 0"
    expect_exactly(sum(bounce == 0.0 for _, _, bounce in drops), 0, call=call, unit="drops")


def speed_of(cause: str, *numbers: float) -> Any:
    """Return the result of top_ball_speed for its first five or all six arguments."""
    names = ("height", "lower_mass", "upper_mass", "ground_restitution", "pair_restitution")
    told = ", ".join(
        f"{name}={number}" for name, number in zip((*names, "gravity"), numbers, strict=False)
    )
    with calls(cause, f"top_ball_speed({told})"):
        return top_ball_speed(*numbers)


@pytest.mark.exercise("7.3", asks="hits the upper ball, which is still falling", read=TWO)
def test_the_upper_ball_flies_off(rng: Random) -> None:
    why = "Both balls reach the ground at v = sqrt(20) m/s, and the lower one bounces at 0.5 v. "
    why += "Compute the upper ball's velocity after the two then collide."
    got = speed_of(why, 1.0, 9.0, 1.0, 0.5, 0.75)
    v = math.sqrt(20.0)
    close = "You subtracted the two speeds. The balls approach each other, so they close at the "
    slips = {
        "You treated the lower ball as if it were at rest.": 0.575 * v,
        "The masses are swapped, so you took upper_mass / (lower_mass + upper_mass).":
            -0.7375 * v,
        "You left out the 1 of 1 + pair_restitution.": 0.0125 * v,
        "You used sqrt(g h) as v. It is sqrt(2 g h).": 1.3625 * math.sqrt(10.0),
        "You squared ground_restitution, a ratio of speeds.": 0.96875 * v,
        "You returned the change in velocity. It was -v before, so subtract v.": 2.3625 * v,
        "You added v at the end. The upper ball is still falling, so subtract v.": 3.3625 * v,
        f"{close}sum of their speeds, v + 0.5 v.": -1.7875 * v,
        f"{close}sum of both, v + 0.5 v.": -0.2125 * v,
        "You gave the upper ball the whole change, instead of 0.9 of it.": 1.625 * v,
    }  # fmt: skip
    expect_close(got, 1.3625 * v, slips, unit="m/s")
    h, g, m, other = (positive_number(rng) for _ in range(4))
    v, e, c = math.sqrt(2.0 * g * h), *(round(rng.uniform(0.1, 0.9), 3) for _ in range(2))
    for lower, ground, pair, wanted, cause in (
        (m, 1.0, 1.0, v,
         "With equal masses and both restitutions 1, the balls swap their velocities."),
        (m, 0.0, 1.0, 0.0,
         "The lower ball stays down. The upper one passes its whole velocity on and stops."),
        (3.0 * m, 1.0, 1.0, 2.0 * v,
         "With three times the mass below, the upper ball rises at twice its speed."),
        (m, 1.0, 0.0, 0.0,
         "The balls move together afterwards. Their momenta cancel, so both should stop."),
        (3.0 * m, 0.0, 0.0, -0.25 * v,
         "The balls move together afterwards. Their momentum points down: a negative speed."),
        (other, e, c, v * (other * e - m + other * c * (1.0 + e)) / (other + m),
         "The collision conserves momentum. The balls approach each other at ground_restitution * "
         "v + v, and they separate at pair_restitution times that speed."),
    ):  # fmt: skip
        got = speed_of(cause, h, lower, m, ground, pair, g)
        slips = {
            "Your result is right only when gravity is 10 m/s^2. Use the argument.": wanted
            * math.sqrt(10.0 / g)
        }
        expect_close(got, wanted, slips if wanted else {}, tolerance=1e-13, unit="m/s")


@pytest.mark.exercise("7.3", asks="Without height or gravity, the result is 0", read=TWO)
def test_without_height_or_gravity_the_speed_is_0() -> None:
    for h, g, cause in (
        (0.0, 10.0, "A height of 0 is valid: the balls never gain any speed."),
        (1.0, 0.0, "Without gravity the balls don't fall, so their speed is 0."),
    ):
        why = f"{cause} Return 0 instead of raising an error."
        expect_close(speed_of(why, h, 2.0, 3.0, 0.5, 0.5, g), 0.0, unit="m/s")


@pytest.mark.exercise("7.4", asks="produces the same impulse in the longer time", read=PUSH)
def test_a_short_push_is_a_weak_one(rng: Random) -> None:
    force, frame = vector(rng), positive_number(rng, 0.1, 0.9)
    for share in (0.25, 1.0, 0.0):
        with calls("Multiply the force by contact_time / frame, so that the impulse is the same."):
            f = Vector3(*force)
            got = force_for_frame(f, contact_time=share * frame, frame=frame)
        slips = {
            "You returned the impulse in N s.": force * share * frame,
            "Your ratio is upside down.": force / (share or 1.0),
        }
        expect_close(xyz(got), force * share, slips, tolerance=1e-14, unit="N")
        why = "You changed the vector that was passed in, as *= does. Use force * number."
        expect_unchanged("f", f, force, cause=why)
    with calls("You returned the vector that was passed in. Return a new vector instead."):
        f = Vector3(*force)
        g = force_for_frame(f, contact_time=1.0, frame=1.0)
        g.x += 1.0
    expect_unchanged("f", f, force)
