"""Sums of accelerations, build task B2.13."""

from __future__ import annotations

import math
from itertools import pairwise
from random import Random
from typing import Any

import pytest

from ch02_vectors import calculus
from ch02_vectors.tables import SMALL, TIMES, ZERO, draw_times, flat, pair_of_lists, shown
from ch02_vectors.vector import Vector3
from draw import Components, components, number, positive_number
from expect import (
    about,
    blame,
    expect_close,
    expect_error,
    expect_unchanged,
    scoped,
    xyz,
)

READ = "book 2.2.2, Eq. 2.8 and 2.9; the docstring of add_up_accelerations"


def vectors(rows: list[Components]) -> list[Any]:
    return [Vector3(*row) for row in rows]


@scoped
def motion_of(times: list[float], accelerations: list[Any], *start: Any) -> tuple[Any, Any]:
    """Call add_up_accelerations, and return the components of its positions and velocities."""
    __tracebackhide__ = True
    count = len(times)
    result = calculus.add_up_accelerations(times, accelerations, *start)
    positions, velocities = pair_of_lists(result, (count, count), ("positions", "velocities"))
    return flat([xyz(p) for p in positions]), flat([xyz(v) for v in velocities])


@pytest.mark.exercise("B2.13")
def test_one_interval_of_constant_acceleration(rng: Random) -> None:
    p, v, a = components(rng), components(rng), components(rng)
    start, h = number(rng, 1.0, 3.0), positive_number(rng, 0.3, 0.9)
    times = [start, round(start + h, 3)]
    about.call = (
        f"add_up_accelerations({times}, {shown([a])}, position=Vector3{p}, velocity=Vector3{v})"
    )
    about.read = READ
    about.cause = (
        "Under a constant acceleration, the position after an interval is p' = p + v h + a h^2 / 2."
    )
    places, motions = motion_of(times, vectors([a]), Vector3(*p), Vector3(*v))

    def moved(half: float) -> list[float]:
        return [x + u * h + half * b * h * h for x, u, b in zip(p, v, a, strict=True)]

    mistakes = [
        ([*p, *moved(0.0)], f"You leave out the last term. {about.cause}"),
        (
            [*p, *moved(1.0)],
            "Either you forget the factor 1/2 of a h^2 / 2, or you move with the new velocity. "
            "Take v from the start of the interval.",
        ),
        ([*p, *moved(1.5)], "You use the new velocity. Take v from the start of the interval."),
        ([*p, *moved(-0.5)], "You subtract the last term. Add a h^2 / 2."),
        ([*moved(0.5), *p], "Your list begins with the last position. Begin with the first."),
        (
            [*p, *(b * h * h / 2.0 + x for x, b in zip(p, a, strict=True))],
            "You leave out the term v h. The body also moves with its velocity.",
        ),
        (
            [*p, *(n - x for n, x in zip(moved(0.5), p, strict=True))],
            "This is only the displacement. Add it to the position before it.",
        ),
    ]
    blame(places, mistakes)
    expect_close(places, [*p, *moved(0.5)], then="; the positions", tolerance=SMALL)
    about.cause = "The velocity after an interval is v' = v + a h."
    fast = [u + b * h for u, b in zip(v, a, strict=True)]
    blame(
        motions,
        [
            ([*v, *(u + b for u, b in zip(v, a, strict=True))], f"You forget h. {about.cause}"),
            ([*v, *(b * h for b in a)], f"You forget the old velocity. {about.cause}"),
            ([*v, *v], f"Your velocity never changes. {about.cause}"),
        ],
    )
    expect_close(motions, [*v, *fast], then="; the velocities", tolerance=SMALL)


@pytest.mark.exercise("B2.13")
def test_each_interval_starts_where_the_last_one_ended(rng: Random) -> None:
    p, v = components(rng), components(rng)
    times = draw_times(rng, 5)
    rows = [components(rng) for _ in range(4)]
    about.call = (
        f"add_up_accelerations({times}, {shown(rows)}, position=Vector3{p}, velocity=Vector3{v})"
    )
    about.read = READ
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
    expect_close(motions, wanted_v, then="; the velocities", tolerance=SMALL)
    expect_close(places, wanted_p, then="; the positions", tolerance=SMALL)


@pytest.mark.exercise("B2.13")
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
    about.cause, about.read = in_place.format("a vector"), READ
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
