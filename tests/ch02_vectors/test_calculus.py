"""Difference quotients (B2.12) and sums of accelerations (B2.13) of tables."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from random import Random
from typing import Any

import pytest

from ch02_vectors import calculus
from ch02_vectors.vector import Vector3
from draw import Components, components, number, positive_number, rounded
from expect import (
    about,
    blame,
    expect_close,
    expect_exactly,
    expect_unchanged,
    is_plain,
    scoped,
    xyz,
)
from marching import march_slips

TIMES = [0.0, 0.5, 2.5]
# Numbers of up to 200 and intervals of at least 0.2 s have rounding errors below this limit.
SMALL = 1e-11
QUOTIENTS = "book 2.2.1; the docstring of difference_quotients"
IN_PLACE = (
    "Your function changes a vector of the table, because -= and /= work in place. Write "
    "(b - a) / duration, which creates a new vector."
)
FLOOR = "You divide with //, which rounds down to a whole number. Use / instead."
SUMS = "book 2.2.2, Eq. 2.8 and 2.9; the docstring of add_up_accelerations"


def vectors(rows: list[Components]) -> list[Any]:
    return [Vector3(*row) for row in rows]


def draw_times(rng: Random, count: int) -> list[float]:
    """Draw times whose intervals have different lengths. The first time is not 0."""
    times = [number(rng, 1.0, 3.0)]
    for i in range(count - 1):
        times.append(round(times[-1] + (0.2, 0.9)[i % 2] + rng.uniform(0.0, 0.5), 3))
    return times


def shown(rows: list[Components]) -> str:
    return f"[{', '.join(f'Vector3{rounded(row)}' for row in rows)}]"


def flat(rows: list[Components]) -> list[float]:
    return [n for row in rows for n in row]


@scoped
def pair_of_lists(result: Any, lengths: tuple[int, int], names: tuple[str, str]) -> tuple[Any, Any]:
    """Return the two lists of a result, after a check that they are lists of these lengths."""
    __tracebackhide__ = True
    about.cause = f"Return a pair of two lists: the {names[0]} and the {names[1]}."
    is_pair = isinstance(result, (tuple, list)) and len(result) == 2
    are_lists = is_pair and all(isinstance(part, (tuple, list)) for part in result)
    expect_exactly(are_lists, True, then="; is the result a pair of two lists?")
    for part, length, name in zip(result, lengths, names, strict=True):
        about.cause = f"The list of {name} has the length {len(part)}, but it must have {length}."
        if len(part) == length + 1 and "quotients" in names:
            about.cause += " Between n times there are only n - 1 intervals."
        if len(part) == length - 1:
            about.cause += " Either you return in the loop, or you leave out the first or last one."
        expect_exactly(len(part), length, then=f"; the number of {name}")
    return result[0], result[1]


def tried(function: Callable[..., Any], *given: Any) -> Any:
    """Call a function with a valid table, and explain an error that its lengths can cause."""
    __tracebackhide__ = True
    try:
        return function(*given)
    except ValueError:
        about.cause = (
            "Your code raises ValueError, although this table is valid. difference_quotients gets "
            "as many vectors as times, and add_up_accelerations gets one vector less."
        )
        raise
    except IndexError:
        about.cause = (
            "Your loop goes past the end of a list. Between n times there are only n - 1 "
            "intervals. Interval i goes from times[i] to times[i + 1], and i ends at n - 2."
        )
        raise


def expect_the_same_table(given: list[Any], rows: list[Components]) -> None:
    """Expect that the function has not changed a vector of the table."""
    __tracebackhide__ = True
    lists = "Your function changes the lists of the caller. Only read them."
    expect_exactly(len(given), len(rows), then="; the length of values after the call", cause=lists)
    for i, row in enumerate(rows):
        expect_unchanged(f"values[{i}]", xyz(given[i]), row, cause=IN_PLACE)


@scoped
def quotients_of(times: list[float], values: list[Any]) -> tuple[Any, list[float]]:
    """Call difference_quotients, and return its times and the components of its vectors."""
    __tracebackhide__ = True
    count = len(times) - 1
    result = tried(calculus.difference_quotients, times, values)
    middles, quotients = pair_of_lists(result, (count, count), ("times", "quotients"))
    about.cause = "Return the times first and the quotients second. The quotients are vectors."
    if any(not is_plain(m) for m in middles) and all(map(is_plain, quotients)):
        about.cause = "You return the two lists in the wrong order. Return the times first."
    expect_exactly(all(map(is_plain, middles)), True, then="; are the times numbers?")
    expect_exactly(any(map(is_plain, quotients)), False, then="; are the quotients vectors?")
    return middles, flat([xyz(q) for q in quotients])


@scoped
def motion_of(times: list[float], accelerations: list[Any], *start: Any) -> tuple[Any, Any]:
    """Call add_up_accelerations, and return the components of its positions and velocities."""
    __tracebackhide__ = True
    count = len(times)
    result = tried(calculus.add_up_accelerations, times, accelerations, *start)
    positions, velocities = pair_of_lists(result, (count, count), ("positions", "velocities"))
    return flat([xyz(p) for p in positions]), flat([xyz(v) for v in velocities])


# B2.12 Average rates of change


@pytest.mark.exercise("B2.12", asks="the change of the vector divided by the duration")
def test_a_quotient_is_the_change_divided_by_its_own_interval(rng: Random) -> None:
    rows = [components(rng) for _ in TIMES]
    about.call = f"difference_quotients([0, 0.5, 2.5], {shown(rows)})"
    about.read = QUOTIENTS
    about.cause = (
        "In each interval, subtract the vector at its start from the vector at its end, and divide "
        "the difference by the duration of this interval."
    )
    given = vectors(rows)
    _, got = quotients_of(TIMES, given)
    expect_the_same_table(given, rows)
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
        *(
            (over(d, d), f"You divide all changes by the {n}. Divide each by its own interval.")
            for n, d in (
                ("first interval", 0.5),
                ("last interval", 2.0),
                ("average duration", 1.25),
            )
        ),
        (
            [rows[i + 1][j] - rows[i][j] / (0.5, 2.0)[i] for i in (0, 1) for j in range(3)],
            "You divide only the earlier vector by the duration. Put the difference in ( ).",
        ),
        (
            over(2.0, 0.5),
            "You divide each change by the duration of the other interval. Divide it by its own.",
        ),
        (
            [n * d for row, d in zip(changes, (0.5, 2.0), strict=True) for n in row],
            "You multiply the change by the duration. Divide it by the duration.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, over(0.5, 2.0), then="; the quotients", tolerance=SMALL)


@pytest.mark.exercise("B2.12", asks="Return the times in the middle of the intervals")
def test_the_times_of_the_quotients_are_in_the_middle(rng: Random) -> None:
    times = draw_times(rng, 4)
    rows = [components(rng) for _ in times]
    about.call = f"difference_quotients({times}, {shown(rows)})"
    about.read = QUOTIENTS
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
            (
                starts,
                "Either you return the starts of the intervals, or you halve the duration with //, "
                "which rounds down to 0. The time must be the middle of the interval.",
            ),
            (ends, f"You return the ends of the intervals. {about.cause}"),
            (durations, f"You return the durations of the intervals. {about.cause}"),
            ([d / 2.0 for d in durations], "This is half the duration. Add the start to it."),
            ([2.0 * m for m in middles], "This is the sum of the two times. Divide it by 2."),
            ([2.0 * m // 2.0 for m in middles], FLOOR),
            (
                [s + e / 2.0 for s, e in zip(starts, ends, strict=True)],
                "Your formula lacks brackets, so only the second time is halved. Halve the sum.",
            ),
        ],
    )
    expect_close(list(got), middles, then="; the times", tolerance=SMALL)


@pytest.mark.exercise("B2.12", asks="is exactly the velocity in the middle of the interval")
def test_under_constant_acceleration_they_are_the_velocities_in_the_middle(rng: Random) -> None:
    p, v, a = components(rng), components(rng), components(rng)
    times = draw_times(rng, 5)
    rows = [
        tuple(x + u * t + b * t * t / 2.0 for x, u, b in zip(p, v, a, strict=True)) for t in times
    ]
    about.call = f"difference_quotients({times}, {shown(rows)})"
    about.read = QUOTIENTS
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


@pytest.mark.exercise("B2.12", asks="No function here changes its arguments")
def test_the_table_stays_the_same(rng: Random) -> None:
    times, rows = draw_times(rng, 3), [components(rng) for _ in range(3)]
    given_times, given = list(times), vectors(rows)
    about.call = f"times, values = {times}, {shown(rows)}; difference_quotients(times, values)"
    about.cause, about.read = IN_PLACE, QUOTIENTS
    quotients_of(given_times, given)
    expect_the_same_table(given, rows)
    changed = "Your function changes the list of times. Only read it."
    expect_unchanged("times", given_times, times, cause=changed)


# B2.13 From accelerations back to positions


@pytest.mark.exercise("B2.13", asks="p' = p + v h + a h^2 / 2 and")
def test_one_interval_of_constant_acceleration(rng: Random) -> None:
    p, v, a = components(rng), components(rng), components(rng)
    start, h = number(rng, 1.0, 3.0), positive_number(rng, 0.3, 0.9)
    times = [start, round(start + h, 3)]
    about.call = (
        f"add_up_accelerations({times}, {shown([a])}, position=Vector3{p}, velocity=Vector3{v})"
    )
    about.read = SUMS
    about.cause = (
        "Under a constant acceleration, the position after an interval is p' = p + v h + a h^2 / 2."
    )
    places, motions = motion_of(times, vectors([a]), Vector3(*p), Vector3(*v))

    def moved(half: float, h: float = h) -> list[float]:
        return [x + u * h + half * b * h * h for x, u, b in zip(p, v, a, strict=True)]

    fast = [u + b * h for u, b in zip(v, a, strict=True)]
    from_rest = [b * h * h / 2.0 + x for x, b in zip(p, a, strict=True)]
    no_velocity = "You leave out the term v h. The body also moves with its velocity."
    if motions[:3] == [0.0, 0.0, 0.0]:
        no_velocity = "Your body starts at rest. Begin with the given velocity, or with a copy."
    in_time = (
        "You use the time {} of the interval as its duration h. The duration is the end minus the "
        "start, times[i + 1] - times[i]."
    ).format
    mistakes = [
        (
            [*p, *moved(0.0)],
            "Either you leave out the last term, or you write its factor as 1 // 2, which is 0. "
            f"{about.cause}",
        ),
        ([*p, *moved(0.5, times[1])], in_time("at the end")),
        ([*p, *moved(0.5, times[0])], in_time("at the start")),
        ([*p, *moved(0.5, -h)], "Your duration is negative. Subtract the start from the end."),
        ([*v, *fast], "You return the two lists in the wrong order. Return the positions first."),
        (
            [0.0, 0.0, 0.0, *(n - x for n, x in zip(moved(0.5), p, strict=True))],
            "Your body starts at the origin. Begin with the given position, or with a copy of it.",
        ),
        (
            [*p, *moved(1.0)],
            "Either you forget the factor 1/2 of a h^2 / 2, or you move with the new velocity. "
            "Take v from the start of the interval.",
        ),
        ([*p, *moved(1.5)], "You use the new velocity. Take v from the start of the interval."),
        ([*p, *moved(0.25)], "Your last term is a h^2 / 4. Square only h, and then halve it."),
        ([*p, *moved(-0.5)], "You subtract the last term. Add a h^2 / 2."),
        ([*moved(0.5), *p], "Your list begins with the last position. Begin with the first."),
        (
            [*moved(0.5), *moved(0.5)],
            "Both positions are the same vector, which you change after you have put it into the "
            "list. Put in a copy, or compute a new vector.",
        ),
        ([*p, *from_rest], no_velocity),
        (
            [*p, *(n - x for n, x in zip(moved(0.5), p, strict=True))],
            "This is only the displacement. Add it to the position before it.",
        ),
    ]
    blame(places, mistakes)
    expect_close(places, [*p, *moved(0.5)], then="; the positions", tolerance=SMALL)
    about.cause = "The velocity after an interval is v' = v + a h."
    blame(
        motions,
        [
            ([*v, *(u + b for u, b in zip(v, a, strict=True))], f"You forget h. {about.cause}"),
            ([*v, *(b * h for b in a)], f"You forget the old velocity. {about.cause}"),
            ([*v, *v], f"Your velocity never changes. {about.cause}"),
        ],
    )
    expect_close(motions, [*v, *fast], then="; the velocities", tolerance=SMALL)


@pytest.mark.exercise("B2.13", asks="Return both lists, which begin with")
def test_each_interval_starts_where_the_last_one_ended(rng: Random) -> None:
    p, v = components(rng), components(rng)
    times = draw_times(rng, 5)
    rows = [components(rng) for _ in range(4)]
    about.call = (
        f"add_up_accelerations({times}, {shown(rows)}, position=Vector3{p}, velocity=Vector3{v})"
    )
    about.read = SUMS
    about.cause = (
        "Each acceleration acts in its own interval, which has its own duration. Update the "
        "velocity in every interval, and start the next one with the new position and velocity."
    )
    places, motions = motion_of(times, vectors(rows), Vector3(*p), Vector3(*v))
    # Each acceleration a adds a h to all later velocities, as if it came at the middle of its
    # interval. So a later position gains a h times the time since that middle.
    spans = list(pairwise(times))
    wanted_v, wanted_p = [*v], [*p]
    for n in range(1, 5):
        past = [
            (a, end - start, times[n] - (start + end) / 2.0)
            for a, (start, end) in zip(rows[:n], spans[:n], strict=True)
        ]
        for i in range(3):
            wanted_v.append(v[i] + math.fsum(a[i] * h for a, h, _ in past))
            gained = math.fsum(a[i] * h * since for a, h, since in past)
            wanted_p.append(p[i] + v[i] * (times[n] - times[0]) + gained)
    slips = march_slips(times, rows, p, v)
    blame(motions, [(fast, cause) for (_, fast), cause in slips])
    expect_close(motions, wanted_v, then="; the velocities", tolerance=SMALL)
    blame(places, [(far, cause) for (far, _), cause in slips])
    expect_close(places, wanted_p, then="; the positions", tolerance=SMALL)


@pytest.mark.exercise("B2.13", asks="all vectors in the results are new")
def test_the_results_are_new_vectors(rng: Random) -> None:
    p, v, a = components(rng), components(rng), components(rng)
    position, velocity, pull = Vector3(*p), Vector3(*v), Vector3(*a)
    about.call = (
        f"p, v, a = Vector3{p}, Vector3{v}, Vector3{a}; "
        "add_up_accelerations([0, 0.5, 2.5], [a, a], position=p, velocity=v)"
    )
    in_place = (
        "Your function changes {} of the caller, because add_scaled, += and *= work in place. "
        "Start with copies."
    )
    about.cause, about.read = in_place.format("a vector"), SUMS
    result = calculus.add_up_accelerations(TIMES, [pull, pull], position, velocity)
    lists = pair_of_lists(result, (3, 3), ("positions", "velocities"))
    for name, now, before in (("p", position, p), ("v", velocity, v), ("a", pull, a)):
        expect_unchanged(name, xyz(now), before, cause=in_place.format(name))
    for name, made, before in zip(("positions", "velocities"), lists, (p, v), strict=True):
        kept = [xyz(one) for one in made]
        about.cause = (
            f"The {name} in your list are one and the same vector, which you change in every "
            "interval. Create a new vector for each time."
        )
        expect_close(kept[0], before, then=f"; {name}[0]")
        made[0].x += 99.0
        about.call += f"; {name}[0].x += 99"
        about.cause = f"The first of the {name} is the caller's own vector. Put in a copy."
        expect_unchanged("p", xyz(position), p)
        expect_unchanged("v", xyz(velocity), v)
        about.cause = f"Two of the {name} are one and the same vector. Create one for each time."
        for i in (1, 2):
            expect_unchanged(f"{name}[{i}]", xyz(made[i]), kept[i])
