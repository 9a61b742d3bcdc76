"""Keep the display alive, project 4.1: what a click does, and when the game is over."""

from __future__ import annotations

from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import display, probes
from ch04_particle_engine.probes import RULES, game
from expect import about, expect_close, expect_exactly, expect_that


def types(of: Any) -> list[int]:
    return [firework.type for firework in of.show.fireworks]


@pytest.mark.exercise("P4.1", asks="launch another rocket of its type")
def test_a_click_bursts_the_rocket_and_launches_another() -> None:
    about.call = (
        "a rocket of type 1 at (0, 20) and a rocket of type 3 at (9, 20); click(display, 9, 20)"
    )
    about.read = "the docstring of click"
    a_game = game((1, 0.0, 20.0), (3, 9.0, 20.0))
    about.cause = (
        "There is a rocket exactly where the player clicks, so the click is a hit. Return True."
    )
    rockets = a_game.show.fireworks
    try:
        hit = display.click(a_game, 9.0, 20.0)
    except (TypeError, KeyError, ValueError) as error:
        if "Firework" in str(error):
            about.cause = "You pass the rocket itself to launch. Pass its type, rocket.type."
        raise
    if hit is False and a_game.score == 0 and a_game.misses == 0 and len(rockets) == 2:
        about.cause = (
            "Your click does nothing, as if the game were over. Perhaps you wrote is_over without "
            "(display), and a function itself counts as true."
        )
    if hit is False and display.is_over(game((1, 0.0, 20.0))) is True:
        about.cause = (
            "Your is_over returns True although a rocket burns and no click has missed, so the "
            "click does nothing."
        )
    expect_exactly(hit, True)
    about.cause = (
        "After a hit on a rocket of type 3, launch another rocket of type 3. Don't remove the "
        "rocket that was hit, because it burns until the next update."
    )
    lit = types(a_game)
    if lit == [1, 3]:
        about.cause = (
            "You don't launch a new rocket after the hit. Launch one of the same type as the "
            "rocket that was hit."
        )
        if a_game.show.fireworks[1].particle.position.y == 0.0:
            about.cause = (
                "You remove the rocket that was hit. Leave it in the show and set its age to 0, so "
                "that it bursts in the next update."
            )
    elif lit == [1, 3, 1]:
        about.cause = (
            "You launch a rocket of type 1, although the rocket that was hit is of type 3. Launch "
            "one of its type."
        )
    elif lit == [1, 3, 2]:
        about.cause = (
            "You light the payload of the rocket in click. The next update does that. Launch "
            "another rocket of the same type here."
        )
    expect_exactly(types(a_game), [1, 3, 3], then="; the types of the burning fireworks")
    about.cause = (
        "You don't change the age of the rocket that was hit. Set it to 0, so that the rocket "
        "bursts in the next update."
    )
    ages = tuple(firework.age for firework in a_game.show.fireworks)
    if ages[1] != 1.0:
        about.cause = "Set the age of the rocket that was hit to 0, and leave all other ages alone."
    expect_close(ages, (2.0, 0.0, 1.0), then="; the ages of the three rockets", unit="s")
    height = a_game.show.fireworks[2].particle.position.y
    about.cause = (
        "The new rocket must start on the ground. Launch it with show.launch, which places it at y "
        "= 0."
    )
    expect_close(height, 0.0, then="; the height of the new rocket in m")
    a_game.show.update(0.001)
    about.cause = (
        "The rocket that was hit must burst in the next update and light its payload, one firework "
        "of type 2. Leave the rocket in the show until then."
    )
    expect_exactly(
        types(a_game).count(2), 1, then="; show.update(0.001); the number of fireworks of type 2"
    )


@pytest.mark.exercise("P4.1", asks="3 points if the rocket had less than LATE s")
def test_a_late_click_scores_more() -> None:
    about.read = "the docstring of click"
    for fuse, score, cause in (
        (
            1.5,
            1,
            "A hit with 1.5 s of fuse left scores 1 point. Compare the age of the rocket with LATE "
            "before you set it to 0.",
        ),
        (
            0.4,
            1,
            "You give 3 points for a hit with exactly 0.4 s (LATE) of fuse left. Give 3 points "
            "only if less than LATE is left, and 1 point otherwise.",
        ),
        (
            0.39,
            3,
            "A hit with less than 0.4 s (LATE) of fuse left scores 3 points. Compare the age of "
            "the rocket with LATE before you set it to 0.",
        ),
    ):
        about(
            f"a rocket at (0, 20) with {fuse} s of fuse left; click(display, 0, 20); ", cause=cause
        )
        about.call += "display.score"
        a_game = game((1, 0.0, 20.0))
        a_game.show.fireworks[0].age = fuse
        display.click(a_game, 0.0, 20.0)
        if fuse == 0.39 and a_game.score == 4:
            about.cause = (
                "You give 4 points, as if both cases applied. A late hit scores 3 points in all, "
                "so add 1 point only in an else branch."
            )
        if fuse == 1.5 and a_game.score == 3:
            about.cause = (
                "You count this hit as late, although 1.5 s of fuse are left. Compare the age of "
                "the rocket with LATE before you set it to 0."
            )
            late = game((1, 0.0, 20.0))
            late.show.fireworks[0].age = 0.39
            display.click(late, 0.0, 20.0)
            if late.score == 1:
                about.cause = (
                    "You have swapped the scores. A hit with less than LATE s of fuse left scores "
                    "3 points, and any other hit 1 point."
                )
        expect_exactly(a_game.score, score, unit="points")
        about.cause = (
            "You count a hit as a miss too. Change misses only if the click hits no rocket."
        )
        name = about.call.replace("display.score", "display.misses")
        expect_exactly(a_game.misses, 0, call=name)
    about.call = (
        "two rockets, at (0, 20) and (9, 20); click(display, 0, 20); click(display, 9, 20); "
        "display.score"
    )
    about.cause = (
        "You replace the score at each hit. Add the points of the hit to display.score instead."
    )
    a_game = game((1, 0.0, 20.0), (3, 9.0, 20.0))
    display.click(a_game, 0.0, 20.0)
    display.click(a_game, 9.0, 20.0)
    expect_exactly(a_game.score, 2, unit="points")


@pytest.mark.exercise("P4.1", asks="the click counts as a miss")
def test_a_click_far_from_every_rocket_is_a_miss() -> None:
    about.call = "a rocket at (0, 20), far away from the click; click(display, 30, 20)"
    about.cause = (
        "No rocket is within reach of the click, so it is a miss. Add 1 to misses, change nothing "
        "else, and return False."
    )
    about.read = "the docstring of click"
    a_game = game((1, 0.0, 20.0))
    hit = display.click(a_game, 30.0, 20.0)
    expect_exactly(hit, False)
    counted = (a_game.misses, a_game.score)
    shown = f"misses = {counted[0]}, score = {counted[1]}"
    if counted == (0, 0):
        about.cause = (
            "You don't count the miss. Add 1 to display.misses. If you do, assign the sum to "
            "display.misses, not to a local variable."
        )
    expect_that(counted == (1, 0), shown, "misses = 1, score = 0", then="; the state of display")
    expect_exactly(types(a_game), [1], then="; the types of the burning fireworks")
    about.call = (
        "two rockets; four clicks, which hit, miss, hit and miss; the pair (display.misses, "
        "display.score)"
    )
    about.cause = (
        "Two of these clicks hit a rocket and two miss. Add the points of each hit to score, and "
        "add 1 to misses for each miss."
    )
    a_game = game((1, 0.0, 20.0), (3, 9.0, 20.0))
    for x in (0.0, 30.0, 9.0, 30.0):
        display.click(a_game, x, 20.0)
    counted = (a_game.misses, a_game.score)
    expect_exactly(counted, (2, 2))


@pytest.mark.exercise("P4.1", asks="another rocket of its type, if the show has room")
def test_a_click_in_a_full_show_counts_too() -> None:
    about.call = "a show with one slot, which a rocket at (0, 20) has taken; click(display, 0, 20)"
    about.cause = (
        "A click on a rocket is a hit even if the show has no room for a new rocket. Score it and "
        "set the age of the rocket to 0 in any case."
    )
    about.read = "the docstring of click"
    show = probes.show_of(RULES, 1, "keep_old", 1)
    show.light([(1, 1, Particle(Vector3(0.0, 20.0, 0.0)))])
    a_game = display.Display(show)
    hit = display.click(a_game, 0.0, 20.0)
    expect_exactly(hit, True)
    counted = (a_game.score, types(a_game))
    expect_exactly(counted, (1, [1]), then="; (display.score, the types of the burning fireworks)")
    age = show.fireworks[0].age
    expect_close(age, 0.0, then="; the age of the rocket in s", tolerance=0.0)


@pytest.mark.exercise("P4.1", asks="no rocket is left or too many clicks have missed")
def test_the_game_is_over_without_rockets_or_after_six_misses() -> None:
    about.read = "the docstring of is_over"
    rocket, spark = (1, 0.0, 20.0), (2, 0.0, 20.0)
    for lit, misses, over, cause in (
        (
            (rocket,),
            0,
            False,
            "One rocket still burns and no click has missed, so the game is not over. Return "
            "False.",
        ),
        (
            (rocket, spark),
            5,
            False,
            "You end the game at the fifth miss, but the player may miss five times "
            "(MISSES_ALLOWED). Only the sixth miss ends the game.",
        ),
        (
            (rocket, spark),
            6,
            True,
            "You let the game continue after the sixth miss, which must end it (MISSES_ALLOWED is "
            "5). Return True, even if a rocket still burns.",
        ),
        (
            (spark, spark),
            0,
            True,
            "You let the game continue although only sparks are still burning. Count only "
            "fireworks whose rule has payloads, because only those are rockets.",
        ),
        (
            (),
            0,
            True,
            "Nothing burns any more, so no rocket is left and the game is over. Return True.",
        ),
    ):
        about.cause = cause
        burning = " and ".join({1: "a rocket", 2: "a spark"}[type] for type, *_ in lit) or "none"
        burning = "two sparks" if lit == (spark, spark) else burning
        about.call = f"burning fireworks: {burning}; {misses or 'no'} misses so far; "
        about.call += "is_over(display)"
        a_game = game(*lit)
        a_game.misses = misses
        got = display.is_over(a_game)
        empty = game()
        goes_on = misses == 6 and got is False and display.is_over(empty) is False
        empty.misses = 6
        if goes_on and display.is_over(empty) is True:
            about.cause = (
                "You end the game only if no rocket is left and more than five clicks have missed "
                "(MISSES_ALLOWED). Either condition alone must end the game."
            )
        expect_exactly(got, over)
    about.call = "a burning rocket that was hit and now has an age of 0; is_over(display)"
    about.cause = (
        "The game is not over yet, because a rocket that was hit keeps burning until the next "
        "update. Also count rockets with an age of 0."
    )
    a_game = game(rocket)
    a_game.show.fireworks[0].age = 0.0
    expect_exactly(display.is_over(a_game), False)


@pytest.mark.exercise("P4.1", asks="When the game is over, a click does nothing")
def test_a_click_after_the_end_does_nothing() -> None:
    about("a rocket at (0, 20) and 6 misses so far, so the game is over; click(display, 0, 20)")
    about.cause = (
        "Your click still has an effect after the game is over. Call is_over first, and return "
        "False at once if it returns True."
    )
    about.read = "the docstring of click"
    a_game = game((1, 0.0, 20.0))
    a_game.misses = 6
    hit = display.click(a_game, 0.0, 20.0)
    expect_exactly(hit, False)
    display.click(a_game, 30.0, 20.0)
    counted = (a_game.misses, a_game.score)
    expect_exactly(
        counted, (6, 0), then="; click(display, 30, 20); the pair (display.misses, display.score)"
    )
    expect_exactly(types(a_game), [1], then="; the types of the burning fireworks")
    about.call = "only a spark is still burning, so the game is over; click(display, 0, 20)"
    about.cause = (
        "You count a miss although the game is over. No rocket is left, so call is_over first "
        "instead of checking only the number of misses."
    )
    a_game = game((2, 0.0, 20.0))
    hit = display.click(a_game, 0.0, 20.0)
    expect_exactly(hit, False)
    expect_exactly(a_game.misses, 0, then="; display.misses")
