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
    expect_error,
    expect_exactly,
    expect_finite_numbers,
    expect_unchanged,
    expect_vector,
    xyz,
)

DROP = "exercise 7.1, E-10, and the docstring of restitution_of_drop"
TABLE = "the docstring of table_of_drops"
DATA = "exercise 7.1, and the file drops.csv of this chapter"
TWO = "exercise 7.3, and the docstring of top_ball_speed"
PUSH = "exercise 7.4, and the docstring of force_for_frame"


@pytest.mark.exercise("7.1")
def test_restitution_is_a_root(rng: Random) -> None:
    about.read = DROP
    h, c = positive_number(rng), rng.uniform(0.1, 0.9)
    for initial, bounce, wanted in ((1.0, 0.64, 0.8), (h, c * c * h, c), (2.0, 2.0, 1.0)):
        about.call = f"restitution_of_drop({initial}, {bounce})"
        about.cause = "speeds go with the roots of heights: the root of bounce / initial; the book "
        about.cause += "prints it without the root (E-10)"
        got = restitution_of_drop(initial, bounce)
        mistakes = [
            (wanted * wanted, "the root is left out, as the book prints it (E-10): speeds go with "
             "the roots of heights, and restitution is a ratio of speeds"),
            (1.0 / wanted, "upside down: the root of bounce_height / initial_height"),
        ]  # fmt: skip
        blame(got, mistakes)
        expect_close(got, wanted)
    about("restitution_of_drop(2.0, 0.0)", cause="what does not bounce at all has 0")
    got = restitution_of_drop(2.0, 0.0)
    expect_close(got, 0.0)


@pytest.mark.exercise("7.1")
@pytest.mark.robust
def test_a_drop_needs_heights_that_mean_something() -> None:
    about.read = DROP
    bad = [(0, 0.0), (0, -2.0), (1, -1.0)]
    expect_finite_numbers("restitution_of_drop", restitution_of_drop, (2, 1), bad)
    expect_error(
        lambda: restitution_of_drop(2, 2.5),
        ValueError,
        call="restitution_of_drop(2, 2.5)",
        allowed=lambda: restitution_of_drop(2, 2),
        cause="nothing bounces higher than it was dropped from: refuse it, or it is above 1",
    )


@pytest.mark.exercise("7.1")
def test_each_material_has_its_row(rng: Random) -> None:
    about.read = TABLE
    a = [k / 16.0 for k in rng.sample(range(3, 15), 4)]  # so that the heights are short numbers
    b = [k / 16.0 for k in rng.sample(range(3, 15), 2)]
    order = [("Clay", a[0]), ("oak", b[0]), ("Clay", a[1]), ("ash", 0.5), ("Clay", a[2])]
    order += [("oak", b[1]), ("Clay", a[3])]
    heights = [1.0, 2.0, 0.5, 1.0, 4.0, 0.25, 2.0]
    drops = [(name, h, h * c * c) for (name, c), h in zip(order, heights, strict=True)]
    about.call = f"table_of_drops({drops})"
    about.cause = "a row for each material, in the order in which they come first"
    got = table_of_drops(drops)
    names = [row[0] for row in got]
    expect_exactly(names, ["Clay", "oak", "ash"], then=": materials")
    counts = [row[1] for row in got]
    expect_exactly(counts, [4, 2, 1], then=": drops")
    about.cause = "the mean of the drops' restitutions, each by restitution_of_drop"
    wanted = (math.fsum(a) / 4.0, math.fsum(b) / 2.0, 0.5)
    means = [row[2] for row in got]
    # Roots of the heights, a few roundings of 1.
    roots = tuple(math.sqrt(math.fsum(c * c for c in part) / len(part)) for part in (a, b, [0.5]))
    name = "that is the root of the mean: first the root of each drop, then the mean"
    blame(means, [(roots, name)])
    expect_close(means, wanted, then=": means", tolerance=1e-14)
    about.cause = "s / sqrt(n), where s is the standard deviation with n - 1: statistics.stdev"
    spread = math.fsum((c - wanted[0]) ** 2 for c in a)
    errors = (math.sqrt(spread / 3.0 / 4.0), abs(b[0] - b[1]) / 2.0)
    seen = [row[3] for row in got[:2]]
    mistakes = [
        ((2.0 * errors[0], math.sqrt(2.0) * errors[1]), "that is s itself: divide it by sqrt(n)"),
        ((math.sqrt(0.75) * errors[0], errors[1] / math.sqrt(2.0)), "s is with n - 1 below its "
         "root, not n: statistics.stdev, and not pstdev"),
        ((0.5 * errors[0], errors[1] / math.sqrt(2.0)), "that is s / n: divide by sqrt(n)"),
    ]  # fmt: skip
    blame(seen, mistakes)
    expect_close(seen, errors, then=": standard errors", tolerance=1e-14)
    about.cause = "one drop alone says nothing of its error: None"
    expect_exactly(got[2][3], None, then=": the last error")
    about("table_of_drops([])", cause="no drops give no rows")
    got = table_of_drops([])
    expect_exactly(len(got), 0)


@pytest.mark.exercise("7.1")
@pytest.mark.robust
def test_a_table_refuses_what_a_drop_refuses() -> None:
    about.read = TABLE
    good = ("oak", 2.0, 1.0)
    for bad, error in ((("oak", 0.0, 0.0), ValueError), (("ash", 1.0, "2"), TypeError)):
        about.call = f"table_of_drops([{good}, {bad}])"
        about.cause = "restitution_of_drop refuses it: let its error out"
        expect_error(
            lambda bad=bad: table_of_drops([good, bad]),
            error,
            allowed=lambda: table_of_drops([good]),
        )


@pytest.mark.exercise("7.1", weight=2)
def test_bounces_were_measured() -> None:
    about("table_of_drops(the drops of your drops.csv): all drops in it", read=DATA)
    about.cause = "enter your own drops, one a line, as in drops_sample.csv: "
    about.cause += "material,initial_height,bounce_height, heights in m, no bounce higher than the "
    about.cause += "drop"
    drops = entered_drops()
    got = sum(row[1] for row in table_of_drops(drops))
    expect_exactly(got, len(drops))
    about.call = "your drops.csv, at least three materials with at least three drops each: how "
    about.call += "many materials are missing"
    materials = {name for name, _, _ in drops}
    got = sum(sum(name == other for other, _, _ in drops) >= 3 for name in materials)
    expect_exactly(max(0, 3 - got), 0)
    about.call = "your drops.csv: how many bounces are 0"
    got = sum(bounce == 0.0 for _, _, bounce in drops)
    expect_exactly(got, 0)


@pytest.mark.exercise("7.3")
def test_the_upper_ball_flies_off(rng: Random) -> None:
    about("top_ball_speed(1.0, 9.0, 1.0, 0.5, 0.75)", read=TWO)
    about.cause = "both arrive with sqrt(20) m/s; the lower one turns round with half of it, and "
    about.cause += "the upper one leaves with 1.3625 times it: 6.0933 m/s"
    got = top_ball_speed(1.0, 9.0, 1.0, 0.5, 0.75)
    v = math.sqrt(20.0)
    mistakes = [
        (0.575 * v, "that is as if the lower ball stood still: it goes up by then, with 0.5 v"),
        (-0.7375 * v, "the masses are exchanged: the upper ball gets the lower one's share, 0.9"),
        (2.3625 * v, "that is the change of its velocity: it falls with v before, take that off"),
        (2.625 * v - v, "that is all of the change: the upper ball gets 0.9 of it, by the masses"),
    ]
    blame(got, mistakes)
    expect_close(got, 1.3625 * v)
    h, g, m = positive_number(rng), positive_number(rng), positive_number(rng)
    v = math.sqrt(2.0 * g * h)
    for lower, ground, pair, wanted, cause in (
        (m, 1.0, 1.0, v, "equal masses, restitution 1: they exchange their velocities"),
        (m, 0.0, 1.0, 0.0, "equal masses, and the lower one stands: it takes all of the motion"),
        (3.0 * m, 1.0, 1.0, 2.0 * v, "three times the mass, restitution 1: twice as fast"),
        (m, 1.0, 0.0, 0.0, "equal masses, restitution 0: their momenta cancel"),
        (3.0 * m, 0.0, 0.0, -0.25 * v, "what sticks to a lower one at rest goes on downwards"),
    ):
        about(f"top_ball_speed({h}, {lower}, {m}, {ground}, {pair}, {g})", cause=cause)
        got = top_ball_speed(h, lower, m, ground, pair, g)
        ten = wanted * math.sqrt(10.0 / g)
        if wanted:
            blame(got, [(ten, "that is for 10 m/s^2: take the gravity given")])
        expect_close(got, wanted, tolerance=1e-13)


@pytest.mark.exercise("7.3")
def test_two_balls_part_by_their_restitution(rng: Random) -> None:
    about.read = TWO
    h, g = positive_number(rng), positive_number(rng)
    lower, upper = positive_number(rng), positive_number(rng)
    ground, pair = (round(rng.uniform(0.1, 0.9), 3) for _ in range(2))
    about.call = f"top_ball_speed({h}, {lower}, {upper}, {ground}, {pair}, {g})"
    about.cause = "momentum is kept between the two, and they part at the pair's restitution times "
    about.cause += "the speed at which they close: c_ground v + v"
    got = top_ball_speed(h, lower, upper, ground, pair, g)
    v = math.sqrt(2.0 * g * h)
    momentum = (lower * ground - upper) * v
    parting = pair * (1.0 + ground) * v
    wanted = (momentum + lower * parting) / (lower + upper)
    expect_close(got, wanted, tolerance=1e-13)
    about.call = f"top_ball_speed({h}, {lower}, {upper}, {ground}, {pair})"
    about.cause = "without a gravity it is 10 m/s^2"
    got = top_ball_speed(h, lower, upper, ground, pair)
    wanted *= math.sqrt(10.0 / g)
    expect_close(got, wanted, tolerance=1e-13)


@pytest.mark.exercise("7.3")
def test_without_height_or_gravity_no_ball_flies_off() -> None:
    about("top_ball_speed(0.0, 2.0, 3.0, 0.5, 0.5, 10.0)", read=TWO)
    about.cause = "from a height of 0 nothing moves"
    got = top_ball_speed(0.0, 2.0, 3.0, 0.5, 0.5, 10.0)
    expect_close(got, 0.0)
    about.call = "top_ball_speed(1.0, 2.0, 3.0, 0.5, 0.5, 0.0)"
    about.cause = "without gravity nothing falls: that is 0, and no error"
    got = top_ball_speed(1.0, 2.0, 3.0, 0.5, 0.5, 0.0)
    expect_close(got, 0.0)


@pytest.mark.exercise("7.3")
@pytest.mark.robust
def test_two_balls_need_numbers_that_mean_something() -> None:
    about.read = TWO
    bad = [(0, -2.0), (1, 0.0), (1, -1.0), (2, 0.0), (2, -1.0), (3, -0.5), (3, 1.5), (4, -0.5)]
    bad += [(4, 1.5), (5, -1.0)]
    good = (2, 3, 4, 1, 0, 5)
    expect_finite_numbers("top_ball_speed", top_ball_speed, good, bad)


@pytest.mark.exercise("7.4")
def test_a_short_push_is_a_weak_one(rng: Random) -> None:
    about.read = PUSH
    f, frame = components(rng), positive_number(rng, 0.1, 0.9)
    for share in (0.25, 1.0, 0.0):
        about.call = f"f = Vector3{f}; force_for_frame(f, {share * frame}, {frame})"
        about.cause = "k t_s / t_f: the impulse, force times time, is the same"
        force = Vector3(*f)
        got = expect_vector(force_for_frame(force, share * frame, frame))
        wanted = tuple(share * part for part in f)
        impulse = tuple(share * frame * part for part in f)
        mistakes = [(impulse, "that is the impulse, in N s: divide it by the frame for the force")]
        if share:
            longer = tuple(part / share for part in f)
            name = "upside down: a shorter push needs less force in a whole frame"
            mistakes.append((longer, name))
        why = cause_of(got, mistakes, about.cause)
        expect_close(got, wanted, cause=why, tolerance=1e-14)
        kept = "*= works in place: force * number is new"
        expect_unchanged("f", xyz(force), f, cause=kept)
    about.call = f"f = Vector3{f}; force_for_frame(f, 1.0, 1.0).x += 1.0"
    about.cause = "return a new vector, also where nothing is taken off"
    force = Vector3(*f)
    force_for_frame(force, 1.0, 1.0).x += 1.0
    expect_unchanged("f", xyz(force), f)


@pytest.mark.exercise("7.4")
@pytest.mark.robust
def test_a_push_is_not_longer_than_its_frame() -> None:
    about.read = PUSH
    about.cause = "refuse a time that is negative, not finite, or longer than the frame, and a "
    about.cause += "frame that is not positive"
    for numbers, error in (
        ((0.5, 0.25), ValueError),
        ((-0.5, 1.0), ValueError),
        ((0.5, 0.0), ValueError),
        ((0.0, 0.0), ValueError),
        ((0.5, -1.0), ValueError),
        ((0.5, math.nan), ValueError),
        ((math.nan, 0.5), ValueError),
        ((0.5, math.inf), ValueError),
        (("0.5", 1.0), TypeError),
        ((0.5, "1.0"), TypeError),
    ):
        expect_error(
            lambda numbers=numbers: force_for_frame(Vector3(1.0, 2.0, 3.0), *numbers),
            error,
            call=f"force_for_frame(Vector3(1, 2, 3), {numbers[0]!r}, {numbers[1]!r})",
            allowed=lambda: force_for_frame(Vector3(1.0, 2.0, 3.0), 1, 2),
        )
    for bad, error in (
        (Vector3(math.inf), ValueError),
        (Vector3(0.0, 0.0, math.nan), ValueError),
        (3.0, TypeError),
    ):
        name = "3.0" if error is TypeError else "Vector3 that is not finite"
        expect_error(
            lambda bad=bad: force_for_frame(bad, 1.0, 2.0),
            error,
            call=f"force_for_frame({name}, 1.0, 2.0)",
            allowed=lambda: force_for_frame(Vector3(1.0, 2.0, 3.0), 1.0, 2.0),
            cause="refuse what is no vector, or not finite: finite_vector of arguments.py does",
        )
