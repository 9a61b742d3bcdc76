"""Keep the display alive (project 4.1): the rules of a game with rockets, without a screen.

The fuse of each rocket burns down. If the player clicks on a rocket before it burns out, the rocket
bursts, and another rocket of its type starts from the ground. The game lasts as long as there is at
least one rocket. A late click scores more points, but the player risks losing the rocket.
"""

from __future__ import annotations

from dataclasses import dataclass

from ch04_particle_engine.fireworks import Firework, FireworksShow

REACH = 2.5  # m, from the click to the rocket
LATE = 0.4  # s of fuse left: below it a click is worth more
MISSES_ALLOWED = 5


@dataclass
class Display:
    """The state of a game: its show, the score, the number of misses, and the time played in s."""

    show: FireworksShow
    score: int = 0
    misses: int = 0
    time: float = 0.0


def find_rocket(display: Display, x: float, y: float) -> Firework | None:
    """Project 4.1: return the rocket nearest to (x, y), or None if none is within ``REACH``.

    Measure distances in the X-Y plane. A rocket at exactly the distance ``REACH`` is found. A
    rocket is any firework whose rule has payloads, even if the rocket was itself a payload. A
    rocket with an age of 0 or less has no fuse left, so a click can no longer save it. Do not
    return such a rocket.
    """
    raise NotImplementedError("Exercise P4.1: Keep the display alive")


def click(display: Display, x: float, y: float) -> bool:
    """Project 4.1: click on the point (x, y), and return whether a rocket was hit.

    The rocket that ``find_rocket`` returns gets an age of 0, so it bursts in the next update. Then
    another rocket of its type is launched, if the show has room. A hit scores 1 point, or 3 points
    if the fuse was shorter than ``LATE``. A click that hits no rocket is a miss. When the game is
    over, a click does nothing and returns False.
    """
    raise NotImplementedError("Exercise P4.1: Keep the display alive")


def is_over(display: Display) -> bool:
    """Project 4.1: return whether no rocket is left or too many clicks have missed.

    The first ``MISSES_ALLOWED`` misses are free, and the next miss ends the game. After a click on
    a rocket, the rocket still counts until it has burst. At the very start there are no rockets
    either, so a game begins only when a rocket has been launched.
    """
    raise NotImplementedError("Exercise P4.1: Keep the display alive")


def tick(display: Display, duration: float) -> None:
    """Advance the game by ``duration`` s: update the show, and count the time until it is over.

    Raises ValueError if the duration is not positive and finite. In that case nothing changes.
    """
    over = is_over(display)
    display.show.update(duration)
    if not over:
        display.time += duration
