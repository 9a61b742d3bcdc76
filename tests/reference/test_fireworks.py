"""The fireworks: the book's table of rules, shows that end, and a game that is played."""

from __future__ import annotations

import pytest

from ch04_particle_engine.display import Display, click, is_over, tick
from ch04_particle_engine.firework_types import FIREWORK_TYPES, own_types
from ch04_particle_engine.fireworks import FireworkRule, FireworksShow, endless_types

BOOK = {  # the rules in the book's table: ages, velocities, damping and payloads
    1: (0.5, 1.4, (-5, 25, -5), (5, 28, 5), 0.1, ((3, 5), (5, 5))),
    2: (0.5, 1.0, (-5, 10, -5), (5, 20, 5), 0.8, ((4, 2),)),
    3: (0.5, 1.5, (-5, -5, -5), (5, 5, 5), 0.1, ()),
}


@pytest.mark.parametrize("rule", FIREWORK_TYPES[:3], ids=lambda rule: rule.type)
def test_the_first_three_types_are_the_book_s(rule: FireworkRule) -> None:
    payloads = tuple((payload.type, payload.count) for payload in rule.payloads)
    velocities = (rule.min_velocity, rule.max_velocity)
    assert (rule.min_age, rule.max_age, *velocities, rule.damping, payloads) == BOOK[rule.type]


def test_there_are_nine_types_and_two_more_and_every_show_with_them_ends() -> None:
    rules = [*FIREWORK_TYPES, *own_types()]
    assert [rule.type for rule in rules] == [*range(1, 12)]
    assert endless_types(rules) == []
    for rule in rules:
        show = FireworksShow(rules, 1000, seed=3)
        show.launch(rule.type)
        for _ in range(600):
            show.update(1.0 / 60.0)
        assert show.fireworks == []
        assert show.dropped == 0


def test_a_game_can_be_kept_alive_and_ends_when_nobody_clicks() -> None:
    display = Display(FireworksShow(FIREWORK_TYPES, 400, seed=1))
    display.show.launch(1)
    for frame in range(600):
        if frame < 300:
            for rocket in [*display.show.fireworks]:
                if rocket.type == 1 and 0.0 < rocket.age < 0.2:
                    assert click(display, rocket.particle.position.x, rocket.particle.position.y)
        tick(display, 1.0 / 60.0)
    assert is_over(display)
    assert display.misses == 0
    assert display.score >= 9  # a click in the last 0.4 s scores 3; 5 s have three rockets
    assert 5.0 < display.time < 7.0
    assert display.show.fireworks == []  # the last fireworks burn out after the end
