"""Keep the display alive, project 4.1: the rules of the game, without a screen."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import display, probes
from draw import number
from expect import about, expect_close, expect_exactly

STILL = (0.0, 0.0, 0.0)
# Type 1 is a rocket that leaves three sparks of type 2. Type 3 is another rocket.
RULES: list[probes.RuleData] = [
    (1, 2.0, 2.0, STILL, STILL, 1.0, ((2, 3),)),
    (2, 5.0, 5.0, STILL, STILL, 1.0, ()),
    (3, 1.0, 1.0, STILL, STILL, 1.0, ((2, 1),)),
]


def game(*lit: tuple[int, float, float], z: float = 0.0) -> Any:
    """Return a game with fireworks of these types at these points of the X-Y plane."""
    show = probes.show_of(RULES, 50, "keep_old", 1)
    for type, x, y in lit:
        show.light([(type, 1, Particle(Vector3(x, y, z)))])
    return display.Display(show)


def types(of: Any) -> list[int]:
    return [firework.type for firework in of.show.fireworks]


@pytest.mark.exercise("P4.1")
def test_the_nearest_rocket_within_reach_is_found(rng: Random) -> None:
    x, y = number(rng), round(rng.uniform(20.0, 30.0), 3)
    about.read = "the docstring of find_rocket"
    about.cause = (
        "Several rockets are within reach here. Return the one nearest to the click, which is not "
        "always the first in the list."
    )
    about.call = (
        f"rockets at ({x} - 2, {y}), ({x} + 1, {y}) and ({x}, {y} + 1.5); find_rocket(display, "
        f"{x}, {y})"
    )
    found = display.find_rocket(game((1, x - 2, y), (3, x + 1, y), (1, x, y + 1.5)), x, y)
    expect_exactly(found is None, False, then=" is None")
    what = None if found is None else found.type
    expect_exactly(what, 3, then=", its type")
    for away, reached in ((2.4, True), (2.6, False)):
        about.cause = (
            "A rocket is within reach if its distance in the X-Y plane, sqrt(dx^2 + dy^2), is at "
            "most REACH, which is 2.5 m."
        )
        place = (x + away * 0.6, y - away * 0.8)
        about.call = f"one rocket, {away} m from the click; find_rocket(display, {x}, {y}) is None"
        found = display.find_rocket(game((1, *place)), x, y)
        expect_exactly(found is None, not reached)


@pytest.mark.exercise("P4.1")
def test_a_rocket_at_exactly_the_reach_is_found() -> None:
    about(
        cause=(
            "A rocket at exactly the distance REACH is still within reach, so find_rocket must "
            "return it."
        )
    )
    about.read = "the docstring of find_rocket"
    for place in ((2.5, 20.0), (-1.5, 22.0)):
        about.call = f"one rocket at {place}; find_rocket(display, 0, 20) is None"
        found = display.find_rocket(game((1, *place)), 0.0, 20.0)
        expect_exactly(found is None, False)


@pytest.mark.exercise("P4.1")
def test_what_lies_behind_on_the_screen_is_found_too(rng: Random) -> None:
    x, y = number(rng), round(rng.uniform(20.0, 30.0), 3)
    about.call = f"one rocket at ({x}, {y}, 40); find_rocket(display, {x}, {y}) is None"
    about(
        cause="The screen shows only X and Y, so leave z out of the distance.",
        read="the docstring of find_rocket",
    )
    found = display.find_rocket(game((1, x, y), z=40.0), x, y)
    expect_exactly(found is None, False)


@pytest.mark.exercise("P4.1")
def test_sparks_are_no_rockets() -> None:
    about.call = "a spark at (0, 20), a rocket at (2, 20); find_rocket(display, 0, 20), its type"
    about.cause = (
        "find_rocket must not return a spark. A firework is a rocket only if its rule has payloads."
    )
    about.read = "the docstring of find_rocket"
    found = display.find_rocket(game((2, 0.0, 20.0), (1, 2.0, 20.0)), 0.0, 20.0)
    what = found is not None and found.type
    expect_exactly(what, 1)
    about.call = "a spark at (0, 20); find_rocket(display, 0, 20) is None"
    found = display.find_rocket(game((2, 0.0, 20.0)), 0.0, 20.0)
    expect_exactly(found is None, True)


@pytest.mark.exercise("P4.1")
def test_a_rocket_without_a_fuse_is_past_saving() -> None:
    about.read = "the docstring of find_rocket"
    for age, cause in (
        (
            0.0,
            "A rocket of age 0 bursts in the next update. If find_rocket returned it, a second "
            "click could hit the same rocket again.",
        ),
        (
            -0.5,
            (
                "A rocket with an age of 0 or less has no fuse left, so find_rocket must not "
                "return it."
            ),
        ),
    ):
        about.cause = cause
        about.call = (
            f"rockets at (0, 20) with the age {age} and at (2, 20); find_rocket(display, 0, 20)"
        )
        a_game = game((1, 0.0, 20.0), (3, 2.0, 20.0))
        a_game.show.fireworks[0].age = age
        found = display.find_rocket(a_game, 0.0, 20.0)
        what = found is not None and found.type
        expect_exactly(what, 3, then=", its type")


@pytest.mark.exercise("P4.1")
def test_a_click_bursts_the_rocket_and_launches_another() -> None:
    about.call = "rockets of types 1 and 3 at (0, 20) and (9, 20); click(display, 9, 20)"
    about.read = "the docstring of click"
    a_game = game((1, 0.0, 20.0), (3, 9.0, 20.0))
    about.cause = "This click hit a rocket, so return True."
    hit = display.click(a_game, 9.0, 20.0)
    expect_exactly(hit, True)
    about.cause = (
        "After a hit, launch another rocket of the same type. Don't remove the rocket that was "
        "hit, because it burns until the next update."
    )
    expect_exactly(types(a_game), [1, 3, 3], then="; types in the show")
    about.cause = (
        "Set the age of the rocket that was hit to 0, so that the show bursts it in the next "
        "update."
    )
    ages = tuple(firework.age for firework in a_game.show.fireworks)
    expect_close(ages, (2.0, 0.0, 1.0), then="; ages")
    height = a_game.show.fireworks[2].particle.position.y
    about.cause = (
        "The new rocket must start on the ground. Launch it with show.launch, which puts it there."
    )
    expect_close(height, 0.0, then="; height of the new one")
    a_game.show.update(0.001)
    about.cause = (
        "The rocket that was hit must burst in the next update and leave its payload of one "
        "firework of type 2."
    )
    expect_exactly(types(a_game).count(2), 1, then="; show.update(0.001); how many of type 2")


@pytest.mark.exercise("P4.1")
def test_a_late_click_scores_more() -> None:
    about.read = "the docstring of click"
    for fuse, score, cause in (
        (
            1.5,
            1,
            "A hit with 1.5 s of fuse left scores 1. The score depends on how much fuse is left, "
            "so read the age before you set it to 0.",
        ),
        (
            0.4,
            1,
            "A hit scores 3 only if less than 0.4 s (LATE) of the fuse is left. At exactly 0.4 s "
            "it still scores 1.",
        ),
        (
            0.39,
            3,
            "A hit scores 3 if less than LATE of the fuse is left. The score depends on how much "
            "fuse is left, so read the age before you set it to 0.",
        ),
    ):
        about(f"a rocket at (0, 20) with {fuse} s of fuse; click(display, 0, 20); ", cause=cause)
        about.call += "display.score"
        a_game = game((1, 0.0, 20.0))
        a_game.show.fireworks[0].age = fuse
        display.click(a_game, 0.0, 20.0)
        expect_exactly(a_game.score, score)
        about.cause = "A click that hits a rocket is not a miss, so leave misses alone."
        name = about.call.replace("display.score", "display.misses")
        expect_exactly(a_game.misses, 0, call=name)
    about.call = "two rockets; click(display, 0, 20); click(display, 9, 20); display.score"
    about.cause = (
        "Each hit adds its points to the score. Don't overwrite the points of earlier hits."
    )
    a_game = game((1, 0.0, 20.0), (3, 9.0, 20.0))
    display.click(a_game, 0.0, 20.0)
    display.click(a_game, 9.0, 20.0)
    expect_exactly(a_game.score, 2)


@pytest.mark.exercise("P4.1")
def test_a_click_into_the_dark_is_a_miss() -> None:
    about.call = "a rocket at (0, 20); click(display, 30, 20)"
    about.cause = (
        "No rocket is within reach, so this click is a miss. Add 1 to misses, change nothing else, "
        "and return False."
    )
    about.read = "the docstring of click"
    a_game = game((1, 0.0, 20.0))
    hit = display.click(a_game, 30.0, 20.0)
    expect_exactly(hit, False)
    counted = (a_game.misses, a_game.score)
    expect_exactly(counted, (1, 0), then="; misses and score")
    expect_exactly(types(a_game), [1], then="; types in the show")
    about.call = "two rockets; four clicks, which hit, miss, hit and miss: misses and score"
    about.cause = (
        "Two of these clicks hit a rocket and two miss. Add the points of each hit to score, and "
        "add 1 to misses for each miss."
    )
    a_game = game((1, 0.0, 20.0), (3, 9.0, 20.0))
    for x in (0.0, 30.0, 9.0, 30.0):
        display.click(a_game, x, 20.0)
    counted = (a_game.misses, a_game.score)
    expect_exactly(counted, (2, 2))


@pytest.mark.exercise("P4.1")
def test_a_click_in_a_full_show_counts_too() -> None:
    about.call = "a show of one slot, a rocket at (0, 20); click(display, 0, 20)"
    about.cause = (
        "A hit scores and bursts the rocket even if the show has no room for a new one. The hit "
        "must not depend on whether the launch succeeds."
    )
    about.read = "the docstring of click"
    show = probes.show_of(RULES, 1, "keep_old", 1)
    show.light([(1, 1, Particle(Vector3(0.0, 20.0, 0.0)))])
    a_game = display.Display(show)
    hit = display.click(a_game, 0.0, 20.0)
    expect_exactly(hit, True)
    counted = (a_game.score, types(a_game))
    expect_exactly(counted, (1, [1]), then="; score and types")
    age = show.fireworks[0].age
    expect_close(age, 0.0, then="; its age", tolerance=0.0)


@pytest.mark.exercise("P4.1")
def test_the_game_is_over_without_rockets_or_after_six_misses() -> None:
    about.read = "the docstring of is_over"
    rocket, spark = (1, 0.0, 20.0), (2, 0.0, 20.0)
    for lit, misses, over, cause in (
        ((rocket,), 0, False, "One rocket still burns, so the game is not over."),
        (
            (rocket, spark),
            5,
            False,
            "MISSES_ALLOWED is 5, so the game continues after the fifth miss.",
        ),
        (
            (rocket, spark),
            6,
            True,
            "MISSES_ALLOWED is 5, so the sixth miss ends the game, even if a rocket still burns.",
        ),
        (
            (spark, spark),
            0,
            True,
            "Only sparks still burn, and a spark is not a rocket, so the game is over.",
        ),
        ((), 0, True, "There are no fireworks left, so the game is over."),
    ):
        about.cause = cause
        about.call = (
            f"fireworks of types {[type for type, *_ in lit]}, of which only 1 has a payload; "
            f"{misses} misses; is_over(display)"
        )
        a_game = game(*lit)
        a_game.misses = misses
        expect_exactly(display.is_over(a_game), over)
    about.call = "one rocket, whose age is 0; is_over(display)"
    about.cause = (
        "The game is not over yet. A rocket counts until it has burst, even if its age is already "
        "0."
    )
    a_game = game(rocket)
    a_game.show.fireworks[0].age = 0.0
    expect_exactly(display.is_over(a_game), False)


@pytest.mark.exercise("P4.1")
def test_a_click_after_the_end_does_nothing() -> None:
    about("a rocket at (0, 20), 6 misses; click(display, 0, 20)")
    about.cause = (
        "The game is over, so a click must not change anything. Call is_over first, and if it is "
        "true, return False at once."
    )
    about.read = "the docstring of click"
    a_game = game((1, 0.0, 20.0))
    a_game.misses = 6
    hit = display.click(a_game, 0.0, 20.0)
    expect_exactly(hit, False)
    display.click(a_game, 30.0, 20.0)
    counted = (a_game.misses, a_game.score)
    expect_exactly(counted, (6, 0), then="; click(display, 30, 20); misses and score")
    expect_exactly(types(a_game), [1], then="; types in the show")
    about.call = "only a spark burns; click(display, 0, 20)"
    about.cause = (
        "The game is also over when no rocket is left. Call is_over at the start of click, instead "
        "of just counting the misses."
    )
    a_game = game((2, 0.0, 20.0))
    hit = display.click(a_game, 0.0, 20.0)
    expect_exactly(hit, False)
    expect_exactly(a_game.misses, 0, then="; misses")
