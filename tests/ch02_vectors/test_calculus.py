"""Difference quotients of tables, build task B2.12."""

from __future__ import annotations

import math
from itertools import pairwise
from random import Random
from typing import Any

import pytest

from ch02_vectors import calculus
from ch02_vectors.tables import SMALL, TIMES, ZERO, draw_times, flat, pair_of_lists, shown
from ch02_vectors.vector import Vector3
from draw import Components, components
from expect import (
    about,
    blame,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    is_plain,
    scoped,
    xyz,
)

READ = "book 2.2.1; the docstring of difference_quotients"


def vectors(rows: list[Components]) -> list[Any]:
    return [Vector3(*row) for row in rows]


@scoped
def quotients_of(times: list[float], values: list[Any]) -> tuple[Any, list[float]]:
    """Call difference_quotients, and return its times and the components of its vectors."""
    __tracebackhide__ = True
    count = len(times) - 1
    result = calculus.difference_quotients(times, values)
    middles, quotients = pair_of_lists(result, (count, count), ("times", "quotients"))
    about.cause = "Return the times first and the quotients second. The quotients are vectors."
    expect_exactly(all(map(is_plain, middles)), True, then="; are the times numbers?")
    expect_exactly(any(map(is_plain, quotients)), False, then="; are the quotients vectors?")
    return middles, flat([xyz(q) for q in quotients])


@pytest.mark.exercise("B2.12")
def test_a_quotient_is_the_change_divided_by_its_own_interval(rng: Random) -> None:
    rows = [components(rng) for _ in TIMES]
    about.call = f"difference_quotients([0, 0.5, 2.5], {shown(rows)})"
    about.read = READ
    about.cause = (
        "In each interval, subtract the vector at its start from the vector at its end, and divide "
        "the difference by the duration of this interval."
    )
    _, got = quotients_of(TIMES, vectors(rows))
    changes = [[b - a for a, b in zip(*pair, strict=True)] for pair in pairwise(rows)]

    def over(*durations: float) -> list[float]:
        return [n / d for row, d in zip(changes, durations, strict=True) for n in row]

    mistakes = [
        (over(1.0, 1.0), "You return the changes. Divide each of them by its interval."),
        (over(-0.5, -2.0), "Your quotients have the wrong sign. Subtract the earlier vector."),
        (
            over(0.5, 2.5),
            "You divide by the time at the end of the interval. Divide by the duration of the "
            "interval, which is its end minus its start.",
        ),
        (
            over(0.5, 0.5),
            "You divide all changes by the first interval. Divide each of them by its own "
            "interval.",
        ),
        (
            over(2.0, 2.0),
            "You divide all changes by the last interval. Divide each of them by its own interval.",
        ),
        (
            over(2.0, 0.5),
            "You divide each change by the duration of the other interval. Divide it by its own.",
        ),
        (
            over(1.25, 1.25),
            "You divide by the average duration. Divide each change by its own interval.",
        ),
        (
            [n * d for row, d in zip(changes, (0.5, 2.0), strict=True) for n in row],
            "You multiply the change by the duration. Divide it by the duration.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, over(0.5, 2.0), then="; the quotients", tolerance=SMALL)


@pytest.mark.exercise("B2.12")
def test_the_times_of_the_quotients_are_in_the_middle(rng: Random) -> None:
    times = draw_times(rng, 4)
    rows = [components(rng) for _ in times]
    about.call = f"difference_quotients({times}, {shown(rows)})"
    about.read = READ
    about.cause = (
        "A quotient is the average over its whole interval, so its time is the middle of the "
        "interval: the mean of the two times."
    )
    got, _ = quotients_of(times, vectors(rows))
    starts, ends = times[:-1], times[1:]
    middles = [math.fsum(pair) / 2.0 for pair in zip(starts, ends, strict=True)]
    durations = [end - start for start, end in zip(starts, ends, strict=True)]
    blame(
        list(got),
        [
            (starts, f"You return the starts of the intervals. {about.cause}"),
            (ends, f"You return the ends of the intervals. {about.cause}"),
            (durations, f"You return the durations of the intervals. {about.cause}"),
            ([d / 2.0 for d in durations], "This is half the duration. Add the start to it."),
        ],
    )
    expect_close(list(got), middles, then="; the times", tolerance=SMALL)


@pytest.mark.exercise("B2.12")
def test_under_constant_acceleration_they_are_the_velocities_in_the_middle(rng: Random) -> None:
    p, v, a = components(rng), components(rng), components(rng)
    times = draw_times(rng, 5)
    rows = [
        tuple(x + u * t + b * t * t / 2.0 for x, u, b in zip(p, v, a, strict=True)) for t in times
    ]
    about.call = f"difference_quotients({times}, {shown(rows)})"
    about.read = READ
    about.cause = (
        "These positions belong to a constant acceleration. Each quotient must then equal the "
        "velocity in the middle of its interval."
    )
    middles, got = quotients_of(times, vectors(rows))
    # The average velocity is exactly the one at the middle, because the velocity is linear in time.
    halves = [(start + end) / 2.0 for start, end in pairwise(times)]
    wanted = [u + b * t for t in halves for u, b in zip(v, a, strict=True)]
    expect_close(got, wanted, then="; the quotients", tolerance=1e-10)
    about.call = f"t, v = difference_quotients({times}, {shown(rows)}); difference_quotients(t, v)"
    about.cause = "Applied to the velocities, your function must give the constant acceleration."
    again = [Vector3(*got[i : i + 3]) for i in range(0, len(got), 3)]
    _, twice = quotients_of(list(middles), again)
    expect_close(twice, [*a] * 3, then="; the quotients", tolerance=1e-9)


@pytest.mark.exercise("B2.12")
def test_the_table_stays_the_same(rng: Random) -> None:
    times, rows = draw_times(rng, 3), [components(rng) for _ in range(3)]
    given_times, given = list(times), vectors(rows)
    about.call = f"times, values = {times}, {shown(rows)}; difference_quotients(times, values)"
    about.cause = (
        "Your function changes a vector of the table, because -= and /= work in place. Write "
        "(b - a) / duration, which creates a new vector."
    )
    about.read = READ
    quotients_of(given_times, given)
    about.cause = "Your function changes the lists of the caller. Only read them."
    expect_exactly((len(given_times), len(given)), (3, 3), then="; the lengths of both lists")
    expect_unchanged("times", given_times, times)
    about.cause = (
        "Your function changes a vector of the table, because -= and /= work in place. Write "
        "(b - a) / duration, which creates a new vector."
    )
    for i, row in enumerate(rows):
        expect_unchanged(f"values[{i}]", xyz(given[i]), row)


@pytest.mark.exercise("B2.12")
@pytest.mark.robust
@pytest.mark.parametrize(
    ("times", "why"),
    [
        ([0.0, 1.0, 1.0], "Two times are equal, so an interval has the duration 0"),
        ([0.0, 2.0, 1.0], "The last time is before the one in the middle"),
        ([1.0, 0.0, 2.0], "The second time is before the first"),
        ([0.0, math.nan, 2.0], "A time is NaN"),
        ([0.0, 1.0, math.inf], "A time is infinite"),
        ([0.0, 1.0], "There are two times but three vectors"),
        ([0.0, 1.0, 2.0, 3.0], "There are four times but three vectors"),
    ],
    ids=["equal", "backward", "backward at first", "nan", "infinite", "two", "four"],
)
def test_quotients_of_bad_times_are_refused(times: list[float], why: str) -> None:
    rows = [ZERO, (1.0, 2.0, 3.0), (2.0, 2.0, 2.0)]
    about.call = f"difference_quotients({times}, {shown(rows)})"
    about.cause = f"{why}. Check the table before you compute anything, and raise ValueError."
    about.read = "the docstring in calculus.py"
    expect_error(
        lambda: calculus.difference_quotients(times, vectors(rows)),
        ValueError,
        allowed=lambda: calculus.difference_quotients([0.0, 1.0, 2.0], vectors(rows)),
    )


@pytest.mark.exercise("B2.12")
@pytest.mark.robust
@pytest.mark.parametrize("count", [0, 1])
def test_quotients_of_fewer_than_two_points_are_refused(count: int) -> None:
    times, rows = [0.0][:count], [ZERO][:count]
    about.call = f"difference_quotients({times}, {shown(rows)})"
    about.cause = "An interval needs two times. If there are fewer, raise ValueError."
    about.read = "the docstring in calculus.py"
    expect_error(
        lambda: calculus.difference_quotients(times, vectors(rows)),
        ValueError,
        allowed=lambda: calculus.difference_quotients([0.0, 1.0], vectors([ZERO, ZERO])),
    )


@pytest.mark.exercise("B2.12")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_quotients_of_bad_vectors_are_refused(bad: float) -> None:
    for place in range(3):
        rows = [ZERO, (1.0, 2.0, 3.0), (2.0, 2.0, 2.0)]
        rows[place] = (0.0, bad, 0.0)
        about.call = f"difference_quotients([0, 0.5, 2.5], {shown(rows)})"
        about.cause = (
            f"A component is {bad}, so raise ValueError. finite_vector() in arguments.py checks "
            "a vector and raises the error for you."
        )
        about.read = "the docstring in calculus.py"
        expect_error(
            lambda rows=rows: calculus.difference_quotients(TIMES, vectors(rows)),
            ValueError,
            allowed=lambda: calculus.difference_quotients(TIMES, vectors([ZERO] * 3)),
        )
