"""Difference quotients (B2.12) and sums of accelerations (B2.13) of tables that make no sense."""

from __future__ import annotations

import math
from typing import Any

import pytest

from ch02_vectors import calculus
from ch02_vectors.vector import Vector3
from draw import Components, rounded
from expect import about, expect_error

TIMES = [0.0, 0.5, 2.5]
ZERO = (0.0, 0.0, 0.0)


def vectors(rows: list[Components]) -> list[Any]:
    return [Vector3(*row) for row in rows]


def shown(rows: list[Components]) -> str:
    return f"[{', '.join(f'Vector3{rounded(row)}' for row in rows)}]"


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


@pytest.mark.exercise("B2.13")
@pytest.mark.robust
@pytest.mark.parametrize(
    ("times", "why"),
    [
        ([0.0, 1.0, 1.0], "Two times are equal"),
        ([0.0, 2.0, 1.0], "The last time is before the one in the middle"),
        ([0.0, math.nan, 2.0], "A time is NaN"),
        ([0.0, 1.0, math.inf], "A time is infinite"),
        ([0.0, 1.0], "For two accelerations there must be three times, not two"),
        ([0.0, 1.0, 2.0, 3.0], "For two accelerations there must be three times, not four"),
    ],
    ids=["equal", "backward", "nan", "infinite", "two", "four"],
)
def test_sums_over_bad_times_are_refused(times: list[float], why: str) -> None:
    about.call = (
        f"add_up_accelerations({times}, [Vector3(), Vector3()], position=Vector3(), "
        "velocity=Vector3())"
    )
    about.cause = f"{why}. Check the table before you compute anything, and raise ValueError."
    about.read = "the docstring in calculus.py"

    def attempt(given: list[float]) -> Any:
        return calculus.add_up_accelerations(given, vectors([ZERO, ZERO]), Vector3(), Vector3())

    expect_error(lambda: attempt(times), ValueError, allowed=lambda: attempt([0.0, 1.0, 2.0]))


@pytest.mark.exercise("B2.13")
@pytest.mark.robust
@pytest.mark.parametrize("times", [[], [0.0]])
def test_sums_without_an_interval_are_refused(times: list[float]) -> None:
    about.call = f"add_up_accelerations({times}, [], position=Vector3(), velocity=Vector3())"
    about.cause = "An interval needs two times. If there are fewer, raise ValueError."
    about.read = "the docstring in calculus.py"
    expect_error(
        lambda: calculus.add_up_accelerations(times, [], Vector3(), Vector3()),
        ValueError,
        allowed=lambda: calculus.add_up_accelerations(
            [0.0, 1.0], vectors([ZERO]), Vector3(), Vector3()
        ),
    )


@pytest.mark.exercise("B2.13")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_sums_of_bad_vectors_are_refused(bad: float) -> None:
    names = ("the acceleration", "the position", "the velocity")
    for place, name in enumerate(names):
        rows = [ZERO, ZERO, ZERO]
        rows[place] = (0.0, bad, 0.0)
        a, p, v = (f"Vector3{row}" for row in rows)
        about.call = f"add_up_accelerations([0, 1], [{a}], position={p}, velocity={v})"
        about.cause = (
            f"A component of {name} is {bad}, so raise ValueError. finite_vector() in arguments.py "
            "checks a vector and raises the error for you."
        )
        about.read = "the docstring in calculus.py"

        def attempt(rows: list[Components]) -> Any:
            acceleration, *start = vectors(rows)
            return calculus.add_up_accelerations([0.0, 1.0], [acceleration], *start)

        expect_error(
            lambda rows=rows: attempt(rows), ValueError, allowed=lambda: attempt([ZERO] * 3)
        )
