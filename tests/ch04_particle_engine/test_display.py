"""Keep the display alive, project 4.1: which rocket a click hits."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from calls import calls
from ch04_particle_engine.display import find_rocket
from ch04_particle_engine.probes import game
from draw import number
from expect import about, expect_exactly, expect_that, scoped

FIND = "the docstring of find_rocket"
PAYLOADS = "Skip every firework whose rule has no payloads."


def expect_rocket(found: Any, cause: str | None = None) -> None:
    __tracebackhide__ = True
    cause = cause or about.cause
    expect_that(found is not None, "no rocket (None)", "the rocket", cause=cause)


@scoped
def why_none(x: float, y: float) -> str:
    """Return why a rocket that is 2.4 m away on a slant is not found."""
    about(f"one rocket, 2 m beside the click; find_rocket(display, {x}, {y})")
    if find_rocket(game((1, x + 2.0, y)), x, y) is not None:
        return (
            "You add up the distances along X and Y. The distance to the click is the straight "
            "line, sqrt(dx^2 + dy^2), which is 2.4 m here, less than REACH (2.5 m)."
        )
    return (
        "You don't find a rocket that is 2.4 m away, or even 2 m. Compare the distance with REACH, "
        "and don't forget its square root: it is sqrt(dx^2 + dy^2)."
    )


@pytest.mark.exercise("P4.1", asks="Find the rocket nearest to the point (x, y)", read=FIND)
def test_the_nearest_rocket_within_reach_is_found(rng: Random) -> None:
    x, y = number(rng), round(rng.uniform(20.0, 30.0), 3)
    with calls(
        "Return the Firework itself, not only a part of it.",
        "three rockets near the click: type 1 at 2 m, type 3 at 1 m, and type 1 at 1.5 m; "
        f"find_rocket(display, {x}, {y})",
    ):
        found = find_rocket(game((1, x - 2, y), (3, x + 1, y), (1, x, y + 1.5)), x, y)
        expect_that(found is not None, "no rocket (None)", "the rocket of type 3")
        type, is_last = found.type, found.particle.position.y == y + 1.5
    nearest = "You don't return the nearest rocket. Compare the distances of all of them."
    if is_last:
        nearest = "You return the last rocket within reach. Also store the distance of the nearest."
    expect_exactly(type, 3, then="; the type of the rocket that it returns", cause=nearest)
    for away, reached in ((2.4, True), (2.6, False)):
        with calls(
            "A rocket is within reach if its distance from the click, sqrt(dx^2 + dy^2), is at "
            "most REACH, which is 2.5 m. Otherwise return None.",
            f"one rocket, {away} m away from the click; find_rocket(display, {x}, {y})",
        ):
            found = find_rocket(game((1, x + away * 0.6, y - away * 0.8)), x, y)
            far = find_rocket(game((1, x + 9.0, y)), x, y)
        if reached:
            expect_rocket(found, why_none(x, y) if found is None else None)
            continue
        why = "Use the straight-line distance, sqrt(dx^2 + dy^2), which is 2.6 m here."
        if far is not None:
            why = "You return a rocket at any distance. Return None if it is above REACH (2.5 m)."
        expect_that(found is None, "the rocket", "no rocket (None)", cause=why)


@pytest.mark.exercise("P4.1", asks="also accept a rocket at exactly the distance REACH", read=FIND)
def test_a_rocket_at_exactly_the_reach_is_found() -> None:
    for place in ((2.5, 20.0), (-1.5, 22.0)):
        with calls(
            "You ignore a rocket at exactly the distance REACH (2.5 m), which is still within "
            "reach. Include the limit in your comparison.",
            f"one rocket at {place}, 2.5 m away from the click; find_rocket(display, 0, 20)",
        ):
            found = find_rocket(game((1, *place)), 0.0, 20.0)
        expect_rocket(found)


@pytest.mark.exercise("P4.1", asks="Measure distances in the X-Y plane", read=FIND)
def test_the_distance_to_a_rocket_leaves_out_z(rng: Random) -> None:
    x, y = number(rng), round(rng.uniform(20.0, 30.0), 3)
    with calls(
        "You include z in the distance between the click and the rocket. The screen shows only X "
        "and Y, so leave z out.",
        f"one rocket at x = {x}, y = {y}, z = 40; find_rocket(display, {x}, {y})",
    ):
        found = find_rocket(game((1, x, y), z=40.0), x, y)
    expect_rocket(found)


@pytest.mark.exercise("P4.1", asks="A rocket is any firework that lights others", read=FIND)
def test_sparks_are_not_rockets() -> None:
    with calls(
        f"You return a spark, because it is nearer to the click than the rocket. {PAYLOADS}",
        "a spark at (0, 20) and a rocket at (2, 20); find_rocket(display, 0, 20)",
    ):
        found = find_rocket(game((2, 0.0, 20.0), (1, 2.0, 20.0)), 0.0, 20.0)
    expect_rocket(found, f"You return no rocket, although one is within reach. {PAYLOADS}")
    expect_that(found.type == 1, "the spark", "the rocket")
    with calls(
        f"You return a spark. {PAYLOADS}",
        "a spark at (0, 20) and no rocket; find_rocket(display, 0, 20)",
    ):
        found = find_rocket(game((2, 0.0, 20.0)), 0.0, 20.0)
    expect_that(found is None, "the spark", "no rocket (None)")


@pytest.mark.exercise("P4.1", asks="Skip rockets with an age of 0 or less", read=FIND)
def test_a_rocket_without_a_fuse_is_skipped() -> None:
    skip = "which has no fuse left. Skip every rocket whose age is 0 or less."
    for age, which in ((0.0, "whose age is exactly 0"), (-0.5, "with a negative age")):
        with calls(
            f"You return a rocket {which}, {skip}",
            f"a rocket of type 1 and age {age} at (0, 20), and a rocket of type 3 and age 1.0 at "
            "(2, 20); find_rocket(display, 0, 20)",
        ):
            display = game((1, 0.0, 20.0), (3, 2.0, 20.0))
            display.show.fireworks[0].age = age
            found = find_rocket(display, 0.0, 20.0)
        expect_rocket(
            found,
            "You return no rocket, although the second one has fuse left and is within reach. Skip "
            "only the rockets whose age is 0 or less.",
        )
        expect_exactly(found.type, 3, then="; the type of the rocket that it returns")
