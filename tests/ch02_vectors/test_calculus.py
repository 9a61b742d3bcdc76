"""Difference quotients (B2.12) and sums of accelerations (B2.13) of tables."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from itertools import pairwise
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors import calculus
from ch02_vectors.vector import Vector3
from draw import Components, Triple, number, positive_number, vector
from expect import about, expect_close, expect_exactly, expect_unchanged, is_plain, xyz
from marching import march_slips

TIMES = [0.0, 0.5, 2.5]
# Numbers of up to 200 and intervals of at least 0.2 s have rounding errors below this limit.
SMALL = 1e-11
ZERO = Triple((0.0, 0.0, 0.0))
RATES = "book 2.2.1; the docstring of difference_quotients"
SUMS = "book 2.2.2, Eq. 2.8 and 2.9; the docstring of add_up_accelerations"
IN_PLACE = (
    "Your function changes a vector of the table, because -= and /= work in place. Write "
    "(b - a) / duration, which creates a new vector."
)
NEW_POSITION = (
    "Under a constant acceleration, the position after an interval is p' = p + v h + a h^2 / 2."
)
REFUSED = (
    "Your code raises ValueError, although this table is valid. difference_quotients gets as many "
    "vectors as times, and add_up_accelerations gets one vector less."
)
PAST_THE_END = (
    "Your loop goes past the end of a list. Between n times there are only n - 1 intervals. "
    "Interval i goes from times[i] to times[i + 1], and i ends at n - 2."
)


def draw_times(rng: Random, count: int) -> list[float]:
    """Draw times whose intervals have different lengths. The first time is not 0."""
    times = [number(rng, 1.0, 3.0)]
    for i in range(count - 1):
        times.append(round(times[-1] + (0.2, 0.9)[i % 2] + rng.uniform(0.0, 0.5), 3))
    return times


def flat(rows: Iterable[Components]) -> list[float]:
    return [n for row in rows for n in row]


@contextmanager
def explained_errors() -> Iterator[None]:
    """Explain an error that the lengths of a valid table can cause."""
    try:
        yield
    except (ValueError, IndexError) as error:
        about(cause=REFUSED if isinstance(error, ValueError) else PAST_THE_END)
        raise


def two_lists(result: Any, length: int, *names: str) -> tuple[Any, Any]:
    """Return the two lists of a result, after a check that they are lists of this length."""
    __tracebackhide__ = True
    pair = f"Return a pair of two lists: the {names[0]} and the {names[1]}."
    is_pair = isinstance(result, (tuple, list)) and len(result) == 2
    are_lists = is_pair and all(isinstance(part, (tuple, list)) for part in result)
    expect_exactly(are_lists, True, then="; is the result a pair of two lists?", cause=pair)
    for part, name in zip(result, names, strict=True):
        cause = f"The list of {name} has the length {len(part)}, but it must have {length}."
        if len(part) == length + 1 and "quotients" in names:
            cause += " Between n times there are only n - 1 intervals."
        if len(part) == length - 1:
            cause += " Either you return in the loop, or you leave out the first or last one."
        expect_exactly(len(part), length, then=f"; the number of {name}", cause=cause)
    return result[0], result[1]


def quotients_of(
    times: list[float], rows: list[Triple], cause: str
) -> tuple[list[Any], list[float], list[float]]:
    """Return the table's vectors, the times of the quotients, and the quotients' components."""
    __tracebackhide__ = True
    with calls(cause), explained_errors():
        values = [Vector3(*row) for row in rows]
        result = calculus.difference_quotients(times, values)
    middles, quotients = two_lists(result, len(rows) - 1, "times", "quotients")
    cause = "Return the times first and the quotients second. The quotients are vectors."
    if any(not is_plain(m) for m in middles) and all(map(is_plain, quotients)):
        cause = "You return the two lists in the wrong order. Return the times first."
    expect_exactly(all(map(is_plain, middles)), True, then="; are the times numbers?", cause=cause)
    are_vectors = not any(map(is_plain, quotients))
    expect_exactly(are_vectors, True, then="; are the quotients vectors?", cause=cause)
    return values, list(middles), flat(map(xyz, quotients))


def motion_of(
    times: list[float], rows: list[Triple], p: Triple, v: Triple, cause: str
) -> tuple[list[float], list[float]]:
    """Return the components of the positions and velocities of add_up_accelerations."""
    __tracebackhide__ = True
    with calls(cause), explained_errors():
        accelerations = [Vector3(*row) for row in rows]
        result = calculus.add_up_accelerations(
            times, accelerations, position=Vector3(*p), velocity=Vector3(*v)
        )
    positions, velocities = two_lists(result, len(times), "positions", "velocities")
    return flat(map(xyz, positions)), flat(map(xyz, velocities))


def expect_the_same_table(values: list[Any], rows: list[Triple]) -> None:
    """Expect that the function has not changed a vector of the table."""
    __tracebackhide__ = True
    lists = "Your function changes the lists of the caller. Only read them."
    expect_exactly(len(values), len(rows), then="; len(values) after the call", cause=lists)
    for i, row in enumerate(rows):
        expect_unchanged(f"values[{i}]", values[i], row, cause=IN_PLACE)


# B2.12 Average rates of change


@pytest.mark.exercise("B2.12", asks="the change of the vector divided by the duration", read=RATES)
def test_a_quotient_is_the_change_divided_by_its_own_interval(rng: Random) -> None:
    rows = [vector(rng) for _ in TIMES]
    cause = "Subtract the earlier vector from the later one, and divide by the interval's duration."
    values, _, got = quotients_of(TIMES, rows, cause)
    expect_the_same_table(values, rows)
    first, second = rows[1] - rows[0], rows[2] - rows[1]
    slips = {
        "You return the changes. Divide each of them by its interval.": (*first, *second),
        "Your quotients have the wrong sign.": (*first / -0.5, *second / -2.0),
        "You divide by the time at the end of the interval.": (*first / 0.5, *second / 2.5),
        "You divide all changes by the first interval.": (*first / 0.5, *second / 0.5),
        "You divide all changes by the last interval.": (*first / 2.0, *second / 2.0),
        "You divide all changes by the average duration.": (*first / 1.25, *second / 1.25),
        "You divide only the earlier vector by the duration. Put the difference in ( ).":
            (*rows[1] - rows[0] / 0.5, *rows[2] - rows[1] / 2.0),
        "You divide each change by the duration of the other interval.":
            (*first / 2.0, *second / 0.5),
        "You multiply the change by the duration.": (*first * 0.5, *second * 2.0),
    }  # fmt: skip
    wanted = (*first / 0.5, *second / 2.0)
    expect_close(got, wanted, slips, then="; the quotients", tolerance=SMALL)


@pytest.mark.exercise("B2.12", asks="Return the times in the middle of the intervals", read=RATES)
def test_the_times_of_the_quotients_are_in_the_middle(rng: Random) -> None:
    times = draw_times(rng, 4)
    cause = "The time of a quotient is the middle of its interval, the mean of the two times."
    _, got, _ = quotients_of(times, [vector(rng) for _ in times], cause)
    spans = [*pairwise(times)]
    middles = [(start + end) / 2.0 for start, end in spans]
    slips = {
        "Either you return the starts of the intervals, or you halve the duration with //, which "
        "rounds down to 0.": times[:-1],
        "You return the ends of the intervals.": times[1:],
        "You return the durations of the intervals.": [end - start for start, end in spans],
        "This is half the duration. Add the start to it.":
            [(end - start) / 2.0 for start, end in spans],
        "This is the sum of the two times. Divide it by 2.": [start + end for start, end in spans],
        "You divide with //, which rounds down to a whole number. Use / instead.":
            [(start + end) // 2.0 for start, end in spans],
        "Your formula lacks brackets, so only the second time is halved. Halve the sum.":
            [start + end / 2.0 for start, end in spans],
    }  # fmt: skip
    expect_close(got, middles, slips, then="; the times", tolerance=SMALL)


@pytest.mark.exercise(
    "B2.12", asks="is exactly the velocity in the middle of the interval", read=RATES
)
def test_under_constant_acceleration_they_are_the_velocities_in_the_middle(rng: Random) -> None:
    p, v, a = vector(rng), vector(rng), vector(rng)
    times = draw_times(rng, 5)
    rows = [p + v * t + a * (t * t / 2.0) for t in times]
    cause = (
        "These positions belong to a constant acceleration. Each quotient must then equal the "
        "velocity in the middle of its interval."
    )
    _, middles, got = quotients_of(times, rows, cause)
    # The average velocity is exactly the one at the middle, because the velocity is linear in time.
    wanted = flat(v + a * ((start + end) / 2.0) for start, end in pairwise(times))
    expect_close(got, wanted, then="; the quotients", tolerance=1e-10)
    again = [Triple(got[i : i + 3]) for i in range(0, len(got), 3)]
    cause = "These are velocities under a constant acceleration, which each quotient must equal."
    _, _, twice = quotients_of(middles, again, cause)
    expect_close(twice, [*a] * 3, then="; the quotients", tolerance=1e-9)


@pytest.mark.exercise("B2.12", asks="No function here changes its arguments", read=RATES)
def test_the_table_stays_the_same(rng: Random) -> None:
    drawn, rows = draw_times(rng, 3), [vector(rng) for _ in range(3)]
    times = [*drawn]
    values, _, _ = quotients_of(times, rows, IN_PLACE)
    expect_the_same_table(values, rows)
    changed = "Your function changes the list of times. Only read it."
    expect_unchanged("times", times, drawn, cause=changed)


# B2.13 From accelerations back to positions


@pytest.mark.exercise("B2.13", asks="p' = p + v h + a h^2 / 2 and", read=SUMS)
def test_one_interval_of_constant_acceleration(rng: Random) -> None:
    p, v, a = vector(rng), vector(rng), vector(rng)
    start, h = number(rng, 1.0, 3.0), positive_number(rng, 0.3, 0.9)
    end = round(start + h, 3)
    places, motions = motion_of([start, end], [a], p, v, NEW_POSITION)

    def moved(half: float, h: float = h) -> Triple:
        return p + v * h + a * (half * h * h)

    no_velocity = "You leave out the term v h. The body also moves with its velocity."
    if motions[:3] == [0.0, 0.0, 0.0]:
        no_velocity = "Your body starts at rest. Begin with the given velocity, or with a copy."
    in_time = (
        "You use the time {} of the interval as its duration h. The duration is the end minus the "
        "start, times[i + 1] - times[i]."
    ).format
    slips = {
        "Either you leave out the last term, or you write its factor as 1 // 2, which is 0.":
            (*p, *moved(0.0)),
        in_time("at the end"): (*p, *moved(0.5, end)),
        in_time("at the start"): (*p, *moved(0.5, start)),
        "Your duration is negative. Subtract the start from the end.": (*p, *moved(0.5, -h)),
        "You return the two lists in the wrong order. Return the positions first.":
            (*v, *v + a * h),
        "Your body starts at the origin. Begin with the given position, or with a copy of it.":
            (*ZERO, *moved(0.5) - p),
        "Either you forget the factor 1/2 of a h^2 / 2, or you move with the new velocity. Take v "
        "from the start of the interval.": (*p, *moved(1.0)),
        "You use the new velocity. Take v from the start of the interval.": (*p, *moved(1.5)),
        "Your last term is a h^2 / 4. Square only h, and then halve it.": (*p, *moved(0.25)),
        "You subtract the last term. Add a h^2 / 2.": (*p, *moved(-0.5)),
        "Your list begins with the last position. Begin with the first.": (*moved(0.5), *p),
        "Both positions are the same vector, which you change after you have put it into the list. "
        "Put in a copy, or compute a new vector.": (*moved(0.5), *moved(0.5)),
        no_velocity: (*p, *moved(0.5) - v * h),
        "This is only the displacement. Add it to the position before it.": (*p, *moved(0.5) - p),
    }  # fmt: skip
    expect_close(places, (*p, *moved(0.5)), slips, then="; the positions", tolerance=SMALL)
    slips = {
        "You forget h.": (*v, *v + a),
        "You forget the old velocity.": (*v, *a * h),
        "Your velocity never changes.": (*v, *v),
    }
    about(cause="The velocity after an interval is v' = v + a h.")
    expect_close(motions, (*v, *v + a * h), slips, then="; the velocities", tolerance=SMALL)


@pytest.mark.exercise("B2.13", asks="Return both lists, which begin with", read=SUMS)
def test_each_interval_starts_where_the_last_one_ended(rng: Random) -> None:
    p, v = vector(rng), vector(rng)
    times = draw_times(rng, 5)
    rows = [vector(rng) for _ in range(4)]
    cause = (
        "Each acceleration acts in its own interval, which has its own duration. Update the "
        "velocity in every interval, and start the next one with the new position and velocity."
    )
    places, motions = motion_of(times, rows, p, v, cause)
    # Each acceleration a adds a h to all later velocities, as if it came at the middle of its
    # interval. So a later position gains a h times the time since that middle.
    wanted_p, wanted_v = [p + v * (time - times[0]) for time in times], [v] * 5
    for i, (start, end) in enumerate(pairwise(times)):
        gained = rows[i] * (end - start)
        for n in range(i + 1, 5):
            wanted_v[n] += gained
            wanted_p[n] += gained * (times[n] - (start + end) / 2.0)
    slips = march_slips(times, rows, p, v)
    fast, far = ({cause: both[i] for both, cause in slips} for i in (1, 0))
    expect_close(motions, flat(wanted_v), fast, then="; the velocities", tolerance=SMALL)
    expect_close(places, flat(wanted_p), far, then="; the positions", tolerance=SMALL)


@pytest.mark.exercise("B2.13", asks="all vectors in the results are new", read=SUMS)
def test_the_results_are_new_vectors(rng: Random) -> None:
    drawn = vector(rng), vector(rng), vector(rng)
    in_place = (
        "Your function changes {} of the caller, because add_scaled, += and *= work in place. "
        "Start with copies."
    ).format
    with calls(in_place("a vector")):
        p, v, a = [Vector3(*each) for each in drawn]
        result = calculus.add_up_accelerations(TIMES, [a, a], position=p, velocity=v)
    lists = two_lists(result, 3, "positions", "velocities")
    for name, now, before in zip("pva", (p, v, a), drawn, strict=True):
        expect_unchanged(name, now, before, cause=in_place(name))
    for name, made, before in zip(("positions", "velocities"), lists, drawn, strict=False):
        kept = [xyz(one) for one in made]
        one = f"The {name} in your list are one and the same vector, which you change in every "
        one += "interval. Create a new vector for each time."
        expect_close(kept[0], before, then=f"; {name}[0]", cause=one)
        own = f"The first of the {name} is the caller's own vector. Put in a copy."
        with calls(own, f"{name}[0].x += 99", more=True):
            made[0].x += 99.0
        expect_unchanged("p", p, drawn[0])
        expect_unchanged("v", v, drawn[1])
        one = f"Two of the {name} are one and the same vector. Create one for each time."
        for i in (1, 2):
            expect_unchanged(f"{name}[{i}]", made[i], kept[i], cause=one)
