"""Keep the display alive (project 4.1): a game whose rules need no screen.

Rockets burn down. A player who clicks on one before it has burnt out makes it burst, and another
rocket of its type starts from the ground. The display lives as long as there is a rocket; whoever
waits until the last moment scores more, and may be too late.
"""

from __future__ import annotations

from dataclasses import dataclass

from ch04_particle_engine.fireworks import Firework, FireworksShow

REACH = 2.5  # m, from the click to the rocket
LATE = 0.4  # s of fuse left: below it a click is worth more
MISSES_ALLOWED = 5


@dataclass
class Display:
    """A game: its show, the score, the clicks that hit nothing and the time played in s."""

    show: FireworksShow
    score: int = 0
    misses: int = 0
    time: float = 0.0


def find_rocket(display: Display, x: float, y: float) -> Firework | None:
    """Project 4.1: return the rocket nearest to a point of the X-Y plane, None for none in REACH.

    Rockets are the fireworks whose rule has payloads, whatever lit them. One without any fuse left,
    an age of 0 or less, is past saving and is not found; one at exactly REACH is found.
    """
    raise NotImplementedError("Exercise P4.1: Keep the display alive")


def click(display: Display, x: float, y: float) -> bool:
    """Project 4.1: click on a point of the X-Y plane, and say whether a rocket was hit.

    The rocket that find_rocket finds gets an age of 0, so that it bursts in the next update, and
    then another of its type is launched, if the show has room. That scores 1, or 3 where its fuse
    was shorter than LATE. A click that hits no rocket is a miss. When the game is over a click does
    nothing and hits nothing.
    """
    raise NotImplementedError("Exercise P4.1: Keep the display alive")


def is_over(display: Display) -> bool:
    """Project 4.1: say whether the game has ended: no rocket is left, or too many clicks missed.

    MISSES_ALLOWED may miss, the next one ends the game. A rocket that was clicked on counts until
    it has burst. A game begins when something has been launched.
    """
    raise NotImplementedError("Exercise P4.1: Keep the display alive")


def tick(display: Display, duration: float) -> None:
    """Let a frame in s pass: the time counts until the game is over, and what burns burns out.

    Raises ValueError where the duration is not positive and finite; nothing has changed then.
    """
    over = is_over(display)
    display.show.update(duration)
    if not over:
        display.time += duration
