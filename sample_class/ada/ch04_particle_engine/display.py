"""Ada's game."""

from dataclasses import dataclass

from ch04_particle_engine.fireworks import FireworksShow

REACH = 2.5
LATE = 0.4
MISSES_ALLOWED = 5


@dataclass
class Display:
    show: FireworksShow
    score: int = 0
    misses: int = 0
    time: float = 0.0


def rockets(display):
    rules = display.show.rules
    return [f for f in display.show.fireworks if rules[f.type].payloads]


def find_rocket(display, x, y):
    def squared(rocket):
        place = rocket.particle.position
        return (place.x - x) ** 2 + (place.y - y) ** 2

    near = [r for r in rockets(display) if r.age > 0 and squared(r) <= REACH**2]
    return min(near, key=squared, default=None)


def click(display, x, y):
    if is_over(display):
        return False
    rocket = find_rocket(display, x, y)
    if rocket is None:
        display.misses += 1
        return False
    display.score += 3 if rocket.age < LATE else 1
    rocket.age = 0.0
    display.show.launch(rocket.type)
    return True


def is_over(display):
    return display.misses > MISSES_ALLOWED or len(rockets(display)) == 0


def tick(display, duration):
    if not is_over(display):
        display.time += duration
    display.show.update(duration)
