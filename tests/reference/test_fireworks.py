"""The fireworks: invariants of every show, and the types of the chapter."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ch04_particle_engine.display import Display, click, is_over, tick
from ch04_particle_engine.firework_types import FIREWORK_TYPES, own_types
from ch04_particle_engine.fireworks import FireworkRule, FireworksShow, Payload, endless_types

BOOK = {  # the rules in the book's table: ages, velocities, damping and payloads
    1: (0.5, 1.4, (-5, 25, -5), (5, 28, 5), 0.1, ((3, 5), (5, 5))),
    2: (0.5, 1.0, (-5, 10, -5), (5, 20, 5), 0.8, ((4, 2),)),
    3: (0.5, 1.5, (-5, -5, -5), (5, 5, 5), 0.1, ()),
}


def simple(type: int, age: float = 1.0, *payloads: Payload) -> FireworkRule:
    return FireworkRule(type, age, age, (0, 9, 0), (0, 9, 0), 1.0, payloads)


def types(show: FireworksShow) -> list[int]:
    return [firework.type for firework in show.fireworks]


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


births = st.lists(st.tuples(st.integers(1, 3), st.integers(1, 9)), max_size=6)


@given(births, births, st.integers(1, 8), st.sampled_from(["keep_old", "drop_oldest"]))
def test_a_policy_does_what_one_spark_at_a_time_would_do(
    first: Any, then: Any, capacity: int, when_full: str
) -> None:
    show = FireworksShow([simple(type) for type in (1, 2, 3)], capacity, 1, when_full)
    burning: list[int] = []
    dropped = 0
    for group in (first, then):
        show.light([(type, count, None) for type, count in group])
        for type in [type for type, count in group for _ in range(count)]:
            if len(burning) == capacity:
                dropped += 1
                if when_full == "keep_old":
                    continue
                del burning[0]
            burning.append(type)
    assert types(show) == burning
    assert show.dropped == dropped


@settings(max_examples=30)
@given(
    st.lists(
        st.lists(st.tuples(st.integers(0, 5), st.integers(1, 10**9)), max_size=3),
        min_size=6,
        max_size=6,
    ),
    st.integers(1, 40),
    st.sampled_from(["keep_old", "drop_oldest"]),
)
def test_no_rules_make_more_than_the_capacity(leaves: Any, capacity: int, when_full: str) -> None:
    rules = [
        FireworkRule(type, 0.0, 0.3, (-1, -1, -1), (1, 9, 1), 0.5, [Payload(*p) for p in payloads])
        for type, payloads in enumerate(leaves)
    ]
    show = FireworksShow(rules, capacity, 1, when_full)
    for type in range(6):
        show.launch(type)
    for _ in range(60):
        show.update(0.05)
        assert len(show.fireworks) <= capacity


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
