"""The rules of a game in which the player keeps a fireworks display alive (project 4.1).

This module draws nothing, so it works without a screen. The fuse of each rocket burns down. If the
player clicks on a rocket before it burns out, the rocket bursts, and another rocket of its type
starts from the ground. The game ends when no rocket is left or too many clicks have missed. A late
click scores more points, but if the player waits too long, the rocket is lost.
"""

from __future__ import annotations

from dataclasses import dataclass

from ch04_particle_engine.fireworks import Firework, FireworksShow

REACH = 2.5  # m, from the click to the rocket
LATE = 0.4  # s of fuse left: below it a click is worth more
MISSES_ALLOWED = 5


@dataclass
class Display:
    """The state of the rocket game, which every click and every time step can change.

    ``show`` contains the burning fireworks, ``score`` is the number of points, and ``misses``
    counts the clicks that hit no rocket. ``time`` is the time played in s.
    """

    show: FireworksShow
    score: int = 0
    misses: int = 0
    time: float = 0.0


def find_rocket(display: Display, x: float, y: float) -> Firework | None:
    """Find the rocket nearest to the point (x, y), or return None if none is within ``REACH``.

    A rocket is any firework that lights others when it burns out, which means that its rule has
    payloads. This includes fireworks that were lit by another rocket. Measure distances in the X-Y
    plane, and also accept a rocket at exactly the distance ``REACH``. Skip rockets with an age of 0
    or less, because they have no fuse left and a click can no longer save them. Project 4.1.
    """
    raise NotImplementedError("Exercise P4.1: Keep the display alive")


def click(display: Display, x: float, y: float) -> bool:
    """Handle a click by the player at the point (x, y), and return True if it hits a rocket.

    If ``find_rocket`` returns a rocket, the click is a hit. It scores 1 point, or 3 points if the
    rocket had less than ``LATE`` s of fuse left. Set the age of the rocket to 0, so that it bursts
    in the next update. Then launch another rocket of its type, if the show has room. If there is no
    rocket within reach, the click counts as a miss. When the game is over, a click does nothing and
    returns False. Project 4.1.
    """
    raise NotImplementedError("Exercise P4.1: Keep the display alive")


def is_over(display: Display) -> bool:
    """Return True if the game is over, because no rocket is left or too many clicks have missed.

    The first ``MISSES_ALLOWED`` misses are free, and the next miss ends the game. A rocket that was
    clicked still counts until it bursts. Before the first launch there are no rockets, so the game
    counts as over then too. Project 4.1.
    """
    raise NotImplementedError("Exercise P4.1: Keep the display alive")


def tick(display: Display, duration: float) -> None:
    """Advance the game by one time step of ``duration`` s, and update the time played.

    If the game was already over before the step, the fireworks still move, but the time played
    does not increase.

    Raises:
        ValueError: if the duration is not positive and finite. In that case nothing changes.
    """
    over = is_over(display)
    display.show.update(duration)
    if not over:
        display.time += duration
