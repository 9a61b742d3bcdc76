"""The rules of a game in which the player keeps a fireworks display alive (project 4.1).

If the player clicks on a rocket before it burns out, it bursts, and another rocket of its type
starts from the ground. The game ends when no rocket is left or too many clicks have missed.
"""

from __future__ import annotations

from dataclasses import dataclass

from ch04_particle_engine.fireworks import Firework, FireworksShow

REACH = 2.5  # m, from the click to the rocket
LATE = 0.4  # s of fuse left: below it a click is worth more
MISSES_ALLOWED = 5


@dataclass
class Display:
    """The state of the rocket game, which every click and every time step can change."""

    show: FireworksShow
    score: int = 0
    misses: int = 0  # clicks that hit no rocket
    time: float = 0.0  # s


def find_rocket(display: Display, x: float, y: float) -> Firework | None:
    """Find the rocket nearest to the point (x, y), or return None if none is within ``REACH``.

    A rocket is any firework that lights others when it burns out: its rule has payloads. Measure
    distances in the X-Y plane, and also accept a rocket at exactly the distance ``REACH``. Skip
    rockets with an age of 0 or less, because they have no fuse left.
    """
    raise NotImplementedError("Exercise P4.1: Keep the display alive")


def click(display: Display, x: float, y: float) -> bool:
    """Handle a click by the player at the point (x, y), and return True if it hits a rocket.

    A hit scores 1 point, or 3 points if the rocket had less than ``LATE`` s of fuse left. Set the
    age of the rocket to 0, so that it bursts in the next update. Then launch another rocket of its
    type, if the show has room. If there is no rocket within reach, the click counts as a miss. When
    the game is over, a click does nothing and returns False.
    """
    raise NotImplementedError("Exercise P4.1: Keep the display alive")


def is_over(display: Display) -> bool:
    """Return True if no rocket is left, or if more than ``MISSES_ALLOWED`` clicks have missed.

    A rocket that was clicked still counts until it bursts.
    """
    raise NotImplementedError("Exercise P4.1: Keep the display alive")


def tick(display: Display, duration: float) -> None:
    """Advance the show by a time step of ``duration`` s, and the time played until the end."""
    over = is_over(display)
    display.show.update(duration)
    if not over:
        display.time += duration
