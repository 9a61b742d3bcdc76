"""Keep the display alive, project 4.1: clicks on rockets, and the end of the game."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.display import Display, click, find_rocket, is_over
from ch04_particle_engine.probes import RULES, game, show_of, types
from draw import number
from expect import about, expect_close, expect_exactly, expect_that, named, scoped

FIND = "the docstring of find_rocket"
PAYLOADS = "Skip every firework whose rule has no payloads."
CLICK, BURNING = "the docstring of click", "; the types of the burning fireworks"
ROCKET, OTHER, SPARK = (1, 0.0, 20.0), (3, 9.0, 20.0), (2, 0.0, 20.0)


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
        why = "Use the straight-line distance, sqrt(dx^2 + dy^2): 2.6 m here, more than REACH."
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


def clicked(*lit: tuple[int, float, float], xs: tuple[float, ...] = (0.0,), **state: float) -> Any:
    """Return a game after clicks at these x and y = 20. State may hold misses and a fuse's age."""
    played = game(*lit)
    played.misses = state.get("misses", 0)
    if "fuse" in state:
        played.show.fireworks[0].age = state["fuse"]
    for x in xs:
        click(played, x, 20.0)
    return played


@pytest.mark.exercise("P4.1", asks="launch another rocket of its type", read=CLICK)
def test_a_click_bursts_the_rocket_and_launches_another() -> None:
    played = game(ROCKET, OTHER)
    fireworks = played.show.fireworks
    with calls(
        "There is a rocket exactly where the player clicks, so the click is a hit. Return True.",
        "a rocket of type 1 at (0, 20) and a rocket of type 3 at (9, 20); click(display, 9, 20)",
    ):
        try:
            hit = click(played, 9.0, 20.0)
        except (TypeError, KeyError, ValueError) as error:
            if "Firework" in str(error):
                about(cause="You pass the rocket itself to launch. Pass its type, rocket.type.")
            raise
        why = about.cause
        if hit is False and played.score == 0 and played.misses == 0 and len(fireworks) == 2:
            why = (
                "Your click does nothing, as if the game were over. Perhaps you wrote is_over "
                "without (display), and a function itself counts as true."
            )
        if hit is False and is_over(game(ROCKET)) is True:
            why = "Your is_over returns True although a rocket burns, so the click does nothing."
    expect_exactly(hit, True, cause=why)
    lit, fireworks = types(played.show), played.show.fireworks
    slips = {
        "You don't launch a new rocket after the hit. Launch one of the same type as the rocket "
        "that was hit.": [1, 3],
        "You launch a rocket of type 1, although the rocket that was hit is of type 3. Launch one "
        "of its type.": [1, 3, 1],
        "You light the payload, but the next update does that. Launch a rocket here.": [1, 3, 2],
    }
    why = "Launch another rocket of type 3, and keep the one that was hit until the next update."
    why = named(lit, why, slips)
    if lit == [1, 3] and fireworks[1].particle.position.y == 0.0:
        why = "You remove the rocket that was hit. Leave it in the show and set its age to 0."
    expect_exactly(lit, [1, 3, 3], then=BURNING, cause=why)
    ages = tuple(firework.age for firework in fireworks)
    why = "Set the age of the rocket that was hit to 0, and leave all other ages alone."
    if ages[1] == 1.0:
        why = "You don't change the age of the rocket that was hit. Set it to 0, so that it bursts."
    expect_close(ages, (2.0, 0.0, 1.0), then="; the ages of the three rockets", unit="s", cause=why)
    height, then = fireworks[2].particle.position.y, "; the height of the new rocket in m"
    ground = "The new rocket must start on the ground, at y = 0. Launch it with show.launch."
    expect_close(height, 0.0, then=then, cause=ground)
    with calls(
        "The rocket that was hit must burst in the next update and light its payload, one firework "
        "of type 2. Leave the rocket in the show until then.",
        "show.update(0.001); the number of fireworks of type 2",
        more=True,
    ):
        played.show.update(0.001)
    expect_exactly(types(played.show).count(2), 1)


@pytest.mark.exercise("P4.1", asks="3 points if the rocket had less than LATE s", read=CLICK)
def test_a_late_click_scores_more() -> None:
    read = "Compare the age of the rocket with LATE before you set it to 0."
    swapped = "You have swapped the scores. A hit with less than LATE s left scores 3 points."
    for fuse, score, cause, mistake in (
        (1.5, 1, f"A hit with 1.5 s of fuse left scores 1 point. {read}",
         {f"You count this hit as late, although 1.5 s of fuse are left. {read}": 3}),
        (0.4, 1,
         "You give 3 points for a hit with exactly 0.4 s (LATE) of fuse left. Give 3 points only "
         "if less than LATE is left, and 1 point otherwise.", {}),
        (0.39, 3, f"A hit with less than 0.4 s (LATE) of fuse left scores 3 points. {read}",
         {"You give 4 points. A late hit scores 3 in all, so add 1 only in an else branch.": 4}),
    ):  # fmt: skip
        scene = f"a rocket at (0, 20) with {fuse} s of fuse left; click(display, 0, 20)"
        with calls(cause, scene):
            played = clicked(ROCKET, fuse=fuse)
            why = named(played.score, cause, mistake)
            if fuse == 1.5 and played.score == 3 and clicked(ROCKET, fuse=0.39).score == 1:
                why = swapped
        expect_exactly(played.score, score, unit="points", then="; display.score", cause=why)
        also = "You count a hit as a miss too. Change misses only if the click hits no rocket."
        expect_exactly(played.misses, 0, then="; display.misses", cause=also)
    with calls(
        "You replace the score at each hit. Add the points of the hit to display.score instead.",
        "two rockets; click(display, 0, 20); click(display, 9, 20); display.score",
    ):
        played = clicked(ROCKET, OTHER, xs=(0.0, 9.0))
    expect_exactly(played.score, 2, unit="points")


@pytest.mark.exercise("P4.1", asks="the click counts as a miss", read=CLICK)
def test_a_click_far_from_every_rocket_is_a_miss() -> None:
    played = game(ROCKET)
    with calls(
        "No rocket is within reach of the click, so it is a miss. Add 1 to misses, change nothing "
        "else, and return False.",
        "a rocket at (0, 20), far away from the click; click(display, 30, 20)",
    ):
        expect_exactly(click(played, 30.0, 20.0), False)
    counted = (played.misses, played.score)
    slips = {
        "You don't count the miss. Add 1 to display.misses. If you do, assign the sum to "
        "display.misses, not to a local variable.": (0, 0)
    }
    shown, why = f"misses = {counted[0]}, score = {counted[1]}", named(counted, about.cause, slips)
    right, then = "misses = 1, score = 0", "; the state of display"
    expect_that(counted == (1, 0), shown, right, then=then, cause=why)
    expect_exactly(types(played.show), [1], then=BURNING)
    with calls(
        "Two of these clicks hit a rocket and two miss. Add the points of each hit to score, and "
        "add 1 to misses for each miss.",
        "two rockets; clicks that hit, miss, hit and miss; (display.misses, display.score)",
    ):
        played = clicked(ROCKET, OTHER, xs=(0.0, 30.0, 9.0, 30.0))
    expect_exactly((played.misses, played.score), (2, 2))


@pytest.mark.exercise("P4.1", asks="another rocket of its type, if the show has room", read=CLICK)
def test_a_click_in_a_full_show_counts_too() -> None:
    show = show_of(RULES, 1, "keep_old", 1)
    show.light([(1, 1, Particle(Vector3(0.0, 20.0, 0.0)))])
    played = Display(show)
    with calls(
        "A click on a rocket is a hit even if the show has no room for a new rocket. Score it and "
        "set the age of the rocket to 0 in any case.",
        "a show with one slot, which a rocket at (0, 20) has taken; click(display, 0, 20)",
    ):
        expect_exactly(click(played, 0.0, 20.0), True)
    counted = (played.score, types(show))
    expect_exactly(counted, (1, [1]), then="; (display.score, the types of the burning fireworks)")
    age, then = show.fireworks[0].age, "; the age of the rocket in s"
    expect_close(age, 0.0, then=then, tolerance=0.0)


@pytest.mark.exercise(
    "P4.1", asks="no rocket is left or too many clicks have missed", read="the docstring of is_over"
)
def test_the_game_is_over_without_rockets_or_after_six_misses() -> None:
    both = (
        "You end the game only if no rocket is left and more than five clicks have missed "
        "(MISSES_ALLOWED). Either condition alone must end the game."
    )
    for burning, lit, misses, over, cause in (
        ("a rocket", (ROCKET,), 0, False,
         "One rocket still burns and no click has missed, so the game is not over. Return False."),
        ("a rocket and a spark", (ROCKET, SPARK), 5, False,
         "You end the game at the fifth miss, but only the sixth ends it (MISSES_ALLOWED is 5)."),
        ("a rocket and a spark", (ROCKET, SPARK), 6, True,
         "You let the game continue after the sixth miss, which must end it (MISSES_ALLOWED is 5). "
         "Return True, even if a rocket still burns."),
        ("two sparks", (SPARK, SPARK), 0, True,
         "You let the game continue although only sparks are still burning. Count only fireworks "
         "whose rule has payloads, because only those are rockets."),
        ("none", (), 0, True,
         "Nothing burns any more, so no rocket is left and the game is over. Return True."),
    ):  # fmt: skip
        with calls(
            cause, f"burning fireworks: {burning}; {misses or 'no'} misses so far; is_over(display)"
        ):
            got, why = is_over(clicked(*lit, xs=(), misses=misses)), cause
            if misses == 6 and got is False and is_over(game()) is False:
                why = both if is_over(clicked(xs=(), misses=6)) is True else cause
        expect_exactly(got, over, cause=why)
    with calls(
        "The game is not over yet, because a rocket that was hit keeps burning until the next "
        "update. Also count rockets with an age of 0.",
        "a burning rocket that was hit and now has an age of 0; is_over(display)",
    ):
        got = is_over(clicked(ROCKET, xs=(), fuse=0.0))
    expect_exactly(got, False)


@pytest.mark.exercise("P4.1", asks="When the game is over, a click does nothing", read=CLICK)
def test_a_click_after_the_end_does_nothing() -> None:
    played = clicked(ROCKET, xs=(), misses=6)
    with calls(
        "Your click still has an effect after the game is over. Call is_over first, and return "
        "False at once if it returns True.",
        "a rocket at (0, 20) and 6 misses so far, so the game is over; click(display, 0, 20)",
    ):
        expect_exactly(click(played, 0.0, 20.0), False)
        click(played, 30.0, 20.0)
    then = "; click(display, 30, 20); the pair (display.misses, display.score)"
    expect_exactly((played.misses, played.score), (6, 0), then=then)
    expect_exactly(types(played.show), [1], then=BURNING)
    played = game(SPARK)
    with calls(
        "You count a miss although the game is over. No rocket is left, so call is_over first "
        "instead of checking only the number of misses.",
        "only a spark is still burning, so the game is over; click(display, 0, 20)",
    ):
        expect_exactly(click(played, 0.0, 20.0), False)
    expect_exactly(played.misses, 0, then="; display.misses")
