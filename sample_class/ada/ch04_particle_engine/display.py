"""A game with a display: click rockets before they burn out, and the later the better."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from ch04_particle_engine.fireworks import Firework, FireworksShow

REACH = 2.5  # m around a click
LATE = 0.4  # s of fuse
MISSES_ALLOWED = 5


@dataclass
class Display:
    """Where the game stands."""

    show: FireworksShow
    score: int = 0
    misses: int = 0
    time: float = 0.0


def find_rocket(display: Display, x: float, y: float) -> Firework | None:
    def distance(rocket: Firework) -> float:
        place = rocket.particle.position
        return math.dist((place.x, place.y), (x, y))

    nearest_first = sorted((r for r in _rockets(display) if r.age > 0), key=distance)
    return next((rocket for rocket in nearest_first if distance(rocket) <= REACH), None)


def click(display: Display, x: float, y: float) -> bool:
    if is_over(display):
        return False
    match find_rocket(display, x, y):
        case None:
            display.misses += 1
            return False
        case rocket:
            display.score += 3 if rocket.age < LATE else 1
            rocket.age = 0.0
            display.show.launch(rocket.type)
            return True


def is_over(display: Display) -> bool:
    return display.misses > MISSES_ALLOWED or next(_rockets(display), None) is None


def tick(display: Display, duration: float) -> None:
    display.time += 0.0 if is_over(display) else duration
    display.show.update(duration)


def _rockets(display: Display) -> Iterator[Firework]:
    """Yield what will leave something behind."""
    rules = display.show.rules
    return (burning for burning in display.show.fireworks if rules[burning.type].payloads)
