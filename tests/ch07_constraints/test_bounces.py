"""Exercises 7.1, 7.3 and 7.4: measured bounces, two balls dropped at once, a short push."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch07_constraints.exercises import (
    force_for_frame,
    restitution_of_drop,
    table_of_drops,
    top_ball_speed,
)
from ch07_constraints.probes import entered_drops
from draw import components, positive_number
from expect import (
    about,
    blame,
    cause_of,
    expect_close,
    expect_exactly,
    expect_unchanged,
    expect_vector,
    xyz,
)

DROP = "exercise 7.1, and the docstring of restitution_of_drop"
TABLE = "the docstring of table_of_drops"
DATA = "exercise 7.1, and the file drops.csv of this chapter"
TWO = "exercise 7.3, and the docstring of top_ball_speed"
PUSH = "exercise 7.4, and the docstring of force_for_frame"


@pytest.mark.exercise("7.1", asks="square root of bounce_height / initial_height")
def test_restitution_is_a_square_root(rng: Random) -> None:
    about.read = DROP
    h, c = positive_number(rng), rng.uniform(0.1, 0.9)
    for initial, bounce, wanted in ((1.0, 0.64, 0.8), (h, c * c * h, c), (2.0, 2.0, 1.0)):
        about.call = f"restitution_of_drop(initial_height={initial}, bounce_height={bounce})"
        about.cause = "The restitution is a ratio of speeds, and the speed of a fall grows with "
        about.cause += "the square root of the height. Return sqrt(bounce_height / initial_height)."
        got = restitution_of_drop(initial, bounce)
        mistakes = [
            (wanted * wanted,
             "You returned the ratio of the heights, but the restitution is the ratio of the "
             "speeds. Take the square root of the ratio of the heights."),
            (1.0 / wanted, "Your ratio is upside down: a restitution above 1 means that the ball "
                           "bounces higher than it fell. Divide bounce_height by initial_height."),
        ]  # fmt: skip
        blame(got, mistakes)
        expect_close(got, wanted)
    cause = "A bounce height of 0 is a valid measurement: the ball doesn't bounce at all. Return "
    cause += "a restitution of 0."
    about("restitution_of_drop(initial_height=2.0, bounce_height=0.0)", cause=cause)
    got = restitution_of_drop(2.0, 0.0)
    expect_close(got, 0.0)


@pytest.mark.exercise("7.1", asks="The table has a row for each material")
def test_each_material_has_its_row(rng: Random) -> None:
    about.read = TABLE
    a = [k / 16.0 for k in rng.sample(range(3, 15), 4)]  # so that the heights are short numbers
    b = [k / 16.0 for k in rng.sample(range(3, 15), 2)]
    order = [("Clay", a[0]), ("oak", b[0]), ("Clay", a[1]), ("ash", 0.5), ("Clay", a[2])]
    order += [("oak", b[1]), ("Clay", a[3])]
    heights = [1.0, 2.0, 0.5, 1.0, 4.0, 0.25, 2.0]
    drops = [(name, h, h * c * c) for (name, c), h in zip(order, heights, strict=True)]
    about.call = f"drops = {drops[:4]}; drops += {drops[4:]}; table_of_drops(drops)"
    about.cause = "The rows are wrong. Return one row per material, in the order in which the "
    about.cause += "materials first appear in the list of drops. A single drop has no standard "
    about.cause += "deviation, so the standard error of its row is None."
    got = table_of_drops(drops)
    names = [row[0] for row in got]
    if names == ["Clay", "oak"]:
        about.cause = "You left out ash, which has only one drop. Return one row per material, "
        about.cause += "however few drops it has."
    expect_exactly(names, ["Clay", "oak", "ash"], then="; the materials of the rows")
    counts = [row[1] for row in got]
    about.cause = "Count the drops of each material, and return this number as the second entry of "
    about.cause += "its row."
    expect_exactly(counts, [4, 2, 1], then="; the number of drops in each row")
    about.cause = "The mean restitution of a material is wrong. Compute the restitution of each "
    about.cause += "drop with restitution_of_drop, and then take the mean."
    wanted = (math.fsum(a) / 4.0, math.fsum(b) / 2.0, 0.5)
    means = [row[2] for row in got]
    # Roots of the heights, a few roundings of 1.
    roots = tuple(math.sqrt(math.fsum(c * c for c in part) / len(part)) for part in (a, b, [0.5]))
    name = "You took the mean before the square root, which gives a different number. "
    name += "Compute the restitution of each drop first, and then take the mean."
    blame(means, [(roots, name)])
    expect_close(means, wanted, then="; the mean restitution in each row", tolerance=1e-14)
    about.cause = "The standard error of the mean of n restitutions is s / sqrt(n). Compute their "
    about.cause += "standard deviation s with statistics.stdev, which divides by n - 1."
    spread = math.fsum((c - wanted[0]) ** 2 for c in a)
    errors = (math.sqrt(spread / 3.0 / 4.0), abs(b[0] - b[1]) / 2.0)
    seen = [row[3] for row in got[:2]]
    mistakes = [
        ((2.0 * errors[0], math.sqrt(2.0) * errors[1]),
         "You returned the standard deviation s of the restitutions. The standard error of "
         "their mean is smaller: divide s by sqrt(n)."),
        ((math.sqrt(0.75) * errors[0], errors[1] / math.sqrt(2.0)), "Your standard deviation "
                                                                    "divides by n, so it is a "
                                                                    "little too small. Divide by n "
                                                                    "- 1, as statistics.stdev "
                                                                    "does."),
        ((0.5 * errors[0], errors[1] / math.sqrt(2.0)),
         "You divided the standard deviation s by n. Divide it by sqrt(n) instead."),
    ]  # fmt: skip
    blame(seen, mistakes)
    name = "; the standard errors of Clay and oak"
    expect_close(seen, errors, then=name, tolerance=1e-14)
    about.cause = "You returned a number, but a single drop says nothing about how much the "
    about.cause += "restitution varies. Return None as its standard error."
    expect_exactly(got[2][3], None, then="; the standard error of ash, with a single drop")
    about(
        "table_of_drops([])",
        cause="The list of drops is empty, so there are no rows to return. Return an empty list.",
    )
    got = table_of_drops([])
    expect_exactly(len(got), 0, then="; the number of rows")


@pytest.mark.exercise("7.1", asks="at least three times on each", weight=2)
def test_bounces_were_measured() -> None:
    about("table_of_drops(the drops in your drops.csv); the sum of all counts", read=DATA)
    about.cause = "Enter your own drops in drops.csv, one drop per line, as in drops_sample.csv: "
    about.cause += "material,initial_height,bounce_height. The heights are in m, and no bounce is "
    about.cause += "higher than its drop."
    drops = entered_drops()
    got = sum(row[1] for row in table_of_drops(drops))
    expect_exactly(got, len(drops), unit="drops")
    about.call = "your drops.csv should have three or more drops for each of three materials; the "
    about.call += "number of such materials that are still missing"
    materials = {name for name, _, _ in drops}
    got = sum(sum(name == other for other, _, _ in drops) >= 3 for name in materials)
    expect_exactly(max(0, 3 - got), 0, unit="materials")
    about.call = "the number of drops in your drops.csv with a bounce height of 0"
    got = sum(bounce == 0.0 for _, _, bounce in drops)
    expect_exactly(got, 0, unit="drops")


@pytest.mark.exercise("7.3", asks="hits the upper ball, which is still falling")
def test_the_upper_ball_flies_off(rng: Random) -> None:
    about.read = TWO
    about.call = "top_ball_speed(height=1.0, lower_mass=9.0, upper_mass=1.0, "
    about.call += "ground_restitution=0.5, pair_restitution=0.75)"
    about.cause = "Both balls reach the ground at v = sqrt(20) m/s, and the lower one bounces at "
    about.cause += "0.5 v. Compute the upper ball's velocity after the two then collide."
    got = top_ball_speed(1.0, 9.0, 1.0, 0.5, 0.75)
    v = math.sqrt(20.0)
    mistakes = [
        (0.575 * v,
         "You treated the lower ball as if it were at rest. When the balls collide, the lower "
         "ball is already rising at half the speed at which it hit the ground."),
        (-0.7375 * v, "The masses are swapped. The upper ball takes the fraction lower_mass / "
                      "(lower_mass + upper_mass) of the change in the relative velocity."),
        (0.0125 * v,
         "You changed the separating velocity only by the closing speed times pair_restitution. "
         "The balls stop approaching and then separate, so multiply it by 1 + pair_restitution."),
        (1.3625 * math.sqrt(10.0),
         "You used sqrt(g h) as the speed of the fall. It is sqrt(2 g h)."),
        (0.96875 * v, "You squared ground_restitution. It is a ratio of speeds, so the lower ball "
                      "rises at ground_restitution * v."),
        (2.3625 * v,
         "You returned the change in the upper ball's velocity. Before the collision "
         "the upper ball was falling at v = sqrt(2 g h), so subtract v."),
        (3.3625 * v, "You added v at the end. The upper ball is still falling when the balls "
                     "collide, so its velocity is -v before the collision: subtract v."),
        (-1.7875 * v, "You subtracted the two speeds. The balls approach each other, so they "
                      "close at the sum of their speeds, v + 0.5 v."),
        (-0.2125 * v, "You subtracted the two speeds. The balls approach each other, so they "
                      "close at the sum of their speeds, v + 0.5 v."),
        (2.625 * v - v,
         "You gave the upper ball the whole change in the relative velocity. Multiply this "
         "change by lower_mass / (lower_mass + upper_mass), which is 0.9 here."),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, 1.3625 * v, unit="m/s")
    h, g, m = positive_number(rng), positive_number(rng), positive_number(rng)
    v = math.sqrt(2.0 * g * h)
    for lower, ground, pair, wanted, cause in (
        (m, 1.0, 1.0, v, "The masses are equal and both restitutions are 1, so the balls swap "
                         "their velocities. The upper ball should rise at the speed v of the lower "
                         "one."),
        (m, 0.0, 1.0, 0.0, "The lower ball stays on the ground, which has a restitution of 0. The "
                           "upper ball has the same mass, so it passes its whole velocity on and "
                           "stops."),
        (3.0 * m, 1.0, 1.0, 2.0 * v,
         "The lower ball has three times the mass of the upper one, and both restitutions are 1. "
         "The upper ball should rise at twice the speed of its fall."),
        (m, 1.0, 0.0, 0.0, "The balls move together after the collision, because the pair's "
                           "restitution is 0. Their momenta cancel, so both should stop."),
        (3.0 * m, 0.0, 0.0, -0.25 * v, "The balls move together after the collision, because the "
                                       "pair's restitution is 0. Their total momentum points down, "
                                       "so return a negative speed."),
    ):  # fmt: skip
        about(cause=cause)
        about.call = f"top_ball_speed(height={h}, lower_mass={lower:g}, upper_mass={m}, "
        about.call += f"ground_restitution={ground}, pair_restitution={pair}, gravity={g})"
        got = top_ball_speed(h, lower, m, ground, pair, g)
        ten = wanted * math.sqrt(10.0 / g)
        if wanted:
            blame(
                got,
                [
                    (
                        ten,
                        "Your result is right only when gravity is 10 m/s^2. Use the argument "
                        "gravity instead of the number 10.",
                    )
                ],
            )
        expect_close(got, wanted, tolerance=1e-13, unit="m/s")


@pytest.mark.exercise("7.3", asks="the upward velocity of the upper ball")
def test_two_balls_separate_by_their_restitution(rng: Random) -> None:
    about.read = TWO
    h, g = positive_number(rng), positive_number(rng)
    lower, upper = positive_number(rng), positive_number(rng)
    ground, pair = (round(rng.uniform(0.1, 0.9), 3) for _ in range(2))
    about.call = f"top_ball_speed(height={h}, lower_mass={lower}, upper_mass={upper}, "
    about.call += f"ground_restitution={ground}, pair_restitution={pair}, gravity={g})"
    about.cause = "The collision conserves momentum. The balls approach each other at "
    about.cause += "ground_restitution * v + v, and they separate at pair_restitution times that "
    about.cause += "speed."
    got = top_ball_speed(h, lower, upper, ground, pair, g)
    v = math.sqrt(2.0 * g * h)
    momentum = (lower * ground - upper) * v
    parting = pair * (1.0 + ground) * v
    wanted = (momentum + lower * parting) / (lower + upper)
    expect_close(got, wanted, tolerance=1e-13, unit="m/s")
    about.call = f"top_ball_speed(height={h}, lower_mass={lower}, upper_mass={upper}, "
    about.call += f"ground_restitution={ground}, pair_restitution={pair})"
    about.cause = "This call passes no gravity, so use the default value of 10 m/s^2."
    got = top_ball_speed(h, lower, upper, ground, pair)
    wanted *= math.sqrt(10.0 / g)
    expect_close(got, wanted, tolerance=1e-13, unit="m/s")


@pytest.mark.exercise("7.3", asks="Without height or gravity, the result is 0")
def test_without_height_or_gravity_the_speed_is_0() -> None:
    about.read = TWO
    about.call = "top_ball_speed(height=0.0, lower_mass=2.0, upper_mass=3.0, "
    about.call += "ground_restitution=0.5, pair_restitution=0.5, gravity=10.0)"
    about.cause = (
        "A height of 0 is valid: the balls never gain any speed. Return 0 instead of raising an "
        "error."
    )
    got = top_ball_speed(0.0, 2.0, 3.0, 0.5, 0.5, 10.0)
    expect_close(got, 0.0, unit="m/s")
    about.call = "top_ball_speed(height=1.0, lower_mass=2.0, upper_mass=3.0, "
    about.call += "ground_restitution=0.5, pair_restitution=0.5, gravity=0.0)"
    about.cause = "Without gravity the balls don't fall, so their speed is 0. Return 0 instead of "
    about.cause += "raising an error."
    got = top_ball_speed(1.0, 2.0, 3.0, 0.5, 0.5, 0.0)
    expect_close(got, 0.0, unit="m/s")


@pytest.mark.exercise("7.4", asks="produces the same impulse in the longer time")
def test_a_short_push_is_a_weak_one(rng: Random) -> None:
    about.read = PUSH
    f, frame = components(rng), positive_number(rng, 0.1, 0.9)
    for share in (0.25, 1.0, 0.0):
        about.call = f"f = Vector3{f}; force_for_frame(f, contact_time={share * frame}, "
        about.call += f"frame={frame})"
        about.cause = "A force over the whole frame needs only part of the size to give the same "
        about.cause += "impulse. Multiply the force by contact_time / frame."
        force = Vector3(*f)
        got = expect_vector(force_for_frame(force, share * frame, frame))
        wanted = tuple(share * part for part in f)
        impulse = tuple(share * frame * part for part in f)
        why = "You returned the impulse in N s instead of a force. The force acts for the whole "
        why += "frame, so divide the impulse by the duration of the frame."
        mistakes = [(impulse, why)]
        if share:
            longer = tuple(part / share for part in f)
            name = "Your ratio is upside down. The same impulse is now spread over a longer time, "
            name += "so the force must get smaller: multiply it by contact_time / frame."
            mistakes.append((longer, name))
        why = cause_of(got, mistakes, about.cause)
        expect_close(got, wanted, cause=why, tolerance=1e-14, unit="N")
        kept = "You changed the vector that was passed in, as *= does. Use force * number, which "
        kept += "creates a new vector."
        expect_unchanged("f", xyz(force), f, cause=kept)
    about.call = f"f = Vector3{f}; g = force_for_frame(f, contact_time=1.0, frame=1.0); g.x += 1.0"
    about.cause = "You returned the vector that was passed in, so changing g also changes f. "
    about.cause += "Return a new vector, even if its components are the same."
    force = Vector3(*f)
    force_for_frame(force, 1.0, 1.0).x += 1.0
    expect_unchanged("f", xyz(force), f)
